#include <GL/gl.h>

#include <algorithm>
#include <array>

#include "tests/oracle/gl_parts.h"

namespace glint::oracle {
namespace {

using Four = std::array<float, 4>;

Four four(const glm::vec3& a, float w = 1) { return {a.x, a.y, a.z, w}; }

void set_light(GLenum id, const Light& light) {
    const float i = light.intensity;
    const glm::vec4& p = light.position;
    glLightfv(id, GL_POSITION, Four{p.x, p.y, p.z, p.w}.data());
    glLightfv(id, GL_AMBIENT, four(i * light.ambient).data());
    glLightfv(id, GL_DIFFUSE, four(i * light.diffuse).data());
    glLightfv(id, GL_SPECULAR, four(i * light.specular).data());
    const bool directional = light.kind == LightKind::Directional, spot = light.kind == LightKind::Spot;
    glLightf(id, GL_CONSTANT_ATTENUATION, directional ? 1 : light.falloff.constant);
    glLightf(id, GL_LINEAR_ATTENUATION, directional ? 0 : light.falloff.linear);
    glLightf(id, GL_QUADRATIC_ATTENUATION, directional ? 0 : light.falloff.quadratic);
    glLightf(id, GL_SPOT_CUTOFF, spot ? light.spot.cutoff_deg : 180);
    glLightf(id, GL_SPOT_EXPONENT, spot ? light.spot.exponent : 0);
    glLightfv(id, GL_SPOT_DIRECTION, &light.spot.direction.x);
    glEnable(id);
}

}  // namespace

void set_fixed_lights(const Scene& scene, const glm::dmat4& view) {
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four(scene.global_ambient).data());
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, scene.shading.two_sided);
    const bool local = scene.shading.local_viewer && !is_orthographic(scene.camera.projection);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local);
    glShadeModel(scene.shading.mode == ShadingMode::Flat ? GL_FLAT : GL_SMOOTH);
    glClampColor(GL_CLAMP_VERTEX_COLOR, scene.shading.rules == Rules::OpenGL2);
    for (GLenum id = GL_LIGHT0; id < GL_LIGHT0 + 8; ++id) glDisable(id);
    GLenum id = GL_LIGHT0;
    for (const Light& light : scene.lights) {
        if (!light.enabled) continue;
        // A position and a spot's direction are transformed by the current model-view matrix.
        if (light.space == LightSpace::World)
            glLoadMatrixd(&view[0][0]);
        else
            glLoadIdentity();
        set_light(id++, light);
    }
}

void set_fixed_material(const Material& m, const Shading& shading) {
    const bool shines = shading.reflection != Reflection::Lambert;
    const GLenum face = GL_FRONT_AND_BACK;
    glMaterialfv(face, GL_EMISSION, four(m.emission).data());
    glMaterialfv(face, GL_AMBIENT, four(m.ambient).data());
    glMaterialfv(face, GL_DIFFUSE, four(m.diffuse).data());
    glMaterialfv(face, GL_SPECULAR, four(shines ? m.specular : glm::vec3(0)).data());
    glMaterialf(face, GL_SHININESS, shines ? std::min(m.shininess, 128.0f) : 0);
}

}  // namespace glint::oracle
