// Counted a second time by brute force: a map from every pair of vertices to the polygons along it.
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;
using test::make_mesh;

namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;
using Runs = std::map<std::pair<std::uint32_t, std::uint32_t>, std::multiset<std::pair<std::uint32_t, bool>>>;

/// For each pair of vertices (low, high): the faces along it, and whether they run from low to high.
Runs runs_of(const Faces& faces) {
    Runs runs;
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (std::size_t i = 0; i < faces[f].size(); ++i) {
            const std::uint32_t a = faces[f][i], b = faces[f][(i + 1) % faces[f].size()];
            if (a != b) runs[{std::min(a, b), std::max(a, b)}].insert({f, a < b});
        }
    return runs;
}

Runs runs_of(const Mesh& mesh, const Topology& topology) {
    Runs runs;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        const auto [low, high] = topology.edges[e];
        CHECK(low < high);
        CHECK(runs.count({low, high}) == 0);
        for (const EdgeUse& use : topology.uses_of(e)) {
            const std::uint32_t a = mesh.corner_position[use.corner];
            const std::uint32_t b = mesh.corner_position[next_corner(mesh, use.face, use.corner)];
            CHECK(std::min(a, b) == low);
            CHECK(std::max(a, b) == high);
            runs[{low, high}].insert({use.face, a < b});
        }
    }
    return runs;
}

std::vector<glm::vec3> places(std::uint32_t count) {
    std::vector<glm::vec3> result;
    for (std::uint32_t i = 0; i < count; ++i) result.emplace_back(i, i * i % 7, i * i * i % 11);
    return result;
}

void check_against_brute_force(std::uint32_t vertices, const Faces& faces) {
    const Mesh mesh = make_mesh(places(vertices), faces);
    const Runs expected = runs_of(faces);
    CHECK(runs_of(mesh, make_topology(mesh)) == expected);
    std::size_t boundary = 0, non_manifold = 0, inconsistent = 0;
    for (const auto& [edge, uses] : expected) {
        boundary += uses.size() == 1 ? 1 : 0;
        non_manifold += uses.size() > 2 ? 1 : 0;
        inconsistent += uses.size() == 2 && uses.begin()->second == uses.rbegin()->second ? 1 : 0;
    }
    std::set<std::set<std::uint32_t>> distinct;
    for (const auto& face : faces) distinct.emplace(face.begin(), face.end());
    const MeshInfo info = mesh_info(mesh);
    CHECK(info.edges == expected.size());
    CHECK(info.boundary_edges == boundary);
    CHECK(info.non_manifold_edges == non_manifold);
    CHECK(info.inconsistent_edges == inconsistent);
    CHECK(info.duplicate_faces == faces.size() - distinct.size());
}

}  // namespace

TEST_CASE("every edge is reported, however many faces meet there", "[topology]") {
    check_against_brute_force(4, {{0, 1, 2}, {0, 2, 3}});  // two triangles
    check_against_brute_force(5,
                              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});  // an edge of three faces, same direction
    check_against_brute_force(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});             // an edge of three faces
    check_against_brute_force(5, {{0, 1, 2}, {0, 3, 4}});                        // two fans at one vertex
    check_against_brute_force(4, {{0, 1, 2}, {0, 1, 3}});                        // wound oppositely
    check_against_brute_force(3, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {1, 2, 0}});  // duplicates
    check_against_brute_force(4, {{0, 1, 1}, {0, 1}, {2}, {}, {3, 3, 3}, {0, 1, 1, 2, 2, 3}});
    check_against_brute_force(5, {{0, 1, 2, 0, 3, 4}, {1, 0, 3}, {2, 1, 4}});  // a vertex twice in a face
    // A closed tetrahedron with a fin on one of its edges.
    check_against_brute_force(5, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {0, 1, 4}});
}

TEST_CASE("edges of random polygon soup match a brute-force count", "[topology][property]") {
    std::mt19937 generator(5);
    const auto random = [&generator](std::uint32_t below) {
        return static_cast<std::uint32_t>(generator() % below);
    };
    for (int trial = 0; trial < 400; ++trial) {
        const std::uint32_t vertices = 3 + random(12);
        Faces faces(1 + random(40));
        for (auto& face : faces) {
            face.resize(random(6));
            for (auto& v : face) v = random(vertices);
        }
        check_against_brute_force(vertices, faces);
    }
}

TEST_CASE("every edge at a vertex of many faces is reported", "[topology]") {
    Faces fan;
    for (std::uint32_t i = 0; i < 3000; ++i) fan.push_back({0, 1 + i, 1 + (i + 1) % 3000});
    check_against_brute_force(3001, fan);
}

TEST_CASE("info counts faces by number of corners, and degenerate faces", "[mesh]") {
    const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 2, 0}, {7, 7, 7}},
                                {{0, 1, 2, 3}, {3, 2, 4}, {0, 1, 2, 4, 3}, {0, 0, 1}, {3, 0, 1, 2}});
    const MeshInfo info = mesh_info(mesh);
    CHECK(info.vertices == 6);
    CHECK(info.faces == 5);
    CHECK(info.triangles == 2);
    CHECK(info.quads == 2);
    CHECK(info.polygons == 1);
    CHECK(info.degenerate_faces == 1);
    CHECK(info.duplicate_faces == 1);
    CHECK(used_source(mesh, NormalSource::Auto) == NormalSource::Vertex);
    CHECK(info.bounds == Bounds{{0, 0, 0}, {1, 2, 0}});
}

TEST_CASE("facets join across manifold edges within the crease angle, in chains", "[topology][crease]") {
    // Three facets of a bent strip, 40 degrees at each bend: all meet within 50, though the ends differ
    // by 80.
    const double turn = 40 * 3.14159265358979 / 180;
    std::vector<glm::vec3> points;
    double x = 0, y = 0, angle = 0;
    for (int i = 0; i < 4; ++i) {
        points.emplace_back(x, y, 0);
        points.emplace_back(x, y, 1);
        x += std::cos(angle);
        y -= std::sin(angle);
        angle += turn;
    }
    Mesh mesh = make_mesh(points, {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}});
    const auto count = [&mesh](float crease_deg) {
        return crease_groups(mesh, make_topology(mesh), crease_deg).count;
    };
    CHECK(count(50) == 8);   // one per vertex
    CHECK(count(39) == 12);  // one per corner
    // With the middle facet flipped, its edges no longer join.
    mesh = make_mesh(points, {{0, 1, 3, 2}, {2, 4, 5, 3}, {4, 5, 7, 6}});
    CHECK(count(179) == 12);
    // A fin on a flat edge makes it non-manifold: nothing joins there.
    mesh = make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 0, 1}, {1, 1, 0}, {1, 1, 1}},
                     {{0, 1, 3, 2}, {2, 3, 5, 4}, {2, 3, 7, 6}});
    CHECK(count(179) == 12);
}
