// A picture from another program: comparison, diagnosis in the background, and the suggested experiment.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "diagnose/diagnosis_format.h"
#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "ui/document/document_actions.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::DrawnWindow;

namespace {

constexpr PictureSize brought_size{160, 90};

/// A window and a folder for the pictures that are brought to it.
struct MyPictureWindow : DrawnWindow {
    [[nodiscard]] MyPictureState& mine() { return state.get<MyPictureState>(); }
    /// The open scene's picture as a program with flipped normals would draw it.
    [[nodiscard]] Picture flipped_picture(PictureSize size = brought_size, bool linear = false) {
        Scene wrong = scene();
        wrong.shading.mistakes.normals_flipped = true;
        return Renderer(1).render(wrong, size, linear);
    }
    /// Runs frames until no picture is being read and no search is running.
    void wait_for_answer() {
        do {
            (void)frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (mine().reading || (mine().shown && !mine().settled));
        frames(2);
    }
    /// Drops a file with these bytes and waits for its diagnosis.
    void bring(const std::string& name, const std::string& bytes) {
        drop(folder.file(name, bytes));
        wait_for_answer();
    }
    void bring(const Picture& picture) { bring("mine.png", png_bytes(picture, "")); }
    [[nodiscard]] const Diagnosis& found() {
        REQUIRE(mine().answer);
        return mine().answer->diagnosis;
    }

    TemporaryDirectory folder;
};

}  // namespace

TEST_CASE("an opened picture ends a freeze and is compared with the current scene", "[ui][window][mine]") {
    MyPictureWindow bench;
    bench.key(Key::F8);
    REQUIRE(bench.state.get<LectureState>().frozen);
    bench.scene().global_ambient = {1, 1, 1};
    bench.bring(bench.flipped_picture());
    CHECK_FALSE(bench.state.get<LectureState>().frozen);
    CHECK(bench.state.rendered_scene == bench.scene());
}

TEST_CASE("a picture from Glint keeps the framing that it was drawn with", "[ui][window][mine]") {
    MyPictureWindow bench;
    Renderer renderer(1);
    const Picture& square = renderer.render(bench.scene(), {300, 300, true});
    const auto read_and_diagnose = [&](const std::string& scene_text) {
        bring_picture(bench.state, bench.folder.file("mine.png", png_bytes(square, scene_text)));
        bench.wait_for_answer();
        bench.state.get<CompareState>().choice.difference = true;
        bench.frames(2);
        CHECK(bench.found().verdict == Verdict::NoMistake);
        CHECK(bench.state.get<CompareState>().numbers.mean[0] < 2);  // the two pictures differ in size
    };
    read_and_diagnose(scene_text(bench.scene()));
    bench.key(Key::Escape);
    bench.state.editor.document.fitted_to = PictureSize{600, 600, true};
    read_and_diagnose("");  // as if another program had drawn the square picture
}

TEST_CASE("the effect of display mistakes is removed from the compared picture", "[ui][window][mine]") {
    MyPictureWindow bench;
    const Picture upright = bench.flipped_picture();
    Picture turned = upright;
    for (int y = 0; y < brought_size.height; ++y)
        std::copy_n(&upright.rgba[4 * upright.pixel(0, y)], 4 * brought_size.width,
                    &turned.rgba[4 * turned.pixel(0, brought_size.height - 1 - y)]);
    bench.bring(turned);
    INFO(diagnosis_text(bench.found(), bench.scene()));
    CHECK(bench.found().display.change.upside_down);
    REQUIRE(bench.state.get<CompareState>().choice.mine);
    CHECK(bench.state.get<CompareState>().choice.mine->rgba == upright.rgba);
}

TEST_CASE("an experiment is offered only for the scene that it was found for", "[ui][window][mine]") {
    MyPictureWindow bench;
    bench.bring(bench.flipped_picture());
    const auto is_offered = [&bench] {
        return std::any_of(bench.controls().begin(), bench.controls().end(),
                           [](const NamedControl& c) { return c.name == "Change the scene this way"; });
    };
    const WindowCommand& by_command = test::command_named("Change the scene to confirm the mistake");
    CHECK(is_offered());
    CHECK(can_run(bench.state, by_command));
    bench.scene().lights.erase(bench.scene().lights.begin());
    bench.frames(2);
    CHECK_FALSE(is_offered());
    CHECK_FALSE(can_run(bench.state, by_command));
    bench.key(Key::Z, true);
    bench.wait_for_answer();
    const Scene before = bench.scene();
    run_command(bench.state, by_command);
    bench.frames(2);
    CHECK(shown_experiment(bench.state) != nullptr);
    CHECK_FALSE(bench.scene() == before);
    CHECK_FALSE(can_run(bench.state, by_command));
}

TEST_CASE("the search ends when cancelled and restarts when the scene changes", "[ui][window][mine]") {
    MyPictureWindow bench;
    bench.drop(bench.folder.file("mine.png", png_bytes(bench.flipped_picture({800, 450}), "")));
    while (!bench.mine().job) (void)bench.frame();
    bench.frames(2);
    bench.click(test::in_column(bench, "Cancel the search"));
    CHECK_FALSE(bench.mine().job);
    bench.wait_for_answer();
    CHECK_FALSE(bench.mine().answer);
    CHECK(bench.state.notifications.list.empty());
    REQUIRE(bench.mine().shown);
    bench.scene().lights[0].intensity = 0.5f;
    bench.frames(2);
    bench.wait_for_answer();
    REQUIRE(bench.mine().answer);
    bench.click(test::in_column(bench, "Close my picture"));
    CHECK_FALSE(bench.mine().shown);
}

TEST_CASE("an incompatible picture is reported, and an unreadable one in one line", "[ui][window][mine]") {
    MyPictureWindow bench;
    const Scene start = bench.scene();
    bench.state.get<InspectorState>().tab = InspectorTab::Vectors;
    bench.state.get<CompareState>().choice.gain = 4;
    const CompareChoice compared = bench.state.get<CompareState>().choice;
    Scene other = bench.scene();
    Renderer renderer(1);
    const Picture wide = renderer.render(other, {320, 180});
    Picture narrow{{240, 180}, {}, {}};  // the same picture, squeezed: drawn for 16:9, opened as 4:3
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                narrow.rgba.push_back(wide.rgba[4 * wide.pixel(x * 4 / 3, y) + c]);
    bench.bring(narrow);
    CHECK(bench.found().verdict == Verdict::NotComparable);
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::MyPicture);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.mine().shown);
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Vectors);
    CHECK(bench.state.get<CompareState>().choice == compared);
    CHECK(bench.state.notifications.list.empty());

    const std::string whole = png_bytes(wide, "");
    bench.bring("cut.png", whole.substr(0, whole.size() / 2));
    REQUIRE(bench.state.notifications.list.size() == 1);
    const std::string& said = bench.state.notifications.list[0].text;
    CHECK(said.find("cut.png: ") != std::string::npos);
    CHECK(std::count(said.begin(), said.end(), '\n') == 0);
    CHECK_FALSE(bench.mine().shown);
    CHECK(bench.scene() == start);
    CHECK(bench.state.get<CompareState>().choice == compared);
}

