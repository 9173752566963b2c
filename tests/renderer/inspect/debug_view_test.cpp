// Debug views: each displayed number equals the one in its pixel's explanation.
#include "renderer/debug_views/debug_view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize size{90, 60};

/// Calls check(x, y, explanation) for every pixel with a surface.
template <class Check> void for_surface(const Renderer& renderer, const Check& check) {
    int hits = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Explanation e = renderer.explain(x, y);
            if (!e.hit) continue;
            ++hits;
            check(x, y, e);
        }
    REQUIRE(hits > 500);
}

}  // namespace

TEST_CASE("debug view: the displayed normals are those used for lighting", "[debug_view]") {
    Renderer renderer(1);
    for (const bool facet : {false, true}) {
        Scene scene = busy_scene();
        scene.shading.mode = facet ? ShadingMode::Facet : ShadingMode::Phong;
        renderer.render(scene, size);
        Renderer measure(1);
        const Picture& normals = measure.render(normal_scene(scene, facet), size, true);
        int wrong = 0;
        for_surface(renderer, [&](int x, int y, const Explanation& e) {
            wrong += normals.linear_at(x, y) != e.at.normal.camera;
        });
        CHECK(wrong == 0);
    }
}

TEST_CASE("debug view: n.l of each kind of light equals the explanation's, even below 0", "[debug_view]") {
    Scene scene = busy_scene();
    Renderer renderer(1);
    renderer.render(scene, size);
    DebugViewPainter painter(1);
    for (int light = 0; light < 3; ++light) {  // an area light has several vectors; its centre is used
        (void)painter.paint({DebugView::NDotL, light}, scene, renderer, size);
        int wrong = 0, behind = 0;
        for_surface(renderer, [&](int x, int y, const Explanation& e) {
            const float n_dot_l = e.at.lights[static_cast<std::size_t>(light)].n_dot_l;
            wrong += painter.value_at(x, y) != n_dot_l;
            behind += n_dot_l < 0;
        });
        CHECK(wrong == 0);
        CHECK(behind > 0);
    }
    CHECK(std::isnan(painter.value_at(0, 0)));
    CHECK(painter.value_text(0, 0) == "background");
}

TEST_CASE("debug view: depth and face match the pixel", "[debug_view]") {
    const Scene scene = busy_scene();
    Renderer renderer(1);
    renderer.render(scene, size);
    DebugViewPainter painter(1);
    (void)painter.paint({DebugView::Depth, 0}, scene, renderer, size);
    double low = 1e9, high = 0;
    for_surface(renderer, [&](int x, int y, const Explanation& e) {
        CHECK(painter.value_at(x, y) == -e.at.point.camera.z);
        low = std::min(low, double(painter.value_at(x, y)));
        high = std::max(high, double(painter.value_at(x, y)));
    });
    CHECK(painter.scale().low == low);
    CHECK(painter.scale().high == high);
    const Picture& faces = painter.paint({DebugView::Face, 0}, scene, renderer, size);
    for_surface(renderer, [&](int x, int y, const Explanation& e) {
        CHECK(painter.value_text(x, y) == e.object + ", face " + std::to_string(e.face));
    });
    CHECK(faces.rgba.size() == std::size_t{4} * size.width * size.height);
}

TEST_CASE("debug view: the angle from facet to interpolated normal is as explained", "[debug_view]") {
    Scene scene = busy_scene();
    Renderer smooth(1), facet(1);
    smooth.render(scene, size);
    Scene faceted = scene;
    faceted.shading.mode = ShadingMode::Facet;
    facet.render(faceted, size);
    DebugViewPainter painter(1);
    (void)painter.paint({DebugView::FacetAngle, 0}, scene, smooth, size);
    float most = 0;
    for_surface(smooth, [&](int x, int y, const Explanation& e) {
        const glm::dvec3 a = e.at.normal.camera, b = facet.explain(x, y).at.normal.camera;
        const double angle = std::acos(std::min(glm::dot(a, b), 1.0)) * 180 / std::numbers::pi;
        CHECK(painter.value_at(x, y) == Approx(angle).margin(0.03));
        most = std::max(most, painter.value_at(x, y));
    });
    CHECK(most > 5);
}

