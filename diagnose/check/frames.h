#pragma once
// The frames in which a program may have left a vector, and the vector's value there.

#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "diagnose/check/readings.h"

namespace glint {

enum class Frame { Object, World, Camera, Clip };
inline constexpr std::array all_frames{Frame::Object, Frame::World, Frame::Camera, Frame::Clip};

[[nodiscard]] inline const char* name_of(Frame frame) {
    constexpr std::array names{"object coordinates", "world coordinates", "camera coordinates",
                               "clip coordinates"};
    return names[static_cast<std::size_t>(frame)];
}

/// The view's rotation.
[[nodiscard]] inline glm::dmat3 view_turn(const CheckFrames& f) { return glm::dmat3(f.view_from_world); }

/// Camera coordinates from those of the frame; object coordinates are those of the object at `at`.
[[nodiscard]] inline glm::dmat4 camera_from(Frame frame, const ReadAt& at, const CheckFrames& f) {
    switch (frame) {
    case Frame::Object:
        return f.view_from_world * at.world_from_object;
    case Frame::World:
        return f.view_from_world;
    case Frame::Camera:
        break;
    case Frame::Clip:
        return glm::inverse(f.clip_from_view);
    }
    return glm::dmat4(1);
}

/// Transforms a point from camera coordinates to the frame; clip coordinates are not divided by w.
[[nodiscard]] inline glm::dvec3 point_in(Frame frame, const ReadAt& at, const CheckFrames& f,
                                         glm::dvec3 point) {
    return glm::dvec3(glm::inverse(camera_from(frame, at, f)) * glm::dvec4(point, 1));
}
/// Returns the position in normalized device coordinates.
[[nodiscard]] inline glm::dvec3 device_point(const ReadAt& at, const CheckFrames& f) {
    const glm::dvec4 clip = f.clip_from_view * glm::dvec4(at.position, 1);
    return glm::dvec3(clip) / clip.w;
}
/// Transforms a direction from camera coordinates to the frame and makes it unit.
[[nodiscard]] inline glm::dvec3 direction_in(Frame frame, const ReadAt& at, const CheckFrames& f,
                                             glm::dvec3 direction) {
    const glm::dvec4 there = glm::inverse(camera_from(frame, at, f)) * glm::dvec4(direction, 0);
    return glm::normalize(glm::dvec3(there));
}
/// Transforms the normal to the frame and makes it unit: by the transpose of the matrix that takes points
/// from there to camera coordinates; to clip coordinates by P itself, as a program does that takes a normal
/// for a direction.
[[nodiscard]] inline glm::dvec3 normal_in(Frame frame, const ReadAt& at, const CheckFrames& f) {
    if (frame == Frame::Clip) return direction_in(frame, at, f, at.normal);
    return glm::normalize(glm::transpose(glm::dmat3(camera_from(frame, at, f))) * at.normal);
}

}  // namespace glint
