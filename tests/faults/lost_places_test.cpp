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
        open(path);
        scene().lights[0].intensity = 7;
        frames(3);
        while (state.persistence.autosave_writing) (void)frame();
        state.notifications.list.clear();
    }
    void press_save() {
        (void)key(Key::S, true);
        frames(2);
    }
    /// On a slow machine, writing the window's settings may fail at the same moment.
    [[nodiscard]] std::vector<Notification> messages_about_scene() const {
        std::vector<Notification> messages;
        for (const Notification& n : state.notifications.list)
            if (n.text.starts_with(path)) messages.push_back(n);
        return messages;
    }
    /// Checks that one message contains `why` and names the file, that the scene is still open and unsaved,
    /// and that a copy of it exists.
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

TEST_CASE("failing to save to a full disk is reported, the old file and the work are kept", "[faults][ui]") {
    Edited bench;
    fail({Kind::Write, 0, LONG_MAX, ENOSPC});
    bench.press_save();
    stop();
    CHECK(bytes_of(bench.path) == bench.old_text);
    CHECK(fs::directory_iterator(bench.folder.path("work")) != fs::directory_iterator());
    CHECK(std::distance(fs::directory_iterator(bench.folder.path("work")), {}) == 1);
    bench.check_nothing_is_lost("no space left on the device");
}

TEST_CASE("failing to save to a read-only folder is reported, the work is kept", "[faults][ui]") {
    Edited bench;
    fail({Kind::Open, 0, LONG_MAX, EROFS});  // file permissions do not apply to every user who runs this test
    bench.press_save();
    stop();
    CHECK(bytes_of(bench.path) == bench.old_text);
    bench.check_nothing_is_lost("read-only file system");
}
