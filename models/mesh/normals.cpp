#include "models/mesh/normals.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "models/mesh/mesh.h"
#include "models/mesh/polygon.h"
#include "models/numbers.h"
#include "models/problem.h"

namespace glint {
namespace {

void warn_of_missing(std::size_t corners, Warnings& warnings) {
    warn(warnings, corners, "corner has no normal; its vertex normal is used",
         "corners have no normal; their vertex normals are used");
}

CornerNormals facet_normals(const Mesh& mesh) {
    CornerNormals result;
    result.normals.resize(mesh.face_count());
    result.corner.resize(mesh.corner_position.size());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        result.normals[f] = facet_normal(mesh, f);
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) result.corner[c] = f;
    }
    return result;
}

/// The corners without a given normal, or with a zero one.
std::vector<std::size_t> corners_without_normal(const Mesh& mesh) {
    std::vector<std::size_t> without;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c) {
        const std::uint32_t given = mesh.given_normal_of(c);
        if (given == no_index || mesh.normals[given] == glm::vec3(0)) without.push_back(c);
    }
    return without;
}

/// Returns the given normals, normalized; corners without a given normal use their vertex normal.
CornerNormals given_normals(const Mesh& mesh, const NormalOptions& options) {
    CornerNormals result;
    result.normals.reserve(mesh.normals.size());
    for (const glm::vec3& n : mesh.normals) result.normals.push_back(glm::vec3(unit_or_zero(glm::dvec3(n))));
    result.corner = mesh.corner_normal;
    const std::vector<std::size_t> without = corners_without_normal(mesh);
    if (without.empty()) return result;

    const CornerNormals vertex = vertex_normals(mesh, options.weighting, options.crease_deg);
    const auto& vertex_index = vertex.corner.empty() ? mesh.corner_position : vertex.corner;
    const auto first = static_cast<std::uint32_t>(result.normals.size());
    result.normals.insert(result.normals.end(), vertex.normals.begin(), vertex.normals.end());
    if (result.corner.empty()) result.corner = mesh.corner_position;
    for (const std::size_t c : without) result.corner[c] = first + vertex_index[c];
    warn_of_missing(without.size(), result.warnings);
    return result;
}

}  // namespace

NormalSource used_source(const Mesh& mesh, NormalSource asked) {
    if (asked == NormalSource::Facet || asked == NormalSource::Vertex) return asked;
    switch (mesh.given_normals) {
    case GivenNormals::File:
        return NormalSource::File;
    case GivenNormals::Analytic:
        return NormalSource::Analytic;
    case GivenNormals::None:
        return NormalSource::Vertex;
    }
    return NormalSource::Vertex;  // not reached
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

glm::vec3 facet_normal(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    return glm::vec3(triangle_plane(a, b, c).normal);
}

glm::vec3 facet_normal(const Mesh& mesh, std::size_t face) {
    return glm::vec3(polygon_plane(mesh, face).normal);
}

void warn_of_missing_normals(const Mesh& mesh, Warnings& warnings) {
    if (mesh.given_normals != GivenNormals::None)
        warn_of_missing(corners_without_normal(mesh).size(), warnings);
}

CornerNormals corner_normals(const Mesh& mesh, const NormalOptions& options) {
    const NormalSource taken = used_source(mesh, options.source);
    if (taken == NormalSource::Facet) return facet_normals(mesh);
    CornerNormals result = taken == NormalSource::Vertex
                               ? vertex_normals(mesh, options.weighting, options.crease_deg)
                               : given_normals(mesh, options);
    if (taken != options.source && options.source != NormalSource::Auto)
        result.warnings.insert(result.warnings.begin(),
                               fmt::format("the mesh has no \"{}\" normals; \"{}\" normals are used",
                                           choice_of(options.source).word, choice_of(taken).word));
    return result;
}

namespace {

/// Sets of corners that can be joined (union-find); the smallest corner represents its set.
class Groups {
  public:
    explicit Groups(std::size_t corners) : parent_(corners) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t root(std::uint32_t c) {
        while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
        return c;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a < b) std::swap(a, b);
        parent_[a] = b;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

void join_repeated_corners(const Mesh& mesh, Groups& groups) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            const std::uint32_t next = next_corner(mesh, f, c);
            if (mesh.place_of(c) == mesh.place_of(next)) groups.join(c, next);
        }
}

}  // namespace

