#include "models/fields/scene_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

namespace glint {

std::string source_name(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source)) return file->path;
    return std::string(name_of(std::get<PrimitiveMesh>(source).primitive));
}

std::string words_of(const Count& count) {
    if (!count.words.empty()) return std::string(count.words);
    return count.low == count.high ? fmt::format("{}", count.low)
                                   : fmt::format("a whole number from {} to {}", count.low, count.high);
}

namespace {

using Tokens = std::vector<std::string_view>;

Tokens tokens_of(std::string_view pointer) {
    Tokens tokens;
    while (!pointer.empty()) {
        pointer.remove_prefix(1);
        const std::size_t end = std::min(pointer.find('/'), pointer.size());
        tokens.push_back(pointer.substr(0, end));
        pointer.remove_prefix(end);
    }
    return tokens;
}

/// The token's value as a number, or -1.
int index_of(std::string_view token) {
    int index = -1;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    return error == std::errc() && end == token.data() + token.size() ? index : -1;
}

/// Returns a label as used within a sentence: "cutoff" for "Cutoff", "falloff" for "Falloff  1 / (…)".
/// Symbols such as F0 or cosˢ stay unchanged.
std::string in_a_sentence(std::string_view label) {
    std::string words(label.substr(0, label.find("  ")));
    const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
    if (words.size() > 1 && is_small(words[1])) words[0] = static_cast<char>(std::tolower(words[0]));
    return words;
}

/// Calls visit(SceneNumber, kind, member) for every float and int of a scene or a part of it, or only for the
/// number with the pointer `only`. Without `lists`, skips lights and objects.
template <class Visit> class NumberWalk {
  public:
    NumberWalk(Visit& visit, const Tokens* only, bool lists) : visit_(visit), only_(only), lists_(lists) {}

    template <class T> void members(T& value) const {
        fields_with_defaults(value,
                             [this](const Row& row, const auto& kind, auto& member, const auto& initial) {
                                 if (!leads_to(row.key)) return;
                                 NumberWalk below = *this;
                                 below.descend(row.key);
                                 below.name(row, is_group<decltype(kind)>);
                                 below.help_ = row.help;
                                 below.moves_faces_ = moves_faces_ && row.moves_faces;
                                 below.applies_ = applies_ && row.applies;
                                 below.at(kind, member, initial);
                             });
    }

  private:
    [[nodiscard]] bool leads_to(std::string_view key) const {
        return only_ == nullptr || (depth_ < only_->size() && (*only_)[depth_] == key);
    }
    void descend(std::string_view key) {
        pointer_.append("/").append(key);
        ++depth_;
    }

    template <class Kind>
    static constexpr bool is_group =
        std::same_as<std::remove_cvref_t<Kind>, Group> || std::same_as<std::remove_cvref_t<Kind>, List>;

    /// A group directly inside the scene is an owner, such as the camera. The description of a number omits
    /// the owner's name and the words material, transform and projection.
    void name(const Row& row, bool is_group_row) {
        const bool is_owner = depth_ == 1 && is_group_row;
        if (is_owner || row.key == "material" || row.key == "transform" || row.key == "projection") return;
        add_word(in_a_sentence(row.label));
    }
    void add_word(std::string_view word) { words_.append(words_.empty() ? "" : " ").append(word); }

    template <class T> void at(const Real& kind, T& x, float initial) const {
        number(kind, kind, x, initial);
    }
    template <class T> void at(const Count& kind, T& n, int initial) const {
        if (only_ != nullptr && depth_ != only_->size()) return;
        const Real range{.range = {double(kind.low), double(kind.high), kind.words}};
        visit_(described(range, n, initial, kind), kind, n);
    }
    template <class V> void at(const Colour& kind, V& v, const glm::vec3& initial) const {
        parts<3>(kind, v, initial, {"red", "green", "blue"});
    }
    template <class V> void at(const Vector& kind, V& v, const glm::vec3& initial) const {
        parts<3>(kind, v, initial, {"x", "y", "z"});
    }
    template <class V> void at(const Homogeneous& kind, V& v, const glm::vec4& initial) const {
        parts<4>(kind, v, initial, {"x", "y", "z", "w"});
    }
    template <class T, class D> void at(const Group&, T& value, const D&) const { members(value); }
    template <class T, class D> void at(const OneProjection&, T& projection, const D&) const {
        std::visit([this](auto& p) { this->members(p); }, projection);
    }
    template <class T, class D> void at(const OneMesh&, T& source, const D&) const {
        std::visit([this](auto& s) { this->members(s); }, source);
    }
    template <class T, class D> void at(const List&, T& list, const D&) const {
        if (!lists_) return;
        const int one = only_ != nullptr && depth_ < only_->size() ? index_of((*only_)[depth_]) : -1;
        const std::size_t first = one >= 0 ? static_cast<std::size_t>(one) : 0;
        const std::size_t last = only_ == nullptr ? list.size()
                                 : one >= 0       ? std::min(first + 1, list.size())
                                                  : 0;
        for (std::size_t i = first; i < last; ++i) {
            NumberWalk below = *this;
            below.descend(std::to_string(i));
            below.members(list[i]);
        }
    }
    template <class Kind, class T, class D> void at(const Kind&, T&, const D&) const {}

    template <int size, class Kind, class V, class D>
    void parts(const Kind& kind, V& v, const D& initial, const std::array<const char*, size>& names) const {
        for (int i = 0; i < size; ++i) {
            const std::string token = std::to_string(i);
            if (!leads_to(token)) continue;
            NumberWalk below = *this;
            below.descend(token);
            below.add_word(names[static_cast<std::size_t>(i)]);
            below.is_w_ = i == 3;
            below.number(component_of(kind), component_of(kind), v[i], initial[i]);
        }
    }
    template <class T> void number(const Real& described_as, const Real& kind, T& x, float initial) const {
        if (only_ != nullptr && depth_ != only_->size()) return;
        SceneNumber n = described(described_as, x, initial, {});
        if constexpr (!std::is_const_v<T>) n.place = &x;
        visit_(std::move(n), kind, x);
    }
    [[nodiscard]] SceneNumber described(const Real& kind, double value, double initial,
                                        const std::optional<Count>& count) const {
        return {pointer_, words_, value, initial, kind, count, help_, moves_faces_, applies_, is_w_, nullptr};
    }

    Visit& visit_;
    const Tokens* only_;
    bool lists_;
    std::size_t depth_ = 0;
    std::string pointer_, words_;
    const char* help_ = "";
    bool moves_faces_ = true, applies_ = true, is_w_ = false;
};

template <class AnyScene, class Visit>
void walk(AnyScene& scene, const Tokens* only, Visit visit, bool lists = true) {
    NumberWalk<Visit>(visit, only, lists).members(scene);
}

bool is_allowed(const Real& kind, float x) { return kind.range.contains(x); }
bool is_allowed(const Count& kind, int n) { return kind.contains(n); }
std::string allowed_by(const Real& kind) { return std::string(kind.range.words); }
std::string allowed_by(const Count& kind) { return words_of(kind); }

/// Sets a number unless its kind forbids the value. A float may exceed a limit by the error from rounding
/// that limit to a float.
std::optional<Problem> assign(const Real& kind, float& to, double value) {
    const auto rounded = static_cast<float>(value);
    const bool contained = kind.range.contains(rounded) && (value == rounded || kind.range.contains(value));
    if (!contained) return out_of_range(value, allowed_by(kind));
    to = static_cast<float>(value);
    return std::nullopt;
}
std::optional<Problem> assign(const Count& kind, int& to, double value) {
    if (!kind.contains(value)) return out_of_range(value, allowed_by(kind));
    to = static_cast<int>(value);
    return std::nullopt;
}

template <class AnyScene> std::optional<SceneNumber> found_at(AnyScene& scene, const std::string& pointer) {
    const Tokens tokens = tokens_of(pointer);
    std::optional<SceneNumber> found;
    walk(scene, &tokens, [&](SceneNumber number, const auto&, auto&) { found = std::move(number); });
    return found;
}

}  // namespace

