#pragma once
// The lecture's scenes (assets/scenes), opened for tests, and the pixel at which a world-space point appears.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"

namespace glint::test {

inline Scene lecture_scene(const std::string& name, const std::vector<Assignment>& assignments = {}) {
    const auto document = open_document(project_file("assets/scenes/") + name + ".json", assignments);
    if (const Problem* problem = problem_of(document)) FAIL(problem->text());
    return std::get<SceneDocument>(document).scene;
}

/// The pixel at which a world-space point appears. Precondition: the point is in the picture.
inline glm::ivec2 pixel_of(const Camera& camera, PictureSize size, glm::dvec3 place) {
    const glm::dvec4 clip =
        clip_from_view(camera.projection, size) * view_from_world(camera) * glm::dvec4(place, 1);
    return {static_cast<int>(std::floor((clip.x / clip.w + 1) / 2 * size.width)),
            static_cast<int>(std::floor((1 - clip.y / clip.w) / 2 * size.height))};
}

/// A drawn scene that can be explained.
class Drawn {
  public:
    explicit Drawn(Scene scene, PictureSize size = {320, 180}) : scene_(std::move(scene)), size_(size) {
        picture_ = &renderer_.render(scene_, size_, true);
    }
    [[nodiscard]] Explanation at(int x, int y) const { return renderer_.explain(x, y); }
    [[nodiscard]] Explanation at(glm::dvec3 place) const {
        const glm::ivec2 p = pixel_of(scene_.camera, size_, place);
        return at(p.x, p.y);
    }
    [[nodiscard]] glm::vec3 colour(glm::dvec3 place) const {
        const glm::ivec2 p = pixel_of(scene_.camera, size_, place);
        return picture_->linear_at(p.x, p.y);
    }
    /// Calls f(explanation) for every step-th pixel of object `index`.
    template <class F> int for_each_of(int index, int step, F f) const {
        int seen = 0;
        for (int y = step / 2; y < size_.height; y += step)
            for (int x = step / 2; x < size_.width; x += step)
                if (renderer_.object_at(x, y) == index) {
                    ++seen;
                    f(renderer_.explain(x, y));
                }
        return seen;
    }
    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Renderer& renderer() const { return renderer_; }
    [[nodiscard]] const Picture& picture() const { return *picture_; }

  private:
    Scene scene_;
    PictureSize size_;
    Renderer renderer_{1};
    const Picture* picture_;
};

}  // namespace glint::test
