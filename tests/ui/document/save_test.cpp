// Saving over another program's changes to the file.
#include <imgui_internal.h>

#include <cstdlib>
#include <filesystem>

#include "models/io/file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/shell/modal.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

void open(HeadlessWindow& bench, const std::string& path) {
    bench.open(path);
    REQUIRE(bench.state.editor.document.path == path);
}

void edit(HeadlessWindow& bench, float intensity) {
    bench.scene().lights[0].intensity = intensity;
    bench.frames(2);
}

float intensity_in(const std::string& path) {
    const auto opened = open_document(path);
    REQUIRE(problem_of(opened) == nullptr);
    return std::get<SceneDocument>(opened).scene.lights[0].intensity;
}

/// Writes as another program would: to a new file that is then renamed.
void write_as_another(const std::string& path, float intensity) {
    Scene scene = test::busy_scene();
    scene.lights[0].intensity = intensity;
    REQUIRE(problem_of(write_file(path, scene_text(scene))) == nullptr);
}

/// Answers the question with the button's letter key if it has one, otherwise by clicking the button.
void answer(HeadlessWindow& bench, const char* button, std::optional<Key> letter = {}) {
    REQUIRE(open_dialog(bench.state) == &changed_dialog);
    if (letter)
        (void)bench.key(*letter);
    else
        bench.click(bench.control(button));
    bench.frames(2);
}

/// A window after Ctrl+S, with a file that was changed both here and by another program.
struct Clash {
    TemporaryDirectory folder;
    std::string path = folder.file("scene.json", scene_text(test::busy_scene()));
    HeadlessWindow bench;

    Clash() {
        bench.frames(2);
        open(bench, path);
        edit(bench, 0.25f);
        write_as_another(path, 0.5f);
        bench.key(Key::S, true);
        bench.frames(3);
        REQUIRE(open_dialog(bench.state) == &changed_dialog);
        CHECK(intensity_in(path) == 0.5f);
    }
};

}  // namespace

TEST_CASE("a file that nobody else changes is saved repeatedly without asking", "[ui][save]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("scene.json", scene_text(test::busy_scene()));
    DrawnWindow bench;
    open(bench, path);
    for (const float intensity : {0.25f, 0.5f, 0.75f}) {
        edit(bench, intensity);
        bench.key(Key::S, true);
        CHECK(intensity_in(path) == intensity);
        CHECK(open_dialog(bench.state) == nullptr);
    }
    edit(bench, 2);
    std::filesystem::remove(path);  // nothing there can be lost
    bench.key(Key::S, true);
    CHECK(intensity_in(path) == 2);
}

TEST_CASE("another program's changes are overwritten only on request", "[ui][save]") {
    Clash clash;
    answer(clash.bench, "Overwrite");
    CHECK(intensity_in(clash.path) == 0.25f);
    CHECK_FALSE(clash.bench.state.editor.unsaved());
    edit(clash.bench, 0.75f);
    clash.bench.key(Key::S, true);  // the file now has this window's version
    CHECK(intensity_in(clash.path) == 0.75f);
}

TEST_CASE("a scene whose file was changed can be saved elsewhere", "[ui][save]") {
    Clash clash;
    std::filesystem::create_directory(clash.folder.path("mine"));
    answer(clash.bench, "Save as…", Key::S);
    CHECK(open_dialog(clash.bench.state) == &files_dialog);
    clash.bench.state.files.folder = clash.folder.path("mine");
    clash.bench.key(Key::Enter);
    CHECK(intensity_in(clash.folder.path("mine/scene.json")) == 0.25f);
    CHECK(intensity_in(clash.path) == 0.5f);
}

TEST_CASE("a changed file can be reloaded", "[ui][save]") {
    Clash clash;
    answer(clash.bench, "Reload", Key::R);
    clash.bench.wait_for_loads();
    CHECK(clash.bench.scene().lights[0].intensity == 0.5f);
    CHECK_FALSE(clash.bench.state.editor.unsaved());
    CHECK(open_dialog(clash.bench.state) == nullptr);
}

TEST_CASE("neither Enter nor Escape overwrites another program's changes", "[ui][save]") {
    Clash clash;
    clash.bench.key(Key::Enter);
    clash.bench.frames(2);
    CHECK(open_dialog(clash.bench.state) == &changed_dialog);
    clash.bench.key(Key::Escape);
    clash.bench.frames(2);
    CHECK(open_dialog(clash.bench.state) == nullptr);
    CHECK(intensity_in(clash.path) == 0.5f);
    CHECK(clash.bench.scene().lights[0].intensity == 0.25f);
}

