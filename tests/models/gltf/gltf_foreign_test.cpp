// glTF files as other programs write them: features that are left out or refused.
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"

using namespace glint;
using namespace glint::gltf_triangle;

namespace {

SceneDocument opened_text(const std::string& text) {
    const TemporaryDirectory folder;
    Result<SceneDocument> result = open_document(folder.file("t.gltf", text));
    if (const Problem* problem = problem_of(result)) FAIL(problem->text());
    return std::get<SceneDocument>(std::move(result));
}

std::string with_materials(const std::string& materials) {
    return changed("{\"POSITION\": 0}}]}],",
                   "{\"POSITION\": 0}, \"material\": 0}]}], \"materials\": [" + materials + "],");
}

constexpr const char* base_color = R"("pbrMetallicRoughness": {"baseColorFactor": [1, 0.2, 0, 1]})";

}  // namespace

TEST_CASE("an unlit glTF material shows its base colour", "[gltf]") {
    const Scene scene =
        opened_text(with_materials(
                        fmt::format("{{{}, \"extensions\": {{\"KHR_materials_unlit\": {{}}}}}}", base_color)))
            .scene;
    const Material& m = scene.objects[0].material;
    CHECK(m.emission == glm::vec3(1, 0.2f, 0));
    CHECK(m.diffuse == glm::vec3(0));
    CHECK(m.ambient == glm::vec3(0));
    CHECK(m.specular == glm::vec3(0));
}

TEST_CASE("a glTF material's reflectance follows its IOR and specular factors", "[gltf]") {
    struct Case {
        const char *metal, *extensions;
        glm::vec3 diffuse, f0;
        float specular;
    };
    // ((2 - 1)/(2 + 1))^2 = 1/9; glTF's f0 and f90 are specular * f0 and specular here.
    const glm::vec3 white(1);
    for (const Case& c :
         {Case{"0", "", 0.96f * white, 0.04f * white, 1},
          {"0", R"("KHR_materials_ior": {"ior": 2})", white * (8 / 9.0f), white / 9.0f, 1},
          {"0", R"("KHR_materials_ior": {"ior": 0})", 0.0f * white, white, 1},
          {"0", R"("KHR_materials_specular": {"specularFactor": 0})", white, 0.0f * white, 0},
          {"0",
           R"("KHR_materials_ior": {"ior": 2}, "KHR_materials_specular": {"specularFactor": 0.5,
                   "specularColorFactor": [0, 1.5, 100]})",
           {1, 11 / 12.0f, 0.5f},
           {0, 1 / 6.0f, 1},
           0.5f},
          {"0.5", R"("KHR_materials_specular": {"specularFactor": 0})", 0.5f * white, white, 0.5f},
          {"1", R"("KHR_materials_specular": {"specularFactor": 0})", 0.0f * white, white, 1}}) {
        CAPTURE(c.metal, c.extensions);
        const Material m =
            opened_text(with_materials(fmt::format(
                            R"({{"pbrMetallicRoughness": {{"metallicFactor": {}}}, "extensions": {{{}}}}})",
                            c.metal, c.extensions)))
                .scene.objects[0]
                .material;
        CHECK(glm::distance(m.diffuse, c.diffuse) < 1e-6f);
        CHECK(glm::distance(m.f0, c.f0) < 1e-6f);
        CHECK(m.specular == glm::vec3(c.specular));
    }
}

TEST_CASE("a glTF material's unsupported extensions cause a warning each", "[gltf]") {
    CHECK(opened_text(with_materials(R"({"extensions": {"KHR_materials_sheen": {}, "KHR_materials_ior": {},
              "KHR_materials_clearcoat": {"clearcoatFactor": 1}}})"))
              .warnings == Warnings{"1 material has KHR_materials_clearcoat, which is left out",
                                    "1 material has KHR_materials_sheen, which is left out"});
}

