// Reads a scene from a JSON document, by its fields (models/fields/scene_fields.h), and applies assignments
// to the document first.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"

namespace glint {
namespace {

template <class T> std::vector<std::string> keys_of(T& value) {
    std::vector<std::string> keys;
    fields(value, [&keys](const Row& row, const auto&, const auto&) { keys.emplace_back(row.key); });
    return keys;
}

/// The default projection of that kind.
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

/// The keys of a projection of that type, `type` first.
std::vector<std::string> projection_keys(ProjectionKind kind) {
    Projection projection = default_projection(kind);
    std::vector<std::string> keys = keys_of(projection);
    keys.insert(keys.begin(), "type");
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

/// Reads four numbers, or reads three and takes w from the light's type.
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
                      is_file ? "this key only for a primitive" : "this key only for a file");
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

/// The scene of a document of version 1. A missing key keeps its default.
Scene read_scene(const Node& root) {
    Scene scene;
    check_version(root);
    std::vector<std::string> keys = keys_of(scene);
    keys.insert(keys.begin(), "glint");
    root.allow_keys(keys);
    fields(scene, Reader(root));
    return scene;
}

// `--set /pointer=JSON`: assignments to a document before it is checked (docs/command_line.md, "Changing a
// scene").

using Tokens = std::vector<std::string>;

[[noreturn]] void fail(const std::string& pointer, std::string what, std::string expected) {
    throw ProblemFound({"--set", pointer, std::move(what), std::move(expected)});
}

/// "/a~1b/0" -> "a/b", "0" (RFC 6901, section 4).
Tokens tokens_of(const std::string& pointer) {
    Tokens tokens;
    if (first_invalid_utf8(pointer) < pointer.size()) fail(pointer, "the pointer is not UTF-8", "UTF-8 text");
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            tokens.emplace_back();
        } else if (pointer[i] == '~') {
            const char next = i + 1 < pointer.size() ? pointer[++i] : '\0';
            if (next != '0' && next != '1')
                fail(pointer, "a ~ in the pointer is not followed by 0 or 1", "~0 for ~, ~1 for /");
            tokens.back() += next == '0' ? '~' : '/';
        } else {
            tokens.back() += pointer[i];
        }
    }
    if (tokens.size() > max_json_depth)
        fail(pointer, "the pointer is too deep", fmt::format("at most {} steps", max_json_depth));
    return tokens;
}

bool is_word(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto later = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
    return !text.empty() && letter(text.front()) && std::all_of(text.begin() + 1, text.end(), later);
}

Json value_of(const Assignment& a) {
    try {
        return parsed_json(a.json, "--set");
    } catch (const NotJson& found) {
        if (is_word(a.json)) return a.json;
        fail(a.pointer,
             fmt::format("{} is neither JSON nor a word: {}", in_quotes(a.json), found.problem.what),
             "a JSON value such as 2, [1, 2, 3] or \"text\"; or a word");
    } catch (const ProblemFound& found) {
        fail(a.pointer + found.problem.pointer, found.problem.what, found.problem.expected);
    }
}

/// The initial value of a missing parent: an empty list, the default numbers of a vector, or an empty object.
class MissingParent {
  public:
    explicit MissingParent(const Tokens& path) : path_(path) {}

    [[nodiscard]] Json made() const {
        Scene scene;
        Json found = Json::object();
        descend(scene, 0, found);
        return found;
    }

  private:
    template <class T> void descend(const T& value, std::size_t step, Json& found) const {
        fields(value, [&](const Row& row, const auto& kind, const auto& member) {
            if (row.key == path_[step]) at(kind, member, step + 1, found);
        });
    }
    /// The member at the first `step` tokens.
    template <class Kind> void at(const Kind&, const glm::vec3& v, std::size_t step, Json& found) const {
        if (step == path_.size()) found = Json::array({v.x, v.y, v.z});
    }
    /// Omits w, which the light's type determines.
    void at(const Homogeneous& kind, const glm::vec4& v, std::size_t step, Json& found) const {
        at(kind, glm::vec3(v), step, found);
    }
    template <class T> void at(const List&, const std::vector<T>&, std::size_t step, Json& found) const {
        if (step == path_.size()) found = Json::array();
        if (step + 1 < path_.size()) descend(T{}, step + 1, found);  // skip the element's number
    }
    template <class T> void at(const Group&, const T& value, std::size_t step, Json& found) const {
        if (step < path_.size()) descend(value, step, found);
    }
    template <class Kind, class T> void at(const Kind&, const T&, std::size_t, Json&) const {}

    const Tokens& path_;
};

/// The index of an element, or one past the last, which may also be written "-".
std::size_t index_of(const std::string& token, const Json& array, const std::string& pointer) {
    std::size_t index = 0;
    if (token == "-") return array.size();
    const char* const end = token.data() + token.size();
    const auto [rest, error] = std::from_chars(token.data(), end, index);
    const bool number = error == std::errc{} && rest == end && (token == "0" || token.front() != '0');
    if (number && index <= array.size()) return index;
    // A vector does not accept a new number at its end, except for the w of a light's position.
    const bool is_vector = !array.empty() && array.front().is_number();
    fail(pointer,
         in_quotes(token) + (number ? " is past the end of the array" : " is not an index of an array"),
         array.empty() ? "0 or -, for a new one"
         : is_vector   ? fmt::format("0 to {}", array.size() - 1)
                       : fmt::format("0 to {0}; {0} or - for a new one at the end", array.size()));
}

