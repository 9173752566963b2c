#include "programs/scene_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr float fixed_function_most = 128;  // OpenGL 2.1: shininess and a spot's exponent
constexpr std::size_t fixed_function_lights = 8, shader_lights = 32;  // of those that are listed one by one

/// Properties of a scene that are computed once because they are used often.
struct Facts {
    const Scene& scene;
    std::vector<Light> lights = shining(scene);
    std::vector<Object> objects = shown(scene);
    const Shading& shading = scene.shading;
    const Mistakes& wrong = scene.shading.mistakes;

    [[nodiscard]] bool is_lit() const { return shading.reflection != Reflection::None; }
    [[nodiscard]] bool lit_in(ShadingMode mode) const { return is_lit() && shading.mode == mode; }
    [[nodiscard]] bool provoking() const { return flat_at_provoking_corner(shading); }
    /// Whether colours of corners are interpolated.
    [[nodiscard]] bool blends_corners() const {
        return shading.mode != ShadingMode::Flat && (!is_lit() || shading.mode == ShadingMode::Gouraud);
    }
    [[nodiscard]] bool interpolates() const { return blends_corners() || lit_in(ShadingMode::Phong); }
    [[nodiscard]] bool interpolates_by(Interpolation by) const {
        return interpolates() && shading.interpolation == by;
    }
    [[nodiscard]] bool any_light(LightKind kind) const {
        return is_lit() &&
               std::any_of(lights.begin(), lights.end(), [kind](const Light& l) { return l.kind == kind; });
    }
    [[nodiscard]] bool any_falloff() const {
        const auto has = [](const Light& l) { return l.falloff != Falloff{} && l.kind != LightKind::Area; };
        return is_lit() && (wrong.falloff_of_directional || wrong.falloff_without_constant ||
                            wrong.falloff_inverted || std::any_of(lights.begin(), lights.end(), has));
    }
    [[nodiscard]] bool uses_shininess() const {
        return info_of(shading.reflection).uses_shininess() && shading.terms.specular;
    }
    template <class Test> [[nodiscard]] bool any_shininess(const Test& test) const {
        return uses_shininess() && std::any_of(objects.begin(), objects.end(), [&test](const Object& o) {
                   return test(o.material.shininess);
               });
    }
    /// Where the corners' normals are zero, a point uses the facet's.
    [[nodiscard]] bool any_normal_missing() const {
        std::set<NormalsKey> looked_at;  // once each: many objects may share one large mesh
        return std::any_of(objects.begin(), objects.end(), [&looked_at](const Object& o) {
            if (!looked_at.insert(normals_key(o)).second) return false;
            const std::vector<glm::vec3> normals = corner_normals(*o.mesh, o.normals).normals;
            return std::find(normals.begin(), normals.end(), glm::vec3(0)) != normals.end();
        });
    }
    [[nodiscard]] bool infinite_viewer() const {
        const bool orthographic = is_orthographic(scene.camera.projection);
        return !shading.local_viewer || (orthographic && !wrong.perspective_view_in_ortho);
    }
};

struct NeedRow {
    const char *flag, *pointer, *what;
    bool (*is_needed)(const Facts&);
};

bool blends_screen(const Facts& f) { return f.interpolates_by(Interpolation::Screen); }
bool blends_scanline(const Facts& f) { return f.interpolates_by(Interpolation::Scanline); }
bool has_large_exponent(const Facts& f) {
    return f.is_lit() && std::any_of(f.lights.begin(), f.lights.end(), [](const Light& l) {
               return l.kind == LightKind::Spot && l.spot.exponent > fixed_function_most;
           });
}
bool has_soft_edge(const Facts& f) {
    return f.is_lit() && std::any_of(f.lights.begin(), f.lights.end(), [](const Light& l) {
               return l.kind == LightKind::Spot && l.spot.inner_deg < l.spot.cutoff_deg;
           });
}
bool is_capped(const Facts& f) {
    return f.shading.rules == Rules::OpenGL2 &&
           f.any_shininess([](float s) { return s > fixed_function_most; });
}

