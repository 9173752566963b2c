// The examples: their order, captions, and opening.
#include <fmt/core.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/lecture/lecture.h"

using namespace glint;
using namespace glint::test;
using test::HeadlessWindow;

namespace {

const std::string shipped_folder = project_file("assets/scenes");

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

/// The scenes in the rows of the lecture map, each once, in order of first occurrence.
std::vector<std::string> lecture_map_order() {
    std::ifstream file(project_file("docs/lecture_map.md"));
    std::stringstream text;
    text << file.rdbuf();
    const std::string rows = text.str();
    const std::regex row(R"(\n\| [0-9]+ \|[^|]*\| assets/scenes/([a-z-]+)\.json)");
    std::vector<std::string> order;
    for (std::sregex_iterator at(rows.begin(), rows.end(), row), end; at != end; ++at)
        if (std::find(order.begin(), order.end(), (*at)[1]) == order.end()) order.push_back((*at)[1]);
    return order;
}

}  // namespace

TEST_CASE("the examples are all shipped scenes, in the lecture's order", "[ui][lecture]") {
    const std::vector<Example> examples = examples_in(shipped_folder);
    std::set<std::string> listed, there;
    for (const Example& example : examples) listed.insert(stem(example.path));
    for (const std::string& path : asset_scenes()) there.insert(stem(path));
    CHECK(listed == there);
    CHECK(examples.size() == there.size());
    const std::vector<std::string> map = lecture_map_order();
    REQUIRE(map.size() > 30);
    std::vector<std::string> of_map;  // the examples named in the map
    for (const Example& example : examples)
        if (std::find(map.begin(), map.end(), stem(example.path)) != map.end())
            of_map.push_back(stem(example.path));
    CHECK(of_map == map);
    CHECK(examples.front().title == "Default");
}

TEST_CASE("every shipped scene has a one-line caption", "[scenes]") {
    std::set<std::string> all;
    for (const std::string& path : asset_scenes()) {
        CAPTURE(path);
        const Result<SceneDocument> opened = open_document(path);
        REQUIRE(problem_of(opened) == nullptr);
        const std::string about = std::get<SceneDocument>(opened).scene.about;
        CHECK(about.size() > 30);
        CHECK(about.size() < 140);
        CHECK(about.find('\n') == std::string::npos);
        all.insert(about);
    }
    CHECK(all.size() == asset_scenes().size());
}

TEST_CASE("clicking an example's picture opens it", "[ui]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = shipped_folder;
    run_command(bench.state, command_named("Examples…"));
    while (bench.state.get<ExamplesState>().pictures.taken < 4) bench.frames(1);
    bench.frames(2);
    CHECK(bench.state.get<ExamplesState>().pictures.words[1].find("camera") != std::string::npos);
    // Two of the pictures differ, and neither is empty.
    const PictureSheet& sheet = bench.state.get<ExamplesState>().pictures.sheet;
    const auto middle = [&sheet](int i) {
        const std::size_t at =
            sheet.picture.pixel(i * sheet.cell.width + sheet.cell.width / 2, sheet.cell.height / 2);
        return std::array{sheet.picture.rgba[4 * at], sheet.picture.rgba[4 * at + 1],
                          sheet.picture.rgba[4 * at + 3]};
    };
    CHECK(middle(0) != middle(2));
    CHECK(middle(0)[2] == 255);
    const std::string path = bench.state.get<ExamplesState>().list[1].path;
    bench.click(bench.control("Worked camera"));
    bench.wait_for_loads();
    CHECK_FALSE(bench.state.get<ExamplesState>().open);
    CHECK(bench.state.editor.document.path == path);
}

TEST_CASE("the arrow keys and Enter open an example and scroll to it", "[ui]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = shipped_folder;
    run_command(bench.state, command_named("Examples…"));
    bench.frames(2);
    bench.key(Key::Enter);  // nothing is chosen yet
    CHECK(bench.state.get<ExamplesState>().open);
    bench.key(Key::Right);
    CHECK(bench.state.get<ExamplesState>().chosen == 0);
    bench.key(Key::Left);
    CHECK(bench.state.get<ExamplesState>().chosen == 0);
    bench.key(Key::Right);
    bench.key(Key::Down);
    const int columns = bench.state.get<ExamplesState>().chosen - 1;
    CHECK(columns > 1);
    const int last = static_cast<int>(bench.state.get<ExamplesState>().list.size()) - 1;
    for (int i = 0; i < 100; ++i) bench.key(Key::Down);
    CHECK(bench.state.get<ExamplesState>().chosen > last - columns);
    for (int i = 0; i < 10; ++i) bench.key(Key::Right);
    CHECK(bench.state.get<ExamplesState>().chosen == last);
    bench.frames(2);
    const Example chosen = bench.state.get<ExamplesState>().list.back();
    (void)bench.control(chosen.title);  // fails unless it is visible
    bench.key(Key::Enter);
    bench.wait_for_loads();
    CHECK_FALSE(bench.state.get<ExamplesState>().open);
    CHECK(bench.state.editor.document.path == chosen.path);
}

