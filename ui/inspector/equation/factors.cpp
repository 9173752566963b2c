#include "ui/inspector/equation/factors.h"

#include <fmt/core.h>

#include <algorithm>

#include "models/scene/reflection.h"
#include "ui/inspector/equation/words.h"

namespace glint {
namespace {

Light& light_in(Scene& scene, int light) { return scene.lights[static_cast<std::size_t>(light)]; }

NumberHandle material_number(Scene& scene, const Explanation& explanation, const std::string& key) {
    return number_handle(scene, fmt::format("/objects/{}/material/{}", explanation.object_index, key));
}
NumberHandle material_colour(Scene& scene, const Explanation& explanation, const char* key, int channel) {
    return material_number(scene, explanation, fmt::format("{}/{}", key, channel));
}
NumberHandle light_colour(const LightInEquation& in, const char* key) {
    return number_handle(in.scene, fmt::format("/lights/{}/{}/{}", in.light.index, key, in.channel));
}

Factor scene_factor(Symbol symbol, const char* letter, const char* index, const NumberHandle& handle) {
    return {symbol, letter, index, *handle.number.place, handle, {}, 0, {}};
}

/// F, the light's colour, the surface's colour: what every term begins with.
std::vector<Factor> common_factors(const LightInEquation& in, Symbol symbol, const char* index,
                                   const NumberHandle& of_light, const NumberHandle& of_surface) {
    std::vector<Factor> factors;
    const Light& light = light_in(in.scene, in.light.index);
    if (light.kind != LightKind::Area)
        factors.push_back({Symbol::Emission, "F", "", share_of(in.light, light), {}, {}, 0, {}});
    factors.push_back(scene_factor(symbol, "", "", of_light));
    factors.push_back(scene_factor(symbol, "k", index, of_surface));
    return factors;
}

NumberHandle shininess_number(const LightInEquation& in) {
    NumberHandle handle = material_number(in.scene, in.explanation, "shininess");
    handle.number.kind.format = "%.4g";
    return handle;
}

Factor cosine_factor(Symbol a, Symbol b, float cosine) {
    Factor f;
    f.value = cosine;
    f.dot = {a, b};
    return f;
}

/// <n·l>, and what roughness makes of it.
void add_cosine(std::vector<Factor>& factors, const LightInEquation& in) {
    const float cosine = in.light.n_dot_l;
    Factor n_dot_l = cosine_factor(Symbol::N, Symbol::L, in.light.diffuse_factor);
    n_dot_l.clamped_from = std::min(cosine, 0.0f);
    if (!info_of(in.explanation.reflection).rough_diffuse || cosine <= 0) {
        factors.push_back(n_dot_l);
        return;
    }
    n_dot_l.value = cosine;
    factors.push_back(n_dot_l);
    factors.push_back({Symbol::Diffuse, "A+B…", "", in.light.diffuse_factor / cosine, {}, {}, 0, {}});
    factors.push_back({Symbol::Diffuse,
                       "by roughness",
                       "",
                       1,
                       material_number(in.scene, in.explanation, "roughness"),
                       {},
                       0,
                       {}});
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
    const ReflectionInfo info = info_of(in.explanation.reflection);
    switch (info.cosine) {
    case HighlightCosine::RV:
        return power(Symbol::R, Symbol::V, in.light.r_dot_v);
    case HighlightCosine::NH:
        return power(Symbol::N, Symbol::H, in.light.n_dot_h);
    case HighlightCosine::LV:
    case HighlightCosine::None:
        factors.push_back({Symbol::Specular, "S", "", strength, {}, {}, 0, {}});
        if (info.uses_shininess())
            factors.push_back({Symbol::Specular, "by shininess", "", 1, shininess_number(in), {}, 0, {}});
        if (info.has_highlight && info.uses_roughness)
            factors.push_back({Symbol::Specular,
                               "by roughness",
                               "",
                               1,
                               material_number(in.scene, in.explanation, "roughness"),
                               {},
                               0,
                               {}});
        return;
    }
}

}  // namespace

std::vector<TermLine> term_lines(const LightInEquation& in) {
    const Terms& on = in.scene.shading.terms;
    const bool area = light_in(in.scene, in.light.index).kind == LightKind::Area;
    const int c = in.channel;
    TermLine ambient{Symbol::Ambient, "a", on.ambient, {}, in.light.ambient[c]};
    ambient.factors = common_factors(in, Symbol::Ambient, "a", light_colour(in, "ambient"),
                                     material_colour(in.scene, in.explanation, "ambient", c));
    TermLine diffuse{Symbol::Diffuse, "d", on.diffuse, {}, in.light.diffuse[c]};
    diffuse.factors = common_factors(in, Symbol::Diffuse, "d", light_colour(in, "diffuse"),
                                     material_colour(in.scene, in.explanation, "diffuse", c));
    TermLine specular{Symbol::Specular, "s", on.specular, {}, in.light.specular[c]};
    specular.factors = common_factors(in, Symbol::Specular, "s", light_colour(in, "specular"),
                                      material_colour(in.scene, in.explanation, "specular", c));
    if (!area) {
        add_cosine(diffuse.factors, in);
        add_highlight(specular.factors, in);
    }
    return {ambient, diffuse, specular};
}

float share_of(const ExplainedLight& explained, const Light& light) {
    return light.intensity * explained.falloff * explained.spot;
}

NumberHandle number_handle(Scene& scene, const std::string& pointer) {
    const NamedNumber named = named_number(pointer, scene);
    return {number_at(scene, pointer).value(),
            named.owner == "Scene" ? named.what : fmt::format("{} of {}", named.what, named.owner)};
}

std::vector<TermLine> unlit_lines(Scene& scene, const Explanation& explanation, const ExplainedPoint& point,
                                  int channel) {
    const Terms& on = scene.shading.terms;
    TermLine emission{Symbol::Emission, "e", on.emission, {}, point.emission[channel]};
    TermLine ambient{Symbol::Ambient, "a", on.ambient, {}, point.global_ambient[channel]};
    emission.factors.push_back(
        scene_factor(Symbol::Emission, "", "", material_colour(scene, explanation, "emission", channel)));
    ambient.factors.push_back(scene_factor(Symbol::Ambient, "I", "a",
                                           number_handle(scene, fmt::format("/global_ambient/{}", channel))));
    ambient.factors.push_back(
        scene_factor(Symbol::Ambient, "k", "a", material_colour(scene, explanation, "ambient", channel)));
    return {emission, ambient};
}

}  // namespace glint
