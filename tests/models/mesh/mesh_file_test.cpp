// Mesh files given as text: their contents, and the one-line message for each malformed one.
#include "models/mesh/formats/mesh_file.h"

#include "models/mesh/normals.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"

using namespace glint;
using test::error_of;
using test::read_text;

TEST_CASE("the extension determines the mesh format, regardless of case", "[mesh_file]") {
    CHECK(is_mesh_path("bunny.obj"));
    CHECK(is_mesh_path("/a.b/Bunny.OBJ"));
    CHECK_FALSE(is_mesh_path("scene.json"));
    CHECK_FALSE(is_mesh_path("obj"));
    CHECK_FALSE(is_mesh_path("a.obj/b"));
    CHECK(error_of("m.3ds", "x") ==
          "m.3ds: the extension is not that of a mesh file; expected .obj, .ply, .off or .stl");
}

TEST_CASE("an unreadable mesh file is reported by name", "[mesh_file]") {
    CHECK(problem_of(read_mesh("/dev/null.obj")) != nullptr);
    CHECK(problem_of(read_mesh(project_file("no-such-file.obj"))) != nullptr);
    const Result<Mesh> directory = read_mesh(project_folder);
    CHECK(problem_of(directory) != nullptr);
}

TEST_CASE("an OBJ keeps its polygons, positions and order", "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj",
                                "# a house\r\nmtllib a.mtl\no house\ng front\nusemtl red\ns off\r\n"
                                "v 0 0 0\nv +1 0 0\nv 1 1. 0\r\nv 0 1e0 0\n\tv  .5\t1.5 1e-50  # roof\n"
                                "vt 0 0\nf 1 2 3 \\\n  4\nf -2 -3/1 -1");
    CHECK(mesh.positions ==
          std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 1.5f, 0}});
    CHECK(mesh.corner_position == std::vector<std::uint32_t>{0, 1, 2, 3, 3, 2, 4});
    CHECK(mesh.first_corner == std::vector<std::uint32_t>{0, 4, 7});
    CHECK(mesh.triangles.size() == 3);
    CHECK(mesh.given_normals == GivenNormals::None);
    CHECK(mesh.colors.empty());
    CHECK(mesh.warnings == Warnings{"1 material of a .mtl file is not read"});
}

TEST_CASE("an OBJ's normals are per corner, an undefined one leaves its corner without one",
          "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 0 1 0\n"
                                "f 1//1 2//-1 3//7\nf 1 3/1/2 2//0\n");
    CHECK(mesh.given_normals == GivenNormals::File);
    CHECK(mesh.corner_normal == std::vector<std::uint32_t>{0, 1, no_index, no_index, 1, no_index});
    CHECK(corner_normals(mesh, {}).warnings ==
          Warnings{"3 corners have no normal; their vertex normals are used"});
    CHECK(mesh_info(mesh).warnings == Warnings{"3 corners have no normal; their vertex normals are used"});
    // Faces may precede the vertices and normals that they refer to.
    CHECK(read_text("m.obj", "f 1//1 2//1 3//1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n").triangles.size() ==
          1);
}

TEST_CASE("undefined normals of an OBJ are counted in a warning", "[mesh_file][obj]") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto told = [&v](const std::string& text) {
        return mesh_info(read_text("m.obj", v + text)).warnings;
    };
    CHECK(told("f 1 2 3\n").empty());
    CHECK(told("f 1//0 2 3\n") ==
          Warnings{"1 corner names a normal, but the file has none; its vertex normal is used"});
    CHECK(told("f 1//1 2//-1 3//7\n") ==
          Warnings{"3 corners name normals, but the file has none; their vertex normals are used"});
    CHECK(told("vn 0 0 1\nf 1//0 2//1 3//9\n") ==
          Warnings{"2 corners have no normal; their vertex normals are used"});
    CHECK(told("f 1/ 2/1 3/\n") == Warnings{"2 corners end in a slash, which is ignored"});
}

