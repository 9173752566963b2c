#include "models/scene_file/read_scene.h"

#include <fmt/core.h>

#include <cmath>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/utf8.h"

namespace glint {
namespace {

template <class T> std::vector<std::string> keys_of(T& value) {
    std::vector<std::string> keys;
    fields(value, [&keys](const Row& row, const auto&, const auto&) { keys.emplace_back(row.key); });
    return keys;
}

/// Reads an enumerator by its word in the scene file.
template <class Enum> void read_enum(const Node& object, std::string_view key, Enum& to) {
    object.with(key, [&to](const Node& node) {
        const std::vector<std::string> names = names_of<Enum>();
        const std::string& name = text(node, listed(names));
        const std::optional<Enum> value = from_name<Enum>(name);
        if (!value) node.fail(in_quotes(name) + " is not known", listed(names));
        to = *value;
    });
}

/// Fails if the value breaks a condition on its numbers.
template <class T> void check(const Node& node, const T& value) {
    if constexpr (requires { violation_of(value); })
        if (std::optional<Problem> found = violation_of(value))
            throw ProblemFound(
                {"", node.pointer() + found->pointer, std::move(found->what), std::move(found->expected)});
}

MeshFile read_mesh_file(const Node& node) {
    const std::string& path = text(node, "the name of a mesh file");
    if (path.empty()) node.fail("an empty file name", "the name of a mesh file");
    if (path.find('\0') != std::string::npos)
        node.fail("a file name with a zero byte", "the name of a mesh file");
    return {unescaped_bytes(path)};
}

int read_count(const Node& node, const Count& count) {
    const std::string expected = words_of(count);
    if (!node.value().is_number()) node.wrong_type(expected);
    const double x = node.value().get<double>();
    if (x != std::floor(x)) node.fail(fmt::format("{} is not a whole number", x), expected);
    if (!count.contains(x)) node.fail(fmt::format("{} is out of range", x), expected);
    return static_cast<int>(x);
}

/// Reads four numbers, or three numbers and takes w from the light's type.
glm::vec4 read_homogeneous(const Node& node, const Homogeneous& kind) {
    const std::vector<double> p = numbers(node, 3, 4);
    const double w = p.size() == 4 ? p[3] : (kind.is_direction() ? 0 : 1);
    if (const auto found = violation_of_w(kind.kind, w)) node.fail(found->what, found->expected);
    const glm::dvec4 position(p[0], p[1], p[2], w);
    if (const auto found = violation_of_division(position)) node.fail(found->what, found->expected);
    return divided_by_w(position);
}

class Reader;
template <class T> void read_members(const Node& node, T& value);

/// Reads the fields of one object of the document.
class Reader {
  public:
    explicit Reader(const Node& object) : object_(object) {}

    void operator()(const Row& row, const Text& kind, std::string& to) const {
        read(object_, row.key, to, kind.max_characters);
    }
    void operator()(const Row& row, const Switch&, bool& to) const { read(object_, row.key, to); }
    void operator()(const Row& row, const Real& real, float& to) const {
        read(object_, row.key, to, real.range);
    }
    void operator()(const Row& row, const Colour&, glm::vec3& to) const {
        read(object_, row.key, to, at_least_zero);
    }
    void operator()(const Row& row, const Vector&, glm::vec3& to) const { read(object_, row.key, to); }
    void operator()(const Row& row, const Homogeneous& kind, glm::vec4& to) const {
        to.w = kind.is_direction() ? 0.0f : 1.0f;
        object_.with(row.key, [&](const Node& at) { to = read_homogeneous(at, kind); });
    }
    template <class E> void operator()(const Row& row, const OneOf&, E& to) const {
        read_enum(object_, row.key, to);
    }
    void operator()(const Row& row, const Count& count, int& to) const {
        object_.with(row.key, [&](const Node& at) { to = read_count(at, count); });
    }
    void operator()(const Row& row, const Path&, std::string& to) const {
        object_.with(row.key, [&](const Node& at) { to = read_mesh_file(at).path; });
    }
    template <class T> void operator()(const Row& row, const Group&, T& to) const {
        object_.with(row.key, [&](const Node& at) { read_members(at, to); });
    }
    template <class T> void operator()(const Row& row, const List& list, std::vector<T>& to) const {
        object_.with(row.key, [&](const Node& at) {
            at.each(list.max, list.plural,
                    [&](const Node& element) { read_members(element, to.emplace_back()); });
        });
    }
    void operator()(const Row& row, const OneProjection&, Projection& to) const;
    void operator()(const Row& row, const OneMesh&, MeshSource& to) const;

