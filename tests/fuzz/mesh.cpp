// Bytes -> a sound mesh, or one line that says what is wrong. GLINT_FUZZ_MESH names the format, ".obj".

#include <variant>

#include "models/mesh_formats/mesh_file.h"
#include "tests/fuzz/fuzz.h"

using namespace glint;
using fuzz::require;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Mesh> read = parse_mesh(fuzz::text_of(data, size), "m" GLINT_FUZZ_MESH);
    if (const Problem* problem = problem_of(read)) {
        const std::string line = problem->text();
        require(!problem->what.empty() && line.size() < 4096 && line.find('\n') == std::string::npos,
                "a problem is one line");
        return 0;
    }
    fuzz::require_sound(std::get<Mesh>(read));
    return 0;
}
