// Checks the selected object's mesh in the background, and marks the positions of a finding in the picture.
#include "models/scene/scene.h"
#include "ui/feature.h"
#include "ui/fields/panels.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

const Object* selected_object(const UiState& state) {
    const Selection& selected = state.editor.selection;
    return selected.kind == Selection::Kind::Object
               ? &state.editor.scene().objects[static_cast<std::size_t>(selected.index)]
               : nullptr;
}

/// Checks the selected object's mesh once its panel requests it.
void poll_check(UiState& state) {
    MeshCheck& check = state.get<MeshCheck>();
    const Object* const object = selected_object(state);
    const MeshPtr mesh = object != nullptr ? object->mesh : nullptr;
    if (check.mesh != mesh) {
        leave(check.job, check.ending);
        check.mesh = mesh;
        check.info.reset();
        check.shown = -1;
    }
    if (check.job && check.job->done()) {
        Result<MeshInfo> found = check.job->take();
        check.info.emplace();
        if (const Problem* const problem = problem_of(found))
            check.info->findings.push_back({"", 1, "The check failed: " + problem->what, "", {}});
        else
            check.info = std::get<MeshInfo>(std::move(found));
        check.job.reset();
    }
    const bool wants = check.is_wanted && mesh != nullptr && !check.info && !check.job;
    if (wants && has_ended(check.ending))
        check.job = state.jobs.start<MeshInfo>("mesh", [mesh](LoadProgress&) { return mesh_info(*mesh); });
    if (wants || check.job) redraw_within(0.05);
    check.is_wanted = false;
    check.hovered = -1;
}

void draw_places(ImDrawList& list, UiState& state, const PictureView& view) {
    const MeshCheck& check = state.get<MeshCheck>();
    const Object* const object = selected_object(state);
    const int finding = check.hovered >= 0 ? check.hovered : check.shown;
    if (object == nullptr || !check.info || finding < 0) return;
    const glm::dmat4 to_world = world_from_object(object->transform);
    for (const glm::vec3& place : check.info->findings[static_cast<std::size_t>(finding)].places) {
        const ProjectedPoint at = project(view.map, glm::dvec3(to_world * glm::dvec4(place, 1)));
        if (at.in_front) rimmed_disc(list, view.to_window(at.pixel), 3.5f, to_u32(theme().warning));
    }
}

}  // namespace

extern const Feature mesh_check_feature;
const Feature mesh_check_feature{.end = poll_check, .overlay = draw_places};

}  // namespace glint
