#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <new>
#include <numbers>
#include <optional>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/formats/mesh_file.h"
#include "models/mesh/resolution/resolution.h"
#include "models/numbers.h"
#include "models/problem.h"
#include "models/progress.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"
#include "models/utf8.h"

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
            throw ProblemFound({"", "/part",
                                fmt::format("the file has no part {}: it contains only one mesh", named.part),
                                "0"});
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
                               fmt::format("\"{}\" has a different extension", named->path),
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

// Cameras that frame objects, and the scene that shows a single mesh.

namespace {

constexpr double margin = 1.08;  // a factor on the sphere's radius, which leaves space at the picture's edge

struct Sphere {
    glm::dvec3 center{0};
    double radius = 0;
};

/// Calls f(world position) for every corner of all visible objects, or of one object.
template <class F> void each_corner(const Scene& scene, int object, F f) {
    const bool all = object < 0 || static_cast<std::size_t>(object) >= scene.objects.size();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& o = scene.objects[i];
        if (!o.mesh || (all ? !o.visible : i != static_cast<std::size_t>(object))) continue;
        const glm::dmat4 m = world_from_object(o.transform);
        for (const std::uint32_t p : o.mesh->corner_position)
            f(glm::dvec3(m * glm::dvec4(o.mesh->positions[p], 1)));
    }
}

/// A sphere around the centre of the bounds: not the smallest one, but usually at most a seventh larger.
std::optional<Sphere> bounding_sphere(const Scene& scene, int object) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    bool any = false;
    each_corner(scene, object, [&](glm::dvec3 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        any = true;
    });
    if (!any) return std::nullopt;
    Sphere s{(low + high) / 2.0, 0};
    each_corner(scene, object,
                [&](glm::dvec3 p) { s.radius = std::max(s.radius, glm::distance(p, s.center)); });
    // A point has no size that could fill the picture; far from the origin, floats cannot distinguish eye and
    // target.
    const double far_off = std::max({std::abs(s.center.x), std::abs(s.center.y), std::abs(s.center.z)});
    s.radius = s.radius > 0 ? std::max(s.radius, 1e-5 * far_off) : std::max(1.0, 1e-5 * far_off);
    return s;
}

/// The tangent of the smallest angle between the axis and the window's edges, or of half the window's angle
/// if the axis is outside it.
double narrowest_tangent(const Frustum& f) {
    const double left = std::min(f.left, f.right), right = std::max(f.left, f.right);
    const double bottom = std::min(f.bottom, f.top), top = std::max(f.bottom, f.top);
    const double inside = std::min({-left, right, -bottom, top});
    return (inside > 0 ? inside : std::min(right - left, top - bottom) / 2) / f.near;
}

/// The distance between the eye and a sphere's centre at which the sphere fits the height, the shorter side,
/// of a picture from 1:1 to 16:9: a cone of half angle a touches the sphere at the distance radius / sin a.
double fitting_distance(const Projection& projection, double radius) {
    if (const auto* p = std::get_if<Perspective>(&projection))
        return margin * radius / std::sin(p->fov_y_deg * std::numbers::pi / 360);
    if (const auto* p = std::get_if<Frustum>(&projection))
        return margin * radius / std::sin(std::atan(narrowest_tangent(*p)));
    return 4 * radius;  // arbitrary: the size in the picture does not depend on it
}

/// Returns the projection with new clipping planes: near well in front of the sphere, far well behind it,
/// with a ratio that keeps the precision of depth.
Projection with_planes(Projection projection, double distance, double radius) {
    const auto near = static_cast<float>(distance / 50), far = static_cast<float>(distance + 20 * radius);
    if (auto* f = std::get_if<Frustum>(&projection)) {
        const float scale = near / f->near;  // the window is on the near plane
        f->left *= scale, f->right *= scale, f->bottom *= scale, f->top *= scale;
    }
    if (auto* o = std::get_if<Orthographic>(&projection)) o->height = static_cast<float>(2 * margin * radius);
    std::visit([&](auto& p) { p.near = near, p.far = far; }, projection);
    return projection;
}

}  // namespace

bool frame_camera(Scene& scene, int object) {
    const std::optional<Sphere> sphere = bounding_sphere(scene, object);
    if (!sphere) return false;
    Camera camera = scene.camera;
    const glm::dvec3 back = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    const double distance = fitting_distance(camera.projection, sphere->radius);
    camera.target = glm::vec3(sphere->center);
    camera.eye = glm::vec3(sphere->center + distance * back);
    camera.projection = with_planes(camera.projection, distance, sphere->radius);
    if (violation_of_ranges(camera) || violation_of(camera)) return false;
    scene.camera = camera;
    return true;
}

std::vector<Light> default_lights() {
    Light key;
    key.name = "Key";
    key.kind = LightKind::Directional;
    key.position = {-1, 1.5f, 1, 0};
    key.diffuse = key.specular = glm::vec3(0.9f);
    Light fill;
    fill.name = "Fill";
    fill.space = LightSpace::Camera;
    fill.position = {0, 0, 0, 1};
    fill.diffuse = glm::vec3(0.3f);
    fill.specular = glm::vec3(0);  // a highlight at the eye would follow the viewer
    return {key, fill};
}

Scene scene_of_mesh(MeshPtr mesh, const std::string& path) {
    Scene scene;
    Object object;
    object.name = with_invalid_replaced(std::filesystem::path(path).stem().string());
    object.source = MeshFile{path};
    object.mesh = std::move(mesh);
    object.material = {.ambient = glm::vec3(0.2f), .diffuse = glm::vec3(0.7f), .specular = glm::vec3(0.25f)};
    scene.objects.push_back(std::move(object));
    scene.lights = default_lights();

    scene.camera.eye = eye_before_framing;
    frame_camera(scene);
    return scene;
}

}  // namespace glint