CreaseGroups crease_groups(const Mesh& mesh, const Topology& topology, float crease_deg) {
    std::vector<glm::dvec3> normal(mesh.face_count());
    for (std::size_t f = 0; f < normal.size(); ++f) normal[f] = polygon_plane(mesh, f).normal;
    // 1e-6, so that a cube's faces meet at 90 degrees despite the rounding of its normals.
    const double least = cos_sin(static_cast<double>(crease_deg) * std::numbers::pi / 180).c - 1e-6;
    Groups groups(mesh.corner_position.size());
    join_repeated_corners(mesh, groups);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (edge_kind(mesh, topology, e) != EdgeKind::Manifold) continue;
        const EdgeUse &f = topology.uses_of(e)[0], &g = topology.uses_of(e)[1];
        if (glm::dot(normal[f.face], normal[g.face]) < least) continue;
        groups.join(f.corner, next_corner(mesh, g.face, g.corner));  // they run in opposite directions
        groups.join(g.corner, next_corner(mesh, f.face, f.corner));
    }
    CreaseGroups result;
    result.group.resize(mesh.corner_position.size());
    for (std::uint32_t c = 0; c < result.group.size(); ++c) {
        const std::uint32_t root = groups.root(c);
        result.group[c] = root == c ? static_cast<std::uint32_t>(result.count++) : result.group[root];
    }
    return result;
}

namespace {

struct Sum {
    glm::dvec3 n{0};
    double weights = 0;
    void add(const glm::dvec3& normal, double weight) {
        n += weight * normal;
        weights += weight;
    }
};

/// Sums of normals, with the index of each corner's sum.
struct Averages {
    std::vector<std::uint32_t> group;  // #C; empty: one group per place
    std::vector<Sum> sums;

    std::uint32_t sum_of(const Mesh& mesh, std::uint32_t corner) const {
        return group.empty() ? mesh.place_of(corner) : group[corner];
    }
};

glm::dvec3 place(const Mesh& mesh, std::uint32_t corner) {
    return glm::dvec3(mesh.positions[mesh.corner_position[corner]]);
}

/// The angle at `at` from `next` to `before`, counter-clockwise about the facet normal n: 0 to 2 pi.
double interior_angle(const glm::dvec3& at, const glm::dvec3& next, const glm::dvec3& before,
                      const glm::dvec3& n) {
    const glm::dvec3 a = next - at, b = before - at, across = glm::cross(a, b);
    const double angle = angle_of(glm::dot(a, b), std::sqrt(glm::dot(across, across)));
    return glm::dot(across, n) < 0 ? 2 * std::numbers::pi - angle : angle;
}

void add_triangle(const Mesh& mesh, std::uint32_t first, NormalWeighting weighting, Averages& to) {
    const auto* v = &mesh.corner_position[first];
    const auto& p = mesh.positions;
    const PolygonPlane plane = triangle_plane(p[v[0]], p[v[1]], p[v[2]]);
    if (!(plane.area > 0)) return;
    std::array<double, 3> weight{1, 1, 1};
    if (weighting == NormalWeighting::Area) weight.fill(plane.area);
    if (weighting == NormalWeighting::Angle) {  // |cross product of two edges| = 2 area
        const glm::dvec3 a(p[v[0]]), ab = glm::dvec3(p[v[1]]) - a, ac = glm::dvec3(p[v[2]]) - a, bc = ac - ab;
        weight = {angle_of(glm::dot(ab, ac), 2 * plane.area), angle_of(-glm::dot(ab, bc), 2 * plane.area),
                  angle_of(glm::dot(ac, bc), 2 * plane.area)};
    }
    for (std::uint32_t i = 0; i < 3; ++i) to.sums[to.sum_of(mesh, first + i)].add(plane.normal, weight[i]);
}

void add_polygon(const Mesh& mesh, std::uint32_t face, NormalWeighting weighting,
                 std::vector<std::uint32_t>& corners, Averages& to) {
    const PolygonPlane plane = polygon_plane(mesh, face);
    if (!(plane.area > 0)) return;
    distinct_corners(mesh, face, corners);
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        double weight = weighting == NormalWeighting::Area ? plane.area : 1;
        if (weighting == NormalWeighting::Angle)
            weight = interior_angle(place(mesh, corners[i]), place(mesh, corners[(i + 1) % n]),
                                    place(mesh, corners[(i + n - 1) % n]), plane.normal);
        to.sums[to.sum_of(mesh, corners[i])].add(plane.normal, weight);
    }
}

