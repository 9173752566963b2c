// The complete picture: its explanation, its stages, and properties that need no table.
#include "renderer/renderer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/as_fresh.h"
#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize frame_size{96, 72};

constexpr ShadingMode modes[] = {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud,
                                 ShadingMode::Phong};
constexpr Reflection models[] = {Reflection::None,        Reflection::Lambert, Reflection::Phong,
                                 Reflection::BlinnPhong,  Reflection::Retro,   Reflection::OrenNayar,
                                 Reflection::CookTorrance};

double largest_difference(const Picture& a, const Picture& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.linear.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(a.linear[i]) - b.linear[i]));
    return worst;
}

}  // namespace

TEST_CASE("the explanation of every pixel sums to the pixel bit for bit", "[explain][release]") {
    Scene scene = busy_scene();
    Renderer renderer(2);
    for (const Rules rules : {Rules::Lecture, Rules::OpenGL2})
        for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Screen})
            for (const ShadingMode mode : modes)
                for (const Reflection model : models) {
                    scene.shading.mode = mode;
                    scene.shading.reflection = model;
                    scene.shading.interpolation = interpolation;
                    scene.shading.rules = rules;
                    scene.shading.two_sided = model == Reflection::Phong;
                    scene.display.transfer = mode == ShadingMode::Flat ? Transfer::Srgb : Transfer::None;
                    const Picture& picture = renderer.render(scene, frame_size, true);
                    int wrong = 0;
                    for (int y = 0; y < frame_size.height; ++y)
                        for (int x = 0; x < frame_size.width; ++x) {
                            const Explanation e = renderer.explain(x, y);
                            wrong += !same_bits(e.sum, picture.linear_at(x, y));
                            for (std::size_t c = 0; c < 3; ++c)
                                wrong += e.byte[c] != picture.rgba[4 * picture.pixel(x, y) + c];
                        }
                    CAPTURE(static_cast<int>(mode), static_cast<int>(model), static_cast<int>(interpolation));
                    CHECK(wrong == 0);
                }
}

TEST_CASE("the terms of an explanation add up to its sum", "[explain]") {
    Renderer renderer(1);
    renderer.render(busy_scene(), frame_size, true);
    for (int y = 0; y < frame_size.height; y += 3)
        for (int x = 0; x < frame_size.width; x += 3) {
            const Explanation e = renderer.explain(x, y);
            if (!e.hit) continue;
            glm::vec3 sum = e.at.emission + e.at.global_ambient;
            for (const ExplainedLight& l : e.at.lights) sum += l.ambient + l.diffuse + l.specular;
            for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(e.sum[c]).epsilon(1e-5).margin(1e-6));
        }
}

TEST_CASE("only stages with changed inputs run again", "[stages]") {
    Scene scene = busy_scene();
    Renderer renderer(2);
    const auto redone = [&] {
        renderer.render(scene, frame_size);
        const auto& r = renderer.stats().redone;
        std::string text;
        for (const bool b : r) text += b ? '1' : '0';
        return text;
    };
    CHECK(redone() == "11101");
    CHECK(redone() == "00000");
    scene.lights[1].position.x += 0.1f;
    CHECK(redone() == "00001");
    scene.objects[0].material.shininess = 5;
    CHECK(redone() == "00001");
    scene.display.exposure = 2;
    CHECK(redone() == "00001");
    scene.shading.reflection = Reflection::BlinnPhong;
    CHECK(redone() == "00001");
    scene.shading.mode = ShadingMode::Gouraud;
    CHECK(redone() == "00101");
    scene.objects[0].normals.source = NormalSource::Facet;
    CHECK(redone() == "00101");
    scene.shading.cull = Cull::Back;
    CHECK(redone() == "01101");
    scene.camera.eye.x += 0.1f;
    CHECK(redone() == "11101");
    scene.objects[1].transform.translate.y += 0.1f;
    CHECK(redone() == "11101");
}

TEST_CASE("the picture has the same bytes for every number of threads", "[threads]") {
    for (const ShadingMode mode : modes) {
        Scene scene = busy_scene();
        scene.shading.mode = mode;
        Renderer one(1), two(2), seven(7);
        const Picture& a = one.render(scene, {211, 133}, true);
        CHECK(a.rgba == two.render(scene, {211, 133}, true).rgba);
        CHECK(a.linear == seven.render(scene, {211, 133}, true).linear);
    }
}

