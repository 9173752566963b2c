#include "tests/oracle/random_scene.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/scenes.h"

namespace glint::oracle {
namespace {

using test::uniform;
using test::uniform_vec3;

class SceneMaker {
  public:
    explicit SceneMaker(unsigned seed) : random_(seed) {}

    [[nodiscard]] bool chance(float probability) { return uniform(random_, 0, 1) < probability; }
    [[nodiscard]] int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    [[nodiscard]] float number(float low, float high) { return uniform(random_, low, high); }

    /// A unit direction, uniformly distributed on the sphere (approximately).
    [[nodiscard]] glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = uniform_vec3(random_, -1, 1);
            const float length = glm::length(v);
            if (length > 0.1f && length < 1) return v / length;
        }
    }

    [[nodiscard]] Camera camera() {
        Camera c;
        c.target = uniform_vec3(random_, -0.2f, 0.2f);
        const glm::vec3 away = direction();
        const float distance = number(2.6f, 4);
        const float near = chance(0.2f) ? distance - number(0, 0.6f) : 0.1f;  // cuts through objects
        c.eye = c.target + distance * away;
        c.up = std::abs(away.y) > 0.9f ? glm::vec3(1, 0.2f, 0) : glm::vec3(0.1f, 1, 0);
        const int kind = pick(4);
        if (kind == 0) {
            c.projection = Orthographic{number(1.6f, 3), near, 20};
        } else if (kind == 1) {
            const float x = number(-0.2f, 0.2f), y = number(-0.2f, 0.2f);
            Frustum f{near * (x - 0.5f), near * (x + 0.5f), near * (y - 0.4f), near * (y + 0.4f), near, 20};
            if (chance(0.3f)) std::swap(f.left, f.right);  // a mirrored picture
            c.projection = f;
        } else {
            c.projection = Perspective{number(25, 60), near, 20};
        }
        return c;
    }

    [[nodiscard]] Material material() {
        Material m;
        if (const auto presets = material_presets(); chance(0.3f)) {
            m = presets[static_cast<std::size_t>(pick(static_cast<int>(presets.size())))].material;
        } else {
            m.ambient = uniform_vec3(random_, 0, 0.5f);
            m.diffuse = uniform_vec3(random_, 0, 1);
            m.specular = uniform_vec3(random_, 0, 1);
            m.shininess = chance(0.1f) ? 0 : number(1, chance(0.3f) ? 128 : 30);
            if (chance(0.3f)) m.emission = uniform_vec3(random_, 0, 0.3f);
        }
        m.roughness = number(0.4f, 1);  // a lobe no steeper than (n.h)^128: 2/a and sqrt(s) per radian
        m.f0 = uniform_vec3(random_, 0, 1);
        return m;
    }

    [[nodiscard]] Object object() {
        struct Shape {
            Primitive primitive;
            int detail;
        };
        constexpr std::array<Shape, 11> shapes{
            Shape{Primitive::Sphere, 14},  Shape{Primitive::Icosphere, 1},
            Shape{Primitive::Cube, 2},     Shape{Primitive::TessellatedQuad, 3},
            Shape{Primitive::Torus, 14},   Shape{Primitive::Cylinder, 11},
            Shape{Primitive::Cone, 10},    Shape{Primitive::Knot, 40},
            Shape{Primitive::SkewQuad, 1}, Shape{Primitive::TJunction, 2},
            Shape{Primitive::Teapot, 2}};
        const Shape shape = shapes[static_cast<std::size_t>(pick(static_cast<int>(shapes.size())))];
        Object o = test::object_of(test::primitive(shape.primitive, shape.detail));
        const float size =
            shape.primitive == Primitive::TJunction || shape.primitive == Primitive::SkewQuad ? 0.25f : 0.9f;
        o.transform.translate = uniform_vec3(random_, -0.7f, 0.7f);
        o.transform.rotate_deg = uniform_vec3(random_, -180, 180);
        for (int axis = 0; axis < 3; ++axis)
            o.transform.scale[axis] = size * number(0.5f, 1.3f) * (chance(0.25f) ? -1.0f : 1.0f);
        constexpr std::array<NormalSource, 4> sources{NormalSource::Auto, NormalSource::Vertex,
                                                      NormalSource::Facet, NormalSource::Analytic};
        o.normals.source = sources[static_cast<std::size_t>(pick(4))];
        if (chance(0.3f)) o.normals.crease_deg = number(20, 90);
        o.material = material();
        return o;
    }

