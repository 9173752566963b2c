#include "renderer/debug_views/debug_view.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include "models/memory_limit.h"
#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "renderer/explain/equation_text.h"
#include "renderer/reflectance/lobes.h"

namespace glint {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb background{38, 38, 40};

template <class PixelWork> void for_pixels(PictureSize size, const PixelWork& work) {
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) work(size.index(x, y), x, y);
    });
}

/// The unit direction to the eye in camera coordinates.
glm::vec3 towards_eye(const SeenPoint& seen, bool parallel) {
    return parallel ? glm::vec3(0, 0, 1) : -glm::normalize(seen.position);
}

void put(Picture& picture, std::size_t pixel, Rgb color) {
    std::copy(color.begin(), color.end(), picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel));
    picture.rgba[4 * pixel + 3] = 255;
}

}  // namespace

DebugViewPainter::DebugViewPainter(int threads)
    : renderer_(std::make_unique<Renderer>(threads)), facets_(std::make_unique<Renderer>(threads)) {}

void DebugViewPainter::measure_normals(const Scene& scene, PictureSize size) {
    const Picture& drawn = renderer_->render(normal_scene(scene, false), size, true);
    normals_.resize(size.pixels());
    facing_.resize(size.pixels());
    const bool parallel = is_orthographic(scene.camera.projection);
    for_pixels(size, [&](std::size_t i, int x, int y) {
        const auto seen = renderer_->seen_at(x, y);
        normals_[i] = seen ? drawn.linear_at(x, y) : glm::vec3(none);
        facing_[i] = seen ? glm::dot(normals_[i], towards_eye(*seen, parallel)) : none;
        if (!seen) return put(picture_, i, background);
        const Rgb color = normal_color(normals_[i]);
        put(picture_, i, facing_[i] < 0 ? turned_away_color(color, x, y) : color);
    });
}

void DebugViewPainter::paint_sides(const Scene& scene, const Renderer& drawn_by, PictureSize size) {
    sides_.assign(size.pixels(), Side::None);
    const bool parallel = is_orthographic(scene.camera.projection);
    for_pixels(size, [&](std::size_t i, int x, int y) {
        const auto seen = drawn_by.seen_at(x, y);
        if (!seen) return put(picture_, i, background);
        sides_[i] = seen->front ? Side::Front : Side::Back;
        put(picture_, i,
            side_color(seen->front, double(glm::dot(seen->normal, towards_eye(*seen, parallel)))));
    });
}

void DebugViewPainter::measure_angles(const Scene& scene, PictureSize size) {
    const Picture& smooth = renderer_->render(normal_scene(scene, false), size, true);
    const Picture& facet = facets_->render(normal_scene(scene, true), size, true);
    for_pixels(size, [&](std::size_t i, int x, int y) {
        if (renderer_->object_at(x, y) < 0) return;
        const glm::dvec3 a = smooth.linear_at(x, y), b = facet.linear_at(x, y);
        // Uses the half angle, whose sine is precise for small angles.
        values_[i] = static_cast<float>(2 * std::atan2(glm::length(a - b), glm::length(a + b)) * 180 /
                                        std::numbers::pi);
    });
}

void DebugViewPainter::measure_n_dot_l(const Scene& scene, int light, PictureSize size) {
    if (scene.lights.empty()) return;
    light = std::clamp(light, 0, static_cast<int>(scene.lights.size()) - 1);
    const Picture& drawn = renderer_->render(n_dot_l_scene(scene, light), size, true);
    for_pixels(size, [&](std::size_t i, int x, int y) {
        if (renderer_->object_at(x, y) >= 0) values_[i] = drawn.linear_at(x, y).x;
    });
}

void DebugViewPainter::measure_depths(const Renderer& drawn_by, PictureSize size) {
    for_pixels(size, [&](std::size_t i, int x, int y) {
        const float depth = drawn_by.depth_at(x, y);
        if (depth > 0) values_[i] = depth;
    });
}

void DebugViewPainter::paint_faces(const Scene& scene, const Renderer& drawn_by, PictureSize size) {
    names_.clear();
    for (const Object& object : scene.objects) names_.push_back(object.name);
    constexpr std::uint64_t no_face = std::numeric_limits<std::uint64_t>::max();
    faces_.assign(size.pixels(), no_face);
    for_pixels(size, [&](std::size_t i, int x, int y) {
        const auto seen = drawn_by.seen_at(x, y);
        if (seen) faces_[i] = (static_cast<std::uint64_t>(seen->object) << 32) | seen->face;
        put(picture_, i,
            seen ? face_color(seen->face + 7919u * static_cast<unsigned>(seen->object)) : background);
    });
}

