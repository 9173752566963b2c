#include "renderer/surface/surface.h"

#include <tbb/parallel_for.h>

#include <bit>

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

/// Bit i: pixel i of the block shows a triangle of this object; considers only the pixels of `covered`.
std::uint32_t pixels_of(ObjectTriangles triangles, const std::uint32_t* codes, std::uint32_t covered) {
    if (covered == 0xFFFF) {
        // Usually all do; test several pixels at once without a branch.
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

/// Calls visit(group) for the chosen groups of one row, left to right; 16 pixels give one group per object.
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

/// All groups of the picture that are chosen, in reading order for any number of threads.
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

}  // namespace glint
