// References to lights or objects by index, after earlier ones are added or deleted.
#include <random>

#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/document/scene_edit.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Opens three lights, all called "Light", with intensities 1, 2 and 3, and selects the first one.
void take_three(HeadlessWindow& bench) {
    bench.frames(1);
    Scene& scene = bench.scene();
    scene.lights.assign(3, scene.lights[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        scene.lights[i].name = "Light";
        scene.lights[i].intensity = 1 + static_cast<float>(i);
    }
    bench.frames(2);
    bench.state.editor.selection = {Selection::Kind::Light, 0};
}

/// Deletes the selection while that number is animated.
void delete_while_it_goes(HeadlessWindow& bench, const char* number, const Selection& selection) {
    bench.state.get<AnimateState>().animation.motion = Motion::PingPong;
    bench.state.get<AnimateState>().animation.pointer = number;
    bench.state.editor.selection = selection;
    bench.frames(2);
    run_command(bench.state, test::command_named("Delete"));
    bench.frames(2);
}

}  // namespace

TEST_CASE("an item is found in a changed list by its unchanged neighbours unless deleted", "[ui]") {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::vector<int> before(1 + random() % 8);
        for (std::size_t i = 0; i < before.size(); ++i) before[i] = static_cast<int>(i);
        std::vector<int> after = before;
        const auto place = static_cast<std::ptrdiff_t>(random() % before.size());
        const int count = static_cast<int>(1 + random() % 3);  // of added or deleted neighbours
        if (random() % 2 == 0)
            after.insert(after.begin() + place, static_cast<std::size_t>(count), 99);
        else
            after.erase(after.begin() + place,
                        after.begin() + std::min(place + count, std::ptrdiff_t(after.size())));
        for (int i = 0; i < static_cast<int>(before.size()); ++i) {
            const auto found = std::find(after.begin(), after.end(), i);
            CHECK(place_in(before, after, i) ==
                  (found == after.end() ? -1 : static_cast<int>(found - after.begin())));
        }
    }
    CHECK(place_in(std::vector{1, 2, 3}, std::vector{7, 8, 9}, 1) == 1);  // all edited in place
}

TEST_CASE("a view of a light keeps its light when earlier lights are deleted or added", "[ui][window]") {
    HeadlessWindow bench;
    take_three(bench);
    bench.state.get<DebugViewState>().set.choice.light = 1;
    bench.state.get<TermGridState>().solo = GridCell{1, 2};
    bench.state.get<TermGridState>().muted = {{-1, 1}, {0, 0}, {2, 1}};
    bench.state.get<AnimateState>().animation.motion = Motion::PingPong;
    bench.state.get<AnimateState>().animation.pointer = "/lights/1/intensity";
    bench.frames(2);
    const auto check_second = [&](int place) {
        CHECK(bench.state.get<DebugViewState>().set.choice.light == place);
        CHECK(bench.state.get<TermGridState>().solo == GridCell{place, 2});
        CHECK(bench.state.get<AnimateState>().animation.pointer ==
              "/lights/" + std::to_string(place) + "/intensity");
        CHECK(bench.scene().lights[static_cast<std::size_t>(place)].intensity == 2);
        for (const Notification& note : bench.state.notifications.list) CHECK(note.tone == Tone::Done);
    };
    run_command(bench.state, test::command_named("Delete"));
    bench.frames(2);
    check_second(0);
    CHECK(bench.state.get<TermGridState>().muted == std::vector<GridCell>{{-1, 1}, {1, 1}});
    bench.state.editor.selection = {Selection::Kind::Light, 1};
    run_command(bench.state, test::command_named("Undo"));
    bench.frames(2);
    check_second(1);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Light, 2});  // the same light
    bench.state.editor.selection = {Selection::Kind::Light, 0};
    run_command(bench.state, test::command_named("Duplicate"));
    bench.frames(2);
    check_second(2);
}

TEST_CASE("an animated number stays with its light, even among lights of the same name",
          "[ui][window][animate]") {
    HeadlessWindow bench;
    take_three(bench);
    delete_while_it_goes(bench, "/lights/1/intensity", {Selection::Kind::Light, 1});
    CHECK(bench.state.get<AnimateState>().animation.pointer.empty());
    CHECK(bench.state.notifications.list.back().text == "Animate: “Light: intensity” no longer exists");
}

TEST_CASE("an animated number stays with its object if an earlier one is deleted", "[ui][window][animate]") {
    HeadlessWindow bench;
    bench.frames(1);
    Scene& scene = bench.scene();
    scene.objects.resize(2, scene.objects[0]);
    scene.objects[1].transform.translate.x = 3;
    delete_while_it_goes(bench, "/objects/1/transform/translate/0", {Selection::Kind::Object, 0});
    CHECK(bench.state.get<AnimateState>().animation.pointer == "/objects/0/transform/translate/0");
    CHECK(bench.state.notifications.list.empty());
}
