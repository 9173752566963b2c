#include "diagnose/search/camera_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "diagnose/search/probes.h"

namespace glint {
namespace {

constexpr double margin = 1.5;  // the scene's outline is drawn for a picture this many times as wide and high

/// Points between a pixel that shows a surface and a neighbour that shows none, in pixels from the picture's
/// centre.
using Outline = std::vector<glm::dvec2>;

template <class Shows> Outline outline(PictureSize size, const Shows& shows) {
    Outline points;
    const glm::dvec2 middle(size.width / 2.0, size.height / 2.0);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const bool here = shows(x, y);
            if (x + 1 < size.width && here != shows(x + 1, y))
                points.push_back(glm::dvec2(x + 1, y + 0.5) - middle);
            if (y + 1 < size.height && here != shows(x, y + 1))
                points.push_back(glm::dvec2(x + 0.5, y + 1) - middle);
        }
    return points;
}

/// For each pixel, 1 if a wrong picture shows something in front of its background. A pixel that an edge
/// covers by less than half counts as background.
std::vector<std::uint8_t> silhouette_in(const Picture& wrong, Rgb ground) {
    const PictureSize size = wrong.size;
    constexpr int least = 8, reach = 2;
    std::vector<int> off(size.pixels());
    for (std::size_t i = 0; i < off.size(); ++i) off[i] = most_apart(rgb_at(wrong, i), ground);
    const auto around = [&](const std::vector<int>& from, int dx, int dy, const auto& choose) {
        std::vector<int> to(size.pixels());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                int chosen = from[size.index(x, y)];
                for (int k = -reach; k <= reach; ++k)
                    chosen = choose(chosen, from[size.index(std::clamp(x + k * dx, 0, size.width - 1),
                                                            std::clamp(y + k * dy, 0, size.height - 1))]);
                to[size.index(x, y)] = chosen;
            }
        return to;
    };
    const auto larger = [](int a, int b) { return std::max(a, b); };
    const auto smaller = [](int a, int b) { return std::min(a, b); };
    const std::vector<int> most = around(around(off, 1, 0, larger), 0, 1, larger);
    const std::vector<int> fewest = around(around(off, 1, 0, smaller), 0, 1, smaller);
    std::vector<std::uint8_t> shows(size.pixels());
    for (std::size_t i = 0; i < shows.size(); ++i)
        shows[i] = off[i] > least && (fewest[i] > least || 2 * off[i] > most[i]) ? 1 : 0;
    return shows;
}

/// How many pixels of the renderer's last picture show a surface where the silhouette does not, or vice
/// versa.
std::size_t count_unlike(const Renderer& renderer, const std::vector<std::uint8_t>& shows, PictureSize size) {
    std::size_t count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            count += (renderer.object_at(x, y) >= 0) != (shows[size.index(x, y)] != 0) ? 1 : 0;
    return count;
}

/// Distances to an outline on a grid of half pixels.
class Distances {
  public:
    Distances(const Outline& points, PictureSize size)
        : width_(2 * size.width + 3),  // with a border of one cell, which is far from everything
          height_(2 * size.height + 3),
          cells_(std::size_t(width_) * std::size_t(height_), far) {
        for (const glm::dvec2& p : points)
            cells_[index(static_cast<int>(std::lround(2 * p.x)) + size.width + 1,
                         static_cast<int>(std::lround(2 * p.y)) + size.height + 1)] = 0;
        constexpr float straight = 0.5f, diagonal = 0.7071f;  // pixels
        const std::ptrdiff_t row = width_;
        const auto pass = [&](std::ptrdiff_t first, std::ptrdiff_t step) {
            for (int y = 2; y < height_; ++y, first += step * 2)
                for (int x = 2; x < width_; ++x, first += step) {
                    float* const c = &cells_[std::size_t(first)];
                    const float side = std::min(c[-step], c[-step * row]) + straight;
                    const float corner = std::min(c[-step * row - 1], c[-step * row + 1]) + diagonal;
                    *c = std::min(*c, std::min(side, corner));
                }
        };
        pass(row + 1, 1);
        pass(std::ptrdiff_t(cells_.size()) - row - 2, -1);
    }

