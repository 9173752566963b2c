// Random mouse and keyboard input: the scene can always be saved, what the window keeps from frame to frame
// equals what it would compute from scratch, and undo leads back to the start. The environment variables
// GLINT_MONKEY_SEED and GLINT_MONKEY_EVENTS choose the seed and the number of events.
#include <malloc.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/editor.h"
#include "ui/features/games/match.h"
#include "ui/features/lessons/lesson.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

// Sanitizer builds use different seeds from Release builds.
const char* const more_events = std::getenv("GLINT_MONKEY_EVENTS");
const int events_a_run = more_events != nullptr ? std::atoi(more_events) : test::sanitized ? 2'500 : 7'500;
const unsigned first_seed = test::sanitized ? 5 : 1;
const int scenes_exchanged = test::sanitized ? 40 : 400;
constexpr int events_before_exchange = 40;
constexpr int events_a_scene = 250;  // then everything is undone; the history can keep more than this

/// Runs the test in its own folder and without a clipboard, so that nothing outside the folder is touched.
class Cage {
  public:
    Cage() : home_(std::filesystem::current_path()) {
        std::filesystem::current_path(folder_.path(""));
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
    }
    ~Cage() { std::filesystem::current_path(home_); }
    Cage(const Cage&) = delete;
    Cage& operator=(const Cage&) = delete;

  private:
    TemporaryDirectory folder_;
    std::filesystem::path home_;
};

/// Whether the command begins a new history.
bool ends_history(const WindowCommand& command) {
    static const std::set<std::string_view> names{"Quit", "New scene", "Open…", "Next scene in the folder",
                                                  "Previous scene in the folder"};
    for (const std::string_view name : names) (void)test::command_named(name);  // must exist
    return names.contains(command.name);
}

class Monkey {
  public:
    Monkey(HeadlessWindow& bench, unsigned seed) : bench_(bench), random_(seed) {}

    void act() {
        switch (random_() % 16) {
        case 0:
        case 1:
        case 2:
            return jump();
        case 3:
        case 4:
        case 5:
        case 6:
            return creep();
        case 7:
        case 8:
        case 9:
            return button(0);
        case 10:
            return button(1 + static_cast<int>(random_() % 2));
        case 11:
            ImGui::GetIO().MouseWheel = test::uniform(random_, -2, 2);
            return frame({});
        case 12:
        case 13:
            return key();
        case 14:
            return type();
        default:
            return hold();
        }
    }

    /// Releases the mouse and all keys.
    void let_go() {
        for (bool& down : ImGui::GetIO().MouseDown) down = false;
        ImGui::GetIO().KeyShift = ImGui::GetIO().KeyCtrl = ImGui::GetIO().KeyAlt = false;
        held_ = {};
    }
    /// Releases everything and closes all dialogs.
    void calm_down() {
        let_go();
        for (int i = 0; i < 6; ++i) (void)bench_.key(Key::Escape);
        bench_.move({1, 1});
        bench_.frames(3);
        bench_.wait_for_loads();
        bench_.state.pending = {};
        bench_.state.files.open = false;
        bench_.frames(3);
    }

