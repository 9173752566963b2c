// Bytes -> a valid mesh, or a one-line problem; a small mesh is also decimated, subdivided, or both.
// GLINT_FUZZ_MESH names the format, such as ".obj".

#include <variant>

#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/resolution/resolution.h"
#include "tests/fuzz/fuzz.h"

using namespace glint;
using fuzz::require;

namespace {

void require_one_line(const Problem& problem) {
    const std::string line = problem.text();
    require(!problem.what.empty() && line.size() < 4096 && line.find('\n') == std::string::npos,
            "a problem is reported on one line");
}

/// Decimates or subdivides one input in four, because that takes several times as long as reading. The length
/// of the input decides whether and how.
void make_coarser_and_finer(const Mesh& mesh, std::size_t size) {
    constexpr std::size_t most_faces = 256;
    if (size % 4 != 1 || mesh.face_count() > most_faces) return;
    const int half = 1 + static_cast<int>(mesh.triangles.size() / 2);
    const MeshResolution wanted{size % 3 == 0 ? 0 : half,
                                size % 3 == 1 ? 0 : 1 + static_cast<int>(size / 4 % 2)};
    if (has_resolution(mesh, wanted)) return;
    const Result<Mesh> made = with_resolution(mesh, wanted);
    if (const Problem* problem = problem_of(made)) return require_one_line(*problem);
    const Mesh& other = std::get<Mesh>(made);
    if (other.face_count() > 0) fuzz::require_sound(other);
    const auto without_area = static_cast<std::size_t>(mesh_info(mesh).degenerate_faces);
    require(other.face_count() > 0 || without_area == mesh.face_count(),
            "at least one face remains unless no face had an area");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Mesh> read = parse_mesh(fuzz::text_of(data, size), "m" GLINT_FUZZ_MESH);
    if (const Problem* problem = problem_of(read)) {
        require_one_line(*problem);
        return 0;
    }
    fuzz::require_sound(std::get<Mesh>(read));
    make_coarser_and_finer(std::get<Mesh>(read), size);
    return 0;
}
