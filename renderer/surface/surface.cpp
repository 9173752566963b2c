#include "renderer/surface/surface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/geometry/interpolate.h"
#include "renderer/geometry/object_normals.h"
#include "renderer/simd/glm_vec3.h"
#include "renderer/simd/vec3.h"

namespace glint {
namespace {

/// The triangles of one object, first <= t < first + count; they are consecutive.
struct ObjectTriangles {
    std::uint32_t object = 0, first = 0, count = 0;

    [[nodiscard]] bool holds(std::uint32_t triangle) const { return triangle - first < count; }
};

ObjectTriangles triangles_beside(const Geometry& g, std::uint32_t triangle) {
    const std::uint32_t o = g.object_of(triangle);
    return {o, g.objects[o].first_triangle, static_cast<std::uint32_t>(g.objects[o].mesh->triangles.size())};
}

bool is_chosen(const std::vector<std::uint8_t>& blocks, std::size_t block) {
    return block < blocks.size() && blocks[block] != 0;
}

/// Bit i: pixel i of the block shows a triangle of this object; considers only the pixels in `covered`.
std::uint32_t pixels_of(ObjectTriangles triangles, const std::uint32_t* codes, std::uint32_t covered) {
    if (covered == 0xFFFF) {
        // Usually all pixels do, so this tests several pixels at once without a branch.
        std::uint32_t others = 0;
        for (std::uint32_t i = 0; i < block_size; ++i)
            others |= static_cast<std::uint32_t>(!triangles.holds(triangle_of_code(codes[i])));
        if (!others) return covered;
    }
    std::uint32_t pixels = 0;
    for (std::uint32_t left = covered; left; left &= left - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(left));
        if (triangles.holds(triangle_of_code(codes[i]))) pixels |= 1u << i;
    }
    return pixels;
}

/// Calls visit(group) for the chosen groups of one row, left to right; 16 pixels yield one group per object.
template <class Visit>
void visit_row(const Geometry& g, const Visibility& visibility, const BlockChoice& chosen, std::size_t y,
               const Visit& visit) {
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const std::size_t first = y * visibility.groups_a_row;
    const std::uint16_t* covered = &visibility.covered[first];
    ObjectTriangles nearby;  // neighbouring pixels usually show the same object
    for (std::uint32_t x0 = 0; x0 < width; x0 += block_size) {
        if (chosen && !is_chosen(*chosen, first + x0 / block_size)) continue;
        std::uint32_t left = covered[x0 / block_size];  // pixels that are not in a group yet
        const std::uint32_t first_pixel = static_cast<std::uint32_t>(y) * width + x0;
        if (left && g.objects.size() == 1) {
            visit(PixelGroup{first_pixel, 0, static_cast<std::uint16_t>(left)});
            continue;
        }
        const std::uint32_t* codes = &visibility.seen[first_pixel];
        while (left) {
            const std::uint32_t triangle = triangle_of_code(codes[std::countr_zero(left)]);
            if (!nearby.holds(triangle)) nearby = triangles_beside(g, triangle);
            const std::uint32_t pixels = pixels_of(nearby, codes, left);
            visit(PixelGroup{first_pixel, nearby.object, static_cast<std::uint16_t>(pixels)});
            left &= ~pixels;
        }
    }
}

/// Finds the chosen groups of the picture, in reading order for any number of threads.
void find_groups(Surface& s, const Geometry& g, const Visibility& visibility) {
    const auto height = static_cast<std::size_t>(g.size.height);
    s.row_groups.assign(height + 1, {});
    tbb::parallel_for(std::size_t{0}, height, [&](std::size_t y) {
        RowGroups counted;
        visit_row(g, visibility, s.blocks, y, [&counted](const PixelGroup& group) {
            ++counted.first_group;
            counted.pixels +=
                group.mask == 0xFFFF ? block_size : static_cast<unsigned>(std::popcount(group.mask));
        });
        s.row_groups[y + 1] = counted;
    });
    for (std::size_t y = 1; y <= height; ++y) s.row_groups[y].first_group += s.row_groups[y - 1].first_group;
    const std::size_t count = s.row_groups[height].first_group;
    s.groups.resize(count);
    tbb::parallel_for(std::size_t{0}, height, [&](std::size_t y) {
        PixelGroup* next = s.groups.data() + s.row_groups[y].first_group;
        visit_row(g, visibility, s.blocks, y, [&next](const PixelGroup& group) { *next++ = group; });
    });
    s.group_samples.clear();
    s.pixel_count = 0;
    for (const RowGroups& row : s.row_groups) s.pixel_count += row.pixels;
}

}  // namespace

