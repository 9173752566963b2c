#include <fmt/format.h>

#include <string_view>

#include "models/fields/choices.h"
#include "models/utf8.h"
#include "renderer/explain/equation_text.h"

namespace glint {
namespace {

/// Writes the exponent of a number as a power of ten.
std::string with_power(const std::string& text) {
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}
/// Four significant digits.
std::string plain_number(double x) { return fmt::format("{:.4g}", static_cast<float>(x)); }
std::string number(float x) { return with_power(plain_number(double(x))); }

/// Three channels stacked vertically, or a single number if all have the same text.
template <class Text> std::string column(glm::dvec3 v, const Text& text) {
    std::string red = text(v.x);
    const std::string green = text(v.y), blue = text(v.z);
    if (red == green && green == blue) return red;
    return fmt::format("\\begin{{pmatrix}} {} \\\\ {} \\\\ {} \\end{{pmatrix}}", red, green, blue);
}
std::string column(glm::vec3 v) {
    return column(glm::dvec3(v), [](double x) { return number(static_cast<float>(x)); });
}

std::string row(std::string_view left, std::string_view right) {
    return fmt::format("{} &= {} \\\\\n", left, right);
}

std::string symbol_of(const EquationFactor& f, const std::string& index) {
    std::string text = row_of(f.quantity).latex;
    if (f.quantity == Quantity::Share) text += "_{" + index + "}";
    if (f.is_mean) text = fmt::format("\\overline{{{}}}", text);
    if (f.power) return fmt::format("({})^n", text);
    return is_cosine(f.quantity) ? fmt::format("\\langle {} \\rangle", text) : text;
}

std::string value_of(const EquationFactor& f, int decimals, int exponent_decimals) {
    if (f.quantity == Quantity::QuarterPi) return row_of(f.quantity).latex;
    std::string value = column(f.value, [&](double x) { return with_power(short_text(x, decimals)); });
    if (!f.power) return value;
    return fmt::format("({})^{{{}}}", value, with_power(short_text(f.power->exponent, exponent_decimals)));
}

/// The reason for omitting a term, with the dot as a text character.
std::string left_out(const EquationLine& line) {
    std::string text = latex_escaped(line.left_out);
    const std::string dot = "·";
    const std::size_t at = text.find(dot);
    return at == std::string::npos
               ? text
               : text.substr(0, at) + "\\textperiodcentered{}" + text.substr(at + dot.size());
}

/// "letters &= numbers = result"; a term that is left out has the reason at the end.
std::string row(const EquationLine& line, const std::string& index) {
    const LineDecimals decimals = written_decimals(line, std::nullopt, plain_number);
    std::string letters, numbers;
    for (std::size_t i = 0; i < line.factors.size(); ++i) {
        const EquationFactor& f = line.factors[i];
        letters += (i == 0 ? "" : f.divides ? " / " : " \\, ") + symbol_of(f, index);
        numbers += (i == 0      ? ""
                    : f.divides ? " / "
                                : " \\cdot ") +
                   value_of(f, decimals.value[i], decimals.exponent[i]);
    }
    const glm::vec3 product(line.product(0), line.product(1), line.product(2));
    const bool counts = line.left_out.empty();
    const std::string end = counts ? "" : fmt::format(" \\quad \\text{{{}}}", left_out(line));
    const std::string result = column(counts ? glm::vec3(line.result) : product);
    return row(letters, (numbers == result ? numbers : numbers + " = " + result) + end);
}

std::string light_rows(const Explanation& e, const ExplainedLight& light, const Scene& scene, std::size_t i) {
    const Light& source = scene.lights[static_cast<std::size_t>(light.index)];
    const std::string index = std::to_string(i + 1);
    const std::string dark = light.reached < 1 ? ", " + dark_reason(light, source) : "";
    std::string text = fmt::format("&\\text{{{}, {}{}}} \\\\\n", latex_escaped(light.name),
                                   name_of(source.kind), latex_escaped(dark));
    const LightOfEquation in{scene, e, light};
    const EquationLine share = share_line(in);
    text += fmt::format("f_{{{}}} = ", index) + row(share, index);
    for (const EquationLine& line : light_lines(in)) text += row(line, index);
    if (is_clamped(in)) text += row("\\text{the terms together, clamped}", column(counted_share(light)));
    return text;
}

std::string equation(const Explanation& e, const ExplainedPoint& at, const Scene& scene) {
    std::string text = "\\begin{align*}\n";
    if (at.cool_to_warm.used) {
        text += row("k_w", fmt::format("\\tfrac{{1}}{{2}} (1 + \\mathbf{{n}} \\cdot \\mathbf{{l}}) = {}",
                                       number(at.cool_to_warm.k_w)));
        text += row("k_w \\, \\text{warm} + (1 - k_w) \\, \\text{cool}", column(at.cool_to_warm.color));
    } else {
        for (const EquationLine& line : unlit_lines(scene, e, at)) text += row(line, "");
    }
    for (std::size_t i = 0; i < at.lights.size(); ++i) text += light_rows(e, at.lights[i], scene, i);
    return text + fmt::format("I &= {}\n\\end{{align*}}\n", column(at.sum));
}

std::string place(const ExplainedPoint& at) {
    return fmt::format("\\[ \\mathbf{{p}} = {}, \\quad \\mathbf{{n}} = {}, \\quad \\mathbf{{v}} = {} \\]\n",
                       column(at.point.camera), column(at.normal.camera), column(at.view.camera));
}

std::string lit_points(const Explanation& e, const Scene& scene) {
    if (!info_of(e.reflection).is_lit) return "No lighting: the mesh's own colour.\n";
    if (!e.lit_per_corner) return place(e.at) + equation(e, e.at, scene);
    std::string text, mix;
    for (std::size_t i = 0; i < e.corners.size(); ++i) {
        const ExplainedCorner& c = e.corners[i];
        text += fmt::format("Corner {} of weight ${}$:\n", i + 1, number(c.weight));
        text += place(c.at) + equation(e, c.at, scene);
        mix += fmt::format("{}{} \\cdot {}", i == 0 ? "" : " + ", number(c.weight), column(c.at.sum));
    }
    return text + fmt::format("\\[ I = {} = {} \\]\n", mix, column(e.sum));
}

}  // namespace

std::string explain_latex(const Explanation& e, const Scene& scene) {
    std::string text = fmt::format("% glint explain, pixel {}, {}; needs amsmath\n", e.x, e.y);
    if (e.hit) {
        text += fmt::format(
            "\\paragraph{{Pixel {}, {}: {}, face {}, {}; {} shading, {} reflection}} Camera coordinates.\n",
            e.x, e.y, latex_escaped(e.object), e.face, side_words(e), name_of(e.mode), name_of(e.reflection));
        text += lit_points(e, scene);
    } else {
        text += fmt::format("\\paragraph{{Pixel {}, {}: background}}\n", e.x, e.y);
    }
    if (e.stroke.coverage > 0)
        text += fmt::format("\\[ I = (1 - {0}) \\cdot {1} + {0} \\cdot {2} \\]\n", number(e.stroke.coverage),
                            column(e.stroke.shaded), column(e.stroke.color));
    return text +
           fmt::format("\\[ I = {} \\quad \\text{{displayed }} {} \\quad \\text{{bytes }} ({}, {}, {}) \\]\n",
                       column(e.sum), column(e.displayed), e.byte[0], e.byte[1], e.byte[2]);
}

}  // namespace glint
