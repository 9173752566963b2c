// Edges that become strokes: counts worked out by hand, and every edge of many meshes against the definition.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "renderer/strokes/strokes.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

using Edge = std::array<std::uint32_t, 2>;

constexpr EdgeChoice silhouettes{true, false, 40, Cull::None};
constexpr EdgeChoice creases(float deg) { return {false, true, deg, Cull::None}; }

EdgeView eye_at(glm::dvec3 eye) { return {glm::dvec4(eye, 1), glm::dmat3(1)}; }

std::set<Edge> chosen(const MeshPtr& mesh, const EdgeView& view, const EdgeChoice& choice) {
    const MeshEdges edges = mesh_edges(mesh);
    std::set<Edge> found;
    for (const StrokeEdge& e : stroke_edges(edges, view, choice)) found.insert(edges.topology.edges[e.edge]);
    return found;
}

/// Newell's normal from the definition, not normalized.
glm::dvec3 newell(const Mesh& mesh, std::size_t face) {
    glm::dvec3 n(0);
    const auto around = mesh.corners_of(face);
    for (std::size_t i = 0; i < around.size(); ++i) {
        const glm::dvec3 a(mesh.positions[around[i]]), b(mesh.positions[around[(i + 1) % around.size()]]);
        n += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y));
    }
    return n;
}

std::map<Edge, std::vector<std::size_t>> faces_of_edges(const Mesh& mesh) {
    std::map<Edge, std::vector<std::size_t>> faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto around = mesh.corners_of(f);
        for (std::size_t i = 0; i < around.size(); ++i) {
            const auto [a, b] = std::minmax(around[i], around[(i + 1) % around.size()]);
            faces[{a, b}].push_back(f);
        }
    }
    return faces;
}

/// The definition, pair by pair, for an eye whose w is 0 or 1.
std::set<Edge> by_definition(const Mesh& mesh, const glm::dvec4& eye, const EdgeChoice& choice) {
    std::set<Edge> found;
    for (const auto& [edge, faces] : faces_of_edges(mesh)) {
        bool wanted = choice.silhouettes && faces.size() == 1;
        const glm::dvec3 middle =
            (glm::dvec3(mesh.positions[edge[0]]) + glm::dvec3(mesh.positions[edge[1]])) / 2.0;
        const glm::dvec3 e = glm::dvec3(eye) - eye.w * middle;
        for (const std::size_t f : faces)
            for (const std::size_t g : faces) {
                if (f == g) continue;
                const glm::dvec3 n0 = glm::normalize(newell(mesh, f)), n1 = glm::normalize(newell(mesh, g));
                wanted |= choice.silhouettes && glm::dot(e, n0) * glm::dot(e, n1) <= 0;
                wanted |=
                    choice.creases && glm::dot(n0, n1) <= std::cos(choice.crease_deg * 0.017453292519943295);
            }
        if (wanted) found.insert(edge);
    }
    return found;
}

MeshPtr cube() { return primitive(Primitive::Cube, 1); }

}  // namespace

TEST_CASE("a cube shows six, four or seven silhouette edges, and none from inside", "[strokes]") {
    const auto count = [](glm::dvec3 eye) { return chosen(cube(), eye_at(eye), silhouettes).size(); };
    CHECK(count({3, 4, 5}) == 6);
    CHECK(count({3, 0.5, 5}) == 6);
    CHECK(count({0.5, 0.25, 5}) == 4);
    CHECK(count({0, 0, 5}) == 4);
    CHECK(count({1, 0, 5}) == 7);  // in the plane of a face
    CHECK(count({0, 0, 0}) == 0);
    CHECK(count({0.9, -0.5, 0.3}) == 0);
}

TEST_CASE("a cube has twelve creases up to 90 degrees and none above, even when rotated", "[strokes]") {
    const double c = std::cos(0.7), s = std::sin(0.7);
    EdgeView turned = eye_at({3, 4, 5});
    turned.normal_matrix = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c);
    for (const EdgeView& view : {eye_at({3, 4, 5}), turned})
        for (const float deg : {0.0f, 40.0f, 89.0f, 90.0f, 91.0f, 180.0f})
            CHECK(chosen(cube(), view, creases(deg)).size() == (deg <= 90 ? 12 : 0));
    CHECK(chosen(primitive(Primitive::Cube, 4), turned, creases(1)).size() == 48);
    CHECK(chosen(primitive(Primitive::Cylinder, 48), turned, creases(80)).size() == 96);  // the two rims
}

TEST_CASE("silhouettes and creases match the definition, edge by edge", "[strokes][property]") {
    std::mt19937 random(3);
    for (const MeshPtr& mesh : {primitive(Primitive::Sphere, 24), primitive(Primitive::Torus, 24),
                                primitive(Primitive::Knot, 64), primitive(Primitive::Teapot, 4),
                                primitive(Primitive::Plane, 5), primitive(Primitive::TJunction, 1)})
        for (int round = 0; round < 12; ++round) {
            const bool parallel = round % 3 == 0;
            const glm::dvec4 eye(glm::dvec3(uniform_vec3(random, -4, 4)), parallel ? 0 : 1);
            EdgeChoice choice{round % 2 == 0, round % 4 != 0, uniform(random, 5, 100), Cull::None};
            CHECK(chosen(mesh, {eye, glm::dmat3(1)}, choice) == by_definition(*mesh, eye, choice));
        }
}