TEST_CASE("a message quotes at most a short word of a mesh file", "[mesh_file]") {
    const std::string secret = "AKIAIOSFODNN7EXAMPLE/wJalrXUtnFEMI";
    for (const char* name : {"m.obj", "m.ply", "m.off", "m.stl"}) {
        const std::string line = error_of(name, "solid x\n" + secret + " more\n");
        INFO(line);
        CHECK_FALSE(line.empty());
        CHECK(line.find("AKIA") == std::string::npos);
    }
    CHECK(error_of("m.obj", secret) ==
          "m.obj:1: a word of 34 bytes is not an OBJ statement; expected v, vt, vn, f, l, p, g, o, "
          "s, "
          "usemtl "
          "or mtllib");
    CHECK(error_of("m.obj", "v 1 \x1b[2J 3").find("a word of 4 bytes") != std::string::npos);
    CHECK(error_of("m.obj", "Ölförderung").find("\"Ölförderung\"") != std::string::npos);
}

TEST_CASE("a byte-order mark before the text of a mesh is skipped", "[mesh_file]") {
    const std::string mark = "\xEF\xBB\xBF";
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    CHECK(read_text("m.obj", mark + obj).triangles.size() == 1);
    CHECK(read_text("m.off", mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").triangles.size() == 1);
    CHECK(read_text("m.ply", mark + "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                    "property float y\nproperty float z\nelement face 1\n"
                                    "property list uchar int vertex_indices\nend_header\n"
                                    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
              .triangles.size() == 1);
    CHECK(read_text("m.stl", mark + "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                    "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n")
              .triangles.size() == 1);
    CHECK(error_of("m.obj", mark + "w 0 0 0\n" + obj) ==
          "m.obj:1: \"w\" is not an OBJ statement; expected v, vt, vn, f, l, p, g, o, s, usemtl or "
          "mtllib");
    CHECK(error_of("m.obj", obj + mark + "f 1 2 3\n").starts_with("m.obj:5: "));  // skipped at the start only
}

TEST_CASE("an OBJ's colours follow the position, missing ones are white", "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj", "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(mesh.colors == std::vector<glm::vec3>{{1, 1, 1}, {1, 0.5f, 0}, {1, 1, 1}});
}

TEST_CASE("contents of an OBJ other than polygons are ignored with one warning per kind",
          "[mesh_file][obj]") {
    const Mesh mesh = read_text("m.obj",
                                "v 0 0 0 1\nv 1 0 0 0.5\nv 0 1 0\nl 1 2\nl 2 3 1\np 1\ncstype bezier\n"
                                "f 1 2 3\nf 1 1 2\nf 1 2 2 3\n");
    CHECK(mesh.warnings == Warnings{"2 vertices have weights, which are ignored",
                                    "2 line elements are ignored", "1 point element is ignored",
                                    "1 statement is ignored (cstype)",
                                    "1 degenerate face has no area and is not drawn",
                                    "1 face has a repeated corner, which was skipped"});
    CHECK(mesh.face_count() == 3);
}

TEST_CASE("a malformed OBJ is reported with its line and the expected input", "[mesh_file][obj]") {
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const auto line_4 = [&v](const std::string& text) { return error_of("m.obj", v + text); };
    CHECK(error_of("m.obj", "") == "m.obj: the file is empty; expected a mesh");
    CHECK(error_of("m.obj", "# nothing\n") == "m.obj: the mesh has no faces; expected at least one");
    CHECK(error_of("m.obj", v) == "m.obj: the mesh has no faces; expected at least one");
    CHECK(line_4("f 1 2 99") == "m.obj:4: vertex index 99 is out of range; expected 1 to 3");
    CHECK(line_4("f 1 2 0") == "m.obj:4: vertex index 0 is out of range; expected 1 to 3");
    CHECK(line_4("f 1 2 -4") == "m.obj:4: vertex index -4 is out of range; expected -1 to -3, or 1 to 3");
    CHECK(line_4("f 1 2 4\nv 0 0 1\nf 1 2 5") == "m.obj:6: vertex index 5 is out of range; expected 1 to 4");
    CHECK(line_4("f 1 2 99999999999") ==
          "m.obj:4: vertex index 99999999999 is out of range; expected 1 to 3");
    CHECK(error_of("m.obj", "f -1 -2 -3\n") ==
          "m.obj:1: vertex index -1 is out of range; expected vertices before it");
    CHECK(line_4("f 1 2 x") ==
          "m.obj:4: \"x\" is not a corner of a face; expected v, v/vt, v//vn or v/vt/vn");
    CHECK(line_4("f 1 2 3/") == "");  // some exporters write a trailing slash
    CHECK(line_4("f 1 2 3/1/1/1") ==
          "m.obj:4: \"3/1/1/1\" is not a corner of a face; expected v, v/vt, v//vn or v/vt/vn");
    CHECK(line_4("f 1 2 3.5") ==
          "m.obj:4: \"3.5\" is not a corner of a face; expected v, v/vt, v//vn or v/vt/vn");
    CHECK(line_4("f 1 2 99999999999999999999") ==
          "m.obj:4: a vertex index beyond 64 bits is out of range; expected 1 to 3");
    CHECK(line_4("f 1 2 -99999999999999999999") ==
          "m.obj:4: a vertex index beyond 64 bits is out of range; expected -1 to -3, or 1 to 3");
    // Accepted, like any other undefined index of a texture coordinate or a normal.
    CHECK(line_4("f 1/99999999999999999999 2/-99999999999999999999 3//99999999999999999999") == "");
    CHECK(line_4("f") == "m.obj:4: a face has no corners; expected at least 3 after \"f\"");
    CHECK(line_4("v 1 2") == "m.obj:4: z is missing; expected a number");
    CHECK(line_4("v 1 two 3") == "m.obj:4: \"two\" is not a number; expected a number");
    CHECK(line_4("v 1 2,5 3") == "m.obj:4: \"2,5\" is not a number; expected a number");
    CHECK(line_4("v 1 +-1 3") == "m.obj:4: \"+-1\" is not a number; expected a number");
    CHECK(line_4("v 1 +-1e400 3") == "m.obj:4: \"+-1e400\" is not a number; expected a number");
    CHECK(line_4("v 1 ++1 3") == "m.obj:4: \"++1\" is not a number; expected a number");
    CHECK(read_text("m.obj", "v +1 -2 +0.5\nf 1 1 1\n").positions[0] == glm::vec3(1, -2, 0.5f));
    CHECK(line_4("v 1 nan 3") == "m.obj:4: \"nan\" is not a number; expected a number");
    CHECK(line_4("v 1 inf 3") == "m.obj:4: \"inf\" is out of range; expected -1e7 to 1e7");
    CHECK(line_4("v 1 -1.1e7 3") == "m.obj:4: \"-1.1e7\" is out of range; expected -1e7 to 1e7");
    CHECK(line_4("v 1 1e400 3") == "m.obj:4: \"1e400\" is out of range; expected -1e7 to 1e7");
    CHECK(line_4("v 1 2 3 4 5") == "m.obj:4: a colour's blue component is missing; expected a number");
    CHECK(line_4("v 1 2 3 4 5 6 7 8") ==
          "m.obj:4: \"8\" is one too many; expected 3, 4, 6 or 7 numbers after \"v\"");
    CHECK(line_4("vn 1 2") == "m.obj:4: z is missing; expected a number");
    CHECK(line_4("vn 1 2 3 4") == "m.obj:4: \"4\" is one too many; expected 3 numbers after \"vn\"");
    CHECK(line_4("\n\nv 1 \\\n 2 \\\r\n x") == "m.obj:8: \"x\" is not a number; expected a number");
    CHECK(line_4("<html>") ==
          "m.obj:4: \"<html>\" is not an OBJ statement; expected v, vt, vn, f, l, p, g, "
          "o, s, usemtl or mtllib");
}
