#include "ui/features/inspector/equation/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <vector>

#include "models/fields/scene_fields.h"
#include "renderer/explain/equation_text.h"
#include "ui/features/inspector/equation/text_line.h"

namespace glint {

namespace {

TermSums sums_at(const ExplainedPoint& at) {
    TermSums sums{at.emission, at.global_ambient, {}, {}, at.cool_to_warm.color, at.bounces.term};
    for (const ExplainedLight& light : at.lights) {
        sums.ambient += light.ambient;
        sums.diffuse += light.diffuse;
        sums.specular += light.specular;
    }
    return sums;
}

}  // namespace

std::string sample_words(const ExplainedLight& area, const Light& light) {
    const auto less = [](const ExplainedLight& a, const ExplainedLight& b) { return a.n_dot_l < b.n_dot_l; };
    const auto [low, high] = std::minmax_element(area.samples.begin(), area.samples.end(), less);
    if (low == area.samples.end()) return {};
    return fmt::format("{}, n·l {} to {}", sample_count(area, light), shown_number(low->n_dot_l),
                       shown_number(high->n_dot_l));
}

std::string clipping_reason(glm::vec3 sum, float exposure) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const float shown = sum[i] * exposure;
        if (shown > 1.0005f)
            text += fmt::format("{}{} {} → 1", text.empty() ? "clips: " : ", ", "RGB"[i],
                                shown < 1e4f ? fmt::format("{:.2f}", shown) : fmt::format("{:.4g}", shown));
    }
    return text;
}

TermSums term_sums(const Explanation& explanation) {
    if (!explanation.lit_per_corner) return sums_at(explanation.at);
    TermSums sums;
    for (const ExplainedCorner& corner : explanation.corners) {
        const TermSums at = sums_at(corner.at);
        sums.tone += corner.weight * at.tone;
        sums.bounced += corner.weight * at.bounced;
        sums.emission += corner.weight * at.emission;
        sums.ambient += corner.weight * at.ambient;
        sums.diffuse += corner.weight * at.diffuse;
        sums.specular += corner.weight * at.specular;
    }
    return sums;
}

double angle_deg(float cosine) {
    return std::acos(std::clamp(double(cosine), -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::string shown_number(float value) {
    constexpr float rounding = 1e-5f;  // remainder after floats of about 1 cancel
    const float size = std::abs(value) < rounding ? 0 : std::abs(value);
    const char* sign = value < 0 && size > 0 ? "−" : " ";
    if (size >= 1e5f) return fmt::format("{}{:.1e}", sign, size);
    if (size >= 1000) return fmt::format("{}{:.0f}", sign, size);
    if (size >= 100) return fmt::format("{}{:.1f}", sign, size);
    if (size >= 10) return fmt::format("{}{:.2f}", sign, size);
    return sign + significant_text(double(size), 3);
}

std::string shown_vector(glm::vec3 v) {
    return fmt::format("{} {} {}", shown_number(v.x), shown_number(v.y), shown_number(v.z));
}

namespace {

std::vector<std::string> parts_of(const std::string& pointer) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < pointer.size();) {
        const std::size_t end = std::min(pointer.find('/', at + 1), pointer.size());
        parts.push_back(pointer.substr(at + 1, end - at - 1));
        at = end;
    }
    return parts;
}

/// The index that a part contains, or -1.
int index_of_part(const std::string& part) {
    int index = -1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    return error == std::errc() && end == part.data() + part.size() ? index : -1;
}

struct Owner {
    std::string name;
    Selection selection;
};

/// The owner of the number at a pointer with these parts, of which there is at least one.
Owner owner_at(const std::vector<std::string>& parts, const Scene& scene) {
    const std::string& section = parts[0];
    const int index = parts.size() > 1 ? index_of_part(parts[1]) : -1;
    const auto at = static_cast<std::size_t>(index);  // -1 becomes the largest value
    if (section == "lights" && at < scene.lights.size())
        return {scene.lights[at].name, {Selection::Kind::Light, index}};
    if (section == "objects" && at < scene.objects.size())
        return {scene.objects[at].name, {Selection::Kind::Object, index}};
    if (section == "camera") return {"Camera", {Selection::Kind::Camera, 0}};
    if (section == "display") return {"Display", {Selection::Kind::Display, 0}};
    if (section == "npr") return {"Strokes and tones", {Selection::Kind::Shading, 0}};
    return {"Scene", {Selection::Kind::Shading, 0}};
}

}  // namespace

std::string owner_of(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    return parts.empty() ? pointer : owner_at(parts, scene).name;
}

NamedNumber named_number(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    if (parts.empty()) return {pointer, "", {Selection::Kind::Camera, 0}};
    const Owner owner = owner_at(parts, scene);
    const bool is_item =
        owner.selection.kind == Selection::Kind::Light || owner.selection.kind == Selection::Kind::Object;
    const bool is_whole = is_item && parts.size() == 2;
    return {owner.name, is_whole ? "" : words_of_pointer(scene, pointer), owner.selection};
}

NumberHandle number_handle(const HandledScene& scene, const std::string& pointer) {
    const NamedNumber named = named_number(pointer, scene.shown);
    const auto number =
        scene.edited != nullptr ? number_at(*scene.edited, pointer) : number_at(scene.shown, pointer);
    return {number.value(),
            named.owner == "Scene" ? named.what : fmt::format("{} of {}", named.what, named.owner)};
}

}  // namespace glint
