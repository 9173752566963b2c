// Picks the brightest, the darkest or the first clipped pixel of the surfaces in the picture.
#include <fmt/core.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "ui/commands/command.h"
#include "ui/feature.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

enum class Sought { None, Brightest, Darkest, Clipped };

/// Waits for a picture that includes linear colours.
struct FindPixelState {
    Sought sought = Sought::None;
};

/// How well a colour matches; the first pixel with the largest value is picked. `exposure` as in the scene.
float fitness(Sought sought, glm::vec3 linear, float exposure) {
    const float luminance = glm::dot(linear, {0.2126f, 0.7152f, 0.0722f});  // ITU-R BT.709
    if (sought == Sought::Brightest) return luminance;
    if (sought == Sought::Darkest) return -luminance;
    return exposure * std::max({linear.x, linear.y, linear.z}) > 1.0005f ? 1 : -HUGE_VALF;
}

std::optional<glm::ivec2> find(Sought sought, const UiState& state) {
    const Picture& picture = *state.rendered;
    std::optional<glm::ivec2> best;
    float most = -HUGE_VALF;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            if (state.renderer->object_at(x, y) < 0) continue;
            const float fits =
                fitness(sought, picture.linear_at(x, y), state.rendered_scene.display.exposure);
            if (fits > most) most = fits, best = glm::ivec2(x, y);
        }
    return best;
}

void pick_found(UiState& state) {
    Sought& sought = state.get<FindPixelState>().sought;
    if (sought == Sought::None) return;
    if (state.rendered->linear.empty() || !(state.rendered->size == state.full_size)) return redraw_within(0);
    const Sought wanted = std::exchange(sought, Sought::None);
    const std::optional<glm::ivec2> found = find(wanted, state);
    if (!found)
        return state.notifications.tell(
            wanted == Sought::Clipped ? "No pixel is clipped" : "No surface is visible", Tone::Warning);
    const PictureSize size = state.rendered->size;
    ask_about(state.viewport, (glm::dvec2(*found) + 0.5) / glm::dvec2(size.width, size.height));
    state.layout.right = state.left_shows_inspector = state.viewport.touched = true;
    constexpr const char* names[] = {"", "Brightest", "Darkest", "First clipped"};
    state.notifications.tell(
        fmt::format("{} pixel: {}, {}", names[static_cast<int>(wanted)], found->x, found->y));
    redraw_within(0);
}

template <Sought what> WindowCommand find_command(const char* name, const char* words) {
    return {.name = name,
            .section = Section::InspectFind,
            .run = [](UiState& s) { s.get<FindPixelState>().sought = what; },
            .why_disabled =
                [](const UiState& s) {
                    const std::string refusal = s.on_screen.refusal();
                    return refusal.empty() ? unless_drawn(s.rendered) : refusal;
                },
            .line_above = what == Sought::Brightest,
            .words = words};
}

std::vector<WindowCommand> find_commands() {
    return {find_command<Sought::Brightest>("Go to the brightest pixel", "find maximum"),
            find_command<Sought::Darkest>("Go to the darkest pixel", "find minimum"),
            find_command<Sought::Clipped>("Go to the first clipped pixel", "find overexposed bright")};
}

}  // namespace

extern const Feature find_pixel_feature;
const Feature find_pixel_feature{
    .update = pick_found,
    .needs =
        [](const UiState& s) {
            const bool seeks = s.get<FindPixelState>().sought != Sought::None;
            return PictureNeeds{.linear = seeks, .full_size = seeks};
        },
    .commands = find_commands,
    .leave_document = [](UiState& s, const SceneDocument&) { s.get<FindPixelState>() = {}; }};

}  // namespace glint
