// Single rays and paths of the picture's lit points.
#include <algorithm>
#include <optional>

#include "renderer/explain/explain.h"

namespace glint {
namespace {

/// The lit point of a pixel, or nullopt for background. `corner` as in Renderer::shadow_rays().
std::optional<TracedPoint> drawn_point(const KeptStages& stages, int x, int y, int corner) {
    const std::size_t pixel = stages.lighting.picture.pixel(x, y);
    if (stages.visibility.triangle_at(pixel) == no_triangle) return std::nullopt;
    const LitPointFinder finder{stages.transport.rays, stages.geometry, world_from_view(stages.scene.camera)};
    const SurfaceChoice& choice = stages.surface.choice;
    const SampleFace face = sample_face(choice, stages.geometry, stages.visibility, x, y);
    if (choice.kind == SurfaceKind::Pixels)
        return finder.pixel(stages.surface, face, pixel, pixel_point(stages.surface, stages.geometry, face));
    const BlendedPoints points = blended_points(stages.surface, stages.geometry, face);
    const auto begin = points.weight.begin();
    const auto heaviest = std::max_element(begin, begin + points.count) - begin;
    const bool is_corner = corner >= 0 && corner < points.count;
    const ShadingPoint& source = points.point[static_cast<std::size_t>(is_corner ? corner : heaviest)];
    return finder.item(choice, source, lit_point(stages.surface, stages.geometry, source));
}

}  // namespace

std::vector<TracedLight> trace_lights(KeptStages& stages, int x, int y, int corner) {
    stages.transport.rays.update(stages.scene);
    const std::optional<TracedPoint> point = drawn_point(stages, x, y, corner);
    if (!point) return {};
    const TransportInputs inputs = transport_inputs(stages.scene);
    std::vector<TracedLight> rays;
    for (std::size_t i = 0; i + 1 < inputs.begins.size(); ++i) {
        const std::uint32_t middle = (inputs.begins[i] + inputs.begins[i + 1]) / 2;
        rays.push_back(traced_light(stages.transport.rays, inputs.lights[middle], *point));
    }
    return rays;
}

std::vector<PathStep> trace_path(KeptStages& stages, int x, int y, int path, int corner) {
    stages.transport.rays.update(stages.scene);
    std::vector<PathStep> steps;
    if (const std::optional<TracedPoint> point = drawn_point(stages, x, y, corner))
        (void)radiance_of_path(stages.transport.rays, transport_inputs(stages.scene), *point, path, &steps);
    return steps;
}

}  // namespace glint
