// Checks meshes against known properties: Euler's formula, face counts, the closed form of a limit, areas.
#include "models/mesh/resolution/resolution.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/normals.h"
#include "models/mesh/primitives/primitives.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_helpers.h"

using namespace glint;
using test::make_mesh;

namespace {

Mesh refined(const Mesh& mesh, const MeshResolution& wanted) {
    Result<Mesh> made = with_resolution(mesh, wanted);
    if (const Problem* problem = problem_of(made)) FAIL(problem->text());
    return std::get<Mesh>(std::move(made));
}

/// Euler's characteristic: the number of vertices in faces, minus edges, plus faces.
int euler(const Mesh& mesh) {
    const std::set<std::uint32_t> used(mesh.corner_position.begin(), mesh.corner_position.end());
    return static_cast<int>(used.size()) - static_cast<int>(mesh_info(mesh).edges) +
           static_cast<int>(mesh.face_count());
}

bool is_closed(const Mesh& mesh) {
    const MeshInfo info = mesh_info(mesh);
    return info.boundary_edges == 0 && info.non_manifold_edges == 0 && info.inconsistent_edges == 0;
}

double area(const Mesh& mesh, glm::dvec3* normals = nullptr) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](int i) { return glm::dvec3(mesh.positions[mesh.corner_position[t.corner[i]]]); };
        const glm::dvec3 across = glm::cross(at(1) - at(0), at(2) - at(0)) / 2.0;
        sum += glm::length(across);
        if (normals != nullptr) *normals += across;
    }
    return sum;
}

/// The distance from p to the triangle a, b, c (C. Ericson, Real-Time Collision Detection, 5.1.5): to the
/// plane if p is above the triangle, else to the three sides.
double distance(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
    const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
    bool inside = true;
    double least = 1e30;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = t[i], b = t[(i + 1) % 3];
        inside = inside && glm::dot(glm::cross(b - a, p - a), n) >= 0;
        const double s = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        least = std::min(least, glm::length(p - a - s * (b - a)));
    }
    return inside ? std::abs(glm::dot(p - t[0], n)) / glm::length(n) : least;
}

double distance(const glm::dvec3& p, const Mesh& mesh) {
    double least = 1e30;
    for (const Triangle& t : mesh.triangles) {
        std::array<glm::dvec3, 3> corners;
        for (int i = 0; i < 3; ++i) corners[i] = mesh.positions[mesh.corner_position[t.corner[i]]];
        least = std::min(least, distance(p, corners));
    }
    return least;
}

/// n x n quads in x and z from -1 to 1, at the height `y(x, z)`.
template <class Height> Mesh height_field(int n, const Height& y) {
    std::vector<glm::vec3> places;
    std::vector<std::vector<std::uint32_t>> faces;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const float x = 2.0f * float(i) / float(n) - 1, z = 2.0f * float(j) / float(n) - 1;
            places.emplace_back(x, y(x, z), z);
        }
    const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    return make_mesh(places, faces);
}

/// The furthest extent of the mesh along a direction.
double reach(const Mesh& mesh, const glm::dvec3& direction) {
    double most = -1e30;
    for (const glm::vec3& p : mesh.positions) most = std::max(most, glm::dot(glm::dvec3(p), direction));
    return most;
}

}  // namespace

TEST_CASE("subdividing splits each triangle into four and preserves Euler's formula", "[resolution]") {
    const Mesh ball = make_primitive(Primitive::Icosphere, 1);
    for (int n = 1; n <= 3; ++n) {
        const Mesh fine = refined(ball, {0, n});
        CHECK(fine.face_count() == std::size_t{80} << 2 * n);
        CHECK(fine.triangles.size() == fine.face_count());
        CHECK(is_closed(fine));
        CHECK(euler(fine) == 2);
        CHECK(fine.given_triangles == 80);
    }
}

