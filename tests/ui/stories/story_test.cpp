// Does what the README promises, step by step with mouse and keys, and checks what a person would see.
// Other stories: a shader from blank to correct (my_shader_test.cpp), every lesson from its first page to its
// last (walk_test.cpp).
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "renderer/image/compare.h"
#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/person.h"
#include "tests/support/scenes.h"
#include "ui/document/document_actions.h"
#include "ui/picture/orbit.h"

using namespace glint;
using test::HeadlessWindow;
using test::Person;

namespace {

Picture picture_in(const std::string& path) {
    const Result<Picture> read = read_png(path);
    if (const Problem* problem = problem_of(read)) FAIL(problem->text());
    return std::get<Picture>(read);
}

void must(const std::vector<std::string>& arguments) {
    const Ended ended = run_glint(arguments);
    INFO(arguments.front() << ": " << ended.err);
    REQUIRE(ended.status == 0);
}

std::string shipped(const std::string& name) { return project_file("assets/scenes/" + name); }

}  // namespace

TEST_CASE("story: the README's tour of the window", "[ui][window][story]") {
    const TemporaryDirectory folder;
    Person person;
    person.drops(shipped("default.json"));
    const Scene start = person.scene();
    auto before = person.pixels();
    const auto changed = [&] { return std::exchange(before, person.pixels()) != before; };

    person.drag(person.at(0.05, 0.9), person.at(0.15, 0.85));
    CHECK_FALSE(person.scene().camera == start.camera);
    CHECK(changed());
    const double far = target_depth(person.scene().camera);
    person.move(person.at(0.5, 0.5));
    ImGui::GetIO().MouseWheel = 2;
    person.frames(2);
    CHECK(target_depth(person.scene().camera) < far);

    const glm::dvec2 handle = person.handle_pixel(1), wanted = handle + glm::dvec2(40, 30);
    person.drag(person.at_pixel(handle), person.at_pixel(wanted));
    CHECK(glm::length(person.handle_pixel(1) - wanted) < 1);
    CHECK(person.state.editor.history.undo_name() == "Move " + start.lights[1].name);
    CHECK(changed());
    const ImVec2 highlight = person.finds_highlight(), there = highlight + ImVec2(6, 4);
    const auto light = static_cast<std::size_t>(person.state.viewport.hovered_grip.item);
    const int bright = person.brightness(highlight);
    person.drag(highlight, there);
    person.frames(2);
    CHECK_FALSE(person.scene().lights[light] == start.lights[light]);
    CHECK(person.brightness(there) > bright * 9 / 10);  // the highlight followed the cursor
    CHECK(changed());

    person.click(person.at(0.5, 0.5));
    person.frames(3);
    REQUIRE(person.state.on_screen.explanation);
    CHECK(person.sees("s  specular"));
    const Explanation& e = *person.state.on_screen.explanation;
    const std::uint8_t* const byte = &person.pixels()[4 * person.state.displayed->size.index(e.x, e.y)];
    CHECK(std::equal(e.byte.begin(), e.byte.begin() + 3, byte));
    const Scene present = person.scene();
    person.move(person.control("s  specular"));
    person.frames(2);
    CHECK(person.state.rendered_scene.shading.terms == Terms{false, false, false, true});
    CHECK(changed());
    CHECK(person.scene() == present);
    person.move(person.at(0.02, 0.02));
    person.frames(2);
    CHECK(changed());

    for (const auto& [key, mode] : {std::pair(Key::Digit1, ShadingMode::Flat),
                                    {Key::Digit2, ShadingMode::Facet},
                                    {Key::Digit3, ShadingMode::Gouraud},
                                    {Key::Digit4, ShadingMode::Phong}}) {
        person.press(key);
        CHECK(person.scene().shading.mode == mode);
        CHECK(changed());
    }
    person.press(Key::C);
    CHECK(person.sees("Stacked"));
    CHECK(changed());
    person.press(Key::C);
    person.press(Key::P);
    person.drag(person.at(0.1, 0.6), person.at(0.9, 0.6));
    person.frames(2);
    CHECK(person.sees("Close the scope"));
    person.press(Key::P);
    person.finds("gouraud shading");
    CHECK(person.scene().shading.mode == ShadingMode::Gouraud);
    person.press(Key::F1);
    CHECK(person.sees("Undo"));
    person.press(Key::Escape);

    person.press(Key::F12);
    person.names_file(folder.path("picture.png"));
    person.waits_until([&] { return !person.state.get<ExportState>().job; });
    CHECK(person.sees("picture.png"));
    const Scene saved = person.scene();
    CHECK((picture_in(folder.path("picture.png")).rgba == person.state.rendered->rgba));
    person.press(Key::N, true);
    REQUIRE(person.state.pending.asking);
    person.press(Key::D);
    CHECK_FALSE(person.scene() == saved);
    person.drops(folder.path("picture.png"));
    CHECK(same_but_camera(person.scene(), saved));
}

