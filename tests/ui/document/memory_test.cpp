// What persists after the window closes: preferences and recent files.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "models/io/file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/fields/field_panel.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Feature settings, all different from their defaults.
Json odd_features() {
    return json_or_null(
        R"({"scope_from": [0.1, 0.2], "scope_to": [0.3, 0.9], "scope_channels": true, "scope_eye": true,
            "compare": {"parts": ["reflection blinn-phong", "edited", "stored"], "lines": [0.2, 0.75],
                        "stacked": true, "difference": true, "gain": 16}, "axes": true})");
}

std::vector<Camera> two_views() {
    std::vector<Camera> views(2);
    views[1].eye = {1, 2.5f, 0.1f};
    views[1].projection = Orthographic{2.25f};
    return views;
}

/// The settings that a window would save after reading these.
Json taken(const std::string& features) {
    HeadlessWindow bench;
    recall_features(bench.state, read_preferences("{\"view\": " + features + "}").features);
    return features_to_remember(bench.state);
}

}  // namespace

TEST_CASE("the list of recent files accepts only absolute paths, each once", "[ui][memory]") {
    const auto recent = [](const std::string& list) {
        return read_preferences("{\"recent\": " + list + "}").recent;
    };
    CHECK(recent(R"(["/a", 3, null, "/a", "b", "", {"x": 1}, "/c\nd", "/c\u007fd", "/e", ["/f"]])") ==
          std::vector<std::string>{"/a", "/e"});
    CHECK(recent(R"({"/a": 1})").empty());
    CHECK(recent("[\"/" + std::string(5000, 'x') + "\"]").empty());
    CHECK(recent("[\"/\xff\xfe\"]").empty());
    std::vector<std::string> paths;
    for (int i = 0; i < 40; ++i) paths = with_recent_file(paths, "/f" + std::to_string(i));
    REQUIRE(paths.size() == max_recent_files);
    CHECK(paths.front() == "/f39");
    CHECK(with_recent_file(paths, "/x/../f35")[0] == "/f35");
    CHECK(with_recent_file(paths, "-") == paths);
    for (const auto& list : std::vector<std::vector<std::string>>{
             paths, {"/n\xff.json", "/B\u00e4lle.json", "/\xC3"}}) {  // file names are bytes, not text
        Preferences settings;
        settings.recent = list;
        CHECK(read_preferences(preferences_text(settings)).recent == list);
    }
}

TEST_CASE("settings are read back unchanged, and valid parts of an invalid file are used", "[ui][memory]") {
    Preferences settings;
    settings.dark = false;
    settings.layout.right = false;
    settings.layout.left_width = 300;
    settings.layout.right_width = 401.5f;
    settings.layout.lesson_width = 333;
    settings.width = 1111;
    settings.height = 777;
    settings.maximized = true;
    settings.kept_views = two_views();
    settings.features = odd_features();
    settings.recent = {"/a"};
    CHECK(read_preferences(preferences_text(settings)) == settings);
    CHECK(read_preferences("") == Preferences());
    CHECK(read_preferences("[1]") == Preferences());
    const Preferences odd = read_preferences(
        R"({"theme": 5, "scene_width": -1e300, "why_width": 1e300, "width": "wide", "maximized": 1, "height": 99999})");
    CHECK(odd.dark);
    CHECK(odd.layout.left_width == least_column_width);
    CHECK(odd.layout.right_width == max_column_width);
    CHECK(odd.width == 0);
    CHECK(odd.height == 16384);
    CHECK_FALSE(odd.maximized);
    std::mt19937 random(5);
    const std::string whole = preferences_text(settings);
    for (int i = 0; i < 2000; ++i) {
        std::string wounded = whole;
        for (int k = 0; k < 3; ++k) wounded[random() % wounded.size()] = static_cast<char>(random() % 256);
        const Preferences read = read_preferences(wounded);
        CHECK(read.layout.left_width >= least_column_width);
        CHECK(read.width <= 16384);
        for (const Camera& camera : read.kept_views) CHECK_FALSE(violation_of(camera));
    }
}

