// Strokes in the picture: their pixels and coverage, occlusion, and redrawing.
#include "renderer/strokes/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "renderer/renderer.h"
#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize stroke_size{96, 72};

/// An orthographic camera for which one scene unit is one pixel of a 32 x 32 picture, centred at (0, 0).
Scene pixel_scene() {
    Scene scene;
    scene.camera.projection = Orthographic{32, 0.1f, 100};
    scene.display.background = {0.2f, 0.4f, 0.6f};
    scene.global_ambient = {1, 1, 1};
    scene.npr.silhouettes = true;
    scene.npr.stroke = {0.9f, 0.1f, 0.5f};
    return scene;
}

Object quad(float x0, float y0, float x1, float y1, float z) {
    Object o = object_of(polygon_mesh({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {{0, 1, 2, 3}}));
    o.material.ambient = {0.5f, 0.25f, 0.125f};
    return o;
}

float coverage(const Renderer& renderer, int x, int y) { return renderer.explain(x, y).stroke.coverage; }

float largest_coverage(const Renderer& renderer, glm::vec2 place, float reach) {
    float largest = 0;
    const PictureSize size = stroke_size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (glm::distance(glm::vec2(x, y) + 0.5f, place) <= reach)
                largest = std::max(largest, coverage(renderer, x, y));
    return largest;
}

glm::vec2 on_screen(const Camera& camera, PictureSize size, glm::vec3 world) {
    const glm::dvec4 c =
        clip_from_view(camera.projection, size) * view_from_world(camera) * glm::dvec4(glm::dvec3(world), 1);
    return {(c.x / c.w + 1) / 2 * size.width, (1 - c.y / c.w) / 2 * size.height};
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const float t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
    return glm::distance(p, a + t * (b - a));
}

Scene stroked_busy_scene() {
    Scene scene = busy_scene();
    scene.npr.silhouettes = scene.npr.creases = true;
    scene.npr.stroke = {0.1f, 0.7f, 0.3f};
    return scene;
}

}  // namespace

TEST_CASE("a stroke's coverage of a pixel is the pixel's overlap with a band of its width", "[strokes]") {
    CHECK(stroke_share(0, 2) == 1);
    CHECK(stroke_share(0.5f, 2) == 1);
    CHECK(stroke_share(1, 2) == 0.5f);
    CHECK(stroke_share(1.25f, 2) == 0.25f);
    CHECK(stroke_share(1.5f, 2) == 0);
    CHECK(stroke_share(9, 2) == 0);
    CHECK(stroke_share(0, 0.5f) == 0.5f);      // thinner than a pixel and inside it
    CHECK(stroke_share(0.5f, 0.5f) == 0.25f);  // half of the stroke is in this pixel
    CHECK(stroke_share(0, 0) == 0);
}

TEST_CASE("a horizontal edge covers the expected rows with the expected coverage", "[strokes]") {
    Scene scene = pixel_scene();
    Renderer renderer(1);
    const auto rows = [&](float edge_y, float width, std::vector<float> expected, int first) {
        // The quad's upper edge is at row 16 - edge_y of the picture; its other edges are far away.
        scene.objects = {quad(-40, -40, 40, edge_y, 0)};
        scene.npr.stroke_width_px = width;
        const Picture& p = renderer.render(scene, {32, 32}, true);
        for (int i = 0; i < static_cast<int>(expected.size()); ++i) {
            const float c = expected[static_cast<std::size_t>(i)];
            const int y = first + i;
            CAPTURE(edge_y, width, y);
            CHECK(coverage(renderer, 10, y) == Approx(c).margin(1e-5));
            const glm::vec3 shaded =
                renderer.object_at(10, y) == 0 ? scene.objects[0].material.ambient : scene.display.background;
            const glm::vec3 sum = (1 - c) * shaded + c * scene.npr.stroke;
            for (int k = 0; k < 3; ++k) CHECK(p.linear_at(10, y)[k] == Approx(sum[k]).margin(1e-5));
        }
    };
    rows(8, 2, {0, 0, 1, 1, 0, 0}, 5);  // between rows 7 and 8
    rows(8.25f, 2, {0, 0.25f, 1, 0.75f, 0}, 5);
    rows(8, 1, {0, 0.5f, 0.5f, 0}, 6);
    rows(8.5f, 1, {0, 1, 0}, 6);
    rows(8, 0.5f, {0, 0.25f, 0.25f, 0}, 6);
    rows(8, 5, {0, 0.5f, 1, 1, 1, 1, 0.5f, 0}, 4);
}

