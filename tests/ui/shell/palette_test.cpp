// Ctrl+K: the results, their order, and their effect.
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "renderer/explain/equation_text.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/program.h"
#include "ui/commands/command.h"
#include "ui/features/inspector/inspector.h"
#include "ui/preferences/autosave.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

std::vector<PaletteEntry> found(UiState& state, const std::string& text) {
    const std::vector<PaletteEntry> all = palette_entries(state);
    std::vector<PaletteEntry> matching;
    for (const int index : palette_matches(all, text))
        matching.push_back(all[static_cast<std::size_t>(index)]);
    return matching;
}

}  // namespace

TEST_CASE("the palette lists the scene field whose name begins with the text first", "[ui][palette]") {
    DrawnWindow bench;
    const std::string named[][2] = {
        {"shin", "Shininess"}, {"expos", "Exposure"}, {"rough", "Roughness"}, {"cutoff", "Cutoff"}};
    bench.scene().lights[0].kind = LightKind::Spot;
    for (const auto& [text, name] : named) {
        const auto entries = found(bench.state, text);
        INFO(text);
        REQUIRE_FALSE(entries.empty());
        CHECK(entries[0].name == name);
        CHECK(entries[0].group.find("Field") == 0);
    }
}

TEST_CASE("British and American spellings and the names of tabs are found", "[ui][palette]") {
    DrawnWindow bench;
    const std::string same[][2] = {
        {"colour", "color"}, {"colou", "colo"}, {"centre", "center"}, {"grey card", "gray card"}};
    for (const auto& [british, american] : same) {
        const auto a = found(bench.state, british), b = found(bench.state, american);
        CAPTURE(british);
        REQUIRE_FALSE(a.empty());
        CHECK(a.size() == b.size());
        CHECK(a[0].name == b[0].name);
    }
    CHECK(found(bench.state, "opengl calls").at(0).name == "Why: Program");
    CHECK(found(bench.state, "curves").at(0).name == "Why: Plots");
}

TEST_CASE("a command is found by its topic", "[ui][palette]") {
    DrawnWindow bench;
    const std::string about[][2] = {{"game", "Match the target"},
                                    {"screenshot", "Save picture…"},
                                    {"dark mode", "Light theme"},
                                    {"zebra", "Stripes over colours that are too bright"},
                                    {"fullscreen", "Picture alone"},
                                    {"gif", "Animate: turntable, light, number…"},
                                    {"focus", "Frame the selected object, or all"}};
    for (const auto& [text, name] : about) {
        const auto entries = found(bench.state, text);
        CAPTURE(text);
        REQUIRE_FALSE(entries.empty());
        CHECK(entries[0].name == name);
    }
}

TEST_CASE("among equal matches, those that can run come first", "[ui][palette]") {
    DrawnWindow bench;
    for (const std::string text : {"Re", "Co", "S"}) {
        auto entries = found(bench.state, text);
        std::erase_if(entries, [&](const PaletteEntry& entry) { return !entry.name.starts_with(text); });
        const auto can_run = [](const PaletteEntry& entry) { return entry.refused.empty(); };
        CAPTURE(text);
        CHECK(std::is_partitioned(entries.begin(), entries.end(), can_run));
        CHECK_FALSE(std::all_of(entries.begin(), entries.end(), can_run));
    }
    const auto lights = found(bench.state, "light");
    REQUIRE(lights.size() > 8);
    CHECK(std::any_of(lights.begin(), lights.begin() + 8,
                      [](const PaletteEntry& entry) { return entry.name == "Light theme"; }));
}

TEST_CASE("names are found as spelled in files and commands", "[ui][palette]") {
    DrawnWindow bench;
    bench.state.shipped_scenes = project_file("assets/scenes");
    bench.state.get<LessonState>().folder = project_file("assets/lessons");
    list_own_lessons(bench.state);
    CHECK(found(bench.state, "05-lambert").at(0).name == "Lesson: 05 Lambert's law: the beam gets wider");
    CHECK(found(bench.state, "spot-cone").at(0).name == "Scene: spot cone");
    CHECK(found(bench.state, "lit_in_srgb").at(0).name == "Mistake: lit in sRGB");
    CHECK(found(bench.state, "scan-line").at(0).name == "Scan-line scope");
}