TEST_CASE("debug view: the silhouette marks the same pixels in every mode", "[debug_view]") {
    Scene scene = busy_scene();
    scene.objects.resize(1);
    scene.npr = {};
    std::vector<int> first;
    for (const ShadingMode mode : {ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong}) {
        scene.shading.mode = mode;
        Renderer renderer(1);
        const Picture plain = renderer.render(scene, size, true);
        DebugViewPainter painter(1);
        const Picture& marked = painter.paint({DebugView::Silhouette, 0}, scene, renderer, size);
        const auto near_outline = [&](int px, int py) {
            bool surface = false, background = false;
            for (int y = std::max(py - 2, 0); y <= std::min(py + 2, size.height - 1); ++y)
                for (int x = std::max(px - 2, 0); x <= std::min(px + 2, size.width - 1); ++x)
                    (renderer.object_at(x, y) < 0 ? background : surface) = true;
            return surface && background;
        };
        std::vector<int> changed;
        int astray = 0;
        for (int i = 0; i < size.width * size.height; ++i) {
            const int x = i % size.width, y = i / size.width;
            if (marked.linear_at(x, y) == plain.linear_at(x, y)) continue;
            changed.push_back(i);
            // The stroke is two pixels wide and includes silhouettes in front of the object itself.
            astray += !near_outline(x, y);
        }
        CHECK(changed.size() > 100);
        CHECK(static_cast<std::size_t>(astray) < changed.size() / 10);
        if (first.empty()) first = changed;
        CHECK(changed == first);
    }
}

TEST_CASE("debug view: the separate terms add up to the picture", "[debug_view]") {
    const Scene scene = busy_scene();
    Renderer renderer(1);
    const Picture picture = renderer.render(scene, size, true);
    DebugViewPainter painter(1);
    std::vector<glm::vec3> sum(picture.linear.size() / 3, glm::vec3(0));
    for (const DebugView term :
         {DebugView::Emission, DebugView::Ambient, DebugView::Diffuse, DebugView::Specular}) {
        const Picture& alone = painter.paint({term, 0}, scene, renderer, size);
        for_surface(renderer, [&](int x, int y, const Explanation&) {
            sum[picture.pixel(x, y)] += alone.linear_at(x, y);
        });
    }
    for_surface(renderer, [&](int x, int y, const Explanation&) {
        CHECK(glm::length(sum[picture.pixel(x, y)] - picture.linear_at(x, y)) < 1e-5f);
    });
}

TEST_CASE("debug view: exactly the over-range pixels are striped and counted", "[debug_view]") {
    Scene scene = busy_scene();
    scene.lights[0].intensity = 4;
    Renderer renderer(1);
    const Picture picture = renderer.render(scene, size, true);
    Picture striped = picture;
    const std::uint64_t count = stripe_over_range(striped, 1);
    std::uint64_t over = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const glm::vec3 c = picture.linear_at(x, y);
            const bool clips = c.x > 1 || c.y > 1 || c.z > 1;
            over += clips;
            const std::size_t at = 4 * picture.pixel(x, y);
            if (!clips) CHECK(std::equal(&picture.rgba[at], &picture.rgba[at] + 4, &striped.rgba[at]));
        }
    CHECK(count == over);
    CHECK(over > 10);
    CHECK(striped.rgba != picture.rgba);
}