TEST_CASE("the picture is linear in each light", "[property]") {
    // picture(A and B) = picture(A) + picture(B) - picture(neither), and doubling a light's intensity doubles
    // its contribution.
    for (const Reflection model : {Reflection::Lambert, Reflection::Phong, Reflection::CookTorrance}) {
        Scene scene = busy_scene();
        scene.shading.reflection = model;
        scene.display.background = {0, 0, 0};
        Renderer renderer(2);
        const auto draw = [&](std::uint32_t which, float intensity) {
            Scene s = scene;
            for (std::uint32_t i = 0; i < 4; ++i) {
                s.lights[i].enabled = which >> i & 1u;
                s.lights[i].intensity *= intensity;
            }
            return renderer.render(s, frame_size, true);
        };
        const Picture none = draw(0, 1), all = draw(15, 1);
        Picture sum = none;
        for (std::uint32_t i = 0; i < 4; ++i) {
            const Picture one = draw(1u << i, 1), twice = draw(1u << i, 2);
            for (std::size_t k = 0; k < sum.linear.size(); ++k) {
                const float share = one.linear[k] - none.linear[k];
                sum.linear[k] += share;
                CHECK(twice.linear[k] - none.linear[k] == Approx(2 * share).margin(1e-5));
            }
        }
        CHECK(largest_difference(sum, all) < 1e-5);
    }
}

TEST_CASE("no colour is negative or not a number", "[property]") {
    std::mt19937 random(41);
    Renderer renderer(2);
    for (int round = 0; round < 40; ++round) {
        Scene scene = busy_scene();
        for (Light& l : scene.lights) {
            const float w = l.position.w;
            l.position = glm::vec4(uniform_vec3(random, -3, 3), w);
            l.falloff = {uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)};
        }
        for (Object& o : scene.objects) {
            o.material.shininess = uniform(random, 0, 10000);
            o.material.roughness = uniform(random, 0, 1);
        }
        scene.shading.mode = modes[random() % 4];
        scene.shading.reflection = models[random() % 7];
        const Picture& p = renderer.render(scene, frame_size, true);
        CHECK(std::all_of(p.linear.begin(), p.linear.end(),
                          [](float c) { return c >= 0 && std::isfinite(c); }));
    }
}

TEST_CASE("rotating the world and its camera together changes only rounding", "[property]") {
    const Scene scene = busy_scene();
    Scene turned = scene;
    // A quarter turn about y, exact in floating point: (x, y, z) -> (z, y, -x).
    const auto turn = [](auto v) {
        auto r = v;
        r.x = v.z;
        r.z = -v.x;
        return r;
    };
    turned.camera.eye = turn(scene.camera.eye);
    turned.camera.target = turn(scene.camera.target);
    for (Light& l : turned.lights) {
        if (l.space == LightSpace::Camera) continue;
        l.position = turn(l.position);
        l.spot.direction = turn(l.spot.direction);
        l.area.edge_u = turn(l.area.edge_u);
        l.area.edge_v = turn(l.area.edge_v);
    }
    // The objects rotate about the world's axis: bake the rotation into each mesh.
    for (Object& o : turned.objects) {
        Mesh mesh = *o.mesh;
        const glm::dmat4 m = world_from_object(o.transform);
        const glm::dmat3 n = glm::transpose(glm::inverse(glm::dmat3(m)));
        for (glm::vec3& p : mesh.positions) p = turn(glm::vec3(m * glm::dvec4(glm::dvec3(p), 1)));
        for (glm::vec3& v : mesh.normals) v = turn(glm::normalize(glm::vec3(n * glm::dvec3(v))));
        if (glm::determinant(glm::dmat3(m)) < 0)  // keeps facets facing outward
            for (std::size_t f = 0; f < mesh.face_count(); ++f) {
                const auto begin = static_cast<std::ptrdiff_t>(mesh.first_corner[f]);
                const auto end = static_cast<std::ptrdiff_t>(mesh.first_corner[f + 1]);
                std::reverse(mesh.corner_position.begin() + begin, mesh.corner_position.begin() + end);
                if (!mesh.corner_normal.empty())
                    std::reverse(mesh.corner_normal.begin() + begin, mesh.corner_normal.begin() + end);
            }
        mesh.triangles.clear();
        finish_mesh(mesh);
        o.mesh = std::make_shared<const Mesh>(std::move(mesh));
        o.transform = {};
    }
    Renderer a(2), b(2);
    const Picture before = a.render(scene, frame_size, true), after = b.render(turned, frame_size, true);
    int different = 0;
    for (std::size_t i = 0; i < before.linear.size(); i += 3) {
        double d = 0;
        for (std::size_t c = 0; c < 3; ++c)
            d = std::max(d, std::abs(static_cast<double>(before.linear[i + c]) - after.linear[i + c]));
        different += d > 2e-4;
    }
    CHECK(different < frame_size.width * frame_size.height / 200);  // a sample on an edge may switch sides
}

