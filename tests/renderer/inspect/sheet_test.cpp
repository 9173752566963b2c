// Grids of pictures: splitting of values, positions of pictures, and their labels.
#include "renderer/image/sheet.h"

#include <algorithm>
#include <cstdlib>

#include "models/scene_file/scene_file.h"
#include "renderer/image/compare.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

using Values = std::vector<std::string>;

Values values_of(const std::string& text) {
    const auto axis = parse_axis("--rows", text);
    INFO(text);
    REQUIRE(problem_of(axis) == nullptr);
    return std::get<SheetAxis>(axis).values;
}

Font font() {
    auto found = Font::find();
    REQUIRE(problem_of(found) == nullptr);
    return std::get<Font>(std::move(found));
}

Picture filled(PictureSize size, std::uint8_t value) {
    Picture p;
    p.size = size;
    p.rgba.assign(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), value);
    return p;
}

/// The number of dark pixels in [left, right) x [top, bottom).
int ink_in(const Picture& p, int left, int top, int right, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) count += p.rgba[4 * p.pixel(x, y)] < 140;
    return count;
}

}  // namespace

TEST_CASE("sheet: commas inside brackets, braces and strings belong to a value", "[sheet]") {
    CHECK(values_of("/a/b=8,32,128") == Values{"8", "32", "128"});
    CHECK(values_of("/lights/0/position=[1,2,3],[0,0,1,0]") == Values{"[1,2,3]", "[0,0,1,0]"});
    CHECK(values_of("/x={\"a\":[1,2],\"b\":3},\"a,\\\",b\",word") ==
          Values{"{\"a\":[1,2],\"b\":3}", "\"a,\\\",b\"", "word"});
}

TEST_CASE("sheet: an axis without a pointer, '=' or value is refused", "[sheet]") {
    for (const char* text : {"", "a=1", "/a", "/a=", "/a=1,,2", "/a=1,"}) {
        INFO(text);
        const auto axis = parse_axis("--cols", text);
        REQUIRE(problem_of(axis) != nullptr);
        CHECK(problem_of(axis)->file == "--cols");
    }
}

TEST_CASE("sheet: every picture is in its cell and each row and column has a label", "[sheet]") {
    const SheetAxis rows{"/shading/mode", {"flat", "phong"}}, columns{"/display/exposure", {"1", "2", "[3]"}};
    const PictureSize cell{60, 50};
    const Font f = font();
    Picture drawn;
    const Picture sheet =
        make_sheet(rows, columns, cell, f, [&](std::size_t r, std::size_t c) -> const Picture& {
            return drawn = filled(cell, static_cast<std::uint8_t>(200 + 10 * r + c));
        });
    CHECK(sheet.size == sheet_size(rows, columns, cell, f));
    // Cells are located from the right and bottom, where there is only the margin.
    const int margin = 14, gap = 7;
    for (int r = 0; r < 2; ++r)
        for (int c = 0; c < 3; ++c) {
            const int right = sheet.size.width - margin - (2 - c) * (cell.width + gap);
            const int bottom = sheet.size.height - margin - (1 - r) * (cell.height + gap);
            int same = 0;
            for (int y = bottom - cell.height; y < bottom; ++y)
                for (int x = right - cell.width; x < right; ++x)
                    same += sheet.rgba[4 * sheet.pixel(x, y)] == 200 + 10 * r + c;
            CHECK(same == cell.width * cell.height);
            CHECK(sheet.rgba[4 * sheet.pixel(right, bottom - 1)] == 255);
            const int top = sheet.size.height - margin - 2 * cell.height - gap;
            CHECK(ink_in(sheet, right - cell.width, 0, right, top) > 20);  // above the column
            const int left = sheet.size.width - margin - 3 * cell.width - 2 * gap;
            CHECK(ink_in(sheet, 0, bottom - cell.height, left, bottom) > 20);  // next to the row
        }
}

TEST_CASE("sheet: labels that do not fit end in an ellipsis", "[sheet]") {
    const Font f = font();
    const std::string text = "[0.125, 0.25, 0.5] größer als die Zelle";
    for (const int most : {20, 50, 100, 200}) {
        const std::string shown = f.fitted(text, 16, most);
        CHECK(f.width(shown, 16) <= most);
        CHECK(shown.ends_with("…"));
    }
    CHECK(f.fitted("ok", 16, 200) == "ok");
    CHECK(f.fitted("\xff\xff\xff", 16, 5).size() <= 4);  // not UTF-8, and almost no space
}

