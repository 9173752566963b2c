// Each mistake is visible where it applies, and only there.
#include "models/scene/mistakes.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <set>
#include <sstream>

#include "models/scene_file/scene_file.h"
#include "renderer/lighting/illuminate.h"
#include "renderer/renderer.h"
#include "renderer/shade/lighting.h"
#include "tests/support/catch.h"
#include "tests/support/mistake_scenes.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize mistaken_size{96, 72};

/// The correct picture and the one with the mistake, drawn by one renderer to test reused results.
struct Both {
    Picture right, wrong;
    Both(Scene scene, bool Mistakes::*flag) {  // NOLINT(performance-unnecessary-value-param): it is changed
        Renderer renderer(1);
        right = renderer.render(scene, mistaken_size, true);
        scene.shading.mistakes.*flag = true;
        wrong = renderer.render(scene, mistaken_size, true);
        scene.shading.mistakes.*flag = false;
        CHECK((renderer.render(scene, mistaken_size, true).rgba == right.rgba));
    }
    [[nodiscard]] bool show() const {
        for (std::size_t i = 0; i < right.linear.size(); ++i)
            if (!(std::abs(wrong.linear[i] - right.linear[i]) <= 1e-5f)) return true;
        for (std::size_t i = 0; i < right.rgba.size(); ++i)
            if (std::abs(wrong.rgba[i] - right.rgba[i]) > 1) return true;
        return false;
    }
    [[nodiscard]] bool are_the_same() const {
        return right.rgba == wrong.rgba && std::memcmp(right.linear.data(), wrong.linear.data(),
                                                       sizeof(float) * right.linear.size()) == 0;
    }
};

bool Mistakes::*flag_of(std::string_view name) {
    for (const MistakeName& m : mistake_names())
        if (m.name == name) return m.flag;
    FAIL("no mistake is called " << name);
    return nullptr;
}

/// Whether sum and bytes of the explanation equal the pixel's.
bool explained(const Renderer& renderer, const Picture& picture, int x, int y) {
    const Explanation e = renderer.explain(x, y);
    const std::uint8_t* rgb = &picture.rgba[4 * picture.pixel(x, y)];
    return same_bits(e.sum, picture.linear_at(x, y)) && e.byte[0] == rgb[0] && e.byte[1] == rgb[1] &&
           e.byte[2] == rgb[2];
}

}  // namespace

TEST_CASE("each mistake's look-alikes are other mistakes, and every group has a mistake",
          "[mistakes][scene]") {
    std::set<std::string_view> names;
    std::set<SeenAs> groups;
    for (const MistakeName& m : mistake_names()) {
        names.insert(m.name);
        groups.insert(m.seen_as);
    }
    CHECK(groups.size() == std::size(all_seen_as));
    for (const MistakeName& m : mistake_names()) {
        CAPTURE(std::string(m.name));
        CHECK_FALSE(m.what.empty());
        CHECK_FALSE(m.looks.empty());
        std::istringstream words{std::string(m.look_alikes)};
        for (std::string word; words >> word;) {
            CAPTURE(word);
            CHECK(names.count(word) == 1);
            CHECK(word != m.name);
        }
    }
}

TEST_CASE("every mistake is visible where it should be, and only there", "[mistakes]") {
    REQUIRE(mistake_scenes().size() == mistake_names().size());
    for (std::size_t i = 0; i < mistake_scenes().size(); ++i) {
        const MistakeName& mistake = mistake_names()[i];
        CAPTURE(std::string(mistake.name));
        REQUIRE(mistake.name == mistake_scenes()[i].name);
        Scene scene = telling_scene();
        mistake_scenes()[i].where_it_shows(scene);
        CHECK(Both(scene, mistake.flag).show());
        scene = telling_scene();
        mistake_scenes()[i].where_it_is_inert(scene);
        CHECK(Both(scene, mistake.flag).are_the_same());
    }
}

TEST_CASE("the explanation equals the pixel under every mistake", "[mistakes][explain]") {
    const int apart = sanitized ? 7 : 2;
    Renderer renderer(2);
    for (const MistakeScenes& row : mistake_scenes())
        for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong})
            for (const Reflection model :
                 {Reflection::Phong, Reflection::BlinnPhong, Reflection::CookTorrance}) {
                Scene scene = telling_scene();
                row.where_it_shows(scene);
                scene.shading.mode = mode;
                scene.shading.reflection = model;
                // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): each row has a flag
                scene.shading.mistakes.*flag_of(row.name) = true;
                scene.shading.power_table = mode == ShadingMode::Phong ? 0 : 40;
                const Picture& picture = renderer.render(scene, mistaken_size, true);
                int wrong = 0;
                for (int y = 0; y < mistaken_size.height; y += apart)
                    for (int x = 0; x < mistaken_size.width; x += apart)
                        wrong += explained(renderer, picture, x, y) ? 0 : 1;
                CAPTURE(row.name, static_cast<int>(mode), static_cast<int>(model));
                CHECK(wrong == 0);
            }
}

