// The copy of unsaved work: written, offered to the next window, recovered or removed.
#include <fcntl.h>
#include <sys/stat.h>

#include <chrono>
#include <ctime>
#include <filesystem>

#include "models/io/file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/document/loading.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

std::size_t copies_in(const TemporaryDirectory& folder) {
    const auto names = folder.names();
    return std::size_t(std::count_if(names.begin(), names.end(),
                                     [](const std::string& name) { return name.ends_with(".autosave"); }));
}

/// Edits until a copy exists.
void edit_and_wait(HeadlessWindow& bench, float intensity) {
    bench.scene().lights[0].intensity = intensity;
    bench.frames(3);
    REQUIRE(bench.state.persistence.autosave.has_value());
    while (bench.state.persistence.autosave_writing) bench.frames(1);
}

/// A window whose unsaved work has been copied.
struct CopiedWindow {
    TemporaryDirectory folder;
    test::RememberingWindow bench{folder.path("state")};
    std::string copy;  // the path of the copy

    CopiedWindow() {
        edit_and_wait(bench, 0.25f);
        copy = bench.state.persistence.autosave->path;
    }
};

}  // namespace

TEST_CASE("a window that has to close leaves a copy of its latest work", "[ui][memory]") {
    const TemporaryDirectory folder;
    test::RememberingWindow bench(folder.path(""));
    CHECK_FALSE(keep_unsaved_work(bench.state));  // nothing is unsaved
    CHECK(copies_in(folder) == 0);
    edit_and_wait(bench, 0.25f);
    bench.scene().lights[0].intensity = 0.625f;  // no copy is due for 5 seconds
    bench.frames(3);
    CHECK(bytes_of(bench.state.persistence.autosave->path).find("0.625") == std::string::npos);
    CHECK(keep_unsaved_work(bench.state));
    CHECK(bytes_of(bench.state.persistence.autosave->path).find("0.625") != std::string::npos);
}

TEST_CASE("unsaved work is copied, found after a crash and recovered by one window only", "[ui][memory]") {
    const TemporaryDirectory folder;
    Scene left;
    {
        test::RememberingWindow crashes(folder.path(""));
        CHECK(copies_in(folder) == 0);
        edit_and_wait(crashes, 0.25f);
        CHECK(copies_in(folder) == 1);
        left = crashes.scene();
        CHECK(orphaned_autosaves(folder.path("")).empty());  // the writing process is still running
    }
    REQUIRE(copies_in(folder) == 1);
    HeadlessWindow next;
    begin_persistence(next.state, folder.path(""));
    REQUIRE(next.state.persistence.orphans.size() == 1);
    CHECK(next.state.persistence.orphans[0].title == "New scene");
    CHECK(orphaned_autosaves(folder.path("")).empty());  // a copy is offered to one window only
    next.frames(2);
    recover_autosave(next.state, next.state.persistence.orphans[0].lock.path);
    next.wait_for_loads();
    next.frames(2);
    CHECK(same_description(next.scene(), left));
    CHECK(next.state.editor.unsaved());
    CHECK(copies_in(folder) == 1);           // the copy is kept until the scene is saved
    next.state.editor.saved = next.scene();  // as saving does
    next.state.editor.saved_edited_camera = next.scene().camera;
    next.frames(2);
    CHECK(copies_in(folder) == 0);
}

TEST_CASE("a copy whose only edit is to the camera is unsaved work and stays until saved", "[ui][memory]") {
    const TemporaryDirectory folder;
    SceneDocument document = first_scene();
    document.path = folder.file("seen.json", scene_text(document.scene));
    {
        test::RememberingWindow crashes(folder.path("state"));
        take_document(crashes.state.editor, document);
        crashes.frames(2);
        crashes.state.editor.edits_camera = true;  // as in columns.cpp
        crashes.scene().camera.eye.z += 1;
        crashes.frames(3);
        REQUIRE(keep_unsaved_work(crashes.state));
    }
    HeadlessWindow next;
    begin_persistence(next.state, folder.path("state"));
    REQUIRE(next.state.persistence.orphans.size() == 1);
    const std::string copy = next.state.persistence.orphans[0].lock.path;
    recover_autosave(next.state, copy);
    next.wait_for_loads();
    next.frames(3);
    CHECK(next.scene().camera.eye.z == document.scene.camera.eye.z + 1);
    CHECK(next.state.editor.unsaved());
    CHECK(std::filesystem::exists(copy));
}