TEST_CASE("a scene's caption is below its picture and can be hidden", "[ui]") {
    DrawnWindow bench;
    const float before = window_layout(bench.state).centre.high.y;
    bench.scene().about = "Drag the sun.";
    bench.frames(2);
    const Layout with = window_layout(bench.state);
    REQUIRE(with.has_caption);
    CHECK(with.centre.high.y < before);
    CHECK(with.caption.high.y == before);
    bench.key(Key::F11);  // still shown when only the picture is visible
    CHECK(window_layout(bench.state).has_caption);
    run_command(bench.state, command_named("Caption of the scene"));
    CHECK_FALSE(window_layout(bench.state).has_caption);
}

TEST_CASE("the open dialog starts in a folder with scenes", "[ui]") {
    const std::filesystem::path here = std::filesystem::current_path();
    const std::filesystem::path empty = std::filesystem::temp_directory_path() / "glint-empty-test";
    std::filesystem::create_directories(empty);
    std::filesystem::current_path(empty);
    HeadlessWindow bench;
    bench.state.shipped_scenes = shipped_folder;
    bench.frames(1);
    run_command(bench.state, CommandId::Open);
    CHECK(std::filesystem::equivalent(bench.state.files.folder, shipped_folder));
    std::ofstream(empty / "mine.json") << "{}";
    run_command(bench.state, CommandId::Open);
    CHECK(std::filesystem::equivalent(bench.state.files.folder, empty));
    std::filesystem::current_path(here);
    std::filesystem::remove_all(empty);
}

// Tests of the command that draws the exported picture.
namespace {

namespace fs = std::filesystem;

struct Bench : HeadlessWindow {
    Bench() {
        test::use_clipboard(clipboard);
        frames(2);
    }
    [[nodiscard]] bool copied(const std::string& part) const {
        return clipboard.find(part) != std::string::npos;
    }
    void copy() { run_command(state, CommandId::CopyCommand); }

    std::string clipboard;
};

std::string scenes_folder() { return (fs::path(project_folder) / "assets" / "scenes").string(); }

void open_scene(HeadlessWindow& bench, const std::string& name) {
    auto document = open_document((fs::path(scenes_folder()) / name).string());
    REQUIRE(problem_of(document) == nullptr);
    take_document(bench.state.editor, std::get<SceneDocument>(std::move(document)));
    bench.frames(2);
}

/// The output of a shell command.
std::string printed_by(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string printed;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) printed += static_cast<char>(c);
    CHECK(pclose(pipe) == 0);
    return printed;
}

}  // namespace

TEST_CASE("the command copied in a composed view draws the plain scene, and a note says so", "[ui][window]") {
    DrawnWindow bench;
    const auto told = [&bench] {
        bench.state.notifications.list.clear();
        copy_render_command(bench.state, {{64, 48}, 1}, "mine.png");
        return bench.state.notifications.list.at(0).text;
    };
    CHECK(told().starts_with("The command that draws this picture is on the clipboard: 64 × 48"));
    bench.state.get<DebugViewState>().set.choice.view = DebugView::Normal;
    CHECK(told().starts_with("The command that draws the scene's own picture is on"));
    bench.state.get<DebugViewState>().set.choice.view = DebugView::Picture;
    bench.state.get<CompareState>().choice.on = true;
    CHECK(told().starts_with("The command that draws the scene's own picture is on"));
}

TEST_CASE("the export dialog copies the command for its current options", "[ui][window][export]") {
    Bench bench;
    bench.state.get<ExportState>().options = {{333, 222}, 8};
    bench.state.get<ExportState>().open = true;
    bench.frames(3);
    bench.click(bench.control("Copy as command"));
    CHECK(bench.copied("--size 333x222 --samples 8"));
    CHECK(bench.state.get<ExportState>().open);  // the picture can still be saved
}

