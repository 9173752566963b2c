// The examples: their order, captions, and opening.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/headless_window.h"
#include "ui/features/lecture/lecture.h"

using namespace glint;
using namespace glint::test;

namespace {

const std::string shipped_folder = project_file("assets/scenes");

std::string stem(const std::string& path) { return std::filesystem::path(path).stem().string(); }

/// The scenes of the lecture map's rows, each at its first occurrence.
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
    (void)bench.control(chosen.title);  // is visible
    bench.key(Key::Enter);
    bench.wait_for_loads();
    CHECK_FALSE(bench.state.get<ExamplesState>().open);
    CHECK(bench.state.editor.document.path == chosen.path);
}

TEST_CASE("a scene's caption is below its picture and can be hidden", "[ui]") {
    HeadlessWindow bench;
    bench.frames(2);
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
