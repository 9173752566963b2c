// Pictures drawn by the shader that `glint code` writes, unchanged and with mistakes in its code.
#include <cstdio>
#include <filesystem>

#include "diagnose/diagnose.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "shader/shader_canvas.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"
#include "tests/support/mistake_scenes.h"

using namespace glint;

#ifdef GLINT_SANITIZED
// Mesa's shader compiler does not free a few hundred bytes.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace {

constexpr PictureSize size{160, 120};

/// The file lighting.glsl for a scene; empty if GLSL cannot draw it.
std::string lighting_of(const Scene& scene, bool blank = false) {
    const auto program = write_program({scene, size, "scene", blank}, Language::Glsl);
    if (problem_of(program) != nullptr) return {};
    for (const ProgramFile& file : std::get<Program>(program).texts)
        if (file.name == "lighting.glsl") return file.text;
    return {};
}

ShaderPicture drawn(const Scene& scene, const std::string& text) {
    CornerCache cache;
    const Result<ShaderScene> shaded = shader_scene(scene, size, cache);
    if (const Problem* problem = problem_of(shaded)) FAIL(problem->text());
    const OffscreenContext context;
    ShaderCanvas canvas;
    const ShaderLog log = canvas.compile(std::get<ShaderScene>(shaded), text);
    for (const ShaderMessage& message : log.messages) FAIL(problem_from(message, "lighting.glsl").text());
    ShaderPicture picture = canvas.draw(std::get<ShaderScene>(shaded), ShaderOutput::All);
    REQUIRE(picture.stopped.count == 0);
    return picture;
}

Diagnosis diagnosis_of(const Scene& scene, Picture picture) {
    picture.linear.clear();
    SceneDocument document;
    document.scene = scene;
    return diagnose(document, picture, {});
}

/// The number of pixels whose colours differ by more than one level.
int unlike(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(a.rgba[c] - b.rgba[c]));
        count += most > 1;
    }
    return count;
}

}  // namespace

TEST_CASE("the lighting code that Glint writes has no mistake in any scene in assets/", "[shader][release]") {
    std::string left;
    for (const std::string& path : test::asset_scenes()) {
        const Scene scene = std::get<SceneDocument>(open_document(path)).scene;
        const std::string name = std::filesystem::path(path).stem().string(), text = lighting_of(scene);
        if (scene.transport.model != TransportModel::Local) {
            CHECK(text.empty());  // GLSL lights each point separately
            continue;
        }
        if (text.empty() || scene.shading.reflection == Reflection::None) {
            left += (left.empty() ? "" : " ") + name;
            continue;
        }
        INFO(name);
        CHECK(diagnosis_of(scene, drawn(scene, text).picture).verdict == Verdict::NoMistake);
    }
    CHECK(left == "silhouettes-and-creases skew-quad t-junction");
}

TEST_CASE("a mistake in the lighting code is named first", "[shader][release]") {
    int written = 0, shown = 0, named = 0;
    std::string others;
    for (std::size_t i = 0; i < test::mistake_scenes().size(); ++i) {
        const MistakeName& mistake = mistake_names()[i];
        Scene scene = test::telling_scene();
        test::mistake_scenes()[i].where_it_shows(scene);
        if (mistake.name == "unnormalized_light")  // the file receives a unit vector to a directional light
            for (Light& light : scene.lights) light.enabled = light.kind != LightKind::Directional;
        const std::string right = lighting_of(scene);
        scene.shading.mistakes.*mistake.flag = true;
        const std::string wrong = lighting_of(scene);
        if (right.empty() || wrong.empty() || wrong == right) continue;
        scene.shading.mistakes = {};
        ++written;
        const Picture picture = drawn(scene, wrong).picture;
        constexpr int enough = 30;
        if (unlike(picture, drawn(scene, right).picture) < enough) continue;
        ++shown;
        const Diagnosis found = diagnosis_of(scene, picture);
        const bool is_first = test::is_named(found, {i});
        named += is_first;
        if (!is_first) others += " " + std::string(mistake.name);
    }
    std::printf("shader: %d mistakes written as text, %d visible, %d named first; not named first:%s\n",
                written, shown, named, others.c_str());
    CHECK(written >= 20);
    CHECK(shown >= 18);
    CHECK(others == "");
}

TEST_CASE("the blank lighting file compiles and draws black", "[shader]") {
    const Scene scene = test::telling_scene();
    const ShaderPicture picture = drawn(scene, lighting_of(scene, true));
    int surfaces = 0;
    for (std::size_t i = 0; i < picture.positions.size(); i += 3) {
        if (picture.positions[i + 2] == 0) continue;  // the background
        ++surfaces;
        REQUIRE(picture.picture.rgba[i / 3 * 4] == 0);
    }
    CHECK(surfaces > 1000);
}

TEST_CASE("a shader's picture has the positions and normals of its pixels", "[shader]") {
    const Scene scene = test::telling_scene();
    const ShaderPicture picture = drawn(scene, "vec3 lit(vec3 p, vec3 n) { return p; }");
    for (std::size_t i = 0; i < picture.positions.size(); i += 3) {
        if (picture.positions[i + 2] == 0) continue;
        const float *const n = &picture.normals[i], *const color = &picture.picture.linear[i];
        REQUIRE(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] == Approx(1).epsilon(1e-5));
        REQUIRE(std::equal(color, color + 3, &picture.positions[i]));
    }
}
