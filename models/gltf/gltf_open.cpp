#include "models/gltf/gltf_open.h"

#include <fmt/format.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "models/fields/range.h"
#include "models/gltf/gltf_items.h"
#include "models/mesh/mesh_memory.h"
#include "models/progress.h"
#include "models/scene_file/default_lights.h"
#include "models/scene_file/scene_file.h"
#include "models/warning_list.h"

namespace glint {
namespace {

/// The middle of all objects, world coordinates.
glm::dvec3 middle_of(const Scene& scene) {
    glm::dvec3 low(max_number), high(-max_number);
    for (const Object& object : scene.objects) {
        const glm::dmat4 m = world_from_object(object.transform);
        for (const glm::dvec3& corner : corners_of(object.mesh->bounds)) {
            const glm::dvec3 p(m * glm::dvec4(corner, 1));
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    return scene.objects.empty() ? glm::dvec3(0) : (low + high) / 2.0;
}

// A light that gives so many times full brightness was not meant for a display.
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

Result<std::monostate> load_parts(const GltfFile& file, Scene& scene) {
    std::vector<MeshPtr> known;
    for (Object& object : scene.objects) {
        const auto part = static_cast<std::size_t>(std::get<MeshFile>(object.source).part);
        if (part >= known.size()) known.resize(part + 1);
        if (!known[part]) {
            Result<Mesh> mesh = file.mesh(static_cast<int>(part));
            if (const Problem* problem = problem_of(mesh)) return *problem;
            known[part] = share_mesh(std::get<Mesh>(std::move(mesh)));
        }
        object.mesh = known[part];
    }
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
    try {
        if (const Problem* problem = problem_of(file)) return *problem;
        const std::string name = std::filesystem::path(path).filename().string();
        Result<GltfFile::Content> read = std::get<GltfFile>(file).content(name);
        if (const Problem* problem = problem_of(read)) return *problem;
        auto& content = std::get<GltfFile::Content>(read);
        Scene& scene = content.scene;
        if (scene.objects.empty()) return nothing_drawn(content.objects_left_out, path);
        const Result<std::monostate> loaded = load_parts(std::get<GltfFile>(file), scene);
        if (const Problem* problem = problem_of(loaded)) return *problem;
        WarningList of_meshes;
        for (const Object& object : scene.objects)
            for (const std::string& warning : object.mesh->warnings)
                of_meshes.add(fmt::format("{}: {}", object.name, warning));
        for (std::string& warning : of_meshes.take()) content.warnings.push_back(std::move(warning));
        const glm::dvec3 middle = middle_of(scene);
        if (content.has_camera) {
            // The target is moved to the objects' distance, so that turning the camera turns it round them.
            const double distance = glm::dot(middle - glm::dvec3(scene.camera.eye), content.ahead);
            if (distance > 0) scene.camera.target = target_of(scene.camera.eye, content.ahead, distance);
        } else {
            frame_camera(scene);
        }
        if (!content.has_lights && !content.is_ours) scene.lights = default_lights();
        if (!content.is_ours && content.has_lights) darken_lights(scene, middle, content.warnings);
        // What is opened can be saved, and opens again.
        const Result<Scene> read_back = parse_scene(scene_text(scene), path);
        if (const Problem* problem = problem_of(read_back)) return *problem;
        return GltfOpened{std::move(scene), std::move(content.warnings)};
    } catch (const LoadCancelled&) {
        return Problem{path, "", cancelled_words, ""};
    } catch (const Refused& refused) {
        return memory_problem(refused, path);
    } catch (const std::bad_alloc&) {
        return Problem{path, "", "the file does not fit in memory", "a smaller one"};
    }
}

}  // namespace glint
