// A scene as text, laid out as a person would: one line for what belongs together.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

#include "models/mistakes.h"
#include "models/scene_file.h"
#include "models/scene_names.h"
#include "models/utf8.h"

namespace glint {
namespace {

/// The shortest decimals that read back as the same float. The reader goes by way of a double, which for a
/// few floats (7.0385307e-26 is one) rounds the shortest decimals of the float to its neighbour: those get
/// more digits.
std::string number_text(float x) {
    if (x == 0 && std::signbit(x)) return "-0.0";  // "-0" is a whole number, which has no sign
    std::string text = fmt::format("{}", x);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return static_cast<float>(read) == x ? text : fmt::format("{}", static_cast<double>(x));
}

std::string text_of(float x) { return number_text(x); }
std::string text_of(int x) { return fmt::format("{}", x); }
std::string text_of(bool b) { return b ? "true" : "false"; }
std::string text_of(const glm::vec3& v) {
    return fmt::format("[{}, {}, {}]", number_text(v.x), number_text(v.y), number_text(v.z));
}
std::string text_of(const glm::vec4& v) {
    return fmt::format("[{}, {}, {}, {}]", number_text(v.x), number_text(v.y), number_text(v.z),
                       number_text(v.w));
}

/// A JSON string; bytes that are no UTF-8 become U+FFFD.
std::string text_of(std::string_view raw) {
    std::string text = "\"";
    for (std::size_t i = 0; i < raw.size();) {
        const std::size_t length = utf8_length(raw.substr(i, 4));
        const char c = raw[i];
        if (length == 0)
            text += "\uFFFD";
        else if (c == '"' || c == '\\')
            text.append(1, '\\').append(1, c);
        else if (c == '\n')
            text += "\\n";
        else if (c == '\t')
            text += "\\t";
        else if (static_cast<unsigned char>(c) < 0x20 || c == '\x7f')
            text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            text += raw.substr(i, length);
        i += std::max<std::size_t>(1, length);
    }
    return text + "\"";
}

/// `"key": value`
template <class T> std::string member(std::string_view key, const T& value) {
    return fmt::format("\"{}\": {}", key, text_of(value));
}
template <class... Members> std::string object(const Members&... members) {
    std::string text;
    ((text += (text.empty() ? "{" : ", ") + members), ...);
    return text + "}";
}
std::string named(std::string_view key, const std::string& json) {
    return fmt::format("\"{}\": {}", key, json);
}

std::string projection_text(const Projection& projection) {
    const std::string type = member("type", name_of(projection));
    const std::string near = member("near", near_of(projection)), far = member("far", far_of(projection));
    if (const auto* p = std::get_if<Perspective>(&projection))
        return object(type, member("fov_y_deg", p->fov_y_deg), near, far);
    if (const auto* p = std::get_if<Orthographic>(&projection))
        return object(type, member("height", p->height), near, far);
    const auto& p = std::get<Frustum>(projection);
    return object(type, member("left", p.left), member("right", p.right), member("bottom", p.bottom),
                  member("top", p.top), near, far);
}

std::string camera_text(const Camera& c) {
    return fmt::format("  \"camera\": {{\n    {}, {}, {},\n    {}\n  }}", member("eye", c.eye),
                       member("target", c.target), member("up", c.up),
                       named("projection", projection_text(c.projection)));
}

std::string light_text(const Light& l) {
    const std::string falloff =
        object(member("constant", l.falloff.constant), member("linear", l.falloff.linear),
               member("quadratic", l.falloff.quadratic));
    const std::string spot =
        object(member("direction", l.spot.direction), member("cutoff_deg", l.spot.cutoff_deg),
               member("exponent", l.spot.exponent));
    const std::string area = object(member("edge_u", l.area.edge_u), member("edge_v", l.area.edge_v),
                                    member("samples", l.area.samples));
    return fmt::format(
        "    {{{}, {}, {}, {},\n     {}, {}, {}, {}, {},\n     {},\n     {},\n     {}}}",
        member("name", std::string_view(l.name)), member("type", name_of(l.kind)),
        member("space", name_of(l.space)), member("position", l.position), member("ambient", l.ambient),
        member("diffuse", l.diffuse), member("specular", l.specular), member("intensity", l.intensity),
        member("enabled", l.enabled), named("falloff", falloff), named("spot", spot), named("area", area));
}

std::string source_text(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source))
        return object(member("file", std::string_view(escaped_bytes(file->path))));
    const auto& mesh = std::get<PrimitiveMesh>(source);
    return object(member("primitive", name_of(mesh.primitive)), member("detail", mesh.detail));
}

