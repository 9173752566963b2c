#include "ui/fields/highlight_share.h"

#include <fmt/core.h>

#include <algorithm>

#include "renderer/renderer.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double least_highlight = 0.02;  // of the display's range; anything fainter counts as no highlight
constexpr double back = 0.95;             // above this share the highlight looks complete
constexpr int shown_width = 320;          // of the picture used for measuring

/// The object alone, lit only by its specular term.
Scene specular_alone(Scene scene, std::size_t object) {
    const Object kept = scene.objects[object];
    scene.objects = {kept};
    scene.global_ambient = glm::vec3(0);
    scene.display.background = glm::vec3(0);
    scene.npr = {};
    scene.transport = {};
    scene.shading.terms = {.emission = false, .ambient = false, .diffuse = false, .specular = true};
    return scene;
}

double brightest(Renderer& renderer, const Scene& scene, PictureSize size) {
    const Picture& picture = renderer.render(scene, size, true);
    const auto most = std::max_element(picture.linear.begin(), picture.linear.end());
    return most == picture.linear.end() ? 0 : double{*most};
}

}  // namespace

std::optional<double> highlight_share(const Scene& scene, std::size_t object, PictureSize size) {
    Renderer renderer(1);
    Scene alone = specular_alone(scene, object);
    const double kept = brightest(renderer, alone, size);
    alone.shading.mode = ShadingMode::Phong;
    const double whole = brightest(renderer, alone, size);
    if (whole < least_highlight) return std::nullopt;
    return kept / whole;
}

std::string highlight_words(HighlightShareState& state, const Scene& scene, std::size_t object,
                            PictureSize size) {
    const ShadingMode mode = scene.shading.mode;
    const bool lights_corners = mode == ShadingMode::Flat || mode == ShadingMode::Gouraud;
    if (!lights_corners || !scene.objects[object].mesh || !scene.objects[object].visible) return {};
    const int width = std::min(shown_width, size.width);
    const PictureSize small{width, std::max(1, width * size.height / size.width)};
    update_at_rest(state.share, {scene, object}, [&] { return highlight_share(scene, object, small); });
    const std::optional<double>* share = state.share.value();
    if (share == nullptr || !*share) return {};
    return fmt::format("Highlight: {:.2f} of what Phong shading shows{}", **share,
                       **share >= back ? ", it is all there" : "");
}

}  // namespace glint
