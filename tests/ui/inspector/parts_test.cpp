// The window's smaller parts: colours, columns, texts, folders, names.
#include <filesystem>
#include <fstream>

#include "renderer/explain/equation_text.h"
#include "tests/support/catch.h"
#include "ui/document/document_actions.h"
#include "ui/document/file_dialog.h"
#include "ui/document/scene_edit.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/orbit.h"
#include "ui/picture/screen.h"
#include "ui/shell/layout.h"
#include "ui/widgets/theme.h"

using namespace glint;

TEST_CASE("black on white has a contrast of 21", "[ui]") {
    CHECK(contrast({0, 0, 0, 1}, {1, 1, 1, 1}) == Approx(21));
    CHECK(contrast({1, 0, 0, 1}, {1, 0, 0, 1}) == Approx(1));
}

TEST_CASE("text and symbols have a contrast of at least 4.5 on every background", "[ui]") {
    for (const Theme* t : {&dark_theme(), &light_theme()})
        for (const ImVec4& ground : {t->window, t->panel}) {
            for (const ImVec4& ink : {t->text, t->dim_text, t->warning, t->error})
                CHECK(contrast(ink, ground) >= 4.5);
            for (const ImVec4& symbol : t->symbols) CHECK(contrast(symbol, ground) >= 4.5);
            CHECK(contrast(t->accent_text, t->accent) >= 4.5);
            CHECK(contrast(t->text, t->field) >= 4.5);
        }
}

TEST_CASE("the area around the picture is neutral grey in both themes", "[ui]") {
    for (const Theme* t : {&dark_theme(), &light_theme()}) {
        CHECK(t->surround.x == t->surround.y);
        CHECK(t->surround.y == t->surround.z);
    }
}

TEST_CASE("columns tile the window without overlap, at any size and scale", "[ui]") {
    for (const float scale : {1.0f, 1.5f, 2.0f})
        for (const ImVec2 window : {ImVec2(1280, 800), ImVec2(1920, 1080), ImVec2(1024, 640),
                                    ImVec2(3840, 2160), ImVec2(320, 240), ImVec2(40, 30)})
            for (const bool folded : {false, true}) {
                const Layout l = lay_out(window, {.hides_columns = folded}, scale);
                CHECK(l.centre.low.x >= (l.has_left ? l.left.high.x : 0));
                CHECK(l.centre.high.x <= (l.has_right ? l.right.low.x : window.x));
                CHECK(l.centre.size().x >= 1);
                CHECK(l.centre.size().y >= 1);
                CHECK(l.top.high.y <= l.centre.low.y);
                CHECK(l.centre.high.y <= l.status.low.y + 1);
                CHECK(l.centre.size().x >= window.x / 3 - 1);
                CHECK(l.inspector_in_left == (window.x < 1100 * scale));
                const Rect picture = picture_area(l.centre, scale);
                CHECK(picture.size().x >= 1);
                CHECK(picture.low.x >= l.centre.low.x);
                CHECK(picture.high.x <= l.centre.high.x + 1);
                CHECK(picture.high.y <= l.centre.high.y + 1);
            }
}

TEST_CASE("a text explains why a pixel is dark", "[ui]") {
    Light spot;
    spot.kind = LightKind::Spot;
    spot.spot.cutoff_deg = 30;
    ExplainedLight e;
    e.n_dot_l = 0.5f;
    e.spot_angle_deg = 34.2f;
    e.spot = 0;
    CHECK(dark_reason(e, spot) == "outside the cone by 4.2°");
    e.spot_angle_deg = 10;
    e.spot = 0.9f;
    CHECK(dark_reason(e, spot).empty());
    e.spot = 0;  // a mistake makes the cone narrower than in the scene
    CHECK(dark_reason(e, spot) == "its cone lets through 0");
    e.spot_angle_deg = 44;
    e.spot = 1;  // a mistake makes the cone wider
    CHECK(dark_reason(e, spot).empty());
    e.n_dot_l = -0.12f;
    CHECK(dark_reason(e, spot) == "behind the surface: n·l < 0");
    for (const float rounded : {-3e-6f, 0.0f, 2e-6f}) {
        e.n_dot_l = rounded;
        CHECK(dark_reason(e, spot) == "grazes the surface: n·l = 0");
    }
    e.n_dot_l = 0.3f;
    e.falloff = 0.003f;
    CHECK(dark_reason(e, spot) == "hardly reaches: falloff 0.003");
    spot.intensity = 400;
    CHECK(dark_reason(e, spot).empty());
    e.n_dot_l = -0.3f;
    e.diffuse = glm::vec3(0.2f);  // because of a mistake
    CHECK(dark_reason(e, spot).empty());
    Light area;
    area.kind = LightKind::Area;
    area.area.samples = 4;
    ExplainedLight samples;
    samples.samples.resize(4);
    CHECK(dark_reason(samples, area) == "behind the surface: n·l < 0 for all samples");
    samples.samples[2].n_dot_l = 0.1f;
    CHECK(dark_reason(samples, area) == "3 of 4 samples are behind the surface");
    for (ExplainedLight& sample : samples.samples) sample.n_dot_l = 0.5f;
    CHECK(dark_reason(samples, area).empty());
    samples.reached = 0.5f;
    samples.blocked_by = "Box";
    CHECK(dark_reason(samples, area) == "2 of 4 samples reach the point; the others are blocked by Box");
    area.area.samples = 64;
    CHECK(dark_reason(samples, area) ==
          "2 of 4 samples reach the point; the others are blocked by Box (4 of 64 samples so far)");
    CHECK(sample_words(samples, area) == "4 of 64 samples so far, n·l  0.500 to  0.500");
    CHECK(clipping_reason({1.31f, 0.5f, 1}, 1) == "clips: R 1.31 → 1");
    CHECK(clipping_reason({0.7f, 0.4f, 0.1f}, 2) == "clips: R 1.40 → 1");
    CHECK(clipping_reason({0.7f, 0.4f, 0.1f}, 1).empty());
    CHECK(clipping_reason({5.273e29f, 0, 0}, 1) == "clips: R 5.273e+29 → 1");
}

