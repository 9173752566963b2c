#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "diagnose/diagnose.h"
#include "models/numbers.h"
#include "models/progress.h"

namespace glint {
namespace {

constexpr std::size_t most_lights = 8, most_objects = 4;

/// Three decimals, so that the line can be typed.
float short_number(float x) { return std::round(x * 1000) / 1000; }

std::string vector_text(glm::vec3 v) {
    return fmt::format("[{},{},{}]", number_text(short_number(v.x)), number_text(short_number(v.y)),
                       number_text(short_number(v.z)));
}

glm::vec3 turned(glm::vec3 v, float degrees, glm::vec3 axis) {
    return glm::vec3(glm::rotate(glm::mat4(1), glm::radians(degrees), axis) * glm::vec4(v, 0));
}

using Changes = std::vector<Assignment>;

void add_camera(Changes& changes, const Camera& camera) {
    const glm::vec3 arm = camera.eye - camera.target, up = glm::normalize(camera.up);
    const glm::vec3 side = glm::normalize(glm::cross(up, arm));
    for (const float degrees : {-60.0f, -30.0f, 30.0f, 60.0f})
        changes.push_back({"/camera/eye", vector_text(camera.target + turned(arm, degrees, up))});
    for (const float degrees : {-30.0f, 30.0f})
        changes.push_back({"/camera/eye", vector_text(camera.target + turned(arm, degrees, side))});
}

void add_light(Changes& changes, const Light& light, std::size_t index) {
    const auto at = [&](const char* key) { return fmt::format("/lights/{}/{}", index, key); };
    const glm::vec3 position(light.position);
    for (const float degrees : {-90.0f, -45.0f, 45.0f, 90.0f})
        changes.push_back({at("position"), vector_text(turned(position, degrees, {0, 1, 0}))});
    for (const float degrees : {-60.0f, 60.0f})
        changes.push_back({at("position"), vector_text(turned(position, degrees, {1, 0, 0}))});
    for (const float share : {0.5f, 2.0f}) {
        changes.push_back({at("position"), vector_text(share * position)});
        changes.push_back({at("intensity"), number_text(short_number(share * light.intensity))});
    }
    changes.push_back({at("space"), light.space == LightSpace::World ? "camera" : "world"});
    if (light.kind == LightKind::Directional || light.kind == LightKind::Area) return;
    for (const char* quadratic : {"0.1", "0.5"}) changes.push_back({at("falloff/quadratic"), quadratic});
    changes.push_back({at("falloff/constant"), "0.5"});
    if (light.kind != LightKind::Spot) return;
    for (const float share : {0.5f, 1.5f})
        changes.push_back({at("spot/cutoff_deg"),
                           number_text(short_number(std::min(90.0f, share * light.spot.cutoff_deg)))});
}

void add_material(Changes& changes, const Material& material, std::size_t index) {
    const auto at = [&](const char* key) { return fmt::format("/objects/{}/material/{}", index, key); };
    for (const float share : {0.25f, 4.0f})
        changes.push_back(
            {at("shininess"), number_text(short_number(std::max(1.0f, share * material.shininess)))});
    changes.push_back({at("specular"), "[1,1,1]"});
    changes.push_back({at("specular"), "[0,0,0]"});
    changes.push_back({at("ambient"), "[0.5,0.5,0.5]"});
    changes.push_back({at("diffuse"), "[0.5,0.5,0.5]"});
}

Changes changes_of(const Scene& scene) {
    Changes changes;
    add_camera(changes, scene.camera);
    for (std::size_t i = 0; i < std::min(scene.lights.size(), most_lights); ++i)
        if (scene.lights[i].enabled) add_light(changes, scene.lights[i], i);
    for (std::size_t i = 0; i < std::min(scene.objects.size(), most_objects); ++i)
        add_material(changes, scene.objects[i].material, i);
    return changes;
}

int channels_apart(const Picture& a, const Picture& b, std::size_t pixel) {
    int sum = 0;
    for (std::size_t c = 4 * pixel; c < 4 * pixel + 3; ++c) sum += std::abs(int{a.rgba[c]} - int{b.rgba[c]});
    return sum;
}

/// The difference, at a pixel, of the two most similar pictures there.
int least_apart_at(const std::vector<Picture>& pictures, std::size_t pixel) {
    int least = channels_apart(pictures[0], pictures[1], pixel);
    for (std::size_t i = 2; i < pictures.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            least = std::min(least, channels_apart(pictures[k], pictures[i], pixel));
    return least;
}

/// The pixel at which, with its neighbours, the two most similar pictures differ most: a pixel on an
/// outline or on a highlight's rim might look different in a program that rounds otherwise.
glm::ivec2 telling_pixel(const std::vector<Picture>& pictures) {
    const PictureSize size = pictures[0].size;
    std::vector<int> least(size.pixels());
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = least_apart_at(pictures, i);
    const auto least_around = [&](int x, int y) {
        int around = least[size.index(x, y)];
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.width - 1); ++u)
                around = std::min(around, least[size.index(u, v)]);
        return around;
    };
    glm::ivec2 best{0};
    std::pair<int, int> most{-1, -1};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::pair here{least_around(x, y), least[size.index(x, y)]};
            if (here <= most) continue;
            most = here;
            best = {x, y};
        }
    return best;
}