std::vector<SceneNumber> numbers_of(const Scene& scene) {
    std::vector<SceneNumber> numbers;
    walk(scene, nullptr,
         [&](SceneNumber number, const auto&, auto&) { numbers.push_back(std::move(number)); });
    return numbers;
}

std::optional<SceneNumber> number_at(Scene& scene, const std::string& pointer) {
    return found_at(scene, pointer);
}
std::optional<SceneNumber> number_at(const Scene& scene, const std::string& pointer) {
    return found_at(scene, pointer);
}

std::optional<Problem> set_number(Scene& scene, const std::string& pointer, double value) {
    Scene changed = scene;
    const Tokens tokens = tokens_of(pointer);
    bool exists = false;
    std::optional<Problem> violation;
    walk(changed, &tokens, [&](const SceneNumber&, const auto& kind, auto& to) {
        exists = true;
        violation = assign(kind, to, value);
    });
    if (!exists)
        return Problem{"", pointer, "no number with this pointer", "the pointer of a number in the scene"};
    if (violation) {
        violation->pointer = pointer;
        return violation;
    }
    if (auto found = violation_of(changed)) return found;
    for (std::size_t i = 0; i < changed.lights.size(); ++i) {
        glm::vec4& position = changed.lights[i].position;
        if (auto found = violation_of_division(position)) {
            found->pointer = fmt::format("/lights/{}{}", i, found->pointer);
            return found;
        }
        position = divided_by_w(position);
    }
    for (std::size_t i = 0; i < changed.objects.size(); ++i)
        if (changed.objects[i].source != scene.objects[i].source) changed.objects[i].mesh = nullptr;
    scene = std::move(changed);
    return std::nullopt;
}

