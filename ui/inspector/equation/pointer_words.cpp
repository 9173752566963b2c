#include "ui/inspector/equation/pointer_words.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "models/fields/scene_numbers.h"

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

}  // namespace

NamedNumber named_number(const std::string& pointer, const Scene& scene) {
    const std::vector<std::string> parts = parts_of(pointer);
    if (parts.empty()) return {pointer, "", {Selection::Kind::Camera, 0}};
    const std::string& section = parts[0];
    const int index = parts.size() > 1 ? index_of_part(parts[1]) : -1;
    const auto at = static_cast<std::size_t>(std::max(index, 0));
    if (section == "lights" && index >= 0 && at < scene.lights.size())
        return {scene.lights[at].name, words_of_pointer(scene, pointer, 2), {Selection::Kind::Light, index}};
    if (section == "objects" && index >= 0 && at < scene.objects.size())
        return {
            scene.objects[at].name, words_of_pointer(scene, pointer, 2), {Selection::Kind::Object, index}};
    if (section == "camera")
        return {"Camera", words_of_pointer(scene, pointer, 1), {Selection::Kind::Camera, 0}};
    if (section == "display")
        return {"Display", words_of_pointer(scene, pointer, 1), {Selection::Kind::Display, 0}};
    if (section == "npr")
        return {"Strokes and tones", words_of_pointer(scene, pointer, 1), {Selection::Kind::Shading, 0}};
    return {"Scene", words_of_pointer(scene, pointer, 0), {Selection::Kind::Shading, 0}};
}

}  // namespace glint