TEST_CASE("a stretched and mirrored mesh has the strokes of its transformed shape", "[strokes][property]") {
    std::mt19937 random(5);
    for (const Primitive kind : {Primitive::BumpySphere, Primitive::Teapot, Primitive::Cube})
        for (int round = 0; round < 8; ++round) {
            const MeshPtr mesh = primitive(kind, kind == Primitive::Cube ? 2 : 5);
            Transform transform;
            transform.rotate_deg = uniform_vec3(random, -180, 180);
            transform.translate = uniform_vec3(random, -1, 1);
            transform.scale = uniform_vec3(random, 0.3f, 2);
            if (round % 2) transform.scale.y = -transform.scale.y;
            const glm::dmat4 world_from_object = glint::world_from_object(transform);
            auto becomes = std::make_shared<Mesh>(*mesh);
            for (glm::vec3& p : becomes->positions)
                p = glm::vec3(world_from_object * glm::dvec4(glm::dvec3(p), 1));
            if (round % 2)  // keeps facets facing outward
                for (std::size_t f = 0; f < mesh->face_count(); ++f)
                    std::reverse(becomes->corner_position.begin() + mesh->first_corner[f],
                                 becomes->corner_position.begin() + mesh->first_corner[f + 1]);
            const glm::dvec4 eye(glm::dvec3(uniform_vec3(random, -4, 4)), 1);
            const EdgeView view{glm::inverse(world_from_object) * eye,
                                glm::transpose(glm::inverse(glm::dmat3(world_from_object)))};
            const EdgeChoice choice{round<4, round> 2, 35, Cull::None};
            CHECK(chosen(mesh, view, choice) == by_definition(*becomes, eye, choice));
        }
}

TEST_CASE("boundary edges are always silhouettes and never creases", "[strokes]") {
    const MeshPtr plane = primitive(Primitive::Plane, 3);
    for (const glm::dvec3 eye : {glm::dvec3(0, 5, 0), glm::dvec3(1, -2, 7)}) {
        CHECK(chosen(plane, eye_at(eye), silhouettes).size() == 12);
        CHECK(chosen(plane, eye_at(eye), creases(1)).empty());
    }
}

TEST_CASE("an edge shared by three facets is drawn if any two of them qualify", "[strokes]") {
    // A book of three pages along z, seen along -z from slightly to the right: two pages face left.
    const MeshPtr book = polygon_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0.1f, 0}},
                                      {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    const Edge spine{0, 1};
    // Normals of 0-1-2: +y; of 0-1-3: -x; of 0-1-4: about -y.
    CHECK(chosen(book, eye_at({0.5, 3, 0}), silhouettes).count(spine) == 1);
    CHECK(chosen(book, eye_at({0.5, 3, 0}), creases(170)).count(spine) == 1);  // +y against about -y
    CHECK(chosen(book, eye_at({0.5, 3, 0}), creases(179)).count(spine) == 0);
    const MeshPtr stack = polygon_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0.1f, 0}, {1, -0.1f, 0}},
                                       {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    CHECK(chosen(stack, eye_at({0.5, 3, 0}), silhouettes).count(spine) == 0);  // all three face the eye
}

TEST_CASE("a polygon without an area has no stroke", "[strokes]") {
    // Two triangles in a plane; one sliver without area is on the edge from 0 to 2, another is separate.
    const MeshPtr mesh = polygon_mesh({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {5, 5, 5}},
                                      {{0, 1, 2}, {0, 2, 4}, {0, 4, 2, 3}, {5, 3, 5}});
    const std::set<Edge> outline{{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    CHECK(chosen(mesh, eye_at({1, 1, 5}), silhouettes) == outline);
    CHECK(chosen(mesh, eye_at({1, 1, 5}), creases(10)).empty());
}

TEST_CASE("an edge is omitted if all its facets are culled", "[strokes]") {
    const auto count = [](Cull cull) {
        return chosen(cube(), eye_at({3, 4, 5}), {true, true, 40, cull}).size();
    };
    CHECK(count(Cull::None) == 12);
    CHECK(count(Cull::Back) == 9);   // the edges of the three faces towards the eye
    CHECK(count(Cull::Front) == 9);  // the edges of the other three
}

TEST_CASE("edges know whether both facets face the eye, both face away, or one does each", "[strokes]") {
    const auto count = [](const MeshPtr& mesh, glm::dvec3 eye, EdgeFacing facing) {
        const auto edges = stroke_edges(mesh_edges(mesh), eye_at(eye), {true, true, 40, Cull::None});
        return std::count_if(edges.begin(), edges.end(),
                             [facing](const StrokeEdge& e) { return e.facing == facing; });
    };
    CHECK(count(cube(), {3, 4, 5}, EdgeFacing::Towards) == 3);
    CHECK(count(cube(), {3, 4, 5}, EdgeFacing::Away) == 3);
    CHECK(count(cube(), {3, 4, 5}, EdgeFacing::Rim) == 6);
    CHECK(count(cube(), {0, 0, 0}, EdgeFacing::Away) == 12);
    CHECK(count(primitive(Primitive::Plane, 1), {0, 5, 0}, EdgeFacing::Rim) == 4);
}