/// The value under `token`, created if missing.
Json& child_of(Json& parent, const std::string& token, const Json& made, const std::string& pointer) {
    if (parent.is_object()) return parent.emplace(token, Json(made)).first.value();
    if (!parent.is_array())
        fail(pointer, fmt::format("{} cannot be added to a value that contains no others", in_quotes(token)),
             "a pointer to a value in the scene");
    const std::size_t index = index_of(token, parent, pointer);
    if (index == parent.size()) parent.push_back(made);
    return parent[index];
}

void assign(Json& document, const Assignment& a) {
    const Tokens tokens = tokens_of(a.pointer);
    Json value = value_of(a);
    Json* at = &document;
    for (std::size_t step = 0; step < tokens.size(); ++step) {
        const Tokens path(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(step) + 1);
        at = &child_of(*at, tokens[step], MissingParent(path).made(), a.pointer);
    }
    *at = std::move(value);
}

bool is_set(const std::string& pointer, const std::vector<Assignment>& assignments) {
    return std::any_of(assignments.begin(), assignments.end(),
                       [&](const Assignment& a) { return a.pointer == pointer; });
}

/// Removes w from a light's position after dividing x, y and z by it, unless it is 0. Used if an assignment
/// sets the light's type but not its position: the old w may contradict the new type. A negative w stays.
void drop_w(Json& light) {
    const auto position = light.find("position");
    if (position == light.end() || !position->is_array() || position->size() != 4) return;
    if (!std::all_of(position->begin(), position->end(), [](const Json& x) { return x.is_number(); })) return;
    const double w = (*position)[3].get<double>();
    if (w < 0) return;  // invalid for every type
    position->erase(3);
    if (w == 0 || w == 1) return;
    for (Json& x : *position) x = x.get<double>() / w;
}

/// When a projection's type is newly set, drops the keys of the other types, unless they are set as well.
void drop_other_projections(Json& projection, const std::string& type,
                            const std::vector<Assignment>& assignments) {
    const std::optional<ProjectionKind> kind = from_name<ProjectionKind>(type);
    if (!kind) return;
    const Tokens kept = projection_keys(*kind);
    for (std::size_t other = 0; other < count_of<ProjectionKind>(); ++other)
        for (const std::string& key : projection_keys(static_cast<ProjectionKind>(other)))
            if (std::find(kept.begin(), kept.end(), key) == kept.end() &&
                !is_set("/camera/projection/" + key, assignments))
                projection.erase(key);
}

void follow_type(Json& document, const Assignment& a, const std::vector<Assignment>& assignments) {
    const Tokens tokens = tokens_of(a.pointer);
    if (tokens.size() == 3 && tokens[0] == "lights" && tokens[2] == "type") {
        const std::string position = "/lights/" + tokens[1] + "/position";
        if (is_set(position, assignments) || is_set(position + "/3", assignments)) return;
        Json& lights = document["lights"];
        if (!lights.is_array()) return;
        drop_w(lights[tokens[1] == "-" ? lights.size() - 1 : index_of(tokens[1], lights, a.pointer)]);
    }
    if (a.pointer == "/camera/projection/type") {
        Json& projection = document["camera"]["projection"];
        if (projection["type"].is_string())
            drop_other_projections(projection, projection["type"].get<std::string>(), assignments);
    }
}

/// Applies all assignments in order. Missing parents are created: lists and vectors where a scene has them,
/// otherwise objects. Setting only a light's `type` also sets the w of that type. Setting a projection's
/// `type` drops the keys of the other projections. Throws ProblemFound with file "--set".
void apply_assignments(Json& document, const std::vector<Assignment>& assignments) {
    for (const Assignment& a : assignments) {
        assign(document, a);
        follow_type(document, a, assignments);
    }
}

}  // namespace

bool is_assigned(const std::string& pointer, const std::vector<Assignment>& assignments) {
    return std::any_of(assignments.begin(), assignments.end(),
                       [&](const Assignment& a) { return is_within(pointer, a.pointer); });
}

Result<Assignment> parse_assignment(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string expected = "POINTER=JSON, such as /display/exposure=2";
    if (equals == std::string_view::npos)
        return Problem{"--set", "", in_quotes(text) + " has no \"=\"", expected};
    if (!text.starts_with('/'))
        return Problem{"--set", "", in_quotes(text) + " does not begin with \"/\"", expected};
    return Assignment{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

Result<Scene> scene_of(const Result<Json>& json, const std::string& file,
                       const std::vector<Assignment>& assignments) {
    if (const Problem* problem = problem_of(json)) return *problem;
    Result<Scene> scene = result_of("", [&] {
        Json document = std::get<Json>(json);
        if (document.is_object()) apply_assignments(document, assignments);
        return read_scene(Node(document));
    });
    if (auto* problem = std::get_if<Problem>(&scene); problem != nullptr && problem->file.empty()) {
        const bool is_assigned_value =
            !assignments.empty() &&
            (is_assigned(problem->pointer, assignments) || problem_of(scene_of(json, file, {})) == nullptr);
        problem->file = is_assigned_value ? "--set" : file;
    }
    return scene;
}

Result<Scene> parse_scene(std::string_view text, const std::string& file,
                          const std::vector<Assignment>& assignments) {
    return scene_of(read_json(text, file), file, assignments);
}

}  // namespace glint
