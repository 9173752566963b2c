#include "ui/picture/camera_actions.h"

#include "ui/picture/camera_views.h"
#include "ui/picture/handles/light_place.h"
#include "ui/picture/orbit.h"

namespace glint {
namespace {

void look(UiState& state, const Camera& camera) {
    Scene& scene = state.editor.scene();
    const Camera before = scene.camera;
    scene.camera = camera;
    keep_depth_range(scene.camera, before, scene_bounds(scene));
}

std::optional<ViewFrom> side_of(Action action) {
    switch (action) {
    case Action::ViewFront:
        return ViewFrom::Front;
    case Action::ViewBack:
        return ViewFrom::Back;
    case Action::ViewRight:
        return ViewFrom::Right;
    case Action::ViewLeft:
        return ViewFrom::Left;
    case Action::ViewTop:
        return ViewFrom::Top;
    case Action::ViewBottom:
        return ViewFrom::Bottom;
    default:
        return {};
    }
}

}  // namespace

bool run_camera_action(UiState& state, Action action) {
    Camera& camera = state.editor.scene().camera;
    if (const auto side = side_of(action)) {
        look(state, seen_from(camera, *side));
        return true;
    }
    switch (action) {
    case Action::SwitchProjection:
        if (state.picture != nullptr) camera = other_projection(camera, state.picture->size);
        return true;
    case Action::SavedCamera:
        camera = state.editor.saved.camera;
        return true;
    case Action::KeepView:
        keep_view(state.kept_views, camera);
        state.notifications.add(Tone::Done, "This view is kept until the window closes: U comes back to it");
        return true;
    case Action::NextView:
        if (const auto view = next_view(state.kept_views, camera)) camera = *view;
        return true;
    default:
        return false;
    }
}

}  // namespace glint
