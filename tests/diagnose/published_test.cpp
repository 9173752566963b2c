// Pictures drawn by a program in the style of tutorials: lit at each pixel in world coordinates, with normals
// that are normalized at the pixel, and with a highlight even where n·l is negative. It shares no code with
// the renderer: it intersects rays with ellipsoids and a floor.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <string_view>

#include "diagnose/diagnosis_format.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

constexpr PictureSize traced_size{240, 180};

/// The program's scene, for the diagnosis: two balls, one of them stretched, on a floor, under a sun, a bulb
/// and a spot.
SceneDocument balls_on_floor() {
    const auto light = [](LightKind kind, glm::vec4 position, glm::vec3 diffuse) {
        Light l;
        l.kind = kind;
        l.position = position;
        l.ambient = glm::vec3(0.04f);
        l.diffuse = diffuse;
        l.specular = 0.8f * diffuse;
        l.falloff = kind == LightKind::Directional ? Falloff{} : Falloff{0.8f, 0.1f, 0.06f};
        return l;
    };
    const auto object = [](Primitive kind, int detail, const Transform& transform, glm::vec3 diffuse,
                           float shininess) {
        Object o = object_of(primitive(kind, detail));
        o.transform = transform;
        o.material = {
            .ambient = diffuse, .diffuse = diffuse, .specular = glm::vec3(0.5f), .shininess = shininess};
        return o;
    };
    SceneDocument document;
    Scene& scene = document.scene;
    scene.camera.eye = {1.2f, 2.2f, 5};
    scene.camera.target = {0, 0.2f, 0};
    scene.camera.projection = Perspective{40, 0.1f, 50};
    scene.global_ambient = glm::vec3(0);
    scene.display.background = {0.1f, 0.1f, 0.12f};
    scene.lights = {light(LightKind::Directional, {-0.5f, 1, 0.6f, 0}, {0.4f, 0.38f, 0.33f}),
                    light(LightKind::Point, {1.6f, 1.4f, 1.4f, 1}, {0.3f, 0.5f, 0.9f}),
                    light(LightKind::Spot, {-1.8f, 3, 1.2f, 1}, {0.9f, 0.7f, 0.5f})};
    scene.lights[2].spot.direction = {0.45f, -1, -0.35f};
    scene.lights[2].spot.cutoff_deg = 22;
    scene.lights[2].spot.exponent = 0;  // the program's cone is as bright at its edge as at its axis
    scene.objects = {
        object(Primitive::Sphere, 192, {{-0.8f, 0.3f, 0.2f}, {0, 30, 0}, {0.6f, 0.9f, 0.6f}},
               {0.7f, 0.45f, 0.34f}, 24),
        object(Primitive::Sphere, 192, {{1, 0.2f, -0.2f}, {0, -40, 0}, {0.8f, 0.8f, 0.8f}},
               {0.4f, 0.55f, 0.8f}, 40),
        object(Primitive::Cube, 1, {{0, -1.6f, 0}, {0, 0, 0}, {6, 1, 6}}, {0.5f, 0.5f, 0.55f}, 10)};
    return document;
}

/// The program, with a mistake in its code.
class Program {
  public:
    Program(const Scene& scene, std::string_view mistake) : scene_(scene), mistake_(mistake) {
        view_ =
            glm::lookAt(glm::dvec3(scene.camera.eye), glm::dvec3(scene.camera.target), glm::dvec3(0, 1, 0));
    }

