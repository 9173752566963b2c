// Files that break a rule of the glTF 2.0 specification, or contain nothing to draw or no usable view.
#include <fmt/format.h>

#include "tests/support/catch.h"
#include "tests/support/gltf_triangle.h"

using namespace glint;
using namespace glint::gltf_triangle;

TEST_CASE("a violation of the glTF specification is reported in one line with its place", "[gltf]") {
    const auto check = [](const std::string& from, const std::string& to, const std::string& line) {
        CHECK(error_of(changed(from, to)) == line);
    };
    const std::string node = "\"nodes\": [{\"mesh\": 0}]";
    const auto check_node = [&](const std::string& more, const std::string& line) {
        check(node, "\"nodes\": [{\"mesh\": 0, " + more + "}]", "t.gltf: /nodes/0" + line);
    };
    const std::string lamp = "\"extensions\": {\"KHR_lights_punctual\": {\"light\": 1}}";
    const std::string at_lamp =
        "/extensions/KHR_lights_punctual/light: element 1 of \"lights\" does not exist; expected ";
    check_node(lamp, at_lamp + "no number: the list is empty");
    check(node,
          "\"nodes\": [{\"mesh\": 0, " + lamp +
              "}], \"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{\"type\": \"point\"}]}}",
          "t.gltf: /nodes/0" + at_lamp + "0 to 0");
    check("\"2.0\"}", "\"2.0\", \"minVersion\": \"3.0\"}",
          "t.gltf: /asset/minVersion: reading it requires version \"3.0\"; expected 2.0");
    check("\"2.0\"}", "\"2.0\", \"minVersion\": \"20\"}",
          "t.gltf: /asset/minVersion: reading it requires version \"20\"; expected 2.0");
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
        "t.gltf: /accessors/0: its elements have 12 bytes and are 8 bytes apart; expected a byteStride of at "
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

    const auto with_camera = [&](const std::string& camera) {
        return error_of(
            changed(node, "\"nodes\": [{\"mesh\": 0, \"camera\": 0}], \"cameras\": [" + camera + "]"));
    };
    CHECK(with_camera(R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}})").empty());
    CHECK(with_camera(R"({"type": "orthographic", "orthographic": {"ymag": 1, "zfar": 9, "znear": 1}})")
              .empty());
    CHECK(with_camera(R"({"type": "ortographic", "orthographic": {"ymag": 1, "zfar": 9, "znear": 1}})") ==
          "t.gltf: /cameras/0: its type is \"ortographic\"; expected \"perspective\" or \"orthographic\"");
    CHECK(with_camera("{}") ==
          "t.gltf: /cameras/0: its type is \"\"; expected \"perspective\" or \"orthographic\"");
    CHECK(with_camera(R"({"type": "perspective"})") ==
          "t.gltf: /cameras/0: the key \"perspective\" is missing; expected the numbers of its lens");

    const auto with_alpha = [](const std::string& mode) {
        return error_of(changed(
            "{\"POSITION\": 0}}]}],",
            "{\"POSITION\": 0}, \"material\": 0}]}], \"materials\": [{\"alphaMode\": \"" + mode + "\"}],"));
    };
    for (const char* mode : {"OPAQUE", "MASK", "BLEND"}) CHECK(with_alpha(mode).empty());
    CHECK(with_alpha("opaque") ==
          "t.gltf: /materials/0/alphaMode: \"opaque\" is not known; expected \"OPAQUE\", \"MASK\" or "
          "\"BLEND\"");
}

TEST_CASE("glTF nodes outside the scene are checked too", "[gltf]") {
    const auto check = [](const std::string& node, const std::string& line) {
        CHECK(error_of(changed("[{\"mesh\": 0}]", "[{\"mesh\": 0}, " + node + "]")) ==
              "t.gltf: /nodes/1" + line);
    };
    check("{\"mesh\": 77}", "/mesh: element 77 of \"meshes\" does not exist; expected 0 to 0");
    check("{\"camera\": 3}",
          "/camera: element 3 of \"cameras\" does not exist; expected no number: the list is empty");
    check("{\"children\": [1, 5]}", "/children/1: node 5 does not exist; expected 0 to 1");
    check("{\"rotation\": [0, 0, 0, 0]}",
          "/rotation: the quaternion is zero; expected a quaternion of length 1");
}