/// RMS of the differences over all pixels, in levels.
double apart(const Picture& a, const Picture& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int d = int{a.rgba[i]} - int{b.rgba[i]};
        sum += static_cast<std::uint32_t>(d * d);
    }
    return std::sqrt(static_cast<double>(sum) / static_cast<double>(3 * a.size.pixels()));
}

std::vector<Picture> drawn_under(Renderer& renderer, const Scene& scene, PictureSize size,
                                 const std::vector<MistakeSet>& mistakes) {
    std::vector<Picture> pictures;
    pictures.reserve(mistakes.size());
    for (const MistakeSet& set : mistakes)
        pictures.push_back(renderer.render(under_mistakes(scene, set), size));
    return pictures;
}

/// The difference of the two most similar pictures.
double least_apart(const std::vector<Picture>& pictures) {
    double least = apart(pictures[0], pictures[1]);
    for (std::size_t a = 0; a < pictures.size(); ++a)
        for (std::size_t b = a + 1; b < pictures.size(); ++b)
            least = std::min(least, apart(pictures[a], pictures[b]));
    return least;
}

PictureSize small_size(PictureSize size) {
    constexpr int height = 72;
    const int h = std::min(height, size.height);
    return {std::clamp(size.width * h / size.height, 1, 4 * height), h};
}

Experiment shown_at_full_size(Renderer& renderer, const Scene& scene, PictureSize size,
                              const std::vector<MistakeSet>& mistakes, const Assignment& set) {
    const std::vector<Picture> pictures = drawn_under(renderer, scene, size, mistakes);
    Experiment experiment{{set}, telling_pixel(pictures), mistakes, {}};
    const std::size_t pixel = size.index(experiment.pixel.x, experiment.pixel.y);
    for (const Picture& picture : pictures) experiment.shows.push_back(rgb_at(picture, pixel));
    return experiment;
}

}  // namespace

std::optional<Experiment> find_experiment(const SceneDocument& document, PictureSize size,
                                          const std::vector<MistakeSet>& mistakes, int threads) {
    constexpr double least_levels = 1;
    if (mistakes.size() < 2) return std::nullopt;
    Renderer renderer(threads);
    const SceneVariants variants(document);
    std::optional<Assignment> best;
    Scene best_scene;
    double most = least_levels;
    for (const Assignment& change : changes_of(document.scene)) {
        if (load_cancelled()) throw LoadCancelled();
        Result<Scene> varied = variants.with({change});
        if (problem_of(varied) != nullptr) continue;
        const Scene& scene = std::get<Scene>(varied);
        const double far = least_apart(drawn_under(renderer, scene, small_size(size), mistakes));
        if (far <= most) continue;
        most = far;
        best = change;
        best_scene = scene;
    }
    if (!best) return std::nullopt;
    return shown_at_full_size(renderer, best_scene, size, mistakes, *best);
}

}  // namespace glint
