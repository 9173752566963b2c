#include "diagnose/check/check.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "diagnose/check/readings.h"
#include "diagnose/search/comparable.h"
#include "diagnose/search/mistake_set.h"
#include "renderer/threads.h"

namespace glint {
namespace {

/// A pixel differs when a number does by more than this share of its size, or of 1 where it is smaller: other
/// programs round and interpolate in float.
constexpr float tolerance = 4e-3f;

float off(glm::vec3 mine, glm::vec3 ours) {
    float most = 0;
    for (int c = 0; c < 3; ++c) {
        const float d = std::abs(mine[c] - ours[c]) / std::max(1.0f, std::abs(ours[c]));
        most = std::max(most, std::isnan(d) ? HUGE_VALF : d);
    }
    return most;
}

/// Returns how a buffer differs; nothing where at most one pixel in a hundred does.
std::optional<BufferDifference> difference(const Picture& mine, const Picture& ours, const std::string& name,
                                           const std::vector<PixelKind>& kinds) {
    constexpr double most_share = 0.01;
    BufferDifference found;
    found.name = name;
    std::size_t compared = 0, differing = 0;
    float most = tolerance;
    for (int y = 0; y < ours.size.height; ++y)
        for (int x = 0; x < ours.size.width; ++x) {
            if (kinds[ours.pixel(x, y)] != PixelKind::Surface) continue;
            ++compared;
            const float here = off(mine.linear_at(x, y), ours.linear_at(x, y));
            differing += here > tolerance ? 1 : 0;
            if (here <= most) continue;
            most = here;
            found.pixel = {x, y};
        }
    found.share = compared == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(compared);
    if (found.share <= most_share) return std::nullopt;
    found.mine = mine.linear_at(found.pixel.x, found.pixel.y);
    found.ours = ours.linear_at(found.pixel.x, found.pixel.y);
    return found;
}

ReadAt read_at(const ExplainedPoint& point, double weight, int light, const glm::dmat4& world_from_object) {
    ReadAt at{weight, point.point.camera, point.normal.camera, point.view.camera, {}, 0, world_from_object};
    for (const ExplainedLight& l : point.lights) {
        if (l.index != light) continue;
        at.to_light = l.l.camera;
        at.distance = double(l.distance);
    }
    return at;
}

/// What a buffer's numbers at a pixel come from: the points that were lit, or of geometry the pixel's own.
std::vector<ReadAt> read_at(const Explanation& e, BufferKind kind, int light, const Object& object) {
    const glm::dmat4 placed = world_from_object(object.transform);
    const bool is_geometry =
        kind == BufferKind::Point || kind == BufferKind::Depth || kind == BufferKind::Normal;
    if (is_geometry || !e.lit_per_corner) return {read_at(e.at, 1, light, placed)};
    std::vector<ReadAt> all;
    for (const ExplainedCorner& c : e.corners) all.push_back(read_at(c.at, double(c.weight), light, placed));
    return all;
}

/// Some of the comparable pixels.
std::vector<ReadPoint> read_points(const Renderer& renderer, const Scene& scene, const std::string& name,
                                   const Picture& mine, const Picture& ours,
                                   const std::vector<PixelKind>& kinds) {
    constexpr std::size_t enough = 2000;
    const auto all = static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PixelKind::Surface));
    const std::size_t step = std::max<std::size_t>(1, all / enough);
    std::vector<ReadPoint> points;
    std::size_t number = 0;
    for (int y = 0; y < mine.size.height; ++y)
        for (int x = 0; x < mine.size.width; ++x) {
            if (kinds[mine.pixel(x, y)] != PixelKind::Surface || number++ % step != 0) continue;
            const Explanation e = renderer.explain(x, y);
            const Object& object = scene.objects[static_cast<std::size_t>(e.object_index)];
            points.push_back({mine.linear_at(x, y), ours.linear_at(x, y),
                              read_at(e, buffer_kind(name), buffer_light(name), object)});
        }
    return points;
}

/// The given buffers in the order in which a program makes them.
std::vector<const PixelBuffer*> in_order(const std::vector<PixelBuffer>& given, const Scene& scene) {
    std::vector<const PixelBuffer*> ordered;
    for (const std::string& name : checked_buffers(scene)) {
        const auto at = std::find_if(given.begin(), given.end(),
                                     [&name](const PixelBuffer& b) { return b.name == name; });
        if (at != given.end()) ordered.push_back(&*at);
    }
    return ordered;
}

BufferCheck checked(const SceneDocument& document, const std::vector<PixelBuffer>& given, int threads) {
    BufferCheck check;
    check.size = given.front().picture.size;
    const Scene scene = under_mistakes(document.scene, {});
    Renderer renderer(threads);
    (void)renderer.render(scene, check.size, true);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, check.size);
    check.compared = static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PixelKind::Surface));
    if (check.compared == 0) return check;
    const std::vector<const PixelBuffer*> in_turn = in_order(given, scene);
    std::vector<std::string> names;
    names.reserve(in_turn.size());
    for (const PixelBuffer* mine : in_turn) names.push_back(mine->name);
    visit_pixel_buffers(renderer, scene, check.size, names, [&](const PixelBuffer& ours) {
        const PixelBuffer& mine = *in_turn[check.agree.size()];
        check.differs = difference(mine.picture, ours.picture, mine.name, kinds);
        if (!check.differs) {
            check.agree.push_back(mine.name);
            return true;
        }
        const CheckFrames frames{view_from_world(scene.camera),
                                 clip_from_view(scene.camera.projection, check.size)};
        check.differs->found =
            reading_of(buffer_kind(mine.name),
                       read_points(renderer, scene, mine.name, mine.picture, ours.picture, kinds), frames);
        return false;
    });
    return check;
}

}  // namespace

std::vector<std::string> checked_buffers(const Scene& scene) {
    std::vector<std::string> names = buffer_names(scene);
    names.erase(std::remove(names.begin(), names.end(), "face"), names.end());
    return names;
}

BufferCheck check_buffers(const SceneDocument& document, const std::vector<PixelBuffer>& given, int threads) {
    tbb::task_arena arena(arena_threads(threads));
    BufferCheck check;
    arena.execute([&] { check = checked(document, given, threads); });
    return check;
}

}  // namespace glint