TEST_CASE("a lesson is found by its number, its title and its topic", "[ui][palette]") {
    HeadlessWindow bench;
    bench.state.get<LessonState>().folder = project_file("assets/lessons");
    bench.frames(2);
    (void)bench.key(Key::K, true);
    REQUIRE_FALSE(bench.state.get<LessonListState>().own.empty());
    const std::string name = "Lesson: 05 Lambert's law: the beam gets wider";
    for (const char* text : {"lesson 05", "beam gets wider", "lambert's law", "cosine", "lambert"}) {
        CAPTURE(text);
        const auto entries = found(bench.state, text);
        REQUIRE_FALSE(entries.empty());
        const auto is_named = [&](const PaletteEntry& entry) { return entry.name == name; };
        CHECK(std::any_of(entries.begin(), entries.end(), is_named));
    }
    CHECK(found(bench.state, "lesson 05").at(0).name == name);
    std::vector<std::string> numbers;
    for (const PaletteEntry& entry : found(bench.state, "lesson"))
        if (entry.name.starts_with("Lesson: ")) numbers.push_back(entry.name.substr(8, 2));
    CHECK(numbers.size() == bench.state.get<LessonListState>().own.size());
    CHECK(std::is_sorted(numbers.begin(), numbers.end()));
}

TEST_CASE("a component of a vector is found and focused", "[ui][palette][window]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = project_file("assets/scenes");
    bench.state.editor.selection = {Selection::Kind::Object, 0};
    bench.frames(2);
    for (const auto& [text, number] : {std::pair{"scale y", 3}, std::pair{"rotate z", 40}}) {
        CAPTURE(text);
        (void)bench.key(Key::K, true);
        bench.frames(2);
        bench.type(text);
        (void)bench.key(Key::Enter);
        bench.frames(6);
        CHECK(ImGui::GetIO().WantTextInput);
        bench.type(std::to_string(number).c_str());
        bench.frames(2);
    }
    CHECK(bench.scene().objects[0].transform.scale.y == 3);
    CHECK(bench.scene().objects[0].transform.rotate_deg.z == 40);
    CHECK(bench.scene().objects[0].transform.scale.x == 1);
}

TEST_CASE("the palette copies the explanation of the picked pixel", "[ui][palette]") {
    DrawnWindow bench;
    CHECK(found(bench.state, "latex").at(0).refused == "Pick a pixel on an object first");
    bench.click(
        bench.at_pixel({bench.state.rendered->size.width / 2.0, bench.state.rendered->size.height / 2.0}));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    const PaletteEntry copy = found(bench.state, "latex").at(0);
    CHECK(copy.name == "Copy the explanation as LaTeX");
    REQUIRE(copy.refused.empty());
    copy.run(bench.state);
    CHECK(std::string(ImGui::GetClipboardText()) ==
          explain_latex(*bench.state.on_screen.explanation, bench.scene()));
    // The entry still exists after the pixel is unpicked.
    ask_about(bench.state.viewport, {});
    bench.frames(2);
    REQUIRE_FALSE(bench.state.on_screen.explanation);
    ImGui::SetClipboardText("mine");
    copy.run(bench.state);
    CHECK(std::string(ImGui::GetClipboardText()) == "mine");
    CHECK(bench.state.notifications.list.back().text == "Pick a pixel on an object first");
}

TEST_CASE("the palette adds lights and objects, and replaces the selected object's mesh", "[ui][palette]") {
    DrawnWindow bench;
    const std::size_t objects = bench.scene().objects.size(), lights = bench.scene().lights.size();
    found(bench.state, "add torus").at(0).run(bench.state);
    bench.wait_for_loads();
    REQUIRE(bench.scene().objects.size() == objects + 1);
    CHECK(std::get<PrimitiveMesh>(bench.scene().objects.back().source).primitive == Primitive::Torus);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, static_cast<int>(objects)});
    found(bench.state, "torus: cone").at(0).run(bench.state);
    bench.wait_for_loads();
    CHECK(std::get<PrimitiveMesh>(bench.scene().objects.back().source).primitive == Primitive::Cone);
    CHECK(bench.scene().objects.back().mesh != nullptr);
    found(bench.state, "add spot").at(0).run(bench.state);
    REQUIRE(bench.scene().lights.size() == lights + 1);
    CHECK(bench.scene().lights.back().kind == LightKind::Spot);
    found(bench.state, "add mesh file").at(0).run(bench.state);
    CHECK(bench.state.mesh_for_object == -1);
    CHECK(bench.state.files.open);
    found(bench.state, "select the camera").at(0).run(bench.state);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Camera, 0});
}