TEST_CASE("a copy loads in the background, if loading is cancelled, it is offered again", "[ui][memory]") {
    const TemporaryDirectory folder;
    {
        HeadlessWindow crashes;
        begin_persistence(crashes.state, folder.path(""));
        edit_and_wait(crashes, 0.25f);
    }
    test::RememberingWindow next(folder.path(""));
    const Scene before = next.scene();
    const std::string copy = next.state.persistence.orphans.at(0).lock.path;
    recover_autosave(next.state, copy);
    CHECK(next.state.loading.active());
    CHECK(next.scene() == before);
    CHECK_FALSE(next.state.editor.unsaved());
    next.key(Key::Escape);
    next.frames(3);
    CHECK_FALSE(next.state.loading.active());
    CHECK(next.scene() == before);
    REQUIRE(next.state.persistence.orphans.size() == 1);
    recover_autosave(next.state, copy);
    next.scene().shading.mode = ShadingMode::Flat;  // unsaved work, so the window has to ask
    next.wait_for_loads();
    REQUIRE(next.state.pending.asking);
    CHECK(next.scene().shading.mode == ShadingMode::Flat);
    finish_pending(next.state);
    next.frames(2);
    CHECK(next.scene().lights[0].intensity == 0.25f);
    CHECK(next.scene().shading.mode == before.shading.mode);
    CHECK(next.state.editor.unsaved());
    CHECK(next.state.persistence.orphans.empty());
    CHECK(copies_in(folder) == 1);
}

TEST_CASE("a copy is offered with its name and time, and not again once answered", "[ui][memory]") {
    const TemporaryDirectory folder;
    const std::string copy = folder.file("0.autosave", autosave_text(first_scene(), folder.path("")));
    // Noon of 29 February 2024, in the local time zone.
    std::tm noon{};
    noon.tm_year = 124, noon.tm_mon = 1, noon.tm_mday = 29, noon.tm_hour = 12, noon.tm_isdst = -1;
    const timespec then[2]{{std::mktime(&noon), 0}, {std::mktime(&noon), 0}};
    REQUIRE(::utimensat(AT_FDCWD, copy.c_str(), then, 0) == 0);
    HeadlessWindow bench;
    begin_persistence(bench.state, folder.path(""));
    bench.frames(1);
    REQUIRE(bench.state.persistence.orphans.size() == 1);
    CHECK(bench.state.persistence.orphans[0].when == "2024-02-29 12:00");
    answer_copy(bench.state, CopyAnswer::NotNow);
    while (ImGui::GetTime() < 3) bench.frames(1);
    CHECK(bench.state.persistence.orphans.empty());
    CHECK(copies_in(folder) == 1);
}

TEST_CASE("two windows keep two copies, and closing a window removes only its own", "[ui][memory]") {
    const TemporaryDirectory folder;
    auto first = std::make_unique<UiState>(1);
    HeadlessWindow bench;
    begin_persistence(bench.state, folder.path(""));
    edit_and_wait(bench, 0.25f);
    auto other = new_autosave(folder.path(""));
    REQUIRE(other.has_value());
    CHECK(other->path != bench.state.persistence.autosave->path);
    CHECK(problem_of(write_file(other->path, autosave_text(first_scene(), folder.path("")))) == nullptr);
    CHECK(copies_in(folder) == 2);
    end_persistence(bench.state);
    CHECK(copies_in(folder) == 1);
    CHECK(orphaned_autosaves(folder.path("")).empty());
    other.reset();
    CHECK(orphaned_autosaves(folder.path("")).size() == 1);
}

TEST_CASE("the meshes of a copy are found, whichever folder the scene is in", "[ui][memory]") {
    const TemporaryDirectory folder;
    std::filesystem::create_directories(folder.path("work/meshes"));
    (void)folder.file("work/meshes/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Scene scene = test::busy_scene();
    scene.objects.resize(1);
    scene.objects[0].source = MeshFile{"meshes/t.obj"};
    const std::string path = folder.file("work/scene.json", scene_text(scene));
    const auto opened = open_document(path);
    REQUIRE(problem_of(opened) == nullptr);
    const auto& document = std::get<SceneDocument>(opened);
    const std::string copy = folder.file("0.autosave", autosave_text(document, folder.path("")));
    const auto again = open_autosave(copy);
    REQUIRE(problem_of(again) == nullptr);
    CHECK(std::get<SceneDocument>(again).path == path);
    CHECK(std::get<SceneDocument>(again).scene.objects[0].mesh->face_count() == 1);
}
