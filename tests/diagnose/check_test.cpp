// A wrong buffer is reported with a description of what it contains instead.
#include "diagnose/check/check.h"

#include <fmt/format.h>

#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "renderer/renderer.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

/// A rotated and flattened torus, seen from an oblique angle.
SceneDocument torus_scene() {
    SceneDocument document;
    Scene& scene = document.scene;
    scene.camera.eye = {2, 1.5f, 3};
    scene.lights = assorted_lights();
    Object torus = object_of(primitive(Primitive::Torus, 48));
    torus.transform = {{0.2f, 0.1f, 0}, {20, 30, 40}, {1, 0.6f, 0.8f}};
    scene.objects = {torus};
    return document;
}

/// Returns an incorrect program's value at a pixel.
using Change = std::function<glm::dvec3(glm::dvec3 right, const Explanation& e)>;

/// The buffers of a correct program, and its scene.
class RightBuffers {
  public:
    explicit RightBuffers(SceneDocument document) : document_(std::move(document)) {
        Renderer renderer(1);
        (void)renderer.render(document_.scene, diagnosed_size, true);
        buffers_ = pixel_buffers(renderer, document_.scene, diagnosed_size, buffer_names(document_.scene));
        for (int y = 0; y < diagnosed_size.height; ++y)
            for (int x = 0; x < diagnosed_size.width; ++x)
                if (renderer.object_at(x, y) >= 0)
                    surface_.emplace_back(diagnosed_size.index(x, y), renderer.explain(x, y));
    }

    /// The finding for one buffer after `change` was applied to its numbers at every surface pixel.
    [[nodiscard]] std::string found_in(const std::string& name, const Change& change) const {
        std::vector<PixelBuffer> buffers = buffers_;
        for (PixelBuffer& b : buffers) {
            if (b.name != name) continue;
            for (const auto& [pixel, explanation] : surface_) {
                float* const at = &b.picture.linear[3 * pixel];
                const glm::vec3 changed(change(glm::vec3(at[0], at[1], at[2]), explanation));
                for (int c = 0; c < 3; ++c) at[c] = changed[c];
            }
        }
        const BufferCheck check = check_buffers(document_, buffers, 1);
        if (!check.differs)
            return check.conventions.empty() ? "nothing" : check.conventions.front().substr(name.size() + 2);
        CHECK(check.differs->name == name);
        return check.differs->found;
    }

  private:
    SceneDocument document_;
    std::vector<PixelBuffer> buffers_;
    std::vector<std::pair<std::size_t, Explanation>> surface_;  // pixels
};

/// The finding in the torus's scene for a change that does not depend on the pixel.
std::string found_in(const std::string& name, const std::function<glm::dvec3(glm::dvec3)>& change) {
    static const RightBuffers torus(torus_scene());
    return torus.found_in(name, [&](glm::dvec3 right, const Explanation&) { return change(right); });
}