TEST_CASE("a glTF emission with a texture is left out with a warning", "[gltf]") {
    const SceneDocument textured =
        opened_text(with_materials(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}})"));
    CHECK(textured.scene.objects[0].material.emission == glm::vec3(0));
    CHECK(textured.warnings == Warnings{"1 material has textures, which are not read",
                                        "1 material has an emissive texture: its emission is left out"});
    CHECK(opened_text(with_materials(R"({"emissiveFactor": [1, 0.5, 0]})"))
              .scene.objects[0]
              .material.emission == glm::vec3(1, 0.5f, 0));
}

TEST_CASE("glTF siblings become objects in the order of the file", "[gltf]") {
    const Scene scene = opened_text(changed(R"("nodes": [{"mesh": 0}])",
                                            R"("nodes": [{"children": [1, 2, 3]}, {"name": "A", "mesh": 0},
                                               {"name": "B", "mesh": 0, "children": [4]}, {"name": "D", "mesh": 0},
                                               {"name": "C", "mesh": 0}])"))
                            .scene;
    std::string names;
    for (const Object& object : scene.objects) names += object.name;
    CHECK(names == "ABCD");
}

TEST_CASE("each glTF object is culled by its own material", "[gltf]") {
    const auto scene_with = [](const char* a, const char* b) {
        std::string text =
            with_materials(fmt::format("{{\"doubleSided\": {}}}, {{\"doubleSided\": {}}}", a, b));
        const std::string primitive = "{\"attributes\": {\"POSITION\": 0}, \"material\": 0}";
        const std::size_t at = text.find(primitive);
        REQUIRE(at != std::string::npos);
        return opened_text(text.insert(at, "{\"attributes\": {\"POSITION\": 0}, \"material\": 1}, ")).scene;
    };
    const Scene mixed = scene_with("true", "false");
    REQUIRE(mixed.objects.size() == 2);
    CHECK(mixed.shading.cull == Cull::Back);
    CHECK(mixed.shading.two_sided);
    CHECK_FALSE(mixed.objects[0].double_sided);  // the inserted primitive has the second material
    CHECK(mixed.objects[1].double_sided);
    const Scene both = scene_with("true", "true"), none = scene_with("false", "false");
    CHECK(both.shading.cull == Cull::None);
    CHECK(both.shading.two_sided);
    CHECK_FALSE(both.objects[0].double_sided);
    CHECK(none.shading.cull == Cull::Back);
    CHECK_FALSE(none.shading.two_sided);
}

TEST_CASE("every instance of a glTF mesh is an object", "[gltf]") {
    // The positions of the triangle also serve as translations.
    const auto scene_with = [](const std::string& attributes) {
        return opened_text(changed("{\"mesh\": 0}",
                                   "{\"mesh\": 0, \"translation\": [0, 0, 5], \"extensions\": "
                                   "{\"EXT_mesh_gpu_instancing\": {\"attributes\": {" +
                                       attributes + "}}}}"))
            .scene;
    };
    const Scene scene = scene_with("\"TRANSLATION\": 0");
    REQUIRE(scene.objects.size() == 3);
    CHECK(scene.objects[0].transform.translate == glm::vec3(0, 0, 5));
    CHECK(scene.objects[1].transform.translate == glm::vec3(1, 0, 5));
    CHECK(scene.objects[2].transform.translate == glm::vec3(0, 1, 5));
    CHECK(scene.objects[2].mesh == scene.objects[0].mesh);
    CHECK(error_of(changed("{\"mesh\": 0}",
                           "{\"mesh\": 0, \"extensions\": {\"EXT_mesh_gpu_instancing\": "
                           "{\"attributes\": {\"ROTATION\": 0}}}}"))
              .find("its type is \"VEC3\"; expected \"VEC4\"") != std::string::npos);
}

TEST_CASE("a file that requires glTF extensions for images and materials is accepted", "[gltf]") {
    for (const char* name :
         {"EXT_texture_webp", "GOOGLE_texture_basis", "KHR_texture_basisu", "KHR_materials_unlit",
          "KHR_techniques_webgl", "EXT_lights_image_based", "EXT_mesh_gpu_instancing"})
        CHECK(error_of(changed("\"2.0\"}", fmt::format("\"2.0\"}}, \"extensionsRequired\": [\"{}\"]", name)))
                  .empty());
    CHECK_FALSE(
        error_of(changed("\"2.0\"}", "\"2.0\"}, \"extensionsRequired\": [\"EXT_meshopt_compression\"]"))
            .empty());
}

