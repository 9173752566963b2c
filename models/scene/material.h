#pragma once
// The reflection properties of a surface (docs/scene_file.md; lecture: "Lighting in OpenGL").

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

namespace glint {

struct Material {
    glm::vec3 ambient{0.2f}, diffuse{0.8f}, specular{1};  // k_a, k_d, k_s: linear RGB, reflected fraction
    glm::vec3 emission{0};                                // linear RGB
    float shininess = 32;                                 // exponent n_shiny, 0 to 10,000
    float roughness = 0.5f;                               // 0 to 1; oren-nayar and cook-torrance
    glm::vec3 f0{0.04f};                                  // reflectance at normal incidence; cook-torrance
    bool operator==(const Material&) const = default;
};

/// One of the classic materials of the OpenGL sample programs (assets/materials.json).
struct MaterialPreset {
    std::string_view name, family;  // family: gem, metal, plastic, rubber
    Material material;
};

/// All presets, in the order of assets/materials.json, which is compiled in.
[[nodiscard]] std::span<const MaterialPreset> material_presets();

}  // namespace glint
