// PLY, OFF and STL: their contents, and the one-line message for each malformed file.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <limits>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"

using namespace glint;
using test::check_all;
using test::error_of;
using test::read_text;

namespace {

const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply_vertices = "0 0 0\n1 0 0\n0 1 0\n";

}  // namespace

TEST_CASE("a PLY's properties may have any order, type and byte order", "[mesh_file][ply]") {
    const std::string text =
        "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement vertex 4\nproperty uchar red\nproperty uchar "
        "green\n"
        "property uchar blue\nproperty double x\nproperty float z\nproperty short y\nproperty list uchar int "
        "skipped\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement extra 1\nproperty list uint double "
        "values\n"
        "element face 1\nproperty uchar flag\nproperty list ushort uint vertex_index\nend_header\n"
        "255 0 51 0 .5 0 1 7 0 0 2\n255 0 51 1 .5 0 0 0 0 2\n\n255 0 51 1 .5 1 2 7 7 0 0 2\n255 0 51 0 .5 1 "
        "0 0 0 2\n"
        "2 1 nan\n9 4 0 1 2 3\n";
    for (const std::string& bytes : {text, test::binary_ply(false), test::binary_ply(true)}) {
        const Mesh mesh = read_text("m.ply", bytes);
        CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, .5f}, {1, 0, .5f}, {1, 1, .5f}, {0, 1, .5f}});
        CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2, 3});
        CHECK(mesh.given_normals == GivenNormals::File);
        CHECK(mesh.normals == std::vector<glm::vec3>(4, {0, 0, 2}));
        CHECK(corner_normals(mesh, {}).normals == std::vector<glm::vec3>(4, {0, 0, 1}));
        REQUIRE(mesh.colors.size() == 4);
        CHECK(mesh.colors[3].r == 1.f);
        CHECK(mesh.colors[3].b == Approx(0.2));
        CHECK(mesh.warnings == Warnings{"1 row of the element \"extra\" is not read"});
    }
}

TEST_CASE("the body of a binary PLY starts after its header, with any kind of line ending",
          "[mesh_file][ply]") {
    const std::string lines[] = {"ply",
                                 "format binary_little_endian 1.0",
                                 "element vertex 3",
                                 "property uchar first",
                                 "property float x",
                                 "property float y",
                                 "property float z",
                                 "element face 1",
                                 "property list uchar int vertex_indices",
                                 "end_header"};
    for (const std::string end : {"\n", "\r", "\r\n", "\n\r"})
        for (const char first : {'\0', '\n', '\r'}) {  // bytes that could end a line
            CAPTURE(end, int{first});
            test::Bytes bytes([&] {
                std::string head;
                for (const std::string& line : lines) head += line + end;
                return head;
            }());
            bytes.add<char>({first}).f32({0, 0, 0}).u8({0}).f32({1, 0, 0}).u8({0}).f32({0, 1, 0});
            const Mesh mesh = read_text("m.ply", bytes.u8({3}).u32({0, 1, 2}).str());
            CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
            CHECK(mesh.triangles.size() == 1);
        }
}

TEST_CASE("ignored contents of a PLY give a warning", "[mesh_file][ply]") {
    const Mesh mesh = read_text(
        "m.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property int red\nproperty int green\nproperty int blue\nelement face 1\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n1 2 3 3 0 1 2\nmore\n");
    CHECK(mesh.colors.empty());
    CHECK(mesh.warnings == Warnings{"3 vertices have colours of a signed or 32-bit type, which are ignored",
                                    "1 face has a colour, which is ignored",
                                    "data after the last element is ignored"});
}

TEST_CASE("incomplete normals and colours, or ones that are not numbers, give a warning", "[mesh_file]") {
    const Mesh ply = read_text(
        "m.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty uchar red\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n");
    CHECK(ply.warnings == Warnings{"3 vertices have only part of a normal, which is ignored",
                                   "3 vertices have only part of a colour, which is ignored"});
    std::string stl = test::binary_stl();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(stl.data() + 84, &nan, sizeof nan);
    CHECK(read_text("m.stl", stl).warnings == Warnings{"1 normal is not finite and is treated as missing"});
}

