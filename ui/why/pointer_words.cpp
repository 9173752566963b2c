#include "ui/why/pointer_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

namespace glint {
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

/// The number that a part is, or -1.
int index_of_part(const std::string& part) {
    int index = -1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
    return error == std::errc() && end == part.data() + part.size() ? index : -1;
}

bool is_colour(std::string_view key) {
    constexpr std::array<std::string_view, 10> keys{"ambient", "diffuse",       "specular", "emission",
                                                    "f0",      "cool",          "warm",     "background",
                                                    "stroke",  "global_ambient"};
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// "falloff quadratic", "diffuse red": the parts from `first` on, the last index named by what it counts.
std::string words_from(const std::vector<std::string>& parts, std::size_t first) {
    constexpr std::array axes{"x", "y", "z", "w"}, channels{"red", "green", "blue", "alpha"};
    std::string text;
    for (std::size_t i = first; i < parts.size(); ++i) {
        std::string word = parts[i];
        if (const int index = index_of_part(word); index >= 0 && index < 4 && i > 0)
            word = (is_colour(parts[i - 1]) ? channels : axes)[static_cast<std::size_t>(index)];
        if (word == "material" || word == "transform" || word == "projection") continue;
        std::replace(word.begin(), word.end(), '_', ' ');
        text.append(text.empty() ? "" : " ").append(word);
    }
    return text;
}

}  // namespace

NamedNumber named_number(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    if (parts.empty()) return {pointer, "", {Selection::Kind::Camera, 0}};
    const std::string& section = parts[0];
    const int index = parts.size() > 1 ? index_of_part(parts[1]) : -1;
    const auto at = static_cast<std::size_t>(std::max(index, 0));
    if (section == "lights" && index >= 0 && at < scene.lights.size())
        return {scene.lights[at].name, words_from(parts, 2), {Selection::Kind::Light, index}};
    if (section == "objects" && index >= 0 && at < scene.objects.size())
        return {scene.objects[at].name, words_from(parts, 2), {Selection::Kind::Object, index}};
    if (section == "camera") return {"Camera", words_from(parts, 1), {Selection::Kind::Camera, 0}};
    if (section == "display") return {"Display", words_from(parts, 1), {Selection::Kind::Display, 0}};
    if (section == "npr") return {"Strokes and tones", words_from(parts, 1), {Selection::Kind::Shading, 0}};
    return {"Scene", words_from(parts, 0), {Selection::Kind::Shading, 0}};
}

}  // namespace glint