TEST_CASE("strokes are blended in linear light, before exposure and transfer", "[strokes]") {
    Scene scene = pixel_scene();
    scene.objects = {quad(-40, -40, 40, 8.25f, 0)};
    scene.display.transfer = Transfer::Srgb;
    scene.display.exposure = 0.5f;
    Renderer renderer(1);
    const Picture& p = renderer.render(scene, {32, 32});
    // Row 6: 3/4 background + 1/4 stroke = (.375, .325, .575), exposed (.1875, .1625, .2875); encoded by
    // 1.055 x^(1/2.4) - 0.055 and times 255: 119.96, 112.13, 146.05.
    const std::uint8_t* pixel = &p.rgba[4 * p.pixel(10, 6)];
    CHECK(static_cast<int>(pixel[0]) == 120);
    CHECK(static_cast<int>(pixel[1]) == 112);
    CHECK(static_cast<int>(pixel[2]) == 146);
}

TEST_CASE("exactly the edges of the visible faces of a cube are drawn", "[strokes][property]") {
    std::mt19937 random(11);
    for (int round = 0; round < 30; ++round) {
        Scene scene;
        scene.objects = {object_of(primitive(Primitive::Cube, 1))};
        scene.camera.eye = 4.5f * glm::normalize(uniform_vec3(random, -1, 1));
        if (round % 3 == 0) scene.camera.projection = Orthographic{4, 0.1f, 100};
        scene.npr.silhouettes = scene.npr.creases = true;
        Renderer renderer(1);
        renderer.render(scene, stroke_size);
        const glm::vec3 eye = scene.camera.eye;
        const bool parallel = is_orthographic(scene.camera.projection);
        std::vector<std::array<glm::vec2, 2>> shown, hidden;
        for (int axis = 0; axis < 3; ++axis)
            for (int corner = 0; corner < 4; ++corner) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                glm::vec3 a;
                a[axis] = -1;
                a[u] = corner & 1 ? 1.0f : -1.0f;
                a[v] = corner & 2 ? 1.0f : -1.0f;
                glm::vec3 b = a;
                b[axis] = 1;
                const float limit =
                    parallel ? 0 : 1;  // a face is towards the eye if the eye is beyond its plane
                const bool seen = eye[u] * a[u] > limit || eye[v] * a[v] > limit;
                (seen ? shown : hidden)
                    .push_back(
                        {on_screen(scene.camera, stroke_size, a), on_screen(scene.camera, stroke_size, b)});
            }
        for (const auto& e : shown)
            for (const float t : {0.0f, 0.2f, 0.4f, 0.5f, 0.7f, 0.9f, 1.0f}) {
                CAPTURE(round, t);
                CHECK(largest_coverage(renderer, e[0] + t * (e[1] - e[0]), 1) > 0.7f);
            }
        for (int y = 0; y < stroke_size.height; ++y)
            for (int x = 0; x < stroke_size.width; ++x) {
                const glm::vec2 at = glm::vec2(x, y) + 0.5f;
                float nearest = 1e9f;
                for (const auto& e : shown) nearest = std::min(nearest, distance_to_segment(at, e[0], e[1]));
                CAPTURE(round, x, y);
                CHECK(coverage(renderer, x, y) == Approx(stroke_share(nearest, 2)).margin(0.03));
            }
    }
}

