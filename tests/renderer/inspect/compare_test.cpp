#include "renderer/image/compare.h"

#include "tests/support/catch.h"

using namespace glint;

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
