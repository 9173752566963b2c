// The tab "Program": the scene as calls of fixed-function OpenGL, alive.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "models/scene/mistakes.h"
#include "renderer/inspect/explain/printed_number.h"
#include "renderer/programs/gl_calls.h"
#include "ui/diagnosis/my_picture.h"
#include "ui/export/clipboard.h"
#include "ui/inspector/equation/number_handle.h"
#include "ui/inspector/equation/text_line.h"
#include "ui/inspector/mistake_row.h"
#include "ui/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Where a group begins at "/lights/3" or "/objects/0/material": which light or object; -1 where it is
/// neither.
int item_of(std::string_view pointer, std::string_view list) {
    if (!pointer.starts_with(list)) return -1;
    return std::atoi(std::string(pointer.substr(list.size())).c_str());
}

/// What a call sets is lit up in the picture: a light shines alone, an object glows.
void light_up(UiState& state, const std::string& about) {
    constexpr glm::vec3 glow{0.3f, 0.22f, 0};
    Scene scene = state.editor.scene();
    if (const int light = item_of(about, "/lights/"); light >= 0)
        return show_instead(state, with_light_alone(scene, light),
                            scene.lights[static_cast<std::size_t>(light)].name + " alone");
    if (about == "/global_ambient")
        return show_instead(state, with_term_alone(scene, Symbol::Ambient), "Ambient light alone");
    const int index = item_of(about, "/objects/");
    if (index < 0) return;
    Object& object = scene.objects[static_cast<std::size_t>(index)];
    object.material.emission += glow;
    scene.shading.terms.emission = true;
    show_instead(state, scene, object.name);
}

/// So many decimals as the number is written with.
int decimals_of(const std::string& text) {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

/// What is taken hold of to move a light's place past gluLookAt().
void grip(UiState& state, int light_index) {
    Light& light = state.editor.scene().lights[static_cast<std::size_t>(light_index)];
    const float edge = TextLine::height();
    ImGui::PushID(light_index);
    (void)hit_area("##grip", {0.8f * edge, edge});
    ImGui::PopID();
    const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    const auto [low, high] = last_item();
    if (held || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const ImU32 ink = to_u32(held || hovered ? theme().text : theme().dim_text);
    for (const float y : {0.32f, 0.5f, 0.68f})
        ImGui::GetWindowDrawList()->AddLine({low.x + 0.15f * edge, low.y + y * edge},
                                            {high.x - 0.2f * edge, low.y + y * edge}, ink, px(1.2f));
    const std::string what = light.space == LightSpace::Camera
                                 ? "Before gluLookAt: its numbers are camera coordinates"
                                 : "After gluLookAt: its numbers are world coordinates";
    tooltip("Drag past gluLookAt", what.c_str(), "Its numbers stay, and mean another place",
            fmt::format("/lights/{}/space", light_index));
    list_control(fmt::format("grip of light {}", light_index).c_str(), "", {low, high});
    if (!held) return;
    const float y = ImGui::GetIO().MousePos.y, line = state.inspector.look_at_y;
    if (light.space == LightSpace::Camera && y > line + edge) light.space = LightSpace::World;
    if (light.space == LightSpace::World && y < line) light.space = LightSpace::Camera;
}

/// Word by word: a line goes on in the next one between any two.
void words(TextLine& line, const std::string& text, const ImVec4& colour) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t space = text.find(' ', at);
        const std::size_t end = space == std::string::npos ? text.size() : space + 1;
        line.code(text.substr(at, end - at), colour);
        at = end;
    }
}

void draw_call(UiState& state, const GlCall& call) {
    Scene& scene = state.editor.scene();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (call.place_of_light >= 0 && call.pieces.front().text.find("GL_POSITION") != std::string::npos) {
        grip(state, call.place_of_light);
        ImGui::SameLine(0, 0);
    }
    TextLine line(22);
    line.copied_as(call_text(call));
    for (const CallPiece& piece : call.pieces) {
        if (piece.pointer.empty()) {
            words(line, piece.text, call.is_remark ? theme().warning : theme().dim_text);
            continue;
        }
        NumberHandle number = number_handle(scene, piece.pointer);
        number.number.kind.format = decimal_format(number.number.value, std::max(decimals_of(piece.text), 1));
        (void)line.handle(number, theme().text);
    }
    const Rect area{low, {low.x + ImGui::GetContentRegionAvail().x, last_item().high.y}};
    if (call.is_look_at) state.inspector.look_at_y = low.y;
    if (!ImGui::IsAnyMouseDown() && is_pointed_at(area)) light_up(state, call.about);
}

/// A light whose numbers were meant in the other coordinates when the scene was opened or saved: what the
/// mistake "light in wrong space" does.
void wrong_space_notes(UiState& state) {
    const Scene& now = state.editor.scene();
    const Scene& saved = state.editor.saved;
    for (std::size_t i = 0; i < std::min(now.lights.size(), saved.lights.size()); ++i) {
        const Light &light = now.lights[i], &before = saved.lights[i];
        if (light.space == before.space || light.position != before.position) continue;
        const bool camera = light.space == LightSpace::Camera;
        wrapped_dim(fmt::format("The numbers of {} were {} coordinates and are taken for {} ones.",
                                light.name, camera ? "world" : "camera", camera ? "camera" : "world"));
        const auto names = mistake_names();
        const auto row = std::find_if(names.begin(), names.end(),
                                      [](const MistakeName& m) { return m.name == "light_in_wrong_space"; });
        const std::string label = "Mistake: " + title_of(*row);
        if (ImGui::SmallButton(label.c_str())) state.inspector.tab = InspectorTab::Mistakes;
        tooltip(label.c_str(), std::string(row->what).c_str(), "Click for all mistakes");
    }
}

bool is_open_at_first(const UiState& state, const GlCallGroup& group) {
    const Selection& chosen = state.editor.selection;
    return group.about.empty() ||
           (chosen.kind == Selection::Kind::Light && item_of(group.about, "/lights/") == chosen.index) ||
           (chosen.kind == Selection::Kind::Object && item_of(group.about, "/objects/") == chosen.index);
}

}  // namespace

void program_tab(UiState& state, const PictureView&) {
    const std::vector<GlCallGroup> groups = gl_calls(state.editor.scene());
    if (ImGui::SmallButton("Copy")) {
        std::string text;
        for (const GlCallGroup& group : groups) {
            text += "// " + group.title + "\n";
            for (const GlCall& call : group.calls) text += call_text(call) + "\n";
        }
        ImGui::SetClipboardText(text.c_str());
        state.notifications.tell("The calls are in the clipboard");
    }
    tooltip("Copy all calls", "A whole program, to be compiled: glint code FILE --language glsl -o FOLDER");
    for (std::size_t i = 0; i < groups.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (fold(groups[i].title.c_str(), is_open_at_first(state, groups[i]))) {
            for (const GlCall& call : groups[i].calls) draw_call(state, call);
            if (groups[i].about.empty()) wrong_space_notes(state);
        }
        ImGui::PopID();
    }
}

}  // namespace glint
