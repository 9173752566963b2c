// What the renderer asks for before it draws is at least what it then takes, and not many times as much.
// Counted in operator new itself.
#include "renderer/drawing_memory.h"

#include "models/mesh/mesh_memory.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"
#include "tests/allocations/counted_new.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

Scene opened(const std::string& path, const std::vector<Assignment>& changes = {}) {
    return std::get<SceneDocument>(open_document(project_file(path), changes)).scene;
}

/// The largest number of bytes that were held at once while `action` ran, beside those held before.
template <class Do> double max_held(const Do& action) {
    const std::int64_t before = bytes_held;
    max_bytes_held = before;
    action();
    return static_cast<double>(max_bytes_held - before);
}

struct Asked {
    double before = 0, counted = 0;  // guessed beforehand; claimed after the picture was drawn
    double taken = 0;
};

Asked memory_of(const Scene& scene, PictureSize size, bool linear, int samples) {
    Asked asked;
    DrawingMemory memory = drawing_memory(scene, size, linear, samples);
    asked.before = static_cast<double>(memory.certain.total() + memory.guessed.total());
    const std::uint64_t left = memory_left();
    asked.taken = max_held([&] {
        Renderer renderer(2);
        (void)renderer.render(scene, size, linear, samples);
        asked.counted = static_cast<double>(left - memory_left());
    });
    return asked;
}

}  // namespace

TEST_CASE("drawing takes at most what was asked for before, and a quarter of it at least",
          "[allocations][memory]") {
    const std::string knot = "tests/bench/knot.json";
    const std::vector<std::pair<const char*, Scene>> scenes = {
        {"default", opened("assets/scenes/default.json")},
        {"knot", opened(knot)},
        {"fine knot", opened(knot, {{"/objects/0/mesh/detail", "1500"}})},
        {"gouraud", opened(knot, {{"/shading/mode", "gouraud"}})},
        {"scanline", opened(knot, {{"/shading/mode", "gouraud"}, {"/shading/interpolation", "scanline"}})},
        {"flat", opened(knot, {{"/shading/mode", "flat"}})},
        {"facet normals", opened(knot, {{"/objects/0/normals", R"({"source": "facet"})"}})},
        {"creased normals",
         opened(knot, {{"/objects/0/normals", R"({"source": "vertex", "crease_deg": 30})"}})},
        {"strokes", opened(knot, {{"/npr/silhouettes", "true"}, {"/npr/creases", "true"}})},
    };
    for (const auto& [name, scene] : scenes)
        for (const auto& [size, samples] :
             {std::pair{PictureSize{640, 360}, 1}, {PictureSize{1280, 720}, 1}, {PictureSize{1280, 720}, 8}})
            for (const bool linear : {false, true}) {
                const Asked asked = memory_of(scene, size, linear, samples);
                CAPTURE(name, size.width, samples, linear, asked.before, asked.counted, asked.taken);
                CHECK(asked.before >= asked.taken);
                CHECK(asked.before <= 4 * asked.taken + (8 << 20));
            }
}

TEST_CASE("making a primitive takes at most what was asked for before", "[allocations][memory]") {
    for (const auto& [primitive, detail] : {std::pair{Primitive::Sphere, 300},
                                            {Primitive::BumpySphere, 300},
                                            {Primitive::Icosphere, 6},
                                            {Primitive::Cube, 90},
                                            {Primitive::Plane, 200},
                                            {Primitive::Torus, 300},
                                            {Primitive::Cylinder, 20000},
                                            {Primitive::Cone, 40000},
                                            {Primitive::Teapot, 40},
                                            {Primitive::Knot, 700},
                                            {Primitive::SkewQuad, 1}}) {
        double kept = 0;
        const double taken = max_held(
            [&, p = primitive, d = detail] { kept = static_cast<double>(mesh_bytes(make_primitive(p, d))); });
        const auto made = static_cast<double>(bytes_to_make(primitive, detail));
        CAPTURE(static_cast<int>(primitive), detail, taken, made, kept);
        CHECK(made >= taken);
        CHECK(static_cast<double>(bytes_once_made(primitive, detail)) >= kept);
        CHECK(made <= 5 * taken + (1 << 17));
    }
}

TEST_CASE("making the bytes of a picture takes at most what was asked for before", "[allocations][memory]") {
    const Scene scene = opened("assets/scenes/default.json");
    constexpr PictureSize size{1600, 900};
    Renderer renderer(2);
    const Picture& picture = renderer.render(scene, size, true);
    const auto check = [&](const char* format, std::uint64_t asked, double taken) {
        CAPTURE(format, asked, taken);
        CHECK(static_cast<double>(asked) >= taken);
        CHECK(static_cast<double>(asked) <= 40 * taken);  // a PNG may be far smaller than its colours
    };
    check("png", png_memory(size), max_held([&] { (void)png_bytes(picture, ""); }));
    check("pfm", pfm_memory(size), max_held([&] { (void)pfm_bytes(picture, 1); }));
    check("exr", exr_memory(size), max_held([&] { (void)exr_bytes(picture, 1); }));
}

TEST_CASE("fifty objects of one mesh take what depends on their places, and one mesh",
          "[allocations][memory]") {
    Scene one = opened("tests/bench/knot.json", {{"/objects/0/mesh/detail", "800"}});
    Scene many = one;
    for (int i = 1; i < 50; ++i) {
        many.objects.push_back(one.objects.front());
        many.objects.back().transform.translate.x = 0.01f * static_cast<float>(i);
    }
    constexpr PictureSize size{320, 180};
    const Mesh& mesh = *one.objects.front().mesh;
    const double first = memory_of(one, size, false, 1).taken, all = memory_of(many, size, false, 1).taken;
    // Vertices and normals, and the lists of triangles, of which less than half are so large here that they
    // come into some tile's, 16 bytes each. The list of corners and the normals in object coordinates are the
    // mesh's.
    const double placed =
        static_cast<double>(mesh.positions.size() * (32 + 16 + 16) + mesh.triangles.size() * (8 + 4 + 8));
    CAPTURE(first, all, placed, mesh.triangles.size(), mesh.positions.size());
    CHECK(all - first < 49 * placed);
}
