// Writes a scene as text, by its fields, with related values on one line.
#include <fmt/format.h>

#include <array>

#include "models/fields/scene_fields.h"
#include "models/json/json.h"
#include "models/numbers.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"

namespace glint {
namespace {

/// Where an object's text is broken into lines.
struct Layout {
    std::string_view open = "{", new_line = "", close = "}";
    std::array<std::string_view, 8> break_before = {};  // keys that start a line
};

// Structs not listed here are written on one line.
template <class T> constexpr Layout layout_of(const T&) { return {}; }
constexpr Layout layout_of(const Camera&) { return {"{\n    ", "\n    ", "\n  }", {"projection"}}; }
constexpr Layout layout_of(const Light&) {
    return {"{", "\n     ", "}", {"ambient", "falloff", "spot", "area"}};
}
constexpr Layout layout_of(const Object&) {
    return {"{", "\n     ", "}", {"transform", "normals", "material"}};
}
constexpr Layout layout_of(const Material&) { return {"{", "\n                  ", "}", {"emission"}}; }
constexpr Layout layout_of(const Shading&) {
    return {"{\n    ", "\n    ", "\n  }", {"flat_point", "terms", "power_table"}};
}
constexpr Layout layout_of(const Npr&) { return {"{\n    ", "\n    ", "\n  }", {"silhouettes"}}; }
constexpr Layout layout_of(const Scene&) {
    return {"{\n  \"glint\": 1,\n  ",
            "\n  ",
            "\n}\n",
            {"camera", "global_ambient", "lights", "objects", "shading", "transport", "npr", "display"}};
}

template <class T> std::string text_of(const T& value);

std::string text_of_value(const Text&, const std::string& s) { return json_string(s); }
std::string text_of_value(const Path&, const std::string& s) { return json_string(escaped_bytes(s)); }
std::string text_of_value(const Switch&, bool b) { return b ? "true" : "false"; }
std::string text_of_value(const Real&, float x) { return number_text(x); }
std::string text_of_value(const Count&, int n) { return fmt::format("{}", n); }
std::string vector_text(const float* v, int size) {
    std::string text;
    for (int i = 0; i < size; ++i) text += (i == 0 ? "" : ", ") + number_text(v[i]);
    return "[" + text + "]";
}
std::string text_of_value(const Colour&, const glm::vec3& v) { return vector_text(&v.x, 3); }
std::string text_of_value(const Vector&, const glm::vec3& v) { return vector_text(&v.x, 3); }
std::string text_of_value(const Homogeneous&, const glm::vec4& v) { return vector_text(&v.x, 4); }
template <class E> std::string text_of_value(const OneOf&, E value) { return json_string(name_of(value)); }
template <class T> std::string text_of_value(const Group&, const T& value) { return text_of(value); }
std::string text_of_value(const OneProjection&, const Projection& p) {
    std::string text = std::visit([](const auto& one) { return text_of(one); }, p);
    return text.insert(1, fmt::format("\"type\": \"{}\", ", name_of(kind_of(p))));
}
std::string text_of_value(const OneMesh&, const MeshSource& m) {
    return std::visit([](const auto& one) { return text_of(one); }, m);
}
/// One element per line.
template <class T> std::string text_of_value(const List&, const std::vector<T>& elements) {
    if (elements.empty()) return "[]";
    std::string text;
    for (const T& element : elements) text += (text.empty() ? "\n    " : ",\n    ") + text_of(element);
    return "[" + text + "\n  ]";
}

template <class T> std::string text_of(const T& value) {
    const Layout layout = layout_of(value);
    std::string text;
    // A new line also starts if the key that should start it is omitted.
    bool breaks = false;
    fields_with_defaults(value,
                         [&](const Row& row, const auto& kind, const auto& member, const auto& initial) {
                             for (const std::string_view key : layout.break_before) breaks |= key == row.key;
                             if (row.omit_default && member == initial) return;
                             if (!text.empty()) text += breaks ? fmt::format(",{}", layout.new_line) : ", ";
                             text += fmt::format("\"{}\": {}", row.key, text_of_value(kind, member));
                             breaks = false;
                         });
    return fmt::format("{}{}{}", layout.open, text, layout.close);
}

}  // namespace

std::string scene_text(const Scene& scene) { return text_of(scene); }

}  // namespace glint
