#include "ui/picture/picture_notes.h"

#include <imgui_internal.h>

#include <algorithm>

#include "ui/feature.h"
#include "ui/picture/screen.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Kind = PictureNote::Kind;

std::string terms_off(const Terms& terms) {
    std::string names;
    const auto add = [&names](bool on, const char* name) {
        if (!on) names.append(names.empty() ? "" : ", ").append(name);
    };
    add(terms.emission, "emission");
    add(terms.ambient, "ambient");
    add(terms.diffuse, "diffuse");
    add(terms.specular, "specular");
    return names.empty() ? names : "Off: " + names;
}

void add_other(std::vector<PictureNote>& notes, Kind kind, const std::optional<OtherScene>& other) {
    if (other && !other->note.empty()) notes.push_back({kind, other->note, other->end, other->key});
}

/// Returns the notes about the settings of `scene`.
std::vector<PictureNote> notes_about(const UiState& state, const Scene& scene) {
    std::vector<PictureNote> notes;
    const OnScreen& shown = state.on_screen;
    add_other(notes, Kind::Preview, shown.passing);
    if (!shown.passing) add_other(notes, Kind::OtherScene, shown.resting);
    if (shown.resting && shown.resting->is_partial)
        add_other(notes, Kind::OtherScene, resting_below(state, *shown.resting->by));
    if (const std::string off = terms_off(scene.shading.terms); !off.empty())
        notes.push_back({Kind::InScene, off, [](UiState& s) { s.editor.scene().shading.terms = {}; }});
    for (const Feature* feature : features())
        if (feature->note != nullptr)
            if (std::optional<PictureNote> note = feature->note(state, scene))
                notes.push_back(*std::move(note));
    for (PictureNote& note : notes)  // nothing can be edited in a frozen picture or in B
        if (note.kind == Kind::InScene && shown.is_out_of_hand()) note.end = nullptr;
    return notes;
}

FileNotes file_notes(const std::vector<PictureNote>& notes, bool of_shown) {
    FileNotes names;
    for (const PictureNote& note : notes) {
        const bool is_in = note.kind == Kind::InScene || (of_shown && note.kind == Kind::OtherScene);
        std::string& list = is_in ? names.in_file : names.left_out;
        list.append(list.empty() ? "" : ", ").append(note.name);
    }
    return names;
}

/// Draws a line of the badge. Text longer than `width` is cut off.
void badge_line(UiState& state, const PictureNote& note, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    cut_text(*ImGui::GetWindowDrawList(), low + ImVec2(0, ImGui::GetStyle().FramePadding.y), low.x + width,
             note.name + note.remark);
    ImGui::Dummy({width, height});
    list_control("On the picture", note.name, last_item());
    if (note.end == nullptr) return;
    ImGui::SameLine();
    if (icon_button("##end", Icon::Close)) {
        note.end(state);
        redraw_within(0);
    }
    tooltip(("End: " + note.name).c_str(), "Show the picture without it", "",
            note.key == CommandId::None ? std::string() : keys_of(note.key));
}

}  // namespace

std::vector<PictureNote> picture_notes(const UiState& state) {
    return notes_about(state, shown_scene(state));
}

FileNotes notes_of_shown(const UiState& state) { return file_notes(picture_notes(state), true); }
FileNotes notes_of_edited(const UiState& state) {
    return file_notes(notes_about(state, state.editor.scene()), false);
}

Notification file_message(const std::string& what, const FileNotes& notes) {
    std::string text = what;
    if (!notes.in_file.empty()) text += ": " + notes.in_file;
    if (notes.left_out.empty()) return {Tone::Done, text};
    return {Tone::Warning, text + ". Not in the file: " + notes.left_out};
}

std::string file_warning(const FileNotes& notes) {
    if (notes.in_file.empty()) return notes.left_out.empty() ? "" : "Not in the file: " + notes.left_out;
    return file_message("With", notes).text;
}

void picture_badge(UiState& state, const Rect& picture) {
    const std::vector<PictureNote> notes = picture_notes(state);
    if (notes.empty() || is_held(state)) return;  // the notes would reveal the answer to a question
    // Placed below the label of a comparison's first part.
    ImGui::SetNextWindowPos(picture.low + ImVec2(px(10), px(10) + state.label_height));
    ImGui::SetNextWindowBgAlpha(0.88f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, px(1) * ImVec2(8, 4));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, px(1) * ImVec2(2, 3));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, px(1) * ImVec2(6, 1));
    ImGui::Begin("##badge", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    if (ImGuiWindow* dialog = ImGui::GetTopMostPopupModal())
        ImGui::BringWindowToDisplayBehind(ImGui::GetCurrentWindow(), dialog);
    float width = 0;
    for (const PictureNote& note : notes)
        width = std::max(width, ImGui::CalcTextSize((note.name + note.remark).c_str()).x);
    width = std::clamp(width, px(20), std::max(picture.size().x - px(70), px(20)));
    for (std::size_t i = 0; i < notes.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        badge_line(state, notes[i], width);
        ImGui::PopID();
    }
    ImGui::End();
    ImGui::PopStyleVar(4);
}

}  // namespace glint