TEST_CASE("a colour outside the range of its type is clamped with a warning", "[mesh_file]") {
    const auto ply = [](const std::string& type, const std::string& color) {
        std::string text = ply_head;
        text.insert(text.find("element face"),
                    "property " + type + " red\nproperty " + type + " green\nproperty " + type + " blue\n");
        return read_text("c.ply", text + "0 0 0 " + color + "\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
    };
    const Mesh bytes = ply("uchar", "300 51 -5"), floats = ply("float", "-1 2 0.5");
    CHECK(bytes.colors[0].r == 1);
    CHECK(bytes.colors[0].g == Approx(0.2));
    CHECK(bytes.colors[0].b == 0);
    CHECK(bytes.warnings == Warnings{"1 vertex has a colour beyond the range of its type, which is clamped",
                                     "1 vertex has a colour with a channel below 0, which is treated as 0"});
    CHECK(floats.colors[0] == glm::vec3(0, 2, 0.5f));  // a float may be brighter than white
    CHECK(floats.warnings == Warnings{"1 vertex has a colour with a channel below 0, which is treated as 0"});
    const Mesh obj = read_text("c.obj", "v 0 0 0 -1 0 0\nv 1 0 0 0 -2 3\nv 0 1 0 1 1 1\nf 1 2 3\n");
    CHECK(obj.colors == std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 3}, {1, 1, 1}});
    CHECK(obj.warnings == Warnings{"2 vertices have colours with a channel below 0, which is treated as 0"});
}

