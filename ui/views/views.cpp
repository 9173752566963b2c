#include "ui/views/views.h"

#include "ui/picture/draw_picture.h"
#include "ui/views/scope_panel.h"
#include "ui/views/views_bar.h"
#include "ui/widgets/area.h"

namespace glint {
namespace {

void copy_profile_command(UiState& state) {
    const std::string& path = state.editor.document.path;
    ImGui::SetClipboardText(profile_command_line(state.views.scope, path, state.picture->size).c_str());
    const bool saved = !path.empty() && !state.editor.unsaved();
    state.notifications.add(Tone::Done, saved ? "Copied the command of this scan line"
                                              : "Copied. The command reads the scene's file: save it first");
}

/// What shows: the drawn picture, or what is composed of it.
const Picture& shown_picture(UiState& state) {
    ViewsState& views = state.views;
    LookState& look = views.look;
    if (look.set.choice.look != Look::Picture) {
        if (!look.painter) look.painter = std::make_unique<LookPainter>(views.threads);
        return look.painter->paint(look.set.choice, state.drawn, *state.renderer, state.picture->size);
    }
    const Picture& shown =
        views.compare.choice.on
            ? compose(views.compare, {state.drawn, *state.picture, *state.renderer, views.threads})
            : *state.picture;
    if (!look.set.over_range || shown.linear.empty()) return shown;
    look.striped = shown;
    look.clipped = stripe_over_range(look.striped, state.drawn.display.exposure);
    return look.striped;
}

/// Composes again when what it is made from has changed.
void update_shown(UiState& state) {
    ViewsState& views = state.views;
    const ShownFrom from{views.compare.choice, views.look.set, !state.picture->linear.empty()};
    const bool drawn = views.shown_serial != state.picture_serial;
    if (!drawn && from == views.shown_from) return;
    const Picture* before = state.shown;
    state.shown = &shown_picture(state);
    const bool composed = state.shown != state.picture;
    if (!drawn && (composed || state.shown != before)) ++state.picture_serial;
    views.shown_serial = state.picture_serial;
    views.shown_from = from;
}

/// The picked pixel is explained by what drew the part in which it lies: nothing is, when that is B with
/// other lights or objects, of whose numbers the columns make those of the edited scene.
void ask_part(UiState& state) {
    if (!state.why || !(state.drawn == state.editor.scene())) return;
    const CompareState& compare = state.views.compare;
    const glm::ivec2 pixel{state.why->x, state.why->y};
    const Renderer* renderer = part_renderer(compare, pixel, state.shown->size);
    if (renderer == nullptr || renderer == state.renderer.get()) return;
    state.why = renderer->explain(pixel.x, pixel.y);
    const int part = part_of(compare, pixel, state.shown->size);
    const Setting setting = compare.choice.parts[static_cast<std::size_t>(part)];
    state.explained = item_counts(scene_under(setting, state.drawn, compare.choice.stored.get()));
    if (!is_explained(state)) state.why.reset();
}

}  // namespace

void look_at(ViewsState& views, Look look, bool keep_comparing) {
    views.look.set.choice.look = look;
    if (!keep_comparing) views.compare.choice.on = false;
}

void begin_views(UiState& state) { state.layout.scope = state.views.scope.open; }

bool views_need_linear(const ViewsState& views) { return views.scope.open || views.look.set.over_range; }

void update_views(UiState& state) {
    update_shown(state);
    // Of what is shown, where that has linear colours: of a comparison's parts, of a single term.
    const bool readable = !state.shown->linear.empty() && state.shown->size == state.picture->size;
    update_scope(state.views.scope, *state.renderer, readable ? *state.shown : *state.picture);
    ask_part(state);
    update_lit_dots(state.views.lit, *state.renderer, state.picture->size, state.picture_serial);
}

void views_windows(UiState& state, const Layout& layout) {
    if (layout.has_views) {
        begin_area("##views", layout.views, ImGuiWindowFlags_NoScrollWithMouse);
        views_bar(state);
        ImGui::End();
    }
    if (layout.has_scope && state.picture != nullptr) {
        begin_area("##scope", layout.scope, ImGuiWindowFlags_NoScrollWithMouse);
        if (scope_panel(state.views.scope, layout.scope, state.picture->size).copy)
            copy_profile_command(state);
        ImGui::End();
    }
}

void follow_b_key(UiState& state, bool held) {
    constexpr double long_press = 0.4;  // seconds
    constexpr int enough_frames = 2;    // one slow frame makes no long press
    CompareState& compare = state.views.compare;
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
