#include "renderer/reflectance/lobes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "models/scene/reflection.h"
#include "renderer/lighting/illuminate.h"
#include "renderer/lighting/reflection.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"
#include "renderer/simd/glm_vec3.h"

namespace glint {
namespace {

using Vec = Vec3<float>;
using std::numbers::pi;

/// The integral of value(d) over the directions d within horizon(side) radians of `axis`, by the midpoint
/// rule. Samples are dense near the axis, for smooth surfaces, and near the horizon, where the lobe of a
/// grazing light is steep. In each half-plane of axis and `side` the samples end exactly at the horizon.
glm::dvec3 around_axis(glm::dvec3 axis, const std::function<double(glm::dvec3 side)>& horizon,
                       const std::function<glm::dvec3(glm::dvec3 d)>& value) {
    constexpr int around = 256, outward = 256;
    const glm::dvec3 across(0, 1, 0), along = glm::cross(across, axis);
    glm::dvec3 sum(0);
    for (int i = 0; i < around; ++i) {
        const double azimuth = 2 * pi * (i + 0.5) / around;
        const glm::dvec3 side = std::cos(azimuth) * along + std::sin(azimuth) * across;
        const double end = horizon(side);
        for (int j = 0; j < outward; ++j) {
            const double t = (j + 0.5) / outward, polar = end * t * t * t * (4 - 3 * t);
            const glm::dvec3 d = std::cos(polar) * axis + std::sin(polar) * side;
            sum += value(d) * (std::sin(polar) * end * 12 * t * t * (1 - t));
        }
    }
    return sum * (2 * pi / (around * outward));
}

/// The integral of value(v) n.v over the hemisphere of v. A lobe is narrower across the plane of incidence
/// than along it, especially for a low light, but the distribution of its half vectors about n is circular.
glm::dvec3 over_hemisphere(const Reflector& reflector, double light_deg,
                           const std::function<glm::dvec3(glm::vec3 v)>& value) {
    const ReflectionInfo& model = info_of(reflector.reflection);
    if (model.uses_h) {
        const glm::dvec3 l = glm::normalize(glm::dvec3(in_plane(-light_deg)));
        // v = 2 (l.h) h - l, and n.v = l.z cos(2 polar) + l.side sin(2 polar) reaches 0 at this angle:
        const auto horizon = [&](glm::dvec3 side) { return std::atan2(l.z, -glm::dot(l, side)) / 2; };
        return around_axis({0, 0, 1}, horizon, [&](glm::dvec3 h) {
            const double l_dot_h = glm::dot(l, h);
            const glm::dvec3 v = 2 * l_dot_h * h - l;
            return value(glm::vec3(v)) * (v.z * 4 * l_dot_h);  // dv = 4 l.h dh
        });
    }
    const bool back = model.peak == HighlightPeak::Light;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(in_plane(back ? -light_deg : light_deg)));
    // n.v = axis.z cos(polar) + side.z sin(polar) reaches 0 at this angle:
    const auto horizon = [&](glm::dvec3 side) { return std::atan2(side.z, axis.z) + pi / 2; };
    return around_axis(axis, horizon, [&](glm::dvec3 v) { return value(glm::vec3(v)) * v.z; });
}

/// A random direction with n.v in [0.05, 1] and any azimuth.
glm::vec3 direction_above(std::mt19937& random) {
    const double z = 0.05 + 0.95 * uniform(random), azimuth = 2 * pi * uniform(random);
    const double s = std::sqrt(1 - z * z);
    return {s * std::cos(azimuth), s * std::sin(azimuth), z};
}

}  // namespace

Reflected reflected(const Reflector& reflector, glm::vec3 l, glm::vec3 v) {
    LightAt<float> white;
    white.xyz = to_vec(l);
    white.ambient = white.diffuse = white.specular = {1, 1, 1};
    const LightTerms<float> t =
        illuminate({reflector.reflection, reflector.terms, nullptr}, white,
                   material_at<float>(surface_material(reflector.material)), {{}, {0, 0, 1}, to_vec(v)});
    return {to_glm(t.ambient), to_glm(t.diffuse), to_glm(t.specular)};
}

