// Labels that do not overlap.
#include <cmath>
#include <random>

#include "tests/support/catch.h"
#include "ui/features/inspector/label_room.h"

using namespace glint;

namespace {

struct Placed {
    ImVec2 middle, size;
};

bool overlap(const Placed& a, const Placed& b) {
    return std::abs(a.middle.x - b.middle.x) < (a.size.x + b.size.x) / 2 - 1e-3f &&
           std::abs(a.middle.y - b.middle.y) < (a.size.y + b.size.y) / 2 - 1e-3f;
}

}  // namespace

TEST_CASE("a label is at its preferred position if nothing is there", "[ui]") {
    LabelRoom room;
    const auto at = room.place({100, 50}, {40, 12}, 30);
    REQUIRE(at);
    CHECK((at->x == 100 && at->y == 50));
    const auto beside = room.place({140, 50}, {40, 12}, 30);  // touching
    REQUIRE(beside);
    CHECK((beside->x == 140 && beside->y == 50));
}

TEST_CASE("labels move apart as little as possible, within their reach", "[ui]") {
    std::mt19937 random(3);
    const auto number = [&random](float low, float high) {
        return low + (high - low) * float(random() % 10'000) / 10'000;
    };
    for (int round = 0; round < 200; ++round) {
        LabelRoom room;
        std::vector<Placed> placed;
        for (int i = 0; i < 12; ++i) {
            const ImVec2 wanted{number(0, 160), number(0, 90)}, size{number(10, 50), number(10, 16)};
            const bool free = [&] {
                for (const Placed& other : placed)
                    if (overlap(other, {wanted, size})) return false;
                return true;
            }();
            const auto at = room.place(wanted, size, 40);
            if (!at) continue;
            const float away = std::hypot(at->x - wanted.x, at->y - wanted.y);
            CHECK(away <= 40.01f);
            CHECK((away == 0) == free);
            for (const Placed& other : placed) CHECK_FALSE(overlap(other, {*at, size}));
            placed.push_back({*at, size});
        }
        CHECK(placed.size() >= 8);
    }
}

TEST_CASE("without room a label is left out, or written at its preferred position", "[ui]") {
    LabelRoom room;
    room.keep_free({{0, 0}, {200, 200}});
    CHECK_FALSE(room.place({100, 100}, {30, 12}, 40));
    const ImVec2 at = room.place_anyhow({100, 100}, {30, 12}, 40);
    CHECK((at.x == 100 && at.y == 100));
}

TEST_CASE("a label stays inside its bounds", "[ui]") {
    LabelRoom room({{0, 0}, {100, 60}});
    const auto right = room.place({95, 20}, {40, 12}, 30);
    REQUIRE(right);
    CHECK((right->x == 80 && right->y == 20));
    const auto below = room.place({95, 20}, {40, 12}, 30);
    REQUIRE(below);
    CHECK(below->x <= 80);
    CHECK(std::abs(below->y - 20) >= 12);
    const ImVec2 wide = room.place_anyhow({95, -7}, {300, 12}, 30);  // from its beginning
    CHECK((wide.x == 150 && wide.y == 6));
}