TEST_CASE("quitting continues only after the question about the changed file is answered", "[ui][save]") {
    Clash clash;
    clash.bench.key(Key::Escape);
    clash.bench.key(Key::Q, true);
    clash.bench.frames(2);
    CHECK(open_dialog(clash.bench.state) == &unsaved_dialog);
    CHECK_FALSE(clash.bench.key(Key::Enter).quit);  // Save
    clash.bench.frames(2);
    REQUIRE(open_dialog(clash.bench.state) == &changed_dialog);
    clash.bench.state.asks_overwrite = false;
    REQUIRE(save_over(clash.bench.state));
    finish_pending(clash.bench.state);
    CHECK(clash.bench.frame().quit);
}

TEST_CASE("a scene without a file gets a name before the window closes", "[ui][save]") {
    const TemporaryDirectory folder;
    DrawnWindow bench;
    edit(bench, 0.25f);
    bench.key(Key::Q, true);
    bench.frames(2);
    const auto quits = [&] {  // on Enter, or soon after
        bool now = bench.key(Key::Enter).quit;
        for (int i = 0; i < 3; ++i) now |= bench.frame().quit;
        return now;
    };
    CHECK_FALSE(quits());  // Save
    REQUIRE(open_dialog(bench.state) == &files_dialog);
    bench.state.files.folder = folder.path();
    bench.frames(2);
    bench.type("new.json");
    CHECK(quits());
    CHECK(intensity_in(folder.path("new.json")) == 0.25f);
}

TEST_CASE("saving recovered work does not overwrite newer changes to the file", "[ui][save]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("scene.json", scene_text(test::busy_scene()));
    std::filesystem::create_directories(folder.path("state"));
    std::string copy;
    for (const bool changed : {false, true}) {
        {
            test::RememberingWindow crashes(folder.path("state"));
            open(crashes, path);
            edit(crashes, 0.25f);
            REQUIRE(keep_unsaved_work(crashes.state));
        }
        if (changed) write_as_another(path, 0.5f);
        HeadlessWindow next;
        begin_persistence(next.state, folder.path("state"));
        REQUIRE_FALSE(next.state.persistence.orphans.empty());
        recover_autosave(next.state, next.state.persistence.orphans[0].lock.path);
        next.wait_for_loads();
        edit(next, 0.75f);
        next.key(Key::S, true);
        next.frames(2);
        CHECK((open_dialog(next.state) == &changed_dialog) == changed);
        CHECK(intensity_in(path) == (changed ? 0.5f : 0.75f));
        end_persistence(next.state);
    }
}

TEST_CASE("saving appends .json unless the name ends with it, in upper or lower case", "[ui][save]") {
    const TemporaryDirectory folder;
    for (const auto& [name, saved] :
         {std::pair("plain", "plain.json"), {"a.scene", "a.scene.json"}, {"b.JSON", "b.JSON"}}) {
        Editor editor;
        take_document(editor, first_scene());
        REQUIRE_FALSE(save_file(editor, folder.path(name), editor.scene()));
        CHECK(editor.document.path == folder.path(saved));
        CHECK(std::filesystem::exists(folder.path(saved)));
    }
    CHECK(folder.names() == std::vector<std::string>{"a.scene.json", "b.JSON", "plain.json"});
}

TEST_CASE("typing replaces the suggested name, in each dialog and folder", "[ui][save]") {
    const TemporaryDirectory folder;
    std::filesystem::create_directory(folder.path("deep"));
    HeadlessWindow bench;
    for (int i = 0; i < 3; ++i) {
        bench.state.files.ask(save_purpose, folder.path("offered.json"));
        bench.frames(4);
        for (const char* const letter : {"d", "e", "e", "p"}) bench.type(letter);
        CHECK(bench.state.files.name == "deep");
        if (i == 2) break;
        bench.key(Key::Escape);
        bench.frames(3);
        CHECK_FALSE(bench.state.files.open);
    }
    ImGui::ClearActiveID();  // as Enter does in a window with focus
    bench.key(Key::Enter);
    bench.frames(4);
    CHECK(bench.state.files.folder.ends_with("/deep"));
    CHECK(bench.state.files.name.empty());
    bench.type("x");
    CHECK(bench.state.files.name == "x");
}

