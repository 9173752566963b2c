#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/fields/choices.h"
#include "models/problem.h"
#include "models/utf8.h"
#include "renderer/explain/equation_text.h"
#include "renderer/picture.h"

namespace glint {
namespace {

/// Formats a number ten columns wide, with aligned decimal points if no exponent is needed.
std::string in_column(float x) {
    const float size = std::abs(x);
    if (!std::isfinite(x)) return fmt::format("{:>10}", x);
    return x == 0 || (size >= 1e-4f && size < 1e4f) ? fmt::format("{:>10}", fixed_text(double(x), 4))
                                                    : fmt::format("{:10.2e}", x);
}
std::string in_columns(glm::vec3 v) { return in_column(v.x) + in_column(v.y) + in_column(v.z); }

/// Formats a number for use inside an equation, as short as possible.
std::string brief(float x) { return fmt::format("{:.4g}", x); }
std::string brief(glm::vec3 v) {
    if (v.x == v.y && v.y == v.z) return brief(v.x);
    return fmt::format("({:.4g} {:.4g} {:.4g})", v.x, v.y, v.z);
}

constexpr std::size_t product_width = 62;

/// Writes a term: its name, its product, and its red, green and blue (on the next line if the term is long).
std::string term(std::string_view name, std::string_view product, glm::vec3 value) {
    const auto is_start = [](char byte) { return !continues_character(byte); };
    const auto width = static_cast<std::size_t>(std::count_if(product.begin(), product.end(), is_start));
    if (width <= product_width)
        return fmt::format("  {:<9} {:<{}}{}\n", name, product, product_width, in_columns(value));
    return fmt::format("  {:<9} {}\n", name, product) + term("", "", value);
}

std::string vector(std::string_view symbol, const InBothFrames& v, std::string_view meaning) {
    return fmt::format("  {:<3}{}   {}    {}\n", symbol, in_columns(v.camera), in_columns(v.world), meaning);
}

/// Formats a result as in its column, without leading spaces.
std::string result_text(double x) {
    const std::string text = in_column(static_cast<float>(x));
    return text.substr(text.find_first_not_of(' '));
}

/// Writes a term of the equation: the product of its factors and its result.
std::string term(const EquationLine& line) {
    std::string_view name = "f";
    if (line.term == Quantity::EmissionTerm) name = "emission";
    if (line.term == Quantity::AmbientTerm) name = "ambient";
    if (line.term == Quantity::BouncedTerm) name = "bounced";
    if (line.term == Quantity::DiffuseTerm) name = "diffuse";
    if (line.term == Quantity::SpecularTerm) name = "specular";
    return term(name, written_product(line, std::nullopt, result_text), glm::vec3(line.result));
}

class Writer {
  public:
    Writer(const Explanation& e, const Scene& scene) : e_(e), scene_(scene) {}

    [[nodiscard]] std::string text() const {
        std::string text = fmt::format("Pixel {}, {}: ", e_.x, e_.y);
        text += e_.hit ? hit() : "background\n\n";
        return text + result();
    }

  private:
    [[nodiscard]] std::string hit() const {
        std::string text =
            fmt::format("{}, face {}, {}; {} shading, {} reflection\n\n", on_one_line(e_.object), e_.face,
                        side_words(e_), name_of(e_.mode), name_of(e_.reflection));
        text += spaces() + "\n";
        text += "     camera coordinates               world coordinates\n" + place(e_.at) + "\n";
        if (!e_.lit_per_corner) return text + equation(e_.at);
        text += weights();
        for (std::size_t i = 0; i < e_.corners.size(); ++i) {
            const ExplainedCorner& corner = e_.corners[i];
            text += e_.mode == ShadingMode::Flat ? lit_once()
                                                 : fmt::format("Corner {} of {}, weight {}\n", i + 1,
                                                               e_.corners.size(), brief(corner.weight));
            text += place(corner.at) + "\n" + equation(corner.at);
            text += term("sum", "of this point", corner.at.sum) + "\n";
        }
        return text;
    }

