// OM files that OpenMesh's own writer made, and some made byte by byte.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // inside OpenMesh's properties
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <sstream>

#include "models/mesh_formats/mesh_file.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"

using namespace glint;
using test::check_all;
using test::read_text;

TEST_CASE("an OM that OpenMesh wrote keeps polygons, normals and colours", "[mesh_file][om]") {
    struct Traits : OpenMesh::DefaultTraits {
        VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color |
                         OpenMesh::Attributes::Status);
    };
    // A ring of 200 quads with a cap of 200 corners: indices of 2 bytes.
    OpenMesh::PolyMesh_ArrayKernelT<Traits> pillar;
    std::vector<OpenMesh::VertexHandle> v;
    for (int i = 0; i < 400; ++i) {
        const int side = i / 2;
        const double angle = 0.0314159265358979 * side;
        v.push_back(pillar.add_vertex({static_cast<float>(std::cos(angle)),
                                       static_cast<float>(std::sin(angle)), static_cast<float>(i % 2)}));
        pillar.set_normal(v.back(), {0, 0, 3});
        pillar.set_color(v.back(), {255, 51, 0});
    }
    std::vector<OpenMesh::VertexHandle> cap;
    for (std::size_t i = 0; i < 400; i += 2) {
        pillar.add_face(v[i], v[(i + 2) % 400], v[(i + 3) % 400], v[i + 1]);
        cap.push_back(v[i + 1]);
    }
    pillar.add_face(cap);
    using OpenMesh::IO::Options;
    omlog().disconnect(std::clog);  // the writer counts its bytes aloud
    for (const bool attributes : {false, true}) {
        Options options = Options::Binary;
        if (attributes) options += Options::VertexNormal;
        if (attributes) options += Options::VertexColor;
        if (attributes) options += Options::Status;
        std::ostringstream stream;
        REQUIRE(OpenMesh::IO::write_mesh(pillar, stream, ".om", options));
        const Mesh mesh = read_text("m.om", stream.str());
        CHECK(mesh.positions.size() == 400);
        REQUIRE(mesh.face_count() == 201);
        CHECK(mesh.corners_of(200).size() == 200);
        const MeshInfo info = mesh_info(mesh);
        CHECK(info.quads == 200);
        CHECK(info.boundary_edges == 200);
        CHECK(info.inconsistent_edges == 0);
        const auto corners = mesh.corners_of(7);  // from whichever corner
        const auto at =
            static_cast<std::size_t>(std::find(corners.begin(), corners.end(), 14u) - corners.begin());
        REQUIRE(at < 4);
        CHECK(corners[(at + 1) % 4] == 16);
        CHECK(corners[(at + 2) % 4] == 17);
        CHECK(mesh.given_normals == (attributes ? GivenNormals::File : GivenNormals::None));
        CHECK(mesh.colors.size() == (attributes ? 400u : 0u));
        if (attributes) CHECK(mesh.colors[9].g == Approx(0.2));
        CHECK(mesh.warnings.empty());
    }
}

TEST_CASE("faces that OpenMesh has marked as deleted are not part of an OM's mesh", "[mesh_file][om]") {
    struct Traits : OpenMesh::DefaultTraits {
        VertexAttributes(OpenMesh::Attributes::Status);
        HalfedgeAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::PrevHalfedge);
        EdgeAttributes(OpenMesh::Attributes::Status);
        FaceAttributes(OpenMesh::Attributes::Status);
    };
    OpenMesh::PolyMesh_ArrayKernelT<Traits> strip;
    std::vector<OpenMesh::VertexHandle> v;
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 2; ++y) v.push_back(strip.add_vertex({float(x), float(y), 0}));
    for (std::size_t i = 0; i < 6; i += 2) strip.add_face(v[i], v[i + 2], v[i + 3], v[i + 1]);
    strip.delete_face(strip.face_handle(1), false);
    using OpenMesh::IO::Options;
    omlog().disconnect(std::clog);
    std::ostringstream stream;
    REQUIRE(OpenMesh::IO::write_mesh(strip, stream, ".om", Options(Options::Binary) + Options::Status));
    const Mesh mesh = read_text("m.om", stream.str());
    REQUIRE(mesh.face_count() == 2);
    const auto left = mesh.corners_of(1);  // the third of those that were made
    CHECK(std::set<std::uint32_t>(left.begin(), left.end()) == std::set<std::uint32_t>{4, 5, 6, 7});
    CHECK(mesh.warnings == Warnings{"faces that are marked as deleted are left out"});
}

