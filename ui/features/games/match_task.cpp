// The scenes of *Match the target*, generated from a seed, and hints about the difference.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "models/mesh/primitives/primitives.h"
#include "ui/features/games/match.h"
#include "ui/features/inspector/inspector.h"

namespace glint {
namespace {

/// Numbers in [0, 1) that are the same on every machine. Source: Steele, Lea, Flood 2014, SplitMix64.
class Draws {
  public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}
    float next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return static_cast<float>((z ^ (z >> 31U)) >> 40U) / static_cast<float>(1U << 24U);
    }
    float between(float low, float high) { return low + (high - low) * next(); }

  private:
    std::uint64_t state_;
};

/// A direction towards a sun whose highlight is visible.
glm::vec3 draw_direction(Draws& draws) {
    return {draws.between(-1, 1), draws.between(0.05f, 1), draws.between(0.35f, 0.9f)};
}

float degrees_between(glm::vec3 a, glm::vec3 b) {
    return std::acos(glm::dot(glm::normalize(a), glm::normalize(b))) * 180 / std::numbers::pi_v<float>;
}

Scene drawn_scene(Draws& draws) {
    Scene scene;
    scene.camera.eye = {0, 0.4f, 3.3f};
    scene.global_ambient = glm::vec3(0.06f);
    Light sun;
    sun.name = "Sun";
    sun.kind = LightKind::Directional;
    sun.position = glm::vec4(draw_direction(draws), 0);
    sun.intensity = 0.75f;
    scene.lights = {sun};
    Object ball;
    ball.name = "Ball";
    ball.source = PrimitiveMesh{Primitive::Sphere, 96};
    ball.mesh = std::make_shared<const Mesh>(make_primitive(Primitive::Sphere, 96));
    ball.material.ambient = glm::vec3(0.5f);
    ball.material.diffuse = {draws.between(0.15f, 0.6f), draws.between(0.15f, 0.6f),
                             draws.between(0.15f, 0.6f)};
    ball.material.specular = glm::vec3(0.6f);
    ball.material.shininess = std::round(std::exp2(draws.between(2.5f, 6.5f)));
    scene.objects = {ball};
    return scene;
}

/// Moves a light far enough that the player notices.
void move_sun(MatchTask& task, Draws& draws) {
    constexpr float least_deg = 30;
    glm::vec3 way = task.start.lights[0].position;
    while (degrees_between(way, task.start.lights[0].position) < least_deg) way = draw_direction(draws);
    task.target.lights[0].position = glm::vec4(way, 0);
    for (const char* axis : {"0", "1", "2"})
        task.numbers.push_back(std::string("/lights/0/position/") + axis);
}

void change_exponent(MatchTask& task, Draws& draws) {
    const float before = task.start.objects[0].material.shininess;
    const bool sharper = before < 25;
    task.target.objects[0].material.shininess =
        std::round(before * (sharper ? draws.between(3, 6) : 1 / draws.between(3, 6)));
    task.numbers.emplace_back("/objects/0/material/shininess");
}

void change_brightness(MatchTask& task, Draws& draws) {
    task.target.lights[0].intensity =
        draws.next() < 0.5f ? draws.between(0.35f, 0.5f) : draws.between(1, 1.2f);
    task.numbers.emplace_back("/lights/0/intensity");
}

/// A picture of one term: its brightness, the number of its bright pixels, and their position.
struct Blob {
    double sum = 0, bright = 0;
    glm::dvec2 middle{0};
};
Blob blob_of(const Picture& picture) {
    Blob blob;
    int most = 0;
    const auto level = [&](int x, int y) {
        const std::size_t at = 4 * picture.pixel(x, y);
        return picture.rgba[at] + picture.rgba[at + 1] + picture.rgba[at + 2];
    };
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) most = std::max(most, level(x, y));
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            blob.sum += level(x, y);
            if (most == 0 || 2 * level(x, y) < most) continue;
            ++blob.bright;
            blob.middle += glm::dvec2(x, y);
        }
    if (blob.bright > 0) blob.middle /= blob.bright;
    return blob;
}

/// The term alone, on black.
Picture term_picture(Renderer& renderer, const Scene& scene, Symbol term) {
    Scene alone = with_term_alone(scene, term);
    alone.display.background = glm::vec3(0);
    return renderer.render(alone, match_size);
}

/// Describes how `mine` differs from `wanted` in position, size or brightness.
std::string how(const Blob& mine, const Blob& wanted, const char* what, bool has_size) {
    constexpr double far = 5, larger = 1.25, brighter = 1.08;  // pixels of match_size; ratios
    if (mine.bright == 0) return fmt::format("{} is missing", what);
    if (glm::length(mine.middle - wanted.middle) > far) return fmt::format("{} is elsewhere", what);
    if (has_size && mine.bright > larger * wanted.bright) return fmt::format("{} is too large", what);
    if (has_size && wanted.bright > larger * mine.bright) return fmt::format("{} is too small", what);
    if (mine.sum > brighter * wanted.sum) return fmt::format("{} is too bright", what);
    if (wanted.sum > brighter * mine.sum) return fmt::format("{} is too dark", what);
    return fmt::format("{} is slightly displaced", what);
}

}  // namespace

double apart_of(const Picture& a, const Picture& b) {
    const auto c = std::get<Comparison>(compare(a, b));
    return std::sqrt((c.rmse[0] * c.rmse[0] + c.rmse[1] * c.rmse[1] + c.rmse[2] * c.rmse[2]) / 3);
}

MatchTask match_task(std::uint64_t seed) {
    Draws draws(seed);
    MatchTask task;
    task.start = drawn_scene(draws);
    task.target = task.start;
    // The seed decides which of the three changes are made; there is at least one.
    const std::uint64_t changes = seed % 7 == 0 ? 7 : seed % 7;
    if ((changes & 1U) != 0) move_sun(task, draws);
    if ((changes & 2U) != 0) change_exponent(task, draws);
    if ((changes & 4U) != 0) change_brightness(task, draws);
    return task;
}

std::string match_hint(Renderer& renderer, const Scene& scene, const Scene& target) {
    struct Term {
        Symbol symbol;
        const char *name, *what;
        bool has_size;
    };
    constexpr std::array terms{Term{Symbol::Ambient, "ambient", "it", false},
                               Term{Symbol::Diffuse, "diffuse", "its light", false},
                               Term{Symbol::Specular, "specular", "its highlight", true}};
    if (scene.shading != target.shading)
        return "The shading differs from the target's: Begin again restores it.";
    double most = 0;
    std::string hint = "Nothing differs.";
    for (const Term& term : terms) {
        const Picture wanted = term_picture(renderer, target, term.symbol);
        const Picture mine = term_picture(renderer, scene, term.symbol);
        const double apart = apart_of(mine, wanted);
        if (apart <= most) continue;
        most = apart;
        hint = fmt::format("The {} term is off most: {}.", term.name,
                           how(blob_of(mine), blob_of(wanted), term.what, term.has_size));
    }
    return hint;
}

}  // namespace glint
