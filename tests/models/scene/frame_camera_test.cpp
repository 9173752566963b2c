#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <random>

#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

MeshPtr triangle_at(glm::vec3 place, float size) {
    Mesh mesh;
    mesh.positions = {place, place + glm::vec3(size, 0, 0), place + glm::vec3(0, size, size)};
    mesh.first_corner = {0, 3};
    mesh.corner_position = {0, 1, 2};
    finish_mesh(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

Scene scene_of(const Projection& projection, const std::vector<MeshPtr>& meshes) {
    Scene scene;
    scene.camera.eye = {3, 2, 6};
    scene.camera.projection = projection;
    for (const MeshPtr& mesh : meshes) scene.objects.emplace_back().mesh = mesh;
    return scene;
}

/// The largest |x|, |y| or |z| of a corner in normalized device coordinates; 1 is the edge of the view.
double farthest_out(const Scene& scene, PictureSize size) {
    const glm::dmat4 m = clip_from_view(scene.camera.projection, size) * view_from_world(scene.camera);
    double most = 0;
    for (const Object& o : scene.objects)
        for (const std::uint32_t p : o.mesh->corner_position) {
            const glm::dvec4 c =
                m * world_from_object(o.transform) * glm::dvec4(glm::dvec3(o.mesh->positions[p]), 1);
            for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(c[i]) / c.w);
        }
    return most;
}

bool reads_back(const Scene& scene) {
    return problem_of(parse_scene(scene_text(scene), "framed")) == nullptr;
}

}  // namespace

TEST_CASE("a framed scene fits and fills the view for every projection and size", "[frame_camera]") {
    const std::vector<Projection> projections{Perspective{}, Perspective{1, 0.1f, 100},
                                              Perspective{120, 1, 2}, Orthographic{},
                                              Frustum{-1, 2, -0.5f, 1.5f, 1, 11}};
    for (const Projection& projection : projections)
        for (const float scale : {1e-3f, 1.0f, 1e4f}) {
            Scene scene = scene_of(projection, {triangle_at({5 * scale, 0, 0}, scale)});
            frame_camera(scene);
            INFO(scene_text(scene));
            for (const PictureSize size : {PictureSize{1280, 720}, PictureSize{512, 512}}) {
                CHECK(farthest_out(scene, size) < 1);
                CHECK(farthest_out(scene, size) > 0.3);
            }
            CHECK(far_of(scene.camera.projection) / near_of(scene.camera.projection) < 5000);
            CHECK(reads_back(scene));
        }
}

TEST_CASE("framing keeps the viewing direction and the angle of view", "[frame_camera]") {
    Scene scene = scene_of(Frustum{-1, 2, -0.5f, 1.5f, 1, 11}, {triangle_at({0, 0, 0}, 1)});
    frame_camera(scene);
    const glm::vec3 back = glm::normalize(scene.camera.eye - scene.camera.target);
    CHECK(glm::distance(back, glm::normalize(glm::vec3(3, 2, 6))) < 1e-5f);
    const auto& f = std::get<Frustum>(scene.camera.projection);
    CHECK(f.left / f.near == Approx(-1));
    CHECK(f.right / f.near == Approx(2));
    CHECK(f.top / f.near == Approx(1.5));
    CHECK(scene.camera.up == glm::vec3(0, 1, 0));
}

TEST_CASE("framing one object targets its transformed position", "[frame_camera]") {
    Scene scene = scene_of(Perspective{}, {triangle_at({0, 0, 0}, 1), triangle_at({0, 0, 0}, 2)});
    scene.objects[1].transform.translate = {10, 0, 0};
    frame_camera(scene, 1);
    CHECK(scene.camera.target == glm::vec3(11, 1, 1));
    frame_camera(scene);
    CHECK(scene.camera.target == glm::vec3(6, 1, 1));
}

TEST_CASE("a scene that cannot be framed keeps a valid camera", "[frame_camera]") {
    Scene empty;
    CHECK_FALSE(frame_camera(empty));
    CHECK(empty == Scene{});
    Scene far = scene_of(Perspective{}, {triangle_at({1e7f, 0, 0}, 1)});
    const Camera before = far.camera;
    CHECK_FALSE(frame_camera(far));
    CHECK(far.camera == before);
    far.objects[0] = scene_of(Perspective{}, {triangle_at({1e6f, 0, 0}, 1)}).objects[0];
    CHECK(frame_camera(far));
    for (const float size : {0.0f, 1e-38f, 1e7f})
        for (const glm::vec3 place : {glm::vec3(0), glm::vec3(1e6f, 0, 0), glm::vec3(-1e7f, 1e7f, 0)}) {
            Scene scene = scene_of(Perspective{}, {triangle_at(place, size)});
            frame_camera(scene);
            CHECK(reads_back(scene));
            scene.camera.projection = Orthographic{};
            frame_camera(scene, 0);
            CHECK(reads_back(scene));
        }
}

TEST_CASE("an off-axis frustum can also be framed", "[frame_camera]") {
    Scene scene = scene_of(Frustum{1, 2, 1, 2, 1, 11}, {triangle_at({0, 0, 0}, 1)});
    frame_camera(scene);
    CHECK(reads_back(scene));
    CHECK(scene.camera.eye != glm::vec3(3, 2, 6));
}

