#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "models/gltf/gltf_document.h"
#include "models/numbers.h"
#include "models/problem.h"
#include "models/progress.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

struct Box {
    glm::dvec3 low{HUGE_VAL}, high{-HUGE_VAL};
    [[nodiscard]] glm::dvec3 middle() const { return (low + high) / 2.0; }
};

/// Bounds all objects, world coordinates. Precondition: there is at least one.
Box bounds_of(const Scene& scene) {
    Box box;
    for (const Object& object : scene.objects) {
        const glm::dmat4 m = world_from_object(object.transform);
        for (const glm::dvec3& corner : corners_of(object.mesh->bounds)) {
            const glm::dvec3 p(m * glm::dvec4(corner, 1));
            box.low = glm::min(box.low, p);
            box.high = glm::max(box.high, p);
        }
    }
    return box;
}

/// Warns if nodes move small shapes so far from the origin that rounding is visible, as for a single mesh.
void warn_of_rounding(const Scene& scene, const Box& box, Warnings& warnings) {
    const auto is_told = [](const Object& o) { return rounding_warning(o.mesh->bounds).has_value(); };
    if (std::any_of(scene.objects.begin(), scene.objects.end(), is_told)) return;
    if (auto warning = rounding_warning({glm::vec3(box.low), glm::vec3(box.high)}))
        warnings.push_back(std::move(*warning));
}

/// Subtracts an offset if the nodes place everything far from the origin.
void bring_near(const GltfFile& file, const std::string& name, GltfFile::Content& content) {
    const Box box = bounds_of(content.scene);
    const glm::dvec3 offset = far_offset({glm::vec3(box.low), glm::vec3(box.high)});
    if (offset == glm::dvec3(0)) return;
    Result<GltfFile::Content> near = file.content(name, offset);
    auto* read = std::get_if<GltfFile::Content>(&near);
    if (read == nullptr || read->scene.objects.size() != content.scene.objects.size()) return;
    for (std::size_t i = 0; i < content.scene.objects.size(); ++i)
        read->scene.objects[i].mesh = content.scene.objects[i].mesh;
    content = std::move(*read);
    content.warnings.push_back(offset_warning(offset));
}

// A light that exceeds full brightness by this factor was not meant for a display.
constexpr double far_too_bright = 4;

void darken_lights(Scene& scene, const glm::dvec3& middle, Warnings& warnings) {
    double brightest = 0;
    for (const Light& light : scene.lights) {
        const glm::dvec3 place = light.space == LightSpace::World
                                     ? glm::dvec3(light.position)
                                     : glm::dvec3(world_from_view(scene.camera) * glm::dvec4(light.position));
        const double r2 = light.kind == LightKind::Directional ? 1 : glm::dot(place - middle, place - middle);
        const float colour = std::max({light.diffuse.x, light.diffuse.y, light.diffuse.z});
        brightest = std::max(brightest, static_cast<double>(light.intensity * colour) / std::max(r2, 1e-12));
    }
    if (!(brightest > far_too_bright)) return;
    for (Light& light : scene.lights)
        light.intensity = static_cast<float>(static_cast<double>(light.intensity) / brightest);
    warnings.push_back(
        fmt::format("lights are {:.3g} times brighter than a display at the middle of the scene: "
                    "all are divided by that",
                    brightest));
}

Problem in_file(Problem problem, const std::string& path) {
    problem.file = path;
    return problem;
}

Result<std::monostate> load_parts(const GltfFile& file, const std::string& path, Scene& scene) {
    std::vector<MeshPtr> known;
    SceneCost cost;
    for (Object& object : scene.objects) {
        const auto part = static_cast<std::size_t>(std::get<MeshFile>(object.source).part);
        if (part >= known.size()) known.resize(part + 1);
        if (!known[part]) {
            Result<Mesh> mesh = file.mesh(static_cast<int>(part));
            if (const Problem* problem = problem_of(mesh)) return *problem;
            known[part] = std::make_shared<const Mesh>(std::get<Mesh>(std::move(mesh)));
            cost.meshes += mesh_bytes(*known[part]);
            if (const auto problem = too_much_memory(cost)) return in_file(*problem, path);
        }
        object.mesh = known[part];
    }
    if (const auto problem = too_large(scene)) return in_file(*problem, path);
    return std::monostate{};
}

Problem nothing_drawn(const Warnings& left_out, const std::string& path) {
    const std::string what =
        left_out.empty() ? "its scene has no mesh"
                         : fmt::format("nothing of its scene can be drawn: {}", fmt::join(left_out, ", "));
    return {path, "", what, "at least one triangle"};
}

}  // namespace

Result<GltfOpened> open_gltf(const std::string& path) { return open_gltf(GltfFile::read(path), path); }

Result<GltfOpened> open_gltf(const Result<GltfFile>& file, const std::string& path) {
    return result_of(path, [&]() -> Result<GltfOpened> {
        if (const Problem* problem = problem_of(file)) return *problem;
        const std::string name = std::filesystem::path(path).filename().string();
        Result<GltfFile::Content> read = std::get<GltfFile>(file).content(name);
        if (const Problem* problem = problem_of(read)) return *problem;
        auto& content = std::get<GltfFile::Content>(read);
        Scene& scene = content.scene;
        if (scene.objects.empty()) return nothing_drawn(content.objects_left_out, path);
        const Result<std::monostate> loaded = load_parts(std::get<GltfFile>(file), path, scene);
        if (const Problem* problem = problem_of(loaded)) return *problem;
        bring_near(std::get<GltfFile>(file), name, content);
        WarningList of_meshes;
        for (const Object& object : scene.objects)
            for (const std::string& warning : object.mesh->warnings)
                of_meshes.add(fmt::format("{}: {}", object.name, warning));
        for (std::string& warning : of_meshes.take()) content.warnings.push_back(std::move(warning));
        const Box bounds = bounds_of(scene);
        const glm::dvec3 middle = bounds.middle();
        warn_of_rounding(scene, bounds, content.warnings);
        if (content.has_camera) {
            // The target is moved to the objects' distance, so that orbiting the camera turns it around them.
            const double distance = glm::dot(middle - glm::dvec3(scene.camera.eye), content.ahead);
            if (distance > 0) scene.camera.target = target_of(scene.camera.eye, content.ahead, distance);
        } else {
            scene.camera.eye = eye_before_framing;
            frame_camera(scene);
        }
        if (!content.has_lights && !content.is_ours) scene.lights = default_lights();
        if (!content.is_ours && content.has_lights) darken_lights(scene, middle, content.warnings);
        // It must be possible to save an opened scene and to open it again.
        const Result<Scene> read_back = parse_scene(scene_text(scene), path);
        if (const Problem* problem = problem_of(read_back)) return *problem;
        return GltfOpened{std::move(scene), std::move(content.warnings)};
    });
}

Result<GltfWritten> glb_of(const Scene& scene, const std::string& name) {
    Result<GltfWritten> written = unchecked_glb_of(scene, name);
    if (problem_of(written) != nullptr) return written;
    const Result<GltfOpened> opened =
        open_gltf(GltfFile::parse(std::get<GltfWritten>(written).bytes, ""), "written.glb");
    const Problem* problem = problem_of(opened);
    if (problem == nullptr) return written;
    const std::string at = problem->pointer.empty() ? "" : problem->pointer + ": ";
    return Problem{"", "", fmt::format("written as glTF it could not be opened: {}{}", at, problem->what),
                   problem->expected};
}

}  // namespace glint