TEST_CASE("edges behind a surface are hidden, edges in front of it are drawn", "[strokes]") {
    Scene scene = pixel_scene();
    scene.npr.creases = true;
    Object cube = object_of(primitive(Primitive::Cube, 1));
    cube.transform.scale = {6, 6, 6};
    cube.transform.rotate_deg = {30, 40, 0};
    scene.objects = {cube, quad(-40, -40, 40, 40, 15)};
    scene.camera.eye.z = 50;
    Renderer renderer(1);
    const auto stroked_pixels = [&](float z) {
        scene.objects[1] = quad(-40, -40, 40, 40, z);
        renderer.render(scene, {32, 32});
        int count = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) count += coverage(renderer, x, y) > 0;
        return count;
    };
    CHECK(stroked_pixels(15) == 0);
    CHECK(stroked_pixels(-15) > 150);
}

TEST_CASE("the outline of a fine sphere has no gap and hides strokes behind it", "[strokes]") {
    // Triangles much smaller than a pixel, and a second sphere behind the first.
    for (const int detail : {12, 48, 400}) {
        Scene scene;
        Object ball = object_of(primitive(Primitive::Sphere, detail));
        Object behind = object_of(primitive(Primitive::Cube, 8));
        behind.transform = {{0, 0, -2}, {10, 20, 30}, {0.4f, 0.4f, 0.4f}};
        scene.objects = {ball, behind};
        scene.npr.silhouettes = scene.npr.creases = true;
        scene.npr.crease_deg = 60;
        Renderer renderer(2);
        renderer.render(scene, stroke_size);
        // The cone of rays that touch a unit sphere at distance 5: tan = 1/sqrt(24), in pixels:
        const double radius =
            1 / std::sqrt(24.0) / std::tan(22.5 * 0.017453292519943295) * stroke_size.height / 2;
        const double flat = radius * (1 - std::cos(3.141592653589793 / detail));  // the polygon's error
        for (int i = 0; i < 720; ++i) {
            const double angle = i * 3.141592653589793 / 360;
            const glm::vec2 out(std::cos(angle), std::sin(angle));
            const glm::vec2 middle(stroke_size.width / 2.0f, stroke_size.height / 2.0f);
            CAPTURE(detail, i);
            CHECK(largest_coverage(renderer, middle + static_cast<float>(radius - flat / 2) * out,
                                   1.0f + static_cast<float>(flat / 2)) > 0.8f);
        }
        for (int y = 0; y < stroke_size.height; ++y)
            for (int x = 0; x < stroke_size.width; ++x) {
                const double r =
                    std::hypot(x + 0.5 - stroke_size.width / 2.0, y + 0.5 - stroke_size.height / 2.0);
                CAPTURE(detail, x, y);
                if (r < radius - 2 * flat - 2 || r > radius + 2) CHECK(coverage(renderer, x, y) == 0);
            }
    }
}

TEST_CASE("a stroke does not spill over another object in front of it", "[strokes]") {
    Scene scene = pixel_scene();
    scene.npr.silhouettes = false;
    scene.npr.creases = true;
    scene.npr.stroke_width_px = 8;
    Object box = object_of(primitive(Primitive::Cube, 1)), ball = object_of(primitive(Primitive::Sphere, 64));
    box.transform = {{-8, 0, -20}, {0, 0, 0}, {8, 8, 8}};   // its right side is column 16
    ball.transform = {{13, 0, 0}, {0, 0, 0}, {12, 12, 2}};  // from column 17 on, without a crease
    scene.objects = {box, ball};
    scene.camera.eye.z = 50;
    Renderer renderer(1);
    renderer.render(scene, {32, 32});
    CHECK(coverage(renderer, 13, 16) == 1);
    CHECK(coverage(renderer, 16, 16) == 1);
    CHECK(renderer.object_at(18, 16) == 1);
    CHECK(coverage(renderer, 18, 16) == 0);
    scene.objects[1].transform.translate.z = -60;  // now the ball is behind
    renderer.render(scene, {32, 32});
    CHECK(coverage(renderer, 18, 16) == 1);
}

