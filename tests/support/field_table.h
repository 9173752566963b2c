#pragma once
// The table in docs/scene_file.md for the fields of a struct, generated from their rows.

#include <fmt/core.h>

#include <set>
#include <string>

#include "models/fields/scene_fields.h"
#include "models/numbers.h"
#include "models/scene_file/scene_file.h"

namespace glint::test {

class FieldTable {
  public:
    /// Adds a line per field; fields of nested structs follow with their paths. `prefix` precedes each key.
    template <class T> void add(const T& value, const std::string& prefix = "") {
        fields(value, [&](const Row& row, const auto& kind, const auto& member) {
            add(prefix + std::string(row.key), row, kind, member);
        });
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    void line(const std::string& key, const std::string& initial, const std::string& range,
              const std::string& help) {
        if (!keys_.insert(key).second) return;  // near and far, which all projections share
        text_ += fmt::format("| `{}` | {} | {} | {} |\n", key, initial, range, help);
    }
    static std::string numbers(const float* v, int size) {
        std::string text;
        for (int i = 0; i < size; ++i) text += (i == 0 ? "" : ", ") + number_text(v[i]);
        return "[" + text + "]";
    }
    template <std::size_t n> static std::string words(const std::array<Choice, n>& rows) {
        std::string text;
        for (const Choice& row : rows) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", row.word);
        return text;
    }
    static std::string meanings(const std::string& help, auto rows) {
        std::string text = help;
        for (const Choice& row : rows)
            text += fmt::format("{} `{}`: {}", &row == rows.data() ? "." : ";", row.word, row.meaning);
        return text;
    }

    void add(const std::string& key, const Row& row, const Text&, const std::string& s) {
        line(key, "\"" + s + "\"", "", row.help);
    }
    void add(const std::string& key, const Row& row, const Path&, const std::string&) {
        line(key, "", "", row.help);
    }
    void add(const std::string& key, const Row& row, const Switch&, bool b) {
        line(key, b ? "true" : "false", "", row.help);
    }
    void add(const std::string& key, const Row& row, const Real& kind, float x) {
        line(key, number_text(x), std::string(kind.range.words), row.help);
    }
    void add(const std::string& key, const Row& row, const Colour&, const glm::vec3& v) {
        line(key, numbers(&v.x, 3), "colour", row.help);
    }
    void add(const std::string& key, const Row& row, const Vector& kind, const glm::vec3& v) {
        line(key, numbers(&v.x, 3), kind.condition, row.help);
    }
    void add(const std::string& key, const Row& row, const Homogeneous&, const glm::vec4& v) {
        line(key, numbers(&v.x, 3), "3 or 4 numbers", row.help);
    }
    void add(const std::string& key, const Row& row, const Count& kind, int n) {
        line(key, fmt::format("{}", n), words_of(kind), row.help);
    }
    template <class E> void add(const std::string& key, const Row& row, const OneOf&, E value) {
        line(key, fmt::format("`{}`", name_of(value)), words(choices<E>), meanings(row.help, choices<E>));
    }
    template <class T> void add(const std::string& key, const Row&, const Group&, const T& value) {
        add(value, key + "/");
    }
    void add(const std::string&, const Row&, const Group&, const Mistakes&) {}  // has its own table
    void add(const std::string& key, const Row& row, const OneProjection&, const Projection& p) {
        line(key + "/type", fmt::format("`{}`", name_of(kind_of(p))), words(choices<ProjectionKind>),
             meanings(row.help, choices<ProjectionKind>));
        add(Perspective{}, key + "/");
        add(Orthographic{}, key + "/");
        add(Frustum{}, key + "/");
    }
    void add(const std::string& key, const Row&, const OneMesh&, const MeshSource&) {
        add(MeshFile{}, key + "/");
        const PrimitiveMesh mesh;
        fields(mesh, [&](const Row& row, const auto&, const auto&) {
            if (row.key == "primitive")
                line(key + "/primitive", fmt::format("`{}`", name_of(mesh.primitive)), "see the list below",
                     row.help);
            else if (row.key == "detail")
                line(key + "/detail", "depends on the primitive", "from 1 to the primitive's maximum",
                     row.help);
        });
    }
    template <class T> void add(const std::string&, const Row&, const List&, const std::vector<T>&) {}

    std::set<std::string> keys_;
    std::string text_;
};

template <class T> std::string field_table(const T& value) {
    FieldTable table;
    table.add(value);
    return "| key | default | range | meaning |\n|---|---|---|---|\n" + table.text();
}

inline std::string primitive_table() {
    std::string text = "| primitive | shape | `detail` d | default | maximum |\n|---|---|---|---|---|\n";
    for (const Primitive p : enumerators<Primitive>) {
        const PrimitiveInfo info = info_of(p);
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", info.choice.word, info.choice.meaning,
                            info.detail_meaning, info.default_detail, info.max_detail);
    }
    return text;
}

}  // namespace glint::test
