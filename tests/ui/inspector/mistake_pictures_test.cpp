// The thumbnails of the mistakes: their contents, and when they are drawn. Comparisons of bytes are in double
// parentheses, so that a failure does not print them all.
#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "ui/features/inspector/mistake_row.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Runs frames until all thumbnails are drawn. ImGui's clock counts frames; the job's is real time.
bool wait_for_pictures(HeadlessWindow& bench) {
    const MistakePictures& m = bench.state.get<MistakePictures>();
    for (int i = 0; i < 4000; ++i) {
        bench.frames(1);
        if (m.begun && !m.pictures.job)
            return m.pictures.taken == static_cast<int>(mistake_names().size()) + 1;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// The bytes of the thumbnail at that index.
std::vector<std::uint8_t> shown(const HeadlessWindow& bench, std::size_t index) {
    const PictureSheet& sheet = bench.state.get<MistakePictures>().pictures.sheet;
    const int left = static_cast<int>(index) % sheet.columns * sheet.cell.width,
              top = static_cast<int>(index) / sheet.columns * sheet.cell.height;
    std::vector<std::uint8_t> bytes;
    for (int y = 0; y < sheet.cell.height; ++y) {
        const auto from =
            sheet.picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * sheet.picture.pixel(left, top + y));
        bytes.insert(bytes.end(), from, from + 4 * sheet.cell.width);
    }
    return bytes;
}

std::vector<std::uint8_t> drawn(const Scene& scene, PictureSize size, int samples) {
    Renderer renderer(1);
    return renderer.render(scene, size, false, samples).rgba;
}

/// The text in the row of that mistake.
std::string words_at(const HeadlessWindow& bench, bool Mistakes::*flag) {
    const auto rows = mistakes_as_seen();
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](std::size_t place) { return mistake_names()[place].flag == flag; });
    return bench.state.get<MistakePictures>().pictures.words.at(static_cast<std::size_t>(at - rows.begin()) +
                                                                1);
}

}  // namespace

TEST_CASE("each thumbnail shows the scene with its mistake, or is marked as unchanged", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Mistakes);
    REQUIRE(wait_for_pictures(bench));
    const Scene right = bench.scene();
    const SmallPictures& pictures = bench.state.get<MistakePictures>().pictures;
    const PictureSize cell = pictures.sheet.cell;
    CHECK(cell == PictureSize{96, 72, true});
    const auto right_bytes = drawn(right, cell, 4);
    CHECK((shown(bench, 0) == right_bytes));
    int without = 0;
    for (std::size_t row = 0; row < mistakes_as_seen().size(); ++row) {
        const MistakeName& mistake = mistake_names()[mistakes_as_seen()[row]];
        CAPTURE(mistake.name);
        Scene wrong = right;
        wrong.shading.mistakes.*mistake.flag = true;
        if (pictures.words[row + 1] == no_difference) {
            ++without;
            CHECK((drawn(wrong, {384, 288, true}, 1) == drawn(right, {384, 288, true}, 1)));
            continue;
        }
        const auto wrong_bytes = drawn(wrong, cell, 4);
        CHECK((shown(bench, row + 1) == wrong_bytes));
        int levels = 0;
        for (std::size_t i = 0; i < wrong_bytes.size(); ++i)
            levels = std::max(levels, std::abs(wrong_bytes[i] - right_bytes[i]));
        CHECK((pictures.words[row + 1] == hardly_differs) == (levels < 4));
    }
    CHECK(without > 5);
    CHECK(without < 40);
    // The scene has no spot light, so a mistake in the cone changes nothing.
    CHECK(words_at(bench, &Mistakes::cone_cosines_swapped) == no_difference);
    CHECK(words_at(bench, &Mistakes::normals_flipped).empty());
}

TEST_CASE("thumbnails wait until no button is down and the scene has stopped changing", "[ui][window][why]") {
    HeadlessWindow bench;
    ImGui::GetIO().MousePos = {5, 5};
    ImGui::GetIO().MouseDown[0] = true;
    test::ask(bench, InspectorTab::Mistakes);
    const MistakePictures& m = bench.state.get<MistakePictures>();
    bench.frames(60);
    CHECK_FALSE(m.pictures.job);
    ImGui::GetIO().MouseDown[0] = false;
    for (int i = 0; i < 60; ++i) {  // as during text entry or scrolling
        bench.scene().lights[0].intensity = 0.5f + 0.001f * float(i);
        bench.frames(1);
    }
    CHECK_FALSE(m.begun);
    CHECK(m.pictures.sheet.serial == 0);
    REQUIRE(wait_for_pictures(bench));
    CHECK(bench.frame().sleep_s > 1);  // and no additional frame is requested
}

TEST_CASE("a new scene, view or size redraws thumbnails, toggling a mistake does not", "[ui][window][why]") {
    HeadlessWindow bench;
    test::ask(bench, InspectorTab::Mistakes);
    REQUIRE(wait_for_pictures(bench));
    const SmallPictures& pictures = bench.state.get<MistakePictures>().pictures;
    const auto before = shown(bench, 0);
    bench.scene().lights[0].intensity *= 0.5f;
    bench.frames(1);
    CHECK(pictures.taken == 0);          // dimmed: they show the previous scene
    CHECK((shown(bench, 0) == before));  // but not removed
    REQUIRE(wait_for_pictures(bench));
    const auto darker = shown(bench, 0);
    CHECK((darker == drawn(bench.scene(), pictures.sheet.cell, 4)));
    CHECK((darker != before));
    bench.scene().camera.eye.x += 0.5f;
    REQUIRE(wait_for_pictures(bench));
    CHECK((shown(bench, 0) != darker));
    bench.state.layout.right_width = 230;
    REQUIRE(wait_for_pictures(bench));
    CHECK(pictures.sheet.cell.width < 80);
    const auto serial = pictures.sheet.serial;
    bench.scene().shading.mistakes.normals_flipped = true;
    bench.frames(40);
    CHECK(pictures.taken == static_cast<int>(mistakes_as_seen().size()) + 1);
    CHECK(pictures.sheet.serial == serial);
}