glm::vec3 brdf(const Reflector& reflector, glm::vec3 l, glm::vec3 v) {
    if (!(l.z > 0) || !(v.z > 0)) return glm::vec3(0);
    const Reflected r = reflected(reflector, l, v);
    return (r.diffuse + r.specular) / (static_cast<float>(pi) * l.z);
}

glm::vec3 in_plane(double deg) {
    const double angle = deg * pi / 180;
    return {std::sin(angle), 0, std::cos(angle)};
}

std::vector<LobeSample> lobe_slice(const Reflector& reflector, double light_deg, int steps) {
    const glm::vec3 l = in_plane(-light_deg);
    std::vector<LobeSample> slice;
    for (int i = 0; i <= steps; ++i) {
        const double view_deg = -90 + 180.0 * i / steps;
        const glm::vec3 v = in_plane(view_deg);
        slice.push_back({view_deg, reflected(reflector, l, v), brdf(reflector, l, v)});
    }
    return slice;
}

glm::dvec3 specular_energy(const Reflector& reflector, double light_deg) {
    const glm::vec3 l = in_plane(-light_deg);
    return over_hemisphere(reflector, light_deg,
                           [&](glm::vec3 v) { return glm::dvec3(reflected(reflector, l, v).specular); });
}

glm::dvec3 directional_albedo(const Reflector& reflector, double light_deg) {
    const glm::vec3 l = in_plane(-light_deg);
    return over_hemisphere(reflector, light_deg,
                           [&](glm::vec3 v) { return glm::dvec3(brdf(reflector, l, v)); });
}

double reciprocity_error(const Reflector& reflector) {
    std::mt19937 random(1);
    double worst = 0;
    for (int i = 0; i < 4096; ++i) {
        const glm::vec3 l = direction_above(random), v = direction_above(random);
        const glm::dvec3 there = brdf(reflector, l, v), back = brdf(reflector, v, l);
        for (int c = 0; c < 3; ++c) {
            const double larger_one = std::max(there[c], back[c]);
            if (larger_one > 1e-12) worst = std::max(worst, std::abs(there[c] - back[c]) / larger_one);
        }
    }
    return worst;
}

std::string lobe_csv(const std::vector<LobeSample>& slice) {
    std::string csv = "view_deg";
    for (const char* term : {"ambient", "diffuse", "specular", "intensity", "brdf"})
        csv += fmt::format(",{0}_r,{0}_g,{0}_b", term);
    csv += '\n';
    for (const LobeSample& s : slice) {
        csv += fmt::format("{}", s.view_deg);
        for (const glm::vec3& term : {s.reflected.ambient, s.reflected.diffuse, s.reflected.specular,
                                      s.reflected.intensity(), s.brdf})
            csv += fmt::format(",{},{},{}", term.x, term.y, term.z);
        csv += '\n';
    }
    return csv;
}

