#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "models/fields/choices.h"
#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/resolution/resolution.h"
#include "models/problem.h"
#include "models/progress.h"
#include "models/scene/scene_cost.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Identifies an original mesh: by a primitive's name and detail, or by the file itself (independent of its
/// path), its part, and the extension that selects the reader.
using GivenKey = std::tuple<std::string, int, dev_t, ino_t>;
/// Identifies a mesh together with its resolution.
using MeshKey = std::tuple<GivenKey, int, int>;

/// Files with several parts, each read once; the key is that of part 0.
using GltfFiles = std::map<GivenKey, GltfFile>;

/// `key`: the key of the part.
Result<Mesh> part_of(const std::string& path, GivenKey key, GltfFiles& files) {
    const int part = std::exchange(std::get<int>(key), 0);
    auto found = files.find(key);
    if (found == files.end()) {
        const Result<GltfFile> file = GltfFile::read(path);
        if (const Problem* problem = problem_of(file)) return *problem;
        found = files.emplace(std::move(key), std::get<GltfFile>(file)).first;
    }
    return found->second.mesh(part);
}

Result<MeshPtr> load(const MeshSource& source, const GivenKey& key, const std::string& mesh_dir,
                     GltfFiles& files) {
    return result_of("", [&]() -> MeshPtr {
        if (const auto* mesh = std::get_if<PrimitiveMesh>(&source))
            return std::make_shared<const Mesh>(make_primitive(mesh->primitive, mesh->detail));
        const auto& named = std::get<MeshFile>(source);
        const std::string path = path_from(mesh_dir, named.path);
        if (!is_gltf_path(path) && named.part != 0)
            throw ProblemFound(
                {"", "/part", fmt::format("the file holds one mesh, and not a part {}", named.part), "0"});
        return std::make_shared<const Mesh>(
            value_or_throw(is_gltf_path(path) ? part_of(path, key, files) : read_mesh(path)));
    });
}

/// Returns `given` refined or coarsened; `given` itself if nothing changes.
Result<MeshPtr> refined(const MeshPtr& given, const MeshResolution& wanted) {
    if (has_resolution(*given, wanted)) return given;
    Result<Mesh> made = with_resolution(*given, wanted);
    if (const Problem* problem = problem_of(made)) return *problem;
    return std::make_shared<const Mesh>(std::get<Mesh>(std::move(made)));
}

GivenKey key_of_file(const std::string& path) {
    struct stat status {};
    if (path.find('\0') != std::string::npos || ::stat(path.c_str(), &status) != 0) return {path, 0, 0, 0};
    return {lower_extension(path), 0, status.st_dev, status.st_ino};
}

/// Meshes by their source, so that each one is loaded once.
class Loader {
  public:
    Loader(const std::string& file, const std::string& mesh_dir) : file_(file), mesh_dir_(mesh_dir) {}

    /// The object's mesh; a problem refers to its pointer in the scene, or to the mesh file.
    Result<MeshPtr> mesh_of(const Object& object, std::size_t index) {
        const std::string pointer = fmt::format("/objects/{}/mesh", index);
        const auto* named = std::get_if<MeshFile>(&object.source);
        MeshPtr& known = known_[key_of(object.source)];
        if (known) return known;
        Result<MeshPtr> given = given_mesh(object.source, pointer);
        if (problem_of(given) != nullptr) return given;
        Result<MeshPtr> made = refined(std::get<MeshPtr>(given), resolution_of(object.source));
        if (const Problem* problem = problem_of(made))
            return Problem{file_, pointer + problem->pointer, problem->what, problem->expected};
        known = std::get<MeshPtr>(std::move(made));
        cost_.meshes += mesh_bytes(*known);
        if (const auto problem = too_much_memory(cost_))
            return Problem{file_, pointer, problem->what, problem->expected};
        for (const std::string& warning : known->warnings) {
            const std::string line = named != nullptr ? named->path + ": " + warning : warning;
            warnings_.add(line);
        }
        return known;
    }