    /// The distance at a point given in pixels from the centre, interpolated; `far` outside.
    [[nodiscard]] double at(glm::dvec2 p) const {
        const int middle_x = width_ / 2, middle_y = height_ / 2;
        const double x = 2 * p.x + middle_x, y = 2 * p.y + middle_y;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        if (i < 1 || j < 1 || i + 2 >= width_ || j + 2 >= height_) return double(far);
        const double u = x - i, v = y - j;
        const auto cell = [&](int a, int b) { return double(cells_[index(i + a, j + b)]); };
        return (1 - v) * ((1 - u) * cell(0, 0) + u * cell(1, 0)) +
               v * ((1 - u) * cell(0, 1) + u * cell(1, 1));
    }

  private:
    static constexpr float far = 1e4f;
    [[nodiscard]] std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }
    int width_, height_;
    std::vector<float> cells_;
};

/// The scale horizontally and vertically, then the shift to the right and down.
using Place = std::array<double, 4>;

glm::dvec2 in_scene(const Place& p, glm::dvec2 point) {
    return (point - glm::dvec2(p[2], p[3])) / glm::dvec2(p[0], p[1]);
}

/// The mean square of the distances from the picture's outline to the scene's outline at a place, each
/// clamped to `most`.
double misfit(const Outline& mine, const Distances& scene, const Place& p, double most) {
    double sum = 0;
    for (const glm::dvec2& point : mine) {
        const double distance = std::min(most, scene.at(in_scene(p, point)));
        sum += distance * distance;  // squares have their minimum at a shift of half a pixel
    }
    return sum / static_cast<double>(mine.size());
}

/// The share of the picture's outline that is near the scene's. Dark surfaces in front of a dark background
/// have their own outlines, so the share is rarely 1.
double share_near(const Outline& mine, const Distances& scene, const Place& p) {
    constexpr double near = 0.75;  // pixels
    const auto count = std::count_if(mine.begin(), mine.end(), [&](const glm::dvec2& point) {
        return scene.at(in_scene(p, point)) < near;
    });
    return static_cast<double>(count) / static_cast<double>(mine.size());
}

/// Which numbers of a place are free, and whether the two scales may differ (`stretch`).
struct Freedom {
    bool scale = false, stretch = false, shift = false;
};

/// Whether a place is in the range that is searched. With a larger range, many unrelated lines could
/// match a few of the scene's.
bool is_likely(const Place& p, double radius) {
    const auto [least, most] = std::minmax(p[0], p[1]);
    return least > 0.5 && most < 2 && most < 1.5 * least && std::hypot(p[2], p[3]) < radius;
}

/// Searches along the free numbers, with shorter and shorter steps.
double improve(Place& place, double first_step, double last_step, const Freedom& free, double radius,
               const std::function<double(const Place&)>& cost) {
    std::vector<std::array<double, 4>> ways;
    if (free.shift) ways.insert(ways.end(), {{0, 0, 1, 0}, {0, 0, 0, 1}});
    if (free.scale && !free.stretch) ways.push_back({1 / radius, 1 / radius, 0, 0});
    if (free.stretch) ways.insert(ways.end(), {{1 / radius, 0, 0, 0}, {0, 1 / radius, 0, 0}});
    double best = cost(place);
    for (double step = first_step; step >= last_step; step /= 2)
        for (bool better = true; better;) {
            better = false;
            for (const auto& way : ways)
                for (const double sign : {1.0, -1.0}) {
                    Place tried = place;
                    for (std::size_t i = 0; i < 4; ++i) tried[i] += sign * step * way[i];
                    const double c = cost(tried);
                    if (c >= best - 1e-9 || !is_likely(tried, radius)) continue;
                    best = c;
                    place = tried;
                    better = true;
                }
        }
    return best;
}