TEST_CASE("with strokes every explanation still sums to its pixel", "[strokes][explain]") {
    Scene scene = stroked_busy_scene();
    Renderer renderer(2);
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
        for (const bool tone : {false, true}) {
            scene.shading.mode = mode;
            scene.npr.cool_to_warm = tone;
            const Picture& picture = renderer.render(scene, stroke_size, true);
            int wrong = 0, on_surface = 0, on_background = 0;
            for (int y = 0; y < stroke_size.height; ++y)
                for (int x = 0; x < stroke_size.width; ++x) {
                    const Explanation e = renderer.explain(x, y);
                    const glm::vec3 pixel = picture.linear_at(x, y);
                    wrong += e.sum != pixel;
                    for (std::size_t c = 0; c < 3; ++c)
                        wrong += e.byte[c] != picture.rgba[4 * picture.pixel(x, y) + c];
                    const ExplainedStroke& s = e.stroke;
                    (e.hit ? on_surface : on_background) += s.coverage > 0;
                    const glm::vec3 sum = (1 - s.coverage) * s.shaded + s.coverage * s.color;
                    CHECK(glm::distance(sum, e.sum) < 1e-6f);
                }
            CHECK(wrong == 0);
            CHECK(on_surface > 100);
            CHECK(on_background > 50);
        }
}

TEST_CASE("strokes are redrawn only if their inputs change", "[strokes][stages]") {
    Scene scene = stroked_busy_scene();
    Renderer renderer(2);
    const auto redone = [&] {
        draw_as_fresh(renderer, scene, stroke_size);
        return renderer.stats().strokes_redone;
    };
    CHECK(redone());
    CHECK_FALSE(redone());
    scene.lights[0].position.x += 1;
    CHECK_FALSE(redone());
    scene.objects[0].material.diffuse = {0, 1, 0};
    CHECK_FALSE(redone());
    scene.shading.mode = ShadingMode::Gouraud;
    CHECK_FALSE(redone());
    scene.npr.stroke = {1, 0, 0};
    CHECK_FALSE(redone());
    scene.npr.stroke_width_px = 3;
    CHECK(redone());
    scene.npr.crease_deg = 20;
    CHECK(redone());
    scene.npr.silhouettes = false;
    CHECK(redone());
    scene.camera.eye.x += 0.1f;
    CHECK(redone());
    scene.npr.creases = false;
    CHECK(redone());
    scene.camera.eye.x += 0.1f;
    CHECK_FALSE(redone());
}

TEST_CASE("edges through the eye, giant strokes and strokes without width are harmless",
          "[strokes][hostile]") {
    Scene scene = stroked_busy_scene();
    scene.camera.eye = {0.9f, -0.1f, 0.3f};  // inside the box
    scene.objects.push_back(object_of(primitive(Primitive::Plane, 1)));
    scene.objects[2].transform = {{0.9f, -0.1001f, 0}, {0, 0, 0}, {1e6f, 1, 1e6f}};
    for (const float width : {0.0f, 1e-30f, 2.0f, 1e7f}) {
        scene.npr.stroke_width_px = width;
        Renderer renderer(2);
        const Picture& p = renderer.render(scene, stroke_size, true);
        CHECK(std::all_of(p.linear.begin(), p.linear.end(), [](float c) { return std::isfinite(c); }));
        const Warnings& w = renderer.warnings();
        CHECK(std::any_of(w.begin(), w.end(), [](const std::string& text) {
                  return text == "a stroke wider than 100 pixels is drawn 100 pixels wide";
              }) == (width > 100));
    }
}

// Edges that become strokes: counts worked out by hand, and every edge of many meshes against the definition.
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
    // The normal of 0-1-2 is +y, that of 0-1-3 is -x, and that of 0-1-4 is about -y.
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

TEST_CASE("edges store whether both facets face the eye, both face away, or one does each", "[strokes]") {
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