/// Whether something extends behind the near plane, where it has no position on the screen.
bool near_plane_cuts(const Facts& f) {
    if (!blends_screen(f) && !blends_scanline(f)) return false;
    const glm::dmat4 clip_from_world =
        clip_from_view(f.scene.camera.projection, {}) * view_from_world(f.scene.camera);
    return std::any_of(f.objects.begin(), f.objects.end(), [&clip_from_world](const Object& o) {
        const glm::dmat4 m = clip_from_world * world_from_object(o.transform);
        const auto is_behind = [&m](const glm::dvec3& p) {
            const glm::dvec4 c = m * glm::dvec4(p, 1);
            return c.z < -c.w;
        };
        const auto any_behind = [&is_behind](const auto& places) {
            return std::any_of(places.begin(), places.end(), is_behind);
        };
        // A mesh is not behind the plane if no corner of its bounding box is.
        return any_behind(corners_of(o.mesh->bounds)) && any_behind(o.mesh->positions);
    });
}

/// Without a reflection model, mistakes of lighting have no effect, and programs omit them.
bool shows(const MistakeName& mistake, const Facts& f) {
    return f.is_lit() || mistake.stage == MistakeStage::Faces || mistake.stage == MistakeStage::Display;
}

/// The features that a language may lack.
constexpr std::array need_rows{
    NeedRow{"transport", "/transport/model", "light is blocked or bounces off other surfaces",
            [](const Facts& f) { return f.scene.transport.model != TransportModel::Local && f.is_lit(); }},
    NeedRow{"mistakes.form", "/shading/mistakes/form", "another form of a mistake is made",
            [](const Facts& f) { return f.wrong.form != 0 || f.wrong.highlight_form != 0; }},
    NeedRow{"mistakes.only", "/shading/mistakes", "mistakes are made in a part of the picture",
            [](const Facts& f) { return !f.wrong.only.is_all(); }},
    NeedRow{"mode.phong", "/shading/mode", "normals are interpolated and lit at each pixel",
            [](const Facts& f) { return f.lit_in(ShadingMode::Phong); }},
    NeedRow{"mode.facet", "/shading/mode", "each pixel is lit",
            [](const Facts& f) { return f.lit_in(ShadingMode::Facet); }},
    NeedRow{"mode.flat", "/shading/mode", "each polygon has one colour",
            [](const Facts& f) { return f.shading.mode == ShadingMode::Flat; }},
    NeedRow{"flat.centroid", "/shading/flat_point", "each polygon is lit at its centroid",
            [](const Facts& f) { return f.lit_in(ShadingMode::Flat) && !f.provoking(); }},
    NeedRow{"interpolation.screen", "/shading/interpolation", "interpolation is linear on the screen",
            blends_screen},
    NeedRow{"interpolation.scanline", "/shading/interpolation", "interpolation runs along scanlines",
            blends_scanline},
    NeedRow{"near_cut", "/shading/interpolation", "the near plane cuts polygons interpolated on the screen",
            near_plane_cuts},
    NeedRow{"light.area", "/lights", "an area light shines",
            [](const Facts& f) { return f.any_light(LightKind::Area); }},
    NeedRow{"light.spot", "/lights", "a spot shines",
            [](const Facts& f) { return f.any_light(LightKind::Spot); }},
    NeedRow{"light.falloff", "/lights", "light falls off", [](const Facts& f) { return f.any_falloff(); }},
    NeedRow{"exponent.large", "/lights", "a spot's exponent is above 128", has_large_exponent},
    NeedRow{"spot.soft", "/lights", "a spot has a soft edge", has_soft_edge},
    NeedRow{"spot.soft_mistaken", "/shading/mistakes", "the angles of a soft edge are mistaken",
            [](const Facts& f) {
                return has_soft_edge(f) && (f.wrong.cutoff_as_full_angle || f.wrong.degrees_for_radians);
            }},
    NeedRow{"lights.above_8", "/lights", "more than 8 lights shine",
            [](const Facts& f) { return f.is_lit() && f.lights.size() > fixed_function_lights; }},
    NeedRow{"lights.above_32", "/lights", "more than 32 lights shine",
            [](const Facts& f) { return f.is_lit() && f.lights.size() > shader_lights; }},
    NeedRow{"shininess.capped", "/shading/rules", "a shininess above 128 is used as 128", is_capped},
    NeedRow{"shininess.large", "/objects", "a shininess is above 128",
            [](const Facts& f) {
                return !is_capped(f) && f.any_shininess([](float s) { return s > fixed_function_most; });
            }},
    NeedRow{"shininess.zero", "/objects", "a shininess is 0, where drivers differ",
            [](const Facts& f) { return f.any_shininess([](float s) { return s == 0; }); }},
    NeedRow{"corners.clamped", "/shading/rules", "colours of corners are clamped",
            [](const Facts& f) {
                return f.shading.rules == Rules::OpenGL2 &&
                       (f.lit_in(ShadingMode::Gouraud) || f.lit_in(ShadingMode::Flat));
            }},
    NeedRow{"two_sided", "/shading/two_sided", "both sides of a face are lit",
            [](const Facts& f) { return f.is_lit() && f.shading.two_sided; }},
    NeedRow{"cull.back", "/shading/cull", "back faces are left out",
            [](const Facts& f) { return f.shading.cull == Cull::Back; }},
    NeedRow{"cull.front", "/shading/cull", "front faces are left out",
            [](const Facts& f) { return f.shading.cull == Cull::Front; }},
    NeedRow{"cull.some", "/objects", "an object's back faces are kept while others are left out",
            [](const Facts& f) {
                return f.shading.cull != Cull::None &&
                       std::any_of(f.objects.begin(), f.objects.end(),
                                   [](const Object& o) { return o.double_sided; });
            }},
    NeedRow{"power_table", "/shading/power_table", "powers are looked up in a table",
            [](const Facts& f) { return f.shading.power_table > 0 && f.uses_shininess(); }},
    NeedRow{"tone", "/npr/cool_to_warm", "surfaces are shaded from cool to warm",
            [](const Facts& f) { return f.scene.npr.cool_to_warm && f.is_lit(); }},
    NeedRow{"strokes", "/npr", "silhouettes or creases are drawn",
            [](const Facts& f) { return f.scene.npr.silhouettes || f.scene.npr.creases; }},
    NeedRow{"transfer.srgb", "/display/transfer", "colours are encoded for the display",
            [](const Facts& f) { return f.scene.display.transfer == Transfer::Srgb; }},
    NeedRow{"exposure", "/display/exposure", "colours are multiplied by the exposure",
            [](const Facts& f) { return f.scene.display.exposure != 1; }},
    NeedRow{"culled.unlit", "/shading/mistakes/culled_by_light",
            "a light that nothing is lit by leaves faces out",
            [](const Facts& f) { return f.wrong.culled_by_light && !f.is_lit(); }},
    NeedRow{"normals.flip", "/objects", "an object's normals are turned round",
            [](const Facts& f) {
                return f.is_lit() && std::any_of(f.objects.begin(), f.objects.end(),
                                                 [](const Object& o) { return o.normals.flip; });
            }},
};