  private:
    void frame(UiInput input) {
        input.axis_held = held_;
        (void)bench_.frame(input);
        bench_.state.quits = false;
    }
    void jump() {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        ImGui::GetIO().MousePos = {test::uniform(random_, -5, size.x + 5),
                                   test::uniform(random_, -5, size.y + 5)};
        frame({});
    }
    void creep() {
        ImVec2& at = ImGui::GetIO().MousePos;
        at.x += test::uniform(random_, -25, 25), at.y += test::uniform(random_, -25, 25);
        frame({});
    }
    void button(int which) {
        bool& down = ImGui::GetIO().MouseDown[which];
        down = !down;
        frame({});
    }
    void key() {
        const auto table = commands();
        const WindowCommand& command = table[random_() % table.size()];
        UiInput input;
        if (!command.keys.empty() && !ends_history(command))
            input.presses.push_back(command.keys[random_() % command.keys.size()]);
        if (random_() % 3 == 0) input.presses.push_back({Key::Escape});
        if (random_() % 6 == 0) input.presses.push_back({Key::Enter});
        if (random_() % 6 == 0) input.presses.push_back({random_() % 2 == 0 ? Key::Up : Key::Down});
        frame(input);
    }
    void type() {
        constexpr std::string_view letters =
            "0123456789-+e ab";  // no dot and no slash: names stay in the folder
        for (unsigned i = 0; i <= random_() % 4; ++i)
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(letters[random_() % letters.size()]));
        frame({});
    }
    void hold() {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyShift = random_() % 4 == 0;
        io.KeyCtrl = random_() % 6 == 0;
        io.KeyAlt = random_() % 8 == 0;
        for (bool& axis : held_) axis = random_() % 6 == 0;
        frame({});
    }

    HeadlessWindow& bench_;
    std::mt19937 random_;
    std::array<bool, 3> held_{};
};

/// Small shapes, because thousands of pictures are drawn.
SceneDocument small_document() {
    SceneDocument document = first_scene();
    Object& ball = document.scene.objects[0];
    ball.source = PrimitiveMesh{Primitive::Sphere, 8};
    ball.mesh = test::primitive(Primitive::Sphere, 8);
    Light spot = document.scene.lights[1];
    spot.name = "Spot";
    spot.kind = LightKind::Spot;
    document.scene.lights.push_back(spot);
    return document;
}

/// Checks that every number is valid in a scene file: finite, and within its range.
void check_scene(const Scene& scene, int event) {
    const auto read = parse_scene(scene_text(scene), "monkey.json");
    if (const Problem* problem = problem_of(read)) {
        FAIL("after event " << event << ": " << problem->text());
    } else if (!same_description(std::get<Scene>(read), scene)) {
        FAIL("after event " << event << ": the scene changes when it is saved and read back");
    }
}

/// Checks that the picture and the explanation belong to the shown scene, and that the selection is valid.
void check_kept(HeadlessWindow& bench, int event) {
    const UiState& state = bench.state;
    INFO("after event " << event);
    const Selection& selection = state.editor.selection;
    CHECK(valid_selection(selection, state.editor.scene()) == selection);
    if (state.rendered == nullptr || state.rendered_scene.transport.model != TransportModel::Local) return;
    Renderer fresh(1);
    const Picture& picture = fresh.render(state.rendered_scene, state.rendered->size);
    CHECK((picture.rgba == state.rendered->rgba));
    if (!state.parts.empty() || !state.on_screen.explanation || !is_explained(state)) return;
    const Explanation& e = *state.on_screen.explanation;
    CHECK(e.byte == fresh.explain(e.x, e.y).byte);
}

}  // namespace

TEST_CASE("a closed dialog does not block the next one", "[ui]") {
    HeadlessWindow bench;
    bench.frames(2);
    for (const Key key : {Key::O, Key::E}) {
        bench.key(key, true);
        bench.frames(2);
        bench.state.files.open = bench.state.get<ExportState>().open = false;  // closed by other code
        bench.frames(2);
        bench.key(Key::K, true);  // opens the palette
        bench.frames(2);
        CHECK(bench.state.palette.open);
        bench.key(Key::Escape);
        CHECK_FALSE(bench.state.palette.open);
    }
}

