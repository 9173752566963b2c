#include "renderer/explain/equation_line.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/problem.h"
#include "models/scene/reflection.h"
#include "renderer/explain/equation_text.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"

namespace glint {
namespace {

const Light& light_of(const LightOfEquation& in) {
    return in.scene.lights[static_cast<std::size_t>(in.light.index)];
}
/// The pointer to a number of the material in the scene; empty where mistakes changed the material.
std::string material_pointer(const Scene& scene, const Explanation& explanation, const char* key) {
    if (explanation.material != scene.objects[static_cast<std::size_t>(explanation.object_index)].material)
        return {};
    return fmt::format("/objects/{}/material/{}", explanation.object_index, key);
}
EquationFactor colour(Quantity quantity, glm::vec3 value, const std::string& pointer) {
    return {.quantity = quantity, .value = value, .pointer = pointer, .is_colour = true};
}
EquationFactor plain(Quantity quantity, double value) {
    return {.quantity = quantity, .value = glm::dvec3(value)};
}

/// The first factors of every term of a light: f, the two colours, and reach if it is not 1. `key`: the key
/// of both colours in the scene file.
std::vector<EquationFactor> common_factors(const LightOfEquation& in, Quantity of_light, Quantity of_material,
                                           glm::vec3 Light::*light, glm::vec3 Material::*material,
                                           const char* key) {
    std::vector<EquationFactor> factors{
        plain(Quantity::Share, share_line(in).result.x),
        colour(of_light, light_of(in).*light, fmt::format("/lights/{}/{}", in.light.index, key)),
        colour(of_material, in.explanation.material.*material,
               material_pointer(in.scene, in.explanation, key))};
    if (in.light.reached == 0 && in.light.samples.empty()) factors.push_back(plain(Quantity::Reach, 0));
    return factors;
}

void add_maker(EquationLine& line, const LightOfEquation& in, const char* key) {
    const std::string pointer = material_pointer(in.scene, in.explanation, key);
    if (!pointer.empty()) line.made_by.push_back(pointer);
}

/// The factor of the diffuse term: max(n·l, 0), modified by roughness.
void add_cosine(EquationLine& line, const LightOfEquation& in) {
    const float n_dot_l = in.light.n_dot_l;
    // That mistake is a separate factor in every model.
    const double times = in.scene.shading.mistakes.missing_pi ? std::numbers::pi : 1;
    const bool counts_behind = in.light.diffuse_factor != 0;  // by a mistake
    EquationFactor cosine = plain(Quantity::NL, counts_behind ? n_dot_l : std::max(n_dot_l, 0.0f));
    cosine.is_mean = !in.light.samples.empty();
    if (cosine.is_mean) {
        const std::vector<double> weights = sample_weights(in.light);
        cosine.value = glm::dvec3(0);
        for (std::size_t i = 0; i < weights.size(); ++i)
            cosine.value += weights[i] * times * double(in.light.samples[i].diffuse_factor);
    } else if (!counts_behind) {
        cosine.clamped_from = std::min(n_dot_l, 0.0f);
    }
    const bool rough = info_of(in.explanation.reflection).rough_diffuse;
    if (rough) add_maker(line, in, "roughness");
    line.factors.push_back(cosine);
    if (!rough || cosine.is_mean || n_dot_l <= 0) return;
    line.factors.push_back(
        plain(Quantity::Rough, times * double(in.light.diffuse_factor) / double(in.light.n_dot_l)));
}

/// The shininess as the picture uses it: OpenGL's fixed function clamps it to 128.
EquationPower power_of(const LightOfEquation& in) {
    const double n = in.explanation.material.shininess;
    if (in.scene.shading.rules == Rules::OpenGL2 && n > opengl_max_shininess)
        return {opengl_max_shininess, ""};
    return {n, material_pointer(in.scene, in.explanation, "shininess")};
}

bool is_close(glm::dvec3 a, glm::dvec3 b, double relative = 1e-2) {
    const auto close = [relative](double x, double y) {
        return std::abs(x - y) <=
               relative * std::max(std::abs(x), std::abs(y)) + 1e-7;  // fainter highlights are ignored
    };
    return close(a.x, b.x) && close(a.y, b.y) && close(a.z, b.z);
}

/// The cosine that the model raises to the shininess.
std::pair<Quantity, float> highlight_cosine(const ReflectionInfo& info, const ExplainedLight& light) {
    switch (info.cosine) {
    case HighlightCosine::None:
        break;
    case HighlightCosine::RV:
        return {Quantity::RV, light.r_dot_v};
    case HighlightCosine::NH:
        return {Quantity::NH, light.n_dot_h};
    case HighlightCosine::LV:
        return {Quantity::LV, light.l_dot_v};
    }
    return {Quantity::Highlight, 0};
}

/// The factors of the highlight, whether it is dropped or not.
std::vector<EquationFactor> highlight_factors(const LightOfEquation& in) {
    const ReflectionInfo info = info_of(in.explanation.reflection);
    const glm::dvec3 s = in.light.specular_factor;
    const bool dropped = in.light.n_dot_l <= 0 && s == glm::dvec3(0);  // with a mistake, the term is kept
    if (info.uses_shininess()) {
        const auto [quantity, cosine] = highlight_cosine(info, in.light);
        EquationFactor base = plain(quantity, std::max(cosine, 0.0f));
        base.clamped_from = std::min(cosine, 0.0f);
        base.power = power_of(in);
        const double power = std::pow(base.value.x, base.power->exponent);
        if (dropped) return {base};
        // A float cosine near 1 has too few digits for a large exponent: take the missing ones from the
        // power.
        if (s.x > 0 && base.power->exponent > 0 && is_close(glm::dvec3(power), s))
            base.value = glm::dvec3(std::pow(s.x, 1 / base.power->exponent));
        if (is_close(glm::dvec3(power), s)) return {base};
        if (cosine < 0 && is_close(glm::dvec3(std::pow(double(cosine), base.power->exponent)), s)) {
            base.value = glm::dvec3(cosine);  // a mistake does not clamp it
            base.clamped_from = 0;
            return {base};
        }
    }
    const ExplainedFacets& facets = in.light.facets;
    const bool faces_eye = facets.n_dot_v > 0;
    if (in.explanation.reflection == Reflection::CookTorrance && faces_eye) {
        EquationFactor n_dot_v = plain(Quantity::NV, facets.n_dot_v);
        n_dot_v.divides = true;
        const double shared = std::numbers::pi / 4 * double(facets.d) * double(facets.g) / facets.n_dot_v;
        constexpr double rounding = 1e-5;  // a mistake may change F by less than 1 %
        if (dropped || is_close(shared * glm::dvec3(facets.f), s, rounding))
            return {plain(Quantity::QuarterPi, std::numbers::pi / 4),
                    plain(Quantity::Facets, facets.d),
                    plain(Quantity::Masking, facets.g),
                    {.quantity = Quantity::Fresnel, .value = facets.f},
                    n_dot_v};
    }
    return {{.quantity = Quantity::Highlight, .value = s}};  // with a mistake or a table, there is no formula
}

void add_highlight(EquationLine& line, const LightOfEquation& in) {
    const ReflectionInfo info = info_of(in.explanation.reflection);
    if (info.has_highlight && info.uses_roughness) add_maker(line, in, "roughness");
    if (in.light.samples.empty()) {
        for (const EquationFactor& factor : highlight_factors(in)) line.factors.push_back(factor);
        return;
    }
    EquationFactor mean{.quantity = Quantity::Highlight, .value = glm::dvec3(0), .is_mean = true};
    const std::vector<double> weights = sample_weights(in.light);
    for (std::size_t i = 0; i < weights.size(); ++i)
        mean.value += weights[i] * glm::dvec3(in.light.samples[i].specular_factor);
    line.factors.push_back(mean);
}

/// Why the model's highlight is dropped here; empty if it is not.
std::string drop_reason(const LightOfEquation& in) {
    const bool is_area = !in.light.samples.empty();
    if (is_area || !info_of(in.explanation.reflection).has_highlight) return {};
    if (in.light.specular_factor != glm::vec3(0)) return {};  // the mistake that keeps it
    if (in.light.n_dot_l < -grazing_cosine) return "dropped: n·l < 0";
    if (in.light.n_dot_l <= 0) return "dropped: n·l = 0";
    if (in.explanation.reflection == Reflection::CookTorrance && in.light.facets.n_dot_v <= 0)
        return "dropped: n·v < 0";
    return {};
}

EquationLine ambient_line(const LightOfEquation& in) {
    EquationLine line{Quantity::AmbientTerm,
                      common_factors(in, Quantity::LightAmbient, Quantity::MaterialAmbient, &Light::ambient,
                                     &Material::ambient, "ambient"),
                      in.light.ambient};
    if (!in.scene.shading.terms.ambient) line.left_out = switched_off;
    return line;
}

EquationLine diffuse_line(const LightOfEquation& in) {
    EquationLine line{Quantity::DiffuseTerm,
                      common_factors(in, Quantity::LightDiffuse, Quantity::MaterialDiffuse, &Light::diffuse,
                                     &Material::diffuse, "diffuse"),
                      in.light.diffuse};
    add_cosine(line, in);
    if (!in.scene.shading.terms.diffuse) line.left_out = switched_off;
    return line;
}

EquationLine specular_line(const LightOfEquation& in) {
    EquationLine line{Quantity::SpecularTerm,
                      common_factors(in, Quantity::LightSpecular, Quantity::MaterialSpecular,
                                     &Light::specular, &Material::specular, "specular"),
                      in.light.specular};
    line.left_out = drop_reason(in);
    if (!line.left_out.empty())
        line.factors.clear();  // only the highlight, so that the line does not read as a product of 0
    add_highlight(line, in);
    if (!in.scene.shading.terms.specular) line.left_out = switched_off;
    return line;
}

/// If the scene's mistakes make a term differ from the product of its factors, adds the ratio as a factor, or
/// makes the mistake the entire term if the product is 0.
void add_mistake(const Scene& scene, EquationLine& line) {
    if (scene.shading.mistakes == Mistakes() || !line.left_out.empty()) return;
    const glm::dvec3 product{line.product(0), line.product(1), line.product(2)};
    if (is_close(product, line.result)) return;
    EquationFactor mistake{.quantity = Quantity::Mistake, .value = line.result};
    bool from_nothing = false;
    for (int c = 0; c < 3; ++c) from_nothing |= product[c] == 0 && line.result[c] != 0;
    if (from_nothing) line.factors.clear();
    for (int c = 0; c < 3 && !from_nothing; ++c)
        mistake.value[c] = product[c] == 0 ? 1 : line.result[c] / product[c];
    line.factors.push_back(mistake);
}

}  // namespace

double EquationLine::product(int channel) const {
    double p = 1;
    for (const EquationFactor& f : factors) {
        const double x = f.power ? std::pow(f.value[channel], f.power->exponent) : f.value[channel];
        p = f.divides ? p / x : p * x;
    }
    return p;
}

glm::vec3 counted_share(const ExplainedLight& light) {
    glm::vec3 sum = light.share;
    for (const ExplainedLight& sample : light.samples) sum += sample.share;
    return sum;
}

bool is_clamped(const LightOfEquation& in) {
    const glm::dvec3 terms = in.light.ambient + in.light.diffuse + in.light.specular;
    return in.scene.shading.mistakes.clamp_each_light && !is_close(counted_share(in.light), terms);
}

std::vector<double> sample_weights(const ExplainedLight& area) {
    double sum = 0;
    for (const ExplainedLight& sample : area.samples)
        if (sample.reached > 0) sum += double(sample.falloff);
    std::vector<double> weights;
    for (const ExplainedLight& sample : area.samples)
        weights.push_back(sum > 0 && sample.reached > 0 ? double(sample.falloff) / sum : 0);
    return weights;
}

EquationLine share_line(const LightOfEquation& in) {
    const Light& light = light_of(in);
    const double divisor = share_divisor(in.scene);
    EquationFactor intensity = plain(Quantity::Intensity, double(light.intensity) / divisor);
    if (divisor == 1) intensity.pointer = fmt::format("/lights/{}/intensity", in.light.index);
    EquationLine line{Quantity::Share, {intensity}};
    const bool is_area = light.kind == LightKind::Area;
    if (is_area || light.kind != LightKind::Directional || in.light.falloff != 1)
        line.factors.push_back(plain(is_area ? Quantity::Form : Quantity::Falloff, in.light.falloff));
    if (light.kind == LightKind::Spot) line.factors.push_back(plain(Quantity::Spot, in.light.spot));
    line.result = glm::dvec3(line.product(0));
    return line;
}

std::vector<EquationLine> light_lines(const LightOfEquation& in) {
    std::vector<EquationLine> lines;
    if (!in.scene.npr.cool_to_warm) lines = {ambient_line(in), diffuse_line(in)};
    // Factors that the model lacks have no line.
    if (info_of(in.explanation.reflection).has_highlight || in.light.specular != glm::vec3(0))
        lines.push_back(specular_line(in));
    for (EquationLine& line : lines) add_mistake(in.scene, line);
    return lines;
}

std::vector<EquationLine> unlit_lines(const Scene& scene, const Explanation& explanation,
                                      const ExplainedPoint& point) {
    const Material& m = explanation.material;
    EquationLine emission{
        Quantity::EmissionTerm,
        {colour(Quantity::MaterialEmission, m.emission, material_pointer(scene, explanation, "emission"))},
        point.emission};
    EquationLine ambient{
        Quantity::AmbientTerm,
        {colour(Quantity::GlobalAmbient, scene.global_ambient, "/global_ambient"),
         colour(Quantity::MaterialAmbient, m.ambient, material_pointer(scene, explanation, "ambient"))},
        point.global_ambient};
    if (point.bounces.used)
        ambient = {Quantity::BouncedTerm,
                   {colour(Quantity::Bounced, point.bounces.arrives, ""),
                    colour(Quantity::MaterialDiffuse, explanation.material.diffuse,
                           material_pointer(scene, explanation, "diffuse"))},
                   point.bounces.term};
    if (!scene.shading.terms.emission) emission.left_out = switched_off;
    if (!scene.shading.terms.ambient) ambient.left_out = switched_off;
    add_mistake(scene, ambient);
    return {emission, ambient};
}

}  // namespace glint