TEST_CASE("the order of faces changes nothing", "[property]") {
    Scene scene = busy_scene();
    Scene shuffled = scene;
    std::mt19937 random(29);
    for (Object& o : shuffled.objects) {
        const Mesh& from = *o.mesh;
        Mesh to = from;
        std::vector<std::size_t> order(from.face_count());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
        to.corner_position.clear();
        to.corner_normal.clear();
        to.first_corner = {0};
        for (const std::size_t f : order) {
            for (std::uint32_t c = from.first_corner[f]; c < from.first_corner[f + 1]; ++c) {
                to.corner_position.push_back(from.corner_position[c]);
                if (!from.corner_normal.empty()) to.corner_normal.push_back(from.corner_normal[c]);
            }
            to.first_corner.push_back(static_cast<std::uint32_t>(to.corner_position.size()));
        }
        to.triangles.clear();
        finish_mesh(to);
        o.mesh = std::make_shared<const Mesh>(std::move(to));
    }
    for (const ShadingMode mode : modes) {
        scene.shading.mode = shuffled.shading.mode = mode;
        Renderer a(2), b(2);
        CHECK(a.render(scene, frame_size, true).linear == b.render(shuffled, frame_size, true).linear);
    }
}

TEST_CASE("ambient light alone gives a flat silhouette", "[lecture]") {
    Scene scene = busy_scene();
    scene.lights.clear();
    scene.objects.pop_back();
    scene.global_ambient = {0.5f, 0.25f, 1};
    Renderer renderer(1);
    const Picture& p = renderer.render(scene, frame_size, true);
    const glm::vec3 expected = scene.objects[0].material.ambient * scene.global_ambient;
    int seen = 0;
    for (int y = 0; y < frame_size.height; ++y)
        for (int x = 0; x < frame_size.width; ++x)
            if (renderer.object_at(x, y) == 0) {
                ++seen;
                CHECK(p.linear_at(x, y) == expected);
            }
    CHECK(seen > 300);
}

TEST_CASE("the equation is evaluated once per pixel, corner or face for each light", "[lecture][cost]") {
    Scene scene;
    scene.objects.push_back(object_of(primitive(Primitive::Plane, 4)));
    scene.objects[0].transform.rotate_deg.x = 90;  // faces the camera
    scene.lights = {Light{}, Light{}, Light{}};
    scene.lights[2].enabled = false;
    Renderer renderer(1);
    const auto count = [&](ShadingMode mode) {
        scene.shading.mode = mode;
        renderer.render(scene, {200, 200});
        return renderer.stats().evaluations;
    };
    CHECK(count(ShadingMode::Flat) == 16 * 2);
    CHECK(count(ShadingMode::Gouraud) == 25 * 2);
    CHECK(count(ShadingMode::Phong) == renderer.stats().shaded_pixels * 2);
    CHECK(count(ShadingMode::Facet) == renderer.stats().shaded_pixels * 2);
}

TEST_CASE("vertex colours are interpolated unlit, and averaged over a polygon in flat mode", "[none]") {
    auto mesh = std::make_shared<Mesh>(
        *polygon_mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}));
    mesh->colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    Scene scene;
    scene.objects.push_back(object_of(mesh));
    scene.shading.reflection = Reflection::None;
    scene.camera.projection = Orthographic{2, 0.1f, 100};
    Renderer renderer(1);
    const glm::vec3 phong = renderer.render(scene, {101, 101}, true).linear_at(50, 50);
    CHECK(phong.x == Approx(0.5f).margin(1e-5));  // the midpoint of the diagonal from corner 0 to corner 2
    CHECK(phong.y == Approx(0).margin(1e-5));
    scene.shading.mode = ShadingMode::Flat;
    const glm::vec3 flat = renderer.render(scene, {101, 101}, true).linear_at(10, 50);
    CHECK(flat.x == Approx(0.5f));
    CHECK(flat.y == Approx(0.5f));
    scene.shading.flat_point = FlatPoint::Provoking;  // triangles (0, 1, 2) and (0, 2, 3)
    CHECK(renderer.render(scene, {101, 101}, true).linear_at(80, 60) == glm::vec3(0, 0, 1));
    CHECK(renderer.render(scene, {101, 101}, true).linear_at(20, 40) == glm::vec3(1, 1, 1));
}

