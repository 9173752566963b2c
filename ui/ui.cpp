#include "ui/ui.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/actions.h"
#include "ui/animate/animate.h"
#include "ui/camera_panel.h"
#include "ui/dialogs.h"
#include "ui/fonts.h"
#include "ui/light_panel.h"
#include "ui/npr_panel.h"
#include "ui/object_panel.h"
#include "ui/scene_panel.h"
#include "ui/shading_panel.h"
#include "ui/theme.h"
#include "ui/toolbar.h"
#include "ui/views/views.h"
#include "ui/why/asked.h"
#include "ui/why/tabs.h"
#include "ui/why/vectors_overlay.h"
#include "ui/widgets.h"

namespace glint {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Where the picture goes and how large it is in real pixels.
PictureView picture_view(const Rect& centre, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const float dots = std::max(ImGui::GetIO().DisplayFramebufferScale.x, 0.1f);
    const Rect area = picture_area(centre, px(1));
    const ImVec2 room = area.size();
    const auto pixels = [dots](float units) { return std::clamp(static_cast<int>(units * dots), 1, 16384); };
    PictureView view;
    view.origin = area.low;
    view.units_per_pixel = 1 / dots;
    view.map = screen_map(scene.camera, {pixels(room.x), pixels(room.y)});
    view.bounds = scene_bounds(scene);
    view.dome = sun_dome(scene.camera.target, view.bounds, view.map);
    magnify(view, area, state.views.magnifier);
    return view;
}

void begin_column(const char* id, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin(id, nullptr, fixed);
}

/// The picture and what a hand does on it. True while a gesture has the scene in hand.
bool viewport(UiState& state, const Layout& layout, const UiInput& input, ImTextureID texture) {
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme().surround);
    begin_column("##view", layout.centre);
    ImGui::PopStyleColor();
    const PictureView view = picture_view(layout.centre, state);
    const ImVec2 high = view.to_window({view.map.size.width, view.map.size.height});
    ImGui::GetWindowDrawList()->AddImage(texture, view.origin, high);
    // Magnified, the picture goes on behind the columns.
    const ImVec2 low{std::max(view.origin.x, layout.centre.low.x),
                     std::max(view.origin.y, layout.centre.low.y)};
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton(
        "##picture",
        {std::min(high.x, layout.centre.high.x) - low.x, std::min(high.y, layout.centre.high.y) - low.y},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
            ImGuiButtonFlags_MouseButtonMiddle);
    const Renderer* renderer =
        state.picture != nullptr && state.picture->size == view.map.size ? state.renderer.get() : nullptr;
    if (state.viewport.gesture == Gesture::None &&
        (pen_hand(state.lecture.pen, view) || views_hand(state, view))) {
        state.viewport.hovered = false;
        state.viewport.hovered_grip = {};
        state.viewport.touched |= ImGui::IsAnyMouseDown();
        ImGui::End();
        return false;
    }
    const bool busy = viewport_gestures(
        state.viewport, {state.editor.scene(), state.editor.selection, renderer, view}, input);
    ImGui::End();
    return busy;
}

/// Puts the selected item's panel on the screen.
void selected_panel(UiState& state, const PictureView& view) {
    Scene& scene = state.editor.scene();
    const Selection& selection = state.editor.selection;
    const auto index = static_cast<std::size_t>(selection.index);
    const std::string number = std::to_string(selection.index);
    ObjectWishes wishes;
    wishes.gizmo = state.viewport.gizmo;
    switch (selection.kind) {
    case Selection::Kind::Camera:
        (void)camera_panel(scene.camera, view.map.size);
        break;
    case Selection::Kind::Light:
        (void)light_panel(scene.lights[index], "/lights/" + number, scene.camera, view.dome, view.map);
        break;
    case Selection::Kind::Object:
        (void)object_panel(scene.objects[index], "/objects/" + number, scene.shading.reflection, wishes);
        break;
    case Selection::Kind::Shading:
        (void)shading_panel(scene.shading, scene.global_ambient);
        (void)npr_panel(scene.npr);
        break;
    case Selection::Kind::Display:
        (void)display_panel(scene.display);
        break;
    }
    state.viewport.gizmo = wishes.gizmo;
    if (wishes.browse_mesh) {
        state.mesh_for_object = selection.index;
        state.files.ask(FilePurpose::OpenMesh, state.editor.document.path);
    }
}

std::string selected_title(const Scene& scene, const Selection& selection) {
    const auto index = static_cast<std::size_t>(selection.index);
    switch (selection.kind) {
    case Selection::Kind::Camera:
        return "Camera";
    case Selection::Kind::Light:
        return scene.lights[index].name;
    case Selection::Kind::Object:
        return scene.objects[index].name;
    case Selection::Kind::Shading:
        return "Shading";
    case Selection::Kind::Display:
        return "Display";
    }
    return {};  // not reached
}