  private:
    const Node& object_;
};

template <class T> void read_members(const Node& node, T& value) {
    node.allow_keys(keys_of(value));
    fields(value, Reader(node));
    check(node, value);
}

/// Rejects keys of other projections: they are known, but would have no effect here.
void refuse_keys_of_others(const Node& node, ProjectionKind kind) {
    const std::vector<std::string> keys = projection_keys(kind);
    for (std::size_t other = 0; other < count_of<ProjectionKind>(); ++other)
        for (const std::string& key : projection_keys(static_cast<ProjectionKind>(other))) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
            node.with(key, [&](const Node& at) {
                at.fail(fmt::format("not a key of the projection \"{}\"", name_of(kind)), listed(keys));
            });
        }
}

void Reader::operator()(const Row& row, const OneProjection&, Projection& to) const {
    object_.with(row.key, [&](const Node& node) {
        if (!node.value().is_object()) node.wrong_type("an object");
        auto kind = ProjectionKind::Perspective;
        read_enum(node, "type", kind);
        refuse_keys_of_others(node, kind);
        node.allow_keys(projection_keys(kind));
        to = default_projection(kind);
        if (kind == ProjectionKind::Frustum)
            for (const std::string& key : projection_keys(kind))
                if (!node.has(key))
                    node.fail(fmt::format("\"{}\" is missing", key), "all six numbers of a frustum");
        fields(to, Reader(node));
    });
}

/// Rejects unknown keys, and keys of a primitive mixed with keys of a file.
void allow_keys_of_one_mesh(const Node& node) {
    MeshFile file;
    PrimitiveMesh primitive;
    const bool is_file = node.has("file");
    const std::vector<std::string> own = is_file ? keys_of(file) : keys_of(primitive),
                                   others = is_file ? keys_of(primitive) : keys_of(file);
    std::vector<std::string> keys = own;
    keys.insert(keys.end(), others.begin(), others.end());
    node.allow_keys(keys);
    if (is_file && node.has("primitive")) node.fail("both \"file\" and \"primitive\"", "one of the two");
    for (const std::string& key : others)
        if (node.has(key) && std::find(own.begin(), own.end(), key) == own.end())
            node.fail(fmt::format("\"{}\" {} \"file\"", key, is_file ? "together with" : "without"),
                      is_file ? "it for a primitive only" : "it for a file only");
}

void Reader::operator()(const Row& row, const OneMesh&, MeshSource& to) const {
    object_.with(row.key, [&](const Node& node) {
        PrimitiveMesh primitive;
        MeshFile file;
        allow_keys_of_one_mesh(node);
        if (node.has("file")) {
            fields(file, Reader(node));
            to = file;
            return;
        }
        read_enum(node, "primitive", primitive.primitive);
        primitive.detail = info_of(primitive.primitive).default_detail;
        fields(primitive, Reader(node));
        to = primitive;
    });
}

void check_version(const Node& root) {
    if (!root.value().is_object()) root.wrong_type("an object, such as {\"glint\": 1}");
    if (!root.has("glint"))
        root.fail("the key \"glint\" is missing", "\"glint\": 1, the version of the format");
    root.with("glint", [](const Node& version) {
        if (!version.value().is_number()) version.wrong_type("1, the version of the format");
        const double number = version.value().get<double>();
        if (number != 1) version.fail(fmt::format("version {} is not known", number), "1");
    });
}

}  // namespace

Projection default_projection(ProjectionKind kind) {
    switch (kind) {
    case ProjectionKind::Perspective:
        return Perspective{};
    case ProjectionKind::Orthographic:
        return Orthographic{};
    case ProjectionKind::Frustum:
        return Frustum{};
    }
    return {};  // not reached
}

std::vector<std::string> projection_keys(ProjectionKind kind) {
    Projection projection = default_projection(kind);
    std::vector<std::string> keys = keys_of(projection);
    keys.insert(keys.begin(), "type");
    return keys;
}

Scene read_scene(const Node& root) {
    Scene scene;
    check_version(root);
    std::vector<std::string> keys = keys_of(scene);
    keys.insert(keys.begin(), "glint");
    root.allow_keys(keys);
    fields(scene, Reader(root));
    return scene;
}

}  // namespace glint
