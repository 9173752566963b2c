// Reads scenes from files and writes them.

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <system_error>

#include "models/gltf/gltf_document.h"
#include "models/io/file.h"
#include "models/io/png_info.h"
#include "models/json/json.h"
#include "models/mesh/formats/mesh_file.h"
#include "models/numbers.h"
#include "models/problem.h"
#include "models/progress.h"
#include "models/scene/scene.h"
#include "models/scene_file/scene_file.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Objects with an unchanged source share the loaded meshes.
void take_meshes(Scene& scene, const std::vector<Object>& loaded) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        Object& object = scene.objects[i];
        const auto has_it = [&](const Object& o) { return o.source == object.source; };
        const auto same = i < loaded.size() && has_it(loaded[i])  // the usual case
                              ? loaded.begin() + static_cast<std::ptrdiff_t>(i)
                              : std::find_if(loaded.begin(), loaded.end(), has_it);
        if (same != loaded.end()) object.mesh = same->mesh;
    }
}

/// Attributes a problem with a mesh to --set if an assignment set the mesh or changed one of its numbers.
Problem blamed(Problem problem, const std::vector<Assignment>& assignments) {
    const auto changed_it = [&](const Assignment& a) { return is_within(a.pointer, problem.pointer); };
    if (problem.pointer.empty()) return problem;
    if (is_assigned(problem.pointer, assignments) ||
        std::any_of(assignments.begin(), assignments.end(), changed_it))
        problem.file = "--set";
    return problem;
}

// Functions that return a document or warnings throw ProblemFound.

/// Gives the scene its meshes: reuses those in `loaded` with the same source, and reads the others. Problems
/// with assigned values are attributed to the assignment.
Warnings add_meshes(Scene& scene, const std::vector<Object>& loaded, const std::string& path,
                    const std::string& mesh_dir, const std::vector<Assignment>& assignments) {
    take_meshes(scene, loaded);
    Result<Warnings> warned = load_meshes(scene, path, mesh_dir);
    if (const Problem* problem = problem_of(warned)) throw ProblemFound(blamed(*problem, assignments));
    return std::get<Warnings>(std::move(warned));
}

SceneDocument document_of(std::string_view text, const std::string& path,
                          const std::vector<Assignment>& assignments,
                          const std::vector<Object>& loaded = {}) {
    SceneDocument document{
        value_or_throw(parse_scene(text, path, assignments)), path, directory_of(path), {}};
    document.warnings = add_meshes(document.scene, loaded, path, document.mesh_dir, assignments);
    return document;
}

/// The document of a file other than a scene file, with the assignments applied.
SceneDocument assigned(SceneDocument given, const std::vector<Assignment>& assignments) {
    if (assignments.empty()) return given;
    SceneDocument changed =
        document_of(scene_text(given.scene), given.path, assignments, given.scene.objects);
    changed.warnings.insert(changed.warnings.begin(), given.warnings.begin(), given.warnings.end());
    return changed;
}

SceneDocument open_scene(const std::string& path, const std::vector<Assignment>& assignments) {
    return document_of(value_or_throw(read_file(path, max_json_bytes)), path, assignments);
}

/// "640x716"; nullopt for any other text.
std::optional<PictureSize> fitted_size_of(const std::string& words) {
    PictureSize size{0, 0, true};
    const char* end = words.data() + words.size();
    const auto width = std::from_chars(words.data(), end, size.width);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return {};
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    const auto is_side = [](int side) { return side >= 1 && side <= max_picture_side; };
    if (height.ec != std::errc() || height.ptr != end || !is_side(size.width) || !is_side(size.height))
        return {};
    return size;
}

/// Records how the picture was drawn: its size, its samples, and the size to which its scene is fitted, if
/// any.
void take_picture(SceneDocument& document, const PngInfo& png) {
    const auto ignore = [&document](std::string_view what, const char* kind) {
        document.warnings.push_back(
            fmt::format("{}: its {} is not {}, and is ignored", on_one_line(document.path), what, kind));
    };
    const auto is_side = [](std::uint32_t side) { return side >= 1 && side <= max_picture_side; };
    if (is_side(png.width) && is_side(png.height))
        document.picture_size = {static_cast<int>(png.width), static_cast<int>(png.height)};
    else
        ignore("header", "that of a picture of 1x1 to 16384x16384");
    if (const std::string* text = png.text(png_samples_keyword)) {
        const bool is_count = *text == "1" || *text == "2" || *text == "4" || *text == "8";
        if (is_count)
            document.picture_samples = (*text)[0] - '0';
        else
            ignore(fmt::format("chunk {}", png_samples_keyword), "1, 2, 4 or 8");
    }
    if (const std::string* text = png.text(png_field_keyword)) {
        document.fitted_to = fitted_size_of(*text);
        if (!document.fitted_to) ignore(fmt::format("chunk {}", png_field_keyword), "a size");
    }
}

