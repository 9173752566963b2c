#include <fmt/format.h>

#include <string_view>

#include "models/fields/choices.h"
#include "models/problem.h"
#include "renderer/inspect/explain/explain_format.h"

namespace glint {
namespace {

/// LaTeX's special characters stand for themselves, and a name stays on its line: an empty one would end the
/// equation.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : on_one_line(text)) {
        switch (c) {
        case '<':  // in LaTeX's first font encoding these three are other characters
            out += "\\textless{}";
            break;
        case '>':
            out += "\\textgreater{}";
            break;
        case '|':
            out += "\\textbar{}";
            break;
        case '\\':
            out += "\\textbackslash{}";
            break;
        case '~':
            out += "\\textasciitilde{}";
            break;
        case '^':
            out += "\\textasciicircum{}";
            break;
        case '#':
        case '$':
        case '%':
        case '&':
        case '_':
        case '{':
        case '}':
            out += '\\';
            [[fallthrough]];
        default:
            out += c;
        }
    }
    return out;
}

/// Four significant digits; an exponent as a power of ten.
std::string number(float x) {
    std::string text = fmt::format("{:.4g}", x);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    return fmt::format("{} \\cdot 10^{{{}}}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string column(glm::vec3 v) {
    if (v.x == v.y && v.y == v.z) return number(v.x);
    return fmt::format("\\begin{{pmatrix}} {} \\\\ {} \\\\ {} \\end{{pmatrix}}", number(v.x), number(v.y),
                       number(v.z));
}

std::string row(std::string_view left, std::string_view right) {
    return fmt::format("{} &= {} \\\\\n", left, right);
}

/// The specular factor S as its model writes it.
std::string highlight(const Explanation& e, const ExplainedLight& light) {
    const ReflectionInfo info = info_of(e.reflection);
    if (!info.uses_shininess()) return "S";
    const std::string power = fmt::format("^{{{}}}", number(e.material.shininess));
    std::string formula = fmt::format("({}){}", info.highlight_latex, power);
    if (info.cosine == HighlightCosine::LV) return formula;
    const float cosine = info.cosine == HighlightCosine::RV ? light.r_dot_v : light.n_dot_h;
    return fmt::format("{} = ({}){}", formula, number(cosine), power);
}

std::string light_rows(const Explanation& e, const ExplainedLight& light, const Light& source,
                       std::size_t i) {
    const std::string index = "_{" + std::to_string(i + 1) + "}";
    std::string text = fmt::format("&\\text{{{}, {}}} \\\\\n", escaped(light.name), name_of(source.kind));
    if (light.samples.empty()) {
        text += row("n \\cdot l" + index, number(light.n_dot_l));
        if (light.falloff != 1 || light.spot != 1 || source.intensity != 1)
            text += row("f" + index, fmt::format("{} \\cdot {} \\cdot {}", number(light.falloff),
                                                 number(light.spot), number(source.intensity)));
        if (info_of(e.reflection).has_highlight)
            text += row("S" + index, highlight(e, light) + " = " + column(light.specular_factor));
    }
    text += row(fmt::format("f{0} \\, k_a A{0}", index), column(light.ambient));
    text +=
        row(fmt::format("f{0} \\, k_d D{0} \\langle n \\cdot l{0} \\rangle", index), column(light.diffuse));
    return text + row(fmt::format("f{0} \\, k_s S{0}", index), column(light.specular));
}

std::string equation(const Explanation& e, const ExplainedPoint& at, const Scene& scene) {
    std::string text = "\\begin{align*}\n";
    if (at.cool_to_warm.used) {
        text +=
            row("k_w", fmt::format("\\tfrac{{1}}{{2}} (1 + n \\cdot l) = {}", number(at.cool_to_warm.k_w)));
        text += row("c", "k_w c_w + (1 - k_w) c_c = " + column(at.cool_to_warm.color));
    } else {
        text += row("k_e", column(at.emission)) + row("k_a I_a", column(at.global_ambient));
    }
    for (std::size_t i = 0; i < at.lights.size(); ++i)
        text += light_rows(e, at.lights[i], scene.lights[static_cast<std::size_t>(at.lights[i].index)], i);
    return text + fmt::format("I &= {}\n\\end{{align*}}\n", column(at.sum));
}

std::string place(const ExplainedPoint& at) {
    return fmt::format("\\[ p = {}, \\quad n = {}, \\quad v = {} \\]\n", column(at.point.camera),
                       column(at.normal.camera), column(at.view.camera));
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
            "\\paragraph{{Pixel {}, {}: {}, face {}; {} shading, {} reflection}} Camera coordinates.\n", e.x,
            e.y, escaped(e.object), e.face, name_of(e.mode), name_of(e.reflection));
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