/// The camera whose picture is that of `camera`, scaled about its centre and then shifted, and `wider` times
/// as wide and high.
Camera placed(const Camera& camera, PictureSize size, const Place& p, double wider = 1) {
    Camera changed = camera;
    const double width = size.width, height = size.height;
    if (const auto* o = std::get_if<Orthographic>(&camera.projection)) {
        const glm::dmat4 axes = world_from_view(camera);
        const double unit = double(o->height) / height / p[1];
        const glm::vec3 by(-p[2] * unit * glm::dvec3(axes[0]) + p[3] * unit * glm::dvec3(axes[1]));
        changed.eye += by;
        changed.target += by;
        std::get<Orthographic>(changed.projection).height = static_cast<float>(o->height / p[1] * wider);
        return changed;
    }
    Frustum f;
    if (const auto* of = std::get_if<Frustum>(&camera.projection)) {
        f = *of;
    } else {
        const Perspective perspective = std::get<Perspective>(fitted(camera.projection, size));
        const double top =
            double(perspective.near) * std::tan(glm::radians(double(perspective.fov_y_deg)) / 2);
        if (p[0] == p[1] && p[2] == 0 && p[3] == 0) {
            Perspective zoomed = perspective;
            zoomed.fov_y_deg = static_cast<float>(
                glm::degrees(2 * std::atan(top * wider / p[1] / double(perspective.near))));
            changed.projection = zoomed;
            return changed;
        }
        f.near = perspective.near;
        f.far = perspective.far;
        f.top = static_cast<float>(top);
        f.bottom = -f.top;
        f.right = static_cast<float>(top * width / height);
        f.left = -f.right;
    }
    const double x = (double(f.right) - double(f.left)) / width,
                 y = (double(f.top) - double(f.bottom)) / height;
    const double middle_x = (double(f.left) + double(f.right)) / 2,
                 middle_y = (double(f.top) + double(f.bottom)) / 2;
    const double half_x = wider * width / 2, half_y = wider * height / 2;
    f.left = static_cast<float>(middle_x + x * (-half_x - p[2]) / p[0]);
    f.right = static_cast<float>(middle_x + x * (half_x - p[2]) / p[0]);
    f.top = static_cast<float>(middle_y + y * (half_y + p[3]) / p[1]);
    f.bottom = static_cast<float>(middle_y + y * (-half_y + p[3]) / p[1]);
    changed.projection = f;
    return changed;
}

/// Moves eye and target. `by`: camera coordinates.
Camera moved(const Camera& camera, glm::dvec3 by) {
    Camera changed = camera;
    const glm::vec3 in_world(glm::dmat3(world_from_view(camera)) * by);
    changed.eye += in_world;
    changed.target += in_world;
    return changed;
}

/// The shift of half a pixel under which the silhouette agrees much better: many programs sample pixels at
/// their corners. Outlines are too coarse to show such a shift, but counting pixels is exact.
std::optional<Place> half_pixel_shift(Renderer& renderer, const Scene& right, PictureSize size,
                                      const std::vector<std::uint8_t>& shows, std::size_t points) {
    constexpr double clearly = 0.1;  // as a fraction of the outline's points
    const auto unlike = [&](const Place& p) {
        Scene scene = right;
        scene.camera = placed(right.camera, size, p);
        (void)renderer.render(scene, size);
        return static_cast<double>(count_unlike(renderer, shows, size));
    };
    const Place none{1, 1, 0, 0};
    const double before = unlike(none);
    double best = before - clearly * static_cast<double>(points);
    if (best < 0) return std::nullopt;
    std::optional<Place> found;
    for (const double x : {-0.5, 0.0, 0.5})
        for (const double y : {-0.5, 0.0, 0.5}) {
            const Place p{1, 1, x, y};
            const double c = unlike(p);
            if (c >= best) continue;
            best = c;
            found = p;
        }
    return found;
}

