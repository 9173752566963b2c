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
    return {symbol, letter, index, *handle.number.place, handle};
}

Factor value_factor(Symbol symbol, const char* letter, float value) { return {symbol, letter, "", value}; }

/// A number of the scene by which a factor before it came about: it multiplies nothing.
Factor by_number(Symbol symbol, const char* letter, const NumberHandle& handle) {
    return {symbol, letter, "", 1, handle};
}

Factor by_roughness(const LightInEquation& in, Symbol symbol) {
    return by_number(symbol, "by roughness", material_number(in.scene, in.explanation, "roughness"));
}

/// F, the light's colour, the surface's colour: what every term begins with.
std::vector<Factor> common_factors(const LightInEquation& in, Symbol symbol, const char* index,
                                   const char* key) {
    std::vector<Factor> factors;
    const Light& light = light_in(in.scene, in.light.index);
    if (light.kind != LightKind::Area)
        factors.push_back(value_factor(Symbol::Emission, "F", share_of(in.light, light)));
    factors.push_back(scene_factor(symbol, "", "", light_colour(in, key)));
    factors.push_back(
        scene_factor(symbol, "k", index, material_colour(in.scene, in.explanation, key, in.channel)));
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
    factors.push_back(value_factor(Symbol::Diffuse, "A+B…", in.light.diffuse_factor / cosine));
    factors.push_back(by_roughness(in, Symbol::Diffuse));
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
        factors.push_back(value_factor(Symbol::Specular, "S", strength));
        if (info.uses_shininess())
            factors.push_back(by_number(Symbol::Specular, "by shininess", shininess_number(in)));
        if (info.has_highlight && info.uses_roughness) factors.push_back(by_roughness(in, Symbol::Specular));
        return;
    }
}

}  // namespace

std::vector<TermLine> term_lines(const LightInEquation& in) {
    const Terms& on = in.scene.shading.terms;
    const bool area = light_in(in.scene, in.light.index).kind == LightKind::Area;
    const auto term = [&](Symbol symbol, const char* letter, const char* key, bool is_on, glm::vec3 result) {
        return TermLine{symbol, letter, is_on, common_factors(in, symbol, letter, key), result[in.channel]};
    };
    const TermLine ambient = term(Symbol::Ambient, "a", "ambient", on.ambient, in.light.ambient);
    TermLine diffuse = term(Symbol::Diffuse, "d", "diffuse", on.diffuse, in.light.diffuse);
    TermLine specular = term(Symbol::Specular, "s", "specular", on.specular, in.light.specular);
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
