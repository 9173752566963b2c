#include "renderer/debug_views/buffers.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>

#include "models/memory_limit.h"
#include "models/scene/scene.h"

namespace glint {
namespace {

using OfPixel = std::function<glm::vec3(const Explanation&)>;
using OfPoint = std::function<glm::vec3(const ExplainedPoint&)>;
using OfLight = glm::vec3 (*)(const ExplainedLight&);

struct Buffer {
    std::string name;
    OfPixel value;
    bool of_background = false;  // else computed only for pixels that show a surface
};

/// Blended over the lit points.
OfPixel of_lit_points(const OfPoint& value) {
    return [value](const Explanation& e) {
        if (!e.lit_per_corner) return value(e.at);
        glm::vec3 blended(0);
        for (const ExplainedCorner& corner : e.corners) blended += corner.weight * value(corner.at);
        return blended;
    };
}

OfPixel of_light(int index, OfLight value) {
    return of_lit_points([index, value](const ExplainedPoint& at) {
        const auto light = std::lower_bound(at.lights.begin(), at.lights.end(), index,
                                            [](const ExplainedLight& l, int i) { return l.index < i; });
        return light != at.lights.end() && light->index == index ? value(*light) : glm::vec3(0);
    });
}

OfPixel of_all_lights(OfLight value) {
    return of_lit_points([value](const ExplainedPoint& at) {
        glm::vec3 sum(0);
        for (const ExplainedLight& light : at.lights) sum += value(light);
        return sum;
    });
}

glm::vec3 ambient_of(const ExplainedLight& light) { return light.ambient; }
glm::vec3 diffuse_of(const ExplainedLight& light) { return light.diffuse; }
glm::vec3 specular_of(const ExplainedLight& light) { return light.specular; }

void add_geometry(std::vector<Buffer>& all) {
    all.push_back({"face", [](const Explanation& e) {
                       return glm::vec3(1, static_cast<float>(e.object_index), static_cast<float>(e.face));
                   }});
    all.push_back({"position", [](const Explanation& e) { return e.at.point.camera; }});
    all.push_back({"depth", [](const Explanation& e) { return glm::vec3(-e.at.point.camera.z); }});
    all.push_back({"normal", [](const Explanation& e) { return e.at.normal.camera; }});
    all.push_back({"side", [](const Explanation& e) { return glm::vec3(e.front_facing ? 1 : -1); }});
}

template <class Add> void for_each_enabled(const Scene& scene, const Add& add) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled) add(scene.lights[i], static_cast<int>(i), fmt::format("_{}", i));
}

// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks): it does not see that a std::function inside another
// frees its memory.
void add_directions(std::vector<Buffer>& all, const Scene& scene) {
    all.push_back({"view", of_lit_points([](const ExplainedPoint& at) { return at.view.camera; })});
    for_each_enabled(scene, [&all](const Light& light, int i, const std::string& number) {
        if (light.kind == LightKind::Area) return;
        all.push_back({"l" + number, of_light(i, [](const ExplainedLight& e) { return e.l.camera; })});
        all.push_back(
            {"n_dot_l" + number, of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.n_dot_l); })});
        if (light.kind != LightKind::Directional) {
            all.push_back({"distance" + number,
                           of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.distance); })});
            all.push_back({"falloff" + number,
                           of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.falloff); })});
        }
        if (light.kind == LightKind::Spot)
            all.push_back(
                {"cone" + number, of_light(i, [](const ExplainedLight& e) { return glm::vec3(e.spot); })});
        all.push_back({"r" + number, of_light(i, [](const ExplainedLight& e) { return e.r.camera; })});
        all.push_back({"h" + number, of_light(i, [](const ExplainedLight& e) { return e.h.camera; })});
    });
}

void add_terms(std::vector<Buffer>& all, const Scene& scene) {
    all.push_back({"emission", of_lit_points([](const ExplainedPoint& at) { return at.emission; })});
    all.push_back(
        {"global_ambient", of_lit_points([](const ExplainedPoint& at) { return at.global_ambient; })});
    if (scene.transport.model == TransportModel::Bounces)
        all.push_back({"bounced", of_lit_points([](const ExplainedPoint& at) { return at.bounces.term; })});
    for_each_enabled(scene, [&all](const Light&, int i, const std::string& number) {
        all.push_back({"ambient" + number, of_light(i, ambient_of)});
        all.push_back({"diffuse" + number, of_light(i, diffuse_of)});
        all.push_back({"specular" + number, of_light(i, specular_of)});
    });
    all.push_back({"ambient", of_all_lights(ambient_of)});
    all.push_back({"diffuse", of_all_lights(diffuse_of)});
    all.push_back({"specular", of_all_lights(specular_of)});
    all.push_back({"sum", [](const Explanation& e) { return e.sum; }, true});
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

std::vector<Buffer> all_buffers(const Scene& scene) {
    std::vector<Buffer> all;
    add_geometry(all);
    add_directions(all, scene);
    add_terms(all, scene);
    return all;
}

}  // namespace

std::vector<std::string> buffer_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Buffer& buffer : all_buffers(scene)) names.push_back(buffer.name);
    return names;
}

std::size_t buffers_at_once(PictureSize size, std::size_t all) {
    constexpr std::uint64_t fewest = 12, most_times = 8, room = std::uint64_t{64} << 20;
    return std::max({fewest, room / buffers_memory(size, 1), (all + most_times - 1) / most_times});
}

std::uint64_t buffers_memory(PictureSize size, std::size_t buffers) {
    return std::uint64_t{buffers} * 3 * sizeof(float) * size.pixels();
}

std::vector<PixelBuffer> pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                                       const std::vector<std::string>& names) {
    std::vector<Buffer> wanted = all_buffers(scene);
    const std::set<std::string_view> named(names.begin(), names.end());
    std::erase_if(wanted, [&named](const Buffer& b) { return named.count(b.name) == 0; });
    std::vector<PixelBuffer> buffers;
    buffers.reserve(wanted.size());
    for (const Buffer& b : wanted)
        buffers.push_back({b.name, {size, {}, std::vector(3 * size.pixels(), 0.0f)}});
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const Explanation e = renderer.explain(x, y);
            for (std::size_t i = 0; i < wanted.size(); ++i) {
                if (!e.hit && !wanted[i].of_background) continue;
                const glm::vec3 value = wanted[i].value(e);
                float* to = &buffers[i].picture.linear[3 * buffers[i].picture.pixel(x, y)];
                for (int c = 0; c < 3; ++c) to[c] = value[c];
            }
        }
    });
    return buffers;
}

void visit_pixel_buffers(const Renderer& renderer, const Scene& scene, PictureSize size,
                         const std::vector<std::string>& names,
                         const std::function<bool(const PixelBuffer&)>& visit) {
    const std::size_t at_once = std::min(buffers_at_once(size, names.size()), names.size());
    if (const auto problem = too_much_memory({.picture = buffers_memory(size, at_once)}))
        throw LimitExceeded(*problem);
    for (std::size_t from = 0; from < names.size(); from += at_once) {
        const auto first = names.begin() + static_cast<std::ptrdiff_t>(from);
        const std::vector<std::string> some(
            first, first + static_cast<std::ptrdiff_t>(std::min(at_once, names.size() - from)));
        for (const PixelBuffer& buffer : pixel_buffers(renderer, scene, size, some))
            if (!visit(buffer)) return;
    }
}

}  // namespace glint