void DebugViewPainter::color_values() {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (const float v : values_) {  // comparisons with NaN are false
        if (v < low) low = v;
        if (v > high) high = v;
    }
    const bool any = low <= high;
    scale_.has_bar = true;
    if (view_ == DebugView::NDotL) scale_ = {true, -1, 1, "n·l"};
    if (view_ == DebugView::Depth)
        scale_ = {true, any ? low : 0, any && high > low ? high : low + 1, "depth"};
    if (view_ == DebugView::FacetAngle) scale_ = {true, 0, any ? std::max(high, 1.0f) : 1, "degrees"};
    if (!any && view_ == DebugView::Depth) scale_ = {true, 0, 1, "depth"};
    for_pixels(picture_.size, [&](std::size_t i, int, int) {
        put(picture_, i, std::isnan(values_[i]) ? background : debug_view_color(view_, scale_, values_[i]));
    });
}

const Picture& DebugViewPainter::paint(DebugViewChoice choice, const Scene& scene, const Renderer& drawn_by,
                                       PictureSize size) {
    view_ = choice.view;
    scale_ = {};
    terms_ = nullptr;
    picture_.size = size;
    picture_.rgba.resize(4 * size.pixels());
    values_.assign(size.pixels(), none);
    switch (choice.view) {
    case DebugView::Normal:
        measure_normals(scene, size);
        return picture_;
    case DebugView::Orientation:
        paint_sides(scene, drawn_by, size);
        return picture_;
    case DebugView::Face:
        paint_faces(scene, drawn_by, size);
        return picture_;
    case DebugView::NDotL:
        measure_n_dot_l(scene, choice.light, size);
        break;
    case DebugView::Depth:
        measure_depths(drawn_by, size);
        break;
    case DebugView::FacetAngle:
        measure_angles(scene, size);
        break;
    case DebugView::Picture:
        terms_ = &renderer_->render(scene, size, true);
        return *terms_;
    case DebugView::Silhouette:
        terms_ = &renderer_->render(silhouette_scene(scene), size, true);
        return *terms_;
    case DebugView::Emission:
    case DebugView::Ambient:
    case DebugView::Diffuse:
    case DebugView::Specular:
        terms_ = &renderer_->render(term_scene(scene, choice.view), size, true);
        return *terms_;
    }
    color_values();
    return picture_;
}

float DebugViewPainter::value_at(int x, int y) const {
    return values_.empty() ? none : values_[picture_.pixel(x, y)];
}

std::string DebugViewPainter::value_text(int x, int y) const {
    const std::size_t i = picture_.pixel(x, y);
    if (terms_ != nullptr) {
        const glm::vec3 c = terms_->linear_at(x, y);
        const auto text = [](float part) { return significant_text(double(part), 3); };
        return fmt::format("{} {} {}", text(c.x), text(c.y), text(c.z));
    }
    if (view_ == DebugView::Normal) {
        const glm::vec3 n = normals_[i];
        if (std::isnan(n.x)) return "background";
        const auto part = [](float v) { return std::abs(v) < 0.0005f ? 0 : v; };  // removes the sign of zero
        return fmt::format("{:+.3f} {:+.3f} {:+.3f}{}", part(n.x), part(n.y), part(n.z),
                           facing_[i] < 0 ? " away" : "");
    }
    if (view_ == DebugView::Orientation)
        return sides_[i] == Side::None ? "background" : sides_[i] == Side::Front ? "front" : "back";
    if (view_ == DebugView::Face) {
        const std::size_t object = faces_[i] >> 32;
        if (object >= names_.size()) return "background";
        return fmt::format("{}, face {}", names_[object], faces_[i] & 0xFFFFFFFFu);
    }
    if (std::isnan(values_[i])) return "background";
    return view_ == DebugView::FacetAngle ? fmt::format("{:.2f}°", values_[i])
                                          : significant_text(double(values_[i]), 3);
}

std::uint64_t stripe_over_range(Picture& picture, float exposure) {
    std::uint64_t count = 0;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            const glm::vec3 c = picture.linear_at(x, y) * exposure;
            if (!(std::max({c.x, c.y, c.z}) > 1)) continue;
            ++count;
            if ((x + y) % 8 < 3) put(picture, picture.pixel(x, y), {0, 0, 0});
        }
    return count;
}

// The colour scales of debug views.

namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb bytes(glm::dvec3 color) {
    const glm::dvec3 c = glm::clamp(color, 0.0, 1.0) * 255.0 + 0.5;
    return {static_cast<std::uint8_t>(c.x), static_cast<std::uint8_t>(c.y), static_cast<std::uint8_t>(c.z)};
}

/// Interpolates evenly spaced colours at a parameter from 0 to 1.
template <std::size_t N> glm::dvec3 between(const std::array<glm::dvec3, N>& stops, double at) {
    const double scaled = std::clamp(at, 0.0, 1.0) * (N - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(scaled), N - 2);
    return glm::mix(stops[i], stops[i + 1], scaled - static_cast<double>(i));
}

/// Lightness increases evenly, so the scale also works in greyscale.
const std::array<glm::dvec3, 5> dark_to_light{glm::dvec3(0.06, 0.04, 0.26), glm::dvec3(0.16, 0.26, 0.58),
                                              glm::dvec3(0.12, 0.53, 0.60), glm::dvec3(0.53, 0.78, 0.37),
                                              glm::dvec3(1.00, 0.95, 0.60)};
/// Lit: black, orange, white. Facing away: blues, so that the discontinuity at 0 shows the terminator.
const std::array<glm::dvec3, 3> lit_ramp{glm::dvec3(0.07, 0.04, 0.02), glm::dvec3(0.88, 0.47, 0.10),
                                         glm::dvec3(1, 1, 0.92)};
const std::array<glm::dvec3, 2> unlit_ramp{glm::dvec3(0.10, 0.15, 0.32), glm::dvec3(0.35, 0.62, 1)};

/// Blue and red, as in modelling software.
const glm::dvec3 front_side(0.22, 0.42, 0.95), back_side(0.93, 0.22, 0.20);

}  // namespace

Rgb debug_view_color(DebugView view, const DebugViewScale& scale, double value) {
    if (view == DebugView::NDotL)
        return bytes(value < 0 ? between(unlit_ramp, -value) : between(lit_ramp, value));
    const double share = (value - scale.low) / (scale.high - scale.low);
    // Shows near surfaces in light colours.
    return bytes(between(dark_to_light, view == DebugView::Depth ? 1 - share : share));
}

Rgb normal_color(glm::vec3 normal) { return bytes(glm::dvec3(normal) * 0.5 + 0.5); }

Rgb face_color(std::uint64_t number) {
    const double hue = 6 * std::fmod(static_cast<double>(number) * std::numbers::phi, 1.0);
    const double light = number % 2 == 0 ? 0.92 : 0.66;
    const auto channel = [&](double shift) {
        const double away = std::abs(std::fmod(hue + shift, 6.0) - 3);
        return light * (0.35 + 0.65 * std::clamp(away - 1, 0.0, 1.0));
    };
    return bytes({channel(0), channel(4), channel(2)});
}

Rgb side_color(bool front, double n_dot_v) {
    const double light = 0.55 + 0.45 * std::clamp(std::abs(n_dot_v), 0.0, 1.0);
    return bytes(light * (front ? front_side : back_side));
}

Rgb turned_away_color(Rgb color, int x, int y) {
    if ((x + y) % 8 >= 3) return color;
    return {static_cast<std::uint8_t>(color[0] / 3), static_cast<std::uint8_t>(color[1] / 3),
            static_cast<std::uint8_t>(color[2] / 3)};
}

// Scenes whose pictures measure a quantity.

namespace {

/// Switches off the mistakes for which keep(mistake) is false.
template <class Keep> void keep_mistakes(Mistakes& mistakes, const Keep& keep) {
    for (const MistakeName& m : mistake_names()) mistakes.*m.flag &= keep(m);
}

/// Whether a mistake affects normals or the position of a light.
bool shows_in_measures(const MistakeName& m) {
    const bool reach = m.seen_as == SeenAs::WrongReach || m.seen_as == SeenAs::WrongBrightness;
    return m.stage == MistakeStage::Normals || m.stage == MistakeStage::Viewer ||
           (m.stage == MistakeStage::Lights && !reach);
}

/// A white surface under Lambert's law without clamping, with nothing else in the picture.
Scene measuring_scene(const Scene& scene) {
    Scene s = scene;
    s.lights.clear();
    s.global_ambient = glm::vec3(0);
    s.npr = {};
    s.display = {};
    s.display.background = glm::vec3(0);
    s.shading.reflection = Reflection::Lambert;
    s.shading.rules = Rules::Lecture;
    s.shading.terms = {false, false, true, false};
    keep_mistakes(s.shading.mistakes, [](const MistakeName& m) { return shows_in_measures(m); });
    s.shading.mistakes.no_clamp_of_cosine = true;
    s.shading.mistakes.lit_after_projection = false;
    for (Object& object : s.objects) {
        object.material = {};
        object.material.diffuse = glm::vec3(1);
    }
    return s;
}

Light sun_along(glm::vec3 axis) {
    Light sun;
    sun.kind = LightKind::Directional;
    sun.space = LightSpace::Camera;
    sun.position = {axis, 0};
    sun.diffuse = axis;
    return sun;
}

}  // namespace