SurfaceChoice surface_choice(const Shading& shading) {
    SurfaceChoice c;
    const bool blends_colors = shading.mode == ShadingMode::Gouraud || shading.reflection == Reflection::None;
    c.kind = shading.mode == ShadingMode::Flat ? SurfaceKind::Faces
             : blends_colors                   ? SurfaceKind::Corners
                                               : SurfaceKind::Pixels;
    c.facet_normals = c.kind == SurfaceKind::Pixels && shading.mode == ShadingMode::Facet;
    if (c.kind == SurfaceKind::Corners || (c.kind == SurfaceKind::Pixels && !c.facet_normals))
        c.interpolation = shading.interpolation;
    c.provoking = c.kind == SurfaceKind::Faces && flat_at_provoking_corner(shading);
    c.two_sided = shading.two_sided && !shading.mistakes.flipped_twice;
    c.mistakes = normal_mistakes(shading.mistakes);
    return c;
}

bool update_surface(Surface& kept, const Scene& scene, const Geometry& g, const Visibility& visibility,
                    bool visibility_redone) {
    const SurfaceChoice choice = surface_choice(scene.shading);
    if (!visibility_redone && kept.choice == choice && kept.blocks == kept.wanted_blocks &&
        same_normals(kept.normals, scene))
        return false;
    kept.choice = choice;
    kept.blocks = kept.wanted_blocks;
    update_normals(kept.normals, scene, g, choice.mistakes);
    if (visibility.samples > 1)
        find_sampled_groups(kept, g, visibility);
    else
        find_groups(kept, g, visibility);
    if (choice.kind == SurfaceKind::Pixels)
        interpolate_pixels(kept, g, visibility);
    else
        collect_lit_points(kept, g, visibility);
    return true;
}

// The surface at single samples: the functions behind both the surface stage and `explain`.

namespace {

using Vec = Vec3<float>;

/// The interpolated normal, not yet normalized.
Vec blended_normal(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const CornerWeights weights = corner_weights(surface.choice.interpolation, g, face);
    const ObjectNormals& normals = surface.normals[face.object];
    Vec sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(weights.count); ++i)
        sum = sum + weights.weight[i] * to_vec(normals.at_corner(weights.corner[i]));
    return sum;
}

/// Whether the normals of a face are reversed, as they are with two-sided lighting if the face is seen from
/// behind.
bool is_turned(const SurfaceChoice& choice, const Geometry& g, const SampleFace& face, bool back) {
    const bool turned = choice.two_sided && back;
    if (!choice.mistakes.some_faces_flipped) return turned;
    return turned != (g.triangle(face.object, face.triangle).face % 3 == 0);
}

SampleFace seen_face(const SurfaceChoice& choice, const Geometry& g, const Visibility& visibility, int x,
                     int y) {
    const std::size_t pixel = g.size.index(x, y);
    SampleFace face;
    face.at = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
    face.triangle = visibility.triangle_at(pixel);
    face.object = g.object_of(face.triangle);
    face.turned = is_turned(choice, g, face, visibility.back_at(pixel));
    return face;
}

}  // namespace

