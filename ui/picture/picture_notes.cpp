#include "ui/picture/picture_notes.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>

#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/tabs.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/term_grid.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

using Kind = PictureNote::Kind;

/// A reason why the picture may differ. `name` is empty while it does not; `scene` is the one that is named.
struct Reason {
    Kind kind;
    std::string (*name)(const UiState& state, const Scene& scene);
    void (*end)(UiState& state);
    CommandId key = CommandId::None;
    bool stays = false;  // when another scene opens: that scene's own, or labelled elsewhere
};

std::string name_if(bool shows, const char* name) { return shows ? name : ""; }

bool is_preview(const UiState& state) {
    return state.get<InspectorState>().instead && !state.get<InspectorState>().instead_rests;
}

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

std::string debug_view(const DebugViewSet& set) {
    if (set.choice.view != DebugView::Picture) return std::string("View: ") + info_of(set.choice.view).label;
    return name_if(set.over_range, "Over-range stripes");
}

constexpr std::array reasons{
    Reason{Kind::Preview,
           [](const UiState& s, const Scene&) {
               const std::string& name = s.get<InspectorState>().preview_name;
               return is_preview(s) && !name.empty() ? "Preview: " + name : std::string();
           },
           nullptr},
    Reason{Kind::OtherScene,
           [](const UiState& s, const Scene&) {
               return name_if(s.get<LectureState>().frozen.has_value(), "Frozen picture");
           },
           [](UiState& s) { s.get<LectureState>().frozen.reset(); }, CommandId::Freeze},
    Reason{Kind::OtherScene,
           [](const UiState& s, const Scene&) {
               return name_if(s.get<AnimateState>().frame && !s.get<LectureState>().frozen, "Animation");
           },
           [](UiState& s) {
               s.get<AnimateState>().playing = false;
               s.get<AnimateState>().frame.reset();
           }},
    Reason{Kind::OtherScene, [](const UiState& s, const Scene&) { return kept_cells(s); },
           [](UiState& s) {
               s.get<TermGridState>().solo.reset();
               s.get<TermGridState>().muted.clear();
               s.get<InspectorState>().instead.reset();
           }},
    Reason{Kind::OtherScene,
           [](const UiState& s, const Scene&) {
               return name_if(
                   s.get<CompareState>().choice.shows_stored && column_has_turn(s) && !is_preview(s),
                   name_of_stored);
           },
           [](UiState& s) {
               s.get<CompareState>().choice.shows_stored = s.get<CompareState>().b_turned = false;
           },
           CommandId::ShowB},
    Reason{Kind::InScene, [](const UiState&, const Scene& scene) { return terms_off(scene.shading.terms); },
           [](UiState& s) { s.editor.scene().shading.terms = {}; }, CommandId::None, true},
    Reason{Kind::InScene,
           [](const UiState&, const Scene& scene) { return mistakes_text(scene.shading.mistakes); },
           [](UiState& s) { s.editor.scene().shading.mistakes = {}; }, CommandId::None, true},
    Reason{Kind::View,
           [](const UiState& s, const Scene&) {
               const CompareChoice& choice = s.get<CompareState>().choice;
               return name_if(choice.on, choice.difference ? "Difference" : "Comparison");
           },
           [](UiState& s) { s.get<CompareState>().choice.on = false; }, CommandId::Compare, true},
    Reason{Kind::View, [](const UiState& s, const Scene&) { return debug_view(s.get<DebugViewState>().set); },
           [](UiState& s) { s.get<DebugViewState>().set = {}; }},
};

std::vector<PictureNote> notes_about(const UiState& state, const Scene& scene) {
    std::vector<PictureNote> notes;
    for (const Reason& reason : reasons) {
        std::string name = reason.name(state, scene);
        // Of a frozen picture or B nothing is edited.
        const bool can_end = reason.kind != Kind::InScene || !is_out_of_hand(state);
        if (!name.empty())
            notes.push_back({reason.kind, std::move(name), can_end ? reason.end : nullptr, reason.key});
    }
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

/// A line of the badge. `width`: of its text, cut off where it is longer.
void badge_line(UiState& state, const PictureNote& note, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    cut_text(*ImGui::GetWindowDrawList(), low + ImVec2(0, ImGui::GetStyle().FramePadding.y), low.x + width,
             note.name);
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

void end_picture_notes(UiState& state) {
    for (const Reason& reason : reasons)
        if (reason.end != nullptr && !reason.stays) reason.end(state);
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

std::string kept_cells(const UiState& state) {
    const InspectorState& inspector = state.get<InspectorState>();
    const bool shows = column_has_turn(state) && inspector.instead && inspector.instead_rests;
    return shows ? inspector.preview_name : std::string();
}

void picture_badge(UiState& state, const Rect& picture) {
    const std::vector<PictureNote> notes = picture_notes(state);
    if (notes.empty() || is_held(state)) return;  // while a question waits they would give the answer away
    // Below the label of a comparison's first part.
    const float above = state.get<CompareState>().choice.on ? small_text_height() + px(20) : px(10);
    ImGui::SetNextWindowPos(picture.low + ImVec2(px(10), above));
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
    for (const PictureNote& note : notes) width = std::max(width, ImGui::CalcTextSize(note.name.c_str()).x);
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
