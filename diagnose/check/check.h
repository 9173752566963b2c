#pragma once
// Compares another renderer's buffers with ours, from geometry to colour: the first one that differs shows
// where the mistake is. For vectors, the result names the transform that would correct them.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/debug_views/debug_view.h"

namespace glint {

/// The names of the scene's buffers that are compared, in the order in which a program computes them: all but
/// `face`.
[[nodiscard]] std::vector<std::string> checked_buffers(const Scene& scene);

struct BufferDifference {
    std::string name;
    double share = 0;     // the fraction of the comparable pixels that differ, 0 to 1
    glm::ivec2 pixel{0};  // where it differs most
    glm::vec3 mine{0}, ours{0};
    std::string found;  // describes the wrong numbers: "world coordinates"; empty if no description fits
};

struct BufferCheck {
    PictureSize size;
    std::size_t compared = 0;                 // how many pixels; if 0, nothing is known about the buffers
    std::vector<std::string> agree;           // the buffers before the first that differs
    std::vector<std::string> conventions;     // what the program does differently, but not wrongly
    std::optional<BufferDifference> differs;  // the first buffer that differs
};

/// Draws the scene without mistakes at the size of the given buffers and compares its buffers with those.
/// `given`: at least one of checked_buffers(), with `linear` filled in, all the same size. `in_world`:
/// vectors are in world coordinates.
[[nodiscard]] BufferCheck check_buffers(const SceneDocument& document, const std::vector<PixelBuffer>& given,
                                        int threads, bool in_world = false);

/// The result as text, and as JSON.
[[nodiscard]] std::string check_text(const BufferCheck& check);
[[nodiscard]] std::string check_json(const BufferCheck& check);

// Recognises the numbers in a wrong buffer: the correct ones in a different frame, reversed, or with a
// different length.

/// One lit point from which a pixel's value is blended: a vertex, or the pixel's own point. In
/// camera coordinates.
struct ReadAt {
    double weight = 1;  // the point's share in the pixel's blend
    glm::dvec3 position{0}, normal{0}, view{0};
    glm::dvec3 to_light{0};               // unit length; 0 if the buffer does not belong to a light
    double distance = 0;                  // to the light; 0 if the light is directional
    glm::dvec3 falloff{1, 0, 0};          // the light's factors: constant, linear, quadratic
    glm::dvec3 axis{0};                   // the axis of the light's cone
    double cutoff_deg = 0, exponent = 0;  // of the light's cone
    glm::dmat4 world_from_object{1};
};

/// One pixel of a wrong buffer.
struct ReadPoint {
    glm::vec3 mine{0}, ours{0};  // the buffer's value, and the correct one
    std::vector<ReadAt> at;      // the blended points
};

struct CheckFrames {
    glm::dmat4 view_from_world{1}, clip_from_view{1};
};

/// The kind of numbers in a buffer.
enum class BufferKind {
    Point,
    Depth,
    Normal,
    View,
    ToLight,
    Cosine,
    Distance,
    Falloff,
    Cone,
    Mirrored,
    Halfway,
    Diffuse,
    Color
};
/// Returns the kind of the buffer with that name: ToLight for "l_3".
[[nodiscard]] BufferKind buffer_kind(const std::string& name);
/// The index of the light in a buffer's name: 3 for "l_3" and "n_dot_l_3"; -1 for a buffer that does not
/// belong to one light.
[[nodiscard]] int buffer_light(const std::string& name);

/// Describes the numbers that the buffer has instead of the correct ones: "ours times V transposed: they were
/// left in world coordinates". Empty if no description fits nearly all of them.
[[nodiscard]] std::string reading_of(BufferKind kind, const std::vector<ReadPoint>& points,
                                     const CheckFrames& frames);

}  // namespace glint
