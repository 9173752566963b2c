#include "models/scene/mistakes.h"

#include <algorithm>
#include <array>

namespace glint {
namespace {

constexpr std::array names{
    MistakeName{"unnormalized_light", &Mistakes::unnormalized_light, MistakeStage::Equation,
                SeenAs::WrongBrightness, "The vector to the light keeps its length in n·l, r and h.",
                "Surfaces far from the light get brighter, and highlights grow into blots.",
                "no_clamp_of_cosine falloff_inverted", "openFrameworks#6221",
                "in n·l, r and h|also in the cone of a spot|except for directional lights|"
                "also in the cone of a spot, except for directional lights"},
    MistakeName{"unnormalized_half", &Mistakes::unnormalized_half, MistakeStage::Equation,
                SeenAs::WrongHighlight, "h = (l + v)/2, as the lecture first writes it, is not normalized.",
                "Highlights shrink and darken where l and v diverge.", "", "openFrameworks#6221",
                "half of l + v|l + v"},
    MistakeName{"specular_behind_surface", &Mistakes::specular_behind_surface, MistakeStage::Equation,
                SeenAs::WrongHighlight, "n·l is not tested before the highlight is added.",
                "A highlight shines on the side that the light cannot reach.",
                "absolute_cosine no_clamp_of_cosine", "scp-fs2open#1353; processing#5362"},
    MistakeName{"no_clamp_of_cosine", &Mistakes::no_clamp_of_cosine, MistakeStage::Equation,
                SeenAs::WrongSide, "Negative cosines are used as they are.",
                "The dark side subtracts light, and an even shininess makes a ghost highlight there.",
                "absolute_cosine specular_behind_surface", "TinyRenderer's wiki, \"Visual troubleshooting\""},
    MistakeName{"half_angle_with_phong_shininess", &Mistakes::half_angle_with_phong_shininess,
                MistakeStage::Equation, SeenAs::WrongHighlight,
                "n·h in place of r·v with the same shininess.",
                "The highlight is about twice as wide (four times the exponent would match).", "",
                "Stack Overflow 24132774"},
    MistakeName{"ambient_per_light_added_twice", &Mistakes::ambient_per_light_added_twice,
                MistakeStage::Equation, SeenAs::WrongBrightness,
                "Each light's ambient contribution counts twice.", "Dark sides turn grey.", "lit_in_srgb",
                "Software Engineering SE \"Combination lighting shader\""},
    MistakeName{"clamp_each_light", &Mistakes::clamp_each_light, MistakeStage::Equation,
                SeenAs::WrongBrightness, "Each light's contribution is clamped to 1 before it is added.",
                "Differences disappear where bright lights overlap.", "average_of_lights",
                "TinyRenderer's wiki, \"Visual troubleshooting\""},
    MistakeName{"shininess_as_fraction", &Mistakes::shininess_as_fraction, MistakeStage::Materials,
                SeenAs::WrongHighlight, "The shininess is divided by 128, as in old material tables.",
                "Every highlight covers half the object.", "shininess_inverted", "Stack Overflow 55875798"},
    MistakeName{"missing_pi", &Mistakes::missing_pi, MistakeStage::Equation, SeenAs::WrongBrightness,
                "Only the diffuse term is divided by π.", "Diffuse light is a third as bright.",
                "average_of_lights", "aframevr/aframe#5546; f3d-app/f3d#816"},
    MistakeName{"absolute_cosine", &Mistakes::absolute_cosine, MistakeStage::Equation, SeenAs::WrongSide,
                "|n·l| in place of max(n·l, 0), in the diffuse term and in the test for the highlight.",
                "The side away from the light is lit like the side towards it.",
                "flipped_by_view specular_behind_surface", "TinyRenderer's wiki, \"Visual troubleshooting\""},
    MistakeName{
        "reflect_sign", &Mistakes::reflect_sign, MistakeStage::Equation, SeenAs::WrongHighlight,
        "r = l − 2 (n·l) n: GLSL's reflect() given l, which points the other way. Phong's highlight only.",
        "The highlight is missing, or is at the edge away from the light.", "view_reversed",
        "Stack Overflow 24132774"},
    MistakeName{"reflect_of_difference", &Mistakes::reflect_of_difference, MistakeStage::Equation,
                SeenAs::WrongHighlight, "r = 2 (n·l) (n − l), not normalized. Phong's highlight only.",
                "The highlight is a ring or a crescent, dark where it should be brightest.", "reflect_sign",
                "Stack Overflow 24132774"},
    MistakeName{"power_zero_is_nan", &Mistakes::power_zero_is_nan, MistakeStage::Equation,
                SeenAs::SpotsAndHoles,
                "pow(0, 0) is NaN: where the highlight's cosine is 0 or less and the shininess is 0, "
                "the pixel is NaN.",
                "Black holes with hard edges where the rest is bright; NaN in a floating-point file.", "",
                "three.js#5222; godot#14796"},
    MistakeName{"light_in_wrong_space", &Mistakes::light_in_wrong_space, MistakeStage::Lights,
                SeenAs::MovesWithCamera,
                "World lights are treated as camera lights, and camera lights as world lights.",
                "World lights move with the camera, and camera lights do not.",
                "light_moved_twice light_by_inverse_view normals_left_in_world",
                "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{"light_moved_twice", &Mistakes::light_moved_twice, MistakeStage::Lights,
                SeenAs::MovesWithCamera, "The view matrix is applied once too often to every light.",
                "Lights swing the wrong way as the camera orbits.",
                "light_in_wrong_space light_by_inverse_view",
                "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{
        "falloff_of_directional", &Mistakes::falloff_of_directional, MistakeStage::Lights, SeenAs::WrongReach,
        "A directional light is dimmed by the length of its position vector, as if that were a distance.",
        "The sun's brightness depends on how its direction is written.", "", "threepp#10"},
    MistakeName{"falloff_without_constant", &Mistakes::falloff_without_constant, MistakeStage::Lights,
                SeenAs::WrongReach, "The constant term of the falloff is missing.",
                "Surfaces near a light are overexposed; without other coefficients, the light goes out.",
                "falloff_forgotten", "threepp#10"},
    MistakeName{"degrees_for_radians", &Mistakes::degrees_for_radians, MistakeStage::Lights,
                SeenAs::WrongReach, "The cutoff is passed to cos() in degrees, as if it were radians.",
                "The cone's width is unrelated to the cutoff.", "cutoff_as_full_angle",
                "three.js#3291; glTF-Sample-Viewer#405"},
    MistakeName{"cutoff_as_full_angle", &Mistakes::cutoff_as_full_angle, MistakeStage::Lights,
                SeenAs::WrongReach, "The cutoff is treated as the full angle of the cone.",
                "The pool of light is half as wide.", "degrees_for_radians",
                "three.js#3291; glTF-Sample-Viewer#405"},
    MistakeName{"viewer_at_origin_of_world", &Mistakes::viewer_at_origin_of_world, MistakeStage::Viewer,
                SeenAs::MovesWithCamera, "v points to the world's origin instead of the eye.",
                "Highlights stick to the surface while the camera moves.", "view_reversed", "melonJS#1636"},
    MistakeName{"lit_after_projection", &Mistakes::lit_after_projection, MistakeStage::Viewer,
                SeenAs::MovesWithCamera, "Points are lit after projection.",
                "Angles and distances to lights are distorted.", "", "Munzner, \"Lighting\""},
    MistakeName{"light_by_inverse_view", &Mistakes::light_by_inverse_view, MistakeStage::Lights,
                SeenAs::MovesWithCamera,
                "A world light's position, aim and edges are transformed by world_from_view instead of "
                "view_from_world.",
                "Lights move twice as far as the camera, the wrong way.",
                "light_in_wrong_space light_moved_twice",
                "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{"direction_is_position", &Mistakes::direction_is_position, MistakeStage::Lights,
                SeenAs::WrongSide,
                "A directional light's `position` is treated as a point (w = 1), without falloff.",
                "The sun looks like a nearby bulb: each object is lit from a different side.",
                "light_in_wrong_space", "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{"light_direction_reversed", &Mistakes::light_direction_reversed, MistakeStage::Lights,
                SeenAs::WrongSide, "l = −l for directional lights.",
                "The sun lights the side that faces away from it.", "normals_flipped",
                "gamedev.net \"Directional Lighting Question\"",
                "directional lights|bulbs and spots|bulbs and spots, including their cones"},
    MistakeName{"aim_stays_at_origin", &Mistakes::aim_stays_at_origin, MistakeStage::Lights,
                SeenAs::WrongReach,
                "A spot points from its position to the world's origin, regardless of its `direction`.",
                "The pool of light does not turn with the lamp.", "light_in_wrong_space", "three.js#5555"},
    MistakeName{"cone_cosines_swapped", &Mistakes::cone_cosines_swapped, MistakeStage::Lights,
                SeenAs::WrongReach,
                "The spot lights everything outside its cutoff, with factor 1, and nothing inside.",
                "A dark pool where the light should be, and light all around it.", "degrees_for_radians",
                "three.js#3291; glTF-Sample-Viewer#405"},
    MistakeName{"falloff_inverted", &Mistakes::falloff_inverted, MistakeStage::Lights, SeenAs::WrongReach,
                "Light is multiplied by constant + linear r + quadratic r² instead of divided.",
                "Surfaces far from the light are brightest.", "unnormalized_light", "threepp#10"},
    MistakeName{"falloff_forgotten", &Mistakes::falloff_forgotten, MistakeStage::Lights, SeenAs::WrongReach,
                "Every light has a falloff of 1. Spot cones and light areas still apply.",
                "Distant surfaces are as bright as near ones.", "falloff_without_constant", "threepp#10"},
    MistakeName{"last_light_only", &Mistakes::last_light_only, MistakeStage::Lights, SeenAs::WrongBrightness,
                "Each light overwrites the one before: only the last enabled one counts.",
                "Lights are missing; if the last one is switched off, another one appears.", "",
                "Software Engineering SE \"Combination lighting shader\"", "the last light|the first light"},
    MistakeName{"average_of_lights", &Mistakes::average_of_lights, MistakeStage::Lights,
                SeenAs::WrongBrightness,
                "The lights' contributions are divided by the number of enabled lights.",
                "Every additional light makes the others darker.", "missing_pi last_light_only",
                "Software Engineering SE \"Combination lighting shader\""},
    MistakeName{"unnormalized_view", &Mistakes::unnormalized_view, MistakeStage::Viewer,
                SeenAs::WrongHighlight, "v is not normalized: every term uses v = eye − p.",
                "Highlights grow with the distance of the eye.", "shininess_inverted unnormalized_light",
                "openFrameworks#6221"},
    MistakeName{"view_reversed", &Mistakes::view_reversed, MistakeStage::Viewer, SeenAs::WrongHighlight,
                "v points away from the eye.",
                "Highlights are missing, or are at the rim opposite the light.",
                "reflect_sign viewer_at_origin_of_world", "melonJS#1636"},
    MistakeName{"perspective_view_in_ortho", &Mistakes::perspective_view_in_ortho, MistakeStage::Viewer,
                SeenAs::WrongHighlight, "Under an orthographic camera v points from the point to the eye.",
                "Highlights of directional lights are where a perspective camera would show them.", "",
                "melonJS#1636"},
    MistakeName{"lit_in_srgb", &Mistakes::lit_in_srgb, MistakeStage::Materials, SeenAs::WrongBrightness,
                "Material colours are lit as sRGB values, like a texture that was not decoded.",
                "Colours are pale, and dark sides are too light.",
                "encoded_twice ambient_per_light_added_twice", "aframevr/aframe#5546; f3d-app/f3d#816"},
    MistakeName{"coefficients_swapped", &Mistakes::coefficients_swapped, MistakeStage::Materials,
                SeenAs::WrongHighlight, "k_d and k_s are swapped.",
                "Objects take on the colour of their highlights, and vice versa.", "",
                "Stack Overflow 55875798"},
    MistakeName{"shininess_inverted", &Mistakes::shininess_inverted, MistakeStage::Materials,
                SeenAs::WrongHighlight, "The exponent is 1 / shininess; 0 stays 0.",
                "Shiny objects are flooded by one huge highlight.", "shininess_as_fraction",
                "Stack Overflow 55875798"},
    MistakeName{"unnormalized_normals", &Mistakes::unnormalized_normals, MistakeStage::Normals,
                SeenAs::WrongBrightness,
                "Normals keep the length that they have in the file, and scaling changes it.",
                "Brightness follows the length, so small objects are too bright.",
                "interpolated_normals_not_normalized", "GL_NORMALIZE threads; openFrameworks#6221",
                "the highlight's cosine may exceed 1|it is clamped to 1"},
    MistakeName{"normals_by_model_matrix", &Mistakes::normals_by_model_matrix, MistakeStage::Normals,
                SeenAs::WrongSide,
                "Normals are transformed by the same matrix as points instead of its inverse transpose.",
                "A squashed ball is shaded as if it leaned the wrong way.", "normals_left_in_object",
                "bdero/flutter_scene#140; KhronosGroup/glTF-Sample-Viewer#60"},
    MistakeName{"normals_flipped", &Mistakes::normals_flipped, MistakeStage::Normals, SeenAs::WrongSide,
                "Every normal points inwards.", "Everything is lit from the wrong side.",
                "light_direction_reversed cross_reversed", "mitsuba2#132; mitsuba3#919"},
    MistakeName{"no_normals_given", &Mistakes::no_normals_given, MistakeStage::Normals, SeenAs::WrongFaces,
                "No normals are given, so all are (0, 0, 1) in object coordinates.",
                "A ball is shaded like a disc.", "", "three.js#20498"},
    MistakeName{"interpolated_normals_not_normalized", &Mistakes::interpolated_normals_not_normalized,
                MistakeStage::Normals, SeenAs::WrongBrightness,
                "Interpolated normals are not normalized at the pixel.", "Faces are darker in the middle.",
                "unnormalized_normals", "openFrameworks#6221"},
    MistakeName{"normals_left_in_object", &Mistakes::normals_left_in_object, MistakeStage::Normals,
                SeenAs::MovesWithCamera,
                "Normals stay in object coordinates: the model and the view do not transform them.",
                "The lit side is painted on: it turns with the object and with the camera.",
                "normals_left_in_world normals_by_model_matrix",
                "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{"normals_left_in_world", &Mistakes::normals_left_in_world, MistakeStage::Normals,
                SeenAs::MovesWithCamera,
                "Normals are transformed by the model's inverse transpose but not by the view: they stay in "
                "world coordinates.",
                "The lit side moves as the camera orbits.", "normals_left_in_object light_in_wrong_space",
                "raysan5/raylib#1870; facebookresearch/momentum#1571; three.js#481"},
    MistakeName{"normals_as_points", &Mistakes::normals_as_points, MistakeStage::Normals, SeenAs::WrongSide,
                "Normals are transformed like points, with w = 1 and translation, and normalized afterwards.",
                "Objects far from the eye are lit evenly, as flat as a cut-out.",
                "no_normals_given normals_by_model_matrix", "Khronos forum \"GLSL per-vertex Phong\"",
                "of view and model|of the model alone, in a program that lights in world coordinates"},
    MistakeName{
        "some_faces_flipped", &Mistakes::some_faces_flipped, MistakeStage::Normals, SeenAs::WrongFaces,
        "Every third facet in the file's order, starting with the first, has reversed normals.",
        "Some faces are black, in a pattern.", "cross_reversed flipped_twice", "mitsuba2#132; mitsuba3#919"},
    MistakeName{"cross_reversed", &Mistakes::cross_reversed, MistakeStage::Normals, SeenAs::WrongFaces,
                "Facet normals, and vertex normals averaged from them, are reversed; those from a file or a "
                "formula are not.",
                "Faces are lit from behind where no normals were given.", "normals_flipped",
                "mitsuba2#132; mitsuba3#919"},
    MistakeName{"mirror_turns_inside_out", &Mistakes::mirror_turns_inside_out, MistakeStage::Normals,
                SeenAs::WrongFaces, "The normals of mirrored objects are reversed.",
                "Only mirrored objects are lit from the wrong side.", "normals_flipped",
                "three.js#4904; godot#53642"},
    MistakeName{"flipped_by_view", &Mistakes::flipped_by_view, MistakeStage::Normals, SeenAs::WrongFaces,
                "Each normal is flipped towards the viewer, regardless of `two_sided`.",
                "The inside of open surfaces is lit, and specks shine along silhouettes.",
                "flipped_twice absolute_cosine", "KhronosGroup/glTF-Sample-Viewer#51; VSG#703"},
    MistakeName{"flipped_twice", &Mistakes::flipped_twice, MistakeStage::Normals, SeenAs::WrongFaces,
                "With `two_sided`, the normals of back faces are flipped twice, so not at all.",
                "The inside of open surfaces is dark although both sides should be lit.", "flipped_by_view",
                "KhronosGroup/glTF-Sample-Viewer#51; VSG#703"},
    MistakeName{"culled_by_light", &Mistakes::culled_by_light, MistakeStage::Faces, SeenAs::SpotsAndHoles,
                "Faces that face away from the first enabled light are not drawn.",
                "Holes in the shade, through which the far side is visible.", "", "tinyrenderer#59"},
    MistakeName{"encoded_twice", &Mistakes::encoded_twice, MistakeStage::Display, SeenAs::WrongBrightness,
                "The displayed value is sRGB-encoded again after `transfer`.",
                "Everything is pale and washed out, including the background.", "lit_in_srgb",
                "aframevr/aframe#5546; f3d-app/f3d#816"},
    MistakeName{"bytes_wrap", &Mistakes::bytes_wrap, MistakeStage::Display, SeenAs::SpotsAndHoles,
                "The displayed value is not clamped: the byte is floor(255 x + ½) modulo 256.",
                "Black or oddly coloured blots in the middle of areas that are too bright.",
                "power_zero_is_nan", "TinyRenderer's wiki, \"Visual troubleshooting\""},
    MistakeName{"power_of_negative_is_nan", &Mistakes::power_of_negative_is_nan, MistakeStage::Equation,
                SeenAs::SpotsAndHoles,
                "pow() of a negative cosine is NaN: where r·v (or n·h) is below 0 the pixel is NaN.",
                "Parts without a highlight are black, despite ambient light.", "power_zero_is_nan",
                "three.js#5626", "shown black|shown white"},
    MistakeName{"half_lambert", &Mistakes::half_lambert, MistakeStage::Equation, SeenAs::WrongSide,
                "(1 + n·l) / 2 in place of max(n·l, 0).",
                "Light wraps around to the side away from the light.", "absolute_cosine", "godot#65515",
                "plain|squared"},
    MistakeName{"specular_without_cosine", &Mistakes::specular_without_cosine, MistakeStage::Equation,
                SeenAs::WrongHighlight, "Cook–Torrance's term is not multiplied by n·l.",
                "Highlights glare where light grazes the surface.", "fresnel_of_view_angle", "QGIS#65961"},
    MistakeName{"fresnel_of_view_angle", &Mistakes::fresnel_of_view_angle, MistakeStage::Equation,
                SeenAs::WrongHighlight, "Fresnel's factor uses n·v in place of v·h.",
                "Highlights brighten towards the silhouette.", "specular_without_cosine", ""},
    MistakeName{"ambient_not_attenuated", &Mistakes::ambient_not_attenuated, MistakeStage::Equation,
                SeenAs::WrongReach, "A light's ambient contribution ignores its falloff and cone.",
                "Far from a lamp and outside its cone, surfaces are too bright.",
                "ambient_per_light_added_twice", "castle-model-viewer#15"},
    MistakeName{
        "position_is_direction", &Mistakes::position_is_direction, MistakeStage::Lights, SeenAs::WrongSide,
        "The position of a bulb or spot is used as the direction to it: the point is not subtracted.",
        "A lamp shines like a sun: everything is lit from one side.", "light_in_wrong_space", "gama.old#1711",
        "its direction, at the true distance|the place in camera coordinates, at the true "
        "distance|its direction and its length|the place in camera coordinates and its length"},
    MistakeName{"distance_is_one", &Mistakes::distance_is_one, MistakeStage::Lights, SeenAs::WrongReach,
                "The distance is measured after l is normalized, so it is 1 everywhere.",
                "Brightness does not fall off with the distance.", "falloff_forgotten", "many-lights-gi#1"},
    MistakeName{"distance_includes_w", &Mistakes::distance_includes_w, MistakeStage::Lights,
                SeenAs::WrongReach,
                "The length is that of the four components (L − P, 1), in l and in the falloff.",
                "Surfaces near a lamp are too dark.", "unnormalized_light", "three.js#33679"},
    MistakeName{"divided_by_square", &Mistakes::divided_by_square, MistakeStage::Lights, SeenAs::WrongReach,
                "l is divided by l·l in place of its length.",
                "Surfaces farther than one unit from a lamp are too dark, and nearer ones are too bright.",
                "unnormalized_light", "ray4#11", "l|l and v"},
    MistakeName{"distance_across_spaces", &Mistakes::distance_across_spaces, MistakeStage::Lights,
                SeenAs::MovesWithCamera,
                "The distance for the falloff is between the light in world coordinates and the point in "
                "camera coordinates.",
                "Lamps brighten and fade as the camera moves.", "falloff_inverted", "habitat-sim#961"},
    MistakeName{"spot_direction_left_in_world", &Mistakes::spot_direction_left_in_world, MistakeStage::Lights,
                SeenAs::MovesWithCamera,
                "A spot's axis is not transformed to camera coordinates; its position is.",
                "The pool of light swings as the camera orbits.", "aim_stays_at_origin", "lwjglbook#24"},
    MistakeName{"ambient_without_material", &Mistakes::ambient_without_material, MistakeStage::Materials,
                SeenAs::WrongBrightness, "Ambient light is added without k_a.",
                "Shadows have the colour of the light instead of the object's.",
                "ambient_per_light_added_twice", "VulkanSceneGraph#432",
                "the global ambient light|all ambient light"},
    MistakeName{"highlight_tinted", &Mistakes::highlight_tinted, MistakeStage::Materials,
                SeenAs::WrongHighlight,
                "The entire sum, including the highlight, is multiplied by the object's diffuse colour.",
                "Highlights are dull and have the object's colour.", "coefficients_swapped",
                "LearnOpenGL, \"Basic Lighting\""},
    MistakeName{
        "highlight_normalized", &Mistakes::highlight_normalized, MistakeStage::Materials,
        SeenAs::WrongHighlight, "The highlight is multiplied by (n + 8) / 8π, where n is the shininess.",
        "Sharp highlights are too bright, and wide ones are too dark.", "", "godot#50455",
        "(n + 8) / 8π|(n + 2) / 2π|(n + 2) / 8|(n + 2) / 8, n·l and Fresnel's factor, as in three.js"},
    MistakeName{"alpha_not_squared", &Mistakes::alpha_not_squared, MistakeStage::Materials,
                SeenAs::WrongHighlight,
                "The width of the microfacets is the roughness instead of its square.",
                "Highlights are too wide, especially on smooth surfaces.", "", "three.js#8348",
                "the roughness itself|its fourth power"},
    MistakeName{"normals_without_model", &Mistakes::normals_without_model, MistakeStage::Normals,
                SeenAs::WrongSide,
                "Normals are transformed by the view alone; the model's matrix is missing.",
                "Shading does not turn with the object.", "normals_left_in_object", "thunder#61"},
    MistakeName{"normals_by_inverse", &Mistakes::normals_by_inverse, MistakeStage::Normals, SeenAs::WrongSide,
                "Normals are transformed by the inverse of the matrix, not transposed.",
                "Rotations turn the shading the wrong way.", "normals_by_model_matrix",
                "cocos2d-objc#1214; Terasology#3885",
                "of view and model|of the model alone|the view transposed"},
    MistakeName{"normals_by_projection", &Mistakes::normals_by_projection, MistakeStage::Normals,
                SeenAs::WrongSide,
                "Normals are transformed by the inverse transpose of projection, view and model.",
                "Everything has nearly the same brightness, or is black.", "normals_as_points",
                "tinyrenderer#155", "the inverse transpose|the matrix itself"},
    MistakeName{
        "facet_normals_of_screen_points", &Mistakes::facet_normals_of_screen_points, MistakeStage::Normals,
        SeenAs::WrongFaces,
        "A facet's cross product is computed from projected corners: all normals point to the viewer.",
        "All facets are lit equally.", "no_normals_given", "tinyrenderer#47"},
    MistakeName{"cross_component_wrong", &Mistakes::cross_component_wrong, MistakeStage::Normals,
                SeenAs::WrongFaces, "One component of a facet's cross product has the wrong sign.",
                "Facets are lit as if mirrored.", "cross_reversed", "tinyrenderer#120", "y|x|z"},
    MistakeName{"facet_normal_of_first_corners", &Mistakes::facet_normal_of_first_corners,
                MistakeStage::Normals, SeenAs::WrongFaces,
                "The normal of a polygon comes from its first three corners.",
                "Some polygons with a notch are lit from behind.", "some_faces_flipped", "Elements#652"},
    MistakeName{"last_facet_wins", &Mistakes::last_facet_wins, MistakeStage::Normals, SeenAs::WrongFaces,
                "A vertex has the normal of its last facet instead of the average.",
                "Smooth surfaces look torn, with streaks across the faces.", "some_faces_flipped",
                "pycollada#37"},
    MistakeName{"normals_axes_exchanged", &Mistakes::normals_axes_exchanged, MistakeStage::Normals,
                SeenAs::WrongSide, "Components of the normals are swapped or negated: y and z swapped.",
                "The light seems to come along a different axis.", "normals_flipped", "rviz#339", "axes"},
    MistakeName{"positions_as_normals", &Mistakes::positions_as_normals, MistakeStage::Normals,
                SeenAs::WrongFaces, "The position attribute is bound as the normal.",
                "Flat faces are shaded as if bulging from the object's origin.", "normals_left_in_object",
                "raylib#1865"},
    MistakeName{"normals_by_position_index", &Mistakes::normals_by_position_index, MistakeStage::Normals,
                SeenAs::WrongFaces, "Normals are looked up by the position's index.",
                "Some faces are shaded like other faces.", "last_facet_wins", "Pangolin#502"},
    MistakeName{"interpolated_lengths", &Mistakes::interpolated_lengths, MistakeStage::Normals,
                SeenAs::WrongSide,
                "Corner normals are interpolated with their lengths, and normalized only at the pixel.",
                "Shading leans towards corners with long normals.", "unnormalized_normals", "cesium#6008"},
    MistakeName{"zero_normal_is_nan", &Mistakes::zero_normal_is_nan, MistakeStage::Normals,
                SeenAs::SpotsAndHoles, "A corner without a normal makes its faces NaN.",
                "Individual faces are black.", "power_zero_is_nan", "bevy#10905"},
};

}  // namespace

std::span<const MistakeName> mistake_names() { return names; }

std::size_t mistake_index(bool Mistakes::*flag) {
    const auto at =
        std::find_if(names.begin(), names.end(), [flag](const MistakeName& m) { return m.flag == flag; });
    return static_cast<std::size_t>(at - names.begin());
}

int form_count(const MistakeName& mistake) {
    if (mistake.flag == &Mistakes::normals_axes_exchanged) return axes_forms;
    return 1 + static_cast<int>(std::count(mistake.forms.begin(), mistake.forms.end(), '|'));
}

std::string form_words(const MistakeName& mistake, int form) {
    if (mistake.flag == &Mistakes::normals_axes_exchanged) {
        const AxesForm axes = axes_form(form);
        std::string words = "(";
        for (int i = 0; i < 3; ++i) {
            words += axes.sign[i] < 0 ? "-" : "";
            words += "xyz"[axes.from[i]];
            words += i < 2 ? ", " : ") for (x, y, z)";
        }
        return words;
    }
    std::string_view left = mistake.forms;
    for (int i = 0; i < form; ++i) left.remove_prefix(std::min(left.size(), left.find('|') + 1));
    return std::string(left.substr(0, left.find('|')));
}

AxesForm axes_form(int form) {
    constexpr int orders[6][3] = {{0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const int code = form < 8 ? form : form + 1;  // the identity is left out
    const int* order = orders[code / 8 % 6];
    AxesForm axes{};
    for (int i = 0; i < 3; ++i) {
        axes.from[i] = order[i];
        axes.sign[i] = (code >> i & 1) != 0 ? -1 : 1;
    }
    return axes;
}

std::string_view heading_of(SeenAs seen_as) {
    switch (seen_as) {
    case SeenAs::MovesWithCamera:
        return "Light moves with the camera";
    case SeenAs::WrongSide:
        return "Light comes from the wrong side";
    case SeenAs::WrongFaces:
        return "Some faces or objects are black";
    case SeenAs::WrongBrightness:
        return "Too dark, too bright or washed out";
    case SeenAs::WrongHighlight:
        return "No highlight, or a wrong one";
    case SeenAs::WrongReach:
        return "A lamp's cone or distance is wrong";
    case SeenAs::SpotsAndHoles:
        return "Black spots, holes, torn colours";
    }
    return {};  // not reached
}

}  // namespace glint
