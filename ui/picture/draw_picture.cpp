#include "ui/picture/draw_picture.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/picture/magnifier.h"
#include "ui/ui.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Whether a smaller picture may temporarily replace the full one. False while numbers computed from many
/// pixels are shown.
bool may_be_small(const UiState& state) {
    const bool camera = state.viewport.gesture == Gesture::Orbit || state.viewport.gesture == Gesture::Pan ||
                        state.viewport.gesture == Gesture::Dolly;
    const bool light =
        state.viewport.gesture == Gesture::Hand && state.viewport.held.grip.kind == GripKind::Light;
    const bool field = state.viewport.gesture == Gesture::None && ImGui::IsAnyItemActive();
    const PictureNeeds needs = picture_needs(state);
    return (camera || light || field) && state.on_screen.drawn() == nullptr && !needs.linear &&
           !needs.full_size && !(state.get<MagnifierState>().zoom > 1);
}

/// Returns the size of the next picture. `changed`: whether the scene has changed since the last one.
PictureSize paced_size(UiState& state, PictureSize full, bool changed, bool small_will_do) {
    FramePace& pace = state.pace;
    const bool small_now = state.rendered != nullptr && !(state.rendered->size == full);
    if (!small_will_do) {
        end_of_motion(pace);
        return full;
    }
    if (changed) {
        pace.rests_since = ImGui::GetTime();
        return divided(full, pace.divisor);
    }
    const double rest = pace.rests_since + rest_before_full - ImGui::GetTime();
    if (!small_now || rest <= 0) return full;
    redraw_within(rest);
    return state.rendered->size;
}

/// During a preview the explanation remains that of the previous picture. A preview of a different size may
/// not contain the explained pixel; the explanation is then hidden until the preview ends.
void follow_size(UiState& state, const PictureView& view) {
    OnScreen& shown = state.on_screen;
    const bool same = shown.explained_size == view.map.size && shown.explained_drawn == state.rendered->size;
    if (!same) shown.explanation.reset();
}

}  // namespace

void end_of_motion(FramePace& pace) {
    pace.divisor = 1;
    pace.in_vain = false;
}

void picture_took(FramePace& pace, int divisor, double ms) {
    const double pixels_fewer = double(divisor) * divisor;
    if (divisor == 1) {
        pace.full_ms = ms;
    } else if (ms > 0.8 * pace.full_ms) {
        pace.in_vain = true;
    } else if (ms * pixels_fewer > pace.full_ms || ms * pixels_fewer < wanted_picture_ms / 2) {
        // The estimate was too low, or the small picture was very cheap. Fixed costs do not shrink with the
        // size, so times in between do not predict the time of a full picture.
        pace.full_ms = ms * pixels_fewer;
    }
    if (pace.in_vain || pace.full_ms <= pace.slow_ms) {
        pace.divisor = 1;
        return;
    }
    const double wanted = std::ceil(std::sqrt(pace.full_ms / wanted_picture_ms));
    // During motion the resolution only decreases, because a change of resolution is more distracting than a
    // coarse picture.
    pace.divisor =
        static_cast<int>(std::clamp(std::max(wanted, double(divisor)), 2.0, double(largest_divisor)));
}

PictureSize divided(PictureSize full, int divisor) {
    return {std::max(full.width / divisor, 1), std::max(full.height / divisor, 1), full.keeps_width};
}

bool same_surfaces(const Scene& a, const Scene& b) {
    const auto same = [](const Object& one, const Object& other) {
        return one.mesh == other.mesh && one.transform == other.transform && one.visible == other.visible &&
               one.normals == other.normals;
    };
    return a.camera == b.camera &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(), same);
}

const Renderer* renderer_of_open_scene(const UiState& state, PictureSize size) {
    const bool tells = state.rendered != nullptr && state.rendered->size == size &&
                       same_surfaces(state.rendered_scene, state.editor.scene());
    return tells ? state.renderer.get() : nullptr;
}

const ShownPart* part_at(const UiState& state, glm::ivec2 pixel) {
    const auto found = std::find_if(state.parts.begin(), state.parts.end(),
                                    [pixel](const ShownPart& part) { return part.rect.holds(pixel); });
    return found == state.parts.end() ? nullptr : &*found;
}

