// Dialogs: one at a time, and none blocks windows opened in the same frame.
#include "ui/shell/modal.h"

#include <imgui_internal.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Closes everything, and restores an unsaved scene, after any previous steps.
void start_afresh(HeadlessWindow& bench) {
    for (int i = 0; i < 6; ++i) (void)bench.key(Key::Escape);
    UiState& state = bench.state;
    state.layout = {};
    state.shows_shortcuts = state.get<AnimateState>().open = state.get<WedgeState>().open =
        state.get<PenState>().on = false;
    state.get<ScopeState>().open = false;
    take_scene(state, first_scene());
    state.editor.saved.lights.clear();
    bench.frames(2);
    state.quits = false;
}

}  // namespace

TEST_CASE("a dialog and a window opened in the same frame are both drawn", "[ui][modal]") {
    // The folder of the dialogs, and a small picture.
    HeadlessWindow bench({420, 240});
    bench.frames(2);
    for (const char* dialog : {"New scene", "Open…", "Export picture…", "Save as…"})
        for (const WindowCommand& command : commands()) {
            if (&command == &test::command_named("Copy picture")) continue;  // it runs a program
            if (&command == &test::command_named("Save picture here and copy its command"))
                continue;  // a file
            INFO(command.name << ", then " << dialog);
            start_afresh(bench);
            run_command(bench.state, command);
            run_command(bench.state, test::command_named(dialog));
            // As from keys in one frame: nothing of it has been drawn yet.
            bench.frames(3);
            CHECK(open_dialog(bench.state) != nullptr);
        }
}

TEST_CASE("keys in one frame may open a dialog and a sheet", "[ui][modal]") {
    HeadlessWindow bench;
    bench.frames(2);
    bench.scene().shading.mode = ShadingMode::Flat;  // not saved
    bench.frames(2);
    UiInput input;
    input.presses = {{Key::C}, {Key::F10}, {Key::Question, false, true}, {Key::N, true}};
    (void)bench.frame(input);
    bench.frames(3);
    CHECK(bench.state.pending.asking);
    CHECK(bench.state.shows_shortcuts);
}

TEST_CASE("a question during a file dialog comes first, and the dialog returns after it", "[ui][modal]") {
    HeadlessWindow bench;
    bench.frames(2);
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.frames(2);
    bench.key(Key::O, true);
    bench.frames(2);
    CHECK(open_dialog(bench.state) == &files_dialog);
    UiInput drop;
    drop.dropped = {"other.json"};
    (void)bench.frame(drop);
    bench.frames(2);
    CHECK(open_dialog(bench.state) == &unsaved_dialog);
    CHECK(bench.state.files.open);
    const auto& open_now = ImGui::GetCurrentContext()->OpenPopupStack;
    REQUIRE(open_now.Size == 1);
    CHECK(std::string_view(open_now[0].Window->Name) == "Unsaved changes##question");
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(open_dialog(bench.state) == &files_dialog);
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK(open_dialog(bench.state) == nullptr);
}

TEST_CASE("opening one of several files is reported only if it opens", "[ui][modal]") {
    HeadlessWindow bench;
    bench.frames(2);
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.frames(2);
    UiInput drop;
    drop.dropped = {"other.json", "third.obj"};
    const auto says_so = [&bench] { return bench.notes_with(only_first_of_several) == 1; };
    (void)bench.frame(drop);
    bench.frames(2);
    REQUIRE(open_dialog(bench.state) == &unsaved_dialog);
    CHECK_FALSE(says_so());
    bench.key(Key::Escape);
    bench.frames(2);
    CHECK_FALSE(says_so());
    bench.state.editor.saved = bench.scene();
    (void)bench.frame(drop);
    CHECK(says_so());
}

TEST_CASE("a mesh path that cannot be made absolute is rejected in one line", "[ui][modal]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    bench.key(Key::C);
    bench.frames(2);
    bench.state.files.ask(mesh_purpose, "");
    bench.state.files.folder = "rel";
    bench.state.files.name = "x.obj";  // before its field has focus
    bench.frames(2);
    bench.state.notifications.list.clear();
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::create_directory(folder.path("gone"));
    std::filesystem::current_path(folder.path("gone"));
    std::filesystem::remove(folder.path("gone"));
    bench.key(Key::Enter);
    std::filesystem::current_path(here);
    bench.frames(2);
    REQUIRE(bench.state.notifications.list.size() == 1);
    CHECK(bench.state.notifications.list[0].text ==
          "rel/x.obj: cannot be made absolute: No such file or directory; expected an absolute path");
    CHECK(bench.state.get<CompareState>().choice.on);
    CHECK_FALSE(bench.state.loading.active());
}

