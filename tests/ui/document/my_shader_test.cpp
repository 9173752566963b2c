// A user's lighting.glsl in the window: it is watched, drawn, diagnosed and edited.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "models/io/file.h"
#include "programs/program.h"
#include "renderer/image/image_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_inspector.h"
#include "tests/support/program.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// A window that is small enough to draw quickly, and runs shaders with the program under test.
class ShaderWindow : public HeadlessWindow {
  public:
    ShaderWindow() {
        mine().shader_limits.program = glint_program;
        mine().shader_limits.seconds = 300;  // long enough even on a busy machine
        frames(2);
    }
    [[nodiscard]] MyPictureState& mine() { return state.get<MyPictureState>(); }
    /// Runs frames until `is_done` and no drawing or search is running.
    template <class Done> void wait_until(const Done& is_done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        do {
            (void)frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            REQUIRE(std::chrono::steady_clock::now() < end);
        } while (mine().reading || !mine().shown || !(mine().settled || mine().is_outdated) || !is_done());
        frames(2);
    }
    /// Replaces the file as an editor does, and waits for the next picture or error.
    void save(const std::string& path, const std::string& text) {
        const auto picture = state.get<CompareState>().choice.mine;
        std::ofstream(path) << text;
        wait_until([&] { return state.get<CompareState>().choice.mine != picture; });
    }
    [[nodiscard]] std::string label() { return part_label(state.get<CompareState>(), 1); }
    [[nodiscard]] std::string first_message() {
        return mine().messages.empty() ? "" : mine().messages.front().text();
    }
    /// The finished lighting.glsl of the open scene.
    [[nodiscard]] std::string right_text() {
        const auto program = write_program({scene(), {160, 90}, "scene"}, Language::Glsl);
        for (const ProgramFile& file : std::get<Program>(program).texts)
            if (file.name == "lighting.glsl") return file.text;
        return {};
    }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("the window's verdicts lead from a blank shader to a correct one", "[ui][window][shader]") {
    ShaderWindow bench;
    const TemporaryDirectory folder;
    run_command(bench.state, test::command_named("Blank shader…"));
    REQUIRE(bench.state.files.open);
    bench.state.files.folder = folder.path();
    bench.state.files.name = "mine";
    bench.frames(2);
    bench.key(Key::Enter);
    const std::string path = folder.path("mine.glsl");
    bench.wait_until([] { return true; });
    CHECK(bytes_of(path).find("// Step: ") != std::string::npos);
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::MyPicture);
    CHECK(bench.first_message().find("nothing is lit yet. Begin with") != std::string::npos);
    CHECK(bench.label() != "My shader: no mistake");

    const std::string right = bench.right_text();
    bench.save(path, replaced(right, "2.0 * n_l * n - l", "l - 2.0 * n_l * n"));
    CHECK(bench.label() == "My shader: specular term");  // the picture shows no highlight
    const auto& also = bench.mine().answer->diagnosis.candidates.front().also_named;
    CHECK(std::find(also.begin(), also.end(), "reflect_sign") != also.end());
    bench.save(path, right);
    CHECK(bench.label() == "My shader: no mistake");
    REQUIRE(bench.mine().verdicts.size() == 3);
    CHECK(bench.mine().verdicts[0].substr(8) == "  no mistake");
    CHECK(bench.mine().verdicts[1].substr(8) == "  specular term");

    // The shader's picture is drawn again when the scene changes.
    const auto before = bench.mine().shown;
    bench.scene().lights[0].position = {-1, 0.2f, 1, 0};
    bench.wait_until([&] { return bench.mine().shown != before && bench.mine().current; });
    CHECK(bench.label() == "My shader: no mistake");
    Renderer renderer(1);
    const Picture& drawn = renderer.render(bench.scene(), bench.mine().shown->size);
    const auto differs = [&](std::size_t i) {
        return std::abs(int{drawn.rgba[i]} - bench.mine().shown->rgba[i]) > 2;
    };
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i) unlike += differs(i);
    CHECK(unlike < drawn.rgba.size() / 100);  // edge pixels may differ
}

