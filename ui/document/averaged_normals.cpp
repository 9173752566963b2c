#include "ui/document/averaged_normals.h"

#include <fmt/core.h>

#include "ui/ui.h"

namespace glint {

bool smooths_every_edge(const Object& object) {
    const NormalOptions& options = object.normals;
    return object.mesh && object.mesh->given_normals == GivenNormals::None &&
           options.source != NormalSource::Facet && options.crease_deg >= 180;
}

void say_averaged(UiState& state, const Object& object) {
    if (!smooths_every_edge(object)) return;
    state.notifications.add(
        Tone::Warning, fmt::format("{} has no normals: they are averaged over all edges, so that creases "
                                   "look smooth. Crease, in the object's panel, keeps edges sharp",
                                   short_name(object.source)));
}

void tell_averaged_normals(UiState& state) {
    const Scene& scene = state.editor.scene();
    const bool is_mesh = !state.editor.document.path.empty() && !state.editor.has_scene_file();
    if (!is_mesh || scene.objects.size() != 1) return;
    say_averaged(state, scene.objects.front());
    state.editor.selection = {Selection::Kind::Object, 0};
}

}  // namespace glint
