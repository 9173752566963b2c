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
using test::DrawnWindow;

TEST_CASE("a question during a file dialog comes first, and the dialog returns after it", "[ui][modal]") {
    DrawnWindow bench;
    bench.scene().shading.mode = ShadingMode::Flat;
    bench.frames(2);
    bench.key(Key::O, true);
    bench.frames(2);
    CHECK(open_dialog(bench.state) == &files_dialog);
    bench.drop("other.json");
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

TEST_CASE("the Enter that answers one dialog does not answer the next", "[ui][modal]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    bench.scene().shading.mode = ShadingMode::Flat;  // an edit of a scene without a file
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
    DrawnWindow bench;
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
    DrawnWindow bench;
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

TEST_CASE("a notification is in front of its dialog and lets clicks through", "[ui][modal][notifications]") {
    DrawnWindow bench;
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