std::string object_text(const Object& o) {
    const Material& m = o.material;
    const std::string transform =
        object(member("translate", o.transform.translate), member("rotate_deg", o.transform.rotate_deg),
               member("scale", o.transform.scale));
    const std::string normals =
        object(member("source", name_of(o.normals.source)), member("weighting", name_of(o.normals.weighting)),
               member("crease_deg", o.normals.crease_deg));
    const std::string material = fmt::format(
        "{{{}, {}, {},\n                  {}, {}, {}, {}}}", member("ambient", m.ambient),
        member("diffuse", m.diffuse), member("specular", m.specular), member("emission", m.emission),
        member("shininess", m.shininess), member("roughness", m.roughness), member("f0", m.f0));
    return fmt::format("    {{{}, {},\n     {},\n     {},\n     {}}}",
                       member("name", std::string_view(o.name)), named("mesh", source_text(o.source)),
                       named("transform", transform), named("normals", normals), named("material", material));
}

/// `"key": []`, or one element a line.
template <class T>
std::string list_text(std::string_view key, const std::vector<T>& elements,
                      std::string (*element_text)(const T&)) {
    std::string text;
    for (const T& element : elements) text += (text.empty() ? "\n" : ",\n") + element_text(element);
    return fmt::format("  \"{}\": [{}{}]", key, text, elements.empty() ? "" : "\n  ");
}

/// Only those that are made: the rest is the default, and a list of 21 times false helps nobody.
std::string mistakes_text(const Mistakes& mistakes) {
    std::string text;
    for (const MistakeName& m : mistake_names())
        if (mistakes.*m.flag) text += fmt::format("{}\"{}\": true", text.empty() ? "" : ", ", m.name);
    return text;
}

/// Only when there is one: most scenes have none, and programs of other makers need not know it.
std::string power_table_text(int entries) {
    return entries == 0 ? "" : fmt::format("{}, ", member("power_table", entries));
}

std::string shading_text(const Shading& s) {
    const std::string terms =
        object(member("emission", s.terms.emission), member("ambient", s.terms.ambient),
               member("diffuse", s.terms.diffuse), member("specular", s.terms.specular));
    return fmt::format(
        "  \"shading\": {{\n    {}, {}, {},\n    {}, {}, {}, {}, {},\n    {},\n    {}\"mistakes\": {{{}}}\n  "
        "}}",
        member("mode", name_of(s.mode)), member("reflection", name_of(s.reflection)),
        member("interpolation", name_of(s.interpolation)), member("flat_point", name_of(s.flat_point)),
        member("two_sided", s.two_sided), member("local_viewer", s.local_viewer),
        member("cull", name_of(s.cull)), member("rules", name_of(s.rules)), named("terms", terms),
        power_table_text(s.power_table), mistakes_text(s.mistakes));
}

std::string npr_text(const Npr& n) {
    return fmt::format("  \"npr\": {{\n    {}, {}, {}, {}, {},\n    {}, {}, {}, {}, {}\n  }}",
                       member("cool_to_warm", n.cool_to_warm), member("cool", n.cool), member("warm", n.warm),
                       member("alpha", n.alpha), member("beta", n.beta), member("silhouettes", n.silhouettes),
                       member("creases", n.creases), member("crease_deg", n.crease_deg),
                       member("stroke", n.stroke), member("stroke_width_px", n.stroke_width_px));
}

}  // namespace

std::string scene_text(const Scene& scene) {
    const std::string display = object(member("background", scene.display.background),
                                       member("transfer", name_of(scene.display.transfer)),
                                       member("exposure", scene.display.exposure));
    return fmt::format("{{\n  \"glint\": 1,\n{},\n  {},\n{},\n{},\n{},\n{},\n  {}\n}}\n",
                       camera_text(scene.camera), member("global_ambient", scene.global_ambient),
                       list_text("lights", scene.lights, light_text),
                       list_text("objects", scene.objects, object_text), shading_text(scene.shading),
                       npr_text(scene.npr), named("display", display));
}

}  // namespace glint