Scene normal_scene(const Scene& scene, bool facet) {
    Scene s = measuring_scene(scene);
    s.shading.mode = facet ? ShadingMode::Facet : ShadingMode::Phong;
    keep_mistakes(s.shading.mistakes, [](const MistakeName& m) { return m.stage != MistakeStage::Lights; });
    // Cook-Torrance also has Lambert's diffuse term, but its light contributions are not rounded
    // (renderer/lighting/surface_point.h).
    s.shading.reflection = Reflection::CookTorrance;
    s.lights = {sun_along({1, 0, 0}), sun_along({0, 1, 0}), sun_along({0, 0, 1})};
    return s;
}

Scene n_dot_l_scene(const Scene& scene, int light) {
    Scene s = measuring_scene(scene);
    Light l = white(scene.lights[static_cast<std::size_t>(light)]);
    if (l.kind != LightKind::Directional) l.kind = LightKind::Point;
    l.falloff = {};
    s.lights = {l};
    return s;
}

Scene silhouette_scene(const Scene& scene) {
    Scene s = scene;
    s.npr.silhouettes = true;
    s.npr.creases = false;
    s.npr.stroke_width_px = 2;
    s.npr.stroke = {1, 0.25f, 0.6f};  // a hue that is rare among materials
    return s;
}

Scene term_scene(const Scene& scene, DebugView term) {
    Scene s = scene;
    s.shading.terms = {term == DebugView::Emission, term == DebugView::Ambient, term == DebugView::Diffuse,
                       term == DebugView::Specular};
    return s;
}

namespace {

using OfPixel = std::function<glm::vec3(const Explanation&)>;
using OfPoint = std::function<glm::vec3(const ExplainedPoint&)>;
using OfLight = glm::vec3 (*)(const ExplainedLight&);

struct Buffer {
    std::string name;
    OfPixel value;
    bool of_background = false;  // false: computed only for pixels that show a surface
};

/// Returns the function that blends `value` over the lit points of a pixel.
OfPixel of_lit_points(const OfPoint& value) {
    return [value](const Explanation& e) {
        if (!e.lit_per_corner) return value(e.at);
        glm::vec3 blended(0);
        for (const ExplainedCorner& corner : e.corners) blended += corner.weight * value(corner.at);
        return blended;
    };
}

OfPixel of_light(int index, OfLight value) {
    return of_lit_points([index, value](const ExplainedPoint& at) {
        const auto light = std::lower_bound(at.lights.begin(), at.lights.end(), index,
                                            [](const ExplainedLight& l, int i) { return l.index < i; });
        return light != at.lights.end() && light->index == index ? value(*light) : glm::vec3(0);
    });
}

OfPixel of_all_lights(OfLight value) {
    return of_lit_points([value](const ExplainedPoint& at) {
        glm::vec3 sum(0);
        for (const ExplainedLight& light : at.lights) sum += value(light);
        return sum;
    });
}

glm::vec3 ambient_of(const ExplainedLight& light) { return light.ambient; }
glm::vec3 diffuse_of(const ExplainedLight& light) { return light.diffuse; }
glm::vec3 specular_of(const ExplainedLight& light) { return light.specular; }

void add_geometry(std::vector<Buffer>& all) {
    all.push_back({"face", [](const Explanation& e) {
                       return glm::vec3(1, static_cast<float>(e.object_index), static_cast<float>(e.face));
                   }});
    all.push_back({"position", [](const Explanation& e) { return e.at.point.camera; }});
    all.push_back({"depth", [](const Explanation& e) { return glm::vec3(-e.at.point.camera.z); }});
    all.push_back({"normal", [](const Explanation& e) { return e.at.normal.camera; }});
    all.push_back({"side", [](const Explanation& e) { return glm::vec3(e.front_facing ? 1 : -1); }});
}

template <class Add> void for_each_enabled(const Scene& scene, const Add& add) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled) add(scene.lights[i], static_cast<int>(i), fmt::format("_{}", i));
}

// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks): the analyzer does not see that a std::function inside
// another one frees its memory.
void add_directions(std::vector<Buffer>& all, const Scene& scene) {
    all.push_back({"view", of_lit_points([](const ExplainedPoint& at) { return at.view.camera; })});
    for_each_enabled(scene, [&all](const Light& light, int i, const std::string& number) {
        if (light.kind == LightKind::Area) return;
        all.push_back({"l" + number, of_light(i, [](const ExplainedLight& e) { return e.l.camera; })});
        all.push_back(
            {"n_dot_l" + number, of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.n_dot_l); })});
        if (light.kind != LightKind::Directional) {
            all.push_back({"distance" + number,
                           of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.distance); })});
            all.push_back({"falloff" + number,
                           of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.falloff); })});
        }
        if (light.kind == LightKind::Spot)
            all.push_back(
                {"cone" + number, of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.spot); })});
        all.push_back({"r" + number, of_light(i, [](const ExplainedLight& e) { return e.r.camera; })});
        all.push_back({"h" + number, of_light(i, [](const ExplainedLight& e) { return e.h.camera; })});
    });
}

void add_terms(std::vector<Buffer>& all, const Scene& scene) {
    all.push_back({"emission", of_lit_points([](const ExplainedPoint& at) { return at.emission; })});
    all.push_back(
        {"global_ambient", of_lit_points([](const ExplainedPoint& at) { return at.global_ambient; })});
    if (scene.transport.model == TransportModel::Bounces)
        all.push_back({"bounced", of_lit_points([](const ExplainedPoint& at) { return at.bounces.term; })});
    for_each_enabled(scene, [&all](const Light&, int i, const std::string& number) {
        all.push_back({"ambient" + number, of_light(i, ambient_of)});
        all.push_back({"diffuse" + number, of_light(i, diffuse_of)});
        all.push_back({"specular" + number, of_light(i, specular_of)});
    });
    all.push_back({"ambient", of_all_lights(ambient_of)});
    all.push_back({"diffuse", of_all_lights(diffuse_of)});
    all.push_back({"specular", of_all_lights(specular_of)});
    all.push_back({"sum", [](const Explanation& e) { return e.sum; }, true});
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

std::vector<Buffer> all_buffers(const Scene& scene) {
    std::vector<Buffer> all;
    add_geometry(all);
    add_directions(all, scene);
    add_terms(all, scene);
    return all;
}

}  // namespace

std::vector<std::string> buffer_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Buffer& buffer : all_buffers(scene)) names.push_back(buffer.name);
    return names;
}

std::size_t buffers_at_once(PictureSize size, std::size_t all) {
    constexpr std::uint64_t fewest = 12, most_times = 8, room = std::uint64_t{64} << 20;
    return std::max({fewest, room / buffers_memory(size, 1), (all + most_times - 1) / most_times});
}

std::uint64_t buffers_memory(PictureSize size, std::size_t buffers) {
    return std::uint64_t{buffers} * 3 * sizeof(float) * size.pixels();
}

std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                                       const std::vector<std::string>& names) {
    std::vector<Buffer> wanted = all_buffers(scene);
    const std::set<std::string_view> named(names.begin(), names.end());
    std::erase_if(wanted, [&named](const Buffer& b) { return named.count(b.name) == 0; });
    std::vector<PixelBuffer> buffers;
    buffers.reserve(wanted.size());
    for (const Buffer& b : wanted)
        buffers.push_back({b.name, {size, {}, std::vector(3 * size.pixels(), 0.0f)}});
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const Explanation e = renderer.explain(x, y);
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                if (!e.hit && !wanted[i].of_background) continue;
                const glm::vec3 value = wanted[i].value(e);
                float* to = &buffers[i].picture.linear[3 * buffers[i].picture.pixel(x, y)];
                for (int c = 0; c < 3; ++c) to[c] = value[c];
            }
        }
    });
    return buffers;
}

void visit_pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                         const std::vector<std::string>& names,
                         const std::function<bool(const PixelBuffer&)>& visit) {
    const std::size_t at_once = std::min(buffers_at_once(size, names.size()), names.size());
    if (const auto problem = too_much_memory({.picture = buffers_memory(size, at_once)}))
        throw LimitExceeded(*problem);
    for (std::size_t from = 0; from < names.size(); from += at_once) {
        const auto first = names.begin() + static_cast<std::ptrdiff_t>(from);
        const std::vector<std::string> some(
            first, first + static_cast<std::ptrdiff_t>(std::min(at_once, names.size() - from)));
        for (const PixelBuffer& buffer : pixel_buffers(renderer, scene, size, some))
            if (!visit(buffer)) return;
    }
}

}  // namespace glint