TEST_CASE("one key saves the picture under an unused name and copies its command", "[ui][window][export]") {
    const TemporaryDirectory folder;
    struct Here {
        std::filesystem::path before = std::filesystem::current_path();
        ~Here() { std::filesystem::current_path(before); }
    } const here;
    std::filesystem::current_path(folder.path(""));
    {
        DrawnWindow bench;
        for (const char* name : {"scene.png", "scene-2.png"}) {
            bench.key(Key::F12, false, true);
            const std::string command = ImGui::GetClipboardText();
            CHECK(command.ends_with(std::string(" -o ") + name));
            const PictureSize size = bench.state.rendered->size;
            CHECK(command.find(fmt::format(" --size {}x{} ", size.width, size.height)) != std::string::npos);
            while (bench.state.get<ExportState>().job) bench.frames(1);
            const auto picture = read_png(folder.path(name));
            REQUIRE(problem_of(picture) == nullptr);
            CHECK(std::get<Picture>(picture).size.width == size.width);
            CHECK(std::get<Picture>(picture).size.height == size.height);
        }
    }
}

TEST_CASE("the command for a shipped scene is short and uses a relative path", "[ui][window][export]") {
    Bench bench;
    const fs::path before = fs::current_path();
    open_scene(bench, "sun.json");
    ImGui::GetIO().DisplaySize = {2400, 800};  // its picture is wider than 16:9, so nothing needs widening
    bench.frames(2);
    fs::current_path(project_folder);
    bench.copy();
    fs::current_path(before);
    CHECK(bench.clipboard.find("glint render assets/scenes/sun.json --size ") == 0);
    CHECK(bench.clipboard.size() < 90);
}

TEST_CASE("the scope's command prints the scope's numbers for an edited, rotated scene",
          "[ui][window][export][scope]") {
    Bench bench;
    open_scene(bench, "still-life.json");
    bench.scene().lights[0].intensity = 0.3f;
    bench.scene().camera.eye.x += 0.5f;
    bench.key(Key::P);
    bench.frames(3);
    REQUIRE(bench.state.get<ScopeState>().open);
    bench.click(bench.control("Copy as command"));
    bench.frames(1);
    REQUIRE(bench.clipboard.find("glint profile ") == 0);
    const Json printed =
        json_or_null(printed_by(glint_program + bench.clipboard.substr(5) + " --format json"));
    const auto& samples = bench.state.get<ScopeState>().samples;
    const Json::array_t& intensity = elements_of(*find_member(printed, "intensity"));
    REQUIRE(intensity.size() == samples.size());
    CHECK(samples.size() > 300);
    for (std::size_t i = 0; i < samples.size(); ++i)
        CHECK(intensity[i].get<double>() == Approx(samples[i].intensity).margin(2e-5));
}

TEST_CASE("a file name that looks like an option is written as a path", "[export]") {
    CHECK(file_word("-a.json") == "./-a.json");
    CHECK(file_word("-") == "-");  // standard input or output
    CHECK(file_word("a-b.json") == "a-b.json");
    CHECK(file_word("- b.json") == "'./- b.json'");
}

TEST_CASE("the command for the unsaved first scene names the built-in file", "[ui][window][export]") {
    Bench bench;
    bench.state.shipped_scenes = scenes_folder();
    auto document = open_document((fs::path(scenes_folder()) / "default.json").string());
    REQUIRE(problem_of(document) == nullptr);
    auto& first = std::get<SceneDocument>(document);
    first.path.clear();
    take_document(bench.state.editor, std::move(first));
    ImGui::GetIO().DisplaySize = {2400, 800};
    bench.frames(2);
    bench.scene().lights[0].intensity = 0.125f;
    bench.copy();
    CHECK(bench.copied("default.json --set /lights/0/intensity=0.125 --size "));
    CHECK(bench.clipboard.size() < 200);
}

TEST_CASE("copying an explanation is reported", "[ui][window]") {
    Bench bench;
    ImGui::GetIO().DisplaySize = {1280, 3000};  // the entire column
    test::ask(bench, InspectorTab::Equation);
    for (const char* format : {"text", "JSON", "LaTeX"}) {
        bench.state.notifications.list.clear();
        bench.click(test::in_column(bench, format));
        bench.frames(1);
        INFO(format);
        REQUIRE_FALSE(bench.state.notifications.list.empty());
        CHECK(bench.state.notifications.list.back().text.find(format) != std::string::npos);
        CHECK_FALSE(bench.clipboard.empty());
    }
}