TEST_CASE("the palette finds a field by a synonym", "[ui][palette]") {
    DrawnWindow bench;
    const auto entries = found(bench.state, "gamma");
    REQUIRE_FALSE(entries.empty());
    CHECK(entries[0].name == "Encoding");
}

TEST_CASE("every number in a scene is in a field that the palette finds", "[ui][palette]") {
    DrawnWindow bench;
    const std::vector<PaletteEntry> entries = palette_entries(bench.state);
    const auto fields = std::count_if(entries.begin(), entries.end(),
                                      [](const PaletteEntry& e) { return e.group.find("Field") == 0; });
    std::size_t rows = 0;  // numbers without effect are not required
    std::string last;
    for (const SceneNumber& number : numbers_of(bench.scene())) {
        std::string row = number.pointer;
        if (std::isdigit(static_cast<unsigned char>(row.back()))) row.erase(row.rfind('/'));
        if (row != last && number.applies) ++rows;
        last = row;
    }
    CHECK(std::size_t(fields) >= rows);
}

TEST_CASE("a field found by the palette is in its panel and has focus", "[ui][palette][window]") {
    HeadlessWindow bench;
    bench.state.editor.selection = {Selection::Kind::Shading, 0};
    bench.frames(2);
    (void)bench.key(Key::K, true);
    bench.frames(1);
    bench.type("shin");
    (void)bench.key(Key::Enter);
    bench.frames(6);
    CHECK_FALSE(bench.state.palette.open);
    CHECK(bench.state.editor.selection == Selection{Selection::Kind::Object, 0});
    CHECK(ImGui::GetIO().WantTextInput);
    CHECK(bench.area_of("/objects/0/material/shininess").high.y < 780);
    bench.type("77");
    CHECK(bench.scene().objects[0].material.shininess == 77);
}

TEST_CASE("each entry of the palette is found by its full name", "[ui][palette]") {
    HeadlessWindow bench;
    bench.state.shipped_scenes = project_file("assets/scenes");
    bench.state.get<LessonState>().folder = project_file("assets/lessons");
    list_own_lessons(bench.state);
    bench.frames(2);
    const std::vector<PaletteEntry> entries = palette_entries(bench.state);
    for (const char* group :
         {"Mistake · ", "Field · ", "Glint's scenes", "Glint's lessons", "Light", "Scene"})
        CHECK(std::any_of(entries.begin(), entries.end(),
                          [&](const PaletteEntry& e) { return e.group.starts_with(group); }));
    for (const PaletteEntry& entry : entries) {
        CAPTURE(entry.name);
        const int first = palette_matches(entries, entry.name).at(0);
        CHECK(entries[std::size_t(first)].name == entry.name);
    }
}

TEST_CASE("the palette finds every kind of projection and keeps the visible size", "[ui][palette][window]") {
    DrawnWindow bench;
    for (const ProjectionKind kind :
         {ProjectionKind::Frustum, ProjectionKind::Orthographic, ProjectionKind::Perspective}) {
        const std::string name = choice_of(kind).label;
        const auto entries = found(bench.state, "Projection: " + name);
        REQUIRE_FALSE(entries.empty());
        CHECK(entries[0].name == "Projection: " + name);
        entries[0].run(bench.state);
        CHECK(kind_of(bench.scene().camera.projection) == kind);
        bench.frames(2);
    }
    CHECK(bench.state.editor.history.can_undo());  // the change counts as an edit
    const auto back = std::get<Perspective>(bench.scene().camera.projection);
    CHECK(back.fov_y_deg == Approx(std::get<Perspective>(first_scene().scene.camera.projection).fov_y_deg));
}

TEST_CASE("a one-letter command reports what it did", "[ui][window][commands]") {
    DrawnWindow bench;
    const auto last = [&] {
        return bench.state.notifications.list.empty() ? "" : bench.state.notifications.list.back().text;
    };
    (void)bench.key(Key::S, false, true);
    CHECK(last() == "Specular: off (Shift+S)");
    (void)bench.key(Key::S, false, true);
    CHECK(last() == "Specular: on (Shift+S)");
    CHECK(bench.state.notifications.list.size() == 1);  // which replaced the previous one
    (void)bench.key(Key::Digit1);
    CHECK(last() == "Flat shading (1)");
    bench.state.editor.selection = {Selection::Kind::Camera, 0};
    (void)bench.key(Key::G);
    CHECK(last().find("(G)") != std::string::npos);
    CHECK(last().find("No object is selected") == 0);
}

