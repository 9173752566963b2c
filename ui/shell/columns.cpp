#include "ui/shell/columns.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/fields/panels.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws the selected item's panel.
void selected_panel(UiState& state, const PictureView& view) {
    Scene& scene = state.editor.scene();
    const Selection& selection = state.editor.selection;
    const auto index = static_cast<std::size_t>(selection.index);
    const std::string number = std::to_string(selection.index);
    const Camera camera = scene.camera;
    ObjectRequests requests;
    requests.gizmo = state.viewport.gizmo;
    switch (selection.kind) {
    case Selection::Kind::Camera:
        camera_panel(scene.camera, view.map.size);
        break;
    case Selection::Kind::Light:
        light_panel(scene.lights[index], "/lights/" + number, scene.camera, view.dome, view.map);
        break;
    case Selection::Kind::Object:
        requests.about_mesh = highlight_words(state.get<HighlightShareState>(), scene, index, view.map.size);
        requests.check = &state.get<MeshCheck>();
        object_panel(scene.objects[index], "/objects/" + number, scene.shading.reflection, requests);
        break;
    case Selection::Kind::Shading:
        shading_panel(scene.shading, scene.transport, scene.global_ambient);
        npr_panel(scene.npr);
        break;
    case Selection::Kind::Display:
        display_panel(scene.display);
        break;
    }
    state.editor.edits_camera |= scene.camera != camera;
    state.viewport.gizmo = requests.gizmo;
    if (requests.browse_mesh) ask_mesh(state, selection.index);
}

std::string selected_title(const Scene& scene, const Selection& selection) {
    const auto index = static_cast<std::size_t>(selection.index);
    switch (selection.kind) {
    case Selection::Kind::Camera:
        return "Camera";
    case Selection::Kind::Light:
        return whole_label(scene.lights[index].name);
    case Selection::Kind::Object:
        return whole_label(scene.objects[index].name);
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
    bool browse_mesh = false;
    Scene& scene = state.editor.scene();
    const auto rows = static_cast<float>(5 + std::max<std::size_t>(scene.lights.size(), 1) +
                                         std::max<std::size_t>(scene.objects.size(), 1));
    const float all = rows * (ImGui::GetFrameHeight() + px(1)) + px(4);
    const float room = ImGui::GetContentRegionAvail().y;
    ImGui::BeginChild("##list", {0, std::min(all, 0.45f * room)});
    scene_panel(scene, state.editor.selection, state.get<LightFocus>(), browse_mesh);
    ImGui::EndChild();
    if (browse_mesh) ask_mesh(state, -1);
    ImGui::Separator();
    ImGui::PushFont(fonts().title);
    const ImVec2 low = ImGui::GetCursorScreenPos(),
                 title{ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()};
    cut_text(*ImGui::GetWindowDrawList(), low, low.x + title.x,
             selected_title(scene, state.editor.selection));
    ImGui::Dummy(title);
    ImGui::PopFont();
    // The selection is the panel's ID, so a field does not keep its focus for a different item, and each
    // panel has its own scroll position.
    ImGui::PushID(number_of(state.editor.selection));
    ImGui::BeginChild("##panel");
    if (std::exchange(state.types_into_panel, false)) {
        ImGui::SetWindowFocus();
        ImGui::SetKeyboardFocusHere();
    }
    selected_panel(state, view);
    ImGui::EndChild();
    ImGui::PopID();
}

void column_tab(const char* name, bool chosen, float width, bool& wanted) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme().field_active : theme().panel);
    if (ImGui::Button(name, {width, 0})) wanted = true;
    ImGui::PopStyleColor();
}

constexpr float caption_margin = 12;  // logical pixels, on both sides

std::string caption_of(const UiState& state) {
    if (!state.layout.caption || state.layout.hides_all) return {};
    for (const Feature* feature : features())
        if (feature->caption != nullptr)
            if (const std::optional<std::string> caption = feature->caption(state)) return *caption;
    return shown_scene(state).about;
}

float height_of(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.c_str(), nullptr, false, std::max(width, 1.0f)).y;
}

/// Returns the smallest width at which `text`, in ImGui's current font, takes no more lines than at `width`:
/// the lines are then about equally long, and no line is a single word. The result is at most `width`.
float even_width(const std::string& text, float width) {
    constexpr int halvings = 10;  // bisection steps, down to a width of one pixel
    const float lines = height_of(text, width);
    float too_narrow = 0, wide = width;
    for (int i = 0; i < halvings; ++i) {
        const float middle = (too_narrow + wide) / 2;
        (height_of(text, middle) <= lines ? wide : too_narrow) = middle;
    }
    return std::ceil(wide);
}

}  // namespace