SampleFace sample_face(const SurfaceChoice& choice, const Geometry& g, const Visibility& visibility, int x,
                       int y) {
    SampleFace face = seen_face(choice, g, visibility, x, y);
    locate_on_face(face, g);
    return face;
}

SampleFace face_of_lane(const Surface& s, const Geometry& g, const Visibility& visibility, std::size_t group,
                        unsigned lane) {
    if (s.group_samples.empty()) {
        const auto width = static_cast<std::uint32_t>(g.size.width);
        const std::uint32_t pixel = s.groups[group].first_pixel + lane;
        return seen_face(s.choice, g, visibility, static_cast<int>(pixel % width),
                         static_cast<int>(pixel / width));
    }
    const GroupSamples& samples = s.group_samples[group];
    SampleFace face;
    face.at = samples.at[lane];
    face.object = s.groups[group].object;
    face.triangle = samples.triangle[lane];
    face.turned = is_turned(s.choice, g, face, samples.back >> lane & 1u);
    return face;
}

PositionNormal pixel_point(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const ObjectGeometry& object = g.objects[face.object];
    const Triangle& t = g.triangle(face.object, face.triangle);
    Vec n;
    if (!surface.choice.facet_normals) {
        const Vec sum = blended_normal(surface, g, face);
        if (!(length(sum) <= shortest_normal))  // also if it is NaN
            n = surface.choice.mistakes.unnormalized_at_pixel ? sum : unit(sum);
    }
    // If opposite corner normals cancel as well, the facet's own normal is the best choice.
    if (dot(n, n) == 0)
        n = to_vec(camera_facet_normal(object, surface.normals[face.object].options.flip, t.face,
                                       surface.choice.mistakes));
    return {face.p, face.turned ? -to_glm(n) : to_glm(n)};
}

namespace {

glm::vec3 known_centroid(const Geometry& g, std::uint32_t object, std::uint32_t face) {
    const ObjectGeometry& o = g.objects[object];
    if (o.mesh->corners_of(face).size() < many_corners) return glm::vec3(o.centroid(face));
    thread_local RecentFaces<GeometryFace, glm::vec3> known;
    return known.of({g.state, object, face}, [&] { return glm::vec3(o.centroid(face)); });
}

}  // namespace

PositionNormal lit_point(const SurfaceInputs& surface, const Geometry& g, const ShadingPoint& source) {
    const ObjectGeometry& object = g.objects[source.object];
    const Mesh& mesh = *object.mesh;
    const ObjectNormals& normals = surface.normals[source.object];
    PositionNormal at;
    if (surface.choice.kind == SurfaceKind::Faces && !surface.choice.provoking) {
        at = {known_centroid(g, source.object, source.item),
              camera_facet_normal(object, normals.options.flip, source.item, surface.choice.mistakes)};
    } else if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t corner = mesh.triangles[source.item].corner[2];
        at = {object.position(mesh.corner_position[corner]), normals.at_corner(corner)};
    } else {
        at = {object.position(normals.position_of_slot(source.item)), normals.normal_of_slot(source.item)};
    }
    if (source.turned) at.n = -at.n;
    return at;
}

BlendedPoints blended_points(const SurfaceInputs& surface, const Geometry& g, const SampleFace& face) {
    const Triangle& t = g.triangle(face.object, face.triangle);
    BlendedPoints s;
    if (surface.choice.kind == SurfaceKind::Faces) {
        const std::uint32_t triangle = face.triangle - g.objects[face.object].first_triangle;
        s.count = 1;
        s.point[0] = {face.object, surface.choice.provoking ? triangle : t.face, face.turned};
        s.weight[0] = 1;
        return s;
    }
    const CornerWeights weights = corner_weights(surface.choice.interpolation, g, face);
    const ObjectNormals& normals = surface.normals[face.object];
    s.count = weights.count;
    s.weight = weights.weight;
    for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i)
        s.point[i] = {face.object, normals.slot_of(weights.corner[i]), face.turned};
    return s;
}

