#pragma once
// Rays among the triangles of a scene, in world coordinates, by Embree 3. Embree only finds the triangle that
// a ray hits; the point of the hit is computed here, in doubles, so that it depends on nothing but the ray
// and the triangle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// A point of a facet from which rays start; world coordinates.
struct RayStart {
    glm::vec3 p{0};
    glm::vec3 n{0};  // unit, of the facet (counter-clockwise is outside); 0 for a facet without area
    /// A bound of two errors along n: that of rounding p to floats, and that of Embree's test of the facet
    /// that contains p (ray_scene.cpp).
    float away = 0;

    /// p, moved by `away` to the side of the facet to which `direction` points. A ray in this direction meets
    /// neither the facet nor its neighbours in the same plane.
    [[nodiscard]] glm::vec3 towards(const glm::vec3& direction) const;
};

/// From `from` to `from + reach * direction`; `direction` of any length but 0.
struct WorldRay {
    glm::vec3 from{0}, direction{0};
    float reach = 0;  // may be infinite
};

/// The triangle that a ray meets first.
struct RayHit {
    std::uint32_t object = 0;    // in Scene::objects
    std::uint32_t triangle = 0;  // in Mesh::triangles
};

/// The visible objects of a scene. The functions without `update` may be called by several threads.
class RayScene {
  public:
    RayScene();
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    /// Builds the acceleration structure unless meshes, transforms and visible objects are those of the last
    /// call; returns whether it did. Meshes must be loaded. Throws LimitExceeded if Embree fails, and
    /// std::bad_alloc; the next call then builds again.
    bool update(const Scene& scene);
    /// Whether update() would do nothing.
    [[nodiscard]] bool is_of(const Scene& scene) const;

    [[nodiscard]] bool is_blocked(const WorldRay& ray) const;
    [[nodiscard]] std::optional<RayHit> first_hit(const WorldRay& ray) const;

    /// The start of rays at the point of the triangle that is nearest to p in the triangle's weights.
    [[nodiscard]] RayStart on_triangle(RayHit triangle, const glm::dvec3& p) const;
    /// The same, lifted off a triangle that is shaded as a part of a smooth bulge: onto the mean of the
    /// planes through its corners with their unit normals, where these are above the triangle. Otherwise its
    /// neighbours would shade its part of the bulge in steps. Source: J. Hanika, "Hacking the Shadow
    /// Terminator" (2021).
    [[nodiscard]] RayStart on_bulge(RayHit triangle, const glm::dvec3& p,
                                    const std::array<glm::dvec3, 3>& normals) const;
    /// The start of rays where the ray meets the triangle.
    [[nodiscard]] RayStart at_hit(const WorldRay& ray, RayHit hit) const;
    /// The start of rays at a corner p with the normal n, of any length but 0, of an object: off all its
    /// facets that n points away from.
    [[nodiscard]] RayStart at_corner(std::uint32_t object, const glm::dvec3& p, const glm::dvec3& n) const;

  private:
    struct Built;
    std::unique_ptr<Built> built_;
};

/// The ray from a facet to a point, such as a light: not beyond what rounding can do to the distance.
[[nodiscard]] WorldRay ray_to(const RayStart& start, const glm::vec3& target);
/// The ray from a facet that ends nowhere.
[[nodiscard]] WorldRay ray_along(const RayStart& start, const glm::vec3& direction);

}  // namespace glint
