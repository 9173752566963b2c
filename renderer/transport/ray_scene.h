#pragma once
// Traces rays against the triangles of a scene with Embree 3, in world coordinates. Embree only finds the
// triangle that a ray hits. The hit point is computed here in doubles, so that it depends only on the ray and
// the triangle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// The origin of rays that start on a facet, in world coordinates.
struct RayStart {
    glm::vec3 p{0};
    glm::vec3 n{0};  // unit normal of the facet (counter-clockwise is outside); 0 for a facet without area
    /// Bounds the sum of two errors along n: from rounding p to floats, and from Embree's intersection test
    /// with the facet that contains p (ray_scene.cpp).
    float away = 0;

    /// p, moved by `away` to the side of the facet to which `direction` points. A ray in this direction hits
    /// neither the facet nor its neighbours in the same plane.
    [[nodiscard]] glm::vec3 towards(const glm::vec3& direction) const;
};

/// From `from` to `from + reach * direction`. `direction` may have any length except 0.
struct WorldRay {
    glm::vec3 from{0}, direction{0};
    float reach = 0;  // may be infinite
};

/// The first triangle that a ray hits.
struct RayHit {
    std::uint32_t object = 0;    // index of Scene::objects
    std::uint32_t triangle = 0;  // index of Mesh::triangles
};

/// The visible objects of a scene. All functions except `update` are thread-safe.
class RayScene {
  public:
    RayScene();
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    /// Builds the acceleration structure unless meshes, transforms and visible objects are unchanged since
    /// the last call; returns whether it did. Meshes must be loaded. Throws LimitExceeded if Embree fails,
    /// and std::bad_alloc; the next call then builds again.
    bool update(const Scene& scene);
    /// Whether update() would do nothing for this scene.
    [[nodiscard]] bool is_of(const Scene& scene) const;

    [[nodiscard]] bool is_blocked(const WorldRay& ray) const;
    [[nodiscard]] std::optional<RayHit> first_hit(const WorldRay& ray) const;

    /// The origin of rays at the point of the triangle whose weights are closest to those of p.
    [[nodiscard]] RayStart on_triangle(RayHit triangle, const glm::dvec3& p) const;
    /// The same for a triangle that is shaded as part of a smooth bulge. Lifts the point onto the mean of the
    /// planes through the corners with their unit normals, where these planes are above the triangle.
    /// Otherwise the shadows of neighbouring triangles on the bulge would have visible steps. Source: J.
    /// Hanika, "Hacking the Shadow Terminator" (2021).
    [[nodiscard]] RayStart on_bulge(RayHit triangle, const glm::dvec3& p,
                                    const std::array<glm::dvec3, 3>& normals) const;
    /// The origin of rays where the ray hits the triangle.
    [[nodiscard]] RayStart at_hit(const WorldRay& ray, RayHit hit) const;
    /// The origin of rays at a corner p of an object, with a normal n of any length except 0. It is moved off
    /// all facets that n points away from.
    [[nodiscard]] RayStart at_corner(std::uint32_t object, const glm::dvec3& p, const glm::dvec3& n) const;

  private:
    struct Built;
    std::unique_ptr<Built> built_;
};

/// The ray from a facet to a point, such as a light, shortened to allow for rounding errors of the distance.
[[nodiscard]] WorldRay ray_to(const RayStart& start, const glm::vec3& target);
/// The ray of infinite length from a facet.
[[nodiscard]] WorldRay ray_along(const RayStart& start, const glm::vec3& direction);

}  // namespace glint