TEST_CASE("debug view: a scale's colours rise in lightness, the hue changes at n.l = 0", "[debug_view]") {
    const DebugViewScale scale{true, 0, 10, ""};
    const auto light = [&](double v) {
        const auto c = debug_view_color(DebugView::FacetAngle, scale, v);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    for (int i = 1; i <= 20; ++i) CHECK(light(i / 2.0) > light(i / 2.0 - 0.5));
    CHECK(debug_view_color(DebugView::Depth, scale, 0) == debug_view_color(DebugView::FacetAngle, scale, 10));
    const auto turned = debug_view_color(DebugView::NDotL, {true, -1, 1, ""}, -0.01);
    const auto facing = debug_view_color(DebugView::NDotL, {true, -1, 1, ""}, 0.01);
    CHECK(turned[2] > turned[0]);
    CHECK(facing[0] > facing[2]);
    CHECK(normal_color({0, 0, 1}) == std::array<std::uint8_t, 3>{128, 128, 255});
}

TEST_CASE("debug view: front and back follow the winding on the screen, even if mirrored", "[debug_view]") {
    // The same triangle four times: counter-clockwise, clockwise, and both mirrored by a negative scale.
    const std::vector<glm::vec3> corners{{-0.4f, -0.4f, 0}, {0.4f, -0.4f, 0}, {0, 0.5f, 0}};
    Scene scene;
    scene.camera.eye = {0, 0, 5};
    for (int i = 0; i < 4; ++i) {
        Object object =
            object_of(i % 2 == 0 ? polygon_mesh(corners, {{0, 1, 2}}) : polygon_mesh(corners, {{0, 2, 1}}));
        object.transform.translate = {i % 2 == 0 ? -0.8f : 0.8f, i < 2 ? 0.8f : -0.8f, 0};
        if (i >= 2) object.transform.scale.x = -1;
        scene.objects.push_back(object);
    }
    const PictureSize square{80, 80};
    Renderer renderer(1);
    (void)renderer.render(scene, square);
    DebugViewPainter painter(1);
    const Picture& sides = painter.paint({DebugView::Orientation, 0}, scene, renderer, square);
    int seen[2] = {0, 0};
    for (int y = 0; y < square.height; ++y)
        for (int x = 0; x < square.width; ++x) {
            const int object = renderer.object_at(x, y);
            const std::size_t i = 4 * sides.pixel(x, y);
            if (object < 0) {
                CHECK(painter.value_text(x, y) == "background");
                continue;
            }
            const bool front = object % 2 == 0;
            ++seen[front];
            CHECK(painter.value_text(x, y) == (front ? "front" : "back"));
            CHECK((sides.rgba[i + 2] > sides.rgba[i]) == front);  // blue for front, otherwise red
        }
    CHECK(seen[0] > 100);
    CHECK(seen[1] > 100);
}

TEST_CASE("debug view: only normals that point away from the viewer are striped", "[debug_view]") {
    Scene scene;
    scene.camera.eye = {0, 0, 3};
    scene.objects = {object_of(primitive(Primitive::Sphere, 48))};
    for (const bool flip : {false, true})
        for (const bool parallel : {false, true}) {
            scene.objects[0].normals.flip = flip;
            if (parallel) scene.camera.projection = Orthographic{3};
            Renderer renderer(1);
            (void)renderer.render(scene, size);
            DebugViewPainter painter(1);
            const Picture& shown = painter.paint({DebugView::Normal, 0}, scene, renderer, size);
            int striped = 0, plain = 0, inside = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const auto seen = renderer.seen_at(x, y);
                    if (!seen) continue;
                    const glm::vec3 v = parallel ? glm::vec3(0, 0, 1) : -glm::normalize(seen->position);
                    if (std::abs(glm::dot(seen->normal, v)) < 0.05f)
                        continue;  // skips the outline of a coarse ball
                    ++inside;
                    const auto color = normal_color(seen->normal);
                    const std::uint8_t* there = &shown.rgba[4 * shown.pixel(x, y)];
                    int off = 0;
                    for (std::size_t c = 0; c < 3; ++c)
                        off = std::max(off, std::abs(int(there[c]) - int(color[c])));
                    ++(off <= 1 ? plain : striped);
                    CHECK(painter.value_text(x, y).ends_with(" away") == flip);
                }
            REQUIRE(inside > 200);
            CHECK((striped == 0) == !flip);
            if (flip) CHECK(striped == Approx(inside * 3 / 8.0).epsilon(0.1));
        }
}
