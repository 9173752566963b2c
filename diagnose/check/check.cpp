#include "diagnose/check/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "diagnose/search/probes.h"
#include "diagnose/search/supposition.h"
#include "models/json/json.h"
#include "renderer/threads.h"

namespace glint {
namespace {

/// A pixel differs if a number differs by more than this fraction of its magnitude, or of 1 if that is
/// larger: other programs round and interpolate in float.
constexpr float tolerance = 4e-3f;

float off(glm::vec3 mine, glm::vec3 ours) {
    float most = 0;
    for (int c = 0; c < 3; ++c) {
        const float d = std::abs(mine[c] - ours[c]) / std::max(1.0f, std::abs(ours[c]));
        most = std::max(most, std::isnan(d) ? HUGE_VALF : d);
    }
    return most;
}

/// Describes how a buffer differs; returns nothing if at most one pixel in a hundred differs.
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

ReadAt read_at(const ExplainedPoint& point, double weight, const Scene& scene, int light,
               const Object& object) {
    ReadAt at;
    at.weight = weight;
    at.position = point.point.camera;
    at.normal = point.normal.camera;
    at.view = point.view.camera;
    at.world_from_object = world_from_object(object.transform);
    for (const ExplainedLight& l : point.lights) {
        if (l.index != light) continue;
        const Light& given = scene.lights[static_cast<std::size_t>(light)];
        at.to_light = l.l.camera;
        at.distance = double(l.distance);
        at.falloff = {given.falloff.constant, given.falloff.linear, given.falloff.quadratic};
        at.cutoff_deg = double(given.spot.cutoff_deg);
        at.exponent = double(given.spot.exponent);
        at.axis = glm::normalize(glm::dvec3(given.spot.direction));
        if (given.space == LightSpace::World) at.axis = glm::dmat3(view_from_world(scene.camera)) * at.axis;
    }
    return at;
}

/// The points from which a buffer's numbers at a pixel are computed: the points that were lit, or, for a
/// buffer of geometry, the pixel's own point.
std::vector<ReadAt> read_at(const Explanation& e, BufferKind kind, const Scene& scene, int light) {
    const Object& object = scene.objects[static_cast<std::size_t>(e.object_index)];
    const bool is_geometry =
        kind == BufferKind::Point || kind == BufferKind::Depth || kind == BufferKind::Normal;
    if (is_geometry || !e.lit_per_corner) return {read_at(e.at, 1, scene, light, object)};
    std::vector<ReadAt> all;
    for (const ExplainedCorner& c : e.corners)
        all.push_back(read_at(c.at, double(c.weight), scene, light, object));
    return all;
}

/// A sample of the comparable pixels.
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
            points.push_back({mine.linear_at(x, y), ours.linear_at(x, y),
                              read_at(e, buffer_kind(name), scene, buffer_light(name))});
        }
    return points;
}

/// The given buffers in the order in which a program computes them.
std::vector<const PixelBuffer*> in_order(const std::vector<PixelBuffer>& given, const Scene& scene) {
    std::vector<const PixelBuffer*> ordered;
    for (const std::string& name : checked_buffers(scene)) {
        const auto at = std::find_if(given.begin(), given.end(),
                                     [&name](const PixelBuffer& b) { return b.name == name; });
        if (at != given.end()) ordered.push_back(&*at);
    }
    return ordered;
}

Picture turned_over(const Picture& picture) {
    Picture turned = picture;
    const std::ptrdiff_t row = std::ptrdiff_t{3} * picture.size.width;
    for (int y = 0; y < picture.size.height; ++y)
        std::copy_n(picture.linear.begin() + row * y, row,
                    turned.linear.begin() + row * (picture.size.height - 1 - y));
    return turned;
}

/// Transforms the vectors in the buffers from world to camera coordinates.
void move_to_camera(std::vector<PixelBuffer>& buffers, const Camera& camera) {
    const glm::mat4 m(view_from_world(camera));
    for (PixelBuffer& b : buffers) {
        const BufferKind kind = buffer_kind(b.name);
        const bool is_point = kind == BufferKind::Point;
        const bool is_direction = kind == BufferKind::Normal || kind == BufferKind::View ||
                                  kind == BufferKind::ToLight || kind == BufferKind::Mirrored ||
                                  kind == BufferKind::Halfway;
        for (std::size_t i = 0; (is_point || is_direction) && i < b.picture.linear.size(); i += 3) {
            float* const at = &b.picture.linear[i];
            const glm::vec3 moved(m * glm::vec4(at[0], at[1], at[2], is_point ? 1 : 0));
            std::copy_n(&moved.x, 3, at);
        }
    }
}

