// Triangulated polygons: areas by the shoelace formula, and figures drawn by hand.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "models/mesh/mesh.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;
using test::make_mesh;
using test::make_polygon;

namespace {

/// Twice the signed areas of the triangles, about +z, and of the entire polygon.
struct Areas {
    double least = 1e300, sum = 0, polygon = 0;
};
Areas areas(const Mesh& mesh) {
    Areas result;
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 a = test::corner_place(mesh, t.corner[0]), b = test::corner_place(mesh, t.corner[1]),
                         c = test::corner_place(mesh, t.corner[2]);
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        result.least = std::min(result.least, area);
        result.sum += area;
    }
    const std::size_t n = mesh.corner_position.size();
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::dvec3 a = test::corner_place(mesh, i),
                         b = test::corner_place(mesh, static_cast<std::uint32_t>((i + 1) % n));
        result.polygon += a.x * b.y - b.x * a.y;
    }
    return result;
}

void check_covered(const Mesh& mesh) {
    const Areas a = areas(mesh);
    CHECK(a.least > 0);
    CHECK(a.sum == Approx(a.polygon).epsilon(1e-9));
}

}  // namespace

TEST_CASE("a convex polygon is a fan from its first corner", "[triangulate]") {
    const Mesh mesh = make_polygon({{2, 0, 1}, {1, 2, 1}, {-1, 2, 1}, {-2, 0, 1}, {0, -2, 1}});
    REQUIRE(mesh.triangles.size() == 3);
    for (std::uint32_t i = 0; i < 3; ++i) CHECK(mesh.triangles[i] == Triangle{{0, i + 1, i + 2}, 0});
    CHECK(mesh.warnings.empty());
}

TEST_CASE("an arrowhead is cut along its inner diagonal, whichever corner comes first", "[triangulate]") {
    const std::vector<glm::vec3> arrow{{0, 0, 0}, {4, -2, 0}, {1, 0, 0}, {4, 2, 0}};  // reflex at (1, 0)
    for (std::size_t first = 0; first < 4; ++first) {
        std::vector<glm::vec3> turned = arrow;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
        // Twice the area, by the shoelace formula for the four points, worked out by hand.
        const Mesh mesh = make_polygon(turned);
        CHECK(mesh.triangles.size() == 2);
        CHECK(areas(mesh).polygon == Approx(4));
        check_covered(mesh);
    }
}

TEST_CASE("corners on a straight side produce no triangle of zero area", "[triangulate]") {
    check_covered(
        make_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}}));
    // An L with corners on its sides.
    check_covered(make_polygon({{0, 0, 0},
                                {1, 0, 0},
                                {3, 0, 0},
                                {3, 1, 0},
                                {2, 1, 0},
                                {1, 1, 0},
                                {1, 2, 0},
                                {1, 3, 0},
                                {0, 3, 0},
                                {0, 2, 0}}));
}

TEST_CASE("a polygon that is not convex is not cut as a fan, even if it only turns left", "[triangulate]") {
    const auto is_fan = [](const Mesh& mesh) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
            if (mesh.triangles[i] != Triangle{{0, i + 1, i + 2}, 0}) return false;
        return true;
    };
    // It is entirely visible from its first corner, but (3, 2) is reflex.
    const Mesh star = make_polygon({{0, 0, 0}, {4, 0, 0}, {3, 2, 0}, {4, 4, 0}, {0, 4, 0}});
    CHECK_FALSE(is_fan(star));
    check_covered(star);
    // A curve with a loop inside: r = 1 + 2 cos t always turns left, and stays to the left of its first edge.
    std::vector<glm::vec3> loop;
    loop.reserve(16);
    for (int i = 0; i < 16; ++i) {
        const double t = 6.283185307179586 * (i - 0.5) / 16, r = 1 + 2 * std::cos(t);
        loop.emplace_back(r * std::cos(t), r * std::sin(t), 0);
    }
    CHECK_FALSE(is_fan(make_polygon(loop)));
}

TEST_CASE("polygons that cross themselves are cut approximately", "[triangulate][degenerate]") {
    std::vector<glm::vec3> pentagram, noise;
    for (int i = 0; i < 5; ++i) {
        const double angle = 6.283185307179586 * 2 * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    CHECK(make_polygon(pentagram).triangles.size() == 3);
    std::mt19937 random(3);
    // Few values, so that many points are equal or collinear.
    const auto number = [&random] { return static_cast<float>(random() % 5); };
    for (int trial = 0; trial < 500; ++trial) {
        noise.resize(3 + random() % 20);
        for (glm::vec3& p : noise) p = {number(), number(), trial % 2 == 0 ? 0 : number()};
        const Mesh mesh = make_polygon(noise);
        CHECK(mesh.triangles.size() <= noise.size() - 2);
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t c : t.corner) CHECK(c < noise.size());
    }
}

TEST_CASE("a hole joined by a bridge stays open", "[triangulate]") {
    // A 6 x 6 square with a 2 x 2 hole, one outline: area 36 - 4.
    const Mesh mesh = make_polygon({{-3, -3, 0},
                                    {3, -3, 0},
                                    {3, 3, 0},
                                    {-3, 3, 0},
                                    {-3, -3, 0},
                                    {-1, -1, 0},
                                    {-1, 1, 0},
                                    {1, 1, 0},
                                    {1, -1, 0},
                                    {-1, -1, 0}});
    CHECK(areas(mesh).sum == Approx(64));
    check_covered(mesh);
}

