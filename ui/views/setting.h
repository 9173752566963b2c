#pragma once
// A way to draw the edited scene: as it is, with one choice changed, or as it was when it was stored. What
// the parts of a comparison differ in.

#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

struct Setting {
    enum class Kind { Edited, Mode, Reflection, Interpolation, Stored };
    Kind kind = Kind::Edited;
    int index = 0;  // in choices<ShadingMode>, choices<Reflection> or choices<Interpolation>
    bool operator==(const Setting&) const = default;
};

[[nodiscard]] Setting setting_of(ShadingMode mode);
[[nodiscard]] Setting setting_of(Reflection reflection);

/// All there are, in the order of lists. Stored is among them whether or not there is a stored scene.
[[nodiscard]] std::vector<Setting> all_settings();

/// "mode gouraud", "edited", "stored": for a file.
[[nodiscard]] std::string word_of(Setting setting);
/// The inverse; nothing for other words.
[[nodiscard]] std::optional<Setting> setting_named(const std::string& word);

/// "Gouraud", "As edited", "B".
[[nodiscard]] std::string label_of(Setting setting);

/// The scene that a setting shows, seen by the edited scene's camera. Stored without a stored scene (null):
/// as edited.
[[nodiscard]] Scene scene_under(Setting setting, const Scene& edited, const Scene* stored);

}  // namespace glint
