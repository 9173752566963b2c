// What is written is true: the written factors of a line, multiplied, are the written result within its last
// digit, whatever the light, the model and the pixel.
#include "renderer/inspect/explain/equation_text.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <sstream>

#include "models/fields/choices.h"
#include "renderer/inspect/explain/explain_format.h"
#include "renderer/inspect/explain/printed_number.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;

namespace {

std::vector<std::string> split(const std::string& text, const std::string& at) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t to; (to = text.find(at, from)) != std::string::npos; from = to + at.size())
        parts.push_back(text.substr(from, to - from));
    parts.push_back(text.substr(from));
    return parts;
}

/// The number at the end of "k_d 0.8", "k_d (0.8 0.1 0.1)", "n·l -0.2 → 0": the last one, or the channel's.
double number_in(const std::string& text, std::size_t channel) {
    if (text.back() != ')') return std::atof(text.substr(text.rfind(' ') + 1).c_str());
    const std::size_t open = text.rfind('(');
    return std::atof(split(text.substr(open + 1, text.size() - open - 2), " ").at(channel).c_str());
}

/// The value of "(r·v 0.987)^32", or of what number_in() reads.
double factor_value(const std::string& text, std::size_t channel) {
    if (text == "π/4") return std::acos(-1.0) / 4;
    const std::size_t power = text.rfind(")^");
    if (power == std::string::npos) return number_in(text, channel);
    return std::pow(number_in(text.substr(1, power - 1), channel), std::atof(text.c_str() + power + 2));
}

/// Multiplies and divides what stands between " · " and " / ".
double evaluated(const std::string& product, std::size_t channel) {
    double value = 1;
    for (const std::string& part : split(product, " · ")) {
        const std::vector<std::string> over = split(part, " / ");
        value *= factor_value(over[0], channel);
        for (std::size_t i = 1; i < over.size(); ++i) value /= factor_value(over[i], channel);
    }
    return value;
}

bool within_last_digit(double value, const std::string& written) {
    return std::abs(value - std::atof(written.c_str())) <= 1.0000001 * last_digit_of(written);
}

/// "product = result", or "product = what is left out, why" and the result 0.
void check_line(const std::string& product, const std::string& result, std::size_t channel) {
    INFO(product << " gives " << result);
    const std::size_t equals = product.find(" = ");
    if (equals == std::string::npos) {
        CHECK(within_last_digit(evaluated(product, channel), result));
        return;
    }
    CHECK(std::atof(result.c_str()) == 0);
    std::string dropped = product.substr(equals + 3, product.find(", ") - equals - 3);
    if (dropped.front() == '(') dropped = split(dropped.substr(1, dropped.size() - 2), " ").at(channel);
    CHECK(within_last_digit(evaluated(product.substr(0, equals), channel), dropped));
}

/// Numbers with all their digits, as a hand that drags leaves them.
class Dice {
  public:
    explicit Dice(unsigned seed) : random_(seed) {}
    float between(double low, double high) {
        return static_cast<float>(low + (high - low) * static_cast<double>(random_()) / 4294967295.0);
    }
    glm::vec3 colour() { return {between(0, 1), between(0, 1), between(0, 1)}; }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  private:
    std::mt19937 random_;
};

Light random_light(Dice& dice, LightKind kind) {
    Light light;
    light.kind = kind;
    const glm::vec3 towards{dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)};
    const float away = dice.between(1.5, 6);
    light.position = glm::vec4(away * towards, kind == LightKind::Directional ? 0 : 1);
    light.ambient = 0.2f * dice.colour(), light.diffuse = dice.colour(), light.specular = dice.colour();
    light.intensity = dice.between(0.05, 8);
    light.falloff = {dice.between(0, 1), dice.between(0, 1), dice.between(0.01, 1)};
    light.spot = {-towards, dice.between(10, 90), dice.between(0, 40)};
    light.area = {{dice.between(0.2, 2), 0, 0}, {0, 0, dice.between(0.2, 2)}, 16};
    return light;
}

Scene random_scene(Dice& dice, LightKind kind, Reflection reflection) {
    Scene scene = test::busy_scene();
    scene.lights = {random_light(dice, kind), random_light(dice, kind)};
    scene.global_ambient = dice.colour();
    scene.shading.reflection = reflection;
    scene.shading.mode = dice.below(3) == 0 ? ShadingMode::Gouraud : ShadingMode::Phong;
    for (Object& object : scene.objects)
        object.material = {dice.colour(),
                           dice.colour(),
                           dice.colour(),
                           0.1f * dice.colour(),
                           dice.between(0, dice.below(2) == 0 ? 30 : 4000),
                           dice.between(0, 1),
                           dice.colour()};
    return scene;
}

std::string of_window(double x) { return fmt::format("{:.3f}", x); }

/// Each line of a point in each channel, as the window writes them.
int check_lines(const Scene& scene, const Explanation& e, const ExplainedPoint& at) {
    int lines = 0;
    const auto check = [&](const EquationLine& line) {
        for (int c = 0; c < 3; ++c)
            check_line(written_product(line, c, of_window), of_window(line.result[c]),
                       static_cast<std::size_t>(c));
        ++lines;
    };
    for (const EquationLine& line : unlit_lines(scene, e, at)) check(line);
    for (const ExplainedLight& light : at.lights) {
        check(share_line({scene, e, light}));
        for (const EquationLine& line : light_lines({scene, e, light})) check(line);
    }
    return lines;
}

