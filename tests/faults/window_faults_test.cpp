// Runs the window while each of its system calls fails in turn: saving, exporting, the copy of unsaved work,
// settings, opening and recovering. The window must report the failure and lose nothing.
#include <climits>
#include <filesystem>

#include "models/io/file.h"
#include "models/json/json.h"
#include "tests/faults/failing_calls.h"
#include "tests/faults/failing_program.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using namespace glint::faults;
using test::HeadlessWindow;

namespace {

constexpr std::array file_kinds{Kind::Open,   Kind::Read, Kind::Write, Kind::Fsync, Kind::Close,
                                Kind::Rename, Kind::Stat, Kind::Lock,  Kind::Mode,  Kind::Thread};

/// Runs `act` once with each fault: every kind and position of a call, failing once and five times in a row.
/// `act` performs the tested action within `during(...)`, and its setup and checks outside.
class InTurn {
  public:
    template <class Act> void operator()(const Act& act) {
        for (const Kind kind : file_kinds) try_kind(kind, 1000, act);
    }
    template <class Do> void during(const Do& action) {
        fail(fault_);
        try {
            action();
        } catch (...) {
            stop();
            throw;
        }
        stop();
        counted_ = calls(fault_.kind);
    }

  private:
    template <class Act> void try_kind(Kind kind, long most, const Act& act) {
        fault_ = {kind, LONG_MAX, 0, 0};
        act(*this);
        const long count = counted_;
        for (const long number : numbers(count, most))
            for (const long in_a_row : {1L, 5L}) {
                fault_ = {kind, number, in_a_row, 0};
                CAPTURE(words_of(fault_), count);
                act(*this);
            }
    }

    Fault fault_;
    long counted_ = 0;
};

struct Bench : HeadlessWindow {
    TemporaryDirectory folder;
    std::string path = folder.file("scene.json", scene_text(test::busy_scene()));
    int edits = 0;

    Bench() : HeadlessWindow({640, 400}) {
        std::filesystem::create_directories(folder.path("state"));
        begin_persistence(state, folder.path("state"));
        (void)frame();
        open(path);
        REQUIRE(state.editor.document.path == path);
    }
    /// Makes another unsaved edit.
    void change() { scene().lights[0].intensity = 7 + 0.001f * float(++edits); }
    void edit() {
        change();
        (void)frame();
    }
    [[nodiscard]] bool says_something() const { return !state.notifications.list.empty(); }
    void wait_for_copy() {
        while (state.persistence.autosave_writing) (void)frame();
    }
};

/// Runs a frame that performs an action before anything else.
template <class Do> void as_in_a_frame(Bench& bench, const Do& action) {
    try {
        action();
    } catch (const std::exception& error) {
        give_up_frame(bench.state, error);
    }
    (void)bench.frame();
}

/// Checks that the folder contains exactly these entries.
void check_names(const TemporaryDirectory& folder, const std::vector<std::string>& names) {
    CHECK(folder.names() == names);
}

/// The text of the scene in the window's copy, or the problem with the copy.
std::string scene_of_copy(const UiState& state) {
    const auto copy = open_autosave(state.persistence.autosave->path);
    if (const Problem* problem = problem_of(copy)) return problem->text();
    return scene_text(std::get<SceneDocument>(copy).scene);
}

/// The number of files in the folder with that ending.
long count_of(const std::string& folder, const std::string& ending) {
    long count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        count += entry.path().string().ends_with(ending) ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("any failure while saving a scene is reported and leaves the file intact", "[faults][ui]") {
    Bench bench;
    InTurn()([&bench](InTurn& turn) {
        bench.edit();
        bench.state.notifications.list.clear();
        const Scene edited = bench.scene();
        const std::string before = bytes_of(bench.path);
        UiInput save_key;
        save_key.presses.push_back({Key::S, true, false, false});
        turn.during([&] { (void)bench.frame(save_key); });
        (void)bench.frame();
        const std::string after = bytes_of(bench.path);
        CHECK(bench.scene() == edited);
        CHECK((after == before || after == scene_text(edited)));
        CHECK(bench.says_something());
        if (after == before) CHECK(bench.state.editor.unsaved());
        check_names(bench.folder, {"scene.json", "state"});
        bench.state.asks_overwrite = false;
        REQUIRE(save_over(bench.state));
        CHECK(bytes_of(bench.path) == scene_text(edited));
        CHECK_FALSE(bench.state.editor.unsaved());
    });
}

TEST_CASE("after any failure while copying unsaved work the next copy is intact", "[faults][ui]") {
    Bench bench;
    const std::string state_folder = bench.folder.path("state");
    InTurn()([&](InTurn& turn) {
        bench.state.notifications.list.clear();
        bench.state.persistence.autosave_failed = false;
        bench.state.persistence.autosaved_at = -1e9;
        bench.change();
        turn.during([&] {
            bench.frames(3);
            bench.wait_for_copy();
            (void)bench.frame();
        });
        (void)bench.frame();
        CHECK(bench.state.editor.unsaved());
        const bool is_copied =
            bench.state.persistence.autosave && bench.state.persistence.has_copy_of(bench.scene());
        CHECK((is_copied || bench.says_something()));
        if (is_copied && !bench.says_something())
            CHECK(scene_of_copy(bench.state) == scene_text(bench.scene()));
        bench.state.persistence.autosaved_at = -1e9;
        bench.change();
        bench.frames(3);
        bench.wait_for_copy();
        REQUIRE(bench.state.persistence.autosave.has_value());
        CHECK(scene_of_copy(bench.state) == scene_text(bench.scene()));
        CHECK(count_of(state_folder, ".tmp") == 0);
        CHECK(count_of(state_folder, ".autosave") == 1);
    });
}

TEST_CASE("after any failure during recovery, unsaved work is recovered or still offered", "[faults][ui]") {
    Bench bench;
    const std::string state_folder = bench.folder.path("state");
    bench.edit();
    const Scene work = bench.scene();
    const std::string text = autosave_text(bench.state.editor.document, state_folder);
    InTurn()([&](InTurn& turn) {
        Persistence& memory = bench.state.persistence;
        drop_autosave(bench.state);
        memory.orphans.clear();
        const std::string left = state_folder + "/0.autosave";
        REQUIRE(problem_of(write_file(left, text)) == nullptr);
        memory.orphans = orphaned_autosaves(state_folder);
        REQUIRE(memory.orphans.size() == 1);
        take_scene(bench.state, std::get<SceneDocument>(open_document(bench.path)));
        bench.frames(2);
        bench.state.notifications.list.clear();
        turn.during([&] {
            as_in_a_frame(bench, [&] { recover_autosave(bench.state, left); });
            while (bench.state.loading.active()) (void)bench.frame();
        });
        bench.frames(2);
        const bool is_taken = same_description(bench.scene(), work);
        CHECK((is_taken || bench.says_something()));
        if (is_taken) CHECK(bench.state.editor.unsaved());
        // In every case the work is in a copy that the next window would find.
        memory.orphans.clear();
        memory.autosave.reset();
        const auto copies = orphaned_autosaves(state_folder);
        REQUIRE_FALSE(copies.empty());
        CHECK(same_description(std::get<SceneDocument>(open_autosave(copies[0].lock.path)).scene, work));
        for (const OrphanedAutosave& copy : copies) std::filesystem::remove(copy.lock.path);
    });
}