/// Fits places and moves of one scene's camera to one picture.
class CameraFit {
  public:
    CameraFit(Renderer& renderer, const Scene& right, PictureSize size, Outline mine)
        : renderer_(renderer), scene_(right), size_(size), mine_(std::move(mine)) {
        double squares = 0;
        for (const glm::dvec2& p : mine_) squares += glm::dot(p, p);
        radius_ = std::max(8.0, std::sqrt(squares / static_cast<double>(mine_.size())));
        wide_ = {2 * static_cast<int>(margin * size.width / 2),
                 2 * static_cast<int>(margin * size.height / 2)};
        if (size.width % 2 != 0) ++wide_.width;  // the centre of each of the two is the centre of a pixel
        if (size.height % 2 != 0) ++wide_.height;
    }

    [[nodiscard]] Distances seen_from(const Camera& camera) {
        Scene scene = scene_;
        // Pixels have the same size in both pictures.
        Place p{1, 1, 0, 0};
        scene.camera = placed(camera, size_, p, double(wide_.height) / size_.height);
        if (auto* f = std::get_if<Frustum>(&scene.camera.projection); f != nullptr) {
            const double more = double(wide_.width) / size_.width / (double(wide_.height) / size_.height);
            const float middle = (f->left + f->right) / 2,
                        half = static_cast<float>((f->right - middle) * more);
            f->left = middle - half;
            f->right = middle + half;
        }
        (void)renderer_.render(scene, wide_);
        return Distances(outline(wide_, [&](int x, int y) { return renderer_.object_at(x, y) >= 0; }), wide_);
    }
    [[nodiscard]] double misfit_of(const Distances& scene, const Place& p, double most) const {
        return misfit(mine_, scene, p, most);
    }
    [[nodiscard]] double share(const Distances& scene, const Place& p) const {
        return share_near(mine_, scene, p);
    }
    /// Whether every small change to a place makes the misfit larger.
    [[nodiscard]] bool is_best_near(const Distances& scene, const Place& p) const {
        constexpr double step = 0.4;  // pixels
        const double here = misfit_of(scene, p, finest);
        for (const Place& by :
             {Place{0, 0, step, 0}, Place{0, 0, 0, step}, Place{step / radius_, step / radius_, 0, 0}})
            for (const double sign : {1.0, -1.0}) {
                Place other = p;
                for (std::size_t i = 0; i < 4; ++i) other[i] += sign * by[i];
                if (misfit_of(scene, other, finest) <= here) return false;
            }
        return true;
    }
    double improve_place(const Distances& scene, Place& p, const Freedom& free, double first) const {
        double most = std::max(3.0, first);
        for (; most > 3; most /= 2)
            improve(p, most / 2, 0.5, free, radius_,
                    [&](const Place& q) { return misfit(mine_, scene, q, most); });
        improve(p, 1, 1.0 / 8, free, radius_,
                [&](const Place& q) { return misfit(mine_, scene, q, finest); });
        // Points that are farther away belong to the outline of something else.
        improve(p, 0.25, 1.0 / 64, free, radius_, [&](const Place& q) { return misfit(mine_, scene, q, 1); });
        return misfit(mine_, scene, p, finest);
    }
    /// The RMS distance by which a place moves the outline, in pixels.
    [[nodiscard]] double moves(const Place& p) const {
        return std::hypot(std::hypot(p[2], p[3]), std::max(std::abs(p[0] - 1), std::abs(p[1] - 1)) * radius_);
    }
    static constexpr double finest = 3;  // pixels; farther points belong to a different outline

  private:
    Renderer& renderer_;
    const Scene& scene_;
    PictureSize size_, wide_;
    Outline mine_;
    double radius_ = 1;
};

/// Where the picture's outline is relative to the scene's, and the eye from which it was seen.
struct Seen {
    Place place{};
    glm::dvec3 eye{0};  // relative to the scene's eye
    double misfit = 0, share = 0;
};
/// The smallest share of an outline that must match.
constexpr double least_share = 0.3;