void add_derived(Flags& flags, const Facts& f) {
    const auto add = [&flags](const char* flag, bool on) {
        if (on) flags.insert(flag);
    };
    const Terms& terms = f.shading.terms;
    const bool tone = f.scene.npr.cool_to_warm;
    add("reflection.lit", f.is_lit());
    add("flat.provoking", f.shading.mode == ShadingMode::Flat && f.provoking());
    add("corners", f.blends_corners());
    add("needs.blend", f.interpolates());
    add("needs.weights", f.interpolates() || f.lit_in(ShadingMode::Facet));
    add("viewer.infinite", f.infinite_viewer());
    add("projection.orthographic", is_orthographic(f.scene.camera.projection));
    add("projection.frustum", std::holds_alternative<Frustum>(f.scene.camera.projection));
    const bool emission = std::any_of(f.objects.begin(), f.objects.end(),
                                      [](const Object& o) { return o.material.emission != glm::vec3(0); });
    add("terms.emission", terms.emission && !tone && emission);
    add("terms.ambient", terms.ambient && !tone);
    add("terms.diffuse", terms.diffuse && !tone);
    add("terms.specular", terms.specular);
    const bool two_sided = f.is_lit() && f.shading.two_sided;
    add("turned", two_sided || (f.is_lit() && f.wrong.some_faces_flipped));
    add("sides", two_sided || f.shading.cull != Cull::None);
    add("facet_normals",
        (f.lit_in(ShadingMode::Phong) && f.any_normal_missing()) || f.lit_in(ShadingMode::Facet) ||
            (f.lit_in(ShadingMode::Flat) && !f.provoking()) || (f.is_lit() && f.wrong.culled_by_light));
    add("lights_pixels", f.lit_in(ShadingMode::Phong) || f.lit_in(ShadingMode::Facet));
    const bool whole_faces = f.shading.mode == ShadingMode::Flat && !f.provoking();
    add("flat_centroid", whole_faces);
    add("facet_normals_alone", f.is_lit() && (whole_faces || f.shading.mode == ShadingMode::Facet));
    add("lights.any", f.is_lit() && !f.lights.empty());
    add("first_light", f.is_lit() && (tone || f.wrong.culled_by_light));
    add("cosine.above_1",
        f.wrong.unnormalized_light || f.wrong.unnormalized_view || f.wrong.reflect_of_difference ||
            f.wrong.unnormalized_normals);
    add("clamped_highlight", !(f.wrong.no_clamp_of_cosine && f.uses_shininess()));
    add("mirrored", std::any_of(f.objects.begin(), f.objects.end(), [](const Object& o) {
            const glm::vec3& s = o.transform.scale;
            return s.x * s.y * s.z < 0;
        }));
    const bool flips =
        std::any_of(f.objects.begin(), f.objects.end(), [](const Object& o) { return o.normals.flip; });
    add("turned_normals",
        f.is_lit() && (flips || f.wrong.normals_flipped || f.wrong.mirror_turns_inside_out));
    const bool mesh_colors = std::any_of(f.objects.begin(), f.objects.end(),
                                         [](const Object& o) { return !o.mesh->colors.empty(); });
    add("mesh.colors", !f.is_lit() && mesh_colors);
    add("light.world", std::any_of(f.lights.begin(), f.lights.end(),
                                   [](const Light& l) { return l.space == LightSpace::World; }));
    add("light.camera", std::any_of(f.lights.begin(), f.lights.end(),
                                    [](const Light& l) { return l.space == LightSpace::Camera; }));
    add("light.directional", f.any_light(LightKind::Directional));
    add("light.place", f.any_light(LightKind::Point) || f.any_light(LightKind::Spot) ||
                           f.any_light(LightKind::Area) || f.wrong.direction_is_position);
}

}  // namespace