SceneDocument open_picture(const std::string& path, const std::vector<Assignment>& assignments) {
    const PngInfo png = value_or_throw(read_png_info(path, png_scene_keyword, max_json_bytes));
    SceneDocument document = document_of(*png.text(png_scene_keyword), path, assignments);
    take_picture(document, png);
    return document;
}

SceneDocument open_mesh(const std::string& path, const std::vector<Assignment>& assignments) {
    const auto mesh = std::make_shared<const Mesh>(value_or_throw(read_mesh(path)));
    const std::string name = fs::path(path).filename().string();
    SceneDocument document{scene_of_mesh(mesh, name), path, directory_of(path), {}};
    for (const std::string& warning : mesh->warnings)
        document.warnings.push_back(fmt::format("{}: {}", name, warning));
    return assigned(std::move(document), assignments);
}

SceneDocument open_gltf_scene(const std::string& path, const std::vector<Assignment>& assignments) {
    GltfOpened opened = value_or_throw(open_gltf(path));
    return assigned({std::move(opened.scene), path, directory_of(path), std::move(opened.warnings)},
                    assignments);
}

SceneDocument open_by_extension(const std::string& path, const std::vector<Assignment>& assignments) {
    const std::string extension = lower_extension(path);
    if (path == "-" || extension == ".json") return open_scene(path, assignments);
    if (extension == ".png") return open_picture(path, assignments);
    if (is_gltf_path(path)) return open_gltf_scene(path, assignments);
    if (is_mesh_path(path)) return open_mesh(path, assignments);
    if (!path.empty())
        // A missing file is reported as missing, even if its extension is unknown.
        if (auto problem = why_not_there(path, opened_files)) throw ProblemFound(*problem);
    std::error_code error;
    const char* const what = fs::is_directory(path, error) ? "is a directory"
                             : extension.empty()           ? "has no extension"
                                                           : "has a different extension";
    throw ProblemFound({path, "", what, opened_files});
}

/// The directory with links and dots resolved in its existing part; the working directory if it is empty. If
/// the system does not permit resolving links, only dots are resolved.
fs::path canonical_directory(const fs::path& directory) {
    std::error_code error;
    const fs::path given = directory.empty() ? "." : directory;
    fs::path path = fs::weakly_canonical(given, error);
    return error ? fs::absolute(given, error).lexically_normal() : path;
}

/// Whether the path is a link to a file in another directory. The file opens under both paths, but its
/// relative paths resolve differently.
bool leads_elsewhere(const std::string& path) {
    const fs::path replaced = replaced_file(path);
    return !replaced.empty() &&
           canonical_directory(replaced.parent_path()) != canonical_directory(directory_of(path));
}

/// Returns the scene in which `changed(place)` replaces the directory `place` of each mesh whose path is
/// relative to `directory`.
template <class Change>
Scene with_mesh_places(Scene scene, const std::string& directory, const Change& changed) {
    const fs::path before = canonical_directory(directory);
    for (Object& object : scene.objects) {
        auto* named = std::get_if<MeshFile>(&object.source);
        if (named == nullptr || fs::path(named->path).is_absolute()) continue;
        const fs::path place = canonical_directory((before / named->path).parent_path());
        const fs::path path = changed(place) / fs::path(named->path).filename();
        if (!place.empty()) named->path = path.lexically_normal().generic_string();
    }
    return scene;
}

/// Returns the scene with the mesh paths that a file at `path` stores. They are relative. If `path` is a link
/// to a file in another directory, they are absolute, so that they are valid from both directories.
Scene with_mesh_paths_for(Scene scene, const std::string& mesh_dir, const std::string& path) {
    if (leads_elsewhere(path))
        return with_mesh_places(std::move(scene), mesh_dir, [](const fs::path& place) { return place; });
    return with_mesh_paths_from(std::move(scene), mesh_dir, directory_of(path));
}