bool says(const std::string& found, const std::string& words) {
    INFO(found);
    return found.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("correct buffers are accepted", "[diagnose][check]") {
    CHECK(found_in("normal", [](glm::dvec3 n) { return n; }) == "nothing");
    for (const double off : {0.005, -0.005})  // noticeable, but too small to mean a different quantity
        CHECK(found_in("position", [off](glm::dvec3 p) { return p + off; }) ==
              "ours except for small differences");
    CHECK(found_in("position", [](glm::dvec3 p) { return p + 0.2; }).empty());
}

TEST_CASE("vectors in a different frame are reported with the missing transform", "[diagnose][check]") {
    const Scene scene = torus_scene().scene;
    const glm::dmat4 world_from_camera = world_from_view(scene.camera);
    const glm::dmat4 object_from_world = glm::inverse(world_from_object(scene.objects[0].transform));
    const glm::dmat4 clip = clip_from_view(scene.camera.projection, diagnosed_size);
    const glm::dmat3 camera_turn(world_from_camera);
    CHECK(
        says(found_in("normal", [&](glm::dvec3 n) { return camera_turn * n; }), "left in world coordinates"));
    CHECK(says(found_in("normal", [](glm::dvec3 n) { return -n; }), "negated"));
    CHECK(says(found_in("normal", [](glm::dvec3 n) { return 2.5 * n; }), "ours, not of length 1"));
    // A normal in object coordinates is the row vector n times the matrix for points, normalized: n M.
    const glm::dmat3 model(world_from_object(scene.objects[0].transform));
    const auto of_object = [&](glm::dvec3 n) { return glm::normalize((camera_turn * n) * model); };
    CHECK(says(found_in("normal", of_object), "left in object coordinates"));
    CHECK(says(found_in("normal", [&](glm::dvec3 n) { return glm::normalize(glm::dmat3(clip) * n); }),
               "clip coordinates"));
    CHECK(says(found_in("normal",
                        [&](glm::dvec3 n) {
                            return glm::normalize(glm::transpose(camera_turn) * (model * of_object(n)));
                        }),
               "in place of its inverse transpose"));
    const auto world = [&](glm::dvec3 p) { return glm::dvec3(world_from_camera * glm::dvec4(p, 1)); };
    CHECK(says(found_in("position", world), "left in world coordinates"));
    CHECK(
        says(found_in("position",
                      [&](glm::dvec3 p) { return glm::dvec3(object_from_world * glm::dvec4(world(p), 1)); }),
             "left in object coordinates"));
    CHECK(says(found_in("position", [&](glm::dvec3 p) { return glm::dvec3(clip * glm::dvec4(p, 1)); }),
               "clip coordinates, not divided by w"));
    CHECK(says(found_in("position", [&](glm::dvec3 p) { return glm::transpose(camera_turn) * world(p); }),
               "translation is missing"));
    CHECK(says(found_in("depth", [](glm::dvec3 d) { return -d; }), "negated"));
}

TEST_CASE("a reversed constant view vector is not reported as clip coordinates", "[diagnose][check]") {
    SceneDocument document = torus_scene();
    document.scene.shading.local_viewer = false;
    CHECK(RightBuffers(document).found_in("view", [](glm::dvec3 v, const Explanation&) { return -v; }) ==
          "ours, and negated");
}

TEST_CASE("a scaled term is reported with its factor, an unknown difference is not named",
          "[diagnose][check]") {
    CHECK(found_in("diffuse", [](glm::dvec3 d) { return d / 4.0; }) == "ours times 0.25");
    CHECK(found_in("normal", [](glm::dvec3 n) { return glm::dvec3(n.y * n.y, n.x, 0.3); }).empty());
}

TEST_CASE("small values of a different term are not reported as a multiple", "[diagnose][check]") {
    static const RightBuffers torus(torus_scene());
    const auto of_normal = [](glm::dvec3, const Explanation& e) {
        return 0.006 * glm::abs(glm::dvec3(e.at.normal.camera));
    };
    CHECK(torus.found_in("diffuse", of_normal).empty());
    CHECK(found_in("diffuse", [](glm::dvec3 d) { return d / 500.0; }) == "ours times 0.002");
}

TEST_CASE("a difference in a small part of the picture is identified from that part", "[diagnose][check]") {
    // A few percent of the torus's pixels face away from the light; the mistake leaves the others unchanged.
    SceneDocument document = torus_scene();
    Light& light = document.scene.lights[0];
    light.kind = LightKind::Directional;
    light.space = LightSpace::Camera;
    light.position = {0.4f, 0.2f, 1, 0};
    double negative = 0, all = 0;
    const std::string found =
        RightBuffers(document).found_in("n_dot_l_0", [&](glm::dvec3 c, const Explanation&) {
            all += 1;
            negative += c.x < 0 ? 1 : 0;
            return glm::max(c, 0.0);
        });
    CHECK(negative / all > 0.01);
    CHECK(negative / all < 0.03);
    CHECK(found == "ours, with negative values clamped to 0");
}

TEST_CASE("an eye or light in a frame other than the point's is reported", "[diagnose][check][release]") {
    const SceneDocument document = torus_scene();
    const Scene& scene = document.scene;
    const glm::dmat4 world_from_camera = world_from_view(scene.camera);
    const glm::dmat4 object_from_camera =
        glm::inverse(world_from_object(scene.objects[0].transform)) * world_from_camera;
    const glm::dmat4 clip_from_camera = clip_from_view(scene.camera.projection, diagnosed_size);
    const std::pair<std::string, glm::dmat4> frames[] = {{"object coordinates", object_from_camera},
                                                         {"world coordinates", world_from_camera},
                                                         {"camera coordinates", glm::dmat4(1)},
                                                         {"clip coordinates", clip_from_camera}};
    const auto in = [](const glm::dmat4& frame, glm::dvec3 point) {
        return glm::dvec3(frame * glm::dvec4(point, 1));
    };
    // The lamp has a position; its camera coordinates are computed from the scene.
    REQUIRE(scene.lights[2].kind == LightKind::Spot);
    REQUIRE(scene.lights[2].space == LightSpace::World);
    const glm::dvec3 light = in(glm::inverse(world_from_camera), glm::vec3(scene.lights[2].position));
    const RightBuffers right(document);
    for (const auto& [head_name, head] : frames)
        for (const auto& [point_name, point] : frames) {
            if (head_name == point_name && head_name == "camera coordinates") continue;
            const auto wrong = [&in, from = head, to = point](glm::dvec3 from_head) {
                return [&in, from, to, from_head](glm::dvec3, const Explanation& e) {
                    return glm::normalize(in(from, from_head) - in(to, e.at.point.camera));
                };
            };
            const std::string view = right.found_in("view", wrong(glm::dvec3(0)));
            const std::string to_light = right.found_in("l_2", wrong(light));
            if (head_name == point_name) {
                CHECK(says(view, head_name));
                CHECK(says(to_light, head_name));
            } else {
                CHECK(
                    says(view, fmt::format("from the point in {} to the eye in {}", point_name, head_name)));
                CHECK(says(to_light,
                           fmt::format("from the point in {} to the light in {}", point_name, head_name)));
            }
        }
}

TEST_CASE("a wrong distance, falloff, cone, r or h is reported with the formula used", "[diagnose][check]") {
    const RightBuffers right(torus_scene());
    const auto found = [&](const char* name, const auto& change) {
        return right.found_in(
            name, [&](glm::dvec3, const Explanation& e) { return glm::dvec3(change(e.at.lights[1], e.at)); });
    };
    const auto r = [](const ExplainedLight& l) { return double(l.distance); };
    CHECK(says(found("distance_1", [](const auto&, const auto&) { return 1.0; }), "1 everywhere"));
    CHECK(says(found("distance_1", [&](const auto& l, const auto&) { return std::sqrt(r(l) * r(l) + 1); }),
               "sqrt(r^2 + 1)"));
    // The bulb's falloff factors are 1, 0.1 and 0.05.
    CHECK(says(
        found("falloff_1", [&](const auto& l, const auto&) { return 1 / (0.1 * r(l) + 0.05 * r(l) * r(l)); }),
        "without the constant"));
    CHECK(says(found("falloff_1", [](const auto&, const auto&) { return 1 / 1.15; }),
               "1 everywhere: taken after l"));
    CHECK(says(found("falloff_1",
                     [&](const auto& l, const auto&) { return 1 / (1 + 0.05 * r(l) + 0.1 * r(l) * r(l)); }),
               "swapped"));
    CHECK(says(right.found_in("cone_2", [](glm::dvec3, const Explanation&) { return glm::dvec3(1); }),
               "the cone is not tested"));
    CHECK(says(found("r_1",
                     [](const auto& l, const auto& at) {
                         return glm::dvec3(double(l.n_dot_l) * glm::dvec3(at.normal.camera) -
                                           glm::dvec3(l.l.camera));
                     }),
               "not doubled"));
    CHECK(says(
        found("h_1", [](const auto& l,
                        const auto& at) { return glm::dvec3(glm::normalize(l.l.camera - at.view.camera)); }),
        "of l - v"));
}

TEST_CASE("normals with swapped axes, stored as colours or times the inverse are reported",
          "[diagnose][check]") {
    const SceneDocument document = torus_scene();
    const RightBuffers right(document);
    CHECK(says(found_in("normal", [](glm::dvec3 n) { return 0.5 * n + 0.5; }), "n / 2 + 1/2"));
    const glm::dmat3 from_object(view_from_world(document.scene.camera) *
                                 world_from_object(document.scene.objects[0].transform));
    const auto by = [&](const auto& change) {
        return right.found_in("normal", [&](glm::dvec3 n, const Explanation&) {
            return glm::normalize(change(glm::normalize(glm::transpose(from_object) * n)));
        });
    };
    CHECK(says(by([&](glm::dvec3 n) { return glm::inverse(from_object) * n; }),
               "inverse of V M, not transposed"));
    CHECK(says(by([&](glm::dvec3 n) {
                   return glm::transpose(glm::inverse(from_object)) * glm::dvec3(n.x, n.z, n.y);
               }),
               "(x, z, y)"));
}

TEST_CASE("rows in top-to-bottom order and vectors in world coordinates are accepted", "[diagnose][check]") {
    const SceneDocument document = torus_scene();
    Renderer renderer(1);
    (void)renderer.render(document.scene, diagnosed_size, true);
    std::vector<PixelBuffer> buffers =
        pixel_buffers(renderer, document.scene, diagnosed_size, {"position", "normal", "view"});
    const glm::mat4 to_world(world_from_view(document.scene.camera));
    for (PixelBuffer& b : buffers)
        for (std::size_t i = 0; i < b.picture.linear.size(); i += 3) {
            float* const at = &b.picture.linear[i];
            const glm::vec3 moved(to_world * glm::vec4(at[0], at[1], at[2], b.name == "position" ? 1 : 0));
            std::copy_n(&moved.x, 3, at);
        }
    CHECK(check_buffers(document, buffers, 1).differs.has_value());
    CHECK_FALSE(check_buffers(document, buffers, 1, true).differs.has_value());
    std::vector<PixelBuffer> turned = pixel_buffers(renderer, document.scene, diagnosed_size, {"position"});
    std::vector<float>& numbers = turned[0].picture.linear;
    const std::vector<float> before = numbers;
    const int row = 3 * diagnosed_size.width;
    for (int y = 0; y < diagnosed_size.height; ++y)
        std::copy_n(&before[std::size_t(row * y)], row,
                    &numbers[std::size_t(row * (diagnosed_size.height - 1 - y))]);
    const BufferCheck check = check_buffers(document, turned, 1);
    REQUIRE(check.differs.has_value());
    CHECK(says(check.differs->found, "rows from top to bottom"));
}

TEST_CASE("a cosine between a normal and a light in different frames is reported",
          "[diagnose][check][release]") {
    const SceneDocument document = torus_scene();
    const Scene& scene = document.scene;
    const glm::dmat3 world_from_camera(world_from_view(scene.camera));
    const glm::dmat3 object_from_world =
        glm::inverse(glm::dmat3(world_from_object(scene.objects[0].transform)));
    const glm::dmat3 clip(clip_from_view(scene.camera.projection, diagnosed_size));
    // Normals are row vectors, multiplied by the matrices for points.
    const auto normals = [&](glm::dvec3 n) {
        return std::vector<std::pair<std::string, glm::dvec3>>{
            {"object", glm::normalize((world_from_camera * n) * glm::inverse(object_from_world))},
            {"world", world_from_camera * n},
            {"camera", n},
            {"clip", glm::normalize(clip * n)}};
    };
    const auto directions = [&](glm::dvec3 l) {
        return std::vector<std::pair<std::string, glm::dvec3>>{
            {"object", glm::normalize(object_from_world * world_from_camera * l)},
            {"world", world_from_camera * l},
            {"camera", l},
            {"clip", glm::normalize(clip * l)}};
    };
    const RightBuffers right(document);
    for (std::size_t n = 0; n < 4; ++n)
        for (std::size_t l = 0; l < 4; ++l) {
            if ((n == 1 || n == 2) && n == l) continue;  // rotating both vectors changes nothing
            const std::string found = right.found_in("n_dot_l_0", [&](glm::dvec3, const Explanation& e) {
                return glm::dvec3(glm::dot(normals(e.at.normal.camera)[n].second,
                                           directions(e.at.lights[0].l.camera)[l].second));
            });
            CHECK(says(found, "for n in " + normals({0, 0, 1})[n].first + " coordinates and l in " +
                                  directions({0, 0, 1})[l].first + " coordinates"));
        }
}

TEST_CASE("mistakes in interpolated values are found at the corners", "[diagnose][check][release]") {
    SceneDocument document = torus_scene();
    document.scene.shading.mode = ShadingMode::Gouraud;
    const glm::dmat3 world_from_camera(world_from_view(document.scene.camera));
    const auto left_in_world = [&](glm::dvec3 l, const Explanation&) { return world_from_camera * l; };
    const RightBuffers right(document);
    CHECK(says(right.found_in("l_0", left_in_world), "left in world coordinates"));
    const auto absolute = [](glm::dvec3, const Explanation& e) {
        double sum = 0;
        for (const ExplainedCorner& c : e.corners)
            sum += double(c.weight) * double(std::abs(c.at.lights[2].n_dot_l));
        return glm::dvec3(sum);
    };
    CHECK(says(right.found_in("n_dot_l_2", absolute), "without its sign"));
}