void draw_picture(UiState& state, const PictureView& view) {
    poll_loads(state);
    state.full_size = view.map.size;
    decide_shown(state.on_screen, state);
    const OtherScene* const other = state.on_screen.drawn();
    const Scene& shown = other != nullptr ? other->scene : state.editor.scene();
    const bool moves = may_be_small(state);
    state.pace.drawn_at = 0;
    const bool changed = !(state.rendered_scene == shown);
    if (state.editor.before) state.failed_size = {0, 0};  // the previous document may be smaller
    const bool failed = state.rendered != nullptr && view.map.size == state.failed_size;
    const PictureSize size = failed ? state.rendered->size : paced_size(state, view.map.size, changed, moves);
    const bool same_size = state.rendered != nullptr && state.rendered->size == size;
    const bool linear = picture_needs(state).linear;
    const bool has_linear = state.rendered != nullptr && !state.rendered->linear.empty();
    if (!same_size || changed || (linear && !has_linear)) {
        try {
            state.rendered = &state.refinement.begin(*state.renderer, shown, size, linear,
                                                     state.on_screen.passing.has_value());
        } catch (const std::exception&) {
            state.failed_size = changed ? PictureSize{0, 0} : size;
            draw_scene_before(state, other != nullptr);
            throw;
        }
        state.rendered_scene = shown;
        ++state.picture_serial;
        if (moves && changed) state.pace.drawn_at = size == view.map.size ? 1 : state.pace.divisor;
    } else if (const Picture* better = state.refinement.advance(*state.renderer, state.jobs, state.threads)) {
        state.rendered = better;
        ++state.picture_serial;
    }
    // A frozen scene may equal the edited one; then it is not drawn again.
    if (changed || !same_size || other == nullptr)
        state.rendered_is_edited = other == nullptr && !awaits_mesh(state);
    if (!state.on_screen.explained_other && !is_explained(state)) state.on_screen.explanation.reset();
    state.on_screen.explained_by = nullptr;
    if (state.on_screen.passing) return follow_size(state, view);
    if (other == nullptr) state.editor.before.reset();
    if (other == nullptr && !(state.edited_drawn == shown)) state.edited_drawn = shown;
    explain_picked(state, view);
}

void learn_pace(UiState& state) {
    if (state.pace.drawn_at == 0) return;
    picture_took(state.pace, state.pace.drawn_at, state.renderer->stats().total_ms + state.parts_ms);
}

namespace {

/// Whether the two points are on adjacent parts of one smooth surface.
bool hang_together(const SeenPoint& a, const SeenPoint& b) {
    if (a.object != b.object || glm::dot(a.normal, b.normal) < 0.7f) return false;
    // The vector between two points of a smooth surface is perpendicular to the mean of their normals.
    const glm::vec3 way = b.position - a.position, normal = a.normal + b.normal;
    return std::abs(glm::dot(way, normal)) <= 1.2f * glm::length(way);
}

}  // namespace

std::optional<SeenPoint> seen_at(const Renderer& renderer, PictureSize size, glm::dvec2 pixel) {
    if (!is_inside(size, pixel)) return {};
    return renderer.seen_at(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

std::optional<SurfacePatch> surface_patch(const Renderer& renderer, PictureSize size, glm::dvec2 pixel,
                                          int radius) {
    const auto middle = seen_at(renderer, size, pixel);
    if (!middle) return {};
    SurfacePatch patch;
    patch.radius = radius;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const auto point = seen_at(renderer, size, pixel + glm::dvec2(x, y));
            const bool used = point && hang_together(*middle, *point);
            patch.points.push_back(used ? *point : *middle);
            patch.used.push_back(used);
        }
    return patch;
}

glm::dvec2 SurfacePatch::offset(std::size_t i) const {
    const int side = 2 * radius + 1;
    const int across = static_cast<int>(i) % side, down = static_cast<int>(i) / side;
    return {across - radius, down - radius};
}

glm::dvec2 SurfacePatch::slope_of_log(const std::vector<double>& values, int within) const {
    glm::dmat2 squares(0);
    glm::dvec2 rises(0);
    for (std::size_t i = 0; i < points.size() / 2; ++i) {
        const std::size_t opposite = points.size() - 1 - i;
        if (!used[i] || !used[opposite] || !(values[i] > 0) || !(values[opposite] > 0)) continue;
        const glm::dvec2 way = offset(opposite);
        if (std::max(std::abs(way.x), std::abs(way.y)) > within) continue;
        squares += glm::outerProduct(way, way);
        rises += (std::log(values[opposite]) - std::log(values[i])) / 2 * way;
    }
    if (!(glm::determinant(squares) > 0)) return glm::dvec2(0);
    return glm::inverse(squares) * rises;
}

double SurfacePatch::steepness(const std::function<double(const SeenPoint&)>& value) const {
    // Of the nine pixels, pixel 1 is above the centre, 3 and 5 are to its left and right, and 7 is below it.
    const auto slope = [&](std::size_t before, std::size_t after) {
        const double span = (used[before] ? 1 : 0) + (used[after] ? 1 : 0);
        return span > 0 ? (value(points[after]) - value(points[before])) / span : 0.0;
    };
    return std::hypot(slope(3, 5), slope(1, 7));
}

double SurfacePatch::distance_of_maximum(const std::vector<double>& values) const {
    const std::size_t middle = points.size() / 2;
    if (!(values[middle] > 0)) return radius + 1;
    double largest = values[middle], distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double away = glm::length(offset(i));
        if (!used[i] || values[i] < largest || (values[i] == largest && away >= distance)) continue;
        largest = values[i];
        distance = away;
    }
    return distance;
}

}  // namespace glint
