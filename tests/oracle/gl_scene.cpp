#include "tests/oracle/gl_scene.h"

#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/oracle/gl_parts.h"

namespace glint::oracle {
namespace {

/// The limit on lights in fixed function, and the size of the shader's array.
constexpr std::ptrdiff_t max_lights = 8;

std::ptrdiff_t enabled_lights(const Scene& scene) {
    return std::count_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.enabled; });
}

void set_cull(Cull cull) {
    if (cull == Cull::None) {
        glDisable(GL_CULL_FACE);
        return;
    }
    glEnable(GL_CULL_FACE);
    glCullFace(cull == Cull::Back ? GL_BACK : GL_FRONT);
}

void clear(const glm::vec3& background) {
    glClearColor(background.x, background.y, background.z, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);  // at equal depth, the triangle drawn first stays
}

}  // namespace

glm::dmat4 look_at(const Camera& c) {
    return glm::lookAt(glm::dvec3(c.eye), glm::dvec3(c.target), glm::dvec3(c.up));
}

void load_projection(const Projection& projection, PictureSize size) {
    const double aspect = static_cast<double>(size.width) / size.height;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (const auto* f = std::get_if<Frustum>(&projection)) {
        glFrustum(f->left, f->right, f->bottom, f->top, f->near, f->far);
    } else if (const auto* o = std::get_if<Orthographic>(&projection)) {
        const double up = 0.5 * o->height;
        glOrtho(-up * aspect, up * aspect, -up, up, o->near, o->far);
    } else {
        const auto& p = std::get<Perspective>(projection);
        const glm::dmat4 m = glm::perspective(glm::radians(static_cast<double>(p.fov_y_deg)), aspect,
                                              static_cast<double>(p.near), static_cast<double>(p.far));
        glLoadMatrixd(&m[0][0]);
    }
    glMatrixMode(GL_MODELVIEW);
}

bool lit_at_corner(const Shading& s) {
    return s.flat_point == FlatPoint::Provoking || s.rules == Rules::OpenGL2;
}

void multiply_transform(const Transform& t) {
    glTranslated(t.translate.x, t.translate.y, t.translate.z);
    glRotated(t.rotate_deg.z, 0, 0, 1);
    glRotated(t.rotate_deg.y, 0, 1, 0);
    glRotated(t.rotate_deg.x, 1, 0, 0);
    glScaled(t.scale.x, t.scale.y, t.scale.z);
}

Material seen_material(const Material& material, const Shading& shading) {
    Material m = material;
    if (!shading.terms.emission) m.emission = {};
    if (!shading.terms.ambient) m.ambient = {};
    if (!shading.terms.diffuse) m.diffuse = {};
    if (!shading.terms.specular) m.specular = {};
    return m;
}

bool can_draw(const Scene& scene) {
    const Shading& s = scene.shading;
    const Npr& npr = scene.npr;
    return s.mistakes == Mistakes{} && s.interpolation != Interpolation::Scanline && !npr.silhouettes &&
           !npr.creases && enabled_lights(scene) <= max_lights;
}

bool fixed_function_can_draw(const Scene& scene) {
    const Shading& s = scene.shading;
    const auto reflects = [&s](const Object& o) {
        return o.material.reflection == OwnReflection::Scene &&
               (s.reflection == Reflection::Lambert || s.reflection == Reflection::BlinnPhong);
    };
    const bool mode = (s.mode == ShadingMode::Flat && lit_at_corner(s)) ||
                      (s.mode == ShadingMode::Gouraud && s.interpolation == Interpolation::Perspective);
    const auto holds = [](const Light& l) {
        return l.kind != LightKind::Area && (l.kind != LightKind::Spot || l.spot.exponent <= 128);
    };
    // With a shininess of exactly 0 Mesa uses a shortcut whose highlight is not (n.h)^0 = 1.
    const auto shines = [&s](const Object& o) {
        const bool usable =
            o.material.shininess > 0 && (o.material.shininess <= 128 || s.rules == Rules::OpenGL2);
        return usable || s.reflection == Reflection::Lambert;
    };
    return can_draw(scene) && !scene.npr.cool_to_warm && mode &&
           std::all_of(scene.objects.begin(), scene.objects.end(), reflects) &&
           std::all_of(scene.lights.begin(), scene.lights.end(), holds) &&
           std::all_of(scene.objects.begin(), scene.objects.end(), shines);
}

unsigned GlPainter::program(const Shading& s) {
    struct Kind {
        const char *stage, *interpolated;
    };
    constexpr std::array<Kind, 5> kinds{Kind{"corner", "flat"},
                                        {"corner", "smooth"},
                                        {"corner", "noperspective"},
                                        {"pixel", "smooth"},
                                        {"pixel", "noperspective"}};
    const bool corners = s.mode == ShadingMode::Gouraud || s.reflection == Reflection::None;
    const std::size_t linear =
        s.interpolation == Interpolation::Screen && s.mode != ShadingMode::Facet ? 1 : 0;
    const std::size_t kind = s.mode == ShadingMode::Flat ? 0 : (corners ? 1 : 3) + linear;
    if (!programs_[kind]) programs_[kind] = make_program(kinds[kind].stage, kinds[kind].interpolated, wrong_);
    return programs_[kind];
}

void GlPainter::draw(const Scene& scene, PictureSize size, Route route) {
    const glm::dmat4 view = look_at(scene.camera);
    load_projection(scene.camera.projection, size);
    clear(scene.display.background);
    set_cull(scene.shading.cull);
    const bool fixed = route == Route::FixedFunction;
    const unsigned used = fixed ? 0 : program(scene.shading);
    glUseProgram(used);
    if (fixed)
        set_fixed_lights(scene, view);
    else
        set_shader_lights(used, scene, view);
    for (const Object& object : scene.objects) {
        const glm::vec3& scale = object.transform.scale;
        glFrontFace(scale.x * scale.y * scale.z < 0 ? GL_CW : GL_CCW);  // keeps facets facing outward
        if (fixed)
            set_fixed_material(seen_material(object.material, scene.shading), scene.shading);
        else
            set_shader_material(used, scene, object.material);
        glLoadMatrixd(&view[0][0]);
        multiply_transform(object.transform);
        emit_triangles(object, scene.shading);
    }
}

}  // namespace glint::oracle