std::vector<Light> shining(const Scene& scene) {
    std::vector<Light> lights;
    for (Light light : scene.lights) {
        if (!light.enabled) continue;
        if (light.kind == LightKind::Spot && light.spot.cutoff_deg == 180) light.kind = LightKind::Point;
        if (light.kind != LightKind::Directional) light.position /= light.position.w;
        lights.push_back(light);
    }
    return lights;
}

std::vector<Object> shown(const Scene& scene) {
    std::vector<Object> objects;
    std::copy_if(scene.objects.begin(), scene.objects.end(), std::back_inserter(objects),
                 [](const Object& o) { return o.visible; });
    return objects;
}

std::vector<Need> needs_of(const Scene& scene) {
    const Facts facts{scene};
    std::vector<Need> needs;
    for (const NeedRow& row : need_rows)
        if (row.is_needed(facts)) needs.push_back({row.flag, row.pointer, row.what});
    const std::string model(name_of(scene.shading.reflection));
    needs.push_back({"reflection." + model, "/shading/reflection", "the model is " + model});
    for (const MistakeName& mistake : mistake_names())
        if (scene.shading.mistakes.*mistake.flag && shows(mistake, facts))
            needs.push_back({fmt::format("wrong.{}", mistake.name),
                             fmt::format("/shading/mistakes/{}", mistake.name), "this mistake is made"});
    return needs;
}

Flags flags_of(const Scene& scene) {
    Flags flags;
    for (const Need& need : needs_of(scene)) flags.insert(need.flag);
    const Facts facts{scene};
    add_derived(flags, facts);
    if (blends_scanline(facts) || near_plane_cuts(facts)) flags.insert("needs.xy");
    return flags;
}

}  // namespace glint
