#pragma once
// Random scenes that use all features, reproducible from a seed. Only the standard generator's raw bits are
// used, because the distributions differ between libraries.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"
#include "models/scene/scene.h"

namespace glint {

class RandomScene {
  public:
    explicit RandomScene(unsigned seed) : random_(seed) {}

    Scene scene() {
        Scene s;
        s.camera = camera();
        s.global_ambient = color();
        s.lights.resize(below(6));
        for (Light& l : s.lights) l = light();
        s.objects.resize(below(6));
        for (Object& o : s.objects) o = object();
        s.shading = shading();
        s.npr = {flag(), color(), color(),         number(), number(),
                 flag(), flag(),  between(0, 180), color(),  positive()};
        s.display = {color(), one_of<Transfer>(), positive()};
        return s;
    }
    std::size_t below(std::size_t n) { return random_() % n; }

  private:
    bool flag() { return below(2) == 0; }
    float between(double low, double high) {
        return static_cast<float>(low + (high - low) * static_cast<double>(random_()) / 4294967295.0);
    }
    /// Returns a number that a scene file accepts: usually an ordinary one, otherwise one of any magnitude,
    /// sometimes one that is hard to write as text.
    float positive() {
        constexpr float hard[] = {1e7f, 1e-45f, 7.0385307e-26f, 0.1f, 1.17549435e-38f, 3.14159274f};
        if (below(10) == 0) return hard[below(std::size(hard))];
        return between(0.5, 1) * static_cast<float>(std::pow(10.0, between(-6, 6)));
    }
    float number() { return below(8) == 0 ? -0.0f : (flag() ? positive() : -positive()); }
    glm::vec3 color() { return {flag() ? 0 : positive(), positive(), positive()}; }
    glm::vec3 vector() { return {number(), number(), positive()}; }  // never zero
    glm::vec3 small_vector() { return {between(-9, 9), between(-9, 9), between(1, 9)}; }
    template <class Enum> Enum one_of() { return static_cast<Enum>(below(names_of<Enum>().size())); }
    std::string name() {
        constexpr const char* pieces[] = {"Lamp", " ",    "\"",   "\\", "/", "\n", "\t",
                                          "\x01", "\x7f", "茶壺", "é",  "😀", "~"};
        std::string text;
        for (std::size_t i = below(5); i > 0; --i) text += pieces[below(std::size(pieces))];
        if (below(9) == 0) text.push_back('\0');
        return text;
    }

    Camera camera() {
        Camera c;
        c.target = small_vector();
        c.eye = c.target + glm::vec3(between(1, 5), between(1, 5), between(1, 5));
        c.up = {0, between(0.1, 9), 0};
        const float near = between(1e-3, 1), far = near + between(1, 1e6);
        switch (below(3)) {
        case 0:
            c.projection = Perspective{between(1, 179), near, far};
            break;
        case 1:
            c.projection = Orthographic{positive(), near, far};
            break;
        default:
            c.projection = Frustum{between(-2, -1), between(1, 2), between(1, 2), between(-2, -1), near, far};
        }
        return c;
    }
    Light light() {
        Light l;
        l.name = name();
        l.kind = one_of<LightKind>();
        l.space = one_of<LightSpace>();
        l.position = glm::vec4(vector(), l.kind == LightKind::Directional ? 0 : 1);
        l.ambient = color(), l.diffuse = color(), l.specular = color();
        l.intensity = positive();
        l.enabled = flag();
        l.falloff = {flag() ? 0 : positive(), positive(), positive()};
        l.spot = {vector(), below(4) == 0 ? 180 : between(0, 90), positive()};
        const int n = 1 + static_cast<int>(below(8));
        l.area = {{between(1, 2), between(-1, 1), 0}, {0, 0, between(1, 2)}, n * n};
        return l;
    }
    Object object() {
        Object o;
        o.name = name();
        const auto primitive = one_of<Primitive>();
        const auto most = static_cast<std::size_t>(info_of(primitive).max_detail);
        if (flag())
            o.source = PrimitiveMesh{primitive, 1 + static_cast<int>(below(most))};
        else
            o.source = MeshFile{"meshes/a \"b\" ü.obj"};
        o.transform = {{number(), number(), number()}, vector(), {positive(), -positive(), positive()}};
        o.normals = {one_of<NormalSource>(), one_of<NormalWeighting>(), between(0, 180), flag()};
        o.visible = below(4) != 0;
        o.material = {color(), color(), color(), color(), between(0, 10'000), between(0, 1), color()};
        return o;
    }
    Shading shading() {
        Shading s;
        s.mode = one_of<ShadingMode>();
        s.reflection = one_of<Reflection>();
        s.interpolation = one_of<Interpolation>();
        s.flat_point = one_of<FlatPoint>();
        s.two_sided = flag(), s.local_viewer = flag();
        s.cull = one_of<Cull>();
        s.power_table = flag() ? 0 : static_cast<int>(2 + below(65535));
        s.rules = one_of<Rules>();
        s.terms = {flag(), flag(), flag(), flag()};
        for (const MistakeName& m : mistake_names()) s.mistakes.*m.flag = below(4) == 0;
        return s;
    }

    std::mt19937 random_;
};

}  // namespace glint