/// Each term that the text of an explanation writes, whose red, green and blue end a line.
int check_text(const std::string& text) {
    std::istringstream in(text);
    int terms = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind("  f = ", 0) == 0) {
            const std::size_t last = line.rfind(" = ");
            check_line(line.substr(6, last - 6), line.substr(last + 3), 0);
            continue;
        }
        const std::string name = line.substr(0, line.find(' ', 2));
        if (name != "  ambient" && name != "  diffuse" && name != "  specular") continue;
        std::string product = line.substr(12), numbers = line;
        if (line.find("  ", 12) == std::string::npos) std::getline(in, numbers);  // it was too long
        if (const std::size_t gap = product.find("  "); gap != std::string::npos) product.resize(gap);
        REQUIRE(numbers.size() > 30);
        for (std::size_t c = 0; c < 3; ++c)
            check_line(product, numbers.substr(numbers.size() - 30 + 10 * c, 10), c);
        ++terms;
    }
    return terms;
}

}  // namespace

TEST_CASE("what is written of 500 pixels under every kind of light and model multiplies to what is written",
          "[explain][why]") {
    Dice dice(14);
    Renderer renderer(1);
    constexpr PictureSize size{64, 48};
    int pixels = 0, lines = 0, terms = 0;
    for (int round = 0; pixels < 500; ++round)
        for (const LightKind kind : enumerators<LightKind>)
            for (const Reflection reflection : enumerators<Reflection>) {
                if (reflection == Reflection::None) continue;
                const Scene scene = random_scene(dice, kind, reflection);
                (void)renderer.render(scene, size);
                for (int tries = 0, hits = 0; tries < 100 && hits < 5; ++tries) {
                    const Explanation e = renderer.explain(dice.below(size.width), dice.below(size.height));
                    if (!e.hit) continue;
                    ++hits, ++pixels;
                    INFO(name_of(kind)
                         << ' ' << name_of(reflection) << ' ' << e.x << ", " << e.y << ", round " << round);
                    if (!e.lit_per_corner) lines += check_lines(scene, e, e.at);
                    for (const ExplainedCorner& corner : e.corners) lines += check_lines(scene, e, corner.at);
                    terms += check_text(explain_text(e, scene));
                }
            }
    CHECK(lines > 5000);
    CHECK(terms > 2500);
}

TEST_CASE("a model without a highlight has no line for one", "[explain][why]") {
    Scene scene = test::busy_scene();
    Renderer renderer(1);
    for (const Reflection reflection : enumerators<Reflection>) {
        scene.shading.reflection = reflection;
        (void)renderer.render(scene, {96, 72});
        const Explanation e = renderer.explain(48, 36);
        REQUIRE(e.hit);
        for (const ExplainedLight& light : e.at.lights) {
            const std::size_t expected = info_of(reflection).has_highlight ? 3 : 2;
            CAPTURE(choice_of(reflection).label);
            CHECK(light_lines({scene, e, light}).size() == expected);
        }
    }
}

TEST_CASE("a highlight behind the surface is written as what is dropped, and not as a product with n·l",
          "[explain][why]") {
    Scene scene = test::busy_scene();
    scene.shading.reflection = Reflection::BlinnPhong;
    Renderer renderer(1);
    (void)renderer.render(scene, {96, 72});
    int dropped = 0;
    for (int y = 0; y < 72; y += 3)
        for (int x = 0; x < 96; x += 3) {
            const Explanation e = renderer.explain(x, y);
            for (const ExplainedLight& light : e.at.lights) {
                if (!light.samples.empty() || light.n_dot_l >= 0) continue;
                ++dropped;
                const std::string text = written_product(light_lines({scene, e, light}).back(), 0, of_window);
                CHECK(text.rfind("(n·h ", 0) == 0);
                CHECK(text.ends_with(", dropped: n·l < 0"));
            }
        }
    CHECK(dropped > 20);
}

TEST_CASE("each letter of the equation stands for one thing, in LaTeX too", "[explain][why]") {
    std::set<std::string> letters, latex;
    for (std::size_t i = 0; i < quantity_rows.size(); ++i) {
        const QuantityRow& row = quantity_rows[i];
        INFO(row.meaning);
        CHECK(static_cast<std::size_t>(row.quantity) == i);
        CHECK(letters.insert(text_of(row.quantity)).second);
        CHECK(latex.insert(row.latex).second);
        CHECK(*row.meaning != 0);
    }
}

TEST_CASE("a Gouraud pixel has what each way of weighing the corners makes of it", "[explain][why]") {
    Scene scene = test::busy_scene();
    scene.shading.mode = ShadingMode::Gouraud;
    Renderer drawn(1), other(1);
    (void)drawn.render(scene, {96, 72});
    int different = 0, pixels = 0;
    for (const Interpolation interpolation : enumerators<Interpolation>) {
        Scene changed = scene;
        changed.shading.interpolation = interpolation;
        const Picture& picture = other.render(changed, {96, 72}, true);
        for (int y = 1; y < 72; y += 5)
            for (int x = 1; x < 96; x += 5) {
                const Explanation e = drawn.explain(x, y);
                if (!e.hit || e.stroke.coverage > 0) continue;
                REQUIRE(e.interpolations.size() == enumerators<Interpolation>.size());
                const auto& found = e.interpolations[static_cast<std::size_t>(interpolation)];
                CHECK(found.interpolation == interpolation);
                CHECK(found.sum == picture.linear_at(x, y));
                ++pixels;
                different += found.sum != e.sum ? 1 : 0;
            }
    }
    CHECK(pixels > 100);
    CHECK(different > 20);
}
