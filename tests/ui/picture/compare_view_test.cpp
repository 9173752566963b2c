// Comparisons: every part equals the full picture with its setting, byte for byte.
#include <stdexcept>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/features/lessons/lesson.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

struct ComparingWindow : DrawnWindow {
    ComparingWindow() {
        key(Key::C);
        frames(2);
    }
};

/// Checks that the shown picture's columns from `first` to `end` are those of this mode's own picture.
void check_columns(HeadlessWindow& bench, ShadingMode mode, int first, int end) {
    Scene scene = bench.scene();
    scene.shading.mode = mode;
    Renderer renderer(2);
    const Picture& full = renderer.render(scene, bench.state.rendered->size);
    const Picture& shown = *bench.state.displayed;
    REQUIRE(shown.size == full.size);
    REQUIRE(first < end);
    int wrong = 0;
    for (int y = 0; y < full.size.height; ++y)
        for (std::size_t i = 4 * full.pixel(first, y); i < 4 * full.pixel(end - 1, y) + 4; ++i)
            wrong += full.rgba[i] != shown.rgba[i];
    INFO("columns " << first << " to " << end);
    CHECK(wrong == 0);
}

void check_three(HeadlessWindow& bench) {
    const CompareChoice& choice = bench.state.get<CompareState>().choice;
    const int width = bench.state.rendered->size.width;
    const int one = first_of(choice, 1, width), two = first_of(choice, 2, width);
    check_columns(bench, ShadingMode::Flat, 0, one);
    check_columns(bench, ShadingMode::Gouraud, one, two);
    check_columns(bench, ShadingMode::Phong, two, width);
}

ImVec2 on_line(HeadlessWindow& bench, int wipe) {
    const PictureSize size = bench.state.rendered->size;
    const int column = first_of(bench.state.get<CompareState>().choice, wipe + 1, size.width);
    return bench.at_pixel({column, size.height * 0.3});
}

}  // namespace

TEST_CASE("each part of a comparison equals the full picture of its mode", "[ui][window][compare]") {
    ComparingWindow bench;
    check_three(bench);
    bench.scene().lights[1].position = {-1, 1, 2, 1};
    bench.frames(1);
    check_three(bench);
    bench.scene().camera.eye = {1, 1, 3.5f};
    bench.frames(1);
    check_three(bench);
    bench.key(Key::C);
    bench.frames(1);
    CHECK(bench.state.displayed == bench.state.rendered);
}

TEST_CASE("a dragged wipe line moves the parts' border to the cursor and redraws no scene",
          "[ui][window][compare]") {
    ComparingWindow bench;
    const Scene before = bench.scene();
    const auto serial = bench.state.picture_serial;
    const Renderer* flat = bench.state.get<CompareState>().drawn_by[0];
    bench.drag(on_line(bench, 0), bench.at_pixel({70, 100}));
    const int width = bench.state.rendered->size.width;
    CHECK(first_of(bench.state.get<CompareState>().choice, 1, width) == 70);
    CHECK(bench.state.picture_serial > serial);
    CHECK(flat->stats().redone == std::array{false, false, false, false, false});
    check_three(bench);
    CHECK(bench.scene() == before);
    // A wipe line stops before its neighbour.
    bench.drag(on_line(bench, 0), bench.at_pixel({width - 5.0, 100}));
    const auto& wipes = bench.state.get<CompareState>().choice.wipes;
    CHECK(wipes[0] < wipes[1]);
    check_three(bench);
}

TEST_CASE("a pixel picked in a part is explained by that part's renderer", "[ui][window][compare]") {
    ComparingWindow bench;
    const PictureSize size = bench.state.rendered->size;
    const CompareChoice& choice = bench.state.get<CompareState>().choice;
    const ShadingMode modes[] = {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong};
    for (int part = 0; part < 3; ++part) {
        const int x =
            std::clamp((first_of(choice, part, size.width) + first_of(choice, part + 1, size.width)) / 2,
                       size.width * 2 / 5, size.width * 3 / 5);
        if (part_at(choice, x, size.width) != part) continue;
        const int y = size.height / 2;
        bench.click(bench.at_pixel({x + 0.5, y + 0.5}));
        bench.frames(2);
        REQUIRE(bench.state.on_screen.explanation);
        CHECK(bench.state.on_screen.explanation->mode == modes[part]);
        const std::size_t at = 4 * bench.state.displayed->pixel(bench.state.on_screen.explanation->x,
                                                                bench.state.on_screen.explanation->y);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(bench.state.on_screen.explanation->byte[i] == bench.state.displayed->rgba[at + i]);
    }
}

