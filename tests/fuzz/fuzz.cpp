#include "tests/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "models/mesh/normals.h"

namespace glint::fuzz {
namespace {

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_indices(const Mesh& mesh) {
    require(mesh.face_count() > 0, "a mesh has at least one face");
    require(mesh.first_corner.front() == 0 && mesh.first_corner.back() == mesh.corner_position.size() &&
                std::is_sorted(mesh.first_corner.begin(), mesh.first_corner.end()),
            "every corner belongs to exactly one face");
    const auto is_position = [&mesh](std::uint32_t p) { return p < mesh.positions.size(); };
    const auto is_normal = [&mesh](std::uint32_t n) { return n < mesh.normals.size() || n == no_index; };
    require(std::all_of(mesh.corner_position.begin(), mesh.corner_position.end(), is_position),
            "position indices are in range");
    require(std::all_of(mesh.corner_normal.begin(), mesh.corner_normal.end(), is_normal),
            "normal indices are in range, or mark a missing normal");
    require(mesh.corner_normal.empty() || mesh.corner_normal.size() == mesh.corner_position.size(),
            "each corner has a normal index");
    require(mesh.smoothing.empty() || mesh.smoothing.size() == mesh.face_count(),
            "each face has a smoothing group");
    require(mesh.first_at_place.empty() || mesh.first_at_place.size() == mesh.positions.size(),
            "each position has the index of the first position equal to it");
    require(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size(), "each position has a colour");
}

void check_numbers(const Mesh& mesh) {
    for (const glm::vec3& p : mesh.positions)
        require(std::abs(p.x) <= 1e7f && std::abs(p.y) <= 1e7f && std::abs(p.z) <= 1e7f,
                "positions are within +-1e7");
    require(mesh_info(mesh).faces == mesh.face_count(), "the reported number of faces is the actual one");
    for (const float crease : {40.f, 180.f})
        for (const glm::vec3& n :
             corner_normals(mesh, {NormalSource::Auto, NormalWeighting::Angle, crease, false}).normals)
            require(is_finite(n), "normals are finite");
}

}  // namespace

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

std::size_t put(std::string_view text, std::uint8_t* data, std::size_t max_size) {
    const std::size_t size = std::min(text.size(), max_size);
    std::copy_n(text.data(), size, data);
    return size;
}

std::string path_of_bytes(std::string_view bytes) {
    static const int file = ::memfd_create("fuzz", MFD_CLOEXEC);
    require(file >= 0 && ::ftruncate(file, 0) == 0 &&
                ::pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
            "cannot create a file in memory");
    return "/proc/self/fd/" + std::to_string(file);
}

void require_sound(const Mesh& mesh) {
    check_indices(mesh);
    check_numbers(mesh);
}

}  // namespace glint::fuzz
