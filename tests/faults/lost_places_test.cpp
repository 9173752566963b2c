// A full disk, a read-only folder, a deleted folder: the window reports it once, the scene stays open and
// unsaved, and unsaved work is offered after a crash. Written files are synced to disk.
#include <climits>
#include <filesystem>

#include "models/io/file.h"
#include "tests/faults/failing_calls.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using namespace glint::faults;
using test::HeadlessWindow;
namespace fs = std::filesystem;

namespace {

/// A window with an edited scene, and its copy in a state folder.
struct Edited : HeadlessWindow {
    TemporaryDirectory folder;
    std::string path, state_folder = folder.path("state"), old_text = scene_text(test::busy_scene());

    Edited() : HeadlessWindow({640, 400}) {
        fs::create_directory(folder.path("work"));
        path = folder.file("work/scene.json", old_text);
        begin_persistence(state, state_folder);
        (void)frame();
        UiInput drop;
        drop.dropped = {path};
        (void)frame(drop);
        wait_for_loads();
        scene().lights[0].intensity = 7;
        frames(3);
        while (state.persistence.autosave_writing) (void)frame();
        state.notifications.list.clear();
    }
    void press_save() {
        (void)key(Key::S, true);
        frames(2);
    }
    /// On a slow machine the settings of the window may fail to be written in the same moment.
    [[nodiscard]] std::vector<Notification> messages_about_scene() const {
        std::vector<Notification> messages;
        for (const Notification& n : state.notifications.list)
            if (n.text.starts_with(path)) messages.push_back(n);
        return messages;
    }
    /// One message that contains `why` and names the file; the scene is still open and unsaved, and a copy of
    /// it exists.
    void check_nothing_is_lost(const std::string& why) {
        const std::vector<Notification> errors = messages_about_scene();
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].tone == Tone::Error);
        CHECK(errors[0].text.starts_with(path + ": cannot write: " + why));
        CHECK(state.editor.unsaved());
        CHECK(scene().lights[0].intensity == 7);
        state.persistence.autosave.reset();  // as when the process ends
        const auto left = orphaned_autosaves(state_folder);
        REQUIRE(left.size() == 1);
        const auto copy = open_autosave(left[0].lock.path);
        REQUIRE(problem_of(copy) == nullptr);
        CHECK(std::get<SceneDocument>(copy).scene.lights[0].intensity == 7);
        CHECK(std::get<SceneDocument>(copy).path == path);
    }
};

}  // namespace

TEST_CASE("on a full disk saving reports it, keeps the old file and the work", "[faults][ui]") {
    Edited bench;
    fail({Kind::Write, 0, LONG_MAX, ENOSPC});
    bench.press_save();
    stop();
    CHECK(bytes_of(bench.path) == bench.old_text);
    CHECK(fs::directory_iterator(bench.folder.path("work")) != fs::directory_iterator());
    CHECK(std::distance(fs::directory_iterator(bench.folder.path("work")), {}) == 1);
    bench.check_nothing_is_lost("no space left on the device");
}

TEST_CASE("on a disk that is full only at closing a file the old file is intact", "[faults][ui]") {
    Edited bench;
    fail({Kind::Close, 0, LONG_MAX, ENOSPC});
    bench.press_save();
    stop();
    CHECK(bytes_of(bench.path) == bench.old_text);
    bench.check_nothing_is_lost("no space left on the device");
}

TEST_CASE("in a read-only folder saving reports it and keeps the work", "[faults][ui]") {
    Edited bench;
    fail({Kind::Open, 0, LONG_MAX, EROFS});  // file permissions do not apply to every user who runs this
    bench.press_save();
    stop();
    CHECK(bytes_of(bench.path) == bench.old_text);
    bench.check_nothing_is_lost("read-only file system");
}

TEST_CASE("in a deleted folder saving reports it, and works again after it is restored", "[faults][ui]") {
    Edited bench;
    fs::remove_all(bench.folder.path("work"));
    bench.press_save();
    REQUIRE(bench.messages_about_scene().size() == 1);
    CHECK(bench.state.editor.unsaved());
    fs::create_directory(bench.folder.path("work"));
    bench.state.notifications.list.clear();
    bench.press_save();
    CHECK(bytes_of(bench.path) == scene_text(bench.scene()));
    CHECK_FALSE(bench.state.editor.unsaved());
}

TEST_CASE("after the folder was deleted the work is kept", "[faults][ui]") {
    Edited bench;
    fs::remove_all(bench.folder.path("work"));
    bench.press_save();
    bench.check_nothing_is_lost("no such file or directory");
}

TEST_CASE("a deleted folder of copies is recreated, with the copy and the settings", "[faults][ui]") {
    Edited bench;
    fs::remove_all(bench.state_folder);
    bench.state.persistence.autosaved_at = -1e9;
    bench.scene().lights[0].intensity = 8;
    bench.frames(3);
    while (bench.state.persistence.autosave_writing) bench.frames(1);
    CHECK(bench.state.notifications.list.empty());
    CHECK(fs::status(bench.state_folder).permissions() == fs::perms::owner_all);
    bench.state.persistence.autosave.reset();
    {
        const auto left = orphaned_autosaves(bench.state_folder);
        REQUIRE(left.size() == 1);
        CHECK(std::get<SceneDocument>(open_autosave(left[0].lock.path)).scene.lights[0].intensity == 8);
    }
    fs::remove_all(bench.state_folder);
    bench.state.dark = !bench.state.dark;
    bench.frames(1);
    end_persistence(bench.state);
    CHECK(fs::exists(bench.state_folder + "/window.json"));
}

TEST_CASE("a file in place of the folder of copies is reported once", "[faults][ui]") {
    Edited bench;
    fs::remove_all(bench.state_folder);
    (void)bench.folder.file("state", "");
    for (int i = 0; i < 3; ++i) {
        bench.state.persistence.autosaved_at = -1e9;
        bench.scene().lights[0].intensity = 8 + float(i);
        bench.frames(3);
        while (bench.state.persistence.autosave_writing) bench.frames(1);
        bench.frames(1);
    }
    CHECK(bench.notes_with("No copy of the unsaved work can be kept: ") == 1);
    fs::remove(bench.state_folder);
    bench.state.persistence.autosaved_at = -1e9;
    bench.scene().lights[0].intensity = 12;
    bench.frames(3);
    while (bench.state.persistence.autosave_writing) bench.frames(1);
    bench.state.persistence.autosave.reset();
    const auto left = orphaned_autosaves(bench.state_folder);
    REQUIRE(left.size() == 1);
    CHECK(std::get<SceneDocument>(open_autosave(left[0].lock.path)).scene.lights[0].intensity == 12);
}