/// Compares the buffers with those of a scene, up to the first that differs by more than the length of its
/// vectors or the clamping of its cosines. Does not describe a difference in the buffer `unread`.
BufferCheck checked(const Scene& scene, const std::vector<PixelBuffer>& given, int threads,
                    const std::string& unread = {}) {
    BufferCheck check;
    check.size = given.front().picture.size;
    Renderer renderer(threads);
    (void)renderer.render(scene, check.size, true);
    const std::vector<PixelKind> kinds = pixel_kinds(renderer, check.size);
    check.compared = static_cast<std::size_t>(std::count(kinds.begin(), kinds.end(), PixelKind::Surface));
    if (check.compared == 0) return check;
    const std::vector<const PixelBuffer*> in_turn = in_order(given, scene);
    std::vector<std::string> names;
    names.reserve(in_turn.size());
    for (const PixelBuffer* mine : in_turn) names.push_back(mine->name);
    std::size_t number = 0;
    const CheckFrames frames{view_from_world(scene.camera),
                             clip_from_view(scene.camera.projection, check.size)};
    visit_pixel_buffers(renderer, scene, check.size, names, [&](const PixelBuffer& ours) {
        const PixelBuffer& mine = *in_turn[number++];
        check.differs = difference(mine.picture, ours.picture, mine.name, kinds);
        if (!check.differs) {
            check.agree.push_back(mine.name);
            return true;
        }
        if (mine.name == unread) return false;
        if (!difference(turned_over(mine.picture), ours.picture, mine.name, kinds)) {
            check.differs->found =
                "ours with the rows from top to bottom; files must start with the bottom row";
            return false;
        }
        check.differs->found =
            reading_of(buffer_kind(mine.name),
                       read_points(renderer, scene, mine.name, mine.picture, ours.picture, kinds), frames);
        const std::string& found = check.differs->found;
        if (found != "ours, not of length 1" && found != "ours, 0 where it is negative") return false;
        check.conventions.push_back(mine.name + ": " + found);
        check.differs.reset();
        return true;
    });
    return check;
}

/// Compares the buffers with those of the scene, and with those under each convention that makes more buffers
/// agree.
BufferCheck checked_by_conventions(Scene scene, const std::vector<PixelBuffer>& given, int threads) {
    BufferCheck best = checked(scene, given, threads);
    // Conventions change normals, v and highlights. A reading that matches the wrong normals is more certain
    // than a convention.
    const auto may_be_convention = [&best] {
        if (!best.differs) return false;
        const BufferKind kind = buffer_kind(best.differs->name);
        return (kind == BufferKind::Normal && best.differs->found.empty()) || kind == BufferKind::View ||
               best.differs->name.starts_with("specular");
    };
    for (bool better = may_be_convention(); better;) {
        better = false;
        for (const Convention& convention : conventions_of(scene)) {
            Scene other = scene;
            convention.edit(other);
            BufferCheck check = checked(other, given, threads, best.differs->name);
            if (check.agree.size() <= best.agree.size()) continue;
            check.conventions.insert(check.conventions.begin(), best.conventions.begin(),
                                     best.conventions.end());
            check.conventions.push_back(convention.name + ": " + convention.words);
            best = std::move(check);
            scene = other;
            better = may_be_convention();
            break;
        }
    }
    return best;
}

std::string text_of(glm::vec3 v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

}  // namespace

std::vector<std::string> checked_buffers(const Scene& scene) {
    std::vector<std::string> names = buffer_names(scene);
    names.erase(std::remove(names.begin(), names.end(), "face"), names.end());
    return names;
}

BufferCheck check_buffers(const SceneDocument& document, const std::vector<PixelBuffer>& given, int threads,
                          bool in_world) {
    tbb::task_arena arena(arena_threads(threads));
    BufferCheck check;
    arena.execute([&] {
        std::vector<PixelBuffer> buffers = given;
        if (in_world) move_to_camera(buffers, document.scene.camera);
        check = checked_by_conventions(under_mistakes(document.scene, {}), buffers, threads);
    });
    return check;
}

std::string check_text(const BufferCheck& check) {
    std::string text;
    if (!check.agree.empty()) text += fmt::format("These agree: {}.\n", fmt::join(check.agree, ", "));
    for (const std::string& convention : check.conventions)
        text += "A convention, not a mistake: " + convention + ".\n";
    if (!check.differs)
        return text + (check.conventions.empty() ? "Nothing" : "Nothing else") + " differs.\n";
    const BufferDifference& d = *check.differs;
    text += fmt::format(
        "{} is the first that differs, in {:.0f} % of the pixels: at {},{} yours is {}, ours is {}.\n",
        d.name, 100 * d.share, d.pixel.x, d.pixel.y, text_of(d.mine), text_of(d.ours));
    text += d.found.empty() ? "No transform that was tried turns one into the other.\n"
                            : fmt::format("Yours are {}.\n", d.found);
    return text;
}

std::string check_json(const BufferCheck& check) {
    Json json;
    json["width"] = check.size.width;
    json["height"] = check.size.height;
    json["agree"] = check.agree;
    json["conventions"] = check.conventions;
    Json& differs = json["differs"];
    if (check.differs) {
        const BufferDifference& d = *check.differs;
        differs["buffer"] = d.name;
        differs["share"] = d.share;
        differs["pixel"] = Json{d.pixel.x, d.pixel.y};
        differs["mine"] = json_of(d.mine);
        differs["ours"] = json_of(d.ours);
        differs["found"] = d.found;
    }
    return json_text(json);
}

}  // namespace glint