TEST_CASE("a picture with a scene opens as that scene, a command compares the picture",
          "[ui][window][mine]") {
    MyPictureWindow bench;
    const std::string path =
        bench.folder.file("carries.png", png_bytes(bench.flipped_picture(), scene_text(bench.scene())));
    bench.open(path);
    CHECK(bench.state.editor.document.path == path);
    CHECK_FALSE(bench.mine().shown);
    run_command(bench.state, test::command_named("Compare my picture…"));
    REQUIRE(bench.state.files.open);
    bench.state.files.folder = bench.folder.path();
    bench.state.files.name = "carries.png";
    bench.frames(2);
    bench.key(Key::Enter);
    bench.wait_for_answer();
    CHECK(bench.mine().shown);
    CHECK(bench.found().verdict == Verdict::Mistake);
    run_command(bench.state, test::command_named("Close my picture"));
    CHECK_FALSE(bench.mine().shown);
}

TEST_CASE("pictures without a scene are read in every format", "[ui][window][mine]") {
    MyPictureWindow bench;
    const Picture drawn = bench.flipped_picture(brought_size, true);
    for (const auto& [name, format] :
         {std::pair{"mine.pfm", PictureFormat::Pfm}, {"mine.exr", PictureFormat::Exr}}) {
        bench.bring(name, picture_bytes(drawn, format, bench.scene().display.exposure, ""));
        CHECK(bench.mine().name == name);
        REQUIRE(bench.mine().shown);
        CHECK(bench.mine().shown->rgba == drawn.rgba);
    }
}

