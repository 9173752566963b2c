#include "tests/stress/stress_scene.h"

#include <algorithm>
#include <cmath>

#include "models/scene/mistakes.h"

namespace glint {

/// A factor: usually 1; in extreme scenes sometimes a power of ten.
float StressScenes::stretch() { return wild() ? std::pow(10.0f, between(-7, 7)) : 1.0f; }

/// Returns a positive number: usually an ordinary one; in extreme scenes sometimes any that a scene file
/// accepts.
float StressScenes::positive() {
    constexpr float hard[] = {1e7f, 1e-45f, 1e-38f, 1e-18f, 9999999.0f, 1.0f};
    if (!wild()) return between(0.1, 3);
    return one_in(2) ? hard[below(std::size(hard))] : std::pow(10.0f, between(-30, 7));
}

/// Returns a number from 0 to 1, often exactly 0 or 1; in extreme scenes sometimes any positive one.
float StressScenes::share() {
    if (one_in(4)) return static_cast<float>(below(2));
    return wild() ? positive() : between(0, 1);
}

Projection StressScenes::projection(float size) {
    const float near = between(0.01, 2) * size * stretch();
    const float far = near + between(1, 50) * size * stretch();
    const float k = stretch();
    switch (below(3)) {
    case 0:
        return Perspective{wild() ? positive() : between(1, 179), near, far};
    case 1:
        return Orthographic{between(0.5, 6) * size * k, near, far};
    default:
        return Frustum{between(-2, 0) * near * k,
                       between(0.1, 2) * near * k,
                       between(-2, 0) * near * k,
                       between(0.1, 2) * near * k,
                       near,
                       far};
    }
}

Camera StressScenes::camera(float size) {
    Camera c;
    c.target = size * around(1);
    c.eye = c.target + size * (around(4) + glm::vec3(0, 0, 3));
    if (wild()) c.eye = vector();
    c.up = one_in(4) ? vector() : glm::vec3(0, 1, 0);
    c.projection = projection(size);
    return c;
}

Light StressScenes::light(float size) {
    Light l;
    l.kind = one_of<LightKind>(4);
    l.space = one_of<LightSpace>(2);
    const float k = stretch();
    l.position = glm::vec4(k * size * around(5), l.kind == LightKind::Directional ? 0.0f : 1.0f);
    if (l.position.w > 0 && wild()) l.position.w = positive();
    l.ambient = one_in(2) ? glm::vec3(0) : color();
    l.diffuse = color(), l.specular = color();
    l.intensity = share();
    l.enabled = !one_in(8);
    l.falloff = {one_in(3) ? 0.0f : positive(), one_in(2) ? 0.0f : positive(), one_in(2) ? 0.0f : positive()};
    l.spot = {one_in(2) ? vector() : glm::vec3(0, -1, 0), one_in(5) ? 180.0f : between(0, 90),
              one_in(4) ? 0.0f : between(0, 60)};
    if (one_in(9)) l.spot.cutoff_deg = 90;
    const int n = 1 + static_cast<int>(below(3));
    l.area = {k * size * around(1), size * around(1), n * n};
    return l;
}

Transform StressScenes::transform(float size) {
    Transform t;
    t.translate = size * around(2);
    t.rotate_deg = one_in(2) ? glm::vec3(0) : stretch() * around(180);
    t.scale = size * glm::vec3(between(0.2, 2), between(0.2, 2), between(0.2, 2));
    for (int i = 0; i < 3; ++i) {
        if (one_in(9)) t.scale[i] = -t.scale[i];
        t.scale[i] *= stretch();
        t.translate[i] *= stretch();
    }
    t.scale *= stretch();
    return t;
}

Material StressScenes::material() {
    Material m{color(), color(), color(), one_in(3) ? color() : glm::vec3(0), 32, between(0, 1), color()};
    if (one_in(5)) m.roughness = static_cast<float>(below(2));
    m.shininess = one_in(3) ? std::min(share(), 1e4f) : between(0, one_in(4) ? 10'000 : 100);
    if (one_in(4)) m.shininess = std::floor(m.shininess);
    return m;
}

Object StressScenes::object(float size) {
    constexpr int max_detail[] = {9, 9, 2, 2, 3, 3, 7, 9, 40, 1, 16, 1, 2};  // in the order of Primitive
    Object o;
    const auto primitive = below(std::size(max_detail));
    o.source = PrimitiveMesh{static_cast<Primitive>(primitive),
                             1 + static_cast<int>(below(static_cast<std::size_t>(max_detail[primitive])))};
    o.transform = transform(size);
    o.normals = {one_of<NormalSource>(5), one_of<NormalWeighting>(3), one_in(2) ? 180.0f : between(0, 180)};
    o.material = material();
    return o;
}

Shading StressScenes::shading() {
    Shading s;
    s.mode = one_of<ShadingMode>(4);
    s.reflection = one_of<Reflection>(7);
    s.interpolation = one_of<Interpolation>(3);
    s.flat_point = one_of<FlatPoint>(2);
    s.two_sided = one_in(2);
    s.local_viewer = !one_in(3);
    s.cull = one_in(2) ? Cull::None : one_of<Cull>(3);
    s.rules = one_of<Rules>(2);
    s.terms = {!one_in(8), !one_in(8), !one_in(8), !one_in(8)};
    s.power_table = one_in(8) ? static_cast<int>(2 + below(65535)) : 0;
    if (one_in(2)) return s;
    const auto mistakes = mistake_names();
    for (std::size_t i = 1 + below(3); i > 0; --i) s.mistakes.*mistakes[below(mistakes.size())].flag = true;
    return s;
}

Npr StressScenes::npr() {
    Npr n;
    n.cool_to_warm = one_in(3);
    n.cool = color(), n.warm = color();
    n.alpha = number(), n.beta = number();
    n.silhouettes = one_in(4), n.creases = one_in(4);
    n.crease_deg = between(0, 180);
    n.stroke = color();
    n.stroke_width_px = wild() ? positive() : between(0, 6);
    return n;
}

StressCase StressScenes::next() {
    StressCase c;
    constexpr std::size_t wildness[] = {0, 100, 30, 10, 3};
    wild_ = wildness[below(std::size(wildness))];
    const float size = one_in(3) ? std::pow(10.0f, between(-7, 7)) : 1.0f;
    c.scene.camera = camera(size);
    c.scene.global_ambient = color();
    c.scene.lights.resize(below(5));
    for (Light& l : c.scene.lights) l = light(size);
    c.scene.objects.resize(one_in(30) ? 0 : 1 + below(4));
    for (Object& o : c.scene.objects) o = object(size);
    c.scene.shading = shading();
    if (one_in(2)) c.scene.npr = npr();
    c.scene.display = {color(), one_of<Transfer>(2), positive()};
    const auto most = one_in(25) ? std::size_t{150} : std::size_t{40};
    c.size = {1 + static_cast<int>(below(most)), 1 + static_cast<int>(below(most))};
    c.samples = one_in(3) ? 1 << below(4) : 1;
    return c;
}

void StressScenes::edit(Scene& scene) {
    const auto what = below(8);
    if (what < 4 && !scene.lights.empty()) {
        Light& l = scene.lights[below(scene.lights.size())];
        const glm::vec3 moved = glm::vec3(l.position) * between(0.5, 1.5);
        l.position = glm::vec4(moved, l.position.w);
        if (one_in(4)) l = light(1);
    } else if (what < 6 && !scene.objects.empty()) {
        Object& o = scene.objects[below(scene.objects.size())];
        one_in(2) ? o.material = material() : (o.transform = transform(1), Material());
    } else if (what == 6) {
        scene.shading = shading();
    } else {
        one_in(2) ? scene.npr = npr() : (scene.camera = camera(1), Npr());
    }
}

}  // namespace glint
