#include "renderer/inspect/reflectance/light_needs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/inspect/light_alone.h"
#include "renderer/lighting/shade_point.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

using Vec = Vec3<float>;
constexpr float step = 0.1f;                             // of a distance
constexpr float turn = std::numbers::pi_v<float> / 180;  // one degree

std::array<Vec, 2> across(Vec a) {
    const Vec first = any_perpendicular(a);
    return {first, cross(a, first)};
}

Scene with_white_light(const Scene& scene, const Light& light) {
    Scene s = alone(scene, white(light));
    s.shading.terms.diffuse = s.shading.terms.specular = true;
    return s;
}

struct TwoTerms {
    Vec diffuse, specular;
};

/// The light's terms wherever the point, the viewer and the normal are put.
class LitPoint {
  public:
    LitPoint(const Scene& alone, PictureSize size, const Material& material)
        : sources_(light_sources(alone)), job_(light_job(alone, size, material, sources_, false)) {}

    [[nodiscard]] PointAt<float> seen(Vec place, Vec normal) const {
        return seen_from_eye(job_, place, normal);
    }
    [[nodiscard]] TwoTerms terms(const PointAt<float>& at) const {
        TwoTerms sum;
        for (const LightSource& source : sources_) {
            const LightTerms<float> t = of(source, at);
            sum.diffuse = sum.diffuse + t.diffuse;
            sum.specular = sum.specular + t.specular;
        }
        return sum;
    }
    [[nodiscard]] LightTerms<float> middle(const PointAt<float>& at) const {
        return of(sources_[sources_.size() / 2], at);
    }

  private:
    [[nodiscard]] LightTerms<float> of(const LightSource& source, const PointAt<float>& at) const {
        return illuminate(equation_of(job_), light_at<float>(source), material_at<float>(job_.material), at);
    }
    std::vector<LightSource> sources_;
    LightJob job_;
};

float largest(Vec a, Vec b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace

LightNeeds light_needs(const Scene& scene, PictureSize size, const Light& light, const Material& material,
                       glm::vec3 place, glm::vec3 normal) {
    const LitPoint lit(with_white_light(scene, light), size, material);
    const Vec p = to_vec(place), n = to_vec(normal);
    const PointAt<float> at = lit.seen(p, n);
    const TwoTerms now = lit.terms(at);
    const LightTerms<float> middle = lit.middle(at);
    LightNeeds needs;
    needs.falloff = middle.falloff;
    needs.spot = middle.spot;
    const auto note = [&](float Moved::*what, const PointAt<float>& then_at) {
        const TwoTerms then = lit.terms(then_at);
        needs.diffuse.*what = std::max(needs.diffuse.*what, largest(then.diffuse, now.diffuse));
        needs.specular.*what = std::max(needs.specular.*what, largest(then.specular, now.specular));
    };
    // Of a directional light the distance says nothing; that of the eye is as good as any.
    const bool has_place = light.kind != LightKind::Directional;
    const float eye = square_root(dot(p, p)), away = step * (has_place ? middle.distance : eye);
    const Vec l = middle.directions.l;
    for (const Vec way : {l, -1.0f * l, across(l)[0], across(l)[1]})
        note(&Moved::light, PointAt<float>(p + away * way, n, at.v));
    for (const Vec way : across(unit(p)))
        note(&Moved::viewer, PointAt<float>(p, n, lit.seen(p + step * eye * way, n).v));
    for (const Vec way : across(n))
        note(&Moved::surface, PointAt<float>(p, unit(std::cos(turn) * n + std::sin(turn) * way), at.v));
    return needs;
}

}  // namespace glint
