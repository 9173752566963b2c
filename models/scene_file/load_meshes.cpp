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
#include "models/fineness/fineness.h"
#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/mesh_memory.h"
#include "models/mesh_formats/mesh_file.h"
#include "models/progress.h"
#include "models/scene_file/scene_file.h"
#include "models/warning_list.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Makes a primitive. The memory share for making it is given back before the mesh gets its own.
Mesh made(const PrimitiveMesh& mesh) {
    const MemoryShare making(memory_need(MemoryUse::Meshes, bytes_to_make(mesh.primitive, mesh.detail)));
    return make_primitive(mesh.primitive, mesh.detail);
}

/// Identifies a mesh as it is given: by a primitive's name and detail, or by the file itself (whatever path
/// leads to it), its part, and the extension by which it is read.
using GivenKey = std::tuple<std::string, int, dev_t, ino_t>;
/// Identifies a mesh with how much finer or coarser it is made.
using MeshKey = std::tuple<GivenKey, int, int>;

/// Files of many parts, each read once; by the key of part 0.
using GltfFiles = std::map<GivenKey, GltfFile>;

/// `key`: of the part.
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
    try {
        if (const auto* mesh = std::get_if<PrimitiveMesh>(&source)) return share_mesh(made(*mesh));
        const auto& named = std::get<MeshFile>(source);
        const std::string path = path_from(mesh_dir, named.path);
        Result<Mesh> read = is_gltf_path(path) ? part_of(path, key, files) : read_mesh(path, named.part);
        if (const Problem* problem = problem_of(read)) return *problem;
        return share_mesh(std::get<Mesh>(std::move(read)));
    } catch (const LoadCancelled&) {
        return Problem{"", "", cancelled_words, ""};
    } catch (const Refused& refused) {
        return memory_problem(refused);
    } catch (const std::bad_alloc&) {
        return Problem{"", "", "the mesh does not fit in memory", "a smaller detail"};
    }
}

/// Returns `given` made finer or coarser as wanted; `given` itself when it is fine as it is.
Result<MeshPtr> refined(const MeshPtr& given, const Fineness& wanted) {
    if (is_fine_as_it_is(*given, wanted)) return given;
    try {
        Result<Mesh> made = with_fineness(*given, wanted);
        if (const Problem* problem = problem_of(made)) return *problem;
        return share_mesh(std::get<Mesh>(std::move(made)));
    } catch (const LoadCancelled&) {
        return Problem{"", "", cancelled_words, ""};
    } catch (const Refused& refused) {
        return memory_problem(refused);
    } catch (const std::bad_alloc&) {
        return Problem{"", "", "the mesh does not fit in memory", "fewer faces"};
    }
}

GivenKey key_of_file(const std::string& path) {
    struct stat status {};
    if (path.find('\0') != std::string::npos || ::stat(path.c_str(), &status) != 0) return {path, 0, 0, 0};
    return {lower_extension(path), 0, status.st_dev, status.st_ino};
}

/// Meshes by what they come from, so that each is loaded once.
class Loader {
  public:
    Loader(const std::string& file, const std::string& mesh_dir) : file_(file), mesh_dir_(mesh_dir) {}

    /// The object's mesh; a problem is about its place in the scene, or in the mesh file.
    Result<MeshPtr> mesh_of(const Object& object, std::size_t index) {
        const std::string pointer = fmt::format("/objects/{}/mesh", index);
        const auto* named = std::get_if<MeshFile>(&object.source);
        MeshPtr& known = known_[key_of(object.source)];
        if (known) return known;
        Result<MeshPtr> given = given_mesh(object.source, pointer);
        if (problem_of(given) != nullptr) return given;
        Result<MeshPtr> made = refined(std::get<MeshPtr>(given), fineness_of(object.source));
        if (const Problem* problem = problem_of(made))
            return Problem{file_, pointer + problem->pointer, problem->what, problem->expected};
        known = std::get<MeshPtr>(std::move(made));
        for (const std::string& warning : known->warnings) {
            const std::string line = named != nullptr ? named->path + ": " + warning : warning;
            warnings_.add(line);
        }
        return known;
    }

