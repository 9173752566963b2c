// Files that somebody broke on purpose, and files that chance broke.
#include <fmt/format.h>

#include <random>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_open.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

/// A triangle in 36 bytes, with a normal, as a .glb by our writer.
std::string triangle_glb() {
    const TemporaryDirectory folder;
    const std::string obj = folder.file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto document = std::get<SceneDocument>(open_document(obj));
    return std::get<GltfWritten>(glb_of(document.scene, "t")).bytes;
}

constexpr const char* triangle = R"({"asset": {"version": "2.0"},
 "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri":
   "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = triangle;
    const std::size_t at = text.find(from);
    if (at == text.npos) throw std::runtime_error("not there: " + from);
    return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& bytes, const std::string& name = "t.gltf") {
    const TemporaryDirectory folder;
    const Result<SceneDocument> opened = open_document(folder.file(name, bytes));
    const Problem* problem = problem_of(opened);
    if (problem == nullptr) return "";
    const std::string text = problem->text();
    return text.starts_with(folder.path() + "/") ? text.substr(folder.path().size() + 1) : text;
}

}  // namespace

TEST_CASE("a hostile glTF file is one line that says where and what", "[gltf]") {
    REQUIRE(error_of(triangle).empty());
    const auto check = [](const std::string& from, const std::string& to, const std::string& line) {
        CHECK(error_of(changed(from, to)) == line);
    };
    check("\"count\": 3", "\"count\": 4294967296",
          "t.gltf: /accessors/0/count: 4294967296 is out of range; expected a whole number from 0 to "
          "2147483647");
    check("\"count\": 3", "\"count\": 4",
          "t.gltf: /accessors/0: its 4 numbers end at byte 48 of its buffer view, which has 36; expected a "
          "view that "
          "holds them");
    check("\"count\": 3", "\"count\": 3, \"byteOffset\": 9007199254740000",
          "t.gltf: /accessors/0/byteOffset: 9007199254740000 is out of range; expected a whole number from 0 "
          "to "
          "9000000000000000");
    check("\"byteLength\": 36}", "\"byteLength\": 37}",
          "t.gltf: /bufferViews/0: its bytes 0 to 37 lie beyond its buffer; expected bytes 0 to 36");
    check("\"buffer\": 0", "\"buffer\": 1",
          "t.gltf: /bufferViews/0: its buffer 1 is not there; expected one of 1");
    check("\"byteLength\": 36, \"uri\"", "\"byteLength\": 40, \"uri\"",
          "t.gltf: /buffers/0: its data has 36 bytes; expected 40, its byteLength");
    check("AAAgD8AAAAA", "AAAgD8AA",
          "t.gltf: /buffers/0: its data has 33 bytes; expected 36, its byteLength");
    check("AAAgD8AAAAA", "AAAgD8!",
          "t.gltf: /buffers/0/uri: the data URI holds a character that is not of base64; expected letters, "
          "digits, + "
          "and /");
    for (const std::string file : {"/dev/zero", "/etc/passwd", "/tmp/a.bin", "../a.bin", "b/../../a.bin",
                                   "a.txt", "%2e%2e/a.bin", "http://a.b/c.bin/..", ""})
        check("data:application/octet-stream;base64,", file + "\", \"x\": \"",
              "t.gltf: /buffers/0/uri: \"" + file +
                  "\" is not a buffer that may be opened; expected a file that ends in .bin, beside this one "
                  "or "
                  "below, or a data URI");
    check("data:application/octet-stream;base64,", "there/is/none.bin\", \"x\": \"",
          "t.gltf: /buffers/0/uri: \"there/is/none.bin\": cannot read: no such file or directory; "
          "expected a file that can be read");
    check("\"mesh\": 0", "\"mesh\": 1",
          "t.gltf: /nodes/0/mesh: 1 of \"meshes\" is not there; expected 0 to 0");
    check("\"mesh\": 0", "\"mesh\": 0, \"children\": [0]",
          "t.gltf: /nodes/0: the node is below itself, or below two others; expected a tree of nodes");
    check("\"nodes\": [0]", "\"nodes\": [7]", "t.gltf: the scene has a node 7; expected one of 1 nodes");
    check("\"nodes\": [0]", "\"nodes\": [-1]",
          "t.gltf: /scenes/0/nodes/0: it is not the number of a node; expected a whole number");
    check("\"POSITION\": 0", "\"NORMAL\": 0",
          "t.gltf: /meshes/0/primitives/0/attributes: the key \"POSITION\" is missing; expected a whole "
          "number from 0 "
          "to 4294967295");
    check("{\"POSITION\": 0}", "{\"POSITION\": 0}, \"indices\": 0",
          "t.gltf: /accessors/0: its type is \"VEC3\"; expected \"SCALAR\"");
    check("5126", "5130",
          "t.gltf: /accessors/0: its componentType is 5130; expected 5120, 5121, 5122, 5123, 5125 or 5126");
    check("AAAAAAAAAAAAAAAAAACAPw", "AADAfwAAAAAAAAAAAACAPw",
          "t.gltf: /meshes/0/primitives/0/attributes/POSITION: a number of vertex 0 is nan; expected a "
          "number within "
          "-1e30 and 1e30");
    check("\"2.0\"}", "\"1.0\"}", "t.gltf: /asset: \"1.0\" is its version; expected 2.0");
    check("\"2.0\"}", "\"2.0\"}, \"extensionsRequired\": [\"KHR_draco_mesh_compression\"]",
          "t.gltf: /extensionsRequired/0: \"KHR_draco_mesh_compression\" is needed, and cannot be read here; "
          "expected "
          "a file without that extension");
    check("\"nodes\": [{\"mesh\": 0}]", "\"nodes\": [{}]",
          "t.gltf: its scene has no mesh; expected at least one triangle");
    CHECK(error_of("{}") ==
          "t.gltf: the key \"asset\" is missing; expected {\"asset\": {\"version\": \"2.0\"}}");
    CHECK(error_of(std::string(100'000, '[')).starts_with("t.gltf:1: "));
}

TEST_CASE("what the glTF specification forbids is one line that says where and what", "[gltf]") {
    const auto check = [](const std::string& from, const std::string& to, const std::string& line) {
        CHECK(error_of(changed(from, to)) == line);
    };
    const std::string node = "\"nodes\": [{\"mesh\": 0}]";
    const auto check_node = [&](const std::string& more, const std::string& line) {
        check(node, "\"nodes\": [{\"mesh\": 0, " + more + "}]", "t.gltf: /nodes/0" + line);
    };
    const std::string lamp = "\"extensions\": {\"KHR_lights_punctual\": {\"light\": 1}}";
    const std::string at_lamp =
        "/extensions/KHR_lights_punctual/light: 1 of \"lights\" is not there; expected ";
    check_node(lamp, at_lamp + "no number: the list is empty");
    check(node,
          "\"nodes\": [{\"mesh\": 0, " + lamp +
              "}], \"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"point\"}]}}",
          "t.gltf: /nodes/0" + at_lamp + "0 to 0");
    check("\"2.0\"}", "\"2.0\", \"minVersion\": \"3.0\"}",
          "t.gltf: /asset/minVersion: \"3.0\" is needed to read it; expected 2.0");
    check("\"2.0\"}", "\"2.0\", \"minVersion\": \"20\"}",
          "t.gltf: /asset/minVersion: \"20\" is needed to read it; expected 2.0");
    CHECK(error_of(changed("\"2.0\"}", "\"2.0\", \"minVersion\": \"2.0\"}")).empty());

    const std::string unit = "\"matrix\": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
    CHECK(error_of(changed(node, "\"nodes\": [{\"mesh\": 0, " + unit + "}]")).empty());
    for (const char* other : {"translation", "rotation", "scale"})
        check_node(fmt::format("{}, \"{}\": [0, 0, 1]", unit, other),
                   fmt::format(": it has a matrix and a {}; expected a matrix alone", other));
    check_node("\"matrix\": [1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, 2]",
               "/matrix: its bottom row is 0 0.5 0 2; expected 0 0 0 1");
    check_node("\"rotation\": [0, 0, 0, 0]",
               "/rotation: the quaternion is zero; expected a quaternion of length 1");

    const std::string view = "\"buffer\": 0, \"byteLength\": 36";
    for (const char* stride : {"0", "1", "6", "256"})
        check(view, fmt::format("{}, \"byteStride\": {}", view, stride),
              fmt::format(
                  "t.gltf: /bufferViews/0/byteStride: {} is out of range; expected a multiple of 4 from "
                  "4 to 252",
                  stride));
    check(
        view, view + ", \"byteStride\": 8",
        "t.gltf: /accessors/0: its elements have 12 bytes and lie 8 bytes apart; expected a byteStride of at "
        "least 12");
    CHECK(error_of(changed(view, view + ", \"byteStride\": 12")).empty());

    check("5126", "5123",
          "t.gltf: /meshes/0/primitives/0/attributes/POSITION: its componentType is 5123; expected 5126 "
          "(floats), or \"KHR_mesh_quantization\" in \"extensionsUsed\"");
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
        CHECK(error_of(changed("5126, \"count\": 3, \"type\": \"VEC3\"}]",
                               fmt::format("5123, \"count\": 3, \"type\": \"VEC3\"}}], \"{}\": "
                                           "[\"KHR_mesh_quantization\"]",
                                           list)))
                  .empty());
    check("5126", "5125",
          "t.gltf: /meshes/0/primitives/0/attributes/POSITION: its componentType is 5125; expected 5126 "
          "(floats)");
    check("{\"POSITION\": 0}}]}],\n \"accessors\": [",
          "{\"POSITION\": 0}, \"indices\": 1}]}],\n \"accessors\": [{\"bufferView\": 0, \"componentType\": "
          "5126, \"count\": 3, \"type\": \"VEC3\"}, {\"bufferView\": 0, \"componentType\": 5126, "
          "\"count\": 3, \"type\": \"SCALAR\"}, ",
          "t.gltf: /meshes/0/primitives/0/indices: its componentType is 5126; expected 5121, 5123 or 5125");
}

TEST_CASE("nodes of glTF that no scene reaches are checked too", "[gltf]") {
    const auto check = [](const std::string& node, const std::string& line) {
        CHECK(error_of(changed("[{\"mesh\": 0}]", "[{\"mesh\": 0}, " + node + "]")) ==
              "t.gltf: /nodes/1" + line);
    };
    check("{\"mesh\": 77}", "/mesh: 77 of \"meshes\" is not there; expected 0 to 0");
    check("{\"camera\": 3}", "/camera: 3 of \"cameras\" is not there; expected no number: the list is empty");
    check("{\"children\": [1, 5]}", "/children/1: node 5 is not there; expected 0 to 1");
    check("{\"rotation\": [0, 0, 0, 0]}",
          "/rotation: the quaternion is zero; expected a quaternion of length 1");
}

TEST_CASE("a glTF file of which nothing can be drawn says why", "[gltf]") {
    const auto check = [](const std::string& node, const std::string& what) {
        CHECK(error_of(changed("{\"mesh\": 0}", "{\"mesh\": 0, " + node + "}")) ==
              "t.gltf: nothing of its scene can be drawn: " + what + "; expected at least one triangle");
    };
    check("\"scale\": [1, 0, 1]", "1 object has a scale of 0, which makes it flat, and is left out");
    check("\"matrix\": [1e30, 1e30, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
          "1 object is larger or further away than 1e30, and is left out");
    CHECK(
        error_of(changed("{\"POSITION\": 0}", "{\"POSITION\": 0}, \"mode\": 0")) ==
        "t.gltf: nothing of its scene can be drawn: 1 primitive of points or lines is left out; expected at "
        "least one triangle");
}

TEST_CASE("a light that its node leaves no direction is one line, unless it needs none", "[gltf]") {
    const auto error_with = [](const std::string& type) {
        return error_of(
            changed("\"nodes\": [{\"mesh\": 0}], \"scenes\": [{\"nodes\": [0]}]",
                    "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"" + type +
                        "\"}]}}, \"nodes\": [{\"mesh\": 0}, {\"scale\": [1, 1, 0], \"extensions\": "
                        "{\"KHR_lights_punctual\": {\"light\": 0}}}], \"scenes\": [{\"nodes\": [0, 1]}]"));
    };
    CHECK(error_with("point").empty());
    for (const char* type : {"spot", "directional"})
        CHECK(error_with(type) ==
              "t.gltf: /extensions/KHR_lights_punctual/lights/0: its node's scale leaves it no direction; "
              "expected a node whose axes have a length");
}

TEST_CASE("a camera that its node leaves no direction is one line", "[gltf]") {
    const std::string camera = "\"cameras\": [{\"type\": \"perspective\"}], ";
    const auto check = [&](const std::string& node, const std::string& what) {
        CHECK(error_of(changed("\"nodes\": [{\"mesh\": 0}]",
                               camera + "\"nodes\": [{\"mesh\": 0, \"camera\": 0, " + node + "}]")) ==
              "t.gltf: /nodes/0: no camera can stand there: " + what +
                  "; expected axes that have a length, at a place within 1e30");
    };
    check("\"scale\": [1, 1, 0]", "eye and target are the same point");
    check("\"scale\": [1, 0, 1]", "up is zero");
}

TEST_CASE("a .glb whose header gives another length than the file has is one line", "[gltf]") {
    std::string whole = triangle_glb();
    const std::size_t size = whole.size();
    const auto with_length = [&](std::size_t length) {
        for (std::size_t i = 0; i < 4; ++i) whole[8 + i] = static_cast<char>(length >> (8 * i) & 0xFF);
        return error_of(whole, "t.glb");
    };
    CHECK(with_length(size).empty());
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, size - 4, size + 4})
        CHECK(
            with_length(length) ==
            fmt::format("t.glb: the header says {} bytes, the file has {}; expected {}", length, size, size));
}

TEST_CASE("a .glb that ends early is one line, wherever it ends", "[gltf]") {
    const std::string whole = triangle_glb();
    REQUIRE(error_of(whole, "t.glb").empty());
    for (std::size_t size = 0; size < whole.size(); size += 3) {
        const std::string line = error_of(whole.substr(0, size), "t.glb");
        CAPTURE(size, line);
        CHECK(line.starts_with("t.glb:"));
        CHECK(line.find('\n') == std::string::npos);
    }
    std::string long_chunk = whole;
    long_chunk[15] = '\x7F';
    CHECK(error_of(long_chunk, "t.glb").find("chunk 0 says 21") != std::string::npos);
}

TEST_CASE("a damaged glTF file is a scene or a problem, never a crash", "[gltf][fuzz]") {
    std::size_t scenes = 0, problems = 0;
    for (const std::string& valid : {std::string(triangle), triangle_glb()})
        for (unsigned seed = 0; seed < 1000; ++seed) {
            std::mt19937 random(seed);
            std::string bytes = valid;
            for (unsigned i = 0; i < 1 + random() % 3; ++i) {
                const std::size_t at = random() % bytes.size();
                if (random() % 4 == 0)
                    bytes.erase(at, 1 + random() % 8);
                else
                    bytes[at] =
                        random() % 2 == 0 ? static_cast<char>(random()) : "0123456789-e."[random() % 13];
            }
            INFO(seed);
            const Result<GltfFile> file = GltfFile::parse(bytes, "t.gltf");
            const Problem* problem = problem_of(file);
            Result<Mesh> mesh;
            Result<GltfFile::Content> content;
            if (problem == nullptr) {
                mesh = std::get<GltfFile>(file).mesh(0);
                content = std::get<GltfFile>(file).content("t.gltf");
                problem = problem_of(mesh) != nullptr ? problem_of(mesh) : problem_of(content);
            }
            if (problem == nullptr) {
                ++scenes;
                continue;
            }
            ++problems;
            CHECK(problem->text().find('\n') == std::string::npos);
            CHECK_FALSE(problem->what.empty());
            CHECK_FALSE(problem->expected.empty());
        }
    CHECK(scenes > 50);
    CHECK(problems > 50);
}
