#pragma once
// Drawable scenes by seed: small scenes with everything that a scene file can contain, scaled by any power of
// ten from 1e-7 to 1e7.

#include <random>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// A scene and how to draw it.
struct StressCase {
    Scene scene;
    PictureSize size;
    int samples = 1;
};

class StressScenes {
  public:
    explicit StressScenes(unsigned seed) : random_(seed) {}

    /// The next scene. It occasionally breaks a rule of the scene file, for example with an eye at its
    /// target. Meshes are not loaded.
    StressCase next();
    /// Makes one change, as a user would: most often to a light, because the renderer reuses most while one
    /// is moved.
    void edit(Scene& scene);
    std::size_t below(std::size_t n) { return random_() % n; }

  private:
    bool one_in(std::size_t n) { return below(n) == 0; }
    bool wild() { return wild_ > 0 && one_in(wild_); }
    float between(double low, double high) {
        return static_cast<float>(low + (high - low) * static_cast<double>(random_()) / 4294967295.0);
    }
    template <class Enum> Enum one_of(std::size_t count) { return static_cast<Enum>(below(count)); }
    float stretch();
    float positive();
    float number() { return one_in(8) ? 0.0f : (one_in(2) ? positive() : -positive()); }
    float share();
    glm::vec3 vector() { return {number(), number(), number()}; }
    glm::vec3 around(double most) {
        return {between(-most, most), between(-most, most), between(-most, most)};
    }
    glm::vec3 color() { return {share(), share(), share()}; }

    Camera camera(float size);
    Projection projection(float size);
    Light light(float size);
    Object object(float size);
    Transform transform(float size);
    Material material();
    Shading shading();
    Npr npr();

    std::mt19937 random_;
    std::size_t wild_ = 0;  // one number in this many may have any value; 0: none
};

}  // namespace glint