TEST_CASE("the difference is of the first and last part and has glint compare's numbers",
          "[ui][window][compare]") {
    ComparingWindow bench;
    CompareChoice& choice = bench.state.get<CompareState>().choice;
    choice.difference = true;
    choice.gain = 8;
    bench.frames(1);
    Scene flat = bench.scene(), phong = bench.scene();
    flat.shading.mode = ShadingMode::Flat;
    phong.shading.mode = ShadingMode::Phong;
    Renderer a(1), b(1);
    const Picture &first = a.render(flat, bench.state.rendered->size),
                  &last = b.render(phong, bench.state.rendered->size);
    const auto numbers = std::get<Comparison>(compare(first, last));
    REQUIRE(numbers.max_error > 0);
    CHECK(bench.state.get<CompareState>().numbers.max == numbers.max);
    CHECK(bench.state.get<CompareState>().numbers.mean == numbers.mean);
    int wrong = 0;
    for (std::size_t i = 0; i < first.rgba.size(); ++i) {
        const int far = std::min(8 * std::abs(int(first.rgba[i]) - int(last.rgba[i])), 255);
        if (i % 4 != 3) wrong += bench.state.displayed->rgba[i] != far;
    }
    CHECK(wrong == 0);
}

TEST_CASE("a part without its scene or picture says so and shows the edited scene", "[ui][window][compare]") {
    ComparingWindow bench;
    const CompareState& compare = bench.state.get<CompareState>();
    CompareChoice& choice = bench.state.get<CompareState>().choice;
    set_parts(choice, {{}, {Variant::Kind::Stored, 0}, {Variant::Kind::Mine, 0}});
    bench.frames(2);
    CHECK(part_label(compare, 0) == "As edited");
    CHECK(part_label(compare, 1) == "B: nothing stored");
    CHECK(part_label(compare, 2) == "My picture: not open");
    CHECK(bench.state.displayed->rgba == bench.state.rendered->rgba);
    choice.stored = std::make_shared<const Scene>(bench.scene());
    choice.mine = std::make_shared<const Picture>(*bench.state.rendered);
    CHECK(part_label(compare, 1) == "B, stored");
    CHECK(part_label(compare, 2) == "My picture");
}

TEST_CASE("a part that shows another scene is labelled with that scene", "[ui][window][compare]") {
    ComparingWindow bench;
    const CompareState& compare = bench.state.get<CompareState>();
    CompareChoice& choice = bench.state.get<CompareState>().choice;
    choice.stored = std::make_shared<const Scene>(bench.scene());
    set_parts(choice, {{}, {Variant::Kind::Stored, 0}});
    const auto label = [&] {
        bench.frames(3);
        return part_label(compare, 0);
    };
    CHECK(label() == "As edited");
    choice.shows_stored = true;
    CHECK(label() == "B, stored");
    bench.key(Key::F8);
    CHECK(label() == "Frozen");
    bench.key(Key::F8);
    choice.shows_stored = false;
    bench.state.get<AnimateState>().animation.motion = Motion::Turntable;
    bench.state.get<AnimateState>().playing = true;
    CHECK(label() == "Animated");
    CHECK(part_label(compare, 1) == "B, stored");
}

TEST_CASE("B is the stored scene, and the key that shows it edits nothing", "[ui][window][compare]") {
    DrawnWindow bench;
    CHECK_FALSE(can_run(bench.state, command(CommandId::ShowB)));
    bench.key(Key::B, true);
    const Scene stored = bench.scene();
    bench.scene().lights[0].intensity = 3;
    bench.frames(2);
    const Scene edited = bench.scene();
    bench.key(Key::B);
    bench.frames(2);
    CHECK(bench.state.rendered_scene == stored);
    CHECK(bench.scene() == edited);
    bench.key(Key::B);
    bench.frames(2);
    CHECK(bench.state.rendered_scene == edited);
    // B can also be a part of a comparison, next to the edited scene.
    set_parts(bench.state.get<CompareState>().choice, {{}, {Variant::Kind::Stored, 0}});
    bench.key(Key::C);
    bench.frames(1);
    const PictureSize size = bench.state.rendered->size;
    Renderer renderer(1);
    const Picture& b = renderer.render(stored, size);
    const std::size_t right = 4 * b.pixel(size.width * 11 / 20, size.height / 2);
    CHECK(bench.state.displayed->rgba[right] == b.rgba[right]);
    CHECK(bench.state.displayed->rgba[right] != bench.state.rendered->rgba[right]);
}

TEST_CASE("the scope samples the shown comparison", "[ui][window][compare][scope]") {
    ComparingWindow bench;
    bench.state.get<ScopeState>().open = true;
    bench.frames(2);
    Scene flat = bench.scene();
    flat.shading.mode = ShadingMode::Flat;
    Renderer renderer(1);
    const Picture& full = renderer.render(flat, bench.state.rendered->size, true);
    const int end = first_of(bench.state.get<CompareState>().choice, 1, full.size.width);
    int hits = 0, wrong = 0;
    for (const ProfileSample& s : bench.state.get<ScopeState>().samples)
        if (s.pixel.x < end) {
            wrong += s.color != full.linear_at(s.pixel.x, s.pixel.y);
            hits += s.seen.has_value();
        }
    CHECK(wrong == 0);
    CHECK(hits > 0);
}

