#include "tests/support/mistake_scenes.h"

#include <string>

#include "tests/support/scenes.h"

namespace glint::test {
namespace {

void camera_at_origin(Scene& s) {
    s.camera = Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, {}};
    for (Object& o : s.objects) o.transform.translate.z -= 4;
}

void rigid(Scene& s) {
    for (Object& o : s.objects) o.transform.scale = glm::vec3(1);
}

/// A plane that faces the camera squarely, so that all normals are equal and of unit length.
void one_plane(Scene& s) {
    s.objects = {object_of(primitive(Primitive::Plane, 3))};
    s.objects[0].transform.rotate_deg.x = 90;
}

const auto anywhere = [](Scene&) {};
const auto reflection = [](Reflection model) { return [model](Scene& s) { s.shading.reflection = model; }; };
const auto only = [](LightKind kind) {
    return [kind](Scene& s) {
        for (Light& l : s.lights) l.enabled = l.kind == kind;
    };
};
const auto without_highlights = [](Scene& s) { s.shading.terms.specular = false; };
const auto shininess = [](float exponent) {
    return [exponent](Scene& s) {
        s.shading.reflection = Reflection::Phong;
        for (Object& o : s.objects) o.material.shininess = exponent;
    };
};
const auto brightness = [](float intensity) {
    return [intensity](Scene& s) {
        for (Light& l : s.lights) l.intensity = intensity;
    };
};
const auto unlit = [](Scene& s) {
    for (Light& l : s.lights) l.enabled = false;
};
const auto all_faces_the_light = [](Scene& s) {
    one_plane(s);
    s.lights = {Light{}};
    s.lights[0].position = {0, 0, 3, 1};
    s.shading.reflection = Reflection::Lambert;
};
const auto without_rotations = [](Scene& s) {
    camera_at_origin(s);
    for (Object& o : s.objects) o.transform = {o.transform.translate, {0, 0, 0}, {1, 1, 1}};
};
const auto only_averaged = [](Scene& s) { s.objects.resize(1); };  // its normals are averaged
const auto only_analytic = [](Scene& s) {                          // normals come from a formula
    s.objects.resize(1);
    s.objects[0].normals.source = NormalSource::Analytic;
};

const std::vector<MistakeScenes> table{
    {"unnormalized_light", anywhere,
     [](Scene& s) {  // a sun whose vector already has unit length
         only(LightKind::Directional)(s);
         s.lights[0].position = {0, 1, 0, 0};
         camera_at_origin(s);
     }},
    {"unnormalized_half", anywhere, reflection(Reflection::Phong)},
    {"specular_behind_surface",
     [](Scene& s) { s.objects[0].material.shininess = s.objects[1].material.shininess = 2; },
     without_highlights},
    {"no_clamp_of_cosine", anywhere, all_faces_the_light},
    {"half_angle_with_phong_shininess", reflection(Reflection::Phong), reflection(Reflection::BlinnPhong)},
    {"ambient_per_light_added_twice", anywhere,
     [](Scene& s) {
         for (Light& l : s.lights) l.ambient = {0, 0, 0};
     }},
    {"clamp_each_light", brightness(10), brightness(0.2f)},
    {"shininess_as_fraction", anywhere, without_highlights},
    {"missing_pi", anywhere, [](Scene& s) { s.shading.terms.diffuse = false; }},
    {"absolute_cosine", anywhere, all_faces_the_light},
    {"reflect_sign", reflection(Reflection::Phong), reflection(Reflection::BlinnPhong)},
    {"reflect_of_difference", reflection(Reflection::Phong), reflection(Reflection::Retro)},
    {"power_zero_is_nan", shininess(0), shininess(1)},
    {"light_in_wrong_space", anywhere, camera_at_origin},
    {"light_moved_twice", anywhere, camera_at_origin},
    {"falloff_of_directional", anywhere, only(LightKind::Point)},
    {"falloff_without_constant", anywhere, only(LightKind::Directional)},
    {"degrees_for_radians", anywhere, only(LightKind::Point)},
    {"cutoff_as_full_angle", anywhere, only(LightKind::Point)},
    {"viewer_at_origin_of_world", anywhere, camera_at_origin},
    {"lit_after_projection", anywhere,
     [](Scene& s) {  // directions to a sun and to a viewer at infinity are the same everywhere
         only(LightKind::Directional)(s);
         s.shading.local_viewer = false;
     }},
    {"light_by_inverse_view", anywhere,
     [](Scene& s) {
         for (Light& l : s.lights) l.space = LightSpace::Camera;
     }},
    {"direction_is_position", anywhere, only(LightKind::Point)},
    {"light_direction_reversed", anywhere, only(LightKind::Point)},
    {"aim_stays_at_origin", anywhere, only(LightKind::Area)},
    {"cone_cosines_swapped", anywhere, [](Scene& s) { s.lights[2].spot.cutoff_deg = 180; }},
    {"falloff_inverted", anywhere, only(LightKind::Directional)},
    {"falloff_forgotten", anywhere, only(LightKind::Area)},
    {"last_light_only", anywhere, only(LightKind::Point)},
    {"average_of_lights", anywhere, only(LightKind::Spot)},
    {"unnormalized_view", anywhere, [](Scene& s) { s.shading.local_viewer = false; }},
    {"view_reversed", anywhere, reflection(Reflection::Lambert)},
    {"perspective_view_in_ortho",
     [](Scene& s) {
         s.camera.projection = Orthographic{4, 0.1f, 100};
     },
     anywhere},
    {"lit_in_srgb", anywhere,
     [](Scene& s) {  // 0 and 1 are encoded as themselves
         for (Object& o : s.objects) {
             o.material.ambient = o.material.specular = {0, 0, 1};
             o.material.diffuse = {1, 0, 0};
             o.material.emission = {0, 0, 0};
         }
     }},
    {"coefficients_swapped", anywhere,
     [](Scene& s) {
         for (Object& o : s.objects) o.material.specular = o.material.diffuse;
     }},
    {"shininess_inverted", anywhere, shininess(1)},
    {"unnormalized_normals", anywhere, [](Scene& s) { s.shading.mode = ShadingMode::Flat; }},
    {"normals_by_model_matrix", anywhere, rigid},
    {"normals_flipped", anywhere,
     [](Scene& s) {
         for (Light& l : s.lights) l.enabled = false;
     }},
    {"no_normals_given", anywhere,
     [](Scene& s) {  // a quad whose normal is (0, 0, 1) anyway
         s.objects = {object_of(primitive(Primitive::SkewQuad, 1))};
     }},
    {"interpolated_normals_not_normalized", anywhere,
     [](Scene& s) { s.shading.mode = ShadingMode::Gouraud; }},
    {"normals_left_in_object", anywhere, without_rotations},
    {"normals_left_in_world", anywhere, camera_at_origin},
    {"normals_as_points", anywhere, unlit},
    {"some_faces_flipped", anywhere, unlit},
    {"cross_reversed", anywhere, only_analytic},
    {"mirror_turns_inside_out", anywhere, [](Scene& s) { s.objects.resize(1); }},
    {"flipped_by_view", anywhere, one_plane},
    {"flipped_twice",
     [](Scene& s) {  // a plane seen from behind
         one_plane(s);
         s.objects[0].transform.rotate_deg.x = -90;
         s.shading.two_sided = true;
     },
     anywhere},
    {"culled_by_light", anywhere, unlit},
    {"encoded_twice", anywhere,
     [](Scene& s) {  // everything is black and stays black
         unlit(s);
         s.global_ambient = s.display.background = glm::vec3(0);
         for (Object& o : s.objects) o.material.emission = glm::vec3(0);
     }},
    {"bytes_wrap", brightness(10), brightness(0.05f)},
    {"power_of_negative_is_nan", reflection(Reflection::Phong), reflection(Reflection::Lambert)},
    {"half_lambert", anywhere, [](Scene& s) { s.shading.terms.diffuse = false; }},
    {"specular_without_cosine", reflection(Reflection::CookTorrance), anywhere},
    {"fresnel_of_view_angle", reflection(Reflection::CookTorrance), anywhere},
    {"ambient_not_attenuated", anywhere,
     [](Scene& s) {
         for (Light& l : s.lights) l.ambient = {0, 0, 0};
     }},
    {"position_is_direction", anywhere, only(LightKind::Directional)},
    {"distance_is_one", anywhere, only(LightKind::Directional)},
    {"distance_includes_w", anywhere, only(LightKind::Area)},
    {"divided_by_square", anywhere, only(LightKind::Directional)},
    {"distance_across_spaces", anywhere, only(LightKind::Area)},
    {"spot_direction_left_in_world", anywhere, only(LightKind::Point)},
    {"ambient_without_material", anywhere,
     [](Scene& s) {
         s.global_ambient = {0, 0, 0};
     }},
    {"highlight_tinted", anywhere, without_highlights},
    {"highlight_normalized", anywhere, without_highlights},
    {"alpha_not_squared", reflection(Reflection::CookTorrance), anywhere},
    {"normals_without_model", anywhere, without_rotations},
    {"normals_by_inverse", anywhere, without_rotations},
    {"normals_by_projection", anywhere, unlit},
    {"facet_normals_of_screen_points", [](Scene& s) { s.shading.mode = ShadingMode::Facet; }, only_averaged},
    {"cross_component_wrong", anywhere, only_analytic},
    {"facet_normal_of_first_corners",
     [](Scene& s) {  // a quadrilateral that is not planar
         s.objects = {
             object_of(polygon_mesh({{-1, -1, 0}, {1, -1, 0.6f}, {1, 1, 0}, {-1, 1, 0.5f}}, {{0, 1, 2, 3}}))};
         s.shading.mode = ShadingMode::Facet;
     },
     only_averaged},
    {"last_facet_wins", anywhere, only_analytic},
    {"normals_axes_exchanged", anywhere, unlit},
    {"positions_as_normals", anywhere, unlit},
    {"normals_by_position_index", anywhere, only_averaged},
    {"interpolated_lengths", anywhere, [](Scene& s) { s.shading.mode = ShadingMode::Flat; }},
    {"zero_normal_is_nan",
     [](Scene& s) {
         auto mesh = std::make_shared<Mesh>(*primitive(Primitive::SkewQuad, 1));
         mesh->given_normals = GivenNormals::File;
         mesh->normals = {{0, 0, 0}};
         mesh->corner_normal = {0, 0, 0, 0};
         s.objects.push_back(object_of(mesh));
     },
     anywhere},
};

}  // namespace

Scene telling_scene() {
    Scene scene = busy_scene();
    for (Light& l : scene.lights) {
        l.ambient = {0.1f, 0.05f, 0.02f};
        l.falloff = {0.5f, 0.1f, 0.05f};
        l.intensity = 1.5f;
    }
    scene.objects[0].transform.scale = {1, 0.6f, 1};
    scene.objects[0].normals.source = NormalSource::Vertex;
    scene.shading.reflection = Reflection::BlinnPhong;
    return scene;
}

const std::vector<MistakeScenes>& mistake_scenes() { return table; }

}  // namespace glint::test