TEST_CASE("an unnormalized glNormal3f(1, 1, 1) makes light sqrt(3) times too bright", "[mistakes][lecture]") {
    auto mesh = std::make_shared<Mesh>(
        *polygon_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}));
    mesh->given_normals = GivenNormals::File;
    mesh->normals = {{1, 1, 1}};
    mesh->corner_normal = {0, 0, 0, 0};
    Scene scene;
    scene.objects = {object_of(mesh)};
    scene.lights = {Light{}};
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {0, 0, 1, 0};
    scene.shading.terms.ambient = scene.shading.terms.specular = false;
    Renderer renderer(1);
    const float right = renderer.render(scene, {9, 9}, true).linear_at(4, 4).x;
    CHECK(right == Approx(0.8 / std::sqrt(3.0)));
    scene.shading.mistakes.unnormalized_normals = true;
    auto by_position = std::make_shared<Mesh>(*mesh);  // as in a PLY file
    by_position->normals.assign(4, {1, 1, 1});
    by_position->corner_normal = std::vector<std::uint32_t>();
    for (const ShadingMode mode : {ShadingMode::Phong, ShadingMode::Gouraud})
        for (const auto& given : {mesh, by_position}) {
            scene.shading.mode = mode;
            scene.objects[0].mesh = given;
            CHECK(renderer.render(scene, {9, 9}, true).linear_at(4, 4).x == Approx(std::sqrt(3.0) * right));
        }
}

TEST_CASE("without any normals a ball is shaded like a disc", "[mistakes][lecture]") {
    Scene scene;
    scene.objects = {object_of(primitive(Primitive::Sphere, 32))};
    scene.lights = {Light{}};
    scene.lights[0].kind = LightKind::Directional;
    scene.lights[0].position = {0.3f, 0.4f, 1, 0};
    scene.shading.reflection = Reflection::Lambert;
    scene.shading.mistakes.no_normals_given = true;
    Renderer renderer(1);
    const Picture& p = renderer.render(scene, mistaken_size, true);
    const glm::vec3 middle = p.linear_at(48, 36);
    for (int y = 0; y < mistaken_size.height; ++y)
        for (int x = 0; x < mistaken_size.width; ++x)
            if (renderer.object_at(x, y) == 0) CHECK(p.linear_at(x, y) == middle);
}

TEST_CASE("without the clamp an even shininess makes a ghost: (-0.9)^20 is 0.12", "[mistakes][lecture]") {
    CHECK(unclamped_power(-0.9f, 20.0f) == Approx(0.1215767).epsilon(1e-5));
    CHECK(unclamped_power(-0.9f, 21.0f) == Approx(-0.1094190).epsilon(1e-5));
    CHECK(unclamped_power(0.9f, 21.0f) == Approx(0.1094190).epsilon(1e-5));
}

TEST_CASE("an unnormalised l with exponent 0 gives 1, even opposite the mirror direction", "[mistakes]") {
    Mistakes wrong;
    wrong.unnormalized_light = true;
    LightAt<float> light;
    light.xyz = {0, 0, 5};
    light.w = 1;
    light.specular = {1, 1, 1};
    MaterialAt<float> m;
    m.k_s = {1, 1, 1};
    m.shininess = 0;
    m.min_cosine_squared = min_cosine_squared(0);
    const PointAt<float> at{{0, 0, 0}, {0, 0, 1}, {0, 0, -1}};  // r.v = -5
    CHECK(illuminate({Reflection::Phong, {}, &wrong}, light, m, at).specular.x == 1);
}