// Anti-aliasing: each face that is visible at some samples of a pixel is lit once in that pixel, and the
// pixel is their weighted mean. For the positions of the samples, see sample_offset() in visibility.cpp.

namespace {

constexpr int max_samples = 8;

/// The surface at one sample.
struct SampleSeen {
    std::uint32_t object = 0, triangle = 0, face = 0;
    bool back = false;
};

/// One face in one pixel: its samples as bits, and the triangle and position at which it is lit.
struct Fragment {
    SampleSeen seen;
    unsigned samples = 0;
    PixelPosition at;
    float weight = 0;
    bool taken = false;
};

/// The faces of one pixel, in the order of their first samples.
struct PixelFragments {
    std::array<SampleSeen, max_samples> sample;
    std::array<Fragment, max_samples> fragment;
    int count = 0;
};

/// How far inside a triangle a screen position is: the smallest of its corners' weights there, negative
/// outside.
double least_weight(const Geometry& g, const SampleSeen& seen, PixelPosition at) {
    const ObjectGeometry& object = g.objects[seen.object];
    std::array<ClipCorner<double>, 3> corner;
    const auto positions = g.position_indices(seen.object, g.triangle(seen.object, seen.triangle));
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 p(object.mesh->positions[positions[i]]);
        const glm::dvec4 c = object.clip_from_object * glm::dvec4(p, 1.0);
        corner[i] = {c.x, c.y, c.w};
    }
    const ScreenPoint<double> point = to_ndc<double>(at.x, at.y, g.size.width, g.size.height);
    const Vec3<double> e = edge_functions(corner[0], corner[1], corner[2], point);
    const double sum = e.x + e.y + e.z;
    return sum > 0 ? std::min({e.x, e.y, e.z}) / sum : -HUGE_VAL;
}

/// Finds, among the triangles that a face shows at its samples, the one that contains their mean, or is
/// nearest to it.
SampleSeen triangle_at_mean(const Geometry& g, const PixelFragments& pixel, const Fragment& f) {
    SampleSeen best = f.seen;
    double deepest = -HUGE_VAL;
    std::uint32_t tried = no_triangle;
    for (unsigned s = 0; s < max_samples; ++s) {
        const SampleSeen& sample = pixel.sample[s];
        if (!(f.samples >> s & 1u) || sample.triangle == tried) continue;
        tried = sample.triangle;
        const double depth = least_weight(g, sample, f.at);
        if (depth > deepest) best = sample;
        deepest = std::max(deepest, depth);
    }
    return best;
}

/// Whether a face shows several of its triangles.
bool is_divided(const PixelFragments& pixel, const Fragment& f) {
    for (unsigned s = 0; s < max_samples; ++s)
        if ((f.samples >> s & 1u) && pixel.sample[s].triangle != f.seen.triangle) return true;
    return false;
}

SampleSeen seen_at(const Geometry& g, const Visibility& visibility, std::size_t key) {
    SampleSeen seen;
    seen.triangle = visibility.triangle_at(key);
    if (seen.triangle == no_triangle) return seen;
    seen.object = g.object_of(seen.triangle);
    seen.face = g.triangle(seen.object, seen.triangle).face;
    seen.back = visibility.back_at(key);
    return seen;
}