TEST_CASE("story: from Blender to a student's program", "[ui][window][story][cli]") {
    const TemporaryDirectory folder;
    (void)folder.file("made.json", R"({"glint": 1, "camera": {"eye": [0, 1, 5]},
        "lights": [{"name": "Key", "type": "spot", "position": [1, 3, 3], "spot": {"direction": [-1, -3, -3], "cutoff_deg": 40},
                    "intensity": 9, "falloff": {"constant": 0, "quadratic": 1}}],
        "objects": [{"name": "Suzanne", "mesh": {"primitive": "teapot", "detail": 6}}]})");
    must({"export", folder.path("made.json"), "-o", folder.path("model.glb")});
    Person person;
    person.drops(folder.path("model.glb"));
    REQUIRE(person.scene().objects.size() == 1);
    CHECK(person.scene().objects[0].name == "Suzanne");
    CHECK(person.scene().lights.at(0).name == "Key");
    CHECK(person.scene().lights.at(0).kind == LightKind::Spot);
    const std::size_t triangles = person.scene().objects[0].mesh->triangles.size();
    person.finds("select suzanne");
    person.finds("Decimate");
    person.type("500");
    person.press(Key::Enter);
    person.waits_until([&] { return person.scene().objects[0].mesh->triangles.size() <= 500; });
    CHECK(triangles > 500);
    person.press(Key::S, true);
    person.names_file(folder.path("model.json"));
    CHECK(person.sees("Saved model.json"));

    must({"render", folder.path("model.json"), "-o", folder.path("model.png"), "--size", "96x72"});
    must({"code", folder.path("model.json"), "--language", "python", "-o", folder.path("program"), "--size",
          "96x72"});
    const std::string run =
        "cd '" + folder.path("program") + "' && PATH=/usr/bin:$PATH python3 main.py >/dev/null";
    REQUIRE(std::system(run.c_str()) == 0);
    const std::string drawn = bytes_of(folder.path("program/picture.ppm"));
    const Picture reference = picture_in(folder.path("model.png"));
    REQUIRE(drawn.size() > 3 * reference.size.pixels());
    std::size_t unlike = 0;
    for (std::size_t p = 0; p < reference.size.pixels(); ++p)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto byte =
                static_cast<unsigned char>(drawn[drawn.size() - 3 * (reference.size.pixels() - p) + c]);
            unlike += std::abs(int{reference.rgba[4 * p + c]} - int{byte}) > 2 ? 1 : 0;
        }
    CHECK(unlike <= reference.size.pixels() / 100);  // edge pixels may differ

    must({"export", folder.path("model.json"), "-o", folder.path("changed.glb")});
    person.drops(folder.path("changed.glb"));
    CHECK(person.scene().objects[0].mesh->triangles.size() <= 500);
    CHECK(person.scene().lights.at(0).spot.cutoff_deg == Approx(40));
}