    [[nodiscard]] Picture picture() const {
        Picture drawn{traced_size, std::vector<std::uint8_t>(4 * traced_size.pixels(), 255), {}};
        const double half = std::tan(glm::radians(20.0));
        const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(view_));
        for (int y = 0; y < traced_size.height; ++y)
            for (int x = 0; x < traced_size.width; ++x) {
                const double u = (2 * x + 1.0 - traced_size.width) / traced_size.height;
                const double v = (traced_size.height - 2 * y - 1.0) / traced_size.height;
                const glm::dvec3 c = seen_along(world_from_view * glm::dvec3(half * u, half * v, -1));
                for (int k = 0; k < 3; ++k)
                    drawn.rgba[4 * drawn.pixel(x, y) + std::size_t(k)] =
                        static_cast<std::uint8_t>(std::lround(255 * std::clamp(c[k], 0.0, 1.0)));
            }
        return drawn;
    }

  private:
    [[nodiscard]] bool is(std::string_view name) const { return mistake_ == name; }

    [[nodiscard]] glm::dvec3 seen_along(glm::dvec3 ray) const {
        const glm::dvec3 eye(scene_.camera.eye);
        double nearest = 1e9;
        glm::dvec3 color(scene_.display.background);
        for (const Object& o : scene_.objects) {
            const bool is_floor = &o == &scene_.objects.back();
            const Transform& t = o.transform;
            const glm::dmat4 model =
                glm::scale(glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(t.translate)),
                                       glm::radians(double(t.rotate_deg.y)), glm::dvec3(0, 1, 0)),
                           glm::dvec3(t.scale));
            const glm::dvec3 from(glm::inverse(model) * glm::dvec4(eye, 1)),
                along(glm::inverse(model) * glm::dvec4(ray, 0));
            double s = (1 - from.y) / along.y;  // the distance to the floor, the cube's upper face
            if (!is_floor) {
                const double a = glm::dot(along, along), b = glm::dot(from, along),
                             d = b * b - a * (glm::dot(from, from) - 1);
                if (d < 0) continue;
                s = (-b - std::sqrt(d)) / a;
            }
            const glm::dvec3 object = from + s * along;
            const bool misses = is_floor && std::max(std::abs(object.x), std::abs(object.z)) > 1;
            if (s <= 0 || s >= nearest || misses) continue;
            nearest = s;
            color = lit(o.material, model, object, is_floor ? glm::dvec3(0, 1, 0) : object);
        }
        return color;
    }

    [[nodiscard]] glm::dvec3 lit(const Material& m, const glm::dmat4& model, glm::dvec3 object,
                                 glm::dvec3 normal) const {
        glm::dmat3 to_world = glm::transpose(glm::inverse(glm::dmat3(model)));
        if (is("normals_by_model_matrix")) to_world = glm::dmat3(model);
        if (is("normals_without_model")) to_world = glm::dmat3(1);
        if (is("normals_by_inverse")) to_world = glm::inverse(glm::dmat3(model));
        if (is("positions_as_normals")) normal = object;
        if (is("normals_axes_exchanged")) normal = {normal.x, normal.z, normal.y};
        if (is("normals_flipped")) normal = -normal;
        glm::dvec3 n = glm::normalize(to_world * normal);
        if (is("normals_as_points")) n = glm::normalize(glm::dvec3(model * glm::dvec4(normal, 1)));
        if (is("unnormalized_normals")) n = to_world * normal;
        const glm::dvec3 p(model * glm::dvec4(object, 1));
        glm::dvec3 v = glm::normalize((is("viewer_at_origin_of_world") ? glm::dvec3(0) : eye()) - p);
        if (is("view_reversed")) v = -v;
        if (is("unnormalized_view")) v = eye() - p;
        glm::dvec3 sum(0);
        for (const Light& l : scene_.lights) {
            const glm::dvec3 share = share_of(l, m, n, p, v);
            if (is("last_light_only")) sum = glm::dvec3(0);
            sum += is("clamp_each_light") ? glm::min(share, glm::dvec3(1)) : share;
        }
        if (is("average_of_lights")) sum /= 3;
        return is("hue is turned") ? glm::dvec3(sum.y, sum.z, sum.x) : sum;
    }

    [[nodiscard]] glm::dvec3 eye() const { return glm::dvec3(scene_.camera.eye); }

    [[nodiscard]] glm::dvec3 share_of(const Light& light, const Material& m, glm::dvec3 n, glm::dvec3 p,
                                      glm::dvec3 v) const {
        const bool is_sun = light.kind == LightKind::Directional;
        const glm::dvec3 place(light.position), to_light = is_sun ? place : place - p;
        glm::dvec3 l = glm::normalize(to_light);
        if (is("unnormalized_light")) l = to_light;
        if (is("divided_by_square") && !is_sun) l = to_light / glm::dot(to_light, to_light);
        if (is("position_is_direction")) l = glm::normalize(place);
        if (is("light_direction_reversed") && is_sun) l = -l;
        double cosine = std::max(glm::dot(n, l), 0.0);
        if (is("no_clamp_of_cosine")) cosine = glm::dot(n, l);
        if (is("absolute_cosine")) cosine = std::abs(glm::dot(n, l));
        if (is("half_lambert")) cosine = 0.5 + 0.5 * glm::dot(n, l);
        if (is("cosine squared")) cosine *= cosine;
        glm::dvec3 r = 2 * glm::dot(n, l) * n - l;
        if (is("reflect_sign")) r = -r;
        double shininess = double(m.shininess);
        if (is("shininess_as_fraction")) shininess /= 128;
        if (is("shininess_inverted")) shininess = 1 / shininess;
        double highlight = std::pow(std::max(glm::dot(r, v), 0.0), shininess);
        if (is("half_angle_with_phong_shininess"))
            highlight = std::pow(std::max(glm::dot(n, glm::normalize(l + v)), 0.0), shininess);
        double distance = glm::length(to_light);
        if (is("distance_is_one")) distance = 1;
        const auto [constant, linear, quadratic] = light.falloff;
        double strength = 1 / (double(constant) + distance * (double(linear) + distance * double(quadratic)));
        if (is("falloff_forgotten") || is_sun) strength = 1;
        if (is("falloff_inverted")) strength = 1 / strength;
        if (is("distance to the eye") && !is_sun) {
            const double far = glm::length(eye() - p);
            strength = 1 / (double(constant) + far * (double(linear) + far * double(quadratic)));
        }
        if (light.kind == LightKind::Spot) {
            const double share = is("cutoff_as_full_angle") ? 0.5 : 1, degrees = share * 22;
            const double edge = std::cos(is("degrees_for_radians") ? degrees : glm::radians(degrees));
            const glm::dvec3 along = is("unnormalized_light") ? glm::normalize(to_light) : l;
            const bool is_inside = glm::dot(-along, glm::normalize(glm::dvec3(light.spot.direction))) >= edge;
            strength *= is_inside != is("cone_cosines_swapped") ? 1 : 0;
        }
        glm::dvec3 ambient(light.ambient * m.ambient), diffuse(light.diffuse * m.diffuse),
            specular(light.specular * m.specular);
        if (is("ambient_without_material")) ambient = light.ambient;
        if (is("missing_pi")) diffuse /= glm::pi<double>();
        if (is("highlight_tinted")) specular *= glm::dvec3(m.diffuse);
        if (is("coefficients_swapped")) {
            diffuse = light.diffuse * m.specular;
            specular = light.specular * m.diffuse;
        }
        if (is("/shading/terms/specular=false")) specular = glm::dvec3(0);
        if (is("/shading/terms/ambient=false")) ambient = glm::dvec3(0);
        if (is("/lights/0/enabled=false") && is_sun) return glm::dvec3(0);
        if (is("highlight times cosine twice")) highlight *= cosine * cosine;
        if (is("ambient_not_attenuated"))
            return ambient + strength * (cosine * diffuse + highlight * specular);
        return strength * (ambient + cosine * diffuse + highlight * specular);
    }

    const Scene& scene_;
    std::string_view mistake_;
    glm::dmat4 view_{1};
};