TEST_CASE("a malformed PLY is reported with the expected input", "[mesh_file][ply]") {
    const std::string head = "ply\nformat ascii 1.0\n";
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    check_all({
        {"m.ply", "solid", ":1: this is not a PLY file; expected \"ply\" as its first word"},
        {"m.ply", "ply\n", ":2: the header does not end; expected \"end_header\""},
        {"m.ply", "ply\nformat ascii 2.0\nend_header\n",
         ":2: \"2.0\" is not a known PLY version; expected 1.0"},
        {"m.ply", "ply\nend_header\n",
         ":2: the header names no format; expected a line such as \"format ascii 1.0\""},
        {"m.ply", "ply\nformat text 1.0\n",
         ":2: \"text\" is not a PLY format; expected ascii, binary_little_endian or "
         "binary_big_endian"},
        {"m.ply", head + "elements vertex 3\n",
         ":3: \"elements\" is not a PLY header keyword; expected format, element, property, comment, "
         "obj_info or "
         "end_header"},
        {"m.ply", head + "property float x\n",
         ":3: a property belongs to no element; expected \"element\" before it"},
        {"m.ply", head + "element vertex -1\n",
         ":3: a count of -1 is out of range; expected 0 to 2147483647"},
        {"m.ply", head + "element vertex 99999999999\n",
         ":3: a count of 99999999999 is out of range; expected 0 to 2147483647"},
        {"m.ply", head + "element vertex many\n",
         ":3: \"many\" is not a whole number; expected a whole number"},
        {"m.ply", head + "element vertex 3\nproperty real x\n",
         ":4: \"real\" is not a type; expected char, uchar, short, ushort, int, uint, float or double"},
        {"m.ply", head + "element vertex 3\nproperty float x\nproperty float x\n",
         ":5: duplicate property \"x\"; expected one"},
        {"m.ply", head + "element vertex 3\nproperty float x\nend_header\n",
         ":3: the vertices lack a coordinate; expected properties x, y and z"},
        {"m.ply", head + "element vertex 3\n" + xyz + "element face 1\nend_header\n",
         ":7: the element \"face\" has no corners; expected a property list vertex_indices"},
        {"m.ply", head + "element face 1\nproperty list float int vertex_indices\n",
         ":4: a list's count is not a whole number; expected an integer type"},
        {"m.ply", head + "element face 1\nproperty list uchar float vertex_indices\n",
         ":4: \"vertex_indices\" is not a list of whole numbers; expected a list of an integer type"},
        {"m.ply", ply_head + "0 0 0\n1 0\n", ":11: z is missing; expected a number"},
        {"m.ply", ply_head + "0 0 0\n1 0 0 0\n",
         ":11: \"0\" is one too many; expected the header's properties only"},
        {"m.ply", ply_head + "0 0 0\n1 0 x\n", ":11: \"x\" is not a number; expected a number"},
        {"m.ply", ply_head + "0 0 0\n1 0 2e7\n", ":11: \"2e7\" is out of range; expected -1e7 to 1e7"},
        {"m.ply", ply_head + "0 0 0\n1 0 0\n",
         ":12: the file ends after 2 of element \"vertex\"; expected 3"},
        {"m.ply", ply_head + ply_vertices, ":13: the file ends after 0 of element \"face\"; expected 1"},
        {"m.ply", ply_head + ply_vertices + "3 0 1 3\n",
         ":13: vertex index 3 is out of range; expected 0 to 2"},
        {"m.ply", ply_head + ply_vertices + "3 0 1 -1\n",
         ":13: vertex index -1 is out of range; expected 0 to 2"},
        {"m.ply", ply_head + ply_vertices + "3 0 1\n",
         ":13: vertex_indices is missing; expected a whole number"},
        {"m.ply", ply_head + ply_vertices + "-3 0 1 2\n",
         ":13: vertex_indices has -3 entries; expected 0 or more"},
        {"m.ply", ply_head + ply_vertices + "3 0 1 1.5\n",
         ":13: \"1.5\" is not a whole number; expected a whole number"},
    });
    const std::string binary = test::binary_ply(false);
    CHECK(error_of("m.ply", binary.substr(0, binary.size() - 1)) ==
          "m.ply: face 0: the file ends early; expected 1 of them");
    CHECK(error_of("m.ply", binary.substr(0, binary.size() - 60)) ==
          "m.ply: vertex 3: the file ends early; expected 4 of them");
    std::string wrong = binary;
    wrong[binary.size() - 4] = 4;
    CHECK(error_of("m.ply", wrong) == "m.ply: face 0: vertex index 4 is out of range; expected 0 to 3");
    wrong = binary;
    wrong.replace(wrong.find("end_header\n") + 14, 8, "\0\0\0\0\0\0\xF8\x7F", 8);
    CHECK(error_of("m.ply", wrong) == "m.ply: vertex 0: x = nan is out of range; expected -1e7 to 1e7");
}

TEST_CASE("an OFF may have comments, and its counts on the first or the next line", "[mesh_file][off]") {
    for (const std::string head :
         {"OFF\n# made by hand\n4 2 0\n", "OFF 4 2 0 # counts\n", "  OFF\n\n4 2\n"}) {
        const Mesh mesh =
            read_text("m.off", head + "0 0 0\n1 0 0 # second\n\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3 1 0 0\n");
        CHECK(mesh.positions.size() == 4);
        CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
        CHECK(mesh.colors.empty());
        CHECK(mesh.warnings == Warnings{"1 face has a colour, which is ignored"});
    }
}

TEST_CASE("text after an OFF's last face is ignored with a warning, unless it is blank", "[mesh_file][off]") {
    const std::string file = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    CHECK(read_text("m.off", file + "\n# the end\n").warnings.empty());
    const Mesh mesh = read_text("m.off", file + "3 0 1 2\n");
    CHECK(mesh.warnings == Warnings{"data after the last face is ignored"});
    CHECK(mesh.corner_position.size() == 3);
}

