#include <string>
#include <vector>

#include "models/json/json.h"
#include "models/material_presets_text.h"
#include "models/scene/material.h"

namespace glint {
namespace {

glm::vec3 color(const Json& numbers) {
    return {numbers[0].get<float>(), numbers[1].get<float>(), numbers[2].get<float>()};
}

/// Alpha is ignored: transparency is not supported.
MaterialPreset preset_of(const Json& entry) {
    Material m;
    m.ambient = color(entry["ambient"]);
    m.diffuse = color(entry["diffuse"]);
    m.specular = color(entry["specular"]);
    m.shininess = entry["shininess"].get<float>();
    return {entry["name"].get_ref<const std::string&>(), entry["family"].get_ref<const std::string&>(), m};
}

}  // namespace

std::span<const MaterialPreset> material_presets() {
    static const Json document = parsed_json(material_presets_text, "materials.json");  // owns the names
    static const std::vector<MaterialPreset> presets = [] {
        std::vector<MaterialPreset> made;
        for (const Json& entry : document["materials"]) made.push_back(preset_of(entry));
        return made;
    }();
    return presets;
}

}  // namespace glint