void add_all(const Mesh& mesh, NormalWeighting weighting, Averages& to) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.first_corner[f + 1] - mesh.first_corner[f] == 3)
            add_triangle(mesh, mesh.first_corner[f], weighting, to);
        else
            add_polygon(mesh, f, weighting, corners, to);
    }
}

/// Whether the normals in a sum cancel one another.
bool cancels(const Sum& sum) {
    return sum.weights > 0 && !(glm::dot(sum.n, sum.n) >= 1e-12 * sum.weights * sum.weights);
}

/// Where a sum cancels, gives its corners the normals of their own facets.
void fall_back_to_facets(const Mesh& mesh, const Averages& averages, CornerNormals& result) {
    const auto falls_back = [&](std::uint32_t corner) {
        return cancels(averages.sums[averages.sum_of(mesh, corner)]);
    };
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        std::uint32_t c = mesh.first_corner[f];
        while (c < mesh.first_corner[f + 1] && !falls_back(c)) ++c;
        result.of_facets += c < mesh.first_corner[f + 1] ? 1 : 0;
    }
    result.normals.reserve(result.normals.size() + result.of_facets);
    if (result.corner.empty()) result.corner = mesh.corner_position;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        std::uint32_t facet = no_index;
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c) {
            if (!falls_back(c)) continue;
            if (facet == no_index) {
                facet = static_cast<std::uint32_t>(result.normals.size());
                result.normals.push_back(facet_normal(mesh, f));
            }
            result.corner[c] = facet;
        }
    }
}

/// Groups of corners joined across edges below the crease angle. Empty if no crease splits a place: then all
/// corners at one place share one normal.
Averages averages_below(const Mesh& mesh, float crease_deg) {
    CreaseGroups creased = crease_groups(mesh, make_topology(mesh), crease_deg);
    std::vector<char> used(mesh.positions.size(), 0);
    std::size_t used_count = 0;
    for (std::size_t c = 0; c < mesh.corner_position.size(); ++c)
        used_count += std::exchange(used[mesh.place_of(c)], 1) == 0 ? 1 : 0;
    Averages result;
    if (used_count == creased.count) {
        result.sums.resize(mesh.positions.size());
    } else {
        result.group = std::move(creased.group);
        result.sums.resize(creased.count);
    }
    return result;
}

/// Divides the groups, or the places, by smoothing group; each face of group 0 gets a group of its own.
void split_by_smoothing(const Mesh& mesh, Averages& averages) {
    using Key = std::tuple<std::uint32_t, std::uint64_t>;
    std::vector<std::pair<Key, std::uint32_t>> corners;
    corners.reserve(mesh.corner_position.size());
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint64_t alone = (std::uint64_t{1} << 32) + f, group = mesh.smoothing[f];
        for (std::uint32_t c = mesh.first_corner[f]; c < mesh.first_corner[f + 1]; ++c)
            corners.push_back({{averages.sum_of(mesh, c), group == 0 ? alone : group}, c});
    }
    std::sort(corners.begin(), corners.end());
    averages.group.resize(corners.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        count += i == 0 || corners[i].first != corners[i - 1].first ? 1 : 0;
        averages.group[corners[i].second] = count - 1;
    }
    averages.sums.resize(count);
}

}  // namespace

CornerNormals vertex_normals(const Mesh& mesh, NormalWeighting weighting, float crease_deg) {
    Averages averages;
    if (crease_deg < 180)
        averages = averages_below(mesh, crease_deg);
    else
        averages.sums.resize(mesh.positions.size());
    if (!mesh.smoothing.empty()) split_by_smoothing(mesh, averages);
    add_all(mesh, weighting, averages);
    CornerNormals result;
    result.normals.resize(averages.sums.size());
    bool any_cancels = false;
    for (std::size_t i = 0; i < averages.sums.size(); ++i) {
        const bool of_place = averages.group.empty() && !mesh.first_at_place.empty();
        const Sum& sum = averages.sums[of_place ? mesh.first_at_place[i] : i];
        if (cancels(sum))
            any_cancels = true;
        else if (sum.weights > 0)
            result.normals[i] = glm::vec3(sum.n / std::sqrt(glm::dot(sum.n, sum.n)));
    }
    result.corner = averages.group;
    if (any_cancels) fall_back_to_facets(mesh, averages, result);
    return result;
}

}  // namespace glint
