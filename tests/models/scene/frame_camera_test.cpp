#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

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

TEST_CASE("framing keeps the viewing direction and the angles", "[frame_camera]") {
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
