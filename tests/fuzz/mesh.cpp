// Bytes -> a sound mesh, or one line that says what is wrong. GLINT_FUZZ_MESH names the format, ".obj".

#include <algorithm>
#include <cmath>
#include <variant>

#include "models/mesh/normals.h"
#include "models/mesh_formats/mesh_file.h"
#include "tests/fuzz/fuzz.h"

using namespace glint;
using fuzz::require;

namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_indices(const Mesh& mesh) {
    require(mesh.face_count() > 0, "a mesh has a face");
    require(mesh.first_corner.front() == 0 && mesh.first_corner.back() == mesh.corner_position.size() &&
                std::is_sorted(mesh.first_corner.begin(), mesh.first_corner.end()),
            "faces divide the corners among them");
    const auto is_position = [&mesh](std::uint32_t p) { return p < mesh.positions.size(); };
    const auto is_normal = [&mesh](std::uint32_t n) { return n < mesh.normals.size() || n == no_index; };
    require(std::all_of(mesh.corner_position.begin(), mesh.corner_position.end(), is_position),
            "corners have positions");
    require(std::all_of(mesh.corner_normal.begin(), mesh.corner_normal.end(), is_normal),
            "corners have normals, or none");
    require(mesh.corner_normal.empty() || mesh.corner_normal.size() == mesh.corner_position.size(),
            "each corner says what its normal is");
    require(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size(), "each position has a colour");
}

void check_numbers(const Mesh& mesh) {
    for (const glm::vec3& p : mesh.positions)
        require(std::abs(p.x) <= 1e30f && std::abs(p.y) <= 1e30f && std::abs(p.z) <= 1e30f,
                "positions are within +-1e30");
    require(mesh_info(mesh).faces == mesh.face_count(), "as many faces are told as there are");
    for (const float crease : {40.f, 180.f})
        for (const glm::vec3& n :
             corner_normals(mesh, {NormalSource::Auto, NormalWeighting::Angle, crease, false}).normals)
            require(is_finite(n), "normals are finite");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Mesh> read = parse_mesh(fuzz::text_of(data, size), "m" GLINT_FUZZ_MESH);
    if (const Problem* problem = problem_of(read)) {
        const std::string line = problem->text();
        require(!problem->what.empty() && line.size() < 4096 && line.find('\n') == std::string::npos,
                "a problem is one line");
        return 0;
    }
    const Mesh& mesh = std::get<Mesh>(read);
    check_indices(mesh);
    check_numbers(mesh);
    return 0;
}
