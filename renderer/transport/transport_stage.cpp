#include "renderer/transport/transport_stage.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/geometric.hpp>

#include "models/progress.h"

namespace glint {
namespace {

glm::dvec3 position_in_world(const glm::dmat4& world_from_view, const glm::vec3& p) {
    return glm::dvec3(world_from_view * glm::dvec4(glm::dvec3(p), 1));
}

/// A unit normal, or 0.
glm::dvec3 normal_in_world(const glm::dmat4& world_from_view, const glm::vec3& n) {
    const glm::dvec3 world(world_from_view * glm::dvec4(glm::dvec3(n), 0));
    const double length = glm::length(world);
    return length > 0 ? world / length : glm::dvec3(0);
}

/// The origin of rays on the polygon's triangle closest to the point p.
RayStart on_polygon(const RayScene& rays, const Mesh& mesh, std::uint32_t object, std::uint32_t face,
                    const glm::dvec3& p) {
    const auto first = std::lower_bound(mesh.triangles.begin(), mesh.triangles.end(), face,
                                        [](const Triangle& t, std::uint32_t f) { return t.face < f; });
    RayStart nearest;
    double least = HUGE_VAL;
    for (auto t = first; t != mesh.triangles.end() && t->face == face; ++t) {
        const RayStart start =
            rays.on_triangle({object, static_cast<std::uint32_t>(t - mesh.triangles.begin())}, p);
        const double away = glm::distance(glm::dvec3(start.p), p);
        if (away < least) nearest = start;
        least = std::min(least, away);
    }
    return nearest;
}

/// The lit points of a block. Bit i of `mask`: entry i of the block is a pixel, a corner or a face.
struct TracedBlock {
    unsigned mask = 0;
    std::array<TracedPoint, block_size> point;
};

/// The inputs of a running stage.
struct Run {
    TransportStage& kept;
    const Geometry& geometry;
    const Visibility& visibility;
    const Surface& surface;
    const PathProgress& progress;
    LitPointFinder points;
    const std::atomic<bool>* cancelled = load_cancellation();

    [[nodiscard]] bool is_cancelled() const { return cancelled != nullptr && *cancelled; }

    [[nodiscard]] PositionNormal place(std::size_t block, std::size_t lane) const {
        const PointBlock& b = surface.points[block];
        return {{b.x[lane], b.y[lane], b.z[lane]}, {b.nx[lane], b.ny[lane], b.nz[lane]}};
    }

    void trace_points(std::size_t block, TracedBlock& out) const {
        const bool pixels = surface.choice.kind == SurfaceKind::Pixels;
        const ShadingPoint* items =
            pixels ? nullptr : &surface.lit_points().shading_points[block * block_size];
        out.mask = 0;
        VisibleTriangle triangle;  // often shared by several neighbouring pixels
        for (unsigned lane = 0; lane < block_size; ++lane) {
            if (pixels ? !(surface.groups[block].mask >> lane & 1u) : items[lane].item == no_index) continue;
            out.mask |= 1u << lane;
            if (!pixels) {
                out.point[lane] = points.item(surface.choice, items[lane], place(block, lane));
                continue;
            }
            const SampleFace face = face_of_lane(surface, geometry, visibility, block, lane);
            if (!triangle.is_of(face)) triangle = points.triangle(surface, face);
            out.point[lane] =
                points.pixel(surface, triangle, surface.groups[block].first_pixel + lane, place(block, lane));
        }
    }

    /// Calls work(block, points) for all blocks, on all threads. Throws LoadCancelled.
    template <class Work> void for_blocks(const Work& work) const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.points.size(), 8),
                          [&](const auto& range) {
                              TracedBlock traced;
                              for (std::size_t b = range.begin(); b != range.end() && !is_cancelled(); ++b) {
                                  trace_points(b, traced);
                                  work(b, traced);
                              }
                          });
        if (is_cancelled()) throw LoadCancelled();
    }

    /// Traces the shadow rays of the lights in `which`.
    void find_reached(const std::vector<std::size_t>& which) const {
        const std::size_t stride = surface.points.size();
        kept.reached.resize(std::max<std::size_t>(kept.inputs.lights.size(), 1) * stride);
        for_blocks([&](std::size_t block, const TracedBlock& traced) {
            RayPacket rays{};
            for (const std::size_t l : which) {
                const LightSource& light = kept.inputs.lights[l];
                rays.which = 0;
                for (unsigned lane = 0; lane < block_size; ++lane)
                    if ((traced.mask >> lane & 1u) &&
                        needs_shadow_ray(kept.inputs, light, traced.point[lane]))
                        rays.add(lane, shadow_ray(light, traced.point[lane].start));
                const unsigned blocked = rays.which != 0 ? kept.rays.blocked(rays) : 0;
                kept.reached[l * stride + block] = static_cast<std::uint16_t>(~blocked);
            }
        });
    }

    /// Traces the paths kept.paths .. end - 1 of all points.
    void follow_paths(int end) const {
        for_blocks([&](std::size_t block, const TracedBlock& traced) {
            for (unsigned lane = 0; lane < block_size; ++lane) {
                if (!(traced.mask >> lane & 1u)) continue;
                glm::dvec3& sum = kept.sums[block * block_size + lane];
                for (int path = kept.paths; path < end; ++path)
                    sum += glm::dvec3(radiance_of_path(kept.rays, kept.inputs, traced.point[lane], path));
                const glm::vec3 mean = mean_of_paths(sum, end);
                ColorBlock& to = kept.bounced[block];
                to.r[lane] = mean.x, to.g[lane] = mean.y, to.b[lane] = mean.z;
            }
        });
        kept.paths = end;
    }

    void follow_all_paths() const {
        const int all = kept.inputs.settings.paths;
        const std::size_t count = surface.points.size() * block_size;
        if (kept.paths == 0) {
            kept.sums.assign(count, glm::dvec3(0));
            kept.bounced.assign(surface.points.size(), {});
        }
        constexpr std::size_t paths_between_reports = std::size_t{1} << 20;
        const int each = static_cast<int>(std::clamp<std::size_t>(
            paths_between_reports / std::max<std::size_t>(count, 1), 1, static_cast<std::size_t>(all)));
        while (kept.paths < all) {
            follow_paths(std::min(all, kept.paths + each));
            if (progress) progress(kept.paths, all);
        }
    }
};