TEST_CASE("an OFF's vertex colours are fractions or integers up to 255, and follow normals",
          "[mesh_file][off]") {
    const std::string faces = "3 0 1 2\n";
    const Mesh whole =
        read_text("m.off", "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 0 0\n0 1 0 1 1 1 0\n" + faces);
    CHECK(whole.colors[0].r == 1.f);
    CHECK(whole.colors[0].b == Approx(0.2));
    CHECK(whole.colors[2].r == Approx(1 / 255.0));
    const Mesh shares = read_text("m.off", "COFF\n3 1 0\n0 0 0 1 0 1\n1 0 0 0 0 0\n0 1 0 1 1 1\n" + faces);
    CHECK(shares.colors[0] == glm::vec3(1, 0, 1));
    const Mesh both = read_text(
        "m.off", "CNOFF\n3 1 0\n0 0 0 0 0 5 0.5 2 0\n1 0 0 0 0 5 0 0 0\n0 1 0 0 0 5 1 1 1\n" + faces);
    CHECK(both.colors[0] == glm::vec3(0.5f, 2, 0));
    CHECK(both.normals[0] == glm::vec3(0, 0, 5));
    CHECK(both.given_normals == GivenNormals::File);
    CHECK(read_text("m.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n" + faces).colors.empty());
}

TEST_CASE("a malformed OFF is reported with its line and the expected input", "[mesh_file][off]") {
    const std::string v = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    check_all({
        {"m.off", "# only a comment\n", ":2: this is not an OFF file; expected OFF, COFF, NOFF or CNOFF"},
        {"m.off", "4 2 0\n", ":2: the file ends after 0 vertices; expected 4"},
        {"m.off", "4OFF\n",
         ":1: \"4OFF\" is not a supported kind of OFF file; expected OFF, COFF, NOFF or CNOFF"},
        {"m.off", "OFF BINARY\n\1\2\3", ":1: binary OFF is not supported; expected an ASCII file"},
        {"m.off", "OFF\n", ":2: the file ends early; expected the counts of vertices and faces"},
        {"m.off", "OFF\n3\n", ":2: the face count is missing; expected a whole number"},
        {"m.off", "OFF\n-3 1 0\n", ":2: the vertex count is -3; expected 0 to 2147483647"},
        {"m.off", "OFF\n3 5000000000 0\n", ":2: the face count is 5000000000; expected 0 to 2147483647"},
        {"m.off", "OFF\n3 1 0 0\n",
         ":2: \"0\" is one too many; expected the counts of vertices, faces and edges"},
        {"m.off", "OFF\n2000000000 1 0\n0 0 0\n", ":4: the file ends after 1 vertices; expected 2000000000"},
        {"m.off", "OFF\n3 1 0\n0 0\n", ":3: z is missing; expected a number"},
        {"m.off", "OFF\n3 1 0\n0 0 0 255 0\n", ":3: blue is missing; expected a number"},
        {"m.off", "OFF\n3 1 0\n0 0 0 255 0 0 255 7\n",
         ":3: \"7\" is one too many; expected x y z, a normal for NOFF, then a colour or nothing"},
        {"m.off", "COFF\n3 1 0\n0 0 0 1 1\n", ":3: blue is missing; expected a number"},
        {"m.off", v, ":6: the file ends after 0 faces; expected 1"},
        {"m.off", v + "3 0 1 3\n", ":6: vertex index 3 is out of range; expected 0 to 2"},
        {"m.off", v + "3 0 1\n", ":6: a vertex index is missing; expected a whole number"},
        {"m.off", v + "-1\n", ":6: a face has -1 corners; expected 0 or more"},
        {"m.off", "OFF\n0 0 0\n", ": the mesh has no faces; expected at least one"},
    });
}

