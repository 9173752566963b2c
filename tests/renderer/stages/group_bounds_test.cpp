// Bounds of groups of points: lights that they exclude must add nothing.
#include "renderer/shade/group_bounds.h"

#include <random>
#include <vector>

#include "renderer/lighting/illuminate.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

using Vec = Vec3<float>;

struct Points {
    std::vector<Vec> places, normals;
    GroupBounds<float> bounds;
};

class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    float operator()(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random_);
    }
    Vec vector(float size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }

  private:
    std::mt19937 random_;
};

/// 16 positions and unit normals close together, and the tightest balls around a slightly shifted centre.
Points some_points(Dice& dice, float scale) {
    Points points;
    const Vec place = dice.vector(3 * scale), normal = unit(dice.vector(1));
    const float apart = dice(0, 0.3f), bent = dice(0, 0.5f);
    for (int i = 0; i < 16; ++i) {
        points.places.push_back(place + dice.vector(apart * scale));
        points.normals.push_back(unit(normal + dice.vector(bent)));
    }
    points.bounds.center = place;
    points.bounds.normal = normal;
    for (int i = 0; i < 16; ++i) {
        points.bounds.radius = max(points.bounds.radius, length(points.places[i] - place));
        points.bounds.spread = max(points.bounds.spread, length(points.normals[i] - normal));
    }
    return points;
}

bool some_in_front(const LightAt<float>& light, const Points& points) {
    for (std::size_t i = 0; i < 16; ++i) {
        const PointAt<float> at(points.places[i], points.normals[i], {0, 0, 1});
        if (light_vector(light, at).n_dot > 0) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("bounds that are certainly behind a light contain no point in front of it", "[lighting][release]") {
    Dice dice(7);
    int dark = 0, known = 0;
    for (int i = 0; i < 100000; ++i) {
        const float scale = std::pow(10.0f, dice(-6, 6));
        const Points points = some_points(dice, scale);
        LightAt<float> light;
        light.w = i % 3 ? 1.0f : 0.0f;
        light.xyz = is_positional(light) ? dice.vector(4 * scale) : unit(dice.vector(1));
        const bool behind = certainly_behind(light, points.bounds), front = some_in_front(light, points);
        REQUIRE_FALSE((behind && front));
        dark += !front;
        known += behind;
    }
    CHECK(known > dark / 2);  // it is useful
}

TEST_CASE("bounds are uncertain if they are not numbers, or if a light is among the points", "[lighting]") {
    LightAt<float> light;
    light.w = 1;
    light.xyz = {0, 0, -1};
    GroupBounds<float> bounds{{0, 0, 0}, 0.5f, {0, 0, 1}, 0};
    CHECK(certainly_behind(light, bounds));
    light.xyz = {0, 0, -0.4f};
    CHECK_FALSE(certainly_behind(light, bounds));
    light.xyz = {0, 0, -1};
    for (float* number : {&bounds.center.x, &bounds.radius, &bounds.normal.y, &bounds.spread}) {
        const float before = *number;
        for (const float bad : {std::nanf(""), HUGE_VALF}) {
            *number = bad;
            CHECK_FALSE(certainly_behind(light, bounds));
        }
        *number = before;
    }
}
