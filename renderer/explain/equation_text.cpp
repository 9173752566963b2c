#include "renderer/explain/equation_text.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>

#include "models/problem.h"
#include "models/scene/reflection.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"

namespace glint {
namespace {

/// Writes one channel of v, or all three if they differ.
template <class Text> std::string in_channels(glm::dvec3 v, std::optional<int> channel, const Text& text) {
    if (channel) return text(v[*channel]);
    const std::string red = text(v.x), green = text(v.y), blue = text(v.z);
    return red == green && green == blue ? red : fmt::format("({} {} {})", red, green, blue);
}

std::string written_factor(const EquationFactor& f, int decimals, int exponent_decimals,
                           std::optional<int> channel) {
    std::string text = f.is_mean ? "mean " + text_of(f.quantity) : text_of(f.quantity);
    if (f.quantity == Quantity::QuarterPi) return text;
    text += ' ';
    if (f.clamped_from < 0) text += short_text(f.clamped_from, decimals) + " → ";
    text += in_channels(f.value, channel, [&](double x) { return short_text(x, decimals); });
    if (!f.power) return text;
    return fmt::format("({})^{}", text, short_text(f.power->exponent, exponent_decimals));
}

/// The minimum number of decimals of a factor. A light's factor f is the result of another line, and has as
/// many decimals as in that line.
int least_decimals(const EquationFactor& f, int channel, NumberText as) {
    const double x = f.value[channel];
    if (f.quantity == Quantity::QuarterPi) return most_decimals;
    if (f.quantity != Quantity::Share) return significant_decimals(x, is_cosine(f.quantity) ? 3 : 2);
    const std::string text = as(x);
    const std::size_t end = std::min(text.find('e'), text.size()), point = std::min(text.find('.'), end);
    return point < end ? static_cast<int>(end - point) - 1 : 0;
}

/// The number of decimals for which the product of the written factors equals the exact product in one
/// channel, to within half of the result's last digit.
LineDecimals decimals_of(const EquationLine& line, int channel, NumberText as) {
    constexpr double held_back = 0.45;  // in units of the last digit; the rest allows for float rounding
    std::vector<double> values;
    std::vector<int> least;
    for (const EquationFactor& f : line.factors) {
        values.push_back(f.value[channel]);
        values.push_back(f.power ? f.power->exponent : 1);
        least.push_back(least_decimals(f, channel, as));
        least.push_back(0);
    }
    EquationLine written = line;
    const auto formula = [&](std::span<const double> v) {
        for (std::size_t i = 0; i < written.factors.size(); ++i) {
            written.factors[i].value[channel] = v[2 * i];
            if (written.factors[i].power) written.factors[i].power->exponent = v[2 * i + 1];
        }
        return written.product(channel);
    };
    const double result = line.left_out.empty() ? line.result[channel] : line.product(channel);
    const std::vector<int> all = decimals_for(values, least, formula, held_back * last_digit_of(as(result)));
    LineDecimals decimals;
    for (std::size_t i = 0; i < line.factors.size(); ++i) {
        decimals.value.push_back(all[2 * i]);
        decimals.exponent.push_back(all[2 * i + 1]);
    }
    return decimals;
}

/// The larger number of decimals of each factor.
LineDecimals merged(LineDecimals a, const LineDecimals& b) {
    for (std::size_t i = 0; i < a.value.size(); ++i) {
        a.value[i] = std::max(a.value[i], b.value[i]);
        a.exponent[i] = std::max(a.exponent[i], b.exponent[i]);
    }
    return a;
}

}  // namespace

LineDecimals written_decimals(const EquationLine& line, std::optional<int> channel, NumberText as) {
    const auto of = [&](int c) { return decimals_of(line, c, as); };
    return channel ? of(*channel) : merged(merged(of(0), of(1)), of(2));
}

std::string written_product(const EquationLine& line, std::optional<int> channel, NumberText as) {
    const LineDecimals decimals = written_decimals(line, channel, as);
    std::string text;
    for (std::size_t i = 0; i < line.factors.size(); ++i) {
        const EquationFactor& f = line.factors[i];
        if (i > 0) text += f.divides ? " / " : " · ";
        text += written_factor(f, decimals.value[i], decimals.exponent[i], channel);
    }
    if (line.left_out.empty()) return text;
    const glm::dvec3 product{line.product(0), line.product(1), line.product(2)};
    return fmt::format("{} = {}, {}", text, in_channels(product, channel, as), line.left_out);
}

namespace {

/// " (4 of 64 samples so far)"; empty for all samples.
std::string so_far(const ExplainedLight& explained, const Light& area) {
    const std::string count = sample_count(explained, area);
    return count.ends_with("so far") ? fmt::format(" ({})", count) : "";
}

bool points_away(const ExplainedPoint& at) { return glm::dot(at.normal.camera, at.view.camera) < 0; }

}  // namespace

bool is_plain_front(const Explanation& explanation) {
    return explanation.front_facing && !points_away(explanation.at);
}

std::string side_words(const Explanation& explanation) {
    const bool away = points_away(explanation.at);
    if (explanation.front_facing) return away ? "front side, n points away from the eye" : "front side";
    return away ? "back side" : "back side, n turned towards the eye";
}

std::string sample_count(const ExplainedLight& explained, const Light& area) {
    const auto side = static_cast<std::size_t>(std::lround(std::sqrt(area.area.samples)));
    const std::size_t count = explained.samples.size(), all = side * side;
    return count < all ? fmt::format("{} of {} samples so far", count, all)
                       : fmt::format("{} samples", count);
}

std::string dark_reason(const ExplainedLight& explained, const Light& light) {
    if (light.kind == LightKind::Area) {
        const auto in_front = std::count_if(explained.samples.begin(), explained.samples.end(),
                                            [](const ExplainedLight& sample) { return sample.n_dot_l > 0; });
        const auto all = static_cast<std::ptrdiff_t>(explained.samples.size());
        if (in_front == 0)
            return std::string("behind the surface: n·l < 0 for all samples") + so_far(explained, light);
        if (explained.reached < 1) {
            const auto reach = std::lround(explained.reached * static_cast<float>(in_front));
            const std::string blocker = on_one_line(explained.blocked_by);
            return (reach == 0 ? "in the shadow of " + blocker
                               : fmt::format("{} of {} samples reach the point; the others are blocked by {}",
                                             reach, in_front, blocker)) +
                   so_far(explained, light);
        }
        if (in_front == all) return {};
        return fmt::format("{} of {} samples are behind the surface", all - in_front, all) +
               so_far(explained, light);
    }
    const bool cone = light.kind == LightKind::Spot && light.spot.cutoff_deg <= 90;
    const bool is_outside = cone && explained.spot_angle_deg > light.spot.cutoff_deg;
    if (is_outside && explained.spot == 0)  // a mistake may widen the cone
        return fmt::format("outside the cone by {:.1f}°", explained.spot_angle_deg - light.spot.cutoff_deg);
    const glm::vec3 added = explained.diffuse + explained.specular;
    const bool adds = std::max({added.r, added.g, added.b}) > grazing_cosine;  // a mistake may light the back
    if (std::abs(explained.n_dot_l) <= grazing_cosine && !adds) return "grazes the surface: n·l = 0";
    if (explained.n_dot_l < 0 && !adds) return "behind the surface: n·l < 0";
    if (explained.reached == 0) return "in the shadow of " + on_one_line(explained.blocked_by);
    const float arrives = light.intensity * explained.falloff;  // a strong light has a long range
    if (arrives < 0.01f && explained.falloff < 0.01f)
        return fmt::format("hardly reaches: falloff {:.2g}", explained.falloff);
    if (arrives * explained.spot < 0.01f && explained.spot < 0.01f)
        return fmt::format("its cone lets through {:.2g}", explained.spot);
    return {};
}

const char* decimal_format(double x, int decimals) {
    static constexpr std::array plain{"%.0f", "%.1f", "%.2f", "%.3f", "%.4f",
                                      "%.5f", "%.6f", "%.7f", "%.8f", "%.9f"};
    static constexpr std::array powers{"%.0e", "%.1e", "%.2e", "%.3e", "%.4e",
                                       "%.5e", "%.6e", "%.7e", "%.8e", "%.9e"};
    const double size = std::abs(x);
    const bool is_plain = size == 0 || (size >= 1e-4 && size < 1e6);
    return (is_plain ? plain : powers)[static_cast<std::size_t>(std::clamp(decimals, 0, most_decimals))];
}

std::string decimal_text(double x, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, decimal_format(x, decimals), x == 0 ? 0 : x);  // omits the sign of -0
    return text;
}

