#include "ui/features/games/match.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "models/mesh/primitives/primitives.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/features/views/compare_view.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
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

/// A seed different from the last one, so that repeating the command starts a different game.
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

/// Once a frame: updates the difference between the current scene and the target.
void poll_match(UiState& state) {
    MatchState& match = state.get<MatchState>();
    if (!match.on || match.asked_of == state.editor.scene() || awaits_mesh(state)) return;
    match.asked_of = state.editor.scene();
    match.now = distance_to_target(match, match.asked_of);
    match.hint.clear();
    match.solved = match.solved || match.now <= match_tolerance;
    redraw_within(0);  // the column was drawn earlier in this frame
}

/// Once a frame, after the undo step is recorded: edits made in the game do not count as unsaved work until
/// the scene is saved under a name.
void forget_play(UiState& state) {
    Editor& editor = state.editor;
    if (!state.get<MatchState>().on || !editor.document.path.empty()) return;
    editor.saved = editor.scene();
    editor.saved_edited_camera = editor.history.edited_camera();
}

/// Draws the game's column.
void match_column(UiState& state) {
    MatchState& match = state.get<MatchState>();
    ImGui::PushFont(fonts().heading);
    ImGui::TextUnformatted("Match the target");
    ImGui::PopFont();
    small_dim(fmt::format("Game number {}: the same for everyone", match.seed));
    target_picture(match);
    distance_bar(match);
    ImGui::Dummy({0, px(4)});
    if (match.now <= match_tolerance)
        prose_line("✓ Matched.", theme().accent);
    else
        prose_line(
            "Drag the light or its highlight until the picture matches this one. Drag the highlight's rim to "
            "resize it; hold Ctrl+Shift to change its brightness.");
    hint(match, match.asked_of);
    ImGui::Dummy({0, px(4)});
    const CompareChoice& choice = state.get<CompareState>().choice;
    const bool beside =
        choice.on && has_target_as_b(match, choice) && choice.parts.back().kind == Variant::Kind::Stored;
    if (chosen_button("Target next to it", beside)) show_beside(state, !beside);
    tooltip("Target next to it", "Half of the picture shows the target, up to a draggable line");
    ImGui::SameLine(0, px(8));
    if (ImGui::Button("Begin again")) state.editor.scene() = match.task.start;
    tooltip("Begin again", "Restores the initial scene; undo brings yours back");
    const bool another = match.solved ? main_button("Another") : ImGui::Button("Another");
    tooltip("Another", "Starts the next game; some are harder");
    if (another) ask_to_begin(state, match.seed + 1);
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
    if (has_target_as_b(match, choice)) {  // a comparison with the target ends with the game
        choice.stored = match.stored_before;
        choice.shows_stored = false;
    }
    give_comparison_back(state.get<CompareState>());
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

// The scenes of *Match the target*, generated from a seed, and hints about the difference.

namespace {

/// Numbers in [0, 1) that are the same on every machine. Source: Steele, Lea, Flood 2014, SplitMix64.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}
    float next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<float>((z ^ (z >> 31U)) >> 40U) / static_cast<float>(1U << 24U);
    }
    float between(float low, float high) { return low + (high - low) * next(); }

  private:
    std::uint64_t state_;
};

/// A direction towards a sun whose highlight is visible.
glm::vec3 draw_direction(Draws& draws) {
    return {draws.between(-1, 1), draws.between(0.05f, 1), draws.between(0.35f, 0.9f)};
}

float degrees_between(glm::vec3 a, glm::vec3 b) {
    return std::acos(glm::dot(glm::normalize(a), glm::normalize(b))) * 180 / std::numbers::pi_v<float>;
}

Scene drawn_scene(Draws& draws) {
    Scene scene;
    scene.camera.eye = {0, 0.4f, 3.3f};
    scene.global_ambient = glm::vec3(0.06f);
    Light sun;
    sun.name = "Sun";
    sun.kind = LightKind::Directional;
    sun.position = glm::vec4(draw_direction(draws), 0);
    sun.intensity = 0.75f;
    scene.lights = {sun};
    Object ball;
    ball.name = "Ball";
    ball.source = PrimitiveMesh{Primitive::Sphere, 96};
    ball.mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Sphere, 96));
    ball.material.ambient = glm::vec3(0.5f);
    ball.material.diffuse = {draws.between(0.15f, 0.6f), draws.between(0.15f, 0.6f),
                             draws.between(0.15f, 0.6f)};
    ball.material.specular = glm::vec3(0.6f);
    ball.material.shininess = std::round(std::exp2(draws.between(2.5f, 6.5f)));
    scene.objects = {ball};
    return scene;
}