TEST_CASE("an STL merges equal positions, and its facet normals are the file's normals", "[mesh_file][stl]") {
    const std::string ascii =
        "solid a square # of two facets\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex "
        "1 1 0\n"
        "endloop\nendfacet\n  FACET NORMAL 0 0 1\n OUTER LOOP\nvertex 0 -0 0\nvertex 1 1 0\nvertex -0 1 "
        "0\nENDLOOP\n"
        "ENDFACET\nendsolid a square\n";
    std::string named_solid = test::binary_stl();
    named_solid.replace(0, 5, "solid");
    std::string two_lines = ascii;  // only the solid's name must end with its line
    std::replace(two_lines.begin() + static_cast<std::ptrdiff_t>(two_lines.find('\n')) + 1, two_lines.end(),
                 '\n', ' ');
    for (const std::string& bytes : {ascii, two_lines, test::binary_stl(), named_solid}) {
        const Mesh mesh = read_text("m.stl", bytes);
        CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
        CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
        CHECK(mesh.given_normals == GivenNormals::File);
        CHECK(mesh.normals.size() == 2);
        CHECK(mesh.corner_normal == std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1});
        CHECK(mesh.warnings.empty());
    }
    for (const std::string& bytes : {test::binary_stl(), named_solid})
        CHECK(read_text("m.stl", bytes + "xx").warnings == Warnings{"data after the last facet is ignored"});
    std::string zero = ascii;
    for (std::size_t at = 0; (at = zero.find("0 0 1\n", at)) != std::string::npos;) zero[at + 4] = '0';
    CHECK(read_text("m.stl", zero).given_normals == GivenNormals::None);
}

TEST_CASE("a malformed STL is reported with the expected input", "[mesh_file][stl]") {
    const std::string head = "solid s\nfacet normal 0 0 1\nouter loop\n";
    std::string cut_solid = test::binary_stl(3);
    cut_solid.replace(0, 5, "solid");
    check_all({
        {"m.stl", cut_solid,
         ": this is not an STL file, or it ends early; expected 234 bytes for its 3 facets"},
        {"m.stl", "hello",
         ": this is not an STL file, or it ends early; expected \"solid\", or a binary file of 84 + 50 "
         "n "
         "bytes"},
        {"m.stl", test::binary_stl(3),
         ": this is not an STL file, or it ends early; expected 234 bytes for its 3 facets"},
        {"m.stl", test::binary_stl(4294967295u),
         ": this is not an STL file, or it ends early; expected 214748364834 bytes for its 4294967295 "
         "facets"},
        {"m.stl", test::binary_stl(2, 2e7f), ": facet 0: a coordinate is 20000000; expected -1e7 to 1e7"},
        {"m.stl", test::binary_stl(2, std::numeric_limits<float>::quiet_NaN()),
         ": facet 0: a coordinate is nan; expected -1e7 to 1e7"},
        {"m.stl", "solid s\nendsolid s\n", ": the mesh has no faces; expected at least one"},
        {"m.stl", "solid s\nfacet normal 0 0\n", ":2: z is missing; expected a number"},
        {"m.stl", "solid s\nfacets\n", ":2: \"facets\" is out of place; expected \"facet\" or \"endsolid\""},
        {"m.stl", head + "vertex 0 0 0\nvertex 1 0 0\nendloop\n",
         ":6: \"endloop\" is out of place; expected \"vertex\""},
        {"m.stl", head + "vertex 0 0 0 0\n", ":4: \"0\" is one too many; expected 3 numbers"},
        {"m.stl", head + "vertex 0 0 zero\n", ":4: \"zero\" is not a number; expected a number"},
        {"m.stl", head + "vertex 0 0 0\n", ":5: the file ends early; expected \"vertex\""},
        {"m.stl", "solid s\nfacet normal 0 0 1\nouter\n", ":4: the file ends early; expected \"loop\""},
        {"m.stl", "solid s\nendsolid s\nsolids\n",
         ":3: this is not an STL file; expected \"solid\", or a binary file of 84 + 50 n bytes"},
    });
}