TEST_CASE("terms computed at corners are summed with the corners' weights", "[ui]") {
    Explanation why;
    why.lit_per_corner = true;
    why.corners.resize(2);
    why.corners[0].weight = 0.25f;
    why.corners[0].at.lights.resize(1);
    why.corners[0].at.lights[0].diffuse = {0.8f, 0, 0};
    why.corners[1].weight = 0.75f;
    why.corners[1].at.global_ambient = {0.4f, 0.4f, 0.4f};
    CHECK(term_sums(why).diffuse.x == Approx(0.2f));
    CHECK(term_sums(why).ambient.y == Approx(0.3f));
}

TEST_CASE("numbers show three decimals, more after leading zeros, and no negative zero", "[ui]") {
    CHECK(shown_number(0.71334f) == " 0.713");
    CHECK(shown_number(-0.125f) == "−0.125");
    CHECK(shown_number(0.4f) == " 0.400");
    CHECK(shown_number(0.00012f) == " 0.00012");
    CHECK(shown_number(-0.0025f) == "−0.0025");
    CHECK(shown_number(0.000012f) == " 1.2e-05");
    CHECK(shown_number(-4e-8f) == " 0.000");  // rounded to zero
    CHECK(shown_number(2.6e-6f) == " 0.000");
    CHECK(shown_number(-0.0f) == " 0.000");
    CHECK(shown_number(12.345f) == " 12.35");
    CHECK(shown_number(1234.5f) == " 1234");
}

TEST_CASE("a folder lists folders first, then matching files, by name", "[ui]") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "glint_list_folder_test";
    fs::remove_all(folder);
    fs::create_directories(folder / "zoo");
    for (const char* name : {"b.json", "A.OBJ", "c.txt", ".hidden.json", "p.png"})
        std::ofstream(folder / name) << "x";
    const auto names = [&](const FilePurpose& purpose) {
        std::string all;
        for (const FolderEntry& entry : list_folder(folder.string(), purpose)) all += entry.name + " ";
        return all;
    };
    CHECK(names(open_purpose) == "zoo A.OBJ b.json p.png ");
    CHECK(names(mesh_purpose) == "zoo A.OBJ ");
    CHECK(names(save_purpose) == "zoo b.json ");
    CHECK(list_folder((folder / "nowhere").string(), open_purpose).empty());
    fs::remove_all(folder);
}

TEST_CASE("switching the kind of projection keeps the apparent size at the target", "[ui]") {
    const Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, Perspective{50, 0.1f, 100}};
    const PictureSize size = GENERATE(PictureSize{800, 500}, PictureSize{700, 723, true});
    const glm::dvec3 place{0.7, 0.4, 0};
    const ProjectedPoint before = project(screen_map(camera, size), place);
    for (const ProjectionKind kind : enumerators<ProjectionKind>) {
        Camera other = camera;
        other.projection = as_projection(camera, kind, size);
        CHECK(kind_of(other.projection) == kind);
        const ProjectedPoint after = project(screen_map(other, size), place);
        CHECK(after.pixel.x == Approx(before.pixel.x).epsilon(1e-4));
        CHECK(after.pixel.y == Approx(before.pixel.y).epsilon(1e-4));
        CHECK_FALSE(violation_of(other));
        const Projection back = as_projection(other, ProjectionKind::Perspective, size);
        CHECK(std::get<Perspective>(back).fov_y_deg == Approx(50));
    }
}

TEST_CASE("values that the scene file rejects are invalid in the window too", "[ui]") {
    Camera camera;
    camera.target = camera.eye;
    CHECK(violation_of(camera));
    camera = {};
    camera.up = camera.eye;
    CHECK(violation_of(camera));
    camera = {};
    camera.projection = Perspective{45, 2, 1};
    CHECK(violation_of(camera));
    Light light;
    CHECK_FALSE(violation_of(light));
    light.falloff = {0, 0, 0};
    CHECK(violation_of(light));
    light = {};
    light.position = {0, 0, 0, 0};
    CHECK(violation_of(light));
    light = {};
    light.area.edge_v = 2.0f * light.area.edge_u;
    CHECK(violation_of(light));
    Object object;
    object.transform.scale.y = 0;
    CHECK(violation_of(object));
}
