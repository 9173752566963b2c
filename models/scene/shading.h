#pragma once
// How points are lit, and how lit points fill the picture: two independent choices (lecture: "Lighting vs.
// Shading"). Plain enums and switches, included by the lighting kernels of every instruction set: do not use
// the standard library here.

#include "models/scene/reflection.h"

namespace glint {

enum class ShadingMode { Flat, Facet, Gouraud, Phong };
enum class Interpolation { Perspective, Screen, Scanline };
enum class FlatPoint { Centroid, Provoking };
enum class Cull { None, Back, Front };
enum class Rules { Lecture, OpenGL2 };

struct Terms {
    bool emission = true, ambient = true, diffuse = true, specular = true;
    bool operator==(const Terms&) const = default;
};

enum class ScopeLights { All, Directional, Point, Spot, Area };
enum class ScopeTerm { All, Diffuse, Specular };

/// The part of the picture to which mistakes are limited. An index of -1 means all.
struct MistakeScope {
    int light = -1, object = -1;
    ScopeLights lights = ScopeLights::All;
    ScopeTerm term = ScopeTerm::All;
    constexpr bool is_of_light() const {
        return light >= 0 || lights != ScopeLights::All || term != ScopeTerm::All;
    }
    constexpr bool is_all() const { return !is_of_light() && object < 0; }
    bool operator==(const MistakeScope&) const = default;
};

/// Common student mistakes, each with a switch that shows its effect. Names and effects:
/// models/scene/mistakes.h.
struct Mistakes {
    // In the equation.
    bool unnormalized_light = false, unnormalized_half = false, specular_behind_surface = false;
    bool no_clamp_of_cosine = false, half_angle_with_phong_shininess = false;
    bool ambient_per_light_added_twice = false, clamp_each_light = false, shininess_as_fraction = false;
    bool missing_pi = false, absolute_cosine = false, reflect_sign = false, reflect_of_difference = false;
    bool power_zero_is_nan = false, power_of_negative_is_nan = false, half_lambert = false;
    bool specular_without_cosine = false, fresnel_of_view_angle = false, ambient_not_attenuated = false;
    // In the lights and the viewer.
    bool light_in_wrong_space = false, light_moved_twice = false, falloff_of_directional = false;
    bool falloff_without_constant = false, degrees_for_radians = false, cutoff_as_full_angle = false;
    bool viewer_at_origin_of_world = false, lit_after_projection = false;
    bool light_by_inverse_view = false, direction_is_position = false, light_direction_reversed = false;
    bool aim_stays_at_origin = false, cone_cosines_swapped = false, falloff_inverted = false;
    bool falloff_forgotten = false, last_light_only = false, average_of_lights = false;
    bool unnormalized_view = false, view_reversed = false, perspective_view_in_ortho = false;
    bool position_is_direction = false, distance_is_one = false, distance_includes_w = false;
    bool divided_by_square = false, distance_across_spaces = false, spot_direction_left_in_world = false;
    // In the materials.
    bool lit_in_srgb = false, coefficients_swapped = false, shininess_inverted = false;
    bool ambient_without_material = false, highlight_tinted = false, highlight_normalized = false;
    bool alpha_not_squared = false;
    // In the normals.
    bool unnormalized_normals = false, normals_by_model_matrix = false, normals_flipped = false;
    bool no_normals_given = false, interpolated_normals_not_normalized = false;
    bool normals_left_in_object = false, normals_left_in_world = false, normals_as_points = false;
    bool some_faces_flipped = false, cross_reversed = false, mirror_turns_inside_out = false;
    bool flipped_by_view = false, flipped_twice = false;
    bool normals_without_model = false, normals_by_inverse = false, normals_by_projection = false;
    bool facet_normals_of_screen_points = false, cross_component_wrong = false;
    bool facet_normal_of_first_corners = false, last_facet_wins = false, normals_axes_exchanged = false;
    bool positions_as_normals = false, normals_by_position_index = false, interpolated_lengths = false;
    bool zero_normal_is_nan = false;
    // In the choice of faces and in the displayed bytes.
    bool culled_by_light = false, encoded_twice = false, bytes_wrap = false;
    int form = 0;            // applies to mistakes with several forms (MistakeName::forms)
    int highlight_form = 0;  // applies to highlight_normalized, which combines with any other mistake
    MistakeScope only{};
    bool operator==(const Mistakes&) const = default;
};

struct Shading {
    ShadingMode mode = ShadingMode::Phong;
    Reflection reflection = Reflection::Phong;
    Interpolation interpolation = Interpolation::Perspective;
    FlatPoint flat_point = FlatPoint::Centroid;
    bool two_sided = false;
    bool local_viewer = true;
    Cull cull = Cull::None;
    Rules rules = Rules::Lecture;
    Terms terms;
    int power_table = 0;  // entries of a table for powers of cosines, 2 to 65,536; 0: no table
    Mistakes mistakes;
    bool operator==(const Shading&) const = default;
};

/// Whether flat shading lights each triangle at its provoking corner instead of each polygon at its centroid.
constexpr bool flat_at_provoking_corner(const Shading& shading) {
    return shading.flat_point == FlatPoint::Provoking || shading.rules == Rules::OpenGL2;
}

// How light reaches a point: directly, ignoring all objects in between (the local model); directly unless an
// object blocks it; or also by reflection off other surfaces (docs/scene_file.md, "Transport"). Plain data;
// renderer/transport computes it.

enum class TransportModel { Local, Shadows, Bounces };

struct Transport {
    TransportModel model = TransportModel::Local;
    int paths = 64;   // random paths per lit point, 1 to 65,536
    int bounces = 4;  // maximum number of surfaces on a path, 0 to 64
    int seed = 1;     // a different seed gives different random numbers
    bool operator==(const Transport&) const = default;
};

}  // namespace glint
