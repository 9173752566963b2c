// Deliberately broken files, and randomly damaged ones.
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "models/gltf/gltf.h"
#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/sanitized.h"

using namespace glint;
using namespace glint::gltf_triangle;

TEST_CASE("a hostile glTF file is reported on one line with the place and the error", "[gltf]") {
    REQUIRE(error_of(triangle).empty());
    const auto check = [](const std::string& from, const std::string& to, const std::string& line) {
        CHECK(error_of(changed(from, to)) == line);
    };
    check("\"count\": 3", "\"count\": 4294967296",
          "t.gltf: /accessors/0/count: 4294967296 is out of range; expected a whole number from 0 to "
          "2147483647");
    check("\"count\": 3", "\"count\": 4",
          "t.gltf: /accessors/0: its 4 numbers end at byte 48 of its buffer view, which has 36; expected a "
          "view that contains them");
    check("\"count\": 3", "\"count\": 3, \"byteOffset\": 9007199254740000",
          "t.gltf: /accessors/0/byteOffset: 9007199254740000 is out of range; expected a whole number from 0 "
          "to "
          "9000000000000000");
    check("\"byteLength\": 36}", "\"byteLength\": 37}",
          "t.gltf: /bufferViews/0: its bytes 0 to 37 are beyond its buffer; expected bytes 0 to 36");
    check("\"buffer\": 0", "\"buffer\": 1",
          "t.gltf: /bufferViews/0: its buffer 1 does not exist; expected one of 1");
    check("\"byteLength\": 36, \"uri\"", "\"byteLength\": 40, \"uri\"",
          "t.gltf: /buffers/0: its data has 36 bytes; expected 40, its byteLength");
    check("AAAgD8AAAAA", "AAAgD8AA",
          "t.gltf: /buffers/0: its data has 33 bytes; expected 36, its byteLength");
    check("AAAgD8AAAAA", "AAAgD8!",
          "t.gltf: /buffers/0/uri: the data URI contains a character that is not base64; expected letters, "
          "digits, + "
          "and /");
    for (const std::string file : {"/dev/zero", "/etc/passwd", "/tmp/a.bin", "../a.bin", "b/../../a.bin",
                                   "a.txt", "%2e%2e/a.bin", "http://a.b/c.bin/..", ""})
        check("data:application/octet-stream;base64,", file + "\", \"x\": \"",
              "t.gltf: /buffers/0/uri: \"" + file +
                  "\" is not a buffer that may be opened; expected a .bin file in the same folder or below "
                  "it, or a data URI");
    check("data:application/octet-stream;base64,", "there/is/none.bin\", \"x\": \"",
          "t.gltf: /buffers/0/uri: \"there/is/none.bin\": cannot read: no such file or directory; "
          "expected a readable regular file");
    check("\"mesh\": 0", "\"mesh\": 1",
          "t.gltf: /nodes/0/mesh: element 1 of \"meshes\" does not exist; expected 0 to 0");
    check("\"mesh\": 0", "\"mesh\": 0, \"children\": [0]",
          "t.gltf: /nodes/0: the node is its own descendant, or has two parents; expected a tree of nodes");
    check("\"nodes\": [0]", "\"nodes\": [7]", "t.gltf: the scene refers to node 7; expected one of 1 nodes");
    check("\"nodes\": [0]", "\"nodes\": [-1]",
          "t.gltf: /scenes/0/nodes/0: it is not the index of a node; expected a whole number");
    check("\"POSITION\": 0", "\"NORMAL\": 0",
          "t.gltf: /meshes/0/primitives/0/attributes: the key \"POSITION\" is missing; expected a whole "
          "number from 0 "
          "to 4294967295");
    check("{\"POSITION\": 0}", "{\"POSITION\": 0}, \"indices\": 0",
          "t.gltf: /accessors/0: its type is \"VEC3\"; expected \"SCALAR\"");
    check("5126", "5130",
          "t.gltf: /accessors/0: its componentType is 5130; expected 5120, 5121, 5122, 5123, 5125 or 5126");
    check("AAAAAAAAAAAAAAAAAACAPw", "AADAfwAAAAAAAAAAAACAPw",
          "t.gltf: /meshes/0/primitives/0/attributes/POSITION: a coordinate of vertex 0 is nan; expected a "
          "number between -1e7 and 1e7");
    check("\"2.0\"}", "\"1.0\"}", "t.gltf: /asset: its version is \"1.0\"; expected 2.0");
    check("\"2.0\"}", "\"2.0\"}, \"extensionsRequired\": [\"KHR_draco_mesh_compression\"]",
          "t.gltf: /extensionsRequired/0: \"KHR_draco_mesh_compression\" is required but not supported; "
          "expected "
          "a file without that extension");
    check("\"nodes\": [{\"mesh\": 0}]", "\"nodes\": [{}]",
          "t.gltf: its scene has no mesh; expected at least one triangle");
    CHECK(error_of("{}") ==
          "t.gltf: the key \"asset\" is missing; expected {\"asset\": {\"version\": \"2.0\"}}");
    CHECK(error_of(std::string(100'000, '[')).starts_with("t.gltf:1: "));
}

TEST_CASE("a .glb whose header and file differ in length is read with a warning", "[gltf]") {
    std::string whole = triangle_glb();
    const std::size_t size = whole.size();
    const auto with_length = [&](std::size_t length) {
        for (std::size_t i = 0; i < 4; ++i) whole[8 + i] = static_cast<char>(length >> (8 * i) & 0xFF);
        const TemporaryDirectory folder;
        return std::get<SceneDocument>(open_document(folder.file("t.glb", whole))).warnings;
    };
    CHECK(with_length(size).empty());
    for (const std::size_t length : {std::size_t{0}, std::size_t{5}, size - 4, size + 4})
        CHECK(with_length(length) ==
              Warnings{fmt::format("the length in the header, {} bytes, is ignored: the file has {}", length,
                                   size)});
    whole += std::string(4, '\0');
    CHECK(with_length(size).size() == 1);
    whole += std::string(400, '\7');
    CHECK(with_length(size).size() == 1);
}