namespace {

/// A scene with its own mesh file in the folder `name`: a triangle of this size.
std::string scene_with_mesh(const TemporaryDirectory& folder, const std::string& name, double size) {
    fs::create_directory(folder.path(name));
    (void)folder.file(name + "/m.obj", fmt::format("v {0} 0 0\nv 0 {0} 0\nv -{0} 0 0\nf 1 2 3\n", size));
    return folder.file(name + "/s.json", R"({"glint": 1, "lights": [{"position": [0, 0, 3]}], "objects": [
        {"mesh": {"file": "m.obj"}}]})");
}

void open_file(HeadlessWindow& bench, const std::string& path,
               const std::vector<Assignment>& assignments = {}) {
    auto document = open_document(path, assignments);
    REQUIRE(problem_of(document) == nullptr);
    take_scene(bench.state, std::get<SceneDocument>(std::move(document)));
    bench.frames(2);
}

/// Checks that the copied command draws the picture in the window.
void check_command_draws_what_is_shown(Bench& bench, const TemporaryDirectory& folder) {
    const Picture shown = *bench.state.displayed;
    bench.copy();
    const std::size_t out = bench.clipboard.rfind(" -o ");
    REQUIRE(out != std::string::npos);
    const std::string drawn = folder.path("drawn.png"), command = bench.clipboard.substr(0, out);
    const std::size_t program = command.find("glint ");
    REQUIRE(program != std::string::npos);
    (void)printed_by(command.substr(0, program) + glint_program + command.substr(program + 5) + " -o " +
                     drawn);
    const auto picture = read_png(drawn);
    REQUIRE(problem_of(picture) == nullptr);
    CHECK(std::get<Picture>(picture).rgba == shown.rgba);
}

}  // namespace

TEST_CASE("the stored scene B keeps its meshes when another document is opened", "[ui][window][export]") {
    const TemporaryDirectory folder;
    const std::string one = scene_with_mesh(folder, "one", 0.5), two = scene_with_mesh(folder, "two", 1);
    Bench bench;
    open_file(bench, one);
    bench.key(Key::B, true);
    bench.frames(2);
    const Picture first = *bench.state.displayed;
    open_file(bench, two);
    bench.key(Key::B);
    bench.frames(3);
    REQUIRE(bench.state.displayed->rgba == first.rgba);
    check_command_draws_what_is_shown(bench, folder);
    begin_export(bench.state, {first.size, 1}, folder.path("shown.png"));
    while (bench.state.get<ExportState>().job) (void)bench.frame();
    const auto carried = open_document(folder.path("shown.png"));
    REQUIRE(problem_of(carried) == nullptr);
    const Mesh& mesh = *std::get<SceneDocument>(carried).scene.objects[0].mesh;
    CHECK(mesh.positions[0].x == 0.5f);
}

TEST_CASE("the command includes the assignments that the window was started with", "[ui][window][export]") {
    const TemporaryDirectory folder;
    const std::string file = folder.file("s.json", R"({"glint": 1, "lights": [{"position": [0, 2, 3]}],
        "objects": [{}]})");
    Bench bench;
    open_file(bench, file, {{"/shading/mode", "flat"}, {"/global_ambient", "[0.9, 0.1, 0.1]"}});
    check_command_draws_what_is_shown(bench, folder);
    bench.scene().shading.mode = ShadingMode::Phong;  // as in the file
    bench.frames(3);
    check_command_draws_what_is_shown(bench, folder);
    REQUIRE_FALSE(save_file(bench.state.editor, file, bench.scene()));
    bench.copy();
    CHECK_FALSE(bench.copied("global_ambient"));
    check_command_draws_what_is_shown(bench, folder);
}

TEST_CASE("the command redraws a picture that was opened and saved as a scene", "[ui][window][export]") {
    const TemporaryDirectory folder;
    Bench bench;
    open_file(bench, folder.file("s.json", R"({"glint": 1, "lights": [{}], "objects": [{}]})"));
    const PictureSize size = bench.state.rendered->size;
    REQUIRE(9 * size.width < 16 * size.height);  // narrow enough to be fitted
    begin_export(bench.state, {size, 1}, folder.path("s.png"));
    while (bench.state.get<ExportState>().job) (void)bench.frame();
    open_file(bench, folder.path("s.png"));
    REQUIRE_FALSE(save_file(bench.state.editor, folder.path("saved.json"), bench.scene()));
    bench.frames(2);
    check_command_draws_what_is_shown(bench, folder);
}