TEST_CASE("Loop's weights are correct for a vertex of any valence", "[resolution]") {
    // The tip of a double pyramid over a polygon of n corners at height 0. Loop 1987: (64 - b)/64 of the tip
    // remain and b/64 come from the corners' mean, b = 40 - (3 + 2 cos(2 pi / n))^2.
    for (const std::uint32_t n : {3u, 6u, 49u, 50u, 51u, 64u, 300u, 4096u}) {
        std::vector<glm::vec3> places{{0, 1, 0}, {0, -1, 0}};
        std::vector<std::vector<std::uint32_t>> faces;
        for (std::uint32_t i = 0; i < n; ++i) {
            const double turn = 2 * M_PI * i / n;
            places.emplace_back(std::sin(turn), 0, std::cos(turn));
            const std::uint32_t here = 2 + i, next = 2 + (i + 1) % n;
            faces.push_back({0, here, next});
            faces.push_back({1, next, here});
        }
        INFO(n << " neighbours");
        const Mesh fine = refined(make_mesh(places, faces), {0, 1});
        const double turned = 3 + 2 * std::cos(2 * M_PI / n);
        CHECK(reach(fine, {0, 1, 0}) == Approx((24 + turned * turned) / 64));
        CHECK(reach(fine, {0, -1, 0}) == Approx((24 + turned * turned) / 64));
    }
}

TEST_CASE("a boundary is subdivided as a cubic B-spline, independent of the interior", "[resolution]") {
    // A patch's outline, and the same patch cut into triangles.
    const std::string outline = "v 0 0 0\nv 2 0 1\nv 3 2 0\nv 1 3 0.5\nv -1 1.5 0\n";
    const Mesh polygon = std::get<Mesh>(parse_mesh(outline + "f 1 2 3 4 5\n", "a.obj")),
               triangles = std::get<Mesh>(parse_mesh(outline + "f 1 2 3\nf 1 3 4\nf 1 4 5\n", "b.obj"));
    std::vector<glm::dvec3> curve;
    for (const glm::vec3& p : polygon.positions) curve.emplace_back(p);
    for (int times = 1; times <= 3; ++times) {
        // One step of the curve, by hand: a vertex (1 6 1) / 8, an edge (1 1) / 2.
        std::vector<glm::dvec3> next;
        const std::size_t n = curve.size();
        for (std::size_t i = 0; i < n; ++i) {
            const glm::dvec3 before = curve[(i + n - 1) % n], here = curve[i], after = curve[(i + 1) % n];
            next.push_back((before + 6.0 * here + after) / 8.0);
            next.push_back((here + after) / 2.0);
        }
        curve = next;
        for (const Mesh& mesh : {refined(polygon, {0, times}), refined(triangles, {0, times})})
            for (const glm::dvec3& p : curve) {
                double nearest = 1e9;
                for (const glm::vec3& q : mesh.positions)
                    nearest = std::min(nearest, glm::distance(p, glm::dvec3(q)));
                CHECK(nearest < 1e-6);
            }
    }
}

TEST_CASE("a subdivided cube converges to the Catmull-Clark limit surface", "[resolution]") {
    const Mesh cube = make_primitive(Primitive::Cube, 1);
    for (int n = 1; n <= 4; ++n) {
        const Mesh fine = refined(cube, {0, n});
        CHECK(fine.face_count() == std::size_t{6} << 2 * n);
        CHECK(mesh_info(fine).quads == fine.face_count());
        CHECK(is_closed(fine));
        CHECK(euler(fine) == 2);
    }
    // For a vertex v with n edges to vertices e and, across its faces, vertices f: (n^2 v + 4 sum e + sum
    // f)/(n(n + 5)). The cube's corner (1, 1, 1): (9 + 4 - 1)/24 = 1/2. The centre of a side, after one step:
    // v = 1, e = 3/4, f = 5/9, so (16 + 4 * 3 + 4 * 5/9)/36 = 68/81.
    const Mesh fine = refined(cube, {0, 7});
    CHECK(reach(fine, {0, 1, 0}) == Approx(68.0 / 81).margin(2e-4));
    CHECK(reach(fine, glm::normalize(glm::dvec3(1, 1, 1))) == Approx(0.5 * std::sqrt(3)).margin(1e-3));
}

TEST_CASE("subdividing a polygon gives as many quads as it has corners", "[resolution]") {
    const Mesh fan = make_mesh({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}, {0, 0, 1}},
                               {{0, 1, 2, 3, 4}, {0, 5, 1}});
    CHECK(refined(fan, {0, 1}).face_count() == 5 + 3);
    CHECK(refined(fan, {0, 3}).face_count() == (5 + 3) * 16);
}

