#include "renderer/transport/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <new>

#include "models/memory_limit.h"

namespace glint {
namespace {

void release(RTCDevice device) { rtcReleaseDevice(device); }
void release(RTCScene scene) { rtcReleaseScene(scene); }
template <class Handle> struct Release {
    using pointer = Handle;
    void operator()(Handle handle) const { release(handle); }
};
template <class Handle> using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release<Handle>>;

/// Throws if Embree has reported an error since the last call. `device` is null if it could not be created.
void check(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw LimitExceeded({"", "/transport/model",
                         fmt::format("Embree cannot trace rays here (error {})", static_cast<int>(error)),
                         "the model \"local\""});
}

RTCRay embree_ray(const WorldRay& ray) {
    RTCRay r{};
    r.org_x = ray.from.x, r.org_y = ray.from.y, r.org_z = ray.from.z;
    r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z;
    r.tnear = 0;
    r.tfar = ray.reach;
    r.mask = 0xFFFFFFFFu;
    return r;
}

/// The triangles of one object in world coordinates.
struct RayObject {
    MeshPtr mesh;
    Transform transform;
    bool visible = true;
    std::vector<glm::vec3> positions;    // #V, plus one, because Embree reads 16 bytes at once
    std::vector<std::uint32_t> corners;  // 3 x #triangles, indices into `positions`

    [[nodiscard]] bool is_of(const Object& object) const {
        return mesh == object.mesh && transform == object.transform && visible == object.visible;
    }
};

void place(RayObject& to, const Object& from) {
    to.mesh = from.mesh;
    to.transform = from.transform;
    to.visible = from.visible;
    if (!from.visible) return;
    const Mesh& mesh = *from.mesh;
    const glm::dmat4 world = world_from_object(from.transform);
    to.positions.assign(mesh.positions.size() + 1, glm::vec3(0));
    to.corners.resize(3 * mesh.triangles.size());
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, mesh.positions.size(), 4096), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                to.positions[i] = glm::vec3(world * glm::dvec4(glm::dvec3(mesh.positions[i]), 1));
        });
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            to.corners[3 * t + k] = mesh.corner_position[mesh.triangles[t].corner[k]];
}

}  // namespace

RayFacet::RayFacet(const std::array<glm::dvec3, 3>& corners) : c(corners) {
    const glm::dvec3 u = c[1] - c[0], v = c[2] - c[0], w = c[2] - c[1];
    across = glm::cross(u, v);
    area = glm::length(across);
    if (area > 0) n = across / area;
    longest = std::max({glm::dot(u, u), glm::dot(v, v), glm::dot(w, w)});
}

glm::dvec3 RayFacet::weights_at(const glm::dvec3& p) const {
    const glm::dvec3 u = c[1] - c[0], v = c[2] - c[0], to = p - c[0];
    const double squared = glm::dot(across, across);
    if (!(squared > 0)) return glm::dvec3(1, 0, 0);
    const double wv = glm::dot(glm::cross(u, to), across) / squared,
                 wu = glm::dot(glm::cross(to, v), across) / squared;
    const glm::dvec3 weights = glm::max(glm::dvec3(1 - wu - wv, wu, wv), glm::dvec3(0));
    return weights / (weights.x + weights.y + weights.z);
}

/// Derivation of `away`: the point is the weighted mean of the corners, computed in doubles and then rounded
/// to floats, which moves it by up to half_ulp |p| along each axis. Embree subtracts the ray's origin from
/// the corners, and computes the cross product of two edges and the product of that with a corner: about 6
/// roundings of numbers up to (distance to the corners) x (edge) x (edge), divided by the area. The factor 8
/// includes the roundings of p itself. Compare M. Pharr, W. Jakob, G. Humphreys, "Physically Based
/// Rendering", 3rd ed., 3.9 (Managing Rounding Error).
RayStart RayFacet::start_at(const glm::dvec3& weights) const {
    const glm::dvec3 p = weights.x * c[0] + weights.y * c[1] + weights.z * c[2];
    RayStart start;
    start.p = glm::vec3(p);
    if (!(area > 0)) return start;
    const double farthest =
        std::max({glm::distance(p, c[0]), glm::distance(p, c[1]), glm::distance(p, c[2])});
    start.n = glm::vec3(n);
    start.away = static_cast<float>(
        half_ulp * (glm::dot(glm::abs(n), glm::abs(p)) + 8 * farthest * longest / area) * 1.001);
    return start;
}

RayStart RayFacet::on_bulge(const glm::dvec3& p, const std::array<glm::dvec3, 3>& normals) const {
    const glm::dvec3 weights = weights_at(p);
    RayStart start = start_at(weights);
    glm::dvec3 lift(0);
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        lift -= weights[i] * std::min(0.0, glm::dot(glm::dvec3(start.p) - c[k], normals[k])) * normals[k];
    }
    start.p = glm::vec3(glm::dvec3(start.p) + lift);
    return start;
}

