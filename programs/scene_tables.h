#pragma once
// Writes the scene's numbers as program text: camera, lights and objects under their names in the scene file,
// converted to identifiers of the language.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "programs/model_text.h"
#include "programs/program.h"

namespace glint {

/// Returns a name that is safe in a comment in any language, without control characters or sequences that
/// continue a line or end a comment.
[[nodiscard]] std::string for_comment(const std::string& text);

/// Converts a name to ASCII letters, digits and single underscores: "Left lamp" becomes Left_lamp. Begins
/// with `otherwise` if the name has no letter or digit, or begins with a digit.
[[nodiscard]] std::string in_letters(const std::string& name, const std::string& otherwise);

/// Unique identifiers for names of a scene, different from the words in `taken` (the program's own).
class Identifiers {
  public:
    explicit Identifiers(Flags taken) : taken_(std::move(taken)) {}
    /// Like in_letters(), but a name that a library may define gets the suffix `otherwise`: "log" becomes
    /// log_light.
    [[nodiscard]] std::string of(const std::string& name, const std::string& otherwise);
    /// `base`, or base_2 and so on if that is taken.
    [[nodiscard]] std::string once(const std::string& base);

  private:
    Flags taken_;
    std::map<std::string, int> next_;  // for each base: the number to try next
};

/// Formats a number as in the scene file, without ".0", or a vector as in the language.
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

/// The reflection models of the visible objects, each once; the scene's model if no object is visible.
[[nodiscard]] std::vector<Reflection> models_of(const Scene& scene);

/// All needs of the scene.
[[nodiscard]] std::vector<Need> needs_of(const Scene& scene);

/// The needs' flags, and flags of the scene that every language supports.
[[nodiscard]] Flags flags_of(const Scene& scene);

}  // namespace glint