/// Fits the place. Frees more of its numbers only if that makes it fit clearly better.
void fit_place(Seen& seen, const CameraFit& fit, const Distances& scene, double far) {
    const Place none{1, 1, 0, 0};
    for (const Freedom& free : {Freedom{false, false, true}, Freedom{true, false, false},
                                Freedom{true, false, true}, Freedom{true, true, true}}) {
        Place p = none;
        double cost = fit.improve_place(scene, p, free, far);
        Place near = none;  // with distant points, outlines of dark surfaces mislead the fit
        if (const double c = fit.improve_place(scene, near, free, CameraFit::finest); c <= cost)
            p = near, cost = c;
        for (const double scale : {0.75, 0.87, 1.15, 1.33}) {
            if (!free.scale || fit.share(scene, p) >= least_share) break;
            Place other{scale, scale, 0, 0};
            const double c = fit.improve_place(scene, other, free, far / 2);
            if (c < cost) p = other, cost = c;
        }
        if (cost > 0.8 * seen.misfit - 0.01) continue;
        seen.place = p;
        seen.misfit = cost;
    }
}

double distance_of(const Camera& camera) { return double(glm::distance(camera.eye, camera.target)); }

/// Also fits the eye, because a different eye position changes the parallax. Does nothing if hardly any of
/// the scene's outline is visible, as in a dark picture, or if most of the outline already agrees.
void fit_eye(Seen& seen, CameraFit& fit, const Camera& camera) {
    if (seen.share <= least_share / 3 || seen.share >= least_share * 2) return;
    const Freedom all{true, false, true};
    const double distance = distance_of(camera);
    for (double step = 0.04 * distance; step > 0.001 * distance; step /= 2)
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                glm::dvec3 tried = seen.eye;
                tried[axis] += sign * step;
                Place p = seen.place;
                const Distances there = fit.seen_from(moved(camera, tried));
                const double c = fit.improve_place(there, p, all, 3);
                if (c <= 0.9 * seen.misfit - 0.005) seen = {p, tried, c, fit.share(there, p)};
            }
}

CameraDifference difference_of(Seen seen, const Camera& camera, PictureSize size) {
    constexpr double small = 0.05;
    Place& p = seen.place;
    for (std::size_t i = 2; i < 4; ++i)  // shifts of whole pixels are common
        if (std::abs(p[i] - std::round(p[i])) < 0.1) p[i] = std::round(p[i]) + 0.0;  // never -0
    CameraDifference d;
    d.scale = {p[0], p[1]};
    d.shift = {p[2], p[3]};
    d.eye = seen.eye;
    d.is_small = std::max(std::abs(p[0] - 1), std::abs(p[1] - 1)) <= small &&
                 glm::length(d.shift) <= small * size.height &&
                 glm::length(seen.eye) <= small * distance_of(camera);
    d.camera = placed(moved(camera, seen.eye), size, p);
    auto* const perspective = std::get_if<Perspective>(&d.camera.projection);
    if (perspective != nullptr && seen.eye == glm::dvec3(0)) {
        constexpr float of_half = 2, near = 0.2f;  // angles of half degrees are common
        const float rounded = std::round(perspective->fov_y_deg * of_half) / of_half;
        if (std::abs(rounded - perspective->fov_y_deg) < near) perspective->fov_y_deg = rounded;
    }
    return d;
}

}  // namespace

bool CameraDifference::is_field_of_view() const {
    return !is_stretched() && scale.x != 1 && shift == glm::dvec2(0) && eye == glm::dvec3(0) &&
           std::holds_alternative<Perspective>(camera.projection);
}