struct RayScene::Built {
    Owned<RTCDevice> device;
    Owned<RTCScene> scene;
    std::vector<RayObject> objects;
    bool done = false;

    void add(const RayObject& object, unsigned number) const {
        const std::size_t triangles = object.corners.size() / 3;
        if (!object.visible || triangles == 0) return;
        const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   object.positions.data(), 0, sizeof(glm::vec3),
                                   object.positions.size() - 1);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   object.corners.data(), 0, 3 * sizeof(std::uint32_t), triangles);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene.get(), geometry, number);
        rtcReleaseGeometry(geometry);
    }
};

RayScene::RayScene() : built_(std::make_unique<Built>()) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

bool RayScene::is_of(const Scene& scene) const {
    return built_->done &&
           std::equal(built_->objects.begin(), built_->objects.end(), scene.objects.begin(),
                      scene.objects.end(), [](const RayObject& a, const Object& b) { return a.is_of(b); });
}

bool RayScene::update(const Scene& scene) {
    if (is_of(scene)) return false;
    built_ = std::make_unique<Built>();
    Built& now = *built_;
    // Does not set the number of threads: Embree would impose that limit on the entire process.
    now.device.reset(rtcNewDevice(nullptr));
    if (!now.device) check(nullptr);
    now.scene.reset(rtcNewScene(now.device.get()));
    check(now.device.get());
    rtcSetSceneFlags(now.scene.get(), RTC_SCENE_FLAG_ROBUST);  // rays cannot pass between two triangles
    now.objects.resize(scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        place(now.objects[i], scene.objects[i]);
        now.add(now.objects[i], static_cast<unsigned>(i));
    }
    // Embree sets denormal numbers to 0 while it builds. In a separate arena this setting ends with the
    // build. The calling thread's arena might keep it, if this is its first work, and change our results.
    tbb::task_arena(tbb::this_task_arena::max_concurrency()).execute([&] {
        rtcCommitScene(now.scene.get());
    });
    check(now.device.get());
    now.done = true;
    return true;
}

bool RayScene::is_blocked(const WorldRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay r = embree_ray(ray);
    rtcOccluded1(built_->scene.get(), &context, &r);
    return r.tfar < 0;
}

unsigned RayScene::blocked(const RayPacket& rays) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRay16 r{};
    alignas(64) std::array<int, RayPacket::size> valid;
    for (std::size_t i = 0; i < RayPacket::size; ++i) {
        const bool is_valid = rays.which >> i & 1u;
        r.org_x[i] = rays.from_x[i], r.org_y[i] = rays.from_y[i], r.org_z[i] = rays.from_z[i];
        r.dir_x[i] = rays.direction_x[i], r.dir_y[i] = rays.direction_y[i], r.dir_z[i] = rays.direction_z[i];
        r.tfar[i] = is_valid ? rays.reach[i] : -1;  // Embree ignores `valid` where it splits packets
        r.mask[i] = 0xFFFFFFFFu;
        valid[i] = is_valid ? -1 : 0;
    }
    rtcOccluded16(valid.data(), built_->scene.get(), &context, &r);
    unsigned blocked = 0;
    for (std::size_t i = 0; i < RayPacket::size; ++i) blocked |= (r.tfar[i] < 0 ? 1u : 0u) << i;
    return blocked & rays.which;
}

std::optional<RayHit> RayScene::first_hit(const WorldRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit r{};
    r.ray = embree_ray(ray);
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(built_->scene.get(), &context, &r);
    if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{r.hit.geomID, r.hit.primID};
}

RayFacet RayScene::facet(RayHit hit) const {
    const RayObject& object = built_->objects[hit.object];
    const std::uint32_t* at = &object.corners[3 * std::size_t{hit.triangle}];
    return RayFacet({object.positions[at[0]], object.positions[at[1]], object.positions[at[2]]});
}

RayStart RayScene::at_hit(const WorldRay& ray, RayHit hit) const {
    const RayFacet at = facet(hit);
    const glm::dvec3 from(ray.from), along(ray.direction);
    const double slope = glm::dot(at.across, along);
    if (slope == 0) return at.nearest(from);
    return at.nearest(from + glm::dot(at.across, at.c[0] - from) / slope * along);
}

RayStart RayScene::at_corner(std::uint32_t object, const glm::dvec3& p, const glm::dvec3& n) const {
    const Bounds& box = built_->objects[object].mesh->bounds;
    const glm::dvec3 size(glm::dvec3(box.max) - glm::dvec3(box.min));
    const glm::dvec3 scale(built_->objects[object].transform.scale);
    RayStart start;
    start.p = glm::vec3(p);
    start.n = glm::vec3(glm::normalize(n));
    // The facets at the corner are not known here. Their edges are at most as long as the object's bounding
    // box.
    start.away = static_cast<float>(8 * half_ulp * (glm::length(p) + glm::length(size * scale)));
    return start;
}

}  // namespace glint