PixelFragments fragments_of(const Geometry& g, const Visibility& visibility, std::size_t pixel, float x,
                            float y) {
    PixelFragments found;
    for (int s = 0; s < visibility.samples; ++s) {
        const SampleSeen seen =
            seen_at(g, visibility, static_cast<std::size_t>(s) * visibility.plane + pixel);
        if (seen.triangle == no_triangle) continue;
        found.sample[static_cast<std::size_t>(s)] = seen;
        const auto end = found.fragment.begin() + found.count;
        auto f = std::find_if(found.fragment.begin(), end, [&seen](const Fragment& other) {
            return other.seen.object == seen.object && other.seen.face == seen.face;
        });
        if (f == end) {
            f->seen = seen;
            ++found.count;
        }
        const SampleOffset offset = sample_offset(visibility.samples, s);
        f->samples |= 1u << s;
        f->at.x += static_cast<float>(offset.x);
        f->at.y += static_cast<float>(offset.y);
        f->weight += 1;
    }
    for (int i = 0; i < found.count; ++i) {
        Fragment& f = found.fragment[static_cast<std::size_t>(i)];
        f.at = {x + 0.5f + f.at.x / (f.weight * subpixels), y + 0.5f + f.at.y / (f.weight * subpixels)};
        f.weight /= static_cast<float>(visibility.samples);
        if (is_divided(found, f)) f.seen = triangle_at_mean(g, found, f);
    }
    return found;
}

/// Moves fragments of one object, at most one per pixel, into a group; returns false if none are left.
bool next_group(std::array<PixelFragments, block_size>& pixels, std::uint32_t first_pixel, PixelGroup& group,
                GroupSamples& samples) {
    group = {first_pixel, no_index, 0};
    samples = GroupSamples{};
    for (std::size_t i = 0; i < block_size; ++i) {
        for (int k = 0; k < pixels[i].count; ++k) {
            Fragment& f = pixels[i].fragment[static_cast<std::size_t>(k)];
            if (f.taken || (group.object != no_index && group.object != f.seen.object)) continue;
            f.taken = true;
            group.object = f.seen.object;
            group.mask = static_cast<std::uint16_t>(group.mask | 1u << i);
            samples.triangle[i] = f.seen.triangle;
            samples.weight[i] = f.weight;
            samples.at[i] = f.at;
            samples.back = static_cast<std::uint16_t>(samples.back | (f.seen.back ? 1u : 0u) << i);
            break;
        }
    }
    return group.mask != 0;
}

void find_row(const Geometry& g, const Visibility& visibility, int y, SampledRow& row) {
    row.groups.clear();
    row.samples.clear();
    row.pixels = 0;
    const auto width = static_cast<std::uint32_t>(g.size.width);
    const std::uint32_t begin = static_cast<std::uint32_t>(y) * width;
    for (std::uint32_t x0 = 0; x0 < width; x0 += block_size) {
        std::array<PixelFragments, block_size> pixels;
        for (std::uint32_t i = 0; i < std::min<std::uint32_t>(block_size, width - x0); ++i) {
            pixels[i] = fragments_of(g, visibility, begin + x0 + i, static_cast<float>(x0 + i),
                                     static_cast<float>(y));
            row.pixels += pixels[i].count > 0;
        }
        PixelGroup group;
        GroupSamples samples;
        while (next_group(pixels, begin + x0, group, samples)) {
            row.groups.push_back(group);
            row.samples.push_back(samples);
        }
    }
}

}  // namespace

void find_sampled_groups(Surface& s, const Geometry& g, const Visibility& visibility) {
    s.sampled_rows.resize(static_cast<std::size_t>(g.size.height));
    tbb::parallel_for(0, g.size.height, [&](int y) {
        SampledRow& row = s.sampled_rows[static_cast<std::size_t>(y)];
        find_row(g, visibility, y, row);
    });
    std::size_t count = 0;
    for (const SampledRow& row : s.sampled_rows) count += row.groups.size();
    s.groups.clear();
    s.groups.reserve(count);
    s.group_samples.clear();
    s.group_samples.reserve(count);
    s.pixel_count = 0;
    for (const SampledRow& row : s.sampled_rows) {
        s.groups.insert(s.groups.end(), row.groups.begin(), row.groups.end());
        s.group_samples.insert(s.group_samples.end(), row.samples.begin(), row.samples.end());
        s.pixel_count += row.pixels;
    }
}

}  // namespace glint
