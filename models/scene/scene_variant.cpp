#include "models/scene/scene_variant.h"

#include <algorithm>
#include <utility>

#include "models/scene_file/scene_set.h"

namespace glint {

Result<Scene> scene_variant(const SceneDocument& document, const std::vector<Assignment>& assignments) {
    Result<Scene> parsed = parse_scene(scene_text(document.scene), document.path, assignments);
    if (problem_of(parsed)) return parsed;
    Scene scene = std::get<Scene>(std::move(parsed));
    const std::vector<Object>& loaded = document.scene.objects;
    for (Object& object : scene.objects) {
        const auto same = std::find_if(loaded.begin(), loaded.end(),
                                       [&](const Object& o) { return o.source == object.source; });
        if (same != loaded.end()) object.mesh = same->mesh;
    }
    const Result<Warnings> warned = load_meshes(scene, document.path, document.mesh_dir);
    if (const Problem* found = problem_of(warned)) {
        Problem problem = *found;
        if (is_assigned(problem.pointer, assignments)) problem.file = "--set";
        return problem;
    }
    return scene;
}

}  // namespace glint
