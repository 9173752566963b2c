// Exporting pictures and commands.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/features/export/clipboard.h"
#include "ui/widgets/numbers/number_input.h"

using namespace glint;
using test::DrawnWindow;
using test::HeadlessWindow;

namespace {

namespace fs = std::filesystem;

constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

SceneDocument opened(const std::string& path) {
    auto document = open_document(path);
    REQUIRE(problem_of(document) == nullptr);
    return std::get<SceneDocument>(std::move(document));
}

/// The picture that the command writes when a shell runs it, as RGBA.
std::vector<std::uint8_t> drawn_by(const std::string& command, const TemporaryDirectory& folder) {
    const std::string bin = folder.path("bin");
    fs::create_directories(bin);
    if (!fs::exists(bin + "/glint")) fs::create_symlink(glint_program, bin + "/glint");
    const std::string line = "cd '" + folder.path("") + "' && PATH='" + bin + "':$PATH && " + command;
    INFO(line);
    REQUIRE(std::system(line.c_str()) == 0);
    const auto picture = read_png(folder.path("out.png"));
    REQUIRE(problem_of(picture) == nullptr);
    return std::get<Picture>(picture).rgba;
}

std::vector<std::uint8_t> drawn_here(const Scene& scene, PictureSize size, int samples) {
    Renderer renderer(1);
    return renderer.render(scene, size, false, samples).rgba;
}

/// Makes random changes of every kind to a scene.
void edit(Scene& scene, std::mt19937& random) {
    for (unsigned i = 0; i <= random() % 4; ++i) {
        switch (random() % 9) {
        case 0:
            scene.lights[0].position = glm::vec4(test::uniform_vec3(random, 1, 3), 0);
            break;
        case 1:
            scene.lights[1].kind = LightKind::Spot;
            scene.lights[1].spot.cutoff_deg = 40;
            break;
        case 2:
            scene.objects[0].source = PrimitiveMesh{Primitive::Torus, 12};
            scene.objects[0].mesh = test::primitive(Primitive::Torus, 12);
            break;
        case 3:
            scene.camera.projection = Orthographic{test::uniform(random, 2, 4), 0.1f, 50};
            break;
        case 4:
            scene.shading.mistakes.no_clamp_of_cosine ^= true;
            break;
        case 5:
            scene.lights.push_back(scene.lights[0]);
            scene.lights.back().name = "It's \"new\" $HOME `x`";
            scene.lights.back().position = {-1, 1, 1, 0};
            break;
        case 6:
            scene.shading.mode = ShadingMode::Gouraud;
            break;
        case 7:
            scene.objects.pop_back();
            scene.objects.resize(1);
            break;
        default:
            scene.objects[0].material.diffuse = test::uniform_vec3(random, 0, 1);
        }
        if (scene.objects.size() < 2) scene.objects.resize(2, scene.objects[0]);
    }
}

}  // namespace

TEST_CASE("the copied command draws exactly the picture on the screen", "[ui][export]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("a scene's.json", scene_text(test::busy_scene()));
    const SceneDocument whole = opened(path);
    std::mt19937 random(11);
    for (int i = 0; i < 12; ++i) {
        SceneDocument document = whole;
        edit(document.scene, random);
        const int samples = i % 2 == 0 ? 1 : 4;
        const PictureSize size{90 + i, 61, true};  // as shown in the window
        const auto here = drawn_here(document.scene, size, samples);
        CHECK(drawn_by(render_command_text(document, whole.scene, size, samples, "out.png"), folder) == here);
        document.path.clear();  // never saved: the command sets everything on an empty scene
        CHECK(drawn_by(render_command_text(document, whole.scene, size, samples, "out.png"), folder) == here);
    }
}

TEST_CASE("an unchanged scene's command is short, one change is one --set", "[ui][export]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("s.json", scene_text(test::busy_scene()));
    SceneDocument document = opened(path);
    const Scene in_file = document.scene;
    CHECK(render_command_text(document, in_file, {64, 36}, 1, "out.png") ==
          "glint render " + path + " --size 64x36 -o out.png");
    document.scene.shading.mode = ShadingMode::Flat;
    document.scene.display.exposure = 0.1f;
    CHECK(render_command_text(document, in_file, {64, 36}, 8, "out.png") ==
          "glint render " + path +
              " --set '/shading/mode=\"flat\"' --set /display/exposure=0.1 --size 64x36 --samples 8 -o "
              "out.png");
}