void column_heading(const char* name) {
    ImGui::PushFont(fonts().small);
    dim_text(name);
    ImGui::PopFont();
}

void scene_column(UiState& state, const PictureView& view) {
    SceneWishes wishes;
    Scene& scene = state.editor.scene();
    const auto rows = static_cast<float>(5 + std::max<std::size_t>(scene.lights.size(), 1) +
                                         std::max<std::size_t>(scene.objects.size(), 1));
    const float all = rows * (ImGui::GetFrameHeight() + px(1)) + px(4);
    const float room = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("##list", {0, std::min(all, 0.45f * room)});
    (void)scene_panel(scene, state.editor.selection, wishes);
    ImGui::EndChild();
    if (wishes.browse_mesh) {
        state.mesh_for_object = -1;
        state.files.ask(FilePurpose::OpenMesh, state.editor.document.path);
    }
    ImGui::Separator();
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted(selected_title(scene, state.editor.selection).c_str());
    ImGui::PopFont();
    ImGui::BeginChild("##panel");
    // What is edited is told apart by the selection, so that no field keeps its focus for another item.
    ImGui::PushID(static_cast<int>(state.editor.selection.kind) * 100'000 + state.editor.selection.index);
    selected_panel(state, view);
    ImGui::PopID();
    ImGui::EndChild();
}

void column_tab(const char* name, bool chosen, bool& wanted) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme().field_active : theme().panel);
    if (ImGui::Button(name, {px(84), 0})) wanted = true;
    ImGui::PopStyleColor();
}

void left_column(UiState& state, const Layout& layout, const PictureView& view) {
    if (!layout.has_left) return;
    begin_column("##left", layout.left);
    if (layout.why_in_left) {
        bool scene = false, why = false;
        column_tab("Scene", !state.left_shows_why, scene);
        ImGui::SameLine(0, px(2));
        column_tab("Why", state.left_shows_why, why);
        if (scene || why) state.left_shows_why = why;
    }
    if (!layout.why_in_left) column_heading("SCENE");
    if (!layout.why_in_left || !state.left_shows_why) scene_column(state, view);
    ImGui::End();
}

/// WHY is drawn after the picture, so that its numbers are of the picture on the screen.
void why_columns(UiState& state, const Layout& layout, const PictureView& view) {
    const bool in_left = layout.why_in_left && layout.has_left && state.left_shows_why;
    if (!layout.has_right && !in_left) return;
    if (in_left)
        ImGui::Begin("##left", nullptr, fixed);
    else {
        begin_column("##right", layout.right);
        column_heading("WHY");
    }
    why_column(state, view);
    state.editor.selection = valid_selection(state.editor.selection, state.editor.scene());
    ImGui::End();
}

/// Whether a smaller picture may stand for the whole one for a moment: nothing is read off its pixels.
bool may_be_small(const UiState& state) {
    const bool camera = state.viewport.gesture == Gesture::Orbit || state.viewport.gesture == Gesture::Pan ||
                        state.viewport.gesture == Gesture::Dolly;
    const bool light =
        state.viewport.gesture == Gesture::Hand && state.viewport.held.grip.kind == GripKind::Light;
    const bool field = state.viewport.gesture == Gesture::None && ImGui::IsAnyItemActive();
    return (camera || light || field) && !state.viewport.probe && !state.preview &&
           !views_need_linear(state.views) && (state.shown == nullptr || state.shown == state.picture);
}

/// The size of the next picture of a scene that differs (`changed`) from the last one or does not.
PictureSize paced_size(UiState& state, PictureSize full, bool changed) {
    FramePace& pace = state.pace;
    const bool small_now = state.picture != nullptr && !(state.picture->size == full);
    if (!may_be_small(state)) {
        end_of_motion(pace);
        return full;
    }
    if (changed) {
        pace.rests_since = ImGui::GetTime();
        return divided(full, pace.divisor);
    }
    const double rest = pace.rests_since + rest_before_full - ImGui::GetTime();
    if (!small_now || rest <= 0) return full;
    wish_frame_in(rest);
    return state.picture->size;
}

