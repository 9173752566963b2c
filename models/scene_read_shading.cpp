#include <fmt/core.h>

#include <cmath>

#include "models/mistakes.h"
#include "models/scene_read.h"

namespace glint {
namespace {

constexpr Range crease_range{0, 180, "0 to 180"};

Terms read_terms(const Node& node) {
    Terms t;
    node.allow_keys({"emission", "ambient", "diffuse", "specular"});
    read(node, "emission", t.emission);
    read(node, "ambient", t.ambient);
    read(node, "diffuse", t.diffuse);
    read(node, "specular", t.specular);
    return t;
}

Mistakes read_mistakes(const Node& node) {
    std::vector<std::string> known;
    for (const MistakeName& m : mistake_names()) known.emplace_back(m.name);
    node.allow_keys(known);
    Mistakes mistakes;
    for (const MistakeName& m : mistake_names()) read(node, m.name, mistakes.*m.flag);
    return mistakes;
}

int read_power_table(const Node& node) {
    constexpr std::string_view entries = "0, or 2 to 65536 entries";
    if (!node.value().is_number()) node.wrong_type(std::string(entries));
    const double count = node.value().get<double>();
    if (count != std::floor(count) || count < 0 || count == 1 || count > 65536)
        node.fail(fmt::format("it is {}", count), std::string(entries));
    return static_cast<int>(count);
}

}  // namespace

Shading read_shading(const Node& node) {
    Shading s;
    node.allow_keys({"mode", "reflection", "interpolation", "flat_point", "two_sided", "local_viewer", "cull",
                     "rules", "terms", "power_table", "mistakes"});
    read_enum(node, "mode", s.mode);
    read_enum(node, "reflection", s.reflection);
    read_enum(node, "interpolation", s.interpolation);
    read_enum(node, "flat_point", s.flat_point);
    read(node, "two_sided", s.two_sided);
    read(node, "local_viewer", s.local_viewer);
    read_enum(node, "cull", s.cull);
    read_enum(node, "rules", s.rules);
    node.with("power_table", [&](const Node& at) { s.power_table = read_power_table(at); });
    node.with("terms", [&](const Node& at) { s.terms = read_terms(at); });
    node.with("mistakes", [&](const Node& at) { s.mistakes = read_mistakes(at); });
    return s;
}

Npr read_npr(const Node& node) {
    Npr n;
    node.allow_keys({"cool_to_warm", "cool", "warm", "alpha", "beta", "silhouettes", "creases", "crease_deg",
                     "stroke", "stroke_width_px"});
    read(node, "cool_to_warm", n.cool_to_warm);
    read(node, "cool", n.cool, at_least_zero);
    read(node, "warm", n.warm, at_least_zero);
    read(node, "alpha", n.alpha);
    read(node, "beta", n.beta);
    read(node, "silhouettes", n.silhouettes);
    read(node, "creases", n.creases);
    read(node, "crease_deg", n.crease_deg, crease_range);
    read(node, "stroke", n.stroke, at_least_zero);
    read(node, "stroke_width_px", n.stroke_width_px, at_least_zero);
    return n;
}

Display read_display(const Node& node) {
    Display d;
    node.allow_keys({"background", "transfer", "exposure"});
    read(node, "background", d.background, at_least_zero);
    read_enum(node, "transfer", d.transfer);
    read(node, "exposure", d.exposure, above_zero);
    return d;
}

}  // namespace glint