    /// The interpolation that determines the corners' weights, and the results with the other interpolations.
    [[nodiscard]] std::string weights() const {
        std::string text;
        for (const ExplainedInterpolation& each : e_.interpolations) {
            const bool chosen = each.interpolation == e_.interpolation;
            text +=
                term(name_of(each.interpolation), chosen ? "weights in use" : "weights would give", each.sum);
        }
        return text.empty() ? text : text + "\n";
    }

    [[nodiscard]] std::string lit_once() const {
        return fmt::format("Lit at one point for the entire {}\n",
                           flat_at_provoking_corner(scene_.shading) ? "triangle" : "polygon");
    }

    [[nodiscard]] bool is_lit_in_camera() const {
        return info_of(e_.reflection).is_lit && !scene_.shading.mistakes.lit_after_projection;
    }

    /// The numbers after division by w, which is 0 for points in the eye's plane.
    static std::string divided(const std::vector<float>& numbers) {
        const auto is_finite = [](float x) { return std::isfinite(x); };
        if (!std::all_of(numbers.begin(), numbers.end(), is_finite)) return "      none: divided by 0";
        std::string text;
        for (const float x : numbers) text += in_column(x);
        return text;
    }

    /// The point in every coordinate system from the mesh to the screen.
    [[nodiscard]] std::string spaces() const {
        const ExplainedSpaces& in = e_.spaces;
        const auto line = [](std::string_view name, const std::string& values, std::string_view note) {
            return fmt::format("  {:<8}{}{}\n", name, values, note);
        };
        return line("object", in_columns(in.object), "") + line("world", in_columns(in.world), "") +
               line("camera", in_columns(in.camera), is_lit_in_camera() ? "              lit here" : "") +
               line("clip", in_columns(glm::vec3(in.clip)) + in_column(in.clip.w), "    w last") +
               line("ndc", divided({in.ndc.x, in.ndc.y, in.ndc.z}), "") +
               line("pixel", divided({in.pixel.x, in.pixel.y}), "");
    }

    static std::string place(const ExplainedPoint& at) {
        return vector("p", at.point, "the point") + vector("n", at.normal, "its normal") +
               vector("v", at.view, "to the eye");
    }

    /// The terms of one point, without their sum.
    [[nodiscard]] std::string equation(const ExplainedPoint& at) const {
        if (!info_of(e_.reflection).is_lit) return "  no lighting: the mesh's own colour\n\n";
        std::string text =
            fmt::format("  {:<{}}{:>10}{:>10}{:>10}\n", "", product_width + 10, "red", "green", "blue");
        text += at.cool_to_warm.used ? tone(at.cool_to_warm) : unlit(at);
        for (const ExplainedLight& light : at.lights) text += one_light(light) + "\n";
        return text;
    }

    /// The terms that do not depend on a light.
    [[nodiscard]] std::string unlit(const ExplainedPoint& at) const {
        std::string text;
        for (const EquationLine& line : unlit_lines(scene_, e_, at)) text += term(line);
        if (at.bounces.used)
            text += fmt::format("  L_b is the mean of {} paths, standard error {}\n", at.bounces.paths,
                                brief(at.bounces.standard_error));
        return text + "\n";
    }

    /// Cool-to-warm shading, which replaces emission, ambient and diffuse terms.
    static std::string tone(const ExplainedTone& t) {
        const std::string product = fmt::format("k_w {} · warm {} + {} · cool {}", brief(t.k_w),
                                                brief(t.warm), brief(1 - t.k_w), brief(t.cool));
        return fmt::format("  n·l {} of the first light: k_w = (1 + n·l) / 2\n", brief(t.n_dot_l)) +
               term("tone", product, t.color) + "\n";
    }