    /// A mesh that the scene holds already need not be loaded again.
    void remember(const Object& object) {
        if (object.mesh) known_[key_of(object.source)] = object.mesh;
    }

    /// Checks, before any is made, the memory that all primitives still to be made need together. The problem
    /// names the largest of them.
    std::optional<Problem> too_much_memory(const std::vector<Object>& objects) {
        std::set<MeshKey> counted;
        std::uint64_t all = 0, max_more = 0, most = 0;
        std::size_t largest = 0;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const auto* mesh = std::get_if<PrimitiveMesh>(&objects[i].source);
            if (objects[i].mesh || mesh == nullptr) continue;
            const MeshKey key = key_of(as_given(objects[i].source));
            if (known_.contains(key) || !counted.insert(key).second) continue;
            const std::uint64_t kept = bytes_once_made(mesh->primitive, mesh->detail);
            const std::uint64_t made = bytes_to_make(mesh->primitive, mesh->detail);
            all += kept;
            max_more = std::max(max_more, made - kept);
            if (made > most) largest = i;
            most = std::max(most, made);
        }
        try {
            require_memory(memory_need(MemoryUse::Meshes, all + max_more));
        } catch (const Refused& refused) {
            Problem problem = glint::memory_problem(refused, file_);
            problem.pointer = fmt::format("/objects/{}/mesh", largest);
            return problem;
        }
        return {};
    }
    Warnings take_warnings() { return warnings_.take(); }

  private:
    /// The mesh as it is read or made.
    Result<MeshPtr> given_mesh(const MeshSource& source, const std::string& pointer) {
        const auto* named = std::get_if<MeshFile>(&source);
        MeshPtr& known = known_[key_of(as_given(source))];
        if (known) return known;
        if (named != nullptr) {
            const std::string why = why_no_file(path_from(mesh_dir_, named->path));
            if (!why.empty())
                return Problem{file_, pointer + "/file",
                               fmt::format("cannot read \"{}\": {}", named->path, why), "a mesh file"};
            if (!is_mesh_path(named->path))
                return Problem{file_, pointer + "/file",
                               fmt::format("\"{}\" has another extension", named->path),
                               ".obj, .ply, .off, .stl, .om, .gltf or .glb"};
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
        const Fineness wanted = fineness_of(source);
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
    std::map<std::string, GivenKey> key_of_path_;  // each is asked for once
    WarningList warnings_;
};

/// `meshes`: one an object.
std::optional<Problem> too_many_triangles(const std::vector<MeshPtr>& meshes, const std::string& file) {
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        triangles += meshes[i]->triangles.size();
        if (triangles > max_scene_triangles)
            return Problem{file, fmt::format("/objects/{}/mesh", i),
                           fmt::format("with this one the objects have {} triangles", triangles),
                           fmt::format("at most {} in a scene", max_scene_triangles)};
    }
    return std::nullopt;
}

}  // namespace

std::string why_no_file(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return "no such file";
    if (!fs::exists(status)) return reason(error.value());
    if (fs::is_directory(status)) return "it is a directory";
    return fs::is_regular_file(status) ? "" : "it is a device or a pipe";
}

Result<Warnings> load_meshes(Scene& scene, const std::string& file, const std::string& mesh_dir) {
    Loader loader(file, mesh_dir);
    std::vector<MeshPtr> meshes;  // given to the scene when all are there
    for (const Object& object : scene.objects) loader.remember(object);
    if (const auto problem = loader.too_much_memory(scene.objects)) return *problem;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].mesh) {
            meshes.push_back(scene.objects[i].mesh);
            continue;
        }
        if (load_cancelled()) return Problem{file, "", cancelled_words, ""};
        Result<MeshPtr> mesh = loader.mesh_of(scene.objects[i], i);
        if (const Problem* problem = problem_of(mesh)) return *problem;
        meshes.push_back(std::get<MeshPtr>(std::move(mesh)));
    }
    if (auto problem = too_many_triangles(meshes, file)) return *problem;
    for (std::size_t i = 0; i < meshes.size(); ++i) scene.objects[i].mesh = std::move(meshes[i]);
    return loader.take_warnings();
}

}  // namespace glint