TEST_CASE("comparison, scope and saved views are restored but start switched off", "[ui][memory]") {
    const TemporaryDirectory folder;
    {
        test::RememberingWindow bench(folder.path("state"));
        recall_features(bench.state, odd_features());
        bench.state.kept_views = two_views();
        toggle_scope(bench.state.get<ScopeState>());
        bench.state.get<CompareState>().choice.on = true;
        bench.state.get<DebugViewState>().set = {{DebugView::Depth, 0}, true};
        bench.state.get<LitDotsState>().dots = bench.state.get<LitDotsState>().needles = true;
        bench.key(Key::B, true);
        bench.frames(2);
        end_persistence(bench.state);
    }
    test::RememberingWindow bench(folder.path("state"));
    CHECK(features_to_remember(bench.state) == odd_features());
    CHECK_FALSE(bench.state.get<ScopeState>().open);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    CHECK(bench.state.get<DebugViewState>().set.choice.view == DebugView::Picture);
    CHECK_FALSE(bench.state.get<DebugViewState>().set.over_range);
    CHECK_FALSE(bench.state.get<LitDotsState>().dots);
    CHECK_FALSE(bench.state.get<LitDotsState>().needles);
    CHECK_FALSE(bench.state.get<CompareState>().choice.stored);
    bench.key(Key::U);
    CHECK(bench.scene().camera == two_views()[0]);
    bench.key(Key::B, true);
    reset_layout(bench.state);
    CHECK(features_to_remember(bench.state) == taken("{}"));
    CHECK(bench.state.kept_views == two_views());
    CHECK(bench.state.get<CompareState>().choice.stored);
}

TEST_CASE("the settings folder is created for its owner only, an existing one is unchanged", "[ui][memory]") {
    const TemporaryDirectory folder;
    const auto rights = [&](const char* name) {
        return std::filesystem::status(folder.path(name)).permissions() & std::filesystem::perms::all;
    };
    std::filesystem::create_directory(folder.path("shared"));
    std::filesystem::permissions(folder.path("shared"), std::filesystem::perms(0755));
    for (const char* const name : {"own", "shared"}) {
        test::RememberingWindow bench(folder.path(name));
        end_persistence(bench.state);
    }
    CHECK(rights("own") == std::filesystem::perms(0700));
    CHECK(rights("shared") == std::filesystem::perms(0755));
}

TEST_CASE("theme and columns are restored in the next window", "[ui][memory]") {
    const TemporaryDirectory folder;
    {
        test::RememberingWindow bench(folder.path("state"));
        bench.state.dark = false;
        bench.state.layout.left = false;
        bench.frames(2);
        end_persistence(bench.state);
    }
    HeadlessWindow bench;
    begin_persistence(bench.state, folder.path("state"));
    CHECK_FALSE(bench.state.dark);
    CHECK_FALSE(bench.state.layout.left);
    CHECK(bench.state.layout.right);
    reset_layout(bench.state);
    CHECK(bench.state.layout == LayoutState());
    CHECK(bench.state.dark);
}

TEST_CASE("an opened file becomes the first recent file", "[ui][memory]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("one.json", scene_text(test::busy_scene()));
    test::RememberingWindow bench(folder.path("state"));
    CHECK(bench.state.persistence.preferences.recent.empty());
    bench.open(path);
    CHECK(bench.state.persistence.preferences.recent == std::vector<std::string>{path});
    end_persistence(bench.state);
    CHECK(read_preferences(bytes_of(folder.path("state/window.json"))).recent ==
          std::vector<std::string>{path});
}

TEST_CASE("settings that cannot be written are reported once", "[ui][memory]") {
    const TemporaryDirectory folder;
    test::RememberingWindow bench(folder.path("state"));
    std::filesystem::remove_all(folder.path("state"));
    (void)folder.file("state", "a file in its place");
    bench.frames(200);
    CHECK(bench.notes_with("cannot be remembered") == 0);
    for (int i = 0; i < 2; ++i) {
        bench.key(Key::U, false, true);  // saves a view
        bench.frames(200);
        CHECK(bench.notes_with("The window's settings cannot be remembered: ") == (i == 0 ? 1 : 0));
        bench.scene().camera.eye.x += 1;
    }
}

TEST_CASE("the state folder follows XDG, and a relative path is ignored", "[ui][memory]") {
    const char* old = std::getenv("XDG_STATE_HOME");
    const std::string before = old != nullptr ? old : "";
    setenv("XDG_STATE_HOME", "/somewhere", 1);
    CHECK(state_folder() == "/somewhere/glint");
    setenv("XDG_STATE_HOME", "relative", 1);
    const char* home = std::getenv("HOME");
    REQUIRE(home != nullptr);
    CHECK(state_folder() == std::string(home) + "/.local/state/glint");
    old != nullptr ? setenv("XDG_STATE_HOME", before.c_str(), 1) : unsetenv("XDG_STATE_HOME");
}