std::string short_text(double x, int decimals) {
    std::string text = decimal_text(x, decimals);
    const std::size_t end = std::min(text.find('e'), text.size());
    if (text.find('.') >= end) return text;
    std::size_t kept = end;
    while (text[kept - 1] == '0') --kept;
    if (text[kept - 1] == '.') --kept;
    return text.substr(0, kept) + text.substr(end);
}

std::string fixed_text(double x, int decimals) {
    std::string text = fmt::format("{:.{}f}", x, decimals);
    if (text[0] == '-' && text.find_first_not_of("-0.") == text.npos) text.erase(0, 1);
    return text;
}

int significant_decimals(double x, int decimals) {
    const double size = std::abs(x);
    if (!(size >= 1e-4 && size < 1)) return decimals;
    return std::max(decimals, 1 - static_cast<int>(std::floor(std::log10(size))));
}

std::string significant_text(double x, int decimals) {
    if (x != 0 && std::abs(x) < 1e-4) return fmt::format("{:.1e}", x);
    const int needed = significant_decimals(x, decimals);
    std::string text = fixed_text(x, needed);
    for (int i = needed; i > decimals && text.back() == '0'; --i) text.pop_back();
    return text;
}

double last_digit_of(std::string_view number) {
    const std::size_t e = std::min(number.find('e'), number.size());
    const std::size_t point = number.find('.');
    const auto decimals = point < e ? static_cast<int>(e - point) - 1 : 0;
    int exponent = 0;
    if (e < number.size()) {
        const std::size_t digits = number[e + 1] == '+' ? e + 2 : e + 1;  // from_chars rejects a plus
        std::from_chars(number.data() + digits, number.data() + number.size(), exponent);
    }
    return std::pow(10.0, exponent - decimals);
}

std::vector<int> decimals_for(std::span<const double> values, std::span<const int> least,
                              const std::function<double(std::span<const double>)>& formula,
                              double tolerance) {
    std::vector<int> decimals(least.begin(), least.end());
    std::vector<double> numbers(values.begin(), values.end()), error(values.size());
    const double exact = formula(numbers);
    const auto measure = [&](std::size_t i) {
        numbers[i] = std::strtod(decimal_text(values[i], decimals[i]).c_str(), nullptr);
        error[i] = std::abs(formula(numbers) - exact);
        numbers[i] = values[i];
    };
    for (std::size_t i = 0; i < values.size(); ++i) measure(i);
    for (;;) {
        // In the worst case the errors of the numbers add up; products of errors are negligible.
        double sum = 0;
        std::size_t worst = values.size();
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += error[i];
            if (decimals[i] < most_decimals && (worst == values.size() || error[i] > error[worst])) worst = i;
        }
        if (sum <= tolerance || worst == values.size()) return decimals;
        ++decimals[worst];
        measure(worst);
    }
}

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
/// that the two colours have in the scene file.
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
    // The mistake missing_pi is a separate factor in every model.
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
    return {{.quantity = Quantity::Highlight, .value = s}};  // a mistake or a table has no formula
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