TEST_CASE("a mesh that is compressed with Draco is refused, and Draco is named", "[gltf]") {
    std::string text = changed("{\"POSITION\": 0}}",
                               "{\"POSITION\": 0}, \"extensions\": {\"KHR_draco_mesh_compression\": {}}}");
    CHECK(error_of(text).empty());  // the file also has the uncompressed data
    const std::string view = "\"bufferView\": 0, \"componentType\"";
    text.replace(text.find(view), view.size(), "\"componentType\"");
    CHECK(error_of(text) ==
          "t.gltf: /meshes/0/primitives/0: it uses Draco compression, which is not supported; expected a "
          "file without compression");
}

TEST_CASE("a glTF normal that is not a number is treated as missing", "[gltf]") {
    // The second accessor is the first with NaN as its first number.
    std::string text = changed("{\"POSITION\": 0}", "{\"POSITION\": 0, \"NORMAL\": 1}");
    const auto replace = [&text](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("\"type\": \"VEC3\"}]",
            "\"type\": \"VEC3\"}, {\"bufferView\": 0, \"byteOffset\": 36, \"componentType\": "
            "5126, \"count\": 3, \"type\": \"VEC3\"}]");
    replace("\"byteLength\": 36}]", "\"byteLength\": 72}]");
    replace("\"byteLength\": 36, \"uri\"", "\"byteLength\": 72, \"uri\"");
    replace("AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA",
            "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
            "AADAfwAAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/");
    const SceneDocument document = opened_text(text);
    CHECK(document.scene.objects[0].mesh->normals == std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}});
    CHECK(document.warnings == Warnings{"Object 1: 1 normal is not finite and is treated as missing"});
}

TEST_CASE("a glTF spot's two cones become its soft edge", "[gltf]") {
    const Scene scene =
        opened_text(
            changed("\"nodes\": [{\"mesh\": 0}], \"scenes\": [{\"nodes\": [0]}]",
                    "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"spot\", \"spot\": "
                    "{\"innerConeAngle\": 0.3, \"outerConeAngle\": 0.4}}]}}, \"nodes\": [{\"mesh\": 0}, "
                    "{\"extensions\": {\"KHR_lights_punctual\": {\"light\": 0}}}], \"scenes\": [{\"nodes\": "
                    "[0, 1]}]"))
            .scene;
    const SpotCone& cone = scene.lights.at(0).spot;
    CHECK(cone.inner_deg == Approx(0.3 * 57.29578));
    CHECK(cone.cutoff_deg == Approx(0.4 * 57.29578));
    CHECK(cone.exponent == 0);
}

TEST_CASE("glTF nodes far from the origin are moved closer to it, with a warning", "[gltf]") {
    const SceneDocument far =
        opened_text(changed("{\"mesh\": 0}", "{\"mesh\": 0, \"translation\": [500000.25, 5400000.125, 0]}"));
    CHECK(far.scene.objects[0].transform.translate == glm::vec3(-0.75f, -0.875f, 0));
    CHECK(far.warnings ==
          Warnings{"the coordinates are far from the origin: the offset (500001, 5400001, 0) is "
                   "subtracted"});
    CHECK(
        opened_text(changed("{\"mesh\": 0}", "{\"mesh\": 0, \"translation\": [50, 0, 0]}")).warnings.empty());
}

TEST_CASE("glTF features that a scene lacks are counted by kind", "[gltf]") {
    const SceneDocument document = opened_text(changed("{\"POSITION\": 0}}]}",
                                                       R"({"POSITION": 0, "COLOR_0": 0}, "targets": [{}]},
        {"attributes": {"POSITION": 0}, "targets": [{}]}, {"attributes": {"POSITION": 0}, "mode": 1}]})"));
    CHECK(document.warnings == Warnings{"1 primitive has vertex colours, which are not read",
                                        "2 primitives have morph targets, which are left out",
                                        "1 primitive of points or lines is left out"});
}
