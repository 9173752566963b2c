#pragma once
// A light as the scene file describes it (docs/scene_file.md, "Lights"; lecture: "Light Sources"). Plain
// data; renderer/lighting computes its effect.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace glint {

enum class LightKind { Directional, Point, Spot, Area };
/// World lights stay with the scene, camera lights with the viewer (lecture: "geometry: positions and
/// directions").
enum class LightSpace { World, Camera };

/// 1 / (constant + linear r + quadratic r^2), r the distance in scene units. All >= 0, not all zero.
struct Falloff {
    float constant = 1, linear = 0, quadratic = 0;
    bool operator==(const Falloff&) const = default;
};

/// The cone of a spot: cos(angle from the axis)^exponent inside the cutoff, 0 outside. Between the inner
/// angle and the cutoff it also falls off smoothly, as in KHR_lights_punctual.
struct SpotCone {
    glm::vec3 direction{0, -1, 0};  // in the light's space, any length but 0
    float cutoff_deg = 30;          // axis to edge, 0 to 90; 180: no cone
    float exponent = 1;             // >= 0
    float inner_deg = 180;          // 0 to 90, or 180; at or above the cutoff: no soft edge
    bool operator==(const SpotCone&) const = default;
};

/// A parallelogram centred on the position, with these half-edges (in the light's space).
struct AreaShape {
    glm::vec3 edge_u{0.5f, 0, 0}, edge_v{0, 0, 0.5f};
    int samples = 16;  // a square number, 1 to 64: n x n points at the centres of n x n equal cells
    bool operator==(const AreaShape&) const = default;
};

struct Light {
    std::string name = "Light";
    LightKind kind = LightKind::Point;
    LightSpace space = LightSpace::World;
    glm::vec4 position{0, 2, 2, 1};  // w = 0: the direction towards the light; w > 0: a point, divided by w
    glm::vec3 ambient{0}, diffuse{1}, specular{1};  // linear RGB, >= 0, 1 is full intensity
    float intensity = 1;                            // multiplies all three, >= 0
    bool enabled = true;
    Falloff falloff;  // point and spot only
    SpotCone spot;    // kept but ignored for other kinds
    AreaShape area;   // likewise
    bool operator==(const Light&) const = default;
};

}  // namespace glint