/// Draws what shows (the edited scene or a preview) if it, or the size, is not that of the last picture; then
/// asks the edited scene about the probe.
void draw_picture(UiState& state, const PictureView& view) {
    tend_loads(state);
    if (const auto problem = settle(state.editor)) state.notifications.add(*problem);
    const bool moves = may_be_small(state);
    const bool changed = !(state.drawn == (state.preview ? *state.preview : state.editor.scene()));
    const PictureSize size = paced_size(state, view.map.size, changed);
    const std::optional<Scene> preview = std::exchange(state.preview, std::nullopt);
    const Scene& shown = preview ? *preview : state.editor.scene();
    const bool same_size = state.picture != nullptr && state.picture->size == size;
    const bool linear = views_need_linear(state.views);
    const bool has_linear = state.picture != nullptr && !state.picture->linear.empty();
    if (!same_size || changed || (linear && !has_linear)) {
        state.picture = &state.renderer->render(shown, size, linear);
        state.drawn = shown;
        ++state.picture_serial;
        if (moves && changed)
            picture_took(state.pace, size == view.map.size ? 1 : state.pace.divisor,
                         state.renderer->stats().total_ms);
    }
    if (preview) return;
    state.why.reset();
    if (!(size == view.map.size)) return;
    if (const auto pixel = asked_pixel(state, view)) state.why = state.renderer->explain(pixel->x, pixel->y);
}

void first_hints(const UiState& state, const PictureView& view) {
    if (state.viewport.touched) return;
    const char* text =
        "Drag a light or a highlight   ·   Click a pixel to ask why   ·   Drag elsewhere to orbit";
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float middle = view.origin.x + float(view.map.size.width) * view.units_per_pixel / 2;
    const float bottom = view.origin.y + float(view.map.size.height) * view.units_per_pixel - px(18);
    const ImVec2 low{middle - size.x / 2 - px(14), bottom - size.y - px(12)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {middle + size.x / 2 + px(14), bottom}, packed(theme().window, 0.85f), px(14));
    list.AddText({low.x + px(14), low.y + px(6)}, packed(theme().text), text);
}

void overlay(UiState& state, const Layout& layout, const PictureView& view) {
    ImGui::Begin("##view", nullptr, fixed);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high = view.to_window({view.map.size.width, view.map.size.height});
    list.PushClipRect(view.origin, high, true);
    if (!state.layout.bare) {
        const bool whole = state.picture->size == view.map.size;
        draw_overlay(
            list, state.viewport,
            {state.editor.scene(), state.editor.selection, whole ? state.renderer.get() : nullptr, view});
        draw_views_overlay(list, state, view);
        draw_point_vectors(list, state, view);
        first_hints(state, view);
        frozen_badge(list, state.lecture, view);
    }
    draw_pen(list, state.lecture.pen, view);
    list.PopClipRect();
    ImGui::End();
    pen_bar(state.lecture.pen, view);
    draw_notifications(state.notifications, {layout.centre.high.x - px(18), layout.centre.high.y - px(18)},
                       layout.centre.size().x - px(36));
}

/// One undo step when nothing has the scene in hand any more.
void remember(UiState& state, bool in_hand) {
    if (in_hand || ImGui::IsAnyItemActive() || awaits_mesh(state)) return;
    state.editor.history.commit(state.editor.scene(), state.viewport.wheel_goes_on);
}

UiRequests requests(UiState& state) {
    UiRequests wants;
    wants.quit = state.quits;
    state.quits = false;
    wants.title = fmt::format("{}{} – Glint", state.editor.unsaved() ? "● " : "", state.editor.title());
    wants.sleep_s = frame_wish();
    const Scene& next = state.preview ? *state.preview : state.editor.scene();
    if (!(next == state.drawn)) wants.sleep_s = 0;  // edited or previewed after the picture was drawn
    if (ImGui::GetIO().WantTextInput) wants.sleep_s = std::min(wants.sleep_s, 0.3);  // the text cursor blinks
    return wants;
}

}  // namespace

UiRequests ui_frame(UiState& state, const UiInput& input, ImTextureID texture) {
    frame_wish_reset();
    if (input.close_asked) run_action(state, Action::Quit);
    take_dropped(state, input);
    run_keys(state, input);
    close_left_dialogs(state);
    ImGui::PushFont(fonts().body);
    begin_views(state);
    const Layout layout = lay_out(ImGui::GetIO().DisplaySize, state.layout, px(1));
    if (!state.layout.bare) toolbar(state, layout.top);
    const bool in_hand = viewport(state, layout, input, texture);
    state.left_shows_why |= state.viewport.asked;
    left_column(state, layout, picture_view(layout.centre, state));
    dialogs(state, input);
    const PictureView view = picture_view(layout.centre, state);
    draw_picture(state, view);
    update_views(state);
    overlay(state, layout, picture_view(layout.centre, state));
    why_columns(state, layout, view);
    views_windows(state, layout);
    column_edges(state.layout, layout, px(1));
    loading_panel(state);
    recovery_panel(state);
    if (!state.layout.bare) status_line(state, layout.status);
    animate_panel(state);
    step_wedge(state.lecture.wedge);
    remember(state, in_hand);
    tend_memory(state);
    tend_animation(state);
    keep_frozen(state);
    ImGui::PopFont();
    return requests(state);
}

}  // namespace glint
