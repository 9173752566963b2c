#pragma once
// Generates scenes to diagnose, and incorrect pictures of them, from a seed.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

#include "diagnose/diagnose.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/scenes.h"

namespace glint::test {

inline constexpr PictureSize diagnosed_size{160, 120};

/// A scene that comes with the program, by its file's name.
inline SceneDocument shipped(const std::string& name) {
    return std::get<SceneDocument>(open_document(project_file("assets/scenes/") + name));
}

/// Two or three objects under one to four lights, like a student's first scenes.
inline SceneDocument diagnosed_scene(unsigned seed) {
    std::mt19937 random(seed);
    Scene scene;
    scene.camera.eye = glm::vec3(0, 0.6f, 5) + uniform_vec3(random, -1.5f, 1.5f);
    scene.global_ambient = glm::vec3(uniform(random, 0, 0.2f));
    scene.shading.reflection = random() % 2 == 0 ? Reflection::Phong : Reflection::BlinnPhong;
    scene.shading.mode = random() % 4 == 0 ? ShadingMode::Gouraud : ShadingMode::Phong;
    const std::size_t lights = 1 + random() % 4;
    for (std::size_t i = 0; i < lights; ++i) {
        Light l = assorted_lights()[(random() >> 3) % 3];
        const glm::vec3 place = uniform_vec3(random, -3, 3) + glm::vec3(0, 2, 1);
        l.position = glm::vec4(place, l.kind == LightKind::Directional ? 0 : 1);
        l.spot.direction = glm::vec3(0.1f) - place;
        l.ambient = glm::vec3(uniform(random, 0, 0.1f));
        l.diffuse = uniform_vec3(random, 0.3f, 1);
        l.intensity = uniform(random, 0.5f, 1.2f);
        if (random() % 2 == 0) l.falloff = {1, 0.1f, 0.02f};
        scene.lights.push_back(l);
    }
    const Primitive kinds[] = {Primitive::Sphere, Primitive::Torus, Primitive::Cube, Primitive::Knot};
    const std::size_t objects = 2 + random() % 2;
    for (std::size_t i = 0; i < objects; ++i) {
        const Primitive kind = kinds[random() % 4];
        Object o = object_of(primitive(kind, kind == Primitive::Cube ? 4 : 48));
        o.source = PrimitiveMesh{kind, kind == Primitive::Cube ? 4 : 48};
        o.transform.translate =
            glm::vec3(1.6f * static_cast<float>(i) - 1.6f, 0, 0) + uniform_vec3(random, -0.3f, 0.3f);
        o.transform.rotate_deg = uniform_vec3(random, 0, 90);
        o.transform.scale = uniform_vec3(random, 0.6f, 1.1f);
        o.material.diffuse = uniform_vec3(random, 0.1f, 0.9f);
        o.material.specular = glm::vec3(uniform(random, 0.2f, 1));
        o.material.shininess = uniform(random, 4, 60);
        scene.objects.push_back(o);
    }
    SceneDocument document;
    document.scene = scene;
    return document;
}

/// The mistake's index in the catalogue.
inline std::size_t place_of(std::string_view name) {
    const auto all = mistake_names();
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const MistakeName& m) { return m.name == name; });
    return static_cast<std::size_t>(at - all.begin());
}

/// Diagnoses on one thread, without trying pairs.
inline Diagnosis diagnosed(const SceneDocument& document, const Picture& picture) {
    return diagnose(document, picture, {.threads = 1});
}

/// Whether the first candidate explains the picture and consists of these mistakes or gives the same picture.
/// A mistake that removes a term or light is named second, because a missing term is the simpler explanation.
/// A mistake that is a convention of many programs is reported as a convention.
inline bool is_named(const Diagnosis& d, const MistakeSet& mistakes) {
    if (d.verdict == Verdict::NoMistake && d.conventions.size() == 1)
        return d.conventions.front().starts_with(name_of(mistakes) + ":");
    if (!is_explained(d.verdict)) return false;
    const Candidate& first = d.candidates.front();
    return first.mistakes == mistakes ||
           std::find(first.also.begin(), first.also.end(), mistakes) != first.also.end() ||
           std::find(first.also_named.begin(), first.also_named.end(), name_of(mistakes)) !=
               first.also_named.end();
}

/// The --set options of the first candidate, separated by spaces.
inline std::string settings_of(const Diagnosis& d) {
    std::string all;
    if (d.candidates.empty()) return all;
    for (const std::string& set : d.candidates.front().options()) all += (all.empty() ? "" : " ") + set;
    return all;
}

struct WrongPicture {
    Picture picture;
    std::string what;      // the change at the display
    bool differs = false;  // whether it visibly differs from the correct one
};

inline Picture turned_over(const Picture& picture, bool upside_down, bool mirrored) {
    Picture turned = picture;
    DisplayChange change;
    change.upside_down = upside_down;
    change.mirrored = mirrored;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                turned.rgba[4 * changed_index(change, picture.size, x, y) + c] =
                    picture.rgba[4 * picture.pixel(x, y) + c];
    return turned;
}

/// Applies a function on [0, 1] to every channel.
template <class Curve> Picture through(Picture picture, const Curve& curve) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) {
            const double x = curve(double(picture.rgba[i]) / 255);
            picture.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
        }
    return picture;
}

/// IEC 61966-2-1, implemented independently.
inline double srgb_of_linear(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

inline Picture picture_under(const Scene& scene, const MistakeSet& mistakes) {
    Renderer renderer(1);
    return renderer.render(under_mistakes(scene, mistakes), diagnosed_size);
}

/// Whether the difference is visible.
inline bool differ(const Picture& a, const Picture& b) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            most = std::max(most, std::abs(int{a.rgba[c]} - int{b.rgba[c]}));
        differing += most > 3 ? 1 : 0;
    }
    return differing >= 30;
}

/// Returns the picture unchanged half of the time; otherwise brightened, flipped or encoded.
inline WrongPicture displayed_somehow(const Picture& picture, unsigned seed) {
    WrongPicture wrong{picture, "unchanged", false};
    std::mt19937 random(seed);
    switch (random() % 6) {
    case 0: {
        const double gain = double(uniform(random, 0.4f, 1.6f));
        wrong.what = "gain " + std::to_string(gain);
        wrong.picture = through(picture, [gain](double x) { return gain * x; });
        break;
    }
    case 1:
        wrong.what = "flipped";
        wrong.picture = turned_over(picture, random() % 2 == 0, true);
        break;
    case 2:
        wrong.what = "sRGB";
        wrong.picture = through(picture, srgb_of_linear);
        break;
    default:
        break;
    }
    return wrong;
}

inline WrongPicture wrong_picture(const Scene& scene, const MistakeSet& mistakes, unsigned seed) {
    const Picture picture = picture_under(scene, mistakes);
    WrongPicture wrong = displayed_somehow(picture, seed);
    wrong.differs = differ(picture, picture_under(scene, {}));
    return wrong;
}

}  // namespace glint::test
