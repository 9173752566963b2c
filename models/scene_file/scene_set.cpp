
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "models/fields/scene_fields.h"
#include "models/json/json.h"
#include "models/scene_file/read_scene.h"
#include "models/utf8.h"

namespace glint {
namespace {

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
                       : fmt::format("0 to {0}; {0} and - are a new one at the end", array.size()));
}

/// The value under `token`, created if missing.
Json& child_of(Json& parent, const std::string& token, const Json& made, const std::string& pointer) {
    if (parent.is_object()) return parent.emplace(token, Json(made)).first.value();
    if (!parent.is_array())
        fail(pointer, fmt::format("{} is to go into a value that holds no others", in_quotes(token)),
             "a pointer to a value of the scene");
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

/// Drops the keys of the other types from a projection with a newly set type, unless they are set too.
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

}  // namespace

void apply_assignments(Json& document, const std::vector<Assignment>& assignments) {
    for (const Assignment& a : assignments) {
        assign(document, a);
        follow_type(document, a, assignments);
    }
}

bool is_assigned(const std::string& pointer, const std::vector<Assignment>& assignments) {
    return std::any_of(assignments.begin(), assignments.end(),
                       [&](const Assignment& a) { return is_within(pointer, a.pointer); });
}

}  // namespace glint