/// Whether the two sources need the same shadow rays.
bool same_rays(const LightSource& a, const LightSource& b) {
    return a.xyz == b.xyz && a.w == b.w && (a.ambient == Float3{}) == (b.ambient == Float3{});
}

/// The lights whose shadow rays must be traced again.
std::vector<std::size_t> changed_lights(const TransportInputs& before, const TransportInputs& now, bool all) {
    std::vector<std::size_t> which;
    all |= before.lights.size() != now.lights.size() || before.any_mistake != now.any_mistake;
    for (std::size_t i = 0; i < now.lights.size(); ++i)
        if (all || !same_rays(before.lights[i], now.lights[i])) which.push_back(i);
    return which;
}

/// Whether the paths of `before` are a subset of those of `now`.
bool continues(TransportInputs before, const TransportInputs& now, int followed) {
    if (followed > now.settings.paths) return false;
    before.settings.paths = now.settings.paths;
    return before == now;
}

}  // namespace

bool has_transport(const Scene& scene) {
    return scene.transport.model != TransportModel::Local && scene.shading.reflection != Reflection::None;
}

std::optional<Arrivals> TransportStage::arrivals() const {
    if (!any_shadow) return std::nullopt;
    const std::size_t lights = std::max<std::size_t>(inputs.lights.size(), 1);
    return Arrivals{reached.data(), reached.size() / lights, paths > 0 ? bounced.data() : nullptr};
}

bool update_transport(TransportStage& kept, const Scene& scene, const Geometry& geometry,
                      const Visibility& visibility, const Surface& surface, bool surface_redone,
                      const PathProgress& progress) {
    const bool was_on = kept.any_shadow, had_paths = kept.paths > 0;
    if (!has_transport(scene)) {
        if (!was_on) return false;
        RayScene rays = std::move(kept.rays);  // meshes and transforms may be unchanged next time
        kept = {};
        kept.rays = std::move(rays);
        return true;
    }
    TransportInputs now = transport_inputs(scene);
    const bool same_points = was_on && !surface_redone && kept.rays.is_of(scene);
    if (same_points && kept.inputs == now) return false;
    const bool bounces = now.settings.model == TransportModel::Bounces;
    if (!bounces || !same_points || !continues(kept.inputs, now, kept.paths)) kept.paths = 0;
    kept.any_shadow = false;
    kept.rays.update(scene);
    const std::vector<std::size_t> changed = changed_lights(kept.inputs, now, !same_points);
    kept.inputs = std::move(now);
    const Run run{kept,    geometry, visibility,
                  surface, progress, {kept.rays, geometry, world_from_view(scene.camera)}};
    try {
        if (!changed.empty() || !same_points) run.find_reached(changed);
        if (bounces) run.follow_all_paths();
    } catch (...) {
        kept.paths = 0;
        throw;
    }
    kept.any_shadow = true;
    return bounces || had_paths || !changed.empty() || !same_points;
}

VisibleTriangle LitPointFinder::triangle(const SurfaceInputs& surface, const SampleFace& face) const {
    const Geometry& g = geometry;
    VisibleTriangle seen{face.object, face.triangle, face.turned,
                         rays.facet({face.object, face.triangle - g.objects[face.object].first_triangle})};
    if (surface.choice.facet_normals) return seen;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = g.triangle(face.object, face.triangle).corner[k];
        const glm::dvec3 n = normal_in_world(world_from_view, surface.normals[face.object].at_corner(corner));
        seen.normals[k] = face.turned ? -n : n;
    }
    return seen;
}

TracedPoint LitPointFinder::pixel(const SurfaceInputs& surface, const VisibleTriangle& triangle,
                                  std::size_t pixel, const PositionNormal& at) const {
    const glm::dvec3 p = position_in_world(world_from_view, at.p);
    const glm::vec3 n(normal_in_world(world_from_view, at.n));
    return {surface.choice.facet_normals ? triangle.facet.nearest(p)
                                         : triangle.facet.on_bulge(p, triangle.normals),
            n, pixel};
}

TracedPoint LitPointFinder::item(const SurfaceChoice& choice, const ShadingPoint& source,
                                 const PositionNormal& at) const {
    const glm::dvec3 p = position_in_world(world_from_view, at.p), n = normal_in_world(world_from_view, at.n);
    // A key that differs from every pixel's number.
    const std::uint64_t key = std::uint64_t{1} << 63 | std::uint64_t{source.object} << 33 |
                              std::uint64_t{source.item} << 1 | (source.turned ? 1u : 0u);
    if (choice.kind == SurfaceKind::Corners)
        return {n == glm::dvec3(0) ? RayStart{glm::vec3(p)} : rays.at_corner(source.object, p, n),
                glm::vec3(n), key};
    if (choice.provoking) return {rays.on_triangle({source.object, source.item}, p), glm::vec3(n), key};
    return {on_polygon(rays, *geometry.objects[source.object].mesh, source.object, source.item, p),
            glm::vec3(n), key};
}

}  // namespace glint