std::string words_of_pointer(const Scene& scene, const std::string& pointer) {
    if (const auto number = number_at(scene, pointer)) return number->words;
    // A vector is described like its first number, without the component.
    if (const auto first = number_at(scene, pointer + "/0"))
        return first->words.substr(0, first->words.rfind(' '));
    std::string keys;
    for (const std::string_view token : tokens_of(pointer))
        keys.append(keys.empty() ? "" : " ").append(token);
    std::replace(keys.begin(), keys.end(), '_', ' ');
    return keys;
}

namespace {

std::optional<Problem> violation_of(const Projection& projection) {
    const float near = near_of(projection), far = far_of(projection);
    if (const auto* f = std::get_if<Frustum>(&projection)) {
        if (f->left == f->right)
            return Problem{"", "", fmt::format("left and right are both {}", f->left),
                           "two different numbers"};
        if (f->bottom == f->top)
            return Problem{"", "", fmt::format("bottom and top are both {}", f->top),
                           "two different numbers"};
    }
    if (!(near < far))
        return Problem{"", "", fmt::format("near {} is not less than far {}", near, far), "0 < near < far"};
    return std::nullopt;
}

/// Returns nullopt if edge_u and edge_v span a parallelogram whose area a float can represent.
std::optional<Problem> violation_of(const AreaShape& area) {
    const glm::dvec3 u(area.edge_u), v(area.edge_v);
    const double quarter = glm::length(glm::cross(u, v));
    if (quarter > parallel_sine * glm::length(u) * glm::length(v) && static_cast<float>(quarter) != 0)
        return std::nullopt;
    return Problem{"", "", "edge_u and edge_v span no area", "two edges that are neither zero nor parallel"};
}

std::optional<Problem> below(std::string at, std::optional<Problem> violation) {
    if (violation) violation->pointer = std::move(at) + violation->pointer;
    return violation;
}

/// Finds the first number of a struct, nested structs included, that its kind does not allow. Skips lists.
template <class T> std::optional<Problem> range_violation(const T& value) {
    std::optional<Problem> found;
    const auto check = [&found](const SceneNumber& number, const auto& kind, const auto& x) {
        if (found || is_allowed(kind, x)) return;
        found = out_of_range(x, allowed_by(kind));
        found->pointer = number.pointer;
    };
    walk(value, nullptr, check, false);
    return found;
}

template <class T> std::optional<Problem> any_violation_of(const T& value) {
    if (auto found = violation_of(value)) return found;
    return violation_of_ranges(value);
}

/// In memory, positions have already been divided by w.
std::optional<Problem> any_violation_of(const Light& light) {
    if (auto found = any_violation_of<Light>(light)) return found;
    if (light.position.w == 0 || light.position.w == 1) return std::nullopt;
    return Problem{"", "/position/3", fmt::format("w is {}", light.position.w),
                   "1, with the position divided by w"};
}

/// Returns the first violation in a new or changed item.
template <class Item>
std::optional<Problem> violation_in(const char* list, const std::vector<Item>& valid,
                                    const std::vector<Item>& now) {
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (i < valid.size() && now[i] == valid[i]) continue;
        if (auto found = any_violation_of(now[i]))
            return below(fmt::format("/{}/{}", list, i), std::move(found));
    }
    return std::nullopt;
}

}  // namespace

