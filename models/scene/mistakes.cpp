#include "models/scene/mistakes.h"

#include <array>

namespace glint {
namespace {

constexpr std::array names{
    MistakeName{"unnormalized_light", &Mistakes::unnormalized_light,
                "The vector to the light keeps its length: what is far from the light gets brighter, and "
                "highlights grow into blots."},
    MistakeName{
        "unnormalized_half", &Mistakes::unnormalized_half,
        "h = (l + v)/2, as the lecture first writes it, without making it unit: highlights shrink and "
        "darken where l and v part."},
    MistakeName{"specular_behind_surface", &Mistakes::specular_behind_surface,
                "No test of n·l: a highlight shines on the side that the light cannot reach."},
    MistakeName{"no_clamp_of_cosine", &Mistakes::no_clamp_of_cosine,
                "Negative cosines are used as they are: the dark side takes light away, and an even "
                "shininess makes a ghost highlight there."},
    MistakeName{"half_angle_with_phong_shininess", &Mistakes::half_angle_with_phong_shininess,
                "n·h in place of r·v with the same shininess: the highlight is about twice as wide (four "
                "times the exponent would match)."},
    MistakeName{"ambient_per_light_added_twice", &Mistakes::ambient_per_light_added_twice,
                "Each light's ambient share counts twice: shadows turn grey."},
    MistakeName{"clamp_each_light", &Mistakes::clamp_each_light,
                "Each light's share is clamped to 1 before it is added: overlapping bright lights lose their "
                "difference."},
    MistakeName{
        "shininess_as_fraction", &Mistakes::shininess_as_fraction,
        "Shininess divided by 128, as old material tables list it: every highlight covers half the object."},
    MistakeName{"light_in_wrong_space", &Mistakes::light_in_wrong_space,
                "World lights are taken as if in camera coordinates and camera lights as if in the world: "
                "lights travel with the wrong thing."},
    MistakeName{"light_moved_twice", &Mistakes::light_moved_twice,
                "The view matrix is applied once too often to every light: lights swing the wrong way as the "
                "camera orbits."},
    MistakeName{"falloff_of_directional", &Mistakes::falloff_of_directional,
                "A directional light is dimmed by the length of its position vector, as if that were a "
                "distance: the sun depends on how its direction is written."},
    MistakeName{"falloff_without_constant", &Mistakes::falloff_without_constant,
                "The constant of the falloff is forgotten: surfaces near a light burn out; with no other "
                "coefficient the light goes out."},
    MistakeName{"degrees_for_radians", &Mistakes::degrees_for_radians,
                "The cosine of the cutoff is taken of degrees: the cone has an unrelated width."},
    MistakeName{"cutoff_as_full_angle", &Mistakes::cutoff_as_full_angle,
                "The cutoff is taken as the whole angle of the cone: the pool of light is half as wide."},
    MistakeName{"viewer_at_origin_of_world", &Mistakes::viewer_at_origin_of_world,
                "v points to the world's origin instead of the eye: highlights stick to the surface while "
                "the camera moves."},
    MistakeName{"lit_after_projection", &Mistakes::lit_after_projection,
                "Points are lit at their place after projection: angles and distances to lights are bent."},
    MistakeName{"unnormalized_normals", &Mistakes::unnormalized_normals,
                "Normals keep the length they come with, a file's raw, and scaling changes it: brightness "
                "follows the length."},
    MistakeName{"normals_by_model_matrix", &Mistakes::normals_by_model_matrix,
                "Normals go by the matrix of the points instead of its inverse transpose: a squashed ball is "
                "shaded as if it leaned the wrong way."},
    MistakeName{"normals_flipped", &Mistakes::normals_flipped,
                "Every normal points inwards: lit from the wrong side."},
    MistakeName{
        "no_normals_given", &Mistakes::no_normals_given,
        "No normals are given, so all are (0, 0, 1) in object coordinates: a ball is shaded as a disc."},
    MistakeName{"interpolated_normals_not_normalized", &Mistakes::interpolated_normals_not_normalized,
                "Interpolated normals are not made unit again at the pixel: faces darken in their middles."},
};

}  // namespace

std::span<const MistakeName> mistake_names() { return names; }

}  // namespace glint