TEST_CASE("clicking a part's label lists settings, the chosen one is drawn there", "[ui][window][compare]") {
    ComparingWindow bench;
    const int width = bench.state.rendered->size.width;
    bench.click(bench.at_pixel({width / 6.0, 16}));
    CHECK(bench.state.get<CompareState>().asked == 0);
    bench.frames(2);
    CHECK(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    CHECK_FALSE(bench.state.viewport.probe);
    bench.state.get<CompareState>().choice.parts[0] = variant_of(ShadingMode::Facet);
    bench.frames(1);
    check_columns(bench, ShadingMode::Facet, 0, first_of(bench.state.get<CompareState>().choice, 1, width));
}

TEST_CASE("stacked parts are one above the other, each the full picture of its mode",
          "[ui][window][compare]") {
    ComparingWindow bench;
    CompareChoice& choice = bench.state.get<CompareState>().choice;
    choice.stacked = true;
    bench.frames(1);
    const auto check = [&] {
        const PictureSize size = bench.state.rendered->size;
        const ShadingMode modes[] = {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong};
        for (int part = 0; part < 3; ++part) {
            Scene scene = bench.scene();
            scene.shading.mode = modes[part];
            Renderer renderer(1);
            const Picture& full = renderer.render(scene, size);
            const auto from = std::ptrdiff_t(4 * full.pixel(0, first_of(choice, part, size.height)));
            const auto to = std::ptrdiff_t(4) * size.width * first_of(choice, part + 1, size.height);
            REQUIRE(from < to);
            CHECK(std::equal(full.rgba.begin() + from, full.rgba.begin() + to,
                             bench.state.displayed->rgba.begin() + from));
        }
    };
    check();
    // The line between the parts can be grabbed anywhere along its length, and moves up and down.
    const PictureSize size = bench.state.rendered->size;
    const int row = first_of(choice, 1, size.height);
    bench.drag(bench.at_pixel({size.width * 0.2, row}), bench.at_pixel({size.width * 0.6, 61}));
    CHECK(first_of(choice, 1, size.height) == 61);
    check();
    // A pixel in the bottom part is explained by that part's renderer.
    bench.click(bench.at_pixel({size.width * 0.42, size.height * 0.74}));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->mode == ShadingMode::Phong);
    bench.click(bench.at_pixel({size.width * 0.5, size.height * 0.5}));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->mode == ShadingMode::Gouraud);
}

TEST_CASE("a slow comparison is drawn smaller during a drag and at full size afterwards",
          "[ui][window][compare]") {
    ComparingWindow bench;
    const PictureSize full = bench.state.rendered->size;
    // The parts' times add up: three pictures of 20 ms count as one of 60 ms.
    bench.move(bench.at_pixel({20, 20}));
    bench.button(true, 1);
    bench.move(bench.at_pixel({60, 30}));
    REQUIRE(bench.state.viewport.gesture == Gesture::Pan);
    bench.state.pace.full_ms = 0;
    bench.move(bench.at_pixel({70, 30}));
    REQUIRE(bench.state.pace.drawn_at > 0);
    const double own = bench.state.renderer->stats().total_ms;
    CHECK(bench.state.get<CompareState>().ms > 0);
    const double all = own + bench.state.get<CompareState>().ms;
    if (bench.state.pace.drawn_at == 1) CHECK(bench.state.pace.full_ms == Approx(all));
    bench.state.pace.divisor = 2;
    bench.move(bench.at_pixel({80, 30}));
    CHECK(bench.state.displayed->size == divided(full, 2));
    CHECK(bench.state.displayed->size == bench.state.rendered->size);
    check_columns(bench, ShadingMode::Gouraud,
                  first_of(bench.state.get<CompareState>().choice, 1, full.width / 2),
                  first_of(bench.state.get<CompareState>().choice, 2, full.width / 2));
    bench.button(false, 1);
    bench.frames(2);
    CHECK(bench.state.displayed->size == full);
    check_three(bench);
    // A difference picture is used for measuring, so it is never drawn smaller.
    bench.state.get<CompareState>().choice.difference = true;
    bench.frames(1);
    bench.button(true, 1);
    bench.move(bench.at_pixel({90, 30}));
    bench.state.pace.divisor = 2;
    bench.move(bench.at_pixel({95, 30}));
    CHECK(bench.state.displayed->size == full);
    bench.button(false, 1);
}

TEST_CASE("pressing B toggles the stored scene, holding B shows it temporarily", "[ui][window][compare]") {
    DrawnWindow bench;
    bench.key(Key::B, true);
    const bool& shows = bench.state.get<CompareState>().choice.shows_stored;
    UiInput press, hold;
    press.presses.push_back({Key::B, false, false, false});
    press.b_held = hold.b_held = true;
    const auto held_for = [&](int frames) {
        (void)bench.frame(press);
        CHECK(shows);
        for (int i = 0; i < frames; ++i) (void)bench.frame(hold);
        bench.frames(1);
    };
    held_for(40);  // two thirds of a second
    CHECK_FALSE(shows);
    held_for(6);  // a tenth of a second
    CHECK(shows);
    bench.key(Key::B);
    bench.frames(60);
    CHECK_FALSE(shows);
    // One slow frame is not a long press.
    ImGui::GetIO().DeltaTime = 1.5f;
    held_for(1);
    CHECK(shows);
}