// Numbers worked out by hand for eye (4,3,5), target (0,1,1), up (0,1,0), and frustum -1 2 -0.5 1.5 1 11.
TEST_CASE("view_from_world maps the eye to the origin and the target to -z", "[camera]") {
    const Camera camera{{4, 3, 5}, {0, 1, 1}, {0, 1, 0}, {}};
    const glm::dmat4 m = view_from_world(camera);
    const glm::dvec4 target = m * glm::dvec4(0, 1, 1, 1), p = m * glm::dvec4(1, 2, 3, 1);
    CHECK(target.z == Approx(-6));
    CHECK(std::abs(target.x) + std::abs(target.y) < 1e-12);
    CHECK(p.x == Approx(-0.70710678));
    CHECK(p.y == Approx(0.23570226));
    CHECK(p.z == Approx(-3.6666667));
    const glm::dmat4 identity = m * world_from_view(camera);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) CHECK(identity[c][r] == Approx(c == r ? 1 : 0).margin(1e-14));
}

TEST_CASE("an asymmetric frustum maps its six planes to -1 and +1", "[camera]") {
    const glm::dmat4 m = clip_from_view(Frustum{-1, 2, -0.5f, 1.5f, 1, 11}, {640, 480});
    const auto ndc = [&m](glm::dvec3 p) {
        const glm::dvec4 c = m * glm::dvec4(p, 1);
        return glm::dvec3(c) / c.w;
    };
    const glm::dvec3 low = ndc({-1, -0.5, -1}), high = ndc({22, 16.5, -11}), inside = ndc({0.5, 0.5, -2});
    for (int i = 0; i < 3; ++i) {
        CHECK(low[i] == Approx(-1));
        CHECK(high[i] == Approx(1));
    }
    CHECK(inside.x == Approx(-1.0 / 6));
    CHECK(inside.y == Approx(-0.25));
    CHECK(inside.z == Approx(0.1));
}

TEST_CASE("a perspective camera projects (1, 0.5, -5) to the expected pixel", "[camera]") {
    const glm::dmat4 m = clip_from_view(Perspective{45, 0.1f, 100}, {640, 480});
    const glm::dvec4 c = m * glm::dvec4(1, 0.5, -5, 1);
    CHECK((c.x / c.w + 1) * 320 == Approx(435.882251));
    CHECK((1 - c.y / c.w) * 240 == Approx(182.058875));
    CHECK(c.z / c.w == Approx(0.961962).epsilon(1e-6));
}

// Transforms in any order are converted to a scene file's order without changing the matrix, or refused.
namespace {

/// OpenGL's matrix after the three calls, by GLM: each multiplies from the right.
glm::dmat4 product(const Transform& t, const TransformOrder& order) {
    glm::dmat4 m(1);
    for (const TransformStep step : order) {
        if (step == TransformStep::Translate) m = glm::translate(m, glm::dvec3(t.translate));
        if (step == TransformStep::Scale) m = glm::scale(m, glm::dvec3(t.scale));
        if (step == TransformStep::Rotate) {
            const glm::dvec3 angle = glm::radians(glm::dvec3(t.rotate_deg));
            m = glm::rotate(m, angle.z, {0, 0, 1});
            m = glm::rotate(m, angle.y, {0, 1, 0});
            m = glm::rotate(m, angle.x, {1, 0, 0});
        }
    }
    return m;
}

}  // namespace

TEST_CASE("a transform in any order converts to the file's order with the same matrix", "[transform]") {
    std::mt19937 random(5);
    const auto number = [&random] { return static_cast<float>(random() % 2001) / 100 - 10; };
    for (int i = 0; i < 200; ++i) {
        const float scale = number() + 0.003f;
        const Transform written{{number(), number(), number()},
                                {9 * number(), 9 * number(), 9 * number()},
                                {scale, scale, scale}};
        for (TransformOrder order = file_order;;) {
            const auto transform = in_file_order(written, order);
            REQUIRE(transform);
            const glm::dmat4 expected = product(written, order), found = world_from_object(*transform);
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) CHECK(found[c][r] == Approx(expected[c][r]).margin(2e-5));
            if (!std::next_permutation(order.begin(), order.end())) break;
        }
    }
}

TEST_CASE("a scale cannot be moved before a rotation that turns its axes", "[transform]") {
    using enum TransformStep;
    const Transform shears{{1, 2, 3}, {0, 0, 30}, {1, 2, 1}};
    CHECK_FALSE(in_file_order(shears, {Scale, Rotate, Translate}));
    CHECK_FALSE(in_file_order(shears, {Scale, Translate, Rotate}));
    CHECK(in_file_order(shears, {Rotate, Scale, Translate}));
    // A rotation about the axis of the scale, or no rotation, causes no shear.
    CHECK(in_file_order({{1, 2, 3}, {0, 40, 0}, {1, 2, 1}}, {Scale, Rotate, Translate}));
    CHECK(in_file_order({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}}, {Scale, Translate, Rotate}));
    CHECK(in_file_order(shears, file_order) == shears);
}