TEST_CASE("random star-shaped polygons in random planes are covered exactly once",
          "[triangulate][property]") {
    std::mt19937 random(11);
    const auto number = [&random] { return static_cast<double>(random() >> 8) / (1 << 24); };
    for (int trial = 0; trial < 300; ++trial) {
        const int n = 4 + static_cast<int>(random() % 60);
        std::vector<glm::vec3> flat;
        for (int i = 0; i < n; ++i) {
            const double radius = 0.1 + number(), angle = 6.283185307179586 * i / n;
            flat.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        const Mesh mesh = make_polygon(flat);
        CHECK(mesh.triangles.size() == static_cast<std::size_t>(n - 2));
        check_covered(mesh);
        // The same polygon elsewhere: the same number of triangles and the same area.
        const glm::dvec3 u = glm::normalize(glm::dvec3(number(), number(), number() + 0.1));
        const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(number() + 0.1, 0.3, -number())));
        std::vector<glm::vec3> tilted;
        for (const glm::vec3& p : flat)
            tilted.emplace_back(static_cast<double>(p.x) * u + static_cast<double>(p.y) * v +
                                glm::dvec3(3, -2, 5));
        const Mesh moved = make_polygon(tilted);
        double area = 0;
        for (const Triangle& t : moved.triangles) {
            const glm::dvec3 a = test::corner_place(moved, t.corner[0]);
            area += glm::length(glm::cross(test::corner_place(moved, t.corner[1]) - a,
                                           test::corner_place(moved, t.corner[2]) - a));
        }
        CHECK(area == Approx(areas(mesh).polygon).epsilon(1e-5));
    }
}

TEST_CASE("degenerate polygons keep their index and produce no triangles", "[triangulate][degenerate]") {
    const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                {{0, 1, 2},        // collinear
                                 {0, 1, 1},        // two distinct corners
                                 {0, 1, 3},        // good
                                 {0, 0, 0, 0, 0},  // a single position
                                 {0, 1, 1, 4, 3},  // a repeated corner, but a nonzero area
                                 {0, 1}});
    CHECK(mesh.face_count() == 6);
    REQUIRE(mesh.triangles.size() == 3);
    CHECK(mesh.triangles[0].face == 2);
    CHECK(mesh.triangles[1] == Triangle{{14, 15, 17}, 4});
    CHECK(mesh.triangles[2] == Triangle{{14, 17, 18}, 4});
    CHECK(mesh.warnings == Warnings{"4 degenerate faces have no area and are not drawn",
                                    "1 face has a repeated corner, which was skipped"});
    CHECK(mesh.bounds == Bounds{{0, 0, 0}, {2, 1, 0}});
}

TEST_CASE("bounds include only the positions that faces use", "[mesh]") {
    const Mesh mesh = make_mesh({{9, 9, 9}, {-1, 2, 3}, {1, -2, 3}, {0, 0, -4}}, {{1, 2, 3}});
    CHECK(mesh.bounds == Bounds{{-1, -2, -4}, {1, 2, 3}});
}

TEST_CASE("a face that repeats a corner gives a warning, one with a hole does not", "[triangulate]") {
    const std::vector<glm::vec3> places{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                        {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
    const auto warnings = [&](const std::vector<std::uint32_t>& face) {
        return make_mesh(places, {face}).warnings;
    };
    const Warnings told{"1 face visits one of its corners twice, and may be drawn incorrectly"};
    CHECK(warnings({0, 1, 2, 3}).empty());
    CHECK(warnings({0, 1, 2, 0, 3}) == told);                 // a spike to 3
    CHECK(warnings({0, 1, 2, 1, 3}) == told);                 // a spike to 2
    CHECK(warnings({4, 0, 1, 4, 2, 3}) == told);              // two triangles that meet at 4
    CHECK(warnings({0, 1, 2, 3, 0, 4, 5, 6, 7, 4}).empty());  // a hole, joined by a bridge
    CHECK(warnings({0, 1, 2, 3, 0, 4, 5, 4}) == told);        // a bridge that continues as a spike
    CHECK(make_mesh(places, {{0, 1, 2, 0, 3}, {0, 2, 0, 3, 1}}).warnings ==
          Warnings{"2 faces visit one of their corners twice, and may be drawn incorrectly"});
}

// Counts edges again by brute force: a map from each pair of vertices to the polygons with this edge.
namespace {

using Faces = std::vector<std::vector<std::uint32_t>>;
using Runs = std::map<std::pair<std::uint32_t, std::uint32_t>, std::multiset<std::pair<std::uint32_t, bool>>>;

/// For each pair of vertices (low, high): the faces with this edge, and whether they run from low to high.
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

TEST_CASE("mesh_info() counts degenerate faces, and faces by number of corners", "[mesh]") {
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
    // Three facets of a bent strip, 40 degrees at each bend: all join at a crease angle of 50 degrees, though
    // the ends differ by 80.
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
