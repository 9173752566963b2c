#include "ui/features/views/compare_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/features/views/fitted_picture.h"

namespace glint {
namespace {

/// Copies the pixels from `low` to `high`, exclusive, of one picture to the same position in another.
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

/// Draws the parts whose scene is not already drawn.
void draw_parts(CompareState& state, const DrawnScene& drawn) {
    const CompareChoice& choice = state.choice;
    state.renderers.resize(choice.parts.size());
    state.refinements.resize(choice.parts.size());
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
        state.pictures[i] = &state.refinements[i].begin(*state.renderers[i], scene, drawn.picture.size,
                                                        !drawn.picture.linear.empty(), false);
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

}  // namespace

int length_of(const CompareChoice& choice, PictureSize size) {
    return choice.stacked ? size.height : size.width;
}

int first_of(const CompareChoice& choice, int part, int length) {
    if (part <= 0) return 0;
    if (part >= static_cast<int>(choice.parts.size())) return length;
    const double share = choice.wipes[static_cast<std::size_t>(part - 1)];
    return static_cast<int>(std::round(std::clamp(share, 0.0, 1.0) * length));
}

int part_at(const CompareChoice& choice, int along, int length) {
    int part = 0;
    while (part + 1 < static_cast<int>(choice.parts.size()) && first_of(choice, part + 1, length) <= along)
        ++part;
    return part;
}

PartRect part_rect(const CompareChoice& choice, int part, PictureSize size) {
    const int length = length_of(choice, size);
    const int first = first_of(choice, part, length), end = first_of(choice, part + 1, length);
    return choice.stacked ? PartRect{{0, first}, {size.width, end}}
                          : PartRect{{first, 0}, {end, size.height}};
}

void borrow_comparison(CompareState& state) {
    if (state.borrowers++ == 0) state.own = state.choice;
}

void give_comparison_back(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (--state.borrowers > 0) return;
    const auto stored = choice.stored;
    choice = *std::exchange(state.own, std::nullopt);
    choice.stored = stored;
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
    for (int part = 0; part < static_cast<int>(state.pictures.size()); ++part) {
        const PartRect rect = part_rect(state.choice, part, size);
        copy_pixels(*state.pictures[static_cast<std::size_t>(part)], state.picture, rect.low, rect.high);
    }
    return state.picture;
}

bool refine_parts(CompareState& state, Jobs& jobs, int threads, float& progress) {
    progress = 1;
    bool better = false;
    for (std::size_t i = 0; i < state.drawn_by.size(); ++i) {
        if (state.drawn_by[i] == nullptr || state.drawn_by[i] != state.renderers[i].get()) continue;
        better |= state.refinements[i].advance(*state.renderers[i], jobs, threads) != nullptr;
        progress = std::min(progress, state.refinements[i].progress());
    }
    return better;
}

void forget_parts(CompareState& state) {
    state.refinements.clear();
    state.drawn_by.clear();
    state.pictures.clear();
    state.renderers.clear();
    state.fitted = {};
    state.picture = {};
}

int part_of(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    if (!state.choice.on || state.choice.difference || state.picture.size != size) return -1;
    return part_at(state.choice, state.choice.stacked ? pixel.y : pixel.x, length_of(state.choice, size));
}

const Renderer* part_renderer(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    const auto part = static_cast<std::size_t>(part_of(state, pixel, size));  // -1 becomes the largest value
    return part < state.drawn_by.size() ? state.drawn_by[part] : nullptr;
}

std::vector<DrawnPart> drawn_parts(const CompareState& state, const Renderer& drawn, PictureSize size) {
    if (part_of(state, {0, 0}, size) < 0) return {{&drawn, {{0, 0}, {size.width, size.height}}, {}}};
    const CompareChoice& choice = state.choice;
    std::vector<DrawnPart> parts;
    for (int i = 0; i < static_cast<int>(choice.parts.size()); ++i) {
        const Variant variant = choice.parts[static_cast<std::size_t>(i)];
        if (variant.kind == Variant::Kind::Mine && choice.mine) continue;
        parts.push_back({state.drawn_by[static_cast<std::size_t>(i)], part_rect(choice, i, size), variant});
    }
    return parts;
}

}  // namespace glint
