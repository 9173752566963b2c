// The limits of a scene and its picture, and the estimate that is compared with --memory.
#include "models/scene/scene_cost.h"

#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20;

std::string problem_with(const Scene& scene, PictureSize size = {0, 0}, int samples = 1) {
    const auto problem = too_large(scene, size, samples);
    return problem ? problem->text() : "";
}

}  // namespace

TEST_CASE("a mesh's lists count once, however many objects use it", "[memory]") {
    Scene scene;
    scene.objects = {test::object_of(test::primitive(Primitive::Plane, 1))};
    const Mesh& mesh = *scene.objects[0].mesh;
    CHECK(mesh_bytes(mesh) >= mesh.positions.size() * 12 + mesh.triangles.size() * sizeof(Triangle));
    const SceneCost one = scene_cost(scene, {0, 0}, 1);
    CHECK(one.meshes == mesh_bytes(mesh));
    scene.objects.push_back(scene.objects[0]);
    const SceneCost two = scene_cost(scene, {0, 0}, 1);
    CHECK(two.meshes == one.meshes);
    CHECK(two.objects == 2 * one.objects);
}

TEST_CASE("a scene that exceeds the memory limit is a problem that names its largest part", "[memory]") {
    Scene scene;
    scene.objects = {test::object_of(test::primitive(Primitive::Sphere, 100))};
    const test::MemoryLimit limit(64 * mib);
    CHECK(problem_with(scene, {640, 480}) == "");
    const std::string picture = problem_with(scene, {2048, 1024});
    CHECK(picture.starts_with("this needs 1"));
    CHECK(
        picture.ends_with(" MiB of it for the picture; expected at most 64.0 MiB (--memory and "
                          "GLINT_MEMORY change that)"));
    CHECK(problem_with(scene, {1024, 512}, 8) == "");
    CHECK(problem_with(scene, {1024, 1024}, 8) != "");
    scene.objects.assign(100, scene.objects[0]);
    CHECK(problem_with(scene).find(" MiB of it for the objects; expected at most 64.0 MiB") !=
          std::string::npos);
}

TEST_CASE("a scene has at most 2^30 triangles, and a picture at most 2^30 samples", "[memory]") {
    Scene scene;
    const MeshPtr mesh = test::primitive(Primitive::Sphere, 300);
    const std::size_t count = max_scene_triangles / mesh->triangles.size();
    scene.objects.assign(count, test::object_of(mesh));
    const test::MemoryLimit limit(std::uint64_t{1} << 50);
    CHECK(problem_with(scene) == "");
    scene.objects.push_back(scene.objects[0]);
    CHECK(problem_with(scene).starts_with("/objects: the objects have 107"));
    CHECK(problem_with(scene).ends_with(" triangles; expected at most 1073741824 in a scene"));
    scene.objects.clear();
    CHECK(problem_with(scene, {16384, 16384}, 4) == "");
    CHECK(problem_with(scene, {16384, 16384}, 8) ==
          "the picture has 2147483648 samples; expected at most 1073741824, pixels times samples");
}
