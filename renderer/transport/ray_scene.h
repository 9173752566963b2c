#pragma once
// Traces rays against the triangles of a scene with Embree 3, in world coordinates. Embree only finds the
// triangle that a ray hits. The hit point is computed here in doubles, so that it depends only on the ray and
// the triangle.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
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

/// A triangle of the scene in world coordinates, with the numbers that all of its points share.
struct RayFacet {
    RayFacet() = default;
    explicit RayFacet(const std::array<glm::dvec3, 3>& corners);

    /// The origin of rays at the point of the triangle that is closest to p.
    [[nodiscard]] RayStart nearest(const glm::dvec3& p) const { return start_at(weights_at(p)); }
    /// Like nearest(), for a triangle that is shaded as part of a smooth bulge. Lifts the point onto the mean
    /// of the planes through the corners with their unit normals, where these planes are above the triangle.
    /// Otherwise the shadows of neighbouring triangles on the bulge would have visible steps. Source: J.
    /// Hanika, "Hacking the Shadow Terminator" (2021).
    [[nodiscard]] RayStart on_bulge(const glm::dvec3& p, const std::array<glm::dvec3, 3>& normals) const;

    std::array<glm::dvec3, 3> c{};  // corners, in mesh order
    glm::dvec3 across{0}, n{0};     // cross product of two edges; unit normal, 0 without area
    double area = 0, longest = 0;   // length of `across`; squared length of the longest edge

  private:
    /// The weights of the corners at the point of the triangle closest to p: the perpendicular projection of
    /// p onto the plane, with weights clamped to the triangle.
    [[nodiscard]] glm::dvec3 weights_at(const glm::dvec3& p) const;
    [[nodiscard]] RayStart start_at(const glm::dvec3& weights) const;
};

/// From `from` to `from + reach * direction`. `direction` may have any length except 0.
struct WorldRay {
    glm::vec3 from{0}, direction{0};
    float reach = 0;  // may be infinite
};

/// 16 rays to be traced together, which is faster if they are close together, such as those from neighbouring
/// pixels to a light.
struct alignas(64) RayPacket {
    static constexpr std::size_t size = 16;
    unsigned which = 0;  // bit i: trace ray i
    float from_x[size], from_y[size], from_z[size];
    float direction_x[size], direction_y[size], direction_z[size];
    float reach[size];

    void add(unsigned i, const WorldRay& ray) {
        which |= 1u << i;
        from_x[i] = ray.from.x, from_y[i] = ray.from.y, from_z[i] = ray.from.z;
        direction_x[i] = ray.direction.x, direction_y[i] = ray.direction.y, direction_z[i] = ray.direction.z;
        reach[i] = ray.reach;
    }
};

/// The first triangle that a ray hits.
struct RayHit {
    std::uint32_t object = 0;    // index into Scene::objects
    std::uint32_t triangle = 0;  // index into Mesh::triangles
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
    /// Bit i: ray i of the packet is blocked.
    [[nodiscard]] unsigned blocked(const RayPacket& rays) const;
    [[nodiscard]] std::optional<RayHit> first_hit(const WorldRay& ray) const;

    [[nodiscard]] RayFacet facet(RayHit triangle) const;
    /// The origin of rays at the point of the triangle that is closest to p.
    [[nodiscard]] RayStart on_triangle(RayHit triangle, const glm::dvec3& p) const {
        return facet(triangle).nearest(p);
    }
    /// The origin of rays where the ray hits the triangle.
    [[nodiscard]] RayStart at_hit(const WorldRay& ray, RayHit hit) const;
    /// The origin of rays at a corner p of an object, with a normal n of any length except 0. It is moved off
    /// all facets that n points away from.
    [[nodiscard]] RayStart at_corner(std::uint32_t object, const glm::dvec3& p, const glm::dvec3& n) const;

  private:
    struct Built;
    std::unique_ptr<Built> built_;
};

// Inline, because a picture needs millions of shadow rays.

inline constexpr double half_ulp = 0x1p-24;  // the relative error of rounding to float

/// The float next to x on the side to which `offset` points; x if that is 0. Equals std::nextafter.
inline float next_float(float x, float offset) {
    if (offset == 0) return x;
    if (x == 0) return std::copysign(std::numeric_limits<float>::denorm_min(), offset);
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(x) + ((x < 0) == (offset < 0) ? 1 : -1));
}

inline glm::vec3 RayStart::towards(const glm::vec3& direction) const {
    const glm::vec3 offset = (glm::dot(n, direction) < 0 ? -away : away) * n, from = p + offset;
    // Rounding must not move the point back.
    return {next_float(from.x, offset.x), next_float(from.y, offset.y), next_float(from.z, offset.z)};
}

/// The largest absolute coordinate.
inline float max_norm(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The ray from a facet to a point, such as a light, shortened to allow for rounding errors in the distance.
[[nodiscard]] inline WorldRay ray_to(const RayStart& start, const glm::vec3& target) {
    const glm::vec3 from = start.towards(target - start.p), direction = target - from;
    const float length = max_norm(direction), size = max_norm(from) + max_norm(target);
    if (length == 0) return {from, start.n, 0};
    return {from, direction, std::max(0.0f, 1 - 4 * static_cast<float>(half_ulp) * size / length)};
}
/// The infinitely long ray from a facet.
[[nodiscard]] inline WorldRay ray_along(const RayStart& start, const glm::vec3& direction) {
    return {start.towards(direction), direction, std::numeric_limits<float>::infinity()};
}

}  // namespace glint
