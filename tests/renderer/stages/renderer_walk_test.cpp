// A renderer keeps the results of its stages. A random walk through scenes, edits, sizes and numbers of
// samples compares each of its pictures with that of a new renderer. GLINT_WALK_STEPS and GLINT_WALK_SEED in
// the environment make it longer, or different.
#include <cstdlib>
#include <cstring>
#include <deque>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/scene/mistakes.h"
#include "renderer/renderer.h"
#include "tests/support/catch.h"
#include "tests/support/mistake_scenes.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenes.h"

using namespace glint;
using namespace glint::test;

namespace {

int from_environment(const char* name, int otherwise) {
    const char* const value = std::getenv(name);
    return value != nullptr ? std::atoi(value) : otherwise;
}

/// A random editor of scenes.
class Walk {
  public:
    explicit Walk(unsigned seed) : random_(seed) { change_scene(); }

    /// Makes one or two edits, all of which a scene file accepts.
    void step() {
        const Scene before = scene;
        for (unsigned i = 0; i <= below(4) / 3; ++i) edit();
        if (violation_of(scene) || violation_of_ranges(scene)) scene = before;
        visited_.push_back(scene);
        if (visited_.size() > 6) visited_.pop_front();
    }
    std::size_t below(std::size_t n) { return random_() % n; }

    Scene scene;
    PictureSize size{61, 47};
    int samples = 1;
    bool linear = true;
    std::string what;  // the last edits

  private:
    bool chance() { return below(2) == 0; }
    template <class Enum> Enum one_of() { return enumerators<Enum>[below(enumerators<Enum>.size())]; }
    Object& an_object() { return scene.objects[below(scene.objects.size())]; }
    Light& a_light() { return scene.lights[below(scene.lights.size())]; }