const LeftColumn* open_column(const UiState& state) {
    for (const Feature* feature : features())
        if (feature->column.name != nullptr && feature->column.name(state) != nullptr)
            return &feature->column;
    return nullptr;
}

Layout window_layout(const UiState& state) {
    Layout layout = lay_out(ImGui::GetIO().DisplaySize, state.layout, px(1));
    const std::string caption = caption_of(state);
    if (caption.empty()) return layout;
    const float width = layout.centre.size().x - 2 * px(caption_margin);
    make_room_for_caption(layout, height_of(caption, width) + px(8));
    return layout;
}

void caption_line(const UiState& state, const Layout& layout) {
    if (!layout.has_caption) return;
    begin_area("##caption", layout.caption, ImGuiWindowFlags_NoNav);
    ImGui::SetCursorPos({px(caption_margin), px(2)});
    const std::string caption = caption_of(state);
    const float left = px(caption_margin);
    ImGui::PushTextWrapPos(left + even_width(caption, layout.caption.size().x - 2 * left));
    ImGui::TextUnformatted(caption.c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
}

namespace {

/// The parts of the left column, which has tabs if there are several.
enum class LeftPart { Feature, Scene, Why };

LeftPart left_part(const UiState& state, const Layout& layout) {
    const bool held = is_held(state);  // while held, nothing can be edited or picked
    if (layout.inspector_in_left && state.left_shows_inspector && !held) return LeftPart::Why;
    return state.layout.lesson && (held || !state.left_shows_scene) ? LeftPart::Feature : LeftPart::Scene;
}

void left_tabs(UiState& state, const Layout& layout, const LeftColumn* column) {
    const LeftPart shown = left_part(state, layout);
    const bool three = column != nullptr && layout.inspector_in_left;
    const auto tab = [&](const char* name, LeftPart part) {
        bool wanted = false;
        column_tab(name, shown == part, px(three ? 62 : 84), wanted);
        list_control(name, "tab", last_item());
        ImGui::SameLine(0, px(2));
        if (!wanted) return;
        state.left_shows_inspector = part == LeftPart::Why;
        state.left_shows_scene = part == LeftPart::Scene;
    };
    if (column != nullptr) tab(column->name(state), LeftPart::Feature);
    ImGui::BeginDisabled(is_held(state));
    tab("Scene", LeftPart::Scene);
    if (layout.inspector_in_left) tab("Why", LeftPart::Why);
    ImGui::EndDisabled();
    if (column == nullptr) return ImGui::NewLine();
    const float right = ImGui::GetWindowContentRegionMax().x, cross = ImGui::GetFrameHeight();
    if (column->button != nullptr) column->button(state, right - cross - px(4));
    ImGui::SameLine(right - cross);
    if (icon_button("##leave", Icon::Close)) column->close(state);
    tooltip("Leave", "Closes this column");
}

}  // namespace

void left_column(UiState& state, const Layout& layout, const PictureView& view) {
    if (!layout.has_left) return;
    begin_area("##left", layout.left);
    if (state.types_into_panel) state.left_shows_scene = true;
    const LeftColumn* column = open_column(state);
    if (column != nullptr || layout.inspector_in_left)
        left_tabs(state, layout, column);
    else
        column_heading("SCENE");
    column = open_column(state);  // the column may just have been closed
    switch (left_part(state, layout)) {
    case LeftPart::Feature:
        if (column != nullptr) column->draw(state);
        break;
    case LeftPart::Scene:
        scene_column(state, view);
        break;
    case LeftPart::Why:
        break;  // drawn after the picture: inspector_columns()
    }
    ImGui::End();
}

namespace {

/// Draws a note in place of the numbers, because they would reveal the answer.
void held_note() {
    ImGui::Dummy({0, px(8)});
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("First say what will happen");
    ImGui::PopFont();
    ImGui::Dummy({0, px(4)});
    wrapped_dim("Answer the lesson's question first. Then the numbers behind every pixel appear here.");
}

}  // namespace

void inspector_columns(UiState& state, const Layout& layout, const PictureView& view) {
    const bool in_left =
        layout.inspector_in_left && layout.has_left && left_part(state, layout) == LeftPart::Why;
    if (!layout.has_right && !in_left) return;
    if (in_left)
        resume_area("##left");
    else {
        begin_area("##right", layout.right);
        column_heading("WHY");
    }
    if (is_held(state))
        held_note();
    else
        for (const Feature* feature : features())
            if (feature->why != nullptr && !feature->why(state, view)) break;
    state.editor.selection = valid_selection(state.editor.selection, state.editor.scene());
    ImGui::End();
}

}  // namespace glint