TEST_CASE("a flat grid stays flat when refined or coarsened", "[resolution]") {
    const Mesh grid = height_field(12, [](float, float) { return 0.25f; });
    for (const MeshResolution wanted :
         {MeshResolution{0, 2}, MeshResolution{40, 0}, MeshResolution{8, 0}, MeshResolution{40, 2}}) {
        CAPTURE(wanted.decimate, wanted.subdivide);
        const Mesh made = refined(grid, wanted);
        for (const glm::vec3& p : made.positions) CHECK(p.y == 0.25f);
        glm::dvec3 sum(0);
        const double whole = area(made, &sum);
        CHECK(sum.y == Approx(whole));  // no face is flipped
        if (wanted.subdivide == 0) {
            CHECK(whole == Approx(4));  // no face is missing, and no corner of the square is cut
            CHECK(made.triangles.size() <= static_cast<std::size_t>(wanted.decimate));
        }
    }
}

TEST_CASE("a negative error from rounding is clamped to 0", "[resolution]") {
    // All errors on a plane are 0. They are exactly 0 on a level plane, and on these slanted ones except for
    // negative rounding errors: without the clamp each of them would lose a different vertex first.
    const auto first_gone = [](float slant_x, float slant_z) {
        const Mesh plane = height_field(4, [=](float x, float z) { return slant_x * x + slant_z * z; });
        const std::vector<glm::vec3> left = refined(plane, {30, 0}).positions;
        const auto gone = std::find_if(plane.positions.begin(), plane.positions.end(), [&left](glm::vec3 p) {
            return std::find(left.begin(), left.end(), p) == left.end();
        });
        return gone - plane.positions.begin();
    };
    for (const auto& [slant_x, slant_z] :
         {std::pair(-9, 2), std::pair(-8, 3), std::pair(-7, 6), std::pair(-6, 2)}) {
        CAPTURE(slant_x, slant_z);
        CHECK(first_gone(float(slant_x) / 4, float(slant_z) / 4) == first_gone(0, 0));
    }
}

TEST_CASE("a decimated closed surface stays closed and close to the original", "[resolution]") {
    const Mesh knot = make_primitive(Primitive::Knot, 160);
    const Mesh coarse = refined(knot, {2000, 0});
    CHECK(coarse.triangles.size() <= 2000);
    CHECK(coarse.triangles.size() >= 1998);
    CHECK(is_closed(coarse));
    CHECK(euler(coarse) == 0);  // like a torus
    CHECK(coarse.given_normals == GivenNormals::None);
    std::set<std::array<float, 3>> given;
    for (const glm::vec3& p : knot.positions) given.insert({p.x, p.y, p.z});
    for (const glm::vec3& p : coarse.positions) CHECK(given.count({p.x, p.y, p.z}) == 1);
    double furthest = 0;
    for (std::size_t v = 0; v < knot.positions.size(); v += 7)
        furthest = std::max(furthest, distance(glm::dvec3(knot.positions[v]), coarse));
    CHECK(furthest < 0.02);  // its tube has a radius of 0.25
}

TEST_CASE("a vertex with more than 48 faces around it stays, with a warning", "[resolution]") {
    for (const std::uint32_t n : {48u, 49u}) {  // a fan over a round boundary, which has no straight part
        std::vector<glm::vec3> places{{0, 0.5f, 0}};
        std::vector<std::vector<std::uint32_t>> faces;
        for (std::uint32_t i = 0; i < n; ++i) {
            const double turn = 2 * M_PI * i / n;
            places.emplace_back(std::sin(turn), 0, std::cos(turn));
            faces.push_back({0, 1 + i, 1 + (i + 1) % n});
        }
        const Mesh coarse = refined(make_mesh(places, faces), {static_cast<int>(n) - 2, 0});
        CHECK(coarse.face_count() == (n == 48 ? 46 : 49));
        const bool says_so =
            std::any_of(coarse.warnings.begin(), coarse.warnings.end(), [](const std::string& w) {
                return w.starts_with("49 triangles are left, not 47: ") &&
                       w.find("vertices with more than 48 faces around them stay") != std::string::npos;
            });
        CHECK(says_so == (n == 49));
    }
}

TEST_CASE("decimating keeps a boundary except for vertices on its straight parts", "[resolution]") {
    // Two sides are parabolas; the other two are straight.
    const Mesh bent = height_field(20, [](float x, float) { return x * x; });
    const Mesh coarse = refined(bent, {100, 0});
    std::map<std::array<float, 3>, int> kept;
    for (const glm::vec3& p : coarse.positions) ++kept[{p.x, p.y, p.z}];
    int on_parabolas = 0;
    for (const glm::vec3& p : bent.positions)
        if (std::abs(p.z) == 1) on_parabolas += kept.count({p.x, p.y, p.z}) == 1 ? 1 : 0;
    CHECK(on_parabolas == 42);
    int on_straight = 0;
    for (const auto& [p, count] : kept) {
        CHECK(count == 1);
        on_straight += std::abs(p[0]) == 1 && std::abs(p[2]) < 1 ? 1 : 0;
    }
    CHECK(on_straight < 38);
    const Mesh least = refined(bent, {4, 0});
    CHECK(least.triangles.size() > 4);
    REQUIRE(least.warnings.size() == 1);
    CHECK(least.warnings[0].find("triangles are left, not 4") != std::string::npos);
}