TEST_CASE("a glTF file with nothing to draw is refused with the reason", "[gltf]") {
    const auto check = [](const std::string& node, const std::string& what) {
        CHECK(error_of(changed("{\"mesh\": 0}", "{\"mesh\": 0, " + node + "}")) ==
              "t.gltf: nothing in its scene can be drawn: " + what + "; expected at least one triangle");
    };
    check("\"scale\": [1, 0, 1]", "1 object has a scale of 0, which makes it flat, and is left out");
    check("\"matrix\": [1e7, 1e7, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]",
          "1 object is larger or farther away than 1e7, and is left out");
    CHECK(
        error_of(changed("{\"POSITION\": 0}", "{\"POSITION\": 0}, \"mode\": 0")) ==
        "t.gltf: nothing in its scene can be drawn: 1 primitive of points or lines is left out; expected at "
        "least one triangle");
}

TEST_CASE("a light whose node gives it no direction is refused, unless it needs none", "[gltf]") {
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
              "t.gltf: /extensions/KHR_lights_punctual/lights/0: its node's scale leaves it without a "
              "direction; "
              "expected a node whose axes have non-zero lengths");
}

TEST_CASE("a light's range is left out and invalid cones are clamped, each with a warning", "[gltf]") {
    const auto text_with = [](const std::string& light) {
        return changed("\"nodes\": [{\"mesh\": 0}], \"scenes\": [{\"nodes\": [0]}]",
                       "\"extensions\": {\"KHR_lights_punctual\": {\"lights\": [{" + light +
                           "}]}}, \"nodes\": [{\"mesh\": 0}, {\"extensions\": {\"KHR_lights_punctual\": "
                           "{\"light\": 0}}}], \"scenes\": [{\"nodes\": [0, 1]}]");
    };
    const TemporaryDirectory folder;
    const auto warnings = [&](const std::string& light) {
        return std::get<SceneDocument>(open_document(folder.file("t.gltf", text_with(light)))).warnings;
    };
    const std::string range = "1 light has a range, but also shines beyond it here";
    CHECK(warnings("\"type\": \"point\", \"range\": 3") == Warnings{range});
    CHECK(warnings("\"type\": \"spot\", \"range\": 3") == Warnings{range});
    CHECK(warnings("\"type\": \"directional\", \"range\": 3").empty());
    CHECK(warnings("\"type\": \"point\"").empty());
    const auto cone = [](double inner, double outer) {
        return fmt::format("\"type\": \"spot\", \"spot\": {{\"innerConeAngle\": {}, \"outerConeAngle\": {}}}",
                           inner, outer);
    };
    CHECK(warnings(cone(0.4, 0.5)).empty());
    CHECK(warnings(cone(0.5, 0.5)).empty());
    const Warnings clamped{
        "1 spot has an inner angle above its outer one or an outer one above 90°, which is clamped"};
    CHECK(warnings(cone(0.6, 0.5)) == clamped);
    CHECK(warnings(cone(0.6, 2)) == clamped);
    CHECK(warnings("\"type\": \"spot\", \"spot\": {\"innerConeAngle\": 0.9}") ==
          clamped);  // above the default outer angle
}

TEST_CASE("a camera whose node gives it no direction is refused in one line", "[gltf]") {
    const std::string camera =
        "\"cameras\": [{\"type\": \"perspective\", \"perspective\": {\"yfov\": 1, \"znear\": 1}}], ";
    const auto check = [&](const std::string& node, const std::string& what) {
        CHECK(error_of(changed("\"nodes\": [{\"mesh\": 0}]",
                               camera + "\"nodes\": [{\"mesh\": 0, \"camera\": 0, " + node + "}]")) ==
              "t.gltf: /nodes/0: no camera can be placed there: " + what +
                  "; expected axes of non-zero length, at a position within 1e7");
    };
    check("\"scale\": [1, 1, 0]", "eye and target are the same point");
    check("\"scale\": [1, 0, 1]", "up is zero");
}
