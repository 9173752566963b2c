#include "models/fields/choices.h"
#include "ui/features/views/compare_view.h"

namespace glint {
namespace {

template <class E> void add_variants(std::vector<Variant>& all, Variant::Kind kind) {
    for (std::size_t i = 0; i < count_of<E>(); ++i) all.push_back({kind, static_cast<int>(i)});
}

/// A choice in place of the edited one, with its field's key and the noun for its label.
struct NamedChoice {
    const char *field = "", *noun = "";
    const Choice* choice = nullptr;
};

/// Precondition: `variant` changes a choice.
NamedChoice choice_in(Variant variant) {
    const auto index = static_cast<std::size_t>(variant.index);
    switch (variant.kind) {
    case Variant::Kind::Edited:
    case Variant::Kind::Stored:
    case Variant::Kind::Mine:
        break;
    case Variant::Kind::Mode:
        return {"mode", "shading", &choices<ShadingMode>[index]};
    case Variant::Kind::Reflection:
        return {"reflection", "lighting", &choices<Reflection>[index]};
    case Variant::Kind::Interpolation:
        return {"interpolation", "interpolation", &choices<Interpolation>[index]};
    case Variant::Kind::LightPaths:
        return {"transport", "light", &choices<TransportModel>[index]};
    }
    return {};  // not reached
}

}  // namespace

Variant variant_of(ShadingMode mode) { return {Variant::Kind::Mode, static_cast<int>(mode)}; }

Variant variant_of(Reflection reflection) {
    return {Variant::Kind::Reflection, static_cast<int>(reflection)};
}

Variant variant_of(TransportModel model) { return {Variant::Kind::LightPaths, static_cast<int>(model)}; }

std::vector<Variant> all_variants() {
    std::vector<Variant> all{{}};
    add_variants<ShadingMode>(all, Variant::Kind::Mode);
    add_variants<Reflection>(all, Variant::Kind::Reflection);
    add_variants<Interpolation>(all, Variant::Kind::Interpolation);
    add_variants<TransportModel>(all, Variant::Kind::LightPaths);
    all.push_back({Variant::Kind::Stored, 0});
    all.push_back({Variant::Kind::Mine, 0});
    return all;
}

std::string word_of(Variant variant) {
    if (variant.kind == Variant::Kind::Edited) return "edited";
    if (variant.kind == Variant::Kind::Stored) return "stored";
    if (variant.kind == Variant::Kind::Mine) return "mine";
    const NamedChoice named = choice_in(variant);
    return std::string(named.field) + " " + std::string(named.choice->word);
}

std::optional<Variant> variant_named(const std::string& word) {
    for (const Variant& variant : all_variants())
        if (word_of(variant) == word) return variant;
    return {};
}

std::string label_of(Variant variant) {
    if (variant.kind == Variant::Kind::Edited) return "As edited";
    if (variant.kind == Variant::Kind::Stored) return "B, stored";
    if (variant.kind == Variant::Kind::Mine) return "My picture";
    const NamedChoice named = choice_in(variant);
    const std::string label = named.choice->label;
    // "Unlit" and "With shadows" are clear without the noun.
    const bool is_clear = variant == variant_of(Reflection::None) ||
                          (variant.kind == Variant::Kind::LightPaths && variant.index > 0);
    return is_clear ? label : label + " " + named.noun;
}

bool lacks_stored(const CompareChoice& choice, Variant variant) {
    return variant.kind == Variant::Kind::Stored && choice.stored == nullptr;
}

bool lacks_picture(const CompareChoice& choice, Variant variant) {
    return variant.kind == Variant::Kind::Mine && choice.mine == nullptr;
}

std::string part_label(const CompareState& state, std::size_t part) {
    const CompareChoice& choice = state.choice;
    const Variant variant = choice.parts[part];
    if (lacks_stored(choice, variant)) return "B: nothing stored";
    if (variant.kind == Variant::Kind::Edited && !state.resting.empty()) return state.resting;
    if (variant.kind == Variant::Kind::Mine && !state.label_of_mine.empty()) return state.label_of_mine;
    return lacks_picture(choice, variant) ? "My picture: not open" : label_of(variant);
}

Scene scene_under(Variant variant, const Scene& edited, const Scene* stored) {
    const auto index = static_cast<std::size_t>(variant.index);
    Scene scene = edited;
    switch (variant.kind) {
    case Variant::Kind::Edited:
    case Variant::Kind::Mine:
        break;
    case Variant::Kind::Mode:
        scene.shading.mode = static_cast<ShadingMode>(index);
        break;
    case Variant::Kind::Reflection:
        scene.shading.reflection = static_cast<Reflection>(index);
        break;
    case Variant::Kind::Interpolation:
        scene.shading.interpolation = static_cast<Interpolation>(index);
        break;
    case Variant::Kind::LightPaths:
        scene.transport.model = static_cast<TransportModel>(index);
        break;
    case Variant::Kind::Stored:
        if (stored == nullptr) break;
        scene = *stored;
        scene.camera = edited.camera;
        break;
    }
    return scene;
}

void set_parts(CompareChoice& choice, std::vector<Variant> parts) {
    choice.parts = std::move(parts);
    choice.wipes.clear();
    for (std::size_t i = 1; i < choice.parts.size(); ++i)
        choice.wipes.push_back(double(i) / double(choice.parts.size()));
}

}  // namespace glint
