#pragma once
// The scene's numbers as a program's text: camera, lights and objects under their names in the scene file,
// converted to identifiers of the language.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/model_text.h"
#include "programs/program.h"

namespace glint {

/// A name for a comment in any language: no control characters, and no sequence that continues a line or ends
/// a comment.
[[nodiscard]] std::string for_comment(const std::string& text);

/// ASCII letters, digits and single underscores, beginning with a letter: "Left lamp" becomes Left_lamp.
[[nodiscard]] std::string in_letters(const std::string& name, const std::string& otherwise);

/// Unique identifiers for names of a scene, different from the words in `taken` (the program's own).
class Identifiers {
  public:
    explicit Identifiers(Flags taken) : taken_(std::move(taken)) {}
    /// in_letters(). A name that a library may define gets the suffix `otherwise`: "log" becomes log_light.
    [[nodiscard]] std::string of(const std::string& name, const std::string& otherwise);
    /// `base`, or base_2 and so on if that is taken.
    [[nodiscard]] std::string once(const std::string& base);

  private:
    Flags taken_;
    std::map<std::string, int> next_;  // for each base: the number to try next
};

/// A number as the scene file writes it, without ".0"; a vector as the language writes it.
[[nodiscard]] std::string number_in_program(float x);
[[nodiscard]] std::string vector_in_program(const glm::vec3& v, Language language);

/// The lines that define camera, lights and objects, and lists of their names. `mesh_files`: one for each
/// object of shown(). `flags` select the columns. `words`: those that the program itself uses.
struct SceneTables {
    std::string camera, lights, objects;
};
[[nodiscard]] SceneTables scene_tables(const Scene& scene, Language language, const Flags& flags,
                                       const std::vector<std::string>& mesh_files, Flags words);

// Finds the properties of a scene that determine the lines of its program. A language may lack some of them:
// each such property is one row, and a language supports it if its text mentions the row's flag.

/// A feature that a scene needs from a program.
struct Need {
    std::string flag, pointer, what;  // what: "Phong shading lights each pixel"
};

/// Only the enabled lights and the visible objects, which a program draws. A spot without a cone becomes a
/// point light.
[[nodiscard]] std::vector<Light> shining(const Scene& scene);
[[nodiscard]] std::vector<Object> shown(const Scene& scene);

/// The reflection models of the visible objects, each once; the scene's if there are none.
[[nodiscard]] std::vector<Reflection> models_of(const Scene& scene);

/// All needs of the scene.
[[nodiscard]] std::vector<Need> needs_of(const Scene& scene);

/// The needs' flags, and flags of the scene that every language supports.
[[nodiscard]] Flags flags_of(const Scene& scene);

}  // namespace glint
