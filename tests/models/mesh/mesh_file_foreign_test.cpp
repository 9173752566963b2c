// Mesh files as other programs write them: each test uses the smallest file of a kind that was once refused
// or misread.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstring>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"

using namespace glint;
using test::error_of;
using test::read_text;

namespace {

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string triangle_off = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string ply_xyz = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string ply_square = "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";

std::string with_line_ends(std::string text, const std::string& end) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size())
        text.replace(at, 1, end);
    return text;
}

}  // namespace

TEST_CASE("lines of a mesh file may end in CR, LF, CR LF or LF CR", "[mesh_file]") {
    const std::vector<std::pair<std::string, std::string>> files{
        {"m.obj", "# made by hand\n" + triangle_obj + "f 1 2 \\\n 3\nx"},
        {"m.off", "OFF\n# made by hand\n3 1 0\n" + triangle_off + "more"},
        {"m.ply", "ply\nformat ascii 1.0\n" + ply_xyz +
                      "element face 1\nproperty list uchar int vertex_indices\n" + ply_square +
                      "3 0 1 2\nmore"},
        {"m.stl",
         "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
         "endloop\nendfacet\nendsolid s\n"}};
    for (const auto& [name, text] : files)
        for (const std::string end : {"\n", "\r", "\r\n", "\n\r"}) {
            CAPTURE(name, end.size(), int{end[0]});
            if (name == "m.obj") {
                CHECK(error_of(name, with_line_ends(text, end)).starts_with("m.obj:7: "));
                continue;
            }
            const Mesh mesh = read_text(name, with_line_ends(text, end));
            CHECK(mesh.triangles.size() == 1);
            CHECK(mesh.warnings.size() == (name == "m.stl" ? 0 : 1));
        }
}

TEST_CASE("a corner of an OBJ may leave out any index after its slashes", "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj", triangle_obj + "f 1// 2/1/ 3/\n");
    CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(mesh.warnings == Warnings{"3 corners end in a slash, which is ignored"});
}

TEST_CASE("an OBJ's vertex may have a colour with alpha", "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj", "v 0 0 0 1 0.5 0 1\nv 1 0 0 1 1 1 1\nv 0 1 0\nf 1 2 3\n");
    CHECK(mesh.colors == std::vector<glm::vec3>{{1, 0.5f, 0}, {1, 1, 1}, {1, 1, 1}});
}

TEST_CASE("rare statements of an OBJ are named in one warning", "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj", triangle_obj +
                                             "vw 1 0.5\nt crease 1/1/0 1 2 4\ncall a.obj\ncsh -ls\n"
                                             "bzp 1 2 3\nbzp 3 2 1\ncstype bezier\nfo 1 2 3\n");
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.warnings == Warnings{"7 statements are ignored (vw, t, call, csh, bzp, cstype)"});
    CHECK(error_of("m.obj", triangle_obj + "facet 1 2 3\n")
              .starts_with("m.obj:4: \"facet\" is not an OBJ statement"));
}

