#include "ui/features/views/views.h"

#include <imgui.h>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/scope.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The scope's source: the shown picture if it has linear colours (a comparison's parts, a single term), else
/// the rendered one.
const Picture& scope_reads(const UiState& state) {
    const bool readable = !state.displayed->linear.empty() && state.displayed->size == state.rendered->size;
    return readable ? *state.displayed : *state.rendered;
}

/// The shown picture: the drawn one, or one composed from it. Sets UiState::unpainted.
const Picture& shown_picture(UiState& state) {
    state.unpainted = state.rendered;
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
    state.unpainted = &shown;
    if (!debug.set.over_range || shown.linear.empty()) return shown;
    debug.striped = shown;
    debug.clipped = stripe_over_range(debug.striped, state.rendered_scene.display.exposure);
    return debug.striped;
}

/// Composes the shown picture again when its inputs have changed.
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

/// Updates the parts of the displayed picture.
void update_parts(UiState& state) {
    const CompareState& compare = state.get<CompareState>();
    const CompareChoice& choice = compare.choice;
    const PictureSize size = state.rendered->size;
    const bool is_plain = !is_composed(state);
    state.parts.clear();
    state.parts_ms = choice.on ? compare.ms : 0;
    if (part_of(compare, {0, 0}, size) < 0) {
        state.parts.push_back({{{0, 0}, {size.width, size.height}}, state.renderer.get(), nullptr, is_plain});
        return;
    }
    for (std::size_t i = 0; i < choice.parts.size(); ++i) {
        const Variant variant = choice.parts[i];
        const bool is_mine = variant.kind == Variant::Kind::Mine && choice.mine;
        const bool is_b = variant.kind == Variant::Kind::Stored && choice.stored;
        state.parts.push_back({part_rect(choice, static_cast<int>(i), size),
                               is_mine ? nullptr : compare.drawn_by[i], is_b ? choice.stored.get() : nullptr,
                               variant.kind == Variant::Kind::Edited || variant.kind == Variant::Kind::Mode ||
                                   variant.kind == Variant::Kind::Interpolation});
    }
}

/// Explains the picked pixel with the renderer of its part.
void ask_part(UiState& state) {
    OnScreen& shown = state.on_screen;
    CompareState& compare = state.get<CompareState>();
    compare.asked_part = {};
    if (!shown.explanation || !(state.rendered_scene == shown_scene(state))) return;
    const glm::ivec2 pixel{shown.explanation->x, shown.explanation->y};
    const Renderer* renderer = part_renderer(compare, pixel, state.displayed->size);
    if (renderer == nullptr || renderer == state.renderer.get()) return;
    shown.explained_by = renderer;
    shown.explanation = renderer->explain(pixel.x, pixel.y);
    const int part = part_of(compare, pixel, state.displayed->size);
    compare.asked_part = compare.choice.parts[static_cast<std::size_t>(part)];
    // A variant with a different setting still has the edited scene's numbers.
    const bool is_b = compare.asked_part.kind == Variant::Kind::Stored;
    if (is_b || shown.resting)
        shown.explained_other =
            OtherScene{scene_under(compare.asked_part, state.rendered_scene, compare.choice.stored.get()),
                       is_b ? name_of_stored : shown.resting->name};
}