/// Moves a light far enough that the player notices.
void move_sun(MatchTask& task, Draws& draws) {
    constexpr float least_deg = 30;
    glm::vec3 way = task.start.lights[0].position;
    while (degrees_between(way, task.start.lights[0].position) < least_deg) way = draw_direction(draws);
    task.target.lights[0].position = glm::vec4(way, 0);
    for (const char* axis : {"0", "1", "2"})
        task.numbers.push_back(std::string("/lights/0/position/") + axis);
}

void change_exponent(MatchTask& task, Draws& draws) {
    const float before = task.start.objects[0].material.shininess;
    const bool sharper = before < 25;
    task.target.objects[0].material.shininess =
        std::round(before * (sharper ? draws.between(3, 6) : 1 / draws.between(3, 6)));
    task.numbers.emplace_back("/objects/0/material/shininess");
}

void change_brightness(MatchTask& task, Draws& draws) {
    task.target.lights[0].intensity =
        draws.next() < 0.5f ? draws.between(0.35f, 0.5f) : draws.between(1, 1.2f);
    task.numbers.emplace_back("/lights/0/intensity");
}

/// Measurements of one term's picture: its brightness, the number of bright pixels, and their mean position.
struct Blob {
    double sum = 0, bright = 0;
    glm::dvec2 middle{0};
};
Blob blob_of(const Picture& picture) {
    Blob blob;
    int most = 0;
    const auto level = [&](int x, int y) {
        const std::size_t at = 4 * picture.pixel(x, y);
        return picture.rgba[at] + picture.rgba[at + 1] + picture.rgba[at + 2];
    };
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) most = std::max(most, level(x, y));
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            blob.sum += level(x, y);
            if (most == 0 || 2 * level(x, y) < most) continue;
            ++blob.bright;
            blob.middle += glm::dvec2(x, y);
        }
    if (blob.bright > 0) blob.middle /= blob.bright;
    return blob;
}

/// Draws the term alone, on black.
Picture term_picture(Renderer& renderer, const Scene& scene, Symbol term) {
    Scene alone = with_term_alone(scene, term);
    alone.display.background = glm::vec3(0);
    return renderer.render(alone, match_size);
}

/// Describes how `mine` differs from `wanted` in position, size or brightness.
std::string how(const Blob& mine, const Blob& wanted, const char* what, bool has_size) {
    constexpr double far = 5, larger = 1.25, brighter = 1.08;  // pixels of match_size; ratios
    if (mine.bright == 0) return fmt::format("{} is missing", what);
    if (glm::length(mine.middle - wanted.middle) > far) return fmt::format("{} is in the wrong place", what);
    if (has_size && mine.bright > larger * wanted.bright) return fmt::format("{} is too large", what);
    if (has_size && wanted.bright > larger * mine.bright) return fmt::format("{} is too small", what);
    if (mine.sum > brighter * wanted.sum) return fmt::format("{} is too bright", what);
    if (wanted.sum > brighter * mine.sum) return fmt::format("{} is too dark", what);
    return fmt::format("{} is slightly displaced", what);
}

}  // namespace

double apart_of(const Picture& a, const Picture& b) {
    const auto c = std::get<Comparison>(compare(a, b));
    return std::sqrt((c.rmse[0] * c.rmse[0] + c.rmse[1] * c.rmse[1] + c.rmse[2] * c.rmse[2]) / 3);
}

MatchTask match_task(std::uint64_t seed) {
    Draws draws(seed);
    MatchTask task;
    task.start = drawn_scene(draws);
    task.target = task.start;
    // The seed decides which of the three changes are made; at least one is.
    const std::uint64_t changes = seed % 7 == 0 ? 7 : seed % 7;
    if ((changes & 1U) != 0) move_sun(task, draws);
    if ((changes & 2U) != 0) change_exponent(task, draws);
    if ((changes & 4U) != 0) change_brightness(task, draws);
    return task;
}

std::string match_hint(Renderer& renderer, const Scene& scene, const Scene& target) {
    struct Term {
        Symbol symbol;
        const char *name, *what;
        bool has_size;
    };
    constexpr std::array terms{Term{Symbol::Ambient, "ambient", "it", false},
                               Term{Symbol::Diffuse, "diffuse", "its light", false},
                               Term{Symbol::Specular, "specular", "its highlight", true}};
    if (scene.shading != target.shading)
        return "The shading differs from the target's: Begin again restores it.";
    double most = 0;
    std::string hint = "Nothing differs.";
    for (const Term& term : terms) {
        const Picture wanted = term_picture(renderer, target, term.symbol);
        const Picture mine = term_picture(renderer, scene, term.symbol);
        const double apart = apart_of(mine, wanted);
        if (apart <= most) continue;
        most = apart;
        hint = fmt::format("The {} term is furthest off: {}.", term.name,
                           how(blob_of(mine), blob_of(wanted), term.what, term.has_size));
    }
    return hint;
}

}  // namespace glint
