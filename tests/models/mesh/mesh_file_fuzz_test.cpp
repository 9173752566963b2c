// Valid files, damaged in seeded ways: each result is a sound mesh or a one-line problem.
#include <algorithm>
#include <cmath>
#include <random>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/normals.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_file_bytes.h"

using namespace glint;

namespace {

class Damage {
  public:
    explicit Damage(unsigned seed) : random_(seed) {}

    std::string apply(std::string bytes) {
        for (std::size_t times = 1 + below(3); times > 0 && !bytes.empty(); --times) {
            const std::size_t at = below(bytes.size());
            switch (below(6)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                bytes[at] = static_cast<char>(below(256));
                break;
            case 2:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                break;
            case 3:
                copy_line(bytes, at);
                break;
            case 4:
                bytes.erase(at, 1 + below(8));
                break;
            default:
                bytes.replace(at, std::min<std::size_t>(bytes.size() - at, below(4)), word());
                break;
            }
        }
        return bytes;
    }

  private:
    std::size_t below(std::size_t n) { return random_() % n; }

    void copy_line(std::string& bytes, std::size_t at) {
        const std::size_t newline = bytes.rfind('\n', at),
                          first = newline == std::string::npos ? 0 : newline + 1;
        const std::string line = bytes.substr(first, bytes.find('\n', at) - first) + "\n";
        bytes.insert(below(2) == 0 ? first : bytes.size(), line);
    }

    std::string word() {
        const std::vector<std::string> words{"-1",
                                             "4294967295",
                                             "9e99",
                                             "nan",
                                             "0",
                                             "/",
                                             "//",
                                             "\\\n",
                                             "\n",
                                             "#",
                                             " 3 ",
                                             std::string(4, '\xFF'),
                                             std::string(4, '\0'),
                                             "f 1 2 3\n",
                                             "1e-99",
                                             "solid"};
        return words[below(words.size())];
    }

    std::mt19937 random_;
};

void check_sound(const Mesh& mesh) {
    REQUIRE(mesh.face_count() > 0);
    CHECK(mesh.first_corner.front() == 0);
    CHECK(mesh.first_corner.back() == mesh.corner_position.size());
    CHECK(std::is_sorted(mesh.first_corner.begin(), mesh.first_corner.end()));
    for (const std::uint32_t p : mesh.corner_position) REQUIRE(p < mesh.positions.size());
    CHECK((mesh.smoothing.empty() || mesh.smoothing.size() == mesh.face_count()));
    for (const std::uint32_t v : mesh.first_at_place) REQUIRE(v < mesh.positions.size());
    for (const std::uint32_t n : mesh.corner_normal) REQUIRE((n < mesh.normals.size() || n == no_index));
    for (const glm::vec3& p : mesh.positions)
        for (int i = 0; i < 3; ++i) REQUIRE(std::abs(p[i]) <= 1e7f);
    CHECK((mesh.corner_normal.empty() || mesh.corner_normal.size() == mesh.corner_position.size()));
    CHECK((mesh.colors.empty() || mesh.colors.size() == mesh.positions.size()));
    CHECK(mesh_info(mesh).faces == mesh.face_count());
    for (const float crease : {40.f, 180.f})
        for (const glm::vec3& n :
             corner_normals(mesh, {NormalSource::Auto, NormalWeighting::Angle, crease}).normals)
            REQUIRE((std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z)));
}

void check_damaged(const std::string& name, const std::string& valid) {
    REQUIRE(test::error_of(name, valid).empty());
    std::size_t meshes = 0, problems = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const std::string bytes = Damage(seed).apply(valid);
        INFO(name << " " << seed);
        const Result<Mesh> result = parse_mesh(bytes, name);
        if (const Problem* problem = problem_of(result)) {
            ++problems;
            CHECK(problem->text().find('\n') == std::string::npos);
            CHECK_FALSE(problem->what.empty());
            CHECK_FALSE(problem->expected.empty());
        } else {
            ++meshes;
            check_sound(std::get<Mesh>(result));
        }
    }
    CHECK(meshes > 5);  // the damage is sometimes fatal and sometimes harmless
    CHECK(problems > 5);
}

}  // namespace

TEST_CASE("a damaged mesh file is a mesh or a problem, never a crash", "[mesh_file][fuzz]") {
    check_damaged("m.obj",
                  "# two\nv 0 0 0 1 1 0\nv 1 0 0 1 1 1\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 1\nvt 0 0\n"
                  "f 1//1 2//2 3//1 4//2\nf -4 -2/1 -1/1/2\nl 1 2\nf 1 2 \\\n 3 4 2\n");
    check_damaged(
        "m.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n1 1 0 1 2 3\n"
        "0 1 0 1 2 3\n4 0 1 2 3\n3 3 2 1\n");
    check_damaged(
        "m.obj",
        "v 0 0 0 1 0 0 1\rv 1 0 0\rv 0 1 0\rv 0 1 0\rv 9 9 9\rs 1\rvn nan 0 1\rf 1// 2/1/ 3//1\rs off\r"
        "fo 1 4 2\rusemtl red\rcall a.obj\r");
    check_damaged("m.obj",
                  "v 500000.25 5400000.5 0\nv 500001 5400000.5 0\nv 500000.25 5400001 1\nv -9999999 0 0\n"
                  "f 1 2 3\n");
    check_damaged("m.off", "OFF4 2\n0 0 0\n1 0 0 255 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 3 2 1\n");
    check_damaged("m.ply",
                  "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                  "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                  "element edge 1\nproperty int a\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
                  "8 0 1 2 3 -1 1 2 3\n7\n");
    check_damaged("m.ply", test::binary_ply(false));
    check_damaged("m.ply", test::binary_ply(true));
    check_damaged("m.off",
                  "CNOFF\n4 2 0\n0 0 0 0 0 1 9 9 9\n1 0 0 0 0 1 9 9 9\n1 1 0 0 0 1 9 9 9\n"
                  "0 1 0 0 0 1 9 9 9\n4 0 1 2 3\n3 3 2 1 0 0 0\n");
    check_damaged("m.stl",
                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
                  "endloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 1 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    check_damaged("m.stl", test::binary_stl());
}