TEST_CASE("story: a lecture", "[ui][window][story]") {
    const TemporaryDirectory folder;
    Scene scene = first_scene().scene;
    for (const char* name : {"one", "two"}) {
        scene.about = std::string("Caption of ") + name;
        (void)folder.file(std::string(name) + ".json", scene_text(scene));
        scene.lights[0].intensity = 0.25f;
    }
    Person person;
    person.state.get<LectureState>().given_scenes = {folder.path("one.json"), folder.path("two.json")};
    person.drops(folder.path("one.json"));
    person.press(Key::F9);
    CHECK(person.state.layout.projector);
    CHECK(person.sees("Equation"));
    person.press(Key::F9);
    CHECK_FALSE(person.state.layout.projector);

    auto shown = person.pixels();
    person.press(Key::F8);
    person.press(Key::D);  // prepares the next step
    person.press(Key::Digit1);
    CHECK((person.pixels() == shown));
    CHECK(person.sees("Frozen"));
    person.press(Key::F8);
    CHECK((person.pixels() != shown));
    person.press(Key::Z, true);
    CHECK((person.pixels() == shown));

    const PictureSize size = person.state.rendered->size;
    person.press(Key::F11);
    CHECK(person.state.rendered->size.width > size.width);
    CHECK(window_layout(person.state).has_caption);
    CHECK_FALSE(person.sees("Equation"));
    person.press(Key::F11);
    person.press(Key::F10);
    CHECK(person.text() == "");
    person.press(Key::Escape);
    CHECK(person.state.rendered->size == size);

    person.press(Key::W, false, true);
    person.drag(person.at(0.2, 0.2), person.at(0.6, 0.4));
    CHECK(person.state.get<PenState>().lines.size() == 1);
    UiInput erase;
    erase.presses = {{Key::W, false, false, true}};
    (void)person.frame(erase);
    CHECK(person.state.get<PenState>().lines.empty());
    person.press(Key::Escape);

    person.press(Key::PageDown);
    person.wait_for_loads();
    person.frames(3);
    CHECK(person.state.editor.title() == "two.json");
    CHECK((person.pixels() != shown));
    person.press(Key::PageDown);
    CHECK(person.sees("This is the last scene"));
    person.press(Key::PageUp);
    person.wait_for_loads();
    person.frames(3);
    CHECK((person.pixels() == shown));

    const Scene before = person.scene();
    person.press(Key::T, true);
    person.press(Key::Enter);
    REQUIRE(person.state.get<AnimateState>().playing);
    person.frames(20);
    CHECK((person.pixels() != shown));
    person.press(Key::Escape);
    person.frames(2);
    CHECK((person.pixels() == shown));
    CHECK(person.scene() == before);
    CHECK_FALSE(person.state.editor.unsaved());
}

TEST_CASE("story: an incorrect picture, from drop to experiment", "[ui][window][story]") {
    const TemporaryDirectory folder;
    Person person;
    const Scene start = person.scene();
    Scene wrong = start;
    wrong.shading.mistakes.normals_flipped = true;
    const PictureSize size{160, 90};
    Renderer renderer(1);
    const Picture picture = renderer.render(wrong, size);
    person.drops(folder.file("mine.png", png_bytes(picture, "")));
    const MyPictureState& mine = person.state.get<MyPictureState>();
    person.waits_until([&] { return !mine.reading && mine.shown && mine.settled; });
    CHECK(person.sees("Normals flipped"));
    CHECK(person.scene() == start);

    // The right half of the window shows the picture, in which the lit side of the ball is dark.
    const PictureSize shown = person.state.displayed->size;
    const std::size_t lit = 4 * shown.index(shown.width * 54 / 100, shown.height * 42 / 100);
    CHECK(person.state.rendered->rgba[lit] > person.pixels()[lit] + 40);
    person.clicks("Difference");
    CHECK(person.state.get<CompareState>().numbers.max_error > 50);
    const char* const mistake = "/shading/mistakes/normals_flipped";
    const ImVec2 row = HeadlessWindow::middle_of(
        person.area_of(mistake, lay_out(ImGui::GetIO().DisplaySize, person.state.layout, 1).right));
    person.move(row);
    person.frames(2);
    CHECK(person.state.rendered_scene.shading.mistakes.normals_flipped);
    CHECK(person.scene() == start);
    person.click(row);
    person.frames(2);
    Scene expected = start;
    expected.shading.mistakes.normals_flipped = true;
    CHECK(person.scene() == expected);
    CHECK(person.state.get<CompareState>().numbers.mean[0] < 0.5);  // the two pictures differ in size
    person.press(Key::Z, true);
    CHECK(person.scene() == start);

    REQUIRE(mine.answer);
    REQUIRE(mine.answer->diagnosis.experiment);
    const Experiment experiment = *mine.answer->diagnosis.experiment;
    person.clicks("Change the scene this way");
    CHECK(person.scene() == std::get<Scene>(scene_variant({start, "", "", {}}, experiment.set)));
    CHECK(person.state.viewport.probe);
    const Picture& drawn = renderer.render(under_mistakes(person.scene(), experiment.mistakes[0]), size);
    CHECK(rgb_at(drawn, drawn.pixel(experiment.pixel.x, experiment.pixel.y)) == experiment.shows[0]);
    person.waits_until([&] { return mine.settled; });
    CHECK(mine.current);  // the picture still belongs to the scene without the change
    person.press(Key::Z, true);
    CHECK(person.scene() == start);
    CHECK_FALSE(person.state.editor.history.can_undo());
}
