#include "ui/features/views/views.h"

#include <imgui.h>

#include "ui/commands/command.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/scope.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// What the scope reads: what is shown, where that has linear colours: a comparison's parts, a single term.
const Picture& scope_reads(const UiState& state) {
    const bool readable = !state.displayed->linear.empty() && state.displayed->size == state.rendered->size;
    return readable ? *state.displayed : *state.rendered;
}

/// The picture that shows: the drawn one, or what is composed of it.
const Picture& shown_picture(UiState& state) {
    CompareState& compare = state.get<CompareState>();
    DebugViewState& debug = state.get<DebugViewState>();
    if (debug.set.choice.view != DebugView::Picture) {
        if (!debug.painter) debug.painter = std::make_unique<DebugViewPainter>(state.threads);
        return debug.painter->paint(debug.set.choice, state.rendered_scene, *state.renderer,
                                    state.rendered->size);
    }
    const Picture& shown =
        compare.choice.on
            ? compose(compare, {state.rendered_scene, *state.rendered, *state.renderer, state.threads})
            : *state.rendered;
    if (!debug.set.over_range || shown.linear.empty()) return shown;
    debug.striped = shown;
    debug.clipped = stripe_over_range(debug.striped, state.rendered_scene.display.exposure);
    return debug.striped;
}

}  // namespace

const Picture& unpainted_picture(const UiState& state) {
    const DebugViewState& debug = state.get<DebugViewState>();
    if (debug.set.choice.view != DebugView::Picture) return *state.rendered;
    if (state.displayed != &debug.striped) return *state.displayed;
    const CompareState& compare = state.get<CompareState>();
    return compare.choice.on ? compare.picture : *state.rendered;
}

namespace {

/// Composes again when what it is made from has changed.
void update_shown(UiState& state) {
    ViewsState& views = state.get<ViewsState>();
    const ShownFrom from{state.get<CompareState>().choice, state.get<DebugViewState>().set,
                         !state.rendered->linear.empty()};
    const bool drawn = views.shown_serial != state.picture_serial;
    if (!drawn && from == views.shown_from) return;
    const Picture* before = state.displayed;
    state.displayed = &shown_picture(state);
    const bool composed = state.displayed != state.rendered;
    if (!drawn && (composed || state.displayed != before)) ++state.picture_serial;
    views.shown_serial = state.picture_serial;
    views.shown_from = from;
}

/// Lets the renderer of the picked pixel's part explain it.
void ask_part(UiState& state) {
    if (!state.explanation || !(state.rendered_scene == shown_scene(state))) return;
    const CompareState& compare = state.get<CompareState>();
    const glm::ivec2 pixel{state.explanation->x, state.explanation->y};
    const Renderer* renderer = part_renderer(compare, pixel, state.displayed->size);
    if (renderer == nullptr || renderer == state.renderer.get()) return;
    state.explanation = renderer->explain(pixel.x, pixel.y);
    const int part = part_of(compare, pixel, state.displayed->size);
    const Variant setting = compare.choice.parts[static_cast<std::size_t>(part)];
    state.asked_part = setting;
    Scene asked = scene_under(setting, state.rendered_scene, compare.choice.stored.get());
    state.explained = item_counts(asked);
    // Another setting of the edited scene has its numbers.
    if (setting.kind == Variant::Kind::Stored)
        state.asked_other = {std::move(asked), name_of_stored};
    else if (state.resting)
        state.asked_other = {std::move(asked), state.resting->name};
}

/// A button that runs a command and shows whether it is on.
void command_button(UiState& state, const char* label, CommandId id, const char* what) {
    const WindowCommand& row = command(id);
    const bool on = is_on(state, row).value_or(false);
    const std::string refused = why_disabled(state, row);
    ImGui::BeginDisabled(!refused.empty());
    if (small_chosen_button(label, on)) run_command(state, row);
    ImGui::EndDisabled();
    tooltip(row.name, what, refused, keys_of(row));
    ImGui::SameLine(0, px(4));
}

/// While pictures are compared their controls come first: where they would not fit, the buttons go that the
/// menu View has, too.
void views_bar(UiState& state) {
    float& whole_width = state.get<ViewsState>().bar_width;
    const float begin = ImGui::GetCursorScreenPos().x;
    const bool is_whole =
        !state.get<CompareState>().choice.on || whole_width <= ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(fonts().small);
    if (debug_view_controls(state.get<DebugViewState>(), shown_scene(state)))
        state.get<CompareState>().choice.on = false;  // they take each other's place
    if (is_whole) {
        command_button(state, "Over-range", CommandId::OverRange,
                       "Stripes over pixels whose colour exceeds 1 in a channel and is cut off");
        command_button(
            state, "Scope", CommandId::Scope,
            "Intensity along a line over the picture, with its first and second difference: Mach bands in "
            "numbers");
    }
    command_button(state, "Compare", CommandId::Compare,
                   "Flat, Gouraud and Phong, or any settings, side by side under lines to drag");
    if (is_whole) {
        command_button(
            state, "Pixels", CommandId::Magnify,
            "Each pixel as a square with its number in it: 0 to 255, red, green and blue where there is "
            "room. Ctrl+wheel zooms, the right button moves");
        command_button(
            state, "Dots", CommandId::LitDots,
            "A dot where the equation is evaluated (some dots are left out), and the evaluations per frame");
    }
    compare_controls(state.get<CompareState>());
    if (is_whole) whole_width = ImGui::GetCursorScreenPos().x - begin;
    ImGui::PopFont();
}

}  // namespace