TEST_CASE("the Enter that answers one dialog does not answer the next", "[ui][modal]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    bench.scene().shading.mode = ShadingMode::Flat;  // of a scene without a file
    bench.frames(2);
    bench.key(Key::Q, true);
    bench.frames(2);
    REQUIRE(bench.state.pending.asking);
    bench.state.editor.document.path = folder.path("new.png");  // offers "new.json" next to it
    bench.key(Key::Enter);                                      // Save: a name is requested
    bench.frames(2);
    CHECK(open_dialog(bench.state) == &files_dialog);
    CHECK(folder.names().empty());
    bench.key(Key::Enter);
    bench.frames(2);
    CHECK(folder.names() == std::vector<std::string>{"new.json"});
}

TEST_CASE("the Enter that chooses in the palette does not answer the dialog that it opens", "[ui][modal]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    const std::string path = folder.path("a.json");
    REQUIRE_FALSE(save_file(bench.state.editor, path, bench.scene()));
    const std::string saved = bytes_of(path);
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.frames(2);
    const auto choose = [&](const char* words) {
        bench.key(Key::K, true);
        bench.frames(1);
        bench.type(words);
        bench.key(Key::Enter);
        bench.frames(2);
    };
    for (const auto& [words, asks] : {std::pair{"quit", &unsaved_dialog},
                                      {"new scene", &unsaved_dialog},
                                      {"save as", &files_dialog},
                                      {"save picture", &files_dialog}}) {
        CAPTURE(words);
        choose(words);
        CHECK(open_dialog(bench.state) == asks);
        CHECK_FALSE(bench.state.files.asks_overwrite);
        CHECK_FALSE(bench.state.quits);
        CHECK(folder.names() == std::vector<std::string>{"a.json"});
        CHECK(bytes_of(path) == saved);
        bench.key(Key::Escape);
        bench.frames(2);
    }
}

TEST_CASE("keys answer the questions about unsaved work", "[ui][window]") {
    const TemporaryDirectory folder;
    HeadlessWindow bench;
    bench.frames(2);
    const auto ask_to_quit = [&] {
        bench.scene().lights[0].intensity += 1;
        bench.frames(2);
        (void)bench.key(Key::Q, true);
        bench.frames(2);
        REQUIRE(bench.state.pending.asking);
    };
    ask_to_quit();
    (void)bench.key(Key::Escape);
    bench.frames(2);
    CHECK_FALSE(bench.state.pending.asking);
    ask_to_quit();
    CHECK(bench.key(Key::D).quit);
}

namespace {

/// Returns the index of the window whose name contains `part`, counted from the back.
std::ptrdiff_t place_of(const std::string& part) {
    const auto& windows = ImGui::GetCurrentContext()->Windows;
    return std::find(windows.begin(), windows.end(), test::window_named(part)) - windows.begin();
}

}  // namespace

TEST_CASE("a file dialog's message is in front of the dialog that returns", "[ui][modal][notifications]") {
    for (const bool long_before : {false, true}) {
        HeadlessWindow bench;
        bench.frames(2);
        run_command(bench.state, test::command_named("Export picture…"));
        bench.frames(3);
        bench.state.files.ask(answers_purpose, "answers.json");
        bench.frames(3);
        REQUIRE(open_dialog(bench.state) == &files_dialog);
        bench.state.notifications.add(Tone::Error, "No room.");
        if (long_before) bench.frames(10);
        bench.state.files.open = false;
        bench.frames(6);
        REQUIRE((bench.state.get<ExportState>().open && !bench.state.files.open));
        CHECK((place_of("##note0") > place_of(ImGui::GetTopMostPopupModal()->Name)) == !long_before);
    }
}

TEST_CASE("a notification is in front of its dialog and lets clicks through", "[ui][modal][notifications]") {
    HeadlessWindow bench;
    bench.frames(2);
    run_command(bench.state, test::command_named("Export picture…"));
    bench.frames(3);
    REQUIRE((bench.state.get<ExportState>().open && !bench.state.files.open));
    bench.state.notifications.add(Tone::Error, "No room.");
    bench.frames(3);
    CHECK(place_of("##note0") > place_of(ImGui::GetTopMostPopupModal()->Name));
    CHECK((test::window_named("##note0")->Flags & ImGuiWindowFlags_NoMouseInputs) != 0);
    bench.state.notifications.list.back().since -= 60;  // it has been read by now
    bench.frames(3);
    CHECK(place_of("##note0") < place_of(ImGui::GetTopMostPopupModal()->Name));
    bench.key(Key::Escape);
    bench.frames(3);
    CHECK((test::window_named("##note0")->Flags & ImGuiWindowFlags_NoMouseInputs) == 0);
}
