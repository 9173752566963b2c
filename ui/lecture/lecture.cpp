#include "ui/lecture/lecture.h"

#include <filesystem>

#include "ui/commands/actions.h"
#include "ui/lecture/folder_scenes.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

/// From a scene without a file: through those that come with the program.
std::string other_scene(const UiState& state, int step) {
    const std::string& path = state.editor.document.path;
    if (!path.empty() && path != "-") return scene_beside(path, step);
    const auto scenes = folder_scenes(state.shipped_scenes);
    if (state.shipped_scenes.empty() || scenes.empty()) return {};
    return step > 0 ? scenes.front() : scenes.back();
}

void open_other(UiState& state, int step) {
    const std::string path = other_scene(state, step);
    if (path.empty()) return;
    begin_pending(state, {Pending::What::Open, path, false});
}

void switch_projector(UiState& state) {
    LectureState& lecture = state.lecture;
    lecture.projector = !lecture.projector;
    if (lecture.projector) lecture.folded_before = state.layout.folded;
    state.layout.folded = lecture.projector || lecture.folded_before;
}

void switch_frozen(UiState& state) {
    auto& frozen = state.lecture.frozen;
    if (frozen)
        frozen.reset();
    else
        frozen = state.drawn;
}

}  // namespace

void run_lecture_action(UiState& state, Action action) {
    LectureState& lecture = state.lecture;
    switch (action) {
    case Action::Projector:
        return switch_projector(state);
    case Action::CleanFeed:
        state.layout.bare = !state.layout.bare;
        return;
    case Action::Freeze:
        return switch_frozen(state);
    case Action::Pen:
        lecture.pen.on = !lecture.pen.on;
        return;
    case Action::WipePen:
        lecture.pen.lines.clear();
        return;
    case Action::NextScene:
        return open_other(state, 1);
    case Action::PreviousScene:
        return open_other(state, -1);
    case Action::StepWedge:
        lecture.wedge.open = !lecture.wedge.open;
        return;
    case Action::Animate:
        state.animate.open = !state.animate.open;
        state.animate.playing &= state.animate.open;
        return;
    default:
        return;
    }
}

std::string lecture_why_not(const UiState& state, Action action) {
    switch (action) {
    case Action::WipePen:
        return state.lecture.pen.lines.empty() ? "Nothing is drawn" : "";
    case Action::Freeze:
        return state.picture == nullptr ? "There is no picture yet" : "";
    default:
        return {};
    }
}

std::optional<bool> lecture_is_on(const UiState& state, Action action) {
    const LectureState& lecture = state.lecture;
    switch (action) {
    case Action::Projector:
        return lecture.projector;
    case Action::CleanFeed:
        return state.layout.bare;
    case Action::Freeze:
        return lecture.frozen.has_value();
    case Action::Pen:
        return lecture.pen.on;
    case Action::StepWedge:
        return lecture.wedge.open;
    case Action::Animate:
        return state.animate.open;
    default:
        return {};
    }
}

bool leave_lecture_tool(UiState& state) {
    LectureState& lecture = state.lecture;
    if (lecture.wedge.open) return !(lecture.wedge.open = false);
    if (lecture.pen.on) return !(lecture.pen.on = false);
    if (state.layout.bare) return !(state.layout.bare = false);
    return false;
}

void keep_frozen(UiState& state) {
    const auto& frozen = state.lecture.frozen;
    if (!frozen) return;
    state.preview = *frozen;
}

void frozen_badge(ImDrawList& list, const LectureState& lecture, const PictureView& view) {
    if (!lecture.frozen) return;
    const char* text = "Frozen (F8)";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 low{view.origin.x + px(10), view.origin.y + px(10)};
    list.AddRectFilled(low, {low.x + size.x + px(16), low.y + size.y + px(8)}, packed(theme().window, 0.85f),
                       px(6));
    list.AddText({low.x + px(8), low.y + px(4)}, packed(theme().text), text);
}

}  // namespace glint
