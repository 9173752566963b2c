#include <GL/gl.h>

#include <glm/geometric.hpp>
#include <vector>

#include "models/mesh/normals.h"
#include "tests/oracle/gl_parts.h"

namespace glint::oracle {
namespace {

/// The normal and position at which flat and facet shading light an entire polygon, in object coordinates.
struct Facet {
    glm::dvec3 normal{0}, center{0}, color{1};
};

/// Newell's normal, whose length is twice the area; its sign and direction survive the inverse transpose.
Facet facet_of(const Mesh& mesh, std::size_t face) {
    Facet f;
    glm::dvec3 color(0);
    const auto around = mesh.corners_of(face);
    const auto count = static_cast<double>(around.size());
    for (std::size_t i = 0; i < around.size(); ++i) {
        const glm::dvec3 p = mesh.positions[around[i]], q = mesh.positions[around[(i + 1) % around.size()]];
        const glm::dvec3 first = mesh.positions[around[0]];
        f.normal += glm::cross(p - first, q - first);
        f.center += p / count;
        if (!mesh.colors.empty()) color += glm::dvec3(mesh.colors[around[i]]) / count;
    }
    f.normal = glm::normalize(f.normal);
    if (!mesh.colors.empty()) f.color = color;
    return f;
}

void emit(const glm::dvec3& normal, const glm::dvec3& lit_at, const glm::dvec3& color,
          const glm::vec3& place) {
    glNormal3d(normal.x, normal.y, normal.z);
    glMultiTexCoord3d(GL_TEXTURE0, lit_at.x, lit_at.y, lit_at.z);
    glColor3d(color.x, color.y, color.z);
    glVertex3f(place.x, place.y, place.z);
}

}  // namespace

void emit_triangles(const Object& object, const Shading& shading) {
    const Mesh& mesh = *object.mesh;
    const CornerNormals normals = corner_normals(mesh, object.normals);
    const bool center = shading.mode == ShadingMode::Flat && !lit_at_corner(shading);
    const bool facet_normals = center || shading.mode == ShadingMode::Facet;
    glBegin(GL_TRIANGLES);
    for (const Triangle& t : mesh.triangles) {
        const Facet facet = facet_of(mesh, t.face);
        for (const std::uint32_t c : t.corner) {
            const std::uint32_t p = mesh.corner_position[c];
            const glm::vec3 place = mesh.positions[p];
            const glm::dvec3 normal =
                facet_normals ? facet.normal
                              : glm::dvec3(normals.normals[normals.corner.empty() ? p : normals.corner[c]]);
            const glm::dvec3 color = center                ? facet.color
                                     : mesh.colors.empty() ? glm::dvec3(1)
                                                           : glm::dvec3(mesh.colors[p]);
            emit(normal, center ? facet.center : glm::dvec3(place), color, place);
        }
    }
    glEnd();
}

}  // namespace glint::oracle