    [[nodiscard]] Light light(bool area) {
        Light l;
        l.kind = static_cast<LightKind>(pick(area ? 4 : 3));
        l.space = chance(0.4f) ? LightSpace::Camera : LightSpace::World;
        // In camera coordinates the objects are about 4 units in front of the eye.
        const glm::vec3 near_objects = l.space == LightSpace::Camera ? glm::vec3(0, 0, -4) : glm::vec3(0);
        glm::vec3 toward = direction();
        if (l.space == LightSpace::Camera && toward.z < 0 && chance(0.7f)) toward.z = -toward.z;
        const glm::vec3 place = near_objects + number(3, 5) * toward;
        const float w = chance(0.2f) ? number(0.5f, 2) : 1;
        l.position = glm::vec4(w * place, w);
        if (l.kind == LightKind::Directional) l.position = glm::vec4(number(0.5f, 3) * toward, 0);
        if (chance(0.3f)) l.ambient = uniform_vec3(random_, 0, 0.3f);
        l.diffuse = uniform_vec3(random_, 0.2f, 1);
        l.specular = uniform_vec3(random_, 0.2f, 1);
        l.intensity = number(0.3f, 1.2f);
        l.enabled = !chance(0.05f);
        if (chance(0.6f)) l.falloff = {number(0.3f, 1), number(0, 0.2f), number(0, 0.1f)};
        l.spot.direction = near_objects + uniform_vec3(random_, -0.7f, 0.7f) - place;
        l.spot.cutoff_deg = chance(0.1f) ? 180 : number(6, 60);
        l.spot.exponent = chance(0.3f) ? 0 : number(1, 30);
        l.area.edge_u = uniform_vec3(random_, -0.6f, 0.6f);
        l.area.edge_v = glm::cross(l.area.edge_u, direction()) + 0.2f * l.area.edge_u;
        l.area.samples = 1 << (2 * pick(3));
        return l;
    }

    [[nodiscard]] Scene scene(int max_lights, bool area) {
        Scene s;
        s.camera = camera();
        s.global_ambient = uniform_vec3(random_, 0, 0.3f);
        for (int i = 1 + pick(max_lights); i > 0; --i) s.lights.push_back(light(area));
        for (int i = 1 + pick(3); i > 0; --i) s.objects.push_back(object());
        s.display.background = uniform_vec3(random_, 0, 0.3f);
        s.shading.two_sided = chance(0.5f);
        s.shading.local_viewer = !chance(0.3f);
        s.shading.cull = chance(0.3f) ? Cull::Back : chance(0.2f) ? Cull::Front : Cull::None;
        if (chance(0.3f)) s.shading.interpolation = Interpolation::Screen;
        for (bool* term : {&s.shading.terms.emission, &s.shading.terms.ambient, &s.shading.terms.diffuse,
                           &s.shading.terms.specular})
            *term = !chance(0.05f);
        return s;
    }

  private:
    std::mt19937 random_;
};

}  // namespace

Scene random_scene(unsigned number) {
    Scene s = SceneMaker(1000 + number).scene(4, true);
    struct Mode {
        ShadingMode mode;
        FlatPoint point;
        Rules rules;
    };
    constexpr std::array<Mode, 6> modes{Mode{ShadingMode::Flat, FlatPoint::Centroid, Rules::Lecture},
                                        {ShadingMode::Flat, FlatPoint::Provoking, Rules::Lecture},
                                        {ShadingMode::Facet, FlatPoint::Centroid, Rules::Lecture},
                                        {ShadingMode::Gouraud, FlatPoint::Centroid, Rules::Lecture},
                                        {ShadingMode::Phong, FlatPoint::Centroid, Rules::Lecture},
                                        {ShadingMode::Gouraud, FlatPoint::Centroid, Rules::OpenGL2}};
    const Mode& mode = modes[number % modes.size()];
    s.shading.mode = mode.mode;
    s.shading.flat_point = mode.point;
    s.shading.rules = mode.rules;
    s.shading.reflection = static_cast<Reflection>(number / modes.size() % 7);
    s.npr.cool_to_warm = number % 11 == 0;
    return s;
}

Scene random_fixed_function_scene(unsigned number) {
    Scene s = SceneMaker(500000 + number).scene(8, false);
    s.shading.mode = number % 2 ? ShadingMode::Flat : ShadingMode::Gouraud;
    s.shading.flat_point = FlatPoint::Provoking;
    s.shading.interpolation = Interpolation::Perspective;
    s.shading.reflection = number % 3 ? Reflection::BlinnPhong : Reflection::Lambert;
    s.shading.rules = number % 5 ? Rules::Lecture : Rules::OpenGL2;
    for (Object& o : s.objects) {
        o.material.shininess = std::max(o.material.shininess, 1.0f);
        if (s.shading.rules == Rules::OpenGL2) o.material.shininess *= 2;  // some exceed 128
    }
    return s;
}

}  // namespace glint::oracle