// The effects of an object's switches: `visible`, `normals.flip` and `material.reflection`.
namespace {

constexpr PictureSize small{96, 72};

void for_each_mode(Scene scene, auto&& check) {
    for (const ShadingMode mode :
         {ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        CAPTURE(static_cast<int>(mode));
        check(scene);
    }
}

std::vector<std::uint8_t> drawn_bytes(const Scene& scene) { return Renderer(1).render(scene, small).rgba; }

}  // namespace

TEST_CASE("a hidden object leaves the picture as if it were not in the scene", "[renderer]") {
    Scene scene = busy_scene();
    REQUIRE(scene.objects.size() >= 2);
    scene.npr.silhouettes = scene.npr.creases = true;
    for_each_mode(scene, [](const Scene& shown) {
        for (std::size_t o = 0; o < shown.objects.size(); ++o) {
            CAPTURE(o);
            Scene hidden = shown, without = shown;
            hidden.objects[o].visible = false;
            without.objects.erase(without.objects.begin() + static_cast<std::ptrdiff_t>(o));
            CHECK(drawn_bytes(hidden) == drawn_bytes(without));
            CHECK(drawn_bytes(hidden) != drawn_bytes(shown));
        }
    });
}

TEST_CASE("flipping all objects acts like the mistake that flips all normals, and undoes it", "[renderer]") {
    for_each_mode(busy_scene(), [](const Scene& right) {
        Scene flipped = right, mistaken = right;
        for (Object& object : flipped.objects) object.normals.flip = true;
        mistaken.shading.mistakes.normals_flipped = true;
        CHECK(drawn_bytes(flipped) == drawn_bytes(mistaken));
        CHECK(drawn_bytes(flipped) != drawn_bytes(right));
        flipped.shading.mistakes.normals_flipped = true;
        CHECK(drawn_bytes(flipped) == drawn_bytes(right));
    });
}

TEST_CASE("flipping one object's normals does not change the others", "[renderer]") {
    for_each_mode(busy_scene(), [](const Scene& right) {
        Scene flipped = right;
        flipped.objects[0].normals.flip = true;
        Renderer renderer(1);
        const Picture before = renderer.render(right, small, true);
        const Picture& after = renderer.render(flipped, small, true);
        CHECK(after.rgba == drawn_bytes(flipped));
        int wrong = 0, changed = 0;
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                const Explanation e = renderer.explain(x, y);
                wrong += !same_bits(e.sum, after.linear_at(x, y));
                const bool same = same_bits(before.linear_at(x, y), after.linear_at(x, y));
                if (e.hit && e.object_index == 0) changed += !same;
                if (!e.hit || e.object_index != 0) wrong += !same;
            }
        CHECK(wrong == 0);
        CHECK(changed > 100);
    });
}

TEST_CASE("each object looks as if its own reflection model were the scene's", "[renderer]") {
    for_each_mode(busy_scene(), [](Scene scene) {
        const std::array own{OwnReflection::Scene, OwnReflection::OrenNayar, OwnReflection::CookTorrance};
        for (std::size_t o = 0; o < scene.objects.size(); ++o)
            scene.objects[o].material.reflection = own[o % own.size()];
        Renderer renderer(1), alone(1);
        const Picture mixed = renderer.render(scene, small, true);
        for (std::size_t o = 0; o < scene.objects.size(); ++o) {
            CAPTURE(o);
            Scene other = scene;
            for (Object& object : other.objects) object.material.reflection = OwnReflection::Scene;
            if (o % own.size() > 0) other.shading.reflection = static_cast<Reflection>(own[o % own.size()]);
            const Picture& same_model = alone.render(other, small, true);
            int seen = 0, wrong = 0;
            for (int y = 0; y < small.height; ++y)
                for (int x = 0; x < small.width; ++x) {
                    const Explanation e = renderer.explain(x, y);
                    if (!e.hit || e.object_index != static_cast<int>(o)) continue;
                    ++seen;
                    wrong +=
                        e.reflection != other.shading.reflection || !same_bits(e.sum, mixed.linear_at(x, y));
                    wrong += !same_bits(same_model.linear_at(x, y), mixed.linear_at(x, y));
                }
            CHECK(seen > 0);
            CHECK(wrong == 0);
        }
    });
}

TEST_CASE("switching to an object's own reflection model gives the same as a fresh picture", "[renderer]") {
    Scene scene = busy_scene();
    Renderer renderer(1);
    (void)renderer.render(scene, small);
    scene.objects[0].material.reflection = OwnReflection::CookTorrance;
    CHECK(renderer.render(scene, small).rgba == drawn_bytes(scene));
    scene.shading.reflection = Reflection::None;  // no material is lit
    const std::vector<std::uint8_t> unlit = drawn_bytes(scene);
    scene.objects[0].material.reflection = OwnReflection::Scene;
    CHECK(drawn_bytes(scene) == unlit);
}