TEST_CASE("an edge shared by three faces survives decimation and splits in subdivision", "[resolution]") {
    // Three leaves of a book with 6 x 6 quads each; its spine is the y axis.
    std::vector<glm::vec3> places;
    std::vector<std::vector<std::uint32_t>> faces;
    constexpr std::uint32_t n = 6;
    for (std::uint32_t j = 0; j <= n; ++j) places.emplace_back(0, j, 0);
    for (int leaf = 0; leaf < 3; ++leaf) {
        const auto begin = static_cast<std::uint32_t>(places.size());
        const glm::vec3 out = leaf == 0   ? glm::vec3(1, 0, 0)
                              : leaf == 1 ? glm::vec3(-0.5f, 0, 1)
                                          : glm::vec3(-0.5f, 0, -1);
        for (std::uint32_t i = 1; i <= n; ++i)
            for (std::uint32_t j = 0; j <= n; ++j) places.push_back(float(i) * out + glm::vec3(0, j, 0));
        const auto at = [&](std::uint32_t i, std::uint32_t j) {
            return i == 0 ? j : begin + (i - 1) * (n + 1) + j;
        };
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j)
                faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    const Mesh book = make_mesh(places, faces);
    const Mesh coarse = refined(book, {60, 0});
    CHECK(coarse.triangles.size() <= 60);
    CHECK(area(coarse) == Approx(area(book)));
    CHECK(mesh_info(coarse).non_manifold_edges == n);
    const Mesh fine = refined(book, {0, 1});
    REQUIRE(fine.warnings.size() == 1);
    CHECK(fine.warnings[0].starts_with("7 vertices"));
    CHECK(fine.face_count() == 4 * book.face_count());
}

TEST_CASE("subdividing keeps and blends the colours of vertices", "[resolution]") {
    Mesh grid = height_field(10, [](float, float) { return 0.0f; });
    for (const glm::vec3& p : grid.positions) grid.colors.emplace_back(p.x / 2 + 0.5f, 0.5f, p.z / 2 + 0.5f);
    for (const MeshResolution wanted : {MeshResolution{50, 0}, MeshResolution{0, 2}}) {
        const Mesh made = refined(grid, wanted);
        REQUIRE(made.colors.size() == made.positions.size());
        for (std::size_t v = 0; v < made.positions.size(); ++v) {  // positions use the same weights
            CHECK(made.colors[v].x == Approx(made.positions[v].x / 2 + 0.5f).margin(1e-6));
            CHECK(made.colors[v].z == Approx(made.positions[v].z / 2 + 0.5f).margin(1e-6));
        }
    }
}

TEST_CASE("a subdivision with too many faces is refused in one line", "[resolution]") {
    const auto refused = [](const Mesh& mesh, const MeshResolution& wanted) {
        const Result<Mesh> made = with_resolution(mesh, wanted);
        REQUIRE(problem_of(made) != nullptr);
        return problem_of(made)->text();
    };
    const Mesh ball = make_primitive(Primitive::Icosphere, 5);  // 20 * 4^5 faces
    CHECK(refused(ball, {0, 5}) ==
          "/subdivide: subdivided 5 times, the mesh has 20971520 faces; expected at most 8388608");
    const Mesh cone = make_primitive(Primitive::Cone, 9000);
    CHECK(refused(cone, {0, 1}) ==
          "/subdivide: 9000 faces meet at one vertex of the mesh; expected at most 8192 to change the "
          "resolution");
    CHECK(refused(cone, {100, 0}).starts_with("/decimate: 9000 faces"));
    const Mesh cylinder = make_primitive(Primitive::Cylinder, 9000);  // its caps have as many corners
    CHECK(refused(cylinder, {0, 1}) ==
          "/subdivide: a face of the mesh has 9000 corners; expected at most 8192 to change the resolution");
    CHECK(refused(cylinder, {100, 0}).starts_with("/decimate: a face of the mesh has 9000 corners"));
}
