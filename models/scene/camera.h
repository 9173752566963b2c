#pragma once
// The camera: the position of the eye and the projection of the view volume (lecture: "Viewing", "Perspective
// Derivation"). Right-handed; in its own coordinates the camera looks down -z, x right, y up.

#include <cassert>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <variant>

namespace glint {

struct Perspective {
    float fov_y_deg = 45;  // full vertical angle, above 0 and below 180
    float near = 0.1f, far = 100;
    bool operator==(const Perspective&) const = default;
};
struct Orthographic {
    float height = 4;  // of the view volume, in scene units
    float near = 0.1f, far = 100;
    bool operator==(const Orthographic&) const = default;
};
/// Asymmetric perspective: the window on the near plane. Stretched to the picture, as in OpenGL.
struct Frustum {
    float left = -0.05f, right = 0.05f, bottom = -0.05f, top = 0.05f;
    float near = 0.1f, far = 100;
    bool operator==(const Frustum&) const = default;
};
using Projection = std::variant<Perspective, Orthographic, Frustum>;

struct Camera {
    glm::vec3 eye{0, 0, 5}, target{0}, up{0, 1, 0};  // world coordinates
    Projection projection;
    bool operator==(const Camera&) const = default;
};

inline constexpr int max_picture_side = 16384;

/// Width and height of a picture in pixels, 1 to max_picture_side each.
struct PictureSize {
    int width = 1280, height = 720;
    bool keeps_width = false;  // below 16:9 the horizontal field stays the same: see fitted()
    bool operator==(const PictureSize&) const = default;

    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// Pixels are numbered row by row from the upper left corner. Precondition: (x, y) is inside.
    [[nodiscard]] std::size_t index(int x, int y) const {
        assert(x >= 0 && y >= 0 && x < width && y < height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Camera coordinates from world coordinates: rows (u, -u.eye), (v, -v.eye), (w, -w.eye), (0 0 0 1), with w =
/// (eye - target)/|eye - target|, u = up x w / |up x w|, v = w x u. (The slide "Correction: W2V vs. V2W"
/// labels this matrix M_V2W; it maps the eye to the origin.) In double, so that an eye and an object that are
/// both far away keep a precise difference.
/// Precondition: eye != target and up not parallel to the view direction (checked when a scene is read).
[[nodiscard]] glm::dmat4 view_from_world(const Camera& camera);
/// World coordinates from camera coordinates: the inverse of view_from_world(), with the axes u, v, w as
/// columns and the same precondition.
[[nodiscard]] glm::dmat4 world_from_view(const Camera& camera);

/// The aspect ratio, width / height, for which scenes are composed.
inline constexpr double composed_aspect = 16.0 / 9;

/// Whether the vertical field is larger than that of the projection.
[[nodiscard]] constexpr bool is_widened(PictureSize size) {
    return size.keeps_width && 9LL * size.width < 16LL * size.height;
}

/// The projection for a picture of this size. `projection` has a vertical field of view. If the size keeps
/// its width and is narrower than 16:9, the horizontal field is that of 16:9, so the vertical one is larger.
/// A frustum stays unchanged and is stretched to the picture.
[[nodiscard]] Projection fitted(const Projection& projection, PictureSize size);

/// OpenGL's clip coordinates from camera coordinates, for fitted(projection, size): rows (E 0 A 0) (0 F B 0)
/// (0 0 C D) (0 0 -1 0); points with -w <= x, y, z <= w are visible. Source: lecture, "Perspective
/// Derivation"; OpenGL 2.1, section 2.11.
[[nodiscard]] glm::dmat4 clip_from_view(const Projection& projection, PictureSize size);

/// The clipping planes' distances from the eye along the line of sight, scene units.
[[nodiscard]] inline float near_of(const Projection& projection) {
    return std::visit([](const auto& p) { return p.near; }, projection);
}
[[nodiscard]] inline float far_of(const Projection& projection) {
    return std::visit([](const auto& p) { return p.far; }, projection);
}
[[nodiscard]] inline bool is_orthographic(const Projection& projection) {
    return std::holds_alternative<Orthographic>(projection);
}

}  // namespace glint
