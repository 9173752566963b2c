#include "ui/features/games/match.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/lessons/prose.h"
#include "ui/features/views/compare_view.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Returns the scene as seen by the target's camera.
Scene seen_as_target(const MatchState& match, Scene scene) {
    scene.camera = match.task.target.camera;
    return scene;
}

double distance_to_target(MatchState& match, const Scene& scene) {
    const Picture& picture = match.renderer->render(seen_as_target(match, scene), match_size);
    return apart_of(picture, match.target);
}

bool has_target_as_b(const MatchState& match, const CompareChoice& choice) {
    return choice.stored && *choice.stored == match.task.target;
}

void show_beside(UiState& state, bool beside) {
    CompareChoice& choice = state.get<CompareState>().choice;
    choice.on = beside;
    if (!beside) return;
    choice.stored = std::make_shared<const Scene>(state.get<MatchState>().task.target);
    choice.shows_stored = choice.difference = false;
    set_parts(choice, {{}, {Variant::Kind::Stored, 0}});
}

void ask_to_begin(UiState& state, std::uint64_t seed) {
    ask_first(state, [seed](UiState& s) { begin_match(s, seed); });
}

/// A seed different from the last one, so that repeating the command starts another game.
void new_match(UiState& state) {
    const MatchState& match = state.get<MatchState>();
    ask_to_begin(state, match.seed + (match.on ? 1 : 0));
}

/// A bar that shrinks to the left as the scene gets closer to the target.
void distance_bar(const MatchState& match) {
    const float share = match.first > 0 ? std::min(float(match.now / match.first), 1.0f) : 0;
    const ImVec2 low = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, px(8)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + size, to_u32(theme().line), px(4));
    const ImVec4& colour = match.now <= match_tolerance ? theme().accent : theme().warning;
    list.AddRectFilled(low, {low.x + std::max(share * size.x, px(8)), low.y + size.y}, to_u32(colour), px(4));
    ImGui::Dummy(size);
    ImGui::PushFont(fonts().heading);
    coloured(colour, fmt::format("{:.1f}", match.now));
    ImGui::PopFont();
    ImGui::SameLine(0, px(8));
    dim_text("of 255 levels apart");
    list_control("How far apart", "", last_item());
}

void target_picture(const MatchState& match) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size{width, width * float(match_size.height) / float(match_size.width)};
    match.sheet.draw(*ImGui::GetWindowDrawList(), 0, low, low + size);
    ImGui::Dummy(size);
    list_control("The target", "", last_item());
}

void hint(MatchState& match, const Scene& scene) {
    if (!match.shows_hint) {
        if (ImGui::Button("A hint")) match.shows_hint = true;
        return tooltip("A hint", "Which term differs most");
    }
    if (match.hint.empty())
        match.hint = match_hint(*match.renderer, seen_as_target(match, scene), match.task.target);
    prose_line(match.hint);
}

}  // namespace

void begin_match(UiState& state, std::uint64_t seed) {
    constexpr int columns = 1, pictures = 1;
    MatchTask task = match_task(seed);
    SceneDocument document;
    document.scene = task.start;
    cancel_loads(state);
    take_scene(state, std::move(document));
    MatchState& match = state.get<MatchState>();
    match.stored_before = state.get<CompareState>().choice.stored;
    borrow_comparison(state.get<CompareState>());
    put_away(state);
    ask_about(state.viewport, {});
    match.task = std::move(task);
    match.seed = seed;
    if (!match.renderer) match.renderer = std::make_unique<Renderer>(1);
    match.target = match.renderer->render(match.task.target, match_size);
    match.sheet.reset(match_size, columns, pictures);
    match.sheet.put(0, match.target);
    match.first = match.now = distance_to_target(match, match.task.start);
    match.asked_of = match.task.start;
    match.solved = match.shows_hint = false;
    match.hint.clear();
    match.on = true;
    state.left_shows_scene = state.left_shows_inspector = false;
    show_beside(state, false);
}

void end_match(UiState& state) {
    MatchState& match = state.get<MatchState>();
    if (!match.on) return;
    match.on = false;
    CompareChoice& choice = state.get<CompareState>().choice;
    if (has_target_as_b(match, choice)) {  // the comparison ends with its game
        choice.stored = match.stored_before;
        choice.shows_stored = false;
    }
    give_comparison_back(state.get<CompareState>());
}

void poll_match(UiState& state) {
    MatchState& match = state.get<MatchState>();
    if (!match.on || match.asked_of == state.editor.scene() || awaits_mesh(state)) return;
    match.asked_of = state.editor.scene();
    match.now = distance_to_target(match, match.asked_of);
    match.hint.clear();
    match.solved = match.solved || match.now <= match_tolerance;
    redraw_within(0);  // the column was drawn earlier in this frame
}

void forget_play(UiState& state) {
    Editor& editor = state.editor;
    if (!state.get<MatchState>().on || !editor.document.path.empty()) return;
    editor.saved = editor.scene();
    editor.saved_edited_camera = editor.history.edited_camera();
}

void match_column(UiState& state) {
    MatchState& match = state.get<MatchState>();
    ImGui::PushFont(fonts().heading);
    ImGui::TextUnformatted("Match the target");
    ImGui::PopFont();
    small_dim(fmt::format("Number {}: the same for everyone", match.seed));
    target_picture(match);
    distance_bar(match);
    ImGui::Dummy({0, px(4)});
    if (match.now <= match_tolerance)
        prose_line("✓ Matched.", theme().accent);
    else
        prose_line(
            "Drag the light or its highlight, the highlight's rim for its size, Ctrl+Shift for its "
            "brightness, until the picture matches this one.");
    hint(match, match.asked_of);
    ImGui::Dummy({0, px(4)});
    const CompareChoice& choice = state.get<CompareState>().choice;
    const bool beside =
        choice.on && has_target_as_b(match, choice) && choice.parts.back().kind == Variant::Kind::Stored;
    if (chosen_button("Target next to it", beside)) show_beside(state, !beside);
    tooltip("Target next to it", "Half of the picture is the target, behind a draggable line");
    ImGui::SameLine(0, px(8));
    if (ImGui::Button("Begin again")) state.editor.scene() = match.task.start;
    tooltip("Begin again", "The scene from the beginning; undo restores yours");
    const bool another = match.solved ? main_button("Another") : ImGui::Button("Another");
    tooltip("Another", "The next number: some are harder");
    if (another) ask_to_begin(state, match.seed + 1);
}

namespace {

void leave_with_match(UiState& state, const SceneDocument&) { end_match(state); }

std::vector<WindowCommand> match_commands() {
    return {
        {.name = "Match the target",
         .section = Section::LectureGames,
         .run = new_match,
         .words = "game play"},
    };
}

}  // namespace

extern const Feature match_feature;
const Feature match_feature{
    .update = poll_match,
    .end = forget_play,
    .column = {[](const UiState& s) { return s.get<MatchState>().on ? "Game" : nullptr; }, match_column,
               end_match},
    .sheet = [](UiState& s) { return &s.get<MatchState>().sheet; },
    .commands = match_commands,
    .leave_document = leave_with_match};

}  // namespace glint