TEST_CASE("a question about one scene does not apply to one opened in the meantime", "[ui][save]") {
    const TemporaryDirectory folder;
    const std::string one = folder.file("one.json", scene_text(test::busy_scene()));
    Scene scene = test::busy_scene();
    scene.lights[0].intensity = 0.125f;
    const std::string two = folder.file("two.json", scene_text(scene)), before = bytes_of(one);
    HeadlessWindow bench;
    open(bench, one);
    bench.state.files.ask(save_purpose, one);
    bench.frames(3);
    bench.key(Key::Enter);
    REQUIRE(bench.state.files.asks_overwrite);
    open(bench, two);
    REQUIRE_FALSE(bench.state.notifications.list.empty());
    CHECK(bench.state.notifications.list.back().text == "Closed a dialog about one.json");
    bench.key(Key::Enter);
    bench.frames(2);
    CHECK(bytes_of(one) == before);
    CHECK(bench.state.editor.document.path == two);
    for (const FilePurpose* purpose :
         {&mesh_purpose, &my_picture_purpose, &save_picture_purpose, &export_purpose, &frames_purpose}) {
        bench.state.files.ask(*purpose, one);
        open(bench, bench.state.editor.document.path == one ? two : one);
        CHECK(open_dialog(bench.state) == nullptr);
    }
    bench.state.get<ExportState>().open = true;
    open(bench, two);
    CHECK(open_dialog(bench.state) == nullptr);
    bench.state.asks_overwrite = true;
    open(bench, one);
    CHECK(open_dialog(bench.state) == nullptr);
    for (const FilePurpose* purpose : {&open_purpose, &answers_purpose}) {  // not about a scene
        bench.state.files.ask(*purpose, "");
        open(bench, two);
        CHECK(open_dialog(bench.state) == &files_dialog);
    }
}

TEST_CASE("an example is not overwritten through a link or by its name", "[ui][save]") {
    const TemporaryDirectory folder;
    std::filesystem::create_directory(folder.path("shipped"));
    const std::string text = scene_text(test::busy_scene());
    const std::string example = folder.file("shipped/example.json", text), link = folder.path("link.json");
    std::filesystem::create_symlink(example, link);
    HeadlessWindow bench;
    bench.state.shipped_scenes = folder.path("shipped");
    open(bench, link);
    edit(bench, 0.75f);
    // Sets the name before its field has focus, because a focused field would restore its own text.
    const auto answer_with = [&bench](const std::string& in, const char* name) {
        bench.state.files.folder = in;
        bench.state.files.name = name;
        bench.frames(2);
        bench.key(Key::Enter);
        bench.frames(2);
    };
    (void)save(bench.state);
    REQUIRE(bench.state.files.open);  // Glint requests a new name
    const Notification& asked = bench.state.notifications.list.back();
    CHECK(asked.text == "This is a built-in example. Choose where to save your copy.");
    CHECK(asked.tone == Tone::Warning);  // nothing is saved yet
    answer_with(folder.path("shipped"), "example.json");
    bench.key(Key::Enter);  // confirms replacing it
    bench.frames(1);
    CHECK(bytes_of(example) == text);
    CHECK(bench.state.notifications.list.back().text ==
          example + ": is in the folder of Glint's examples; expected a folder of your own");
    REQUIRE(bench.state.files.open);
    bench.key(Key::Escape);
    bench.frames(2);
    (void)save(bench.state);
    answer_with(folder.path(), "mine.json");
    CHECK(intensity_in(folder.path("mine.json")) == 0.75f);
    CHECK(bytes_of(example) == text);
}

TEST_CASE("in a file dialog a click selects, a double-click enters a folder or opens a file", "[ui][save]") {
    const TemporaryDirectory folder;
    std::filesystem::create_directory(folder.path("inner"));
    Scene scene = test::busy_scene();
    scene.lights[0].intensity = 0.125f;
    (void)folder.file("inner/scene.json", scene_text(scene));
    DrawnWindow bench;
    bench.key(Key::O, true);
    bench.frames(2);
    bench.state.files.ask(*bench.state.files.purpose, folder.path() + "/");
    bench.frames(3);
    const auto click_first_row = [&] {
        const ImGuiContext& context = *ImGui::GetCurrentContext();
        const auto list =
            std::find_if(context.Windows.begin(), context.Windows.end(), [](const ImGuiWindow* w) {
                return std::string_view(w->Name).find("##entries") != std::string_view::npos;
            });
        REQUIRE(list != context.Windows.end());
        bench.click((*list)->InnerRect.Min + ImVec2(60, (*list)->WindowPadding.y + 8));
    };
    click_first_row();
    bench.frames(30);
    CHECK(std::filesystem::equivalent(bench.state.files.folder, folder.path()));
    click_first_row();
    click_first_row();
    bench.frames(30);
    CHECK(std::filesystem::equivalent(bench.state.files.folder, folder.path("inner")));
    click_first_row();
    bench.frames(30);
    CHECK(bench.state.files.name == "scene.json");
    CHECK(open_dialog(bench.state) == &files_dialog);
    click_first_row();
    click_first_row();
    bench.wait_for_loads();
    CHECK(bench.scene().lights[0].intensity == 0.125f);
    CHECK(open_dialog(bench.state) == nullptr);
}
