#include "tests/programs/same_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "tests/oracle/left_out.h"

namespace glint::programs {
namespace {

/// A picture's surfaces, used to exclude pixels at edges.
class Surfaces {
  public:
    Surfaces(Renderer& renderer, const Scene& scene, PictureSize size) : scene_(scene), size_(size) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) all_.push_back(renderer.explain(x, y));
    }
    [[nodiscard]] const Explanation& at(int x, int y) const { return all_[size_.index(x, y)]; }

    /// Whether no neighbour of (x, y) may become visible or hidden by rounding. All its neighbours must
    /// exist.
    [[nodiscard]] bool interior(int x, int y) const {
        const Explanation& e = at(x, y);
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i) {
                const Explanation& n = at(i, j);
                if (n.hit != e.hit || n.object_index != e.object_index) return false;
                const double z = e.at.point.camera.z, other = n.at.point.camera.z;
                if (e.hit && (n.front_facing != e.front_facing || std::abs(other - z) > 0.05 * std::abs(z)))
                    return false;
            }
        return !e.hit || edge_distance(e) > 1 / 32.0;
    }

  private:
    /// The distance from the pixel's centre to the nearest edge of its triangle, in pixels; 0 if the triangle
    /// reaches behind the eye.
    [[nodiscard]] double edge_distance(const Explanation& e) const {
        const Object& object = scene_.objects[static_cast<std::size_t>(e.object_index)];
        const glm::dmat4 clip_from_object = clip_from_view(scene_.camera.projection, size_) *
                                            view_from_world(scene_.camera) *
                                            world_from_object(object.transform);
        std::array<glm::dvec2, 3> corner;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec4 c =
                clip_from_object * glm::dvec4(glm::dvec3(object.mesh->positions[e.corner[i]]), 1);
            if (c.w <= 0) return 0;
            corner[i] = {(c.x / c.w + 1) / 2 * size_.width, (1 - c.y / c.w) / 2 * size_.height};
        }
        const glm::dvec2 middle(e.x + 0.5, e.y + 0.5);
        double nearest = HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 along = corner[(i + 1) % 3] - corner[i], to = middle - corner[i];
            nearest = std::min(nearest, std::abs(along.x * to.y - along.y * to.x) / glm::length(along));
        }
        return nearest;
    }

    const Scene& scene_;
    PictureSize size_;
    std::vector<Explanation> all_;
};

double highlights_of(const ExplainedPoint& at) {
    double sum = 0;
    for (const ExplainedLight& light : at.lights)
        sum += static_cast<double>(std::max({light.specular.x, light.specular.y, light.specular.z}));
    return sum;
}

/// The tolerance for rounding of floats: 1e-5, relative for values above 1. A highlight raises a cosine,
/// which is accurate to about 1e-7, to the power of its shininess, which multiplies the error.
double bound_of(const Explanation& e, const glm::vec3& ours) {
    const double brightest = std::max({ours.x, ours.y, ours.z});
    double highlights = e.lit_per_corner ? 0 : highlights_of(e.at);
    for (const ExplainedCorner& corner : e.corners)
        highlights = std::max(highlights, highlights_of(corner.at));
    return 1e-5 * std::max(1.0, brightest) + 2e-7 * static_cast<double>(e.material.shininess) * highlights;
}

}  // namespace

void Comparison::add(const std::string& name, const Scene& scene, PictureSize size, Language language) {
    ++figure_.scenes;
    const Drawn drawn = build_and_run({scene, size, name}, language);
    text_ = drawn.text;
    if (!drawn.failure.empty()) {
        figure_.disagreements.push_back(name + ": " + drawn.failure);
        return;
    }
    const Picture ours = renderer_.render(scene, size, true);
    const Surfaces surfaces(renderer_, scene, size);
    std::string worst;
    double most = 0;
    for (int y = 1; y + 1 < size.height; ++y) {
        for (int x = 1; x + 1 < size.width; ++x) {
            const Explanation& e = surfaces.at(x, y);
            if (!surfaces.interior(x, y)) continue;
            if (e.hit && oracle::left_out_by_lighting(scene, e) != oracle::LeftOut::None) continue;
            const std::size_t at = ours.pixel(x, y);
            const glm::vec3 linear = scene.display.exposure * ours.linear_at(x, y);
            double share = 0;
            int bytes = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                bytes = std::max(bytes, std::abs(drawn.bytes[3 * at + c] - ours.rgba[4 * at + c]));
                if (drawn.linear.empty()) continue;
                const float our = linear[static_cast<int>(c)], their = drawn.linear[3 * at + c];
                if (std::isnan(our) && std::isnan(their)) continue;
                const double d = std::abs(static_cast<double>(our) - static_cast<double>(their));
                share = std::max(share, std::isfinite(d) ? d / bound_of(e, linear) : HUGE_VAL);
            }
            ++figure_.pixels;
            figure_.surfaces += e.hit;
            figure_.largest = std::max(figure_.largest, share);
            figure_.largest_bytes = std::max(figure_.largest_bytes, bytes);
            const double wrong = std::max(share, bytes > 1 ? bytes : 0.0);
            if (wrong <= std::max(most, 1.0)) continue;
            most = wrong;
            worst = fmt::format("{} ({}), pixel {},{}: {} levels, {:.3g} of the bound, ours {} {} {}", name,
                                static_cast<int>(language), x, y, bytes, share, linear.x, linear.y, linear.z);
        }
    }
    if (!worst.empty()) figure_.disagreements.push_back(worst);
}

}  // namespace glint::programs
