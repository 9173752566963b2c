#include "ui/why/factors.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "ui/scene_numbers.h"

namespace glint {
namespace {

constexpr std::array channel_names{"red", "green", "blue"};

Light& light_in(Scene& scene, int light) { return scene.lights[static_cast<std::size_t>(light)]; }

/// A channel of a colour.
SceneNumber colour_number(glm::vec3& colour, int channel, const std::string& name, const char* what,
                          const std::string& pointer, glm::vec3 initial) {
    const char* shown = channel_names[static_cast<std::size_t>(channel)];
    return {&colour[channel],
            fmt::format("{}: {}", name, shown),
            {.min = 0, .initial = initial[channel], .speed = 0.004f, .format = "%.2f"},
            {what, fmt::format("{}/{}", pointer, channel)}};
}

SceneNumber material_number(Scene& scene, const Explanation& why, glm::vec3 Material::*colour, int channel,
                            const char* key, const char* what) {
    Material& material = scene.objects[static_cast<std::size_t>(why.object_index)].material;
    return colour_number(material.*colour, channel, fmt::format("{} of {}", key, why.object), what,
                         fmt::format("/objects/{}/material/{}", why.object_index, key), Material{}.*colour);
}

SceneNumber light_colour(const LightInEquation& in, glm::vec3 Light::*colour, const char* key) {
    Light& light = light_in(in.scene, in.light.index);
    return colour_number(light.*colour, in.channel, fmt::format("{} colour of {}", key, light.name),
                         "Colour of the light, for this term",
                         fmt::format("/lights/{}/{}", in.light.index, key), Light{}.*colour);
}

Factor scene_factor(Symbol symbol, const char* letter, const char* index, const SceneNumber& number) {
    return {symbol, letter, index, *number.value, number, {}, 0, {}};
}

/// F, the light's colour, the surface's colour: what every term begins with.
std::vector<Factor> common_factors(const LightInEquation& in, Symbol symbol, const char* index,
                                   const SceneNumber& of_light, const SceneNumber& of_surface) {
    std::vector<Factor> factors;
    const Light& light = light_in(in.scene, in.light.index);
    if (light.kind != LightKind::Area)
        factors.push_back({Symbol::Emission, "F", "", share_of(in.light, light), {}, {}, 0, {}});
    factors.push_back(scene_factor(symbol, "", "", of_light));
    factors.push_back(scene_factor(symbol, "k", index, of_surface));
    return factors;
}

SceneNumber shininess_number(const LightInEquation& in) {
    Material& material = in.scene.objects[static_cast<std::size_t>(in.why.object_index)].material;
    return {&material.shininess,
            fmt::format("shininess of {}", in.why.object),
            shown_as(shininess_spec.number, "%.4g"),
            {shininess_spec.what, fmt::format("/objects/{}/material/shininess", in.why.object_index)}};
}

SceneNumber roughness_number(const LightInEquation& in) {
    Material& material = in.scene.objects[static_cast<std::size_t>(in.why.object_index)].material;
    return {&material.roughness,
            fmt::format("roughness of {}", in.why.object),
            roughness_spec.number,
            {roughness_spec.what, fmt::format("/objects/{}/material/roughness", in.why.object_index)}};
}

Factor cosine_factor(Symbol a, Symbol b, float cosine) {
    Factor f;
    f.value = cosine;
    f.dot = {a, b};
    return f;
}

/// <n·l>, and under Oren-Nayar what roughness makes of it.
void add_cosine(std::vector<Factor>& factors, const LightInEquation& in) {
    const float cosine = in.light.n_dot_l;
    Factor n_dot_l = cosine_factor(Symbol::N, Symbol::L, in.light.diffuse_factor);
    n_dot_l.clamped_from = std::min(cosine, 0.0f);
    if (in.why.reflection != Reflection::OrenNayar || cosine <= 0) {
        factors.push_back(n_dot_l);
        return;
    }
    n_dot_l.value = cosine;
    factors.push_back(n_dot_l);
    factors.push_back({Symbol::Diffuse, "A+B…", "", in.light.diffuse_factor / cosine, {}, {}, 0, {}});
    factors.push_back({Symbol::Diffuse, "by roughness", "", 1, roughness_number(in), {}, 0, {}});
}

void add_highlight(std::vector<Factor>& factors, const LightInEquation& in) {
    const float strength = in.light.specular_factor[in.channel];
    const auto power = [&](Symbol a, Symbol b, float cosine) {
        Factor base = cosine_factor(a, b, std::max(cosine, 0.0f));
        base.clamped_from = std::min(cosine, 0.0f);
        base.exponent = shininess_number(in);
        // No highlight from behind, whatever r·v is: the factor that makes the term 0 is n·l.
        if (strength == 0 && in.light.n_dot_l <= 0) {
            base = cosine_factor(Symbol::N, Symbol::L, 0);
            base.clamped_from = in.light.n_dot_l;
        }
        factors.push_back(base);
    };
    switch (in.why.reflection) {
    case Reflection::None:
    case Reflection::Lambert:
    case Reflection::OrenNayar:
        factors.push_back({Symbol::Specular, "S", "", strength, {}, {}, 0, {}});
        return;
    case Reflection::Phong:
        return power(Symbol::R, Symbol::V, in.light.r_dot_v);
    case Reflection::BlinnPhong:
        return power(Symbol::N, Symbol::H, in.light.n_dot_h);
    case Reflection::Retro:
    case Reflection::CookTorrance:
        factors.push_back({Symbol::Specular, "S", "", strength, {}, {}, 0, {}});
        factors.push_back(
            in.why.reflection == Reflection::Retro
                ? Factor{Symbol::Specular, "by shininess", "", 1, shininess_number(in), {}, 0, {}}
                : Factor{Symbol::Specular, "by roughness", "", 1, roughness_number(in), {}, 0, {}});
        return;
    }
}

}  // namespace

std::vector<TermLine> term_lines(const LightInEquation& in) {
    const Terms& on = in.scene.shading.terms;
    const bool area = light_in(in.scene, in.light.index).kind == LightKind::Area;
    const int c = in.channel;
    TermLine ambient{Symbol::Ambient, "a", on.ambient, {}, in.light.ambient[c]};
    ambient.factors = common_factors(in, Symbol::Ambient, "a", light_colour(in, &Light::ambient, "ambient"),
                                     material_number(in.scene, in.why, &Material::ambient, c, "ambient",
                                                     "k_a: share of ambient light reflected"));
    TermLine diffuse{Symbol::Diffuse, "d", on.diffuse, {}, in.light.diffuse[c]};
    diffuse.factors = common_factors(in, Symbol::Diffuse, "d", light_colour(in, &Light::diffuse, "diffuse"),
                                     material_number(in.scene, in.why, &Material::diffuse, c, "diffuse",
                                                     "k_d: share reflected evenly in all directions"));
    TermLine specular{Symbol::Specular, "s", on.specular, {}, in.light.specular[c]};
    specular.factors =
        common_factors(in, Symbol::Specular, "s", light_colour(in, &Light::specular, "specular"),
                       material_number(in.scene, in.why, &Material::specular, c, "specular",
                                       "k_s: share reflected into the highlight"));
    if (!area) {
        add_cosine(diffuse.factors, in);
        add_highlight(specular.factors, in);
    }
    return {ambient, diffuse, specular};
}

float share_of(const ExplainedLight& explained, const Light& light) {
    return light.intensity * explained.falloff * explained.spot;
}

SceneNumber intensity_number(Scene& scene, int light) {
    Light& item = light_in(scene, light);
    return {&item.intensity,
            fmt::format("intensity of {}", item.name),
            shown_as(intensity_spec.number, "%.2f"),
            {intensity_spec.what, fmt::format("/lights/{}/intensity", light)}};
}

std::vector<SceneNumber> falloff_numbers(Scene& scene, int light) {
    Light& item = light_in(scene, light);
    const auto number = [&](float& value, const char* key, const NumberSpec& spec) {
        return SceneNumber{&value,
                           fmt::format("{} falloff of {}", key, item.name),
                           shown_as(spec.number, "%.2f"),
                           {spec.what, fmt::format("/lights/{}/falloff/{}", light, key)}};
    };
    return {number(item.falloff.constant, "constant", falloff_constant_spec),
            number(item.falloff.linear, "linear", falloff_linear_spec),
            number(item.falloff.quadratic, "quadratic", falloff_quadratic_spec)};
}

SceneNumber cutoff_number(Scene& scene, int light) {
    Light& item = light_in(scene, light);
    return {&item.spot.cutoff_deg,
            fmt::format("cutoff of {}", item.name),
            cutoff_spec.number,
            {cutoff_spec.what, fmt::format("/lights/{}/spot/cutoff_deg", light)}};
}

SceneNumber spot_exponent_number(Scene& scene, int light) {
    Light& item = light_in(scene, light);
    return {&item.spot.exponent,
            fmt::format("exponent of {}", item.name),
            shown_as(spot_exponent_spec.number, "%.3g"),
            {spot_exponent_spec.what, fmt::format("/lights/{}/spot/exponent", light)}};
}

std::vector<TermLine> unlit_lines(Scene& scene, const Explanation& why, const ExplainedPoint& point,
                                  int channel) {
    const Terms& on = scene.shading.terms;
    TermLine emission{Symbol::Emission, "e", on.emission, {}, point.emission[channel]};
    emission.factors.push_back(
        scene_factor(Symbol::Emission, "", "",
                     material_number(scene, why, &Material::emission, channel, "emission",
                                     "What the surface shines by itself")));
    TermLine ambient{Symbol::Ambient, "a", on.ambient, {}, point.global_ambient[channel]};
    ambient.factors.push_back(scene_factor(
        Symbol::Ambient, "I", "a",
        colour_number(scene.global_ambient, channel, "global ambient",
                      "Light from everywhere, apart from all lights", "/global_ambient", glm::vec3(0.1f))));
    ambient.factors.push_back(scene_factor(Symbol::Ambient, "k", "a",
                                           material_number(scene, why, &Material::ambient, channel, "ambient",
                                                           "k_a: share of ambient light reflected")));
    return {emission, ambient};
}

}  // namespace glint