TEST_CASE("the highlight of an unnormalised l is not limited to 1: (v.r)^n, 4^3 = 64", "[mistakes]") {
    Mistakes wrong;
    wrong.unnormalized_light = true;
    LightAt<float> light;
    light.xyz = {0, 0, 4};  // for (0, 0, 0) with n = v = z: n.l = r.v = 4, h = (l + v)/5 = z, and l.v stays 1
    light.w = 1;
    light.specular = light.diffuse = {1, 1, 0};
    MaterialAt<float> m;
    m.k_s = m.k_d = {0.5f, 0, 1};
    const auto specular = [&](Reflection model, float shininess) {
        m.shininess = shininess;
        m.min_cosine_squared = min_cosine_squared(shininess);
        const PointAt<float> at{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
        return illuminate({model, {}, &wrong}, light, m, at).specular;
    };
    CHECK(specular(Reflection::Phong, 3).x == Approx(0.5 * 64));
    CHECK(specular(Reflection::Phong, 1.5f).x == Approx(0.5 * 8));
    CHECK(specular(Reflection::Retro, 3).x == Approx(0.5));
    CHECK(specular(Reflection::BlinnPhong, 3).x == Approx(0.5));
    for (const float shininess : {1000.0f, 999.5f, 10'000.0f}) {  // 4^1000 exceeds a float
        const Vec3<float> huge = specular(Reflection::Phong, shininess);
        CHECK(huge.x == 0.5f * max_factor);
        CHECK(huge.y == 0);  // a colour of 0 reflects nothing
        CHECK(huge.z == 0);
    }
}

TEST_CASE("an unnormalised l leaves cone, falloff and an area light's cosine unchanged", "[mistakes]") {
    Mistakes wrong;
    wrong.unnormalized_light = true;
    LightAt<float> lamp;
    lamp.xyz = {0, 0, 4};
    lamp.w = 1;
    lamp.diffuse = {1, 1, 1};
    lamp.axis = {0, 0.8f, -0.6f};  // 53 degrees from the ray to the point, whose cosine is 0.6
    lamp.cos_cutoff = 0.5f;        // 60 degrees
    lamp.exponent = 2.0f;
    lamp.has_cone = lamp.has_falloff = true;
    lamp.quadratic = 1;  // 1 / (1 + 16)
    MaterialAt<float> m;
    m.k_d = {1, 1, 1};
    const PointAt<float> at{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    const LightTerms<float> t = illuminate({Reflection::Lambert, {}, &wrong}, lamp, m, at);
    CHECK(t.spot == Approx(0.36));
    CHECK(t.falloff == Approx(1.0 / 17));
    CHECK(t.diffuse.x == Approx(4 * 0.36 / 17));  // n.l = 4
    lamp.cos_cutoff = 0.7f;                       // 46 degrees
    CHECK(illuminate({Reflection::Lambert, {}, &wrong}, lamp, m, at).spot == 0);

    LightAt<float> window = lamp;
    window.has_cone = window.has_falloff = false;
    window.is_patch = true;
    window.patch = 2;  // 2 |cos theta'| / r^2 = 2 * 0.6 / 16
    CHECK(illuminate({Reflection::Lambert, {}, &wrong}, window, m, at).falloff == Approx(2 * 0.6 / 16));
}

TEST_CASE("a scene file names its mistakes, and an unknown one is an error", "[mistakes][scene]") {
    for (const MistakeName& mistake : mistake_names()) {
        const std::string text =
            "{\"glint\": 1, \"shading\": {\"mistakes\": {\"" + std::string(mistake.name) + "\": true}}}";
        const Result<Scene> read = parse_scene(text, "s.json");
        REQUIRE(std::holds_alternative<Scene>(read));
        const Scene& scene = std::get<Scene>(read);
        CHECK(scene.shading.mistakes.*mistake.flag);
        CHECK(std::get<Scene>(parse_scene(scene_text(scene), "s.json")) == scene);
    }
    const Result<Scene> wrong =
        parse_scene(R"({"glint": 1, "shading": {"mistakes": {"normals_fliped": true}}})", "s.json");
    REQUIRE(problem_of(wrong));
    CHECK(problem_of(wrong)->pointer == "/shading/mistakes/normals_fliped");
    CHECK(problem_of(wrong)->text().find("normals_flipped") != std::string::npos);
}

TEST_CASE("an explanation equals its pixel if a mistake is limited to part of the scene",
          "[mistakes][explain]") {
    Scene scene = busy_scene();
    REQUIRE(scene.objects.size() >= 2);
    REQUIRE(scene.lights.size() >= 2);
    scene.shading.mode = GENERATE(ShadingMode::Phong, ShadingMode::Gouraud, ShadingMode::Flat);
    scene.shading.mistakes.*
        GENERATE(&Mistakes::normals_flipped, &Mistakes::half_lambert, &Mistakes::lit_in_srgb) = true;
    scene.shading.mistakes.only = GENERATE(MistakeScope{.object = 1}, MistakeScope{.light = 1},
                                           MistakeScope{.lights = ScopeLights::Point},
                                           MistakeScope{.object = 0, .term = ScopeTerm::Diffuse},
                                           MistakeScope{.light = 0, .term = ScopeTerm::Specular});
    Renderer renderer(1);
    const Picture picture = renderer.render(scene, mistaken_size, true);
    int wrong = 0, hit = 0, told = 0;
    for (int y = 0; y < mistaken_size.height; y += 3)
        for (int x = 0; x < mistaken_size.width; x += 3) {
            wrong += !explained(renderer, picture, x, y);
            const Explanation e = renderer.explain(x, y);
            if (!e.hit || e.lit_per_corner) continue;
            ++hit;
            glm::vec3 sum = e.at.base;
            for (const ExplainedLight& light : e.at.lights)
                sum += light.ambient + light.diffuse + light.specular;
            told += glm::distance(sum, e.sum) <= 1e-4f * (1 + glm::length(e.sum));
        }
    CHECK(wrong == 0);
    CHECK(told == hit);  // the printed terms add up to the sum
}
