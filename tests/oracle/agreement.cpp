#include "tests/oracle/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace glint::oracle {
namespace {

/// The triangle at each pixel: 0 for the background.
class TriangleMap {
  public:
    TriangleMap(Renderer& renderer, Scene scene, PictureSize size) : size_(size) {
        scene.lights.clear();  // so that explanations are cheap
        scene.shading.mode = ShadingMode::Facet;
        scene.shading.reflection = Reflection::Lambert;
        renderer.render(scene, size);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) ids_.push_back(id(renderer.explain(x, y)));
    }

    [[nodiscard]] std::uint64_t at(int x, int y) const {
        return ids_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                    static_cast<std::size_t>(x)];
    }
    /// Whether all pixels around (x, y), which must all exist, show the same as (x, y).
    [[nodiscard]] bool interior(int x, int y) const {
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                if (at(i, j) != at(x, y)) return false;
        return true;
    }

  private:
    static std::uint64_t id(const Explanation& e) {
        if (!e.hit) return 0;
        return ((static_cast<std::uint64_t>(e.object_index) << 48) | (std::uint64_t{e.face} << 16) |
                e.triangle) +
               1;
    }
    PictureSize size_;
    std::vector<std::uint64_t> ids_;
};

/// The allowed difference of a channel: the error of float arithmetic and of Mesa's pow (1.4e-5 for the
/// exponent 128). S of cook-torrance is not a power and may exceed 1; the bound is then that fraction of the
/// sum of the highlights at this pixel.
glm::dvec3 bound_of(const Scene& scene, const Explanation& e) {
    glm::dvec3 highlights(0), shown(0);
    for (const Light& light : scene.lights)
        if (light.enabled) highlights += glm::dvec3(e.material.specular * light.specular * light.intensity);
    if (e.reflection == Reflection::CookTorrance) {
        for (const ExplainedLight& light : e.at.lights) shown += glm::dvec3(light.specular);
        for (const ExplainedCorner& corner : e.corners)
            for (const ExplainedLight& light : corner.at.lights)
                shown += double{corner.weight} * glm::dvec3(light.specular);
    }
    return 2e-5 + 1.5e-5 * glm::max(highlights, shown);
}

/// One pixel in both pictures.
struct Pair {
    glm::dvec3 ours, theirs, bound;
    glm::ivec3 our_bytes, their_bytes;
    bool covered = false, theirs_covered = false;

    [[nodiscard]] double difference() const {
        double most = 0;
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(ours[c] - theirs[c]));
        return most;
    }
    /// Returns the difference divided by the bound; above 1 they disagree.
    [[nodiscard]] double share() const {
        if (covered != theirs_covered) return HUGE_VAL;
        double most = 0;
        for (int c = 0; c < 3; ++c) {
            const double d = std::abs(ours[c] - theirs[c]);
            most = std::max(most, std::isfinite(d) ? d / bound[c] : HUGE_VAL);
        }
        return most;
    }
    [[nodiscard]] int byte_difference() const {
        int most = 0;
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(our_bytes[c] - their_bytes[c]));
        return most;
    }
    [[nodiscard]] std::string text() const {
        return fmt::format(
            "({:.7f} {:.7f} {:.7f}) here, ({:.7f} {:.7f} {:.7f}) by OpenGL, {:.2f} of the bound", ours.x,
            ours.y, ours.z, theirs.x, theirs.y, theirs.z, share());
    }
};

}  // namespace

std::string Figure::text() const {
    const auto channels = 3 * static_cast<double>(std::max<std::size_t>(pixels, 1));
    return fmt::format(
        "oracle: {} scenes, {} of them with fixed function\n"
        "  {} surface pixels compared (and {} background pixels): largest difference {:.2e}, {:.0f} % of its "
        "bound at most, mean {:.2e}; {} of 255 in 8 bits\n"
        "  left out: {} within a pixel of an edge, {} with n.l = 0, {} with l = -v, {} on a cone's edge, "
        "{} with n.v = 0, {} cut by near and {} cut twice on the screen",
        scenes, by_fixed_function, pixels, background, largest, 100 * largest_share, sum / channels,
        largest_bytes, edges, left_out[1], left_out[2], left_out[3], left_out[4], left_out[5], left_out[6]);
}

void Comparison::add(const std::string& name, const Scene& scene, PictureSize size, Route route) {
    const Picture& ours = renderer_.render(scene, size, true);
    const TriangleMap triangles(faces_, scene, size);
    const auto draw = [&] { painter_.draw(scene, size, route); };
    const GlPicture<float> floats = canvas_.floats(size, draw);
    const GlPicture<std::uint8_t> bytes = canvas_.bytes(size, draw);
    double worst = 1;
    std::string disagreement;
    for (int y = 1; y + 1 < size.height; ++y) {
        for (int x = 1; x + 1 < size.width; ++x) {
            if (!triangles.interior(x, y)) {
                ++figure_.edges;
                continue;
            }
            const Explanation e = renderer_.explain(x, y);
            if (const LeftOut rule = e.hit ? left_out_at(scene, size, e) : LeftOut::None;
                rule != LeftOut::None) {
                ++figure_.left_out[static_cast<std::size_t>(rule)];
                continue;
            }
            const float* f = floats.at(x, y);
            const std::uint8_t *b = bytes.at(x, y), *o = &ours.rgba[4 * ours.pixel(x, y)];
            const Pair pair{ours.linear_at(x, y), {f[0], f[1], f[2]}, bound_of(scene, e),
                            {o[0], o[1], o[2]},   {b[0], b[1], b[2]}, e.hit,
                            f[3] > 0.5f};
            ++(e.hit ? figure_.pixels : figure_.background);
            for (int c = 0; c < 3; ++c) figure_.sum += std::abs(pair.ours[c] - pair.theirs[c]);
            figure_.largest = std::max(figure_.largest, pair.difference());
            figure_.largest_share = std::max(figure_.largest_share, pair.share());
            figure_.largest_bytes = std::max(figure_.largest_bytes, pair.byte_difference());
            if (pair.share() > worst || pair.byte_difference() > 1) {
                worst = std::max(worst, pair.share());
                disagreement = fmt::format("{}, pixel {},{}: {}", name, x, y, pair.text());
            }
        }
    }
    if (!disagreement.empty()) figure_.disagreements.push_back(disagreement);
    ++figure_.scenes;
    figure_.by_fixed_function += route == Route::FixedFunction;
}

}  // namespace glint::oracle
