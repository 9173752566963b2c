// Fixed-function OpenGL calls for a scene: their order, their numbers, and their effect.
#include "programs/gl_calls.h"

#include <algorithm>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "models/fields/scene_fields.h"
#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/asset_scenes.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

const std::string first = project_file("assets/scenes/default.json");

Scene shipped(const std::string& path) { return std::get<SceneDocument>(open_document(path)).scene; }

std::vector<GlCall> all_calls(const Scene& scene) {
    std::vector<GlCall> all;
    for (const GlCallGroup& group : gl_calls(scene))
        all.insert(all.end(), group.calls.begin(), group.calls.end());
    return all;
}

std::vector<std::string> all_texts(const Scene& scene) {
    std::vector<std::string> all;
    for (const GlCall& call : all_calls(scene)) all.push_back(call_text(call));
    return all;
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
}

/// The effect of the calls on OpenGL's matrix, which each call multiplies from the right.
void apply(glm::dmat4& matrix, const std::string& text) {
    glm::dvec3 v;
    double angle = 0;
    if (std::sscanf(text.c_str(), "glTranslatef(%lf, %lf, %lf);", &v.x, &v.y, &v.z) == 3)
        matrix = glm::translate(matrix, v);
    if (std::sscanf(text.c_str(), "glScalef(%lf, %lf, %lf);", &v.x, &v.y, &v.z) == 3)
        matrix = glm::scale(matrix, v);
    if (std::sscanf(text.c_str(), "glRotatef(%lf, %lf, %lf, %lf);", &angle, &v.x, &v.y, &v.z) == 4)
        matrix = glm::rotate(matrix, glm::radians(angle), v);
}

}  // namespace

TEST_CASE("every number in a call equals the scene's number at its pointer", "[programs][calls]") {
    for (const std::string& path : test::asset_scenes()) {
        const Scene scene = shipped(path);
        for (const GlCall& call : all_calls(scene))
            for (const CallPiece& piece : call.pieces) {
                if (piece.pointer.empty()) continue;
                INFO(path << " " << piece.pointer);
                const auto number = number_at(scene, piece.pointer);
                REQUIRE(number);
                CHECK(static_cast<float>(std::stod(piece.text)) == static_cast<float>(number->value));
            }
    }
}

TEST_CASE("camera lights are positioned before gluLookAt, and world lights after it", "[programs][calls]") {
    const Scene scene = shipped(first);
    const std::vector<GlCall> calls = all_calls(scene);
    const auto look = std::find_if(calls.begin(), calls.end(), [](const GlCall& c) { return c.is_look_at; });
    REQUIRE(look != calls.end());
    int places = 0;
    for (auto call = calls.begin(); call != calls.end(); ++call) {
        if (call->place_of_light < 0) continue;
        ++places;
        const Light& light = scene.lights[static_cast<std::size_t>(call->place_of_light)];
        CHECK((call < look) == (light.space == LightSpace::Camera));
    }
    CHECK(places == 5);  // of four lights, one of which also has a direction
}

TEST_CASE("the calls for an object's transform produce its matrix", "[programs][calls]") {
    Scene scene;
    Object object;
    object.transform = {{1, -2, 3}, {20, -35, 50}, {0.5f, 2, -1.25f}};
    scene.objects = {object};
    glm::dmat4 matrix(1);
    for (const std::string& text : all_texts(scene)) apply(matrix, text);
    const glm::dmat4 expected = world_from_object(object.transform);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) CHECK(matrix[c][r] == Approx(expected[c][r]).margin(1e-6));
}

TEST_CASE("the OpenGL calls for the first scene are those in the lecture", "[programs][calls]") {
    const std::vector<std::string> lines = all_texts(shipped(first));
    for (const char* line :
         {"gluPerspective(28, (double)width / height, 1, 80);",
          "gluLookAt(1.1, 3.7, 9, 0.22, 1.12, 0, 0, 1, 0);",
          "{ const GLfloat v[] = {-2, 3, 2.4, 0}; glLightfv(GL_LIGHT0, GL_POSITION, v); }",
          "{ const GLfloat v[] = {0.4 * 1, 0.4 * 0.9, 0.4 * 0.76, 1}; glLightfv(GL_LIGHT0, GL_DIFFUSE, v); }",
          "glLightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 0.25);", "glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, 23);",
          "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 70);", "glRotatef(-28, 0, 1, 0);",
          "glShadeModel(GL_SMOOTH);",
          "// OpenGL 1 lights corners only; lighting each pixel needs a shader."}) {
        INFO(line);
        CHECK(has(lines, line));
    }
}

TEST_CASE("lights are numbered from 0, skipping those without calls", "[programs][calls]") {
    Scene scene = shipped(first);
    Light area, off;
    area.kind = LightKind::Area;
    off.enabled = false;
    scene.lights.insert(scene.lights.begin(), {area, off});
    std::string enabled;
    for (const std::string& text : all_texts(scene))
        if (text.starts_with("glEnable(GL_LIGHT") && text.find("LIGHTING") == text.npos) enabled += text;
    CHECK(enabled == "glEnable(GL_LIGHT0);glEnable(GL_LIGHT1);glEnable(GL_LIGHT2);glEnable(GL_LIGHT3);");
}

TEST_CASE("no call contains a variable of the program", "[programs][calls]") {
    for (const std::string& path : test::asset_scenes())
        for (const Projection& projection :
             {Projection(Perspective{}), Projection(Orthographic{}), Projection(Frustum{})}) {
            Scene scene = shipped(path);
            scene.camera.projection = projection;
            for (const std::string& text : all_texts(scene)) {
                INFO(path << ": " << text);
                CHECK((text.starts_with("//") || text.ends_with(");") || text.ends_with("v); }")));
                for (const char* variable :
                     {"->", ".x", "aspect", "first_list", "view_height", "black", "l,"})
                    CHECK(text.find(variable) == std::string::npos);
            }
        }
}

TEST_CASE("a reflection that fixed-function OpenGL can draw has no remark", "[programs][calls]") {
    Scene scene;
    scene.shading.mode = ShadingMode::Gouraud;
    const auto remarks = [&scene](Reflection reflection) {
        scene.shading.reflection = reflection;
        const std::vector<GlCall> calls = all_calls(scene);
        return std::count_if(calls.begin(), calls.end(), [](const GlCall& call) { return call.is_remark; });
    };
    CHECK(remarks(Reflection::BlinnPhong) == 0);
    CHECK(remarks(Reflection::Lambert) == 0);
    CHECK(remarks(Reflection::Phong) == 1);
    CHECK(remarks(Reflection::CookTorrance) == 1);
}
