// Bytes -> a glTF file's scene and meshes, or a one-line problem. A scene that was read is written as a .glb,
// which must be readable.

#include <string>
#include <variant>

#include "models/fields/scene_fields.h"
#include "models/gltf/gltf_document.h"
#include "models/memory_limit.h"
#include "models/mesh/formats/mesh_reader.h"
#include "models/scene_file/scene_file.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/json_mutator.h"

using namespace glint;
using fuzz::require;

namespace {

void require_line(const Problem& problem) {
    const std::string line = problem.text();
    require(!problem.what.empty() && line.size() < 4096 && line.find('\n') == std::string::npos,
            "a problem is reported on one line");
}

/// Loads the scene's meshes; false for a one-line problem with one of them.
bool load(const GltfFile& file, Scene& scene) {
    for (Object& object : scene.objects) {
        const auto* part = std::get_if<MeshFile>(&object.source);
        require(part != nullptr, "a glTF object has a mesh from the file");
        Result<Mesh> mesh = file.mesh(part->part);
        if (const Problem* problem = problem_of(mesh)) {
            require_line(*problem);
            return false;
        }
        fuzz::require_sound(std::get<Mesh>(mesh));
        object.mesh = std::make_shared<const Mesh>(std::get<Mesh>(std::move(mesh)));
    }
    return true;
}

void read(std::string_view bytes) {
    const Result<GltfFile> file = GltfFile::parse(std::string(bytes), "/nowhere/m.glb");
    if (const Problem* problem = problem_of(file)) return require_line(*problem);
    Result<GltfFile::Content> content = std::get<GltfFile>(file).content("m.glb");
    if (const Problem* problem = problem_of(content)) return require_line(*problem);
    Scene& scene = std::get<GltfFile::Content>(content).scene;
    require(!violation_of(scene), "a scene that was read obeys the rules");
    if (!load(std::get<GltfFile>(file), scene)) return;
    const Result<GltfWritten> written = glb_of(scene, "m");
    if (const Problem* problem = problem_of(written)) return require_line(*problem);
    const Result<GltfFile> again = GltfFile::parse(std::get<GltfWritten>(written).bytes, "n.glb");
    require(!problem_of(again), "written output can be read");
    require(!problem_of(std::get<GltfFile>(again).content("n.glb")), "written output is a scene");
}

}  // namespace

/// Changes a container's JSON and corrects its lengths, or changes arbitrary bytes.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    constexpr std::size_t header = 20;  // bytes: the headers of the container and of its first chunk
    const std::string_view bytes = fuzz::text_of(data, size);
    if (!bytes.starts_with("glTF") || size < header) return fuzz::mutate_json(data, size, max_size, seed);
    std::mt19937 random(seed);
    const std::uint64_t length = little_endian(bytes.data() + 12, 4);
    if (random() % 2 == 0 || length > size - header) return LLVMFuzzerMutate(data, size, max_size);
    const std::string json = fuzz::with_changed_json(bytes.substr(header, length), random);
    const std::string_view bin = bytes.substr(std::min(size, header + length + 8));
    return fuzz::put(glb_container(json, std::string(bin)), data, max_size);
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::uint64_t memory = 64 << 20;  // bytes: one count in a file may request gigabytes
    set_memory_limit(memory);
    try {
        read(fuzz::text_of(data, size));
    } catch (const LimitExceeded&) {  // the commands report it
    }
    return 0;
}