void show_quantity(UiState& state, DebugView view, bool keep_comparing) {
    state.get<DebugViewState>().set.choice.view = view;
    if (!keep_comparing) state.get<CompareState>().choice.on = false;
}

void copy_profile_command(UiState& state) {
    const PictureSize size = state.rendered->size;
    const ScopeState& scope = state.get<ScopeState>();
    const std::string command = shortest_command(state, [&](const SceneDocument& of, const Scene& in_file) {
        return profile_command_text(of, in_file, size, pixel_of(scope.from, size), pixel_of(scope.to, size));
    });
    ImGui::SetClipboardText(command.c_str());
    if (scope_reads(state).linear == state.rendered->linear)
        state.notifications.add(Tone::Done, "The command that prints these numbers is on the clipboard");
    else
        state.notifications.add(
            Tone::Warning,
            "The command on the clipboard prints the numbers of the scene's own picture: no "
            "single command prints those of the comparison or view shown here");
}

bool is_composed(const UiState& state) {
    return state.get<CompareState>().choice.on ||
           state.get<DebugViewState>().set.choice.view != DebugView::Picture;
}

void begin_views(UiState& state) { state.layout.scope = state.get<ScopeState>().open; }

bool views_need_linear(const UiState& state) {
    return state.get<ScopeState>().open || state.get<DebugViewState>().set.over_range;
}

void update_views(UiState& state) {
    state.get<CompareState>().resting = state.resting ? state.resting->label : std::string();
    update_shown(state);
    update_scope(state.get<ScopeState>(), *state.renderer, scope_reads(state));
    ask_part(state);
    const PictureSize size = state.rendered->size;
    update_lit_dots(state.get<LitDotsState>(), drawn_parts(state.get<CompareState>(), *state.renderer, size),
                    size, state.picture_serial);
}

void views_windows(UiState& state, const Layout& layout) {
    if (layout.has_views) {
        begin_area("##views", layout.views, ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::BeginDisabled(is_held(state));
        views_bar(state);
        ImGui::EndDisabled();
        ImGui::End();
    }
    if (layout.has_scope && state.rendered != nullptr) {
        begin_area("##scope", layout.scope, ImGuiWindowFlags_NoScrollWithMouse);
        if (scope_panel(state.get<ScopeState>(), layout.scope, state.rendered->size))
            copy_profile_command(state);
        ImGui::End();
    }
}

void follow_b_key(UiState& state, bool held) {
    constexpr double long_press = 0.4;  // seconds
    constexpr int enough_frames = 2;    // one slow frame makes no long press
    CompareState& compare = state.get<CompareState>();
    if (!compare.b_turned) return;
    if (held) {
        ++compare.b_frames;
        return;
    }
    compare.b_turned = false;
    if (compare.b_frames > enough_frames && ImGui::GetTime() - compare.b_since > long_press)
        compare.choice.shows_stored = !compare.choice.shows_stored;
}

}  // namespace glint