TEST_CASE("a command names mesh files relative to the working directory", "[ui][export]") {
    const TemporaryDirectory folder;
    fs::create_directories(folder.path("deep"));
    (void)folder.file("deep/t.obj", triangle_obj);
    const SceneDocument mesh = opened(folder.path("deep/t.obj"));
    const auto here = drawn_here(mesh.scene, {80, 45}, 1);
    CHECK(drawn_by(render_command_text(mesh, mesh.scene, {80, 45}, 1, "out.png"), folder) == here);
    SceneDocument unnamed = mesh;
    unnamed.path.clear();
    CHECK(drawn_by(render_command_text(unnamed, mesh.scene, {80, 45}, 1, "out.png"), folder) == here);
    SceneDocument added = opened(folder.file("s.json", R"({"glint": 1, "objects": [{}]})"));
    const Scene in_file = added.scene;
    added.scene.objects[0].source = MeshFile{folder.path("deep/t.obj")};
    added.scene.objects[0].mesh = mesh.scene.objects[0].mesh;
    CHECK(drawn_by(render_command_text(added, in_file, {80, 45}, 1, "out.png"), folder) ==
          drawn_here(added.scene, {80, 45}, 1));
}

TEST_CASE("a picture saved or exported elsewhere reopens with its meshes", "[ui][export]") {
    const TemporaryDirectory folder;
    fs::create_directories(folder.path("deep"));
    fs::create_directories(folder.path("pictures"));
    (void)folder.file("deep/t.obj", triangle_obj);
    const std::string path =
        folder.file("deep/s.json", R"({"glint": 1, "objects": [{"mesh": {"file": "t.obj"}}]})");
    const std::string exported = folder.path("pictures/exported.png"),
                      saved = folder.path("pictures/saved.png");
    HeadlessWindow bench;
    take_document(bench.state.editor, opened(path));
    bench.frames(2);
    begin_export(bench.state, {{64, 36}, 4}, exported);
    while (bench.state.get<ExportState>().job) bench.frame();
    CHECK(bench.state.notifications.list.back().text ==
          "Saved exported.png in " + folder.path("pictures") + " (64 × 36, 4 samples per pixel)");
    bench.key(Key::F12);
    REQUIRE(bench.state.files.open);
    bench.state.files.folder = folder.path("pictures");
    bench.state.files.name = "saved.png";
    bench.frames(2);
    bench.key(Key::Enter);
    while (bench.state.get<ExportState>().job) bench.frame();
    for (const std::string& picture : {exported, saved}) {
        const SceneDocument again = opened(picture);
        CHECK(again.scene.objects.at(0).mesh->face_count() == 1);
        CHECK(std::get<MeshFile>(again.scene.objects[0].source).path == "../deep/t.obj");
    }
}

namespace {

/// A window in which F12 saves into its own folder.
struct PictureWindow : HeadlessWindow {
    PictureWindow() { frames(3); }
    /// Saves the picture; returns the notification.
    Notification save(const std::string& name) {
        state.notifications.list.clear();
        (void)key(Key::F12);
        REQUIRE(state.files.open);
        warning = state.files.warning;
        state.files.folder = folder.path("");
        state.files.name = name;
        frames(2);
        (void)key(Key::Enter);
        while (state.get<ExportState>().job) (void)frame();
        REQUIRE(state.notifications.list.size() == 1);
        return state.notifications.list.front();
    }
    Picture saved(const std::string& name) { return std::get<Picture>(read_png(folder.path(name))); }
    /// "Saved a.png in FOLDER (640 × 360, 1 sample per pixel)"
    std::string told(const std::string& name) {
        const Picture picture = saved(name);
        return "Saved " + name + " in " + folder.path("").substr(0, folder.path("").size() - 1) + " (" +
               std::to_string(picture.size.width) + " × " + std::to_string(picture.size.height) +
               ", 1 sample per pixel)";
    }