    /// Registers a mesh that the scene has already loaded.
    void remember(const Object& object) {
        if (object.mesh) known_[key_of(object.source)] = object.mesh;
    }

    Warnings take_warnings() { return warnings_.take(); }

  private:
    /// The original mesh, read or generated.
    Result<MeshPtr> given_mesh(const MeshSource& source, const std::string& pointer) {
        const auto* named = std::get_if<MeshFile>(&source);
        MeshPtr& known = known_[key_of(as_given(source))];
        if (known) return known;
        if (named != nullptr) {
            if (const auto why = why_no_mesh_file(path_from(mesh_dir_, named->path)))
                return Problem{file_, pointer + "/file",
                               fmt::format("cannot read \"{}\": {}", named->path, why->what), why->expected};
            if (!is_mesh_path(named->path) && !is_gltf_path(named->path))
                return Problem{file_, pointer + "/file",
                               fmt::format("\"{}\" has another extension", named->path),
                               ".obj, .ply, .off, .stl, .gltf or .glb"};
        }
        Result<MeshPtr> loaded = load(source, given_key_of(source), mesh_dir_, gltf_files_);
        if (const Problem* problem = problem_of(loaded)) {
            if (!problem->file.empty()) return *problem;
            return Problem{file_, pointer + problem->pointer, problem->what, problem->expected};
        }
        known = std::get<MeshPtr>(std::move(loaded));
        return known;
    }

    MeshKey key_of(const MeshSource& source) {
        const MeshResolution wanted = resolution_of(source);
        return {given_key_of(source), wanted.decimate, wanted.subdivide};
    }
    GivenKey given_key_of(const MeshSource& source) {
        if (const auto* mesh = std::get_if<PrimitiveMesh>(&source))
            return {std::string(name_of(mesh->primitive)), mesh->detail, 0, 0};  // details begin at 1
        const auto& named = std::get<MeshFile>(source);
        const std::string path = path_from(mesh_dir_, named.path);
        auto found = key_of_path_.find(path);
        if (found == key_of_path_.end()) found = key_of_path_.emplace(path, key_of_file(path)).first;
        GivenKey key = found->second;
        std::get<int>(key) = named.part;
        return key;
    }

    const std::string& file_;
    const std::string& mesh_dir_;
    GltfFiles gltf_files_;
    std::map<MeshKey, MeshPtr> known_;
    std::map<std::string, GivenKey> key_of_path_;  // each file is queried once
    SceneCost cost_;
    WarningList warnings_;
};

}  // namespace

std::optional<Problem> why_no_mesh_file(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_regular_file(status)) return std::nullopt;
    const auto problem = [&path](const std::string& what) { return Problem{path, "", what, "a mesh file"}; };
    if (status.type() == fs::file_type::not_found) return problem("no such file");
    if (!fs::exists(status)) return problem(reason(error.value()));
    return problem(fs::is_directory(status) ? "it is a directory" : "it is a device or a pipe");
}

Result<Warnings> load_meshes(Scene& scene, const std::string& file, const std::string& mesh_dir) {
    Loader loader(file, mesh_dir);
    Scene loaded = scene;
    for (const Object& object : scene.objects) loader.remember(object);
    for (std::size_t i = 0; i < loaded.objects.size(); ++i) {
        if (loaded.objects[i].mesh) continue;
        if (load_cancelled()) return Problem{file, "", cancelled_words, ""};
        Result<MeshPtr> mesh = loader.mesh_of(loaded.objects[i], i);
        if (const Problem* problem = problem_of(mesh)) return *problem;
        loaded.objects[i].mesh = std::get<MeshPtr>(std::move(mesh));
    }
    if (auto problem = too_large(loaded)) {
        problem->file = file;
        return *problem;
    }
    scene = std::move(loaded);
    return loader.take_warnings();
}

}  // namespace glint