TEST_CASE("sheet: a missing font is reported with the package to install", "[sheet]") {
    setenv("GLINT_FONT", "/nonexistent/font.ttf", 1);
    const auto found = Font::find();
    unsetenv("GLINT_FONT");
    REQUIRE(problem_of(found) != nullptr);
    CHECK(problem_of(found)->text() ==
          "/nonexistent/font.ttf: cannot be read as a scalable font; expected a TrueType font, such as that "
          "of the package fonts-dejavu-core, or the path of one in GLINT_FONT");
}

TEST_CASE("variant: a changed scene shares the unchanged meshes", "[scene]") {
    SceneDocument document;
    document.scene = busy_scene();
    for (Object& o : document.scene.objects)
        o.source = PrimitiveMesh{Primitive::Torus, o.name == "Box" ? 6 : 8};
    const auto changed =
        scene_variant(document, {{"/objects/1/mesh/detail", "12"}, {"/lights/0/type", "point"}});
    REQUIRE(problem_of(changed) == nullptr);
    const auto& scene = std::get<Scene>(changed);
    CHECK(scene.objects[0].mesh == document.scene.objects[0].mesh);
    CHECK(scene.objects[1].mesh->face_count() == 12 * 6);
    CHECK(scene.lights[0].kind == LightKind::Point);  // although its w was 0

    const auto wrong = scene_variant(document, {{"/objects/0/mesh/detail", "-1"}});
    REQUIRE(problem_of(wrong) != nullptr);
    CHECK(problem_of(wrong)->file == "--set");
    CHECK(problem_of(wrong)->pointer == "/objects/0/mesh/detail");
}

namespace {

Picture picture(PictureSize size, std::vector<std::uint8_t> rgba) { return {size, std::move(rgba), {}}; }

}  // namespace

TEST_CASE("a picture does not differ from itself", "[compare]") {
    const Picture a = picture({2, 1}, {1, 2, 3, 255, 4, 5, 6, 255});
    const auto result = std::get<Comparison>(compare(a, a));
    CHECK(result.max_error == 0);
    CHECK(result.differing_pixels == 0);
    CHECK(result.rmse == std::array<double, 3>{0, 0, 0});
    CHECK(difference_gain(result) == 1);
}

TEST_CASE("max, mean, RMSE and the count of differing pixels match hand-computed ones", "[compare]") {
    // Differences of red 3, 0, 4, 0; of green 0, 0, 0, 10; of blue none.
    const Picture a = picture({2, 2}, {10, 0, 7, 255, 9, 0, 7, 255, 4, 0, 7, 255, 8, 10, 7, 255});
    const Picture b = picture({2, 2}, {13, 0, 7, 255, 9, 0, 7, 255, 0, 0, 7, 255, 8, 20, 7, 255});
    for (const auto& result : {std::get<Comparison>(compare(a, b)), std::get<Comparison>(compare(b, a))}) {
        CHECK(result.max == std::array<int, 3>{4, 10, 0});
        CHECK(result.mean == std::array<double, 3>{7.0 / 4, 10.0 / 4, 0});
        CHECK(result.rmse[0] == Approx(2.5));  // sqrt((9 + 16) / 4)
        CHECK(result.rmse[1] == Approx(5));    // sqrt(100 / 4)
        CHECK(result.differing_pixels == 3);
        CHECK(result.max_error == 10);
    }
    // 25 · 10 = 250 is the largest product within 255.
    CHECK(difference_gain(std::get<Comparison>(compare(a, b))) == 25);
    CHECK(difference_picture(a, b, 25).rgba ==
          std::vector<std::uint8_t>{75, 0, 0, 255, 0, 0, 0, 255, 100, 0, 0, 255, 0, 250, 0, 255});
    CHECK(difference_picture(a, b, 64).rgba ==  // 3 · 64 = 192, larger values are clamped to 255
          std::vector<std::uint8_t>{192, 0, 0, 255, 0, 0, 0, 255, 255, 0, 0, 255, 0, 255, 0, 255});
}

TEST_CASE("a difference in opacity alone counts as a difference", "[compare]") {
    const Picture a = picture({1, 1}, {1, 2, 3, 255}), b = picture({1, 1}, {1, 2, 3, 215});
    const auto result = std::get<Comparison>(compare(a, b));
    CHECK(result.alpha_max == 40);
    CHECK(result.max_error == 40);
    CHECK(result.differing_pixels == 1);
    CHECK(difference_picture(a, b, 6).rgba == std::vector<std::uint8_t>{240, 240, 240, 255});
}

TEST_CASE("pictures of different sizes are not compared", "[compare]") {
    const auto result =
        compare(picture({2, 1}, std::vector<std::uint8_t>(8)), picture({1, 2}, std::vector<std::uint8_t>(8)));
    REQUIRE(problem_of(result) != nullptr);
    CHECK(problem_of(result)->text() ==
          "the pictures have the sizes 2x1 and 1x2; expected two of the same size");
}