TEST_CASE("materials of an OBJ are ignored with one warning", "[mesh_file][obj]") {
    CHECK(read_text("m.obj", "mtllib a.mtl\n" + triangle_obj + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 2\n")
              .warnings == Warnings{"2 materials of .mtl files are not read"});
    CHECK(read_text("m.obj", "mtllib a.mtl\n" + triangle_obj + "f 1 2 3\n").warnings.empty());
}

TEST_CASE("a normal that is not finite is treated as missing, in every format", "[mesh_file]") {
    for (const std::string nan : {"nan", "NaN", "-nan", "-nan(ind)", "1.#IND", "-1.#QNAN", "inf", "1e39"}) {
        CAPTURE(nan);
        const Mesh obj =
            read_text("m.obj", fmt::format("{}vn 0 0 1\nvn 0 {} 1\nf 1//1 2//2 3//1\n", triangle_obj, nan));
        const Mesh off =
            read_text("m.off", "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 " + nan + " 1\n0 1 0 0 0 1\n3 0 1 2\n");
        const Mesh ply = read_text(
            "m.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float ny\nproperty "
            "float nz\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n0 0 1 0 0 0\n" +
                nan + " 0 1 1 0 0\n0 0 1 0 1 0\n3 0 1 2\n");
        for (const Mesh* mesh : {&obj, &off, &ply}) {
            CHECK(mesh->warnings == Warnings{"1 normal is not finite and is treated as missing"});
            CHECK(corner_normals(*mesh, {}).warnings ==
                  Warnings{"1 corner has no normal; its vertex normal is used"});
        }
        const Mesh stl = read_text("m.stl", "solid s\nfacet normal " + nan +
                                                " 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                                "endloop\nendfacet\nendsolid s\n");
        CHECK(stl.warnings == Warnings{"1 normal is not finite and is treated as missing"});
        CHECK(stl.given_normals == GivenNormals::None);
        // There is no such rule for positions.
        CHECK(error_of("m.obj", "v 0 " + nan + " 0\n").starts_with("m.obj:1: "));
    }
    std::string binary = test::binary_ply(false);
    const std::uint32_t bits = 0x7FC00000u;
    std::memcpy(&binary[binary.find("end_header\n") + 11 + 22], &bits, 4);  // nx of vertex 0
    CHECK(read_text("m.ply", binary).normals[0] == glm::vec3(0));
}

TEST_CASE("an OFF may lack its keyword or have its counts next to it", "[mesh_file][off]") {
    for (const std::string head : {"OFF3 1 0\n", "3 1 0\n", "OFF 3 1\n"})
        CHECK(read_text("m.off", head + triangle_off).triangles.size() == 1);
    CHECK(read_text("m.off", "COFF3 1 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n0 1 0 1 0 0\n3 0 1 2\n").colors.size() ==
          3);
}

TEST_CASE("an OFF's vertices may have colours that its keyword does not announce", "[mesh_file][off]") {
    const Mesh mesh = read_text("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0 255 0 51 255\n0 1 0 0 0 255\n3 0 1 2\n");
    REQUIRE(mesh.colors.size() == 3);
    CHECK(mesh.colors[0] == glm::vec3(1));
    CHECK(mesh.colors[1].b == Approx(0.2));
}

TEST_CASE("triangle strips of a PLY become triangles with alternating winding", "[mesh_file][ply]") {
    const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
    const Mesh mesh = read_text(
        "m.ply", "ply\nformat ascii 1.0\n" + ply_xyz + strips + ply_square + "8 0 1 2 3 -1 2 1 3\n");
    CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 2, 1, 3});
    CHECK(mesh.first_corner == std::vector<std::uint32_t>{0, 3, 6, 9});
    CHECK(mesh.warnings.empty());
    const Mesh both = read_text("m.ply", "ply\nformat ascii 1.0\n" + ply_xyz +
                                             "element face 1\nproperty list uchar int vertex_indices\n" +
                                             strips + ply_square + "3 0 1 2\n4 2 1 3 -1\n");
    CHECK(both.triangles.size() == 2);
    CHECK(error_of("m.ply", "ply\nformat ascii 1.0\n" + ply_xyz + strips + ply_square + "3 0 1 4\n")
              .ends_with("vertex index 4 is out of range; expected 0 to 3"));
}

TEST_CASE("an element of a PLY that is not read is named", "[mesh_file][ply]") {
    const Mesh mesh = read_text("m.ply", "ply\nformat ascii 1.0\n" + ply_xyz +
                                             "element edge 2\nproperty int vertex1\nelement camera 0\n"
                                             "property int view\nelement face 1\nproperty list uchar int "
                                             "vertex_indices\n" +
                                             ply_square + "1\n2\n3 0 1 2\n");
    CHECK(mesh.warnings == Warnings{"2 rows of the element \"edge\" are not read"});
}

TEST_CASE("smoothing groups of an OBJ limit the averaging of normals", "[mesh_file][obj][normals]") {
    const std::string roof = "v 0 0 0\nv 1 0 -1\nv 0 1 0\nv -1 0 -1\n";
    const auto normals = [&](const std::string& first, const std::string& second, float crease = 180) {
        const Mesh mesh = read_text("m.obj", roof + first + "f 1 2 3\n" + second + "f 1 3 4\n");
        const CornerNormals n = corner_normals(mesh, {NormalSource::Auto, NormalWeighting::Angle, crease});
        const auto& index = n.corner.empty() ? mesh.corner_position : n.corner;
        return std::array{n.normals[index[0]], n.normals[index[3]]};  // the first vertex, in either face
    };
    for (const float crease : {180.f, 170.f}) {
        CAPTURE(crease);
        for (const std::string same : {"", "s 1\n", "s 7\n"}) {
            const auto [a, b] = normals(same, same, crease);
            CHECK(a == b);
            CHECK(a.x == Approx(0).margin(1e-6));
        }
        for (const auto& [first, second] : {std::pair{"s 1\n", "s 2\n"},
                                            {"s off\n", ""},
                                            {"s 0\n", ""},
                                            {"s 1\n", "s off\n"},
                                            {"", "s 3\n"}}) {
            CAPTURE(first, second);
            const auto [a, b] = normals(first, second, crease);
            CHECK(a.x == Approx(0.7071).margin(1e-3));
            CHECK(b.x == Approx(-0.7071).margin(1e-3));
        }
    }
    CHECK(error_of("m.obj", "s smooth\n").starts_with("m.obj:1: \"smooth\" is not a smoothing group"));
}

