#include "ui/views/setting.h"

#include "ui/choices.h"

namespace glint {
namespace {

template <class E, std::size_t N>
void add_settings(std::vector<Setting>& all, Setting::Kind kind, const std::array<Choice<E>, N>& choices) {
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) all.push_back({kind, i});
}

}  // namespace

Setting setting_of(ShadingMode mode) { return {Setting::Kind::Mode, index_of(mode_choices, mode)}; }

Setting setting_of(Reflection reflection) {
    return {Setting::Kind::Reflection, index_of(reflection_choices, reflection)};
}

std::vector<Setting> all_settings() {
    std::vector<Setting> all{{}};
    add_settings(all, Setting::Kind::Mode, mode_choices);
    add_settings(all, Setting::Kind::Reflection, reflection_choices);
    add_settings(all, Setting::Kind::Interpolation, interpolation_choices);
    all.push_back({Setting::Kind::Stored, 0});
    return all;
}

std::string word_of(Setting setting) {
    const auto index = static_cast<std::size_t>(setting.index);
    switch (setting.kind) {
    case Setting::Kind::Edited:
        return "edited";
    case Setting::Kind::Mode:
        return std::string("mode ") + mode_choices[index].word;
    case Setting::Kind::Reflection:
        return std::string("reflection ") + reflection_choices[index].word;
    case Setting::Kind::Interpolation:
        return std::string("interpolation ") + interpolation_choices[index].word;
    case Setting::Kind::Stored:
        return "stored";
    }
    return {};  // not reached
}

std::optional<Setting> setting_named(const std::string& word) {
    for (const Setting& setting : all_settings())
        if (word_of(setting) == word) return setting;
    return {};
}

std::string label_of(Setting setting) {
    const auto index = static_cast<std::size_t>(setting.index);
    switch (setting.kind) {
    case Setting::Kind::Edited:
        return "As edited";
    case Setting::Kind::Mode:
        return std::string(mode_choices[index].label) + " shading";
    case Setting::Kind::Reflection:
        return std::string(reflection_choices[index].label) + " lighting";
    case Setting::Kind::Interpolation:
        return std::string(interpolation_choices[index].label) + " interpolation";
    case Setting::Kind::Stored:
        return "B, stored";
    }
    return {};  // not reached
}

Scene scene_under(Setting setting, const Scene& edited, const std::optional<Scene>& stored) {
    const auto index = static_cast<std::size_t>(setting.index);
    Scene scene = edited;
    switch (setting.kind) {
    case Setting::Kind::Edited:
        break;
    case Setting::Kind::Mode:
        scene.shading.mode = mode_choices[index].value;
        break;
    case Setting::Kind::Reflection:
        scene.shading.reflection = reflection_choices[index].value;
        break;
    case Setting::Kind::Interpolation:
        scene.shading.interpolation = interpolation_choices[index].value;
        break;
    case Setting::Kind::Stored:
        if (!stored) break;
        scene = *stored;
        scene.camera = edited.camera;
        break;
    }
    return scene;
}

}  // namespace glint