std::optional<CameraDifference> camera_difference(Renderer& renderer, const Scene& right,
                                                  const Picture& wrong, const std::vector<PixelKind>& kinds) {
    constexpr std::size_t enough = 100, most_points = 800;
    constexpr double agrees = 0.1, better = 1.5, least_move = 0.3;
    if (right.npr.silhouettes) return std::nullopt;  // strokes widen the outlines
    DisplayChange rough;
    rough.noise = 0.75f;
    const std::optional<Rgb> ground = background_of(wrong, kinds, rough);
    if (!ground) return std::nullopt;
    const PictureSize size = wrong.size;
    const std::vector<std::uint8_t> shows = silhouette_in(wrong, *ground);
    const Outline mine = outline(size, [&](int x, int y) { return shows[size.index(x, y)] != 0; });
    if (mine.size() < enough) return std::nullopt;
    Outline few;
    for (std::size_t i = 0; i < std::min(most_points, mine.size()); ++i)
        few.push_back(mine[i * mine.size() / std::min(most_points, mine.size())]);
    CameraFit fit(renderer, right, size, few);
    renderer.draw_blocks(std::make_shared<const std::vector<std::uint8_t>>());  // silhouettes need no colours
    const std::optional<Place> half_pixel = half_pixel_shift(renderer, right, size, shows, mine.size());
    // In the picture, dark surfaces have outlines of their own, so the scene's outlines are used as well.
    constexpr double most_of_it = 0.6;
    (void)renderer.render(right, size);
    const Outline drawn = outline(size, [&](int x, int y) { return renderer.object_at(x, y) >= 0; });
    const bool is_seen = share_near(drawn, Distances(mine, size), {1, 1, 0, 0}) > most_of_it;
    const auto found = [&]() -> std::optional<CameraDifference> {
        const Distances scene = fit.seen_from(right.camera);
        const Place none{1, 1, 0, 0};
        const double before = fit.misfit_of(scene, none, CameraFit::finest);
        const double share_before = fit.share(scene, none);
        const bool is_here = (is_seen || share_before >= least_share) && fit.is_best_near(scene, none);
        if (half_pixel && is_here) {
            CameraDifference d;
            d.shift = {(*half_pixel)[2], (*half_pixel)[3]};
            d.camera = placed(right.camera, size, *half_pixel);
            return d;
        }
        if (before < agrees || is_here) return std::nullopt;
        const double far = size.height / 8.0;
        for (const glm::dvec2 turned : {glm::dvec2(-1, 1), glm::dvec2(1, -1), glm::dvec2(-1, -1)})
            if (fit.share(scene, {turned.x, turned.y, 0, 0}) > better * share_before)
                return std::nullopt;  // flipped
        Seen seen{none, glm::dvec3(0), before, 0};
        fit_place(seen, fit, scene, far);
        seen.share = fit.share(scene, seen.place);
        fit_eye(seen, fit, right.camera);
        if (seen.share < least_share || seen.share < better * share_before) return std::nullopt;
        if (fit.moves(seen.place) < least_move && seen.eye == glm::dvec3(0)) return std::nullopt;
        return difference_of(seen, right.camera, size);
    }();
    renderer.draw_blocks(nullptr);
    return found;
}

std::string camera_text(const CameraDifference& d, const Camera& scene, PictureSize size) {
    std::vector<std::string> words;
    const auto* given = std::get_if<Perspective>(&scene.projection);
    const auto* mine = std::get_if<Perspective>(&d.camera.projection);
    if (d.is_stretched()) {
        words.push_back(fmt::format("stretched by {:.3f} across and {:.3f} down", d.scale.x, d.scale.y));
    } else if (d.scale.x != 1 && given != nullptr) {
        const double half = std::tan(glm::radians(double(given->fov_y_deg)) / 2);
        const double fov =
            mine != nullptr ? double(mine->fov_y_deg) : glm::degrees(2 * std::atan(half / d.scale.y));
        words.push_back(
            fmt::format("your field of view is {:.1f}°, the scene's is {:.1f}°", fov, given->fov_y_deg));
        const double aspect = double(size.width) / size.height;
        if (std::abs(d.scale.y / aspect - 1) < 0.01 && size.width != size.height)
            words.back() += ": the angle is taken as the horizontal one";
    } else if (d.scale.x != 1) {
        words.push_back(fmt::format("scaled by {:.3f}", d.scale.x));
    }
    if (d.shift != glm::dvec2(0))
        words.push_back(
            fmt::format("shifted by {:.1f} pixels to the right and {:.1f} down", d.shift.x, d.shift.y));
    if (d.eye != glm::dvec3(0))
        words.push_back(fmt::format("your eye is {:.3g} to the right, {:.3g} up and {:.3g} back", d.eye.x,
                                    d.eye.y, d.eye.z));
    return fmt::format("{}", fmt::join(words, "; "));
}

}  // namespace glint