TEST_CASE("normals are averaged over all vertices at a position, in every format", "[mesh_file][normals]") {
    const std::string off = "OFF 6 2 0\n0 0 0\n1 0 -1\n0 1 0\n0 0 0\n0 1 0\n-1 0 -1\n3 0 1 2\n3 3 4 5\n";
    std::string obj = "v 0 0 0\nv 1 0 -1\nv 0 1 0\nv 0 0 0\nv -0 1 0\nv -1 0 -1\nf 1 2 3\nf 4 5 6\n";
    std::string ply = "ply\nformat ascii 1.0\n" + ply_xyz +
                      "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    ply.replace(ply.find("vertex 4"), 8, "vertex 6");
    ply += "0 0 0\n1 0 -1\n0 1 0\n0 0 0\n0 1 0\n-1 0 -1\n3 0 1 2\n3 3 4 5\n";
    for (const auto& [name, text] : {std::pair{"m.obj", obj}, {"m.off", off}, {"m.ply", ply}})
        for (const float crease : {180.f, 170.f, 60.f}) {
            CAPTURE(name, crease);
            const Mesh mesh = read_text(name, text);
            CHECK(mesh.positions.size() == 6);  // the file's vertices keep their numbers
            const CornerNormals n =
                corner_normals(mesh, {NormalSource::Auto, NormalWeighting::Angle, crease});
            const auto& index = n.corner.empty() ? mesh.corner_position : n.corner;
            for (const std::size_t corner : {0u, 2u, 3u, 4u})
                CHECK(std::abs(n.normals[index[corner]].x) ==
                      Approx(crease == 60.f ? 0.7071 : 0).margin(1e-3));
        }
}

TEST_CASE("positions far from the origin keep their digits, in every format", "[mesh_file]") {
    const std::string a = "500000.25 5400000.125 10", b = "500000.5 5400000.125 10",
                      c = "500000.25 5400000.25 10";
    const std::string header = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    std::string head =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty "
        "double z\n" +
        header;
    test::Bytes binary("ply\nformat binary_little_endian 1.0\n" + head.substr(head.find("element")));
    binary.add<double>({500000.25, 5400000.125, 10, 500000.5, 5400000.125, 10, 500000.25, 5400000.25, 10});
    const std::vector<std::pair<std::string, std::string>> files{
        {"m.obj", "v " + a + "\nv " + b + "\nv " + c + "\nf 1 2 3\n"},
        {"m.off", "OFF 3 1 0\n" + a + "\n" + b + "\n" + c + "\n3 0 1 2\n"},
        {"m.ply", head + a + "\n" + b + "\n" + c + "\n3 0 1 2\n"},
        {"m.ply", binary.u8({3}).u32({0, 1, 2}).str()},
        {"m.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
                      "\nendloop\nendfacet\nendsolid s\n"}};
    for (const auto& [name, text] : files) {
        CAPTURE(name);
        const Mesh mesh = read_text(name, text);
        CHECK(mesh.offset == glm::dvec3(500000, 5400000, 10));
        CHECK(mesh.positions ==
              std::vector<glm::vec3>{{0.25f, 0.125f, 0}, {0.5f, 0.125f, 0}, {0.25f, 0.25f, 0}});
        CHECK(mesh.warnings ==
              Warnings{"the coordinates are far from the origin: the offset (500000, 5400000, 10) "
                       "is subtracted"});
    }
    const Mesh near = read_text("m.obj", "v 900 0 0\nv 910 0 0\nv 900 10 0\nf 1 2 3\n");
    CHECK(near.offset == glm::dvec3(0));
    CHECK(near.positions[0] == glm::vec3(900, 0, 0));
    // Coordinates stored as floats have already been rounded.
    std::string stl = test::binary_stl();
    for (std::size_t corner = 0; corner < 6; ++corner) {
        const float x = 5400000.f + static_cast<float>(corner % 3 == 1),
                    y = 5400000.f + static_cast<float>(corner % 3);
        std::memcpy(&stl[84 + 50 * (corner / 3) + 12 * (1 + corner % 3)], &x, sizeof x);
        std::memcpy(&stl[84 + 50 * (corner / 3) + 12 * (1 + corner % 3) + 4], &y, sizeof y);
    }
    const Mesh rounded = read_text("m.stl", stl);
    REQUIRE(rounded.warnings.size() == 2);
    CHECK(rounded.warnings[1].starts_with(
        "the shape is 2 across at coordinates of up to 5400002, which are rounded"));
}

TEST_CASE("a texture that a PLY names is not read, with a warning", "[mesh_file][ply]") {
    const std::string text = "ply\nformat ascii 1.0\ncomment TextureFile wood.png\ncomment by hand\n" +
                             ply_xyz + "element face 1\nproperty list uchar int vertex_indices\n" +
                             ply_square + "3 0 1 2\n";
    CHECK(read_text("m.ply", text).warnings == Warnings{"1 texture is not read"});
}