void compose_views(UiState& state) {
    state.get<CompareState>().resting =
        state.on_screen.resting ? state.on_screen.resting->label : std::string();
    state.parts_progress = 1;
    if (state.get<CompareState>().choice.on &&
        refine_parts(state.get<CompareState>(), state.jobs, state.threads, state.parts_progress))
        ++state.picture_serial;
    update_shown(state);
    update_parts(state);
    ask_part(state);
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

/// The list of quantities and the Compare button keep their positions; the controls of the active one follow.
void views_bar(UiState& state) {
    ImGui::PushFont(fonts().small);
    ImGui::SetCursorPosY(px(3));
    if (debug_view_choice(state.get<DebugViewState>()))
        state.get<CompareState>().choice.on = false;  // a quantity and a comparison are mutually exclusive
    command_button(state, "Compare", CommandId::Compare,
                   "Flat, Gouraud and Phong, or any settings, side by side with draggable lines between");
    light_choice(state.get<DebugViewState>(), shown_scene(state));
    compare_controls(state.get<CompareState>());
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

namespace {

void draw_views_bar(UiState& state, const Layout& layout) {
    if (!layout.has_views) return;
    begin_area("##views", layout.views, ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::BeginDisabled(is_held(state));
    views_bar(state);
    ImGui::EndDisabled();
    ImGui::End();
}

void begin_scope(UiState& state, const UiInput&) { state.layout.scope = state.get<ScopeState>().open; }

void draw_scope(UiState& state, const Layout& layout) {
    if (!layout.has_scope || state.rendered == nullptr) return;
    begin_area("##scope", layout.scope, ImGuiWindowFlags_NoScrollWithMouse);
    if (scope_panel(state.get<ScopeState>(), layout.scope, state.rendered->size)) copy_profile_command(state);
    ImGui::End();
}

void reshape_scope(UiState& state, const Reshape& reshape) {
    ScopeState& scope = state.get<ScopeState>();
    if (!scope.open || scope.armed) return;  // no line has been placed yet
    for (glm::dvec2* share : {&scope.from, &scope.to, &scope.card_at}) reshape.follow(*share);
    scope.card_size *= reshape.scale;
}

void write_scope(const UiState& state, Json& settings) {
    const ScopeState& scope = state.get<ScopeState>();
    settings["scope_from"] = share_json(scope.from);
    settings["scope_to"] = share_json(scope.to);
    settings["scope_channels"] = scope.channels;
    settings["scope_eye"] = scope.eye;
}

void read_scope(UiState& state, const Json& settings) {
    ScopeState& scope = state.get<ScopeState>();
    lay_level(scope);
    scope.channels = scope.eye = false;
    read_share(settings, "scope_from", scope.from);
    read_share(settings, "scope_to", scope.to);
    read_member(settings, "scope_channels", scope.channels);
    read_member(settings, "scope_eye", scope.eye);
}

void leave_with_scope(UiState& state, const SceneDocument& next) {
    if (is_another(state, next)) lay_level(state.get<ScopeState>());
}

Json compare_json(const CompareChoice& choice) {
    Json parts = Json::array();
    for (const Variant& part : choice.parts) parts.push_back(word_of(part));
    return {{"parts", parts},
            {"lines", choice.wipes},
            {"stacked", choice.stacked},
            {"difference", choice.difference},
            {"gain", choice.gain}};
}

/// Reads ascending positions, one fewer than parts; if they are invalid, the lines stay evenly spaced.
void read_lines(const Json& json, CompareChoice& choice) {
    if (!json.is_array() || elements_of(json).size() != choice.wipes.size()) return;
    std::vector<double> lines;
    for (const Json& line : elements_of(json)) {
        if (!line.is_number()) return;
        lines.push_back(line.get<double>());
        if (!(lines.back() >= 0 && lines.back() <= 1)) return;
        if (lines.size() > 1 && !(lines.back() >= lines[lines.size() - 2])) return;
    }
    choice.wipes = lines;
}

CompareChoice read_choice(const Json* json) {
    CompareChoice choice;
    if (json == nullptr || !json->is_object()) return choice;
    read_member(*json, "stacked", choice.stacked);
    read_member(*json, "difference", choice.difference);
    int gain = 1;
    read_member(*json, "gain", gain, 1, max_gain);
    while (2 * choice.gain <= gain) choice.gain *= 2;
    std::vector<Variant> parts;
    if (const Json* found = find_member(*json, "parts"))
        for (const Json& part : elements_of(*found))
            if (const auto setting =
                    part.is_string() ? variant_named(part.get_ref<const std::string&>()) : std::nullopt)
                parts.push_back(*setting);
    if (parts.size() == 2 || parts.size() == 3) set_parts(choice, parts);
    if (const Json* found = find_member(*json, "lines")) read_lines(*found, choice);
    return choice;
}

void write_compare(const UiState& state, Json& settings) {
    const CompareState& compare = state.get<CompareState>();
    settings["compare"] = compare_json(compare.own ? *compare.own : compare.choice);
}

/// Reads the settings of a comparison; its stored scene and picture are kept.
void read_compare(UiState& state, const Json& settings) {
    CompareChoice& choice = state.get<CompareState>().choice;
    CompareChoice read = read_choice(find_member(settings, "compare"));
    read.stored = choice.stored;
    read.mine = choice.mine;
    choice = std::move(read);
}

/// B outlives its document, so its mesh paths are made relative to the next document's folder.
void leave_with_b(UiState& state, const SceneDocument& next) {
    CompareChoice& choice = state.get<CompareState>().choice;
    if (is_another(state, next)) choice.shows_stored = state.get<CompareState>().b_turned = false;
    const std::string& dir = state.editor.document.mesh_dir;
    if (choice.stored && dir != next.mesh_dir)
        choice.stored =
            std::make_shared<const Scene>(with_mesh_paths_from(*choice.stored, dir, next.mesh_dir));
}

std::optional<OtherScene> show_b(const UiState& state) {
    const CompareChoice& choice = state.get<CompareState>().choice;
    if (!choice.shows_stored) return {};
    const Variant b{Variant::Kind::Stored, 0};
    return OtherScene{.scene = scene_under(b, state.editor.scene(), choice.stored.get()),
                      .name = name_of_stored,
                      .label = label_of(b),
                      .note = name_of_stored,
                      .key = CommandId::ShowB,
                      .end = [](UiState& s) {
                          CompareState& compare = s.get<CompareState>();
                          compare.choice.shows_stored = compare.b_turned = false;
                      }};
}

/// Pressing the B key shows or hides B; releasing the key after a long press undoes that.
void follow_b_key(UiState& state, const UiInput& input) {
    constexpr double long_press = 0.4;  // seconds
    constexpr int enough_frames = 2;    // a single slow frame is not a long press
    CompareState& compare = state.get<CompareState>();
    if (!compare.b_turned) return;
    if (input.b_held) {
        ++compare.b_frames;
        return;
    }
    compare.b_turned = false;
    if (compare.b_frames > enough_frames && ImGui::GetTime() - compare.b_since > long_press)
        compare.choice.shows_stored = !compare.choice.shows_stored;
}

std::optional<PictureNote> note_of_comparison(const UiState& state, const Scene&) {
    const CompareChoice& choice = state.get<CompareState>().choice;
    if (!choice.on) return {};
    return PictureNote{PictureNote::Kind::View, choice.difference ? "Difference" : "Comparison",
                       [](UiState& s) { s.get<CompareState>().choice.on = false; }, CommandId::Compare};
}

std::optional<PictureNote> note_of_debug_view(const UiState& state, const Scene&) {
    const DebugViewSet& set = state.get<DebugViewState>().set;
    if (set == DebugViewSet{}) return {};
    const bool is_plain = set.choice.view == DebugView::Picture;
    return PictureNote{
        PictureNote::Kind::View,
        is_plain ? "Over-range stripes" : std::string("View: ") + info_of(set.choice.view).label,
        [](UiState& s) { s.get<DebugViewState>().set = {}; }};
}

/// The number of evaluations of the equation; in a comparison, for the part under the mouse, or else for the
/// first part.
std::string evaluations_under(const UiState& state, const PictureView& view) {
    const CompareState& compare = state.get<CompareState>();
    const std::vector<DrawnPart> parts = drawn_parts(compare, *state.renderer, view.map.size);
    const glm::ivec2 pixel = nearest_pixel(view.map.size, view.to_pixel(ImGui::GetIO().MousePos));
    const auto holds = [pixel](const DrawnPart& part) { return part.rect.holds(pixel); };
    const auto under = std::find_if(parts.begin(), parts.end(), holds);
    if (parts.empty()) return {};
    const DrawnPart& part = under != parts.end() ? *under : parts.front();
    const Scene scene = scene_under(part.variant, state.rendered_scene, compare.choice.stored.get());
    const std::string text = evaluations_text(*part.renderer, scene);
    return parts.size() == 1 ? text : label_of(part.variant) + ": " + text;
}

void overlay_dots(ImDrawList& list, UiState& state, const PictureView& view) {
    const LitDotsState& lit = state.get<LitDotsState>();
    draw_lit_dots(list, lit, view);
    if (lit.dots) draw_evaluations(list, evaluations_under(state, view), state.get<CompareState>().choice.on);
}

}  // namespace

extern const Feature scope_feature, compare_feature, debug_view_feature, lit_dots_feature,
    stored_scene_feature;

const Feature scope_feature{
    .begin = begin_scope,
    .update = [](UiState& s) { update_scope(s.get<ScopeState>(), *s.renderer, scope_reads(s)); },
    .draw = draw_scope,
    .needs = [](const UiState& s) { return PictureNeeds{.linear = s.get<ScopeState>().open}; },
    .tool = &scope_tool,
    .overlay = draw_scope_line,
    .reshape = reshape_scope,
    .commands = scope_commands,
    .escape = [](UiState& s) { return std::exchange(s.get<ScopeState>().armed, false); },
    .write_settings = write_scope,
    .read_settings = read_scope,
    .leave_document = leave_with_scope,
    .put_away = [](UiState& s) { s.get<ScopeState>().open = s.get<ScopeState>().armed = false; }};

const Feature compare_feature{
    .compose = compose_views,
    .draw = draw_views_bar,
    .needs =
        [](const UiState& s) {
            return PictureNeeds{.full_size = s.get<ViewsState>().shown_from.is_measured()};
        },
    .tool = &compare_tool,
    .overlay = draw_compare,
    .note = note_of_comparison,
    .commands = compare_commands,
    .write_settings = write_compare,
    .read_settings = read_compare,
    .put_away =
        [](UiState& s) {
            s.get<CompareState>().choice.on = false;
            forget_parts(s.get<CompareState>());
        }};

const Feature debug_view_feature{
    .needs = [](const UiState& s) { return PictureNeeds{.linear = s.get<DebugViewState>().set.over_range}; },
    .overlay =
        [](ImDrawList& list, UiState& s, const PictureView& view) {
            s.legend_width = legend_width(s.get<DebugViewState>());
            draw_debug_view_legend(list, s.get<DebugViewState>(), s.rendered_scene, view,
                                   probe_pixel(s.viewport, view.map.size));
        },
    .note = note_of_debug_view,
    .commands = debug_view_commands,
    .follow =
        [](UiState& s, const ItemPlaces& places) {  // follow the light of n·l
            (void)places.follow_light(s.get<DebugViewState>().set.choice.light);
        },
    .leave_document =
        [](UiState& s, const SceneDocument& next) {
            if (is_another(s, next)) s.get<DebugViewState>().set = {};
        },
    .put_away = [](UiState& s) { s.get<DebugViewState>() = {}; }};

const Feature lit_dots_feature{
    .update =
        [](UiState& s) {
            const PictureSize size = s.rendered->size;
            update_lit_dots(s.get<LitDotsState>(), drawn_parts(s.get<CompareState>(), *s.renderer, size),
                            size, s.picture_serial);
        },
    .overlay = overlay_dots,
    .commands = lit_dots_commands,
    .put_away = [](UiState& s) { s.get<LitDotsState>().dots = s.get<LitDotsState>().needles = false; }};

const Feature stored_scene_feature{.begin = follow_b_key,
                                   .shows = show_b,
                                   .commands = stored_scene_commands,
                                   .leave_document = leave_with_b,
                                   .put_away = [](UiState& s) {
                                       s.get<CompareState>().choice.shows_stored =
                                           s.get<CompareState>().b_turned = false;
                                   }};

}  // namespace glint