TEST_CASE("the picked pixel shows its submitted, correct and mistaken values", "[ui][window][mine]") {
    MyPictureWindow bench;
    const Picture picture = bench.flipped_picture({960, 540});
    bench.bring(picture);
    test::ask(bench, InspectorTab::Equation, {0.5, 0.45});
    bench.frames(2);
    const PixelOfMine pixel = *pixel_of_mine(bench.state);
    const Explanation& e = *bench.state.on_screen.explanation;
    CHECK(pixel.right.byte == e.byte);
    REQUIRE(pixel.mistaken);
    // The window shows the width of a 16:9 picture, so equal fractions of both widths are the same position.
    CHECK(pixel.place.x == 960 * (2 * e.x + 1) / (2 * bench.state.rendered->size.width));
    const Rgb mine = rgb_at(picture, picture.pixel(pixel.place.x, pixel.place.y));
    CHECK(pixel.mine == mine);
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(pixel.mistaken->byte[c] - int{mine[c]}) <= 3);
    CHECK(pixel.mistaken->byte != e.byte);
    for (const char* line : {"right", "Normals flipped"})
        CHECK(bench.area_of(line, test::right_column(bench)).high.y > 0);
}

TEST_CASE("two mistakes at once are searched for on request and named together", "[ui][window][mine]") {
    MyPictureWindow bench;
    Scene wrong = bench.scene();
    wrong.shading.mistakes.absolute_cosine = wrong.shading.mistakes.light_in_wrong_space = true;
    Renderer renderer(1);
    CHECK_FALSE(can_run(bench.state, test::command_named("Look for two mistakes at once")));
    bench.bring(renderer.render(wrong, brought_size));
    CHECK(bench.found().verdict == Verdict::NotInCatalogue);
    const WindowCommand& by_command = test::command_named("Look for two mistakes at once");
    CHECK(can_run(bench.state, by_command));
    bench.click(test::in_column(bench, "Look for two mistakes at once"));
    bench.wait_for_answer();
    CHECK_FALSE(can_run(bench.state, by_command));
    CHECK(bench.found().verdict == Verdict::Mistake);
    REQUIRE_FALSE(bench.found().candidates.empty());
    INFO(name_of(bench.found().candidates[0].mistakes));
    CHECK(under_mistakes(bench.scene(), bench.found().candidates[0].mistakes) == wrong);
}

TEST_CASE("a picture closes when another scene opens, and a click compares it again", "[ui][window][mine]") {
    MyPictureWindow bench;
    const SceneDocument first = bench.state.editor.document;
    bench.bring(bench.flipped_picture());
    SceneDocument other = first;
    other.path = bench.folder.path() + "/other.json";
    take_scene(bench.state, other);
    bench.frames(2);
    CHECK_FALSE(bench.mine().shown);
    CHECK_FALSE(bench.state.get<CompareState>().choice.on);
    bench.state.get<InspectorState>().tab = InspectorTab::MyPicture;
    bench.frames(2);
    bench.click(test::in_column(bench, "Compare mine.png again"));
    bench.wait_for_answer();
    CHECK(bench.found().verdict == Verdict::Mistake);
    take_scene(bench.state, other);  // the same file, read again
    bench.frames(2);
    CHECK(bench.mine().shown);
}

TEST_CASE("the bytes of a linear picture follow the scene's display settings", "[ui][window][mine]") {
    MyPictureWindow bench;
    Display& display = bench.scene().display;
    const Picture drawn = bench.flipped_picture(brought_size, true);
    bench.bring("mine.pfm", picture_bytes(drawn, PictureFormat::Pfm, display.exposure, ""));
    display.transfer = display.transfer == Transfer::Srgb ? Transfer::None : Transfer::Srgb;
    bench.frames(2);
    bench.wait_for_answer();
    CHECK(bench.mine().shown->rgba == bench.flipped_picture().rgba);
    CHECK(bench.found().verdict == Verdict::Mistake);
    CHECK(bench.found().display.change.encodings() == 0);
}