    [[nodiscard]] std::string one_light(const ExplainedLight& e) const {
        const Light& light = scene_.lights[static_cast<std::size_t>(e.index)];
        std::string text = fmt::format("{}, {} light", on_one_line(e.name), name_of(light.kind));
        if (!e.samples.empty()) return text + samples(e) + terms(e);
        const std::string reason = dark_reason(e, light);
        text += reason.empty() ? "\n" : fmt::format(" ({})\n", reason);
        text += vector("l", e.l, "to the light") + vector("r", e.r, "l mirrored about n") +
                vector("h", e.h, "halfway from l to v");
        text +=
            fmt::format("  n·l {}   r·v {}   n·h {}", brief(e.n_dot_l), brief(e.r_dot_v), brief(e.n_dot_h));
        if (light.kind != LightKind::Directional) text += "   distance " + brief(e.distance);
        if (light.kind == LightKind::Spot) text += fmt::format("   angle {:.4g}°", e.spot_angle_deg);
        return text + "\n" + terms(e);
    }

    [[nodiscard]] std::string terms(const ExplainedLight& e) const {
        const LightOfEquation in{scene_, e_, e};
        const EquationLine share = share_line(in);
        std::string text = fmt::format("  f = {} = {}\n", written_product(share, 0, result_text),
                                       result_text(share.result.x));
        for (const EquationLine& line : light_lines(in)) text += term(line);
        if (is_clamped(in)) text += term("counts", "the terms together, clamped to 0 to 1", counted_share(e));
        return text;
    }

    static std::string samples(const ExplainedLight& e) {
        std::string text = fmt::format(", {} samples\n", e.samples.size());
        for (std::size_t i = 0; i < e.samples.size(); ++i) {
            const ExplainedLight& s = e.samples[i];
            const std::string line = fmt::format("n·l {:>8}   form {:>9}   {}", brief(s.n_dot_l),
                                                 brief(s.falloff), s.n_dot_l < 0 ? "behind the surface" : "");
            text += term(fmt::format("{:>9}", i + 1), line, s.ambient + s.diffuse + s.specular);
        }
        return text;
    }

    [[nodiscard]] std::string result() const {
        const Display& display = scene_.display;
        const std::string exposed = display.exposure == 1 ? "" : " · exposure " + brief(display.exposure);
        std::string encoded = display.transfer == Transfer::Srgb ? ", sRGB encoded" : "";
        if (scene_.shading.mistakes.encoded_twice)
            encoded += encoded.empty() ? ", sRGB encoded by mistake" : " twice";
        const std::string how = e_.corners.size() > 1 ? "of weight · corner" : "of all terms";
        const std::string what = e_.hit ? how : "the background";
        const ExplainedStroke& s = e_.stroke;
        std::string text = s.coverage > 0 ? stroked(s, what) : term("sum", what, e_.sum);
        text += clips() + term("displayed", "sum" + exposed + encoded, e_.displayed);
        return text + fmt::format("  {:<{}}{:>10}{:>10}{:>10}\n", "byte", product_width + 10, e_.byte[0],
                                  e_.byte[1], e_.byte[2]);
    }

    [[nodiscard]] std::string stroked(const ExplainedStroke& s, std::string_view what) const {
        const std::string blend = fmt::format("{} · shaded + {} · stroke {}", brief(1 - s.coverage),
                                              brief(s.coverage), brief(s.color));
        return term("shaded", what, s.shaded) + term("sum", blend, e_.sum);
    }

    /// The channels that the display clamps, each with its unclamped value.
    [[nodiscard]] std::string clips() const {
        std::string text;
        for (int i = 0; i < 3; ++i) {
            const float shown = exposed(e_.sum[i], scene_.display.exposure);
            if (shown >= 0 && shown <= 1) continue;
            const bool grey = e_.sum.x == e_.sum.y && e_.sum.y == e_.sum.z;
            const char* channel = grey ? "" : i == 0 ? "red " : i == 1 ? "green " : "blue ";
            const std::string as =
                scene_.shading.mistakes.bytes_wrap
                    ? fmt::format("wraps: {} → byte {}", brief(shown), e_.byte[static_cast<std::size_t>(i)])
                    : fmt::format("clips: {} → {}", brief(shown), shown > 1 ? 1 : 0);
            text += fmt::format("            {}{}\n", channel, as);
            if (grey) break;
        }
        return text;
    }

    const Explanation& e_;
    const Scene& scene_;
};

}  // namespace

std::string explain_text(const Explanation& explanation, const Scene& scene) {
    return Writer(explanation, scene).text();
}

}  // namespace glint