TEST_CASE("an OM is read with vertex indices (version 1) and with half-edges (version 2)",
          "[mesh_file][om]") {
    CHECK(read_text("m.om", test::old_om()).corner_position == std::vector<std::uint32_t>{0, 1, 2, 3});
    CHECK(read_text("m.om", test::om()).corner_position == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("colours that OpenMesh before 2.0 called floats are the bytes that they are", "[mesh_file][om]") {
    using namespace std::string_literals;
    // As OpenMesh 1 wrote a triangle: version 1.2; headers of positions, of vertex colours, of faces.
    std::string file = "OMT\x22"s + "\3\0\0\0\1\0\0\0\3\0\0\0"s + "\x00\x16"s;
    const std::string zero(4, '\0'), one = "\0\0\x80\x3f"s;
    file += zero + zero + zero + one + zero + zero + zero + one + zero;
    file += "\x80\x14"s + "\xff\x33\0"s + "\0\0\xff"s + "\1\2\3"s;
    file += "\xe8\x00"s + "\0\1\2"s;
    const Mesh mesh = read_text("m.om", file);
    REQUIRE(mesh.colors.size() == 3);
    CHECK(mesh.colors[0] == glm::vec3(1, 51 / 255.f, 0));
    CHECK(mesh.colors[2].b == Approx(3 / 255.));
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.warnings.empty());
}

TEST_CASE("a malformed OM is answered with what was expected", "[mesh_file][om]") {
    const std::string good = test::om();
    const auto with = [](std::string bytes, std::size_t at, char byte) {
        bytes[at] = byte;
        return bytes;
    };
    check_all({
        {"m.om", "OFF", ": this is not an OM file; expected \"OM\" and its counts"},
        {"m.om", with(good, 2, 'X'), ": \"X\" is not a kind of mesh; expected T, Q or P"},
        {"m.om", with(good, 3, '\x43'), ": the file is of a newer version; expected 2.2 at most"},
        {"m.om", with(good, 7, '\xFF'), ": a count is out of range; expected at most 2147483647"},
        {"m.om", with(good, 6, '\x7F'), ": the file ends early; expected a chunk of 99876900 bytes"},
        {"m.om", with(good, 16, '\x14'), ": a chunk is of the unknown kind 5; expected 0, 1, 2, 4, 6 or 7"},
        {"m.om", with(good, 17, '\x12'),
         ": the positions are of an unusual type; expected three 4-byte floats each"},
        {"m.om", good.substr(0, good.size() - 3), ": the file ends early; expected a chunk of 1 bytes"},
        {"m.om", good.substr(0, 17), ": the file ends early; expected a chunk or the end mark"},
        {"m.om", good.substr(0, 16) + good.substr(54),
         ": the file has no positions of its vertices; expected a chunk of positions"},
        {"m.om", good.substr(0, 54) + good.substr(16), ": a chunk comes twice; expected one of each"},
        {"m.om", test::om(3), ": face 0: its half-edges do not form a loop; expected each once"},
        {"m.om", test::om(77), ": face 0: half-edge index 77 is out of range; expected 0 to 5"},
        {"m.om", test::om(2, 6), ": face 0: half-edge index 6 is out of range; expected 0 to 5"},
        {"m.om", test::old_om(4), ": face 0: vertex index 4 is out of range; expected 0 to 3"},
        {"m.om", with(good, 21, '\x7F'),
         ": vertex 0: a coordinate of 1.7014118e+38 is out of range; expected -1e30 to 1e30"},
    });
}
