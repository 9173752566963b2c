#include "ui/views/setting.h"

#include "models/fields/choices.h"

namespace glint {
namespace {

template <class E> void add_settings(std::vector<Setting>& all, Setting::Kind kind) {
    for (std::size_t i = 0; i < count_of<E>(); ++i) all.push_back({kind, static_cast<int>(i)});
}

}  // namespace

Setting setting_of(ShadingMode mode) { return {Setting::Kind::Mode, static_cast<int>(mode)}; }

Setting setting_of(Reflection reflection) {
    return {Setting::Kind::Reflection, static_cast<int>(reflection)};
}

std::vector<Setting> all_settings() {
    std::vector<Setting> all{{}};
    add_settings<ShadingMode>(all, Setting::Kind::Mode);
    add_settings<Reflection>(all, Setting::Kind::Reflection);
    add_settings<Interpolation>(all, Setting::Kind::Interpolation);
    all.push_back({Setting::Kind::Stored, 0});
    return all;
}

std::string word_of(Setting setting) {
    const auto index = static_cast<std::size_t>(setting.index);
    switch (setting.kind) {
    case Setting::Kind::Edited:
        return "edited";
    case Setting::Kind::Mode:
        return std::string("mode ").append(choices<ShadingMode>[index].word);
    case Setting::Kind::Reflection:
        return std::string("reflection ").append(choices<Reflection>[index].word);
    case Setting::Kind::Interpolation:
        return std::string("interpolation ").append(choices<Interpolation>[index].word);
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
        return std::string(choices<ShadingMode>[index].label) + " shading";
    case Setting::Kind::Reflection:
        return std::string(choices<Reflection>[index].label) + " lighting";
    case Setting::Kind::Interpolation:
        return std::string(choices<Interpolation>[index].label) + " interpolation";
    case Setting::Kind::Stored:
        return "B, stored";
    }
    return {};  // not reached
}

Scene scene_under(Setting setting, const Scene& edited, const Scene* stored) {
    const auto index = static_cast<std::size_t>(setting.index);
    Scene scene = edited;
    switch (setting.kind) {
    case Setting::Kind::Edited:
        break;
    case Setting::Kind::Mode:
        scene.shading.mode = static_cast<ShadingMode>(index);
        break;
    case Setting::Kind::Reflection:
        scene.shading.reflection = static_cast<Reflection>(index);
        break;
    case Setting::Kind::Interpolation:
        scene.shading.interpolation = static_cast<Interpolation>(index);
        break;
    case Setting::Kind::Stored:
        if (stored == nullptr) break;
        scene = *stored;
        scene.camera = edited.camera;
        break;
    }
    return scene;
}

}  // namespace glint