/// Whether at least 15 of 10,000 pixels differ by more than two levels.
bool differ_visibly(const Picture& a, const Picture& b) {
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < a.size.pixels(); ++i)
        unlike += most_apart(rgb_at(a, i), rgb_at(b, i)) > 2 ? 1 : 0;
    return 10'000 * unlike > 15 * a.size.pixels();
}

}  // namespace

TEST_CASE("a correct picture by a tutorial's program has no mistake", "[diagnose]") {
    const SceneDocument document = balls_on_floor();
    const Diagnosis d = diagnosed(document, Program(document.scene, "").picture());
    INFO(diagnosis_text(d, document.scene));
    CHECK(d.verdict == Verdict::NoMistake);
}

TEST_CASE("mistakes in a tutorial's program are named", "[diagnose][release]") {
    const SceneDocument document = balls_on_floor();
    const Picture right = Program(document.scene, "").picture();
    for (const char* name : {"normals_by_model_matrix",
                             "normals_without_model",
                             "normals_by_inverse",
                             "normals_axes_exchanged",
                             "normals_flipped",
                             "normals_as_points",
                             "unnormalized_normals",
                             "viewer_at_origin_of_world",
                             "view_reversed",
                             "unnormalized_view",
                             "last_light_only",
                             "clamp_each_light",
                             "average_of_lights",
                             "unnormalized_light",
                             "divided_by_square",
                             "position_is_direction",
                             "light_direction_reversed",
                             "no_clamp_of_cosine",
                             "absolute_cosine",
                             "half_lambert",
                             "reflect_sign",
                             "shininess_as_fraction",
                             "shininess_inverted",
                             "half_angle_with_phong_shininess",
                             "distance_is_one",
                             "falloff_forgotten",
                             "falloff_inverted",
                             "cutoff_as_full_angle",
                             "degrees_for_radians",
                             "cone_cosines_swapped",
                             "ambient_without_material",
                             "missing_pi",
                             "highlight_tinted",
                             "coefficients_swapped",
                             "ambient_not_attenuated",
                             "/shading/terms/specular=false",
                             "/shading/terms/ambient=false",
                             "/lights/0/enabled=false"}) {
        const Picture wrong = Program(document.scene, name).picture();
        if (!differ_visibly(wrong, right)) continue;
        const Diagnosis d = diagnosed(document, wrong);
        INFO(name << ": " << diagnosis_text(d, document.scene));
        CHECK(is_explained(d.verdict));
        if (d.candidates.empty()) continue;
        const Candidate& first = d.candidates.front();
        const auto is_it = [&](const std::string& said) { return said.find(name) != std::string::npos; };
        CHECK((is_it(settings_of(d)) || is_it(first.name) ||
               std::any_of(first.also_named.begin(), first.also_named.end(), is_it)));
    }
}

TEST_CASE("mistakes outside the catalogue are not reported as ones in the catalogue", "[diagnose][release]") {
    const SceneDocument document = balls_on_floor();
    for (const char* name :
         {"hue is turned", "cosine squared", "distance to the eye", "highlight times cosine twice"}) {
        const Diagnosis d = diagnosed(document, Program(document.scene, name).picture());
        INFO(name << ": " << diagnosis_text(d, document.scene));
        CHECK(d.verdict == Verdict::NotInCatalogue);
    }
}