namespace {

constexpr int bins = 18;
constexpr double bin_deg = 90.0 / bins;

/// The fraction of facets, projected along n, whose normals are within an interval of polar angles.
double share_of_facets(double alpha, double polar, double polar_step, double azimuth_step) {
    const Vec3<float> h{static_cast<float>(std::sin(polar)), 0, static_cast<float>(std::cos(polar))};
    const auto d = static_cast<double>(d_ggx<float>({0, 0, 1}, h, static_cast<float>(alpha)));
    return d * std::cos(polar) * std::sin(polar) * polar_step * azimuth_step;
}

/// Distributes a share evenly over the angles between two directions, ignoring angles below the horizon.
void spread(std::vector<LobeBin>& lobe, double share, double a_deg, double b_deg) {
    const double low = std::min(a_deg, b_deg), width = std::max(std::abs(a_deg - b_deg), 1e-9);
    for (auto i = static_cast<std::size_t>(low / bin_deg); i < lobe.size(); ++i) {
        const double from = std::max(lobe[i].from_deg, low), to = std::min(lobe[i].to_deg, low + width);
        if (to <= from) break;
        lobe[i].expected += share * (to - from) / width;
    }
}

/// Adds to each bin the integral of D(h) (n.h) / (4 v.h) over its directions l, computed as the integral of
/// D(h) (n.h) over their half vectors: dl = 4 v.h dh. Steps are dense where D is large, for any smoothness.
void add_expected(std::vector<LobeBin>& lobe, double alpha, glm::dvec3 v) {
    constexpr int outward = 512, around = 360;  // half of the circle; the other half is symmetric
    const auto polar_at = [alpha](double t) { return std::atan2(alpha * t, 1 - t); };
    for (int j = 0; j < around; ++j) {
        const double azimuth = pi * (j + 0.5) / around;
        const auto out_deg = [&](double polar) {
            const glm::dvec3 h(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                               std::cos(polar));
            return std::acos(std::clamp(2 * glm::dot(v, h) * h.z - v.z, -1.0, 1.0)) * 180 / pi;
        };
        double polar = 0, out = out_deg(0);
        for (int i = 0; i < outward; ++i) {
            const double next = polar_at((i + 1.0) / outward), middle = polar_at((i + 0.5) / outward);
            const double next_out = out_deg(next);
            spread(lobe, 2 * share_of_facets(alpha, middle, next - polar, pi / around), out, next_out);
            polar = next, out = next_out;
        }
    }
}

}  // namespace

glm::dvec3 sampled_normal(double roughness, std::mt19937& random) {
    const double u = uniform(random), azimuth = 2 * pi * uniform(random);
    const double polar = std::atan(ggx_alpha(roughness) * std::sqrt(u / (1 - u)));
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

std::vector<LobeBin> facet_lobe(double roughness, double view_deg, int rays, std::uint32_t seed) {
    const glm::dvec3 v = glm::normalize(glm::dvec3(in_plane(view_deg)));
    std::vector<LobeBin> lobe(bins);
    for (std::size_t i = 0; i < bins; ++i) {
        lobe[i].from_deg = bin_deg * static_cast<double>(i);
        lobe[i].to_deg = lobe[i].from_deg + bin_deg;
    }
    add_expected(lobe, ggx_alpha(roughness), v);
    std::mt19937 random(seed);
    for (int i = 0; i < rays; ++i) {
        const glm::dvec3 h = sampled_normal(roughness, random);
        const double v_dot_h = glm::dot(v, h);
        const glm::dvec3 l = 2 * v_dot_h * h - v;
        if (v_dot_h <= 0 || l.z <= 0) continue;
        const double deg = std::acos(std::min(l.z, 1.0)) * 180 / pi;
        lobe[static_cast<std::size_t>(std::min(deg / bin_deg, bins - 0.5))].share += 1.0 / rays;
    }
    return lobe;
}

Light white(Light light) {
    light.enabled = true;
    light.intensity = 1;
    light.diffuse = light.specular = glm::vec3(1);
    return light;
}

Scene alone(const Scene& scene, const Light& light) {
    Scene s;
    s.camera = scene.camera;
    s.shading = scene.shading;
    s.lights = {light};
    s.lights[0].enabled = true;
    return s;
}

LightAlone::LightAlone(const Scene& scene, PictureSize size, const Light& light, const Material& material) {
    Scene s = alone(scene, white(light));
    s.shading.terms.diffuse = s.shading.terms.specular = true;
    sources_ = light_sources(s);
    job_ = light_job(s, size, material, sources_, false);
}

PointAt<float> LightAlone::seen(glm::vec3 position, glm::vec3 normal) const {
    return seen_from_eye(job_, to_vec(position), to_vec(normal));
}

LightTerms<float> LightAlone::terms(const LightSource& source, const PointAt<float>& at) const {
    return illuminate(equation_of(job_), light_at<float>(source), material_at<float>(job_.material), at);
}

}  // namespace glint
