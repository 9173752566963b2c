// The written equation is correct: the product of the written factors of a line equals the written result to
// within its last digit, for every light, model and pixel.
#include "renderer/explain/equation_text.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>
#include <sstream>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"
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

/// The number at the end of "k_d 0.8", "k_d (0.8 0.1 0.1)", "n·l -0.2 → 0": the last one or the channel's.
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

/// Evaluates factors that are separated by " · " and " / ".
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

/// Checks "product = result", or "product = omitted term, reason" with the result 0.
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

/// Numbers with many digits, as after dragging.
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

/// Checks each line of a point in each channel, as the window writes it. Returns the number of lines.
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

/// Checks each term whose red, green and blue end a line of an explanation's text. Returns the number of
/// terms.
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
        if (line.find("  ", 12) == std::string::npos) std::getline(in, numbers);  // the line was too long
        if (const std::size_t gap = product.find("  "); gap != std::string::npos) product.resize(gap);
        REQUIRE(numbers.size() > 30);
        for (std::size_t c = 0; c < 3; ++c)
            check_line(product, numbers.substr(numbers.size() - 30 + 10 * c, 10), c);
        ++terms;
    }
    return terms;
}

}  // namespace

TEST_CASE("written factors multiply to the written results for every light and model", "[explain][why]") {
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

TEST_CASE("a reflection model without a highlight has no line for one", "[explain][why]") {
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

TEST_CASE("a highlight behind the surface is written as dropped, not as a product with n·l",
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

TEST_CASE("each letter of the equation has one meaning, even in LaTeX", "[explain][why]") {
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

TEST_CASE("a Gouraud pixel combines its corners by each kind of interpolation", "[explain][why]") {
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

TEST_CASE("written factors multiply to results under each mistake, whose effect is named", "[explain][why]") {
    Dice dice(15);
    Renderer renderer(1);
    constexpr PictureSize size{32, 24};
    int lines = 0, with_mistake = 0;
    for (const MistakeName& mistake : mistake_names())
        for (const LightKind kind : enumerators<LightKind>)
            for (const Reflection reflection : enumerators<Reflection>) {
                if (reflection == Reflection::None) continue;
                Scene scene = random_scene(dice, kind, reflection);
                scene.shading.mode = ShadingMode::Phong;
                // Larger powers of dot products of unnormalized vectors would overflow.
                for (Object& object : scene.objects)
                    object.material.shininess = std::min(object.material.shininess, 4.0f);
                scene.shading.mistakes.*mistake.flag = true;
                (void)renderer.render(scene, size);
                for (int tries = 0, hits = 0; tries < 40 && hits < 2; ++tries) {
                    const Explanation e = renderer.explain(dice.below(size.width), dice.below(size.height));
                    if (!e.hit || !std::isfinite(e.sum.x + e.sum.y + e.sum.z)) continue;
                    ++hits;
                    INFO(mistake.name << ' ' << name_of(kind) << ' ' << name_of(reflection) << ' ' << e.x
                                      << ", " << e.y);
                    lines += check_lines(scene, e, e.at);
                    const std::string text = explain_text(e, scene);
                    (void)check_text(text);
                    with_mistake += text.find(" mistake ") != std::string::npos ? 1 : 0;
                }
            }
    CHECK(lines > 1000);
    CHECK(with_mistake > 50);
}

TEST_CASE("doubled ambient light is written as times 2, and a missing pi as division by pi",
          "[explain][why]") {
    Scene scene = test::busy_scene();
    scene.shading.reflection = Reflection::Lambert;
    const auto at = [&](const Mistakes& mistakes) {
        scene.shading.mistakes = mistakes;
        Renderer renderer(1);
        (void)renderer.render(scene, {32, 24});
        Explanation e;
        for (int i = 0; i < 32 * 24 && !(e.hit && !e.at.lights.empty() && e.at.lights[0].n_dot_l > 0.1f); ++i)
            e = renderer.explain(i % 32, i / 32);
        return light_lines({scene, e, e.at.lights.at(0)});
    };
    scene.lights[0].ambient = glm::vec3(0.3f);
    scene.objects[0].material.ambient = glm::vec3(0.5f);
    Mistakes twice, pi;
    twice.ambient_per_light_added_twice = true;
    pi.missing_pi = true;
    const EquationFactor doubled = at(twice)[0].factors.back();
    CHECK(doubled.quantity == Quantity::Mistake);
    CHECK(doubled.value.x == Approx(2));
    const std::vector<EquationLine> without_pi = at(pi);
    const std::vector<EquationFactor>& diffuse = without_pi[1].factors;
    CHECK(diffuse.back().quantity == Quantity::Mistake);
    CHECK(diffuse.back().value.x == Approx(1 / std::numbers::pi));
    CHECK(diffuse[diffuse.size() - 2].quantity == Quantity::NL);
    CHECK(at({})[0].factors.back().quantity == Quantity::MaterialAmbient);
    scene.shading.reflection = Reflection::OrenNayar;
    const std::vector<EquationLine> rough = at({}), rough_without_pi = at(pi);
    REQUIRE(rough[1].factors.back().quantity == Quantity::Rough);
    const auto& factors = rough_without_pi[1].factors;
    CHECK(factors.back().value.x == Approx(1 / std::numbers::pi));
    CHECK(factors[factors.size() - 2].value.x == Approx(rough[1].factors.back().value.x));
}

TEST_CASE("clamping and byte wrapping by a mistake appear in the text", "[explain]") {
    Scene scene = test::busy_scene();
    for (Light& light : scene.lights) light.intensity = 9;
    Renderer renderer(1);
    const auto brightest = [&](const Mistakes& mistakes) {
        scene.shading.mistakes = mistakes;
        (void)renderer.render(scene, {32, 24});
        Explanation best;
        for (int i = 0; i < 32 * 24; ++i)
            if (Explanation e = renderer.explain(i % 32, i / 32); e.hit && e.sum.x >= best.sum.x)
                best = std::move(e);
        return best;
    };
    Mistakes clamps, wraps;
    clamps.clamp_each_light = true;
    wraps.bytes_wrap = true;
    const Explanation right = brightest({});
    REQUIRE(right.sum.x > 1.2f);
    CHECK(explain_text(right, scene).find("  counts ") == std::string::npos);
    CHECK(explain_text(right, scene).find("clips: ") != std::string::npos);
    const Explanation clamped = brightest(clamps);
    CHECK(explain_text(clamped, scene).find("  counts    the terms together, clamped") != std::string::npos);
    CHECK(explain_latex(clamped, scene).find("the terms together, clamped") != std::string::npos);
    const Explanation wrapped = brightest(wraps);
    const std::string text = explain_text(wrapped, scene);
    CHECK(text.find("clips") == std::string::npos);
    CHECK(text.find(fmt::format("→ byte {}", wrapped.byte[0])) != std::string::npos);
}

TEST_CASE("the explanation's text names the lighting space, the lit point and the encoding", "[explain]") {
    Scene scene = test::busy_scene();
    const auto says = [&](const char* words) {
        Renderer renderer(1);
        (void)renderer.render(scene, {32, 24});
        Explanation e;
        for (int i = 0; i < 32 * 24 && !e.hit; ++i) e = renderer.explain(i % 32, i / 32);
        return explain_text(e, scene).find(words) != std::string::npos;
    };
    CHECK(says("lit here"));
    scene.shading.mistakes.encoded_twice = true;
    CHECK(says("sRGB encoded by mistake"));
    scene.display.transfer = Transfer::Srgb;
    CHECK(says("sRGB encoded twice"));
    scene.shading.mistakes = {};
    CHECK_FALSE(says("twice"));
    scene.shading.mistakes.lit_after_projection = true;
    CHECK_FALSE(says("lit here"));
    scene.shading.mistakes = {};
    scene.shading.mode = ShadingMode::Flat;
    CHECK(says("for the entire polygon"));
    scene.shading.flat_point = FlatPoint::Provoking;
    CHECK(says("for the entire triangle"));
    scene.shading.flat_point = FlatPoint::Centroid;
    scene.shading.rules = Rules::OpenGL2;
    CHECK(says("for the entire triangle"));
    scene.shading.rules = Rules::Lecture;
    scene.shading.reflection = Reflection::None;
    CHECK_FALSE(says("lit here"));
}

TEST_CASE("small numbers keep two significant digits, and zero has no sign", "[explain]") {
    CHECK(fixed_text(-0.004, 2) == "0.00");
    CHECK(fixed_text(-0.006, 2) == "-0.01");
    CHECK(decimal_text(-0.0, 3) == "0.000");
    CHECK(significant_text(-0.0, 3) == "0.000");
    CHECK(significant_text(0.00012, 3) == "0.00012");
    CHECK(significant_text(-0.000999, 3) == "-0.001");
    CHECK(significant_text(0.055, 2) == "0.055");
    CHECK(significant_text(0.5, 2) == "0.50");
    CHECK(significant_text(12.345, 2) == "12.35");
    CHECK(significant_text(3.2e-6, 4) == "3.2e-06");
}

TEST_CASE("a light's factor f has the same digits in every line", "[explain]") {
    Scene scene = test::busy_scene();
    scene.lights.resize(1);
    scene.lights[0] = Light{};
    for (const float intensity : {0.725f, 0.055f, 0.4f, 1.0f}) {
        scene.lights[0].intensity = intensity;
        Renderer renderer(1);
        (void)renderer.render(scene, {64, 48});
        const Explanation e = renderer.explain(32, 24);
        REQUIRE(e.hit);
        const LightOfEquation in{scene, e, e.at.lights[0]};
        const NumberText three = [](double x) { return significant_text(x, 3); };
        for (const EquationLine& line : light_lines(in)) {
            if (line.factors.front().quantity != Quantity::Share) continue;
            const std::string text = written_product(line, 0, three);
            CAPTURE(text);
            CHECK(text.starts_with(fmt::format("f {} ", intensity)));
        }
    }
}