    TemporaryDirectory folder;
    std::string warning;  // in the dialog
};

}  // namespace

TEST_CASE("F12 saves the picture at full size while the window shows a smaller one", "[ui][window][export]") {
    PictureWindow bench;
    const PictureSize small = bench.state.rendered->size;
    {
        const test::MemoryLimit limit(test::cost_of(bench.scene(), small));
        ImGui::GetIO().DisplaySize.x += 200;
        bench.frames(3);
    }
    const PictureSize full = bench.state.full_size;
    REQUIRE(bench.state.rendered->size == small);
    REQUIRE(full.width > small.width);
    bench.state.notifications.list.clear();
    const Notification note = bench.save("a.png");
    CHECK(note.text == bench.told("a.png"));
    CHECK((bench.saved("a.png").rgba == drawn_here(bench.scene(), full, 1)));
}

TEST_CASE("a comparison or a debug view is reported as missing from the saved picture",
          "[ui][window][export]") {
    struct Case {
        Key key;
        const char* name;
    };
    for (const auto& [key, name] :
         {Case{Key::C, "Comparison"}, {Key::I, "View: Normals"}, {Key::O, "Over-range stripes"}}) {
        CAPTURE(name);
        PictureWindow bench;
        (void)bench.key(key);
        bench.frames(2);
        const Notification note = bench.save("a.png");
        CHECK(bench.warning == std::string("Not in the file: ") + name);
        CHECK(note.text == bench.told("a.png") + ". Not in the file: " + name);
        CHECK(note.tone == Tone::Warning);
        CHECK((bench.saved("a.png").rgba == drawn_here(bench.scene(), bench.state.full_size, 1)));
    }
}

TEST_CASE("a kept cell of Light × term is reported on saving and noted in the file", "[ui][window][export]") {
    PictureWindow bench;
    bench.scene().about = "Two lights";
    bench.state.get<InspectorState>().tab = InspectorTab::Grid;
    bench.state.get<TermGridState>().solo = GridCell{1, 1};
    bench.frames(4);
    const Notification note = bench.save("cell.png");
    CHECK(bench.warning == "With: Only Bulb: diffuse");
    CHECK(note.text == bench.told("cell.png") + ": Only Bulb: diffuse");
    CHECK((bench.saved("cell.png").rgba ==
           drawn_here(with_cells(bench.scene(), {{1, 1}}), bench.state.full_size, 1)));
    CHECK(opened(bench.folder.path("cell.png")).scene.about == "Only Bulb: diffuse. Two lights");
}

TEST_CASE("disabled terms and mistakes are reported when their scene is saved", "[ui][window][save]") {
    PictureWindow bench;
    bench.scene().shading.terms.specular = false;
    bench.scene().shading.mistakes.reflect_sign = true;
    bench.frames(2);
    const Notification note = bench.save("a.png");
    CHECK(note.text == bench.told("a.png") + ": Off: specular, Mistake: Reflect sign");
    (void)save_as(bench.state, bench.folder.path("a.json"));
    CHECK(bench.notes_with("Saved a.json (Off: specular, Mistake: Reflect sign)") == 1);
}

TEST_CASE("the export dialog names the folder and offers the view's size", "[ui][window][export]") {
    DrawnWindow bench;
    (void)bench.key(Key::E, true);
    bench.frames(2);
    CHECK(bench.state.get<ExportState>().options.size == bench.state.full_size);
    CHECK(std::any_of(bench.controls().begin(), bench.controls().end(), [](const NamedControl& control) {
        return control.name.starts_with("Save in /") && !control.name.ends_with("/###save here");
    }));
}

TEST_CASE("an export equals the command line's output, byte for byte", "[ui][export]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("s.json", scene_text(test::busy_scene()));
    for (const char* name : {"a.png", "a.pfm", "a.exr"}) {
        const auto bytes = picture_file(opened(path), {{72, 40}, 4}, folder.path(name), 2);
        REQUIRE(problem_of(bytes) == nullptr);
        REQUIRE(run_glint({"render", path, "-o", folder.path(name), "--size", "72x40", "--samples", "4"})
                    .status == 0);
        CHECK(std::get<std::string>(bytes) == bytes_of(folder.path(name)));
    }
    CHECK(problem_of(picture_file(opened(path), {{8, 8}, 1}, "a.gif", 1)) != nullptr);
}