TEST_CASE("arrow keys pick a pixel and move it, by ten with Shift", "[ui][window][commands]") {
    DrawnWindow bench;
    const PictureSize size = bench.state.rendered->size;
    const auto picked = [&] { return probe_pixel(bench.state.viewport, size).value_or(glm::ivec2(-1)); };
    (void)bench.key(Key::Left);
    CHECK(picked() == glm::ivec2(size.width / 2, size.height / 2));  // the centre, as none was picked
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.left_shows_inspector);  // which matters if the columns share one space
    (void)bench.key(Key::Right);
    (void)bench.key(Key::Right);
    (void)bench.key(Key::Up);
    CHECK(picked() == glm::ivec2(size.width / 2 + 2, size.height / 2 - 1));
    bench.frames(2);
    REQUIRE(bench.state.on_screen.explanation);
    CHECK(bench.state.on_screen.explanation->x == size.width / 2 + 2);
    CHECK(bench.state.on_screen.explanation->y == size.height / 2 - 1);
    ImGui::GetIO().KeyShift = true;
    (void)bench.key(Key::Down, false, true);
    CHECK(picked().y == size.height / 2 + 9);
    for (int i = 0; i < size.width; i += 10) (void)bench.key(Key::Left, false, true);
    ImGui::GetIO().KeyShift = false;
    CHECK(picked().x == 0);  // not beyond the border
    freeze(bench.state);
    bench.frames(1);
    (void)bench.key(Key::Right);
    CHECK(picked().x == 0);
    CHECK(bench.notes_with("The picture is frozen: F8 unfreezes it") == 1);
}

TEST_CASE("each one-letter command reports something", "[ui][window][commands]") {
    for (const WindowCommand& command : commands())
        for (const KeyPress& press : command.keys) {
            if (press.ctrl || press.shift || press.alt || press.key > Key::Digit4) continue;
            DrawnWindow bench;
            UiInput input;
            input.presses.push_back(press);
            (void)bench.frame(input);
            INFO(command.name);
            REQUIRE_FALSE(bench.state.notifications.list.empty());
            CHECK(bench.state.notifications.list.back().text.find("(" + text_of(press) + ")") !=
                  std::string::npos);
        }
}

TEST_CASE("the palette opens every tab of the column", "[ui][palette]") {
    HeadlessWindow bench;
    for (const InspectorTabInfo& info : inspector_tabs()) {
        bench.state.layout.right = false;
        for (const PaletteEntry& entry : palette_entries(bench.state))
            if (entry.name == std::string("Why: ") + info.label) entry.run(bench.state);
        CHECK(bench.state.get<InspectorState>().tab == info.tab);
        CHECK(bench.state.layout.right);
    }
}

TEST_CASE("with nothing typed, Enter runs nothing until an arrow key picks an entry",
          "[ui][palette][window]") {
    DrawnWindow bench;
    bench.scene().lights[0].name = "Mine";
    bench.frames(2);
    (void)bench.key(Key::K, true);
    bench.frames(2);
    (void)bench.key(Key::Enter);
    bench.frames(3);
    CHECK(bench.state.palette.open);
    CHECK_FALSE(bench.state.pending.then);
    (void)bench.key(Key::Down);
    CHECK(bench.state.palette.chosen == 0);
    (void)bench.key(Key::Enter);
    CHECK_FALSE(bench.state.palette.open);
}

TEST_CASE("the arrow keys cycle through the palette, which scrolls with them", "[ui][palette][window]") {
    DrawnWindow bench;
    (void)bench.key(Key::K, true);
    bench.frames(2);
    const ImGuiWindow* list = test::window_named("##entries");
    REQUIRE(list != nullptr);
    CHECK(list->ScrollMax.y > 1000);
    const auto is_marked = [list] {
        const auto& vertices = list->DrawList->VtxBuffer;
        return std::any_of(vertices.begin(), vertices.end(), [](const ImDrawVert& vertex) {
            return vertex.col == to_u32(theme().field_active);
        });
    };
    CHECK_FALSE(is_marked());
    (void)bench.key(Key::Up);
    bench.frames(2);
    CHECK(bench.state.palette.chosen + 1 == int(bench.state.palette.entries.size()));
    CHECK(list->Scroll.y == list->ScrollMax.y);
    CHECK(is_marked());
    (void)bench.key(Key::Down);
    bench.frames(2);
    CHECK(bench.state.palette.chosen == 0);
    CHECK(list->Scroll.y == 0);
}