void warn_of_hidden_colors(const Scene& scene, Warnings& warnings) {
    if (scene.shading.reflection == Reflection::None) return;
    const auto has_colors = [](const Object& o) { return !o.mesh->colors.empty(); };
    warn(warnings,
         static_cast<std::size_t>(std::count_if(scene.objects.begin(), scene.objects.end(), has_colors)),
         "object has vertex colours, which only the reflection \"none\" shows",
         "objects have vertex colours, which only the reflection \"none\" shows");
}

}  // namespace

std::string directory_of(const std::string& path) {
    return path == "-" ? "" : fs::path(path).parent_path().string();
}

std::string path_from(const std::string& mesh_dir, const std::string& path) {
    return (fs::path(mesh_dir) / path).string();
}

Scene with_mesh_paths_from(Scene scene, const std::string& old_directory, const std::string& new_directory) {
    const fs::path after = canonical_directory(new_directory);
    if (canonical_directory(old_directory) == after) return scene;
    return with_mesh_places(std::move(scene), old_directory,
                            [&after](const fs::path& place) { return place.lexically_relative(after); });
}

std::string carried_scene_text(const Scene& scene, const std::string& mesh_dir,
                               const std::string& picture_path) {
    return scene_text(with_mesh_paths_for(scene, mesh_dir, picture_path));
}

Result<SceneDocument> open_document(const std::string& path, const std::vector<Assignment>& assignments) {
    // Queried before reading, so that a write during the read counts as a change.
    const FileStamp stamp = path == "-" ? FileStamp{} : file_stamp(path);
    return result_of("", [&] {
        SceneDocument document = open_by_extension(path, assignments);
        document.stamp = stamp;
        document.assignments = assignments;
        warn_of_hidden_colors(document.scene, document.warnings);
        return document;
    });
}

std::optional<PictureSize> fitted_size_in(const std::string& path) {
    const Result<PngInfo> read = read_png_info(path, png_field_keyword, max_json_bytes);
    if (problem_of(read) != nullptr) return {};
    return fitted_size_of(*std::get<PngInfo>(read).text(png_field_keyword));
}

bool carries_scene(const std::string& path) {
    return problem_of(read_png_info(path, png_scene_keyword, max_json_bytes)) == nullptr;
}

Result<SceneDocument> save_document(const SceneDocument& document, const std::string& path) {
    if (path != "-" && lower_extension(path) != ".json")
        return Problem{path, "", "is not the name of a scene file", "the extension .json"};
    SceneDocument saved = document;
    saved.path = path;
    saved.mesh_dir = directory_of(path);
    saved.scene = with_mesh_paths_for(std::move(saved.scene), document.mesh_dir, path);
    const std::string text = scene_text(saved.scene);
    const Result<Scene> read_back = parse_scene(text, path);
    if (const Problem* problem = problem_of(read_back)) return *problem;
    if (!same_description(std::get<Scene>(read_back), saved.scene))
        return Problem{path, "", "a name in the scene is not UTF-8, so the file could not be read again",
                       "names in UTF-8"};
    const Result<std::monostate> written = write_file_at_once(path, text);
    if (const Problem* problem = problem_of(written)) return *problem;
    saved.stamp = file_stamp(path);
    return saved;
}

SceneVariants::SceneVariants(const SceneDocument& document)
    : document_(document), json_(read_json(scene_text(document.scene), document.path)) {}

Result<Scene> SceneVariants::with(const std::vector<Assignment>& assignments) const {
    return result_of("", [&] {
        Scene scene = value_or_throw(scene_of(json_, document_.path, assignments));
        (void)add_meshes(scene, document_.scene.objects, document_.path, document_.mesh_dir, assignments);
        return scene;
    });
}

Result<Scene> scene_variant(const SceneDocument& document, const std::vector<Assignment>& assignments) {
    return SceneVariants(document).with(assignments);
}

namespace {

struct Box {
    glm::dvec3 low{HUGE_VAL}, high{-HUGE_VAL};
    [[nodiscard]] glm::dvec3 middle() const { return (low + high) / 2.0; }
};

/// The bounds of all objects in world coordinates. Precondition: there is at least one object.
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
    warnings.push_back(fmt::format(
        "lights are {:.3g} times brighter at the centre of the scene than a display can show: all are "
        "divided by this factor",
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
                         : fmt::format("nothing in its scene can be drawn: {}", fmt::join(left_out, ", "));
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
            // The target is moved to the objects' distance, so that the camera orbits around the objects.
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
    return Problem{"", "", fmt::format("written as glTF, it could not be opened: {}{}", at, problem->what),
                   problem->expected};
}

}  // namespace glint