TEMPLATE_TEST_CASE_SIG("after random events nothing has crashed, scenes can be saved, and undo works",
                       "[ui][monkey][long]", ((unsigned run), run), 0, 1, 2, 3) {
    const Cage cage;
    const char* chosen = std::getenv("GLINT_MONKEY_SEED");
    const unsigned seed = run + (chosen != nullptr ? static_cast<unsigned>(std::atoi(chosen)) : first_seed);
    INFO("seed " << seed);
    HeadlessWindow bench({900, 420});
    Monkey monkey(bench, seed);
    int undone = 0, compared = 0;
    for (int event = 0; event < events_a_run; ++event) {
        if (event % events_a_scene == 0) {
            bench.state.layout = {};
            bench.state.editor.selection = {};
            end_match(bench.state);
            leave_lesson(bench.state);
            take_document(bench.state.editor, small_document());
        }
        monkey.act();
        bench.state.get<RecentlyChanged>().list.clear();  // opening one would begin a new history
        if (event % 10 == 9) check_scene(bench.scene(), event);
        if (event % 50 == 25) check_kept(bench, event);
        if (event % events_a_scene != events_a_scene - 1) continue;
        monkey.calm_down();
        check_scene(bench.scene(), event);
        while (undo(bench.state.editor)) ++undone;
        ViewHistory& views = bench.state.editor.views;
        for (Camera at = bench.scene().camera; views.can_go_back(); ++undone) at = views.back(at);
        // The mouse may still click "New", a game or a lesson, or open a saved file. Undo then leads back
        // only to that scene.
        if (bench.state.get<MatchState>().on || bench.state.get<LessonState>().course) continue;
        if (!bench.state.editor.document.path.empty() || same_but_camera(bench.scene(), first_scene().scene))
            continue;
        INFO("event " << event << ": " << step_name(small_document().scene, bench.scene()));
        CHECK(same_but_camera(bench.scene(), small_document().scene));
        CHECK(bench.state.editor.history.edited_camera() == small_document().scene.camera);
        ++compared;
        bench.frames(2);
    }
    CHECK(undone > events_a_run * 150 / 20'000);  // enough events had an effect
    CHECK(compared > events_a_run / events_a_scene / 2);
    CHECK(bench.state.notifications.list.size() <= 5);
}

TEST_CASE("a scene that replaces another during a drag matches its file", "[ui][monkey][long]") {
    const Cage cage;
    HeadlessWindow bench({900, 420});
    Monkey monkey(bench, first_seed);
    SceneDocument other = small_document();
    for (Light& light : other.scene.lights) {
        light.name += " of the other";
        light.intensity = light.diffuse.x = 0.375f;
    }
    other.scene.objects[0].name = "Other";
    other.scene.objects[0].material.shininess = 3;
    other.scene.objects[0].transform.rotate_deg = {10, 20, 30};
    other.scene.camera.eye = {1, 2, 3};
    for (int round = 0; round < scenes_exchanged; ++round) {
        INFO("round " << round);
        bench.state.layout = {};
        take_scene(bench.state, small_document());
        bench.state.editor.selection = {};
        for (int event = 0; event < events_before_exchange; ++event) monkey.act();
        take_scene(bench.state, other);
        bench.frames(2);
        monkey.let_go();
        bench.frames(2);
        for (const Key key : {Key::Escape, Key::Enter, Key::Escape}) (void)bench.key(key);
        bench.frames(2);
        REQUIRE(bench.scene() == other.scene);
        CHECK_FALSE(bench.state.editor.unsaved());
        monkey.calm_down();
    }
}

TEST_CASE("a window's memory use stays constant after warming up", "[ui][monkey][long][release]") {
    const Cage cage;
    HeadlessWindow bench({900, 420});
    const auto held_after_round = [&] {
        take_document(bench.state.editor, small_document());
        Monkey monkey(bench, first_seed);
        for (int event = 0; event < events_a_scene; ++event) monkey.act();
        monkey.calm_down();
        take_document(bench.state.editor, small_document());
        bench.frames(2);
        const struct mallinfo2 held = mallinfo2();
        return static_cast<double>(held.uordblks + held.hblkhd);
    };
    double warm = 0, held = 0;
    for (int round = 0; round < 24; ++round) {
        held = held_after_round();
        if (round == 11) warm = held;
    }
    CHECK(held < 1.01 * warm);
}