TEST_CASE("an exported narrow picture shows more of the scene and reopens as that scene", "[ui][export]") {
    const TemporaryDirectory folder;
    const std::string path = folder.file("s.json", scene_text(test::busy_scene()));
    const auto bytes = picture_file(opened(path), {{60, 72}, 2}, folder.path("a.png"), 2);
    REQUIRE(problem_of(bytes) == nullptr);
    const std::string picture = folder.file("a.png", std::get<std::string>(bytes));
    CHECK(opened(picture).scene.camera == opened(path).scene.camera);
    REQUIRE(
        run_glint({"render", picture, "-o", folder.path("again.png"), "--size", "60x72", "--samples", "2"})
            .status == 0);
    const auto first = read_png(picture), again = read_png(folder.path("again.png"));
    CHECK(std::get<Picture>(first).rgba == std::get<Picture>(again).rgba);
    REQUIRE(run_glint({"render", path, "-o", folder.path("cut.png"), "--size", "60x72", "--samples", "2"})
                .status == 0);
    CHECK(std::get<Picture>(first).rgba != std::get<Picture>(read_png(folder.path("cut.png"))).rgba);
}

TEST_CASE("a picture is copied by a desktop tool, or a message names the missing tool", "[ui][export]") {
    const TemporaryDirectory folder;
    const char* path = std::getenv("PATH");
    REQUIRE(path != nullptr);
    const std::string path_before = path;
    const char* display = std::getenv("DISPLAY");
    const std::string display_before = display != nullptr ? display : "";
    setenv("PATH", folder.path("").c_str(), 1);
    setenv("DISPLAY", ":1234", 1);
    unsetenv("WAYLAND_DISPLAY");
    DrawnWindow bench;
    CHECK(why_disabled(bench.state, test::command_named("Copy picture")) == "Needs the program xclip");
    const std::string script = folder.file("xclip", "#!/bin/sh\n/bin/cat >'" + folder.path("got.png") +
                                                        "'\necho \"$@\" >'" + folder.path("words") + "'\n");
    fs::permissions(script, fs::perms::owner_all);
    CHECK(why_disabled(bench.state, test::command_named("Copy picture")).empty());
    run_command(bench.state, test::command_named("Copy picture"));
    while (bench.state.get<ExportState>().job) bench.frame();
    CHECK(bench.state.notifications.list.back().tone == Tone::Done);
    CHECK(bytes_of(folder.path("words")) == "-selection clipboard -t image/png -i\n");
    const auto got = read_png(folder.path("got.png"));
    REQUIRE(problem_of(got) == nullptr);
    CHECK(std::get<Picture>(got).rgba == bench.state.rendered->rgba);
    (void)folder.file("xclip", "#!/bin/sh\nexit 3\n");
    run_command(bench.state, test::command_named("Copy picture"));
    while (bench.state.get<ExportState>().job) bench.frame();
    CHECK(bench.state.notifications.list.back().tone == Tone::Error);
    setenv("PATH", path_before.c_str(), 1);
    display != nullptr ? setenv("DISPLAY", display_before.c_str(), 1) : unsetenv("DISPLAY");
}

TEST_CASE("a size typed into the width field of an export sets both dimensions", "[ui][export][window]") {
    DrawnWindow bench;
    (void)bench.key(Key::E, true);
    bench.frames(3);
    PictureSize& size = bench.state.get<ExportState>().options.size;
    const auto type = [&](const char* text) {
        bench.click_on("Width");
        bench.type(text);
        bench.click({5, 5});
        bench.frames(2);
    };
    type("800x600");
    CHECK(size == PictureSize{800, 600});
    type(" 1024 X 768 ");
    CHECK(size == PictureSize{1024, 768});
    (void)take_said();
    for (const char* wrong : {"0x600", "800x", "99999999999x600", "800x600x2", "one x two"}) {
        CAPTURE(wrong);
        bench.state.notifications.list.clear();
        type(wrong);
        CHECK(size.height == 768);
        CHECK(bench.state.notifications.list.size() == 1);  // which reports that the text is not a number
    }
}