    void edit() {
        const std::size_t kind = below(16);
        what += " " + std::to_string(kind);
        if (scene.objects.empty() || scene.lights.empty()) return change_scene();
        if (kind < 4) return change_number();
        if (kind < 7) return drag_light();
        if (kind < 9) return change_switch();
        if (kind < 11) return change_shading();
        if (kind < 13) return change_picture();
        if (kind < 14) return change_items();
        if (kind < 15) return change_scene();
        scene = visited_.empty() ? scene : visited_[below(visited_.size())];  // as undo does
    }
    void change_number() {
        const std::vector<SceneNumber> numbers = numbers_of(scene);
        const SceneNumber& number = numbers[below(numbers.size())];
        if (number.is_w || number.pointer.find("/mesh") != std::string::npos ||
            number.pointer.starts_with("/transport"))
            return;
        what += number.pointer;
        const double value = number.value * double(uniform(random_, 0.6f, 1.5f)) +
                             (number.count ? 0.0 : double(uniform(random_, -0.1f, 0.1f)));
        (void)set_number(scene, number.pointer, number.count ? number.count->nearest(value) : value);
    }
    /// Mostly the same light as before, so that the sum of the others is kept.
    void drag_light() {
        if (below(4) == 0) dragged_ = below(scene.lights.size());
        Light& light = scene.lights[dragged_ % scene.lights.size()];
        light.position += glm::vec4(uniform_vec3(random_, -0.4f, 0.4f), 0);
        if (below(3) == 0) light.intensity = uniform(random_, 0, 8);  // its upper bound changes as well
        if (below(6) == 0) scene.display.exposure = uniform(random_, 0.5f, 2);
    }
    void change_switch() {
        bool* const switches[] = {
            &a_light().enabled,           &an_object().visible,          &an_object().normals.flip,
            &an_object().double_sided,    &scene.shading.two_sided,      &scene.shading.local_viewer,
            &scene.shading.terms.ambient, &scene.shading.terms.specular, &scene.npr.silhouettes,
            &scene.npr.creases,           &scene.npr.cool_to_warm};
        if (below(3) == 0) {
            const MistakeName& mistake = mistake_names()[below(mistake_names().size())];
            scene.shading.mistakes.*mistake.flag ^= true;
        } else {
            *switches[below(std::size(switches))] ^= true;
        }
    }
    void change_shading() {
        Shading& s = scene.shading;
        switch (below(7)) {
        case 0:
        case 1:
            s.mode = one_of<ShadingMode>();
            break;
        case 2:
            s.reflection = one_of<Reflection>();
            break;
        case 3:
            s.interpolation = one_of<Interpolation>();
            s.flat_point = one_of<FlatPoint>();
            break;
        case 4:
            s.cull = one_of<Cull>();
            s.rules = one_of<Rules>();
            break;
        case 5:
            scene.display.transfer = one_of<Transfer>();
            an_object().normals.source = one_of<NormalSource>();
            break;
        default:
            scene.transport = {chance() ? TransportModel::Local : one_of<TransportModel>(), 3, 2,
                               1 + static_cast<int>(below(3))};
        }
    }
    /// Most of these sizes have the same number of pixels, so that kept results have the same length.
    void change_picture() {
        constexpr PictureSize sizes[] = {{64, 45}, {45, 64}, {72, 40}, {96, 30},
                                         {30, 96}, {61, 47}, {1, 1},   {7, 130}};
        constexpr int counts[] = {1, 1, 2, 4};
        size = sizes[below(std::size(sizes))];
        samples = counts[below(std::size(counts))];
        linear = chance();
    }
    void change_items() {
        switch (below(5)) {
        case 0:
            if (scene.objects.size() < 6) scene.objects.push_back(an_object());
            break;
        case 1:
            scene.objects.erase(scene.objects.begin() + std::ptrdiff_t(below(scene.objects.size())));
            break;
        case 2:
            std::swap(an_object(), an_object());
            break;
        case 3:
            an_object().mesh = primitive(one_of<Primitive>(), 3);
            break;
        default:
            if (scene.lights.size() < 9) scene.lights.push_back(a_light());
        }
    }
    void change_scene() {
        scene = chance() ? busy_scene() : telling_scene();
        if (below(3) == 0) scene.camera.eye.x *= -1;
        if (below(8) == 0) scene.objects.clear();
        // With an area light no sum of the other lights is kept while one is dragged.
        if (chance()) std::erase_if(scene.lights, [](const Light& l) { return l.kind == LightKind::Area; });
        if (below(3) == 0) scene.lights.insert(scene.lights.end(), 4, Light(scene.lights[0]));
    }

    std::mt19937 random_;
    std::deque<Scene> visited_;
    std::size_t dragged_ = 0;
};

/// Compares bits, because some mistakes give NaNs, which are not equal to themselves.
bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), 4 * a.size()) == 0);
}

}  // namespace

TEST_CASE("after random edits, each reused picture and explanation equals a fresh one",
          "[renderer][property]") {
    const int seed = from_environment("GLINT_WALK_SEED", sanitized ? 2 : 1);
    Walk walk(static_cast<unsigned>(seed));
    Renderer kept(2);
    const int steps = from_environment("GLINT_WALK_STEPS", sanitized ? 500 : 15'000);
    for (int step = 0; step < steps; ++step) {
        walk.what.clear();
        walk.step();
        INFO("seed " << seed << ", step " << step << ":" << walk.what);
        Renderer fresh(1);
        const Picture& a = kept.render(walk.scene, walk.size, walk.linear, walk.samples);
        const Picture& b = fresh.render(walk.scene, walk.size, walk.linear, walk.samples);
        REQUIRE((a.rgba == b.rgba));
        REQUIRE(same_bytes(a.linear, b.linear));
        if (walk.samples > 1) continue;
        const int x = static_cast<int>(walk.below(std::size_t(walk.size.width))),
                  y = static_cast<int>(walk.below(std::size_t(walk.size.height)));
        const Explanation one = kept.explain(x, y), other = fresh.explain(x, y);
        REQUIRE(one.byte == other.byte);
        REQUIRE(one.hit == other.hit);
        if (one.hit) REQUIRE(one.face == other.face);
    }
}