TEST_CASE("shader errors name their line, and the last picture stays, dimmed", "[ui][window][shader]") {
    ShaderWindow bench;
    const TemporaryDirectory folder;
    const std::string path = folder.file("a.glsl", "vec3 lit(vec3 p, vec3 n) {\n  return vec3(0.8);\n}\n");
    bench.drop(path);
    bench.wait_until([] { return true; });
    const auto color = [&bench] {
        const Picture& picture = *bench.state.get<CompareState>().choice.mine;
        return int{picture.rgba[picture.pixel(picture.size.width / 2, picture.size.height / 2) * 4]};
    };
    const int bright = color();
    CHECK(bright > 200);
    bench.save(path, "vec3 lit(vec3 p, vec3 n) {\n  return vec3(0.8)\n}\n");
    CHECK(bench.first_message().starts_with("a.glsl:3: syntax error"));
    CHECK(bench.label() == "My shader: see the error");
    CHECK(color() == bright / 2);
    CHECK_FALSE(bench.mine().current);
    bench.save(path, "vec3 lit(vec3 p, vec3 n) {\n  while (true);\n  return vec3(0.8);\n}\n");
    CHECK(bench.first_message().starts_with("a.glsl: its loops run more than 60000 times"));
    bench.save(path, std::string("vec3\0", 5));
    CHECK(bench.first_message().find("it is not text") != std::string::npos);
    std::filesystem::remove(path);
    bench.wait_until([&] { return bench.first_message().find("no such file") != std::string::npos; });
    CHECK(color() == bright / 2);
    bench.save(path, "vec3 lit(vec3 p, vec3 n) {\n  return vec3(0.8 + 0.0 / (p.x - p.x));\n}\n");
    CHECK(bench.first_message().starts_with("a.glsl: lit() returns NaN or an infinity in "));
    CHECK_FALSE(bench.mine().is_outdated);
    bench.key(Key::Escape);
    CHECK_FALSE(bench.mine().shown);
    CHECK_FALSE(bench.mine().watching);
}

TEST_CASE("a shader that does not compile still opens, so it can be fixed", "[ui][window][shader]") {
    ShaderWindow bench;
    const TemporaryDirectory folder;
    bench.drop(folder.file("a.glsl", "vec3 lit(vec3 p, vec3 n) { retrun n; }\n"));
    bench.wait_until([] { return true; });
    CHECK(bench.first_message().starts_with("a.glsl:1: "));
    CHECK(bench.state.notifications.list.empty());
    bench.click(test::in_column(bench, "Edit here"));
    bench.frames(2);
    CHECK(bench.mine().editor.text == "vec3 lit(vec3 p, vec3 n) { retrun n; }\n");
    bench.mine().editor.text = "vec3 lit(vec3 p, vec3 n) { return n; }\n";
    bench.click(test::in_column(bench, "Save and draw"));
    bench.wait_until([&] { return !bench.mine().is_outdated; });
    CHECK(bench.mine().messages.empty());
    CHECK(bytes_of(bench.mine().path) == "vec3 lit(vec3 p, vec3 n) { return n; }\n");
}

TEST_CASE("a shader that takes too long is stopped, and the window continues", "[ui][window][shader]") {
    ShaderWindow bench;
    bench.mine().shader_limits.seconds = 0.05;
    const TemporaryDirectory folder;
    std::string bomb = "#define A x = sin(x) + cos(x * p.y);\n";  // 4^9 statements
    for (char c = 'B'; c < 'K'; ++c)
        bomb += fmt::format("#define {0} {1} {1} {1} {1}\n", c, static_cast<char>(c - 1));
    bench.drop(
        folder.file("slow.glsl", bomb + "vec3 lit(vec3 p, vec3 n) { float x = p.x; J return vec3(x); }\n"));
    bench.wait_until([] { return true; });
    CHECK(bench.first_message() == "slow.glsl: it did not end within 0.05 s");
    // Closing the shader ends its process.
    bench.mine().shader_limits.seconds = 300;
    read_again(bench.state);
    bench.frames(2);
    const auto start = std::chrono::steady_clock::now();
    const auto job = bench.mine().reading;
    bench.key(Key::Escape);
    CHECK(job->wait_for(std::chrono::seconds(20)));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("a dropped picture is read and diagnosed again when its file changes", "[ui][window][mine]") {
    ShaderWindow bench;
    const TemporaryDirectory folder;
    Scene wrong = bench.scene();
    wrong.shading.mistakes.normals_flipped = true;
    Renderer renderer(1);
    const std::string path = folder.file("a.png", png_bytes(renderer.render(wrong, {160, 90}), ""));
    bench.drop(path);
    bench.wait_until([] { return true; });
    CHECK(bench.label() == "My picture: Normals flipped");
    const std::string right = png_bytes(renderer.render(bench.scene(), {160, 90}), "");
    bench.state.get<InspectorState>().tab = InspectorTab::Vectors;
    bench.save(path, right.substr(0, right.size() / 2));  // as if its program had stopped halfway
    CHECK(bench.mine().is_outdated);
    CHECK(bench.first_message().find("a.png") != std::string::npos);
    std::filesystem::rename(folder.file("new.png", right), path);
    bench.wait_until([&] { return bench.mine().current; });
    CHECK(bench.label() == "My picture: no mistake");
    CHECK(bench.mine().verdicts.size() == 2);
    CHECK(bench.state.get<InspectorState>().tab == InspectorTab::Vectors);  // nothing else has changed
}
