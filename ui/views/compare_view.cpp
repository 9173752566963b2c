#include "ui/views/compare_view.h"

#include <algorithm>
#include <cmath>

#include "models/fields/choices.h"
#include "models/saturate.h"
#include "ui/views/fitted_picture.h"

namespace glint {
namespace {

/// Copies the pixels from `low` to before `high` of one picture into the same place of another.
void copy_pixels(const Picture& from, Picture& to, glm::ivec2 low, glm::ivec2 high) {
    if (high.x <= low.x) return;
    const auto count = static_cast<std::ptrdiff_t>(high.x - low.x);
    for (int y = low.y; y < high.y; ++y) {
        const auto at = static_cast<std::ptrdiff_t>(to.pixel(low.x, y));
        std::copy_n(from.rgba.begin() + 4 * at, 4 * count, to.rgba.begin() + 4 * at);
        if (!to.linear.empty())
            std::copy_n(from.linear.begin() + 3 * at, 3 * count, to.linear.begin() + 3 * at);
    }
}

/// Draws the parts whose scene is not the one drawn already.
void draw_parts(CompareState& state, const DrawnScene& drawn) {
    const CompareChoice& choice = state.choice;
    state.renderers.resize(choice.parts.size());
    state.pictures.assign(choice.parts.size(), &drawn.picture);
    state.drawn_by.assign(choice.parts.size(), &drawn.renderer);
    state.ms = 0;
    for (std::size_t i = 0; i < choice.parts.size(); ++i) {
        if (choice.parts[i].kind == Variant::Kind::Mine && choice.mine) {
            state.fitted = fitted_picture(*choice.mine, drawn.scene, drawn.picture, choice.difference);
            state.pictures[i] = &state.fitted;
            continue;
        }
        const Scene scene = scene_under(choice.parts[i], drawn.scene, choice.stored.get());
        if (scene == drawn.scene) continue;
        if (!state.renderers[i]) state.renderers[i] = std::make_unique<Renderer>(drawn.threads);
        state.pictures[i] =
            &state.renderers[i]->render(scene, drawn.picture.size, !drawn.picture.linear.empty());
        state.drawn_by[i] = state.renderers[i].get();
        state.ms += state.renderers[i]->stats().total_ms;
    }
}

void compose_difference(CompareState& state) {
    const Picture &first = *state.pictures.front(), &last = *state.pictures.back();
    const Result<Comparison> numbers = compare(first, last);
    if (const auto* found = std::get_if<Comparison>(&numbers)) state.numbers = *found;
    state.picture = difference_picture(first, last, state.choice.gain);
}

template <class E> void add_variants(std::vector<Variant>& all, Variant::Kind kind) {
    for (std::size_t i = 0; i < count_of<E>(); ++i) all.push_back({kind, static_cast<int>(i)});
}

/// A choice in place of the edited one: its field's key, and the noun of its label.
struct NamedChoice {
    const char *field = "", *noun = "";
    const Choice* choice = nullptr;
};

/// Precondition: one of those that change a choice.
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
    }
    return {};  // not reached
}

}  // namespace

int length_of(const CompareChoice& choice, PictureSize size) {
    return choice.stacked ? size.height : size.width;
}

int first_of(const CompareChoice& choice, int part, int length) {
    if (part <= 0) return 0;
    if (part >= static_cast<int>(choice.parts.size())) return length;
    const double share = choice.wipes[static_cast<std::size_t>(part - 1)];
    return std::clamp(saturated_int(std::round(share * length)), 0, length);
}

int part_at(const CompareChoice& choice, int along, int length) {
    int part = 0;
    while (part + 1 < static_cast<int>(choice.parts.size()) && first_of(choice, part + 1, length) <= along)
        ++part;
    return part;
}

const Picture& compose(CompareState& state, const DrawnScene& drawn) {
    draw_parts(state, drawn);
    if (state.choice.difference) {
        compose_difference(state);
        return state.picture;
    }
    const PictureSize size = drawn.picture.size;
    state.picture.size = size;
    state.picture.rgba.resize(drawn.picture.rgba.size());
    state.picture.linear.resize(drawn.picture.linear.size());
    const bool stacked = state.choice.stacked;
    const int length = length_of(state.choice, size);
    for (int part = 0; part < static_cast<int>(state.pictures.size()); ++part) {
        const int first = first_of(state.choice, part, length),
                  end = first_of(state.choice, part + 1, length);
        copy_pixels(*state.pictures[static_cast<std::size_t>(part)], state.picture,
                    stacked ? glm::ivec2(0, first) : glm::ivec2(first, 0),
                    stacked ? glm::ivec2(size.width, end) : glm::ivec2(end, size.height));
    }
    return state.picture;
}

int part_of(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    if (!state.choice.on || state.choice.difference || state.picture.size != size) return -1;
    return part_at(state.choice, state.choice.stacked ? pixel.y : pixel.x, length_of(state.choice, size));
}

const Renderer* part_renderer(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    const auto part = static_cast<std::size_t>(part_of(state, pixel, size));  // -1 becomes the largest
    return part < state.drawn_by.size() ? state.drawn_by[part] : nullptr;
}

void set_parts(CompareChoice& choice, std::vector<Variant> parts) {
    choice.parts = std::move(parts);
    choice.wipes.clear();
    for (std::size_t i = 1; i < choice.parts.size(); ++i)
        choice.wipes.push_back(double(i) / double(choice.parts.size()));
}

Variant variant_of(ShadingMode mode) { return {Variant::Kind::Mode, static_cast<int>(mode)}; }

Variant variant_of(Reflection reflection) {
    return {Variant::Kind::Reflection, static_cast<int>(reflection)};
}

std::vector<Variant> all_variants() {
    std::vector<Variant> all{{}};
    add_variants<ShadingMode>(all, Variant::Kind::Mode);
    add_variants<Reflection>(all, Variant::Kind::Reflection);
    add_variants<Interpolation>(all, Variant::Kind::Interpolation);
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
    // "Unlit" says by itself what it is.
    return variant == variant_of(Reflection::None) ? label : label + " " + named.noun;
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
    case Variant::Kind::Stored:
        if (stored == nullptr) break;
        scene = *stored;
        scene.camera = edited.camera;
        break;
    }
    return scene;
}

}  // namespace glint