std::optional<Problem> violation_of(const Camera& camera) {
    const glm::dvec3 back = glm::dvec3(camera.eye) - glm::dvec3(camera.target), up(camera.up);
    if (camera.eye == camera.target)
        return Problem{"", "", "eye and target are the same point", "two different points"};
    if (up == glm::dvec3(0)) return Problem{"", "", "up is zero", "a direction"};
    // Without these conditions the camera has no orthonormal frame (view_from_world).
    if (!(glm::length(glm::cross(up, back)) > parallel_sine * glm::length(up) * glm::length(back)))
        return Problem{"", "", "up is parallel to the viewing direction",
                       "an up that is not along the line from eye to target"};
    return below("/projection", violation_of(camera.projection));
}

std::optional<Problem> violation_of_w(LightKind kind, double w) {
    const bool is_direction = kind == LightKind::Directional;
    if (is_direction ? w == 0 : w > 0) return std::nullopt;
    const char* const article = kind == LightKind::Area ? "an" : "a";
    return Problem{"", "/position", fmt::format("w is {}", w),
                   fmt::format("w {} 0 for {} {} light", is_direction ? '=' : '>', article, name_of(kind))};
}

std::optional<Problem> violation_of_division(const glm::dvec4& position) {
    for (int i = 0; i < 3 && position.w != 0; ++i) {
        const double divided = position[i] / position.w;
        if (!any_number.contains(static_cast<float>(divided)))
            return Problem{"", "/position", fmt::format("divided by w, it is {}", divided),
                           std::string(any_number.words)};
    }
    return std::nullopt;
}

std::optional<Problem> violation_of(const Light& light) {
    if (auto found = violation_of_w(light.kind, light.position.w)) return found;
    if (light.position.w == 0 && glm::vec3(light.position) == glm::vec3(0))
        return Problem{"", "/position", "a zero direction", "the direction towards the light"};
    if (light.falloff == Falloff{0, 0, 0})
        return Problem{"", "/falloff", "constant, linear and quadratic are all 0", "one of them above 0"};
    if (light.spot.direction == glm::vec3(0))
        return Problem{"", "/spot/direction", "a zero direction", "the direction of the cone's axis"};
    return below("/area", violation_of(light.area));
}

std::optional<Problem> violation_of(const Object& object) {
    for (int i = 0; i < 3; ++i)
        if (object.transform.scale[i] == 0)
            return Problem{"", fmt::format("/transform/scale/{}", i), "a scale of 0",
                           "a number other than 0 (negative values mirror)"};
    return std::nullopt;
}

std::optional<Problem> violation_of(const Scene& scene) {
    if (auto found = violation_of(scene.camera)) return below("/camera", std::move(found));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (auto found = violation_of(scene.lights[i]))
            return below(fmt::format("/lights/{}", i), std::move(found));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (auto found = violation_of(scene.objects[i]))
            return below(fmt::format("/objects/{}", i), std::move(found));
    return std::nullopt;
}

std::optional<Problem> violation_of_ranges(const Camera& camera) { return range_violation(camera); }
std::optional<Problem> violation_of_ranges(const Light& light) { return range_violation(light); }
std::optional<Problem> violation_of_ranges(const Object& object) { return range_violation(object); }
std::optional<Problem> violation_of_ranges(const Scene& scene) { return range_violation(scene); }

std::optional<Problem> violation_since(const Scene& valid, const Scene& now) {
    if (auto found = violation_of(now.camera)) return below("/camera", std::move(found));
    if (auto found = violation_of_ranges(now)) return found;
    if (auto found = violation_in("lights", valid.lights, now.lights)) return found;
    return violation_in("objects", valid.objects, now.objects);
}

glm::vec4 divided_by_w(glm::dvec4 position) {
    if (position.w == 0) return position;
    return {glm::vec3(glm::dvec3(position) / position.w), 1};
}

}  // namespace glint
