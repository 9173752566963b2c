// Prints a line for each of many generated jobs for the kernels of one instruction set: its name and a hash
// of the results' bits. Compiled once for each set (GLINT_ISA, GLINT_LANES as for the renderer's *_isa.cpp);
// the lines of all sets must be equal. Uses only the C library's headers, so that a cross compiler can build
// it.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "renderer/lighting/light_job.h"
#include "renderer/simd/isa/kernel_set.h"

namespace glint::GLINT_ISA {
extern const ColorKernels colors;
extern const DrawingKernels drawing;
}  // namespace glint::GLINT_ISA

namespace {

using namespace glint;

constexpr std::size_t blocks = 40;  // more than two batches, and not a multiple of them

/// A linear congruential generator (Knuth, MMIX): the same numbers on every machine.
class Numbers {
  public:
    std::uint32_t bits() {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::uint32_t>(state_ >> 32);
    }
    float between(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits() >> 8) * 0x1p-24f);
    }
    Float3 rgb(float low, float high) {
        const float x = between(low, high), y = between(low, high);
        return {x, y, between(low, high)};
    }
    Float3 unit() {
        Float3 v = rgb(-1, 1);
        const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
        return {v.x / length, v.y / length, v.z / length};
    }

  private:
    std::uint64_t state_ = 20;
};

std::vector<PointBlock> some_points(Numbers& number) {
    std::vector<PointBlock> points(blocks);
    for (PointBlock& block : points)
        for (std::size_t i = 0; i < block_size; ++i) {
            const bool none = number.bits() % 19 == 0;  // all zeros, as after an object's last point
            const Float3 n = number.unit();
            block.x[i] = none ? 0 : number.between(-3, 3);
            block.y[i] = none ? 0 : number.between(-3, 3);
            block.z[i] = none ? 0 : number.between(-9, -1);
            block.nx[i] = none ? 0 : n.x;
            block.ny[i] = none ? 0 : n.y;
            block.nz[i] = none ? 0 : std::abs(n.z);
        }
    return points;
}

/// A directional light, a point light, a point light with falloff, a spot, a sample of an area light, and so
/// on.
std::vector<LightSource> some_lights(Numbers& number) {
    std::vector<LightSource> lights(10);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        LightSource& light = lights[i];
        light.light = static_cast<int>(i);
        light.w = i % 5 == 0 ? 0.0f : 1.0f;
        light.xyz = light.w > 0 ? number.rgb(-5, 5) : number.unit();
        light.ambient = number.rgb(0, i % 2 ? 0.0f : 0.2f);
        light.diffuse = number.rgb(0, 1);
        light.specular = number.rgb(0, 1);
        light.axis = number.unit();
        light.has_falloff = i % 5 == 2;
        light.has_cone = i % 5 == 3;
        light.is_patch = i % 5 == 4;
        if (light.has_falloff) {
            light.linear = number.between(0, 1);
            light.quadratic = number.between(0, 1);
        }
        if (light.has_cone) {
            light.cos_cutoff = number.between(-0.5f, 0.9f);
            light.exponent = number.between(0, 20);
        }
        light.patch = light.is_patch ? number.between(0, 1) : 0.0f;
    }
    return lights;
}

LightJob some_job(Numbers& number, const std::vector<LightSource>& lights, Reflection model) {
    LightJob job;
    job.lights = lights.data();
    job.light_count = lights.size();
    job.model = model;
    job.material.k_a = number.rgb(0, 1);
    job.material.k_d = number.rgb(0, 1);
    job.material.k_s = number.rgb(0, 1);
    job.material.f0 = number.rgb(0, 1);
    job.material.shininess = number.bits() % 2 ? 32.0f : number.between(0, 200);
    job.material.roughness = number.between(0, 1);
    job.material.emission = number.rgb(0, 0.1f);
    job.infinite_viewer = number.bits() % 4 == 0;
    return job;
}

/// FNV-1a over 32-bit words; all NaNs count as the same, because processors choose their sign.
class Hash {
  public:
    void add(std::uint32_t word) { value_ = (value_ ^ word) * 1099511628211ull; }
    void add(float number) {
        std::uint32_t word = 0;
        std::memcpy(&word, &number, sizeof word);
        add(number != number ? 0x7FC00000u : word);
    }
    void add(const std::vector<ColorBlock>& colors) {
        for (const ColorBlock& block : colors)
            for (const auto& channel : {&block.r, &block.g, &block.b})
                for (const float c : *channel) add(c);
    }
    void print(const char* what, int which) const {
        std::printf("%s %d %016llx\n", what, which, static_cast<unsigned long long>(value_));
    }

  private:
    std::uint64_t value_ = 14695981039346656037ull;
};

using Mistake = bool Mistakes::*;
constexpr Mistake in_the_equation[] = {&Mistakes::unnormalized_light,
                                       &Mistakes::unnormalized_half,
                                       &Mistakes::specular_behind_surface,
                                       &Mistakes::no_clamp_of_cosine,
                                       &Mistakes::half_angle_with_phong_shininess,
                                       &Mistakes::ambient_per_light_added_twice,
                                       &Mistakes::clamp_each_light,
                                       &Mistakes::shininess_as_fraction};

std::vector<ColorBlock> lit(const LightJob& job, const std::vector<PointBlock>& points) {
    std::vector<ColorBlock> colors(blocks);
    GLINT_ISA::colors.lighting.light(job, points.data(), nullptr, nullptr, colors.data(), blocks);
    return colors;
}

void light_all(Numbers& number, const std::vector<PointBlock>& points) {
    for (int which = 0; which < 7 * 8; ++which) {
        const std::vector<LightSource> lights = some_lights(number);
        LightJob job = some_job(number, lights, static_cast<Reflection>(which % 7));
        if (which % 3 == 1) job.grid = 0x1p-22f;
        if (which % 5 == 1) job.clamp = true;
        if (which % 4 == 3) job.power_table = 64;
        job.any_mistake = which % 2 == 1;
        if (job.any_mistake) job.mistakes.*in_the_equation[which / 7] = true;
        const std::vector<ColorBlock> colors = lit(job, points);
        Hash hash;
        hash.add(colors);
        hash.print("light", which);

        std::vector<std::uint32_t> rgba(blocks * block_size);
        GLINT_ISA::colors.lighting.encode({number.between(0.5f, 2), which % 2 == 0}, colors.data(),
                                          rgba.data(), blocks);
        Hash bytes;
        for (const std::uint32_t pixel : rgba) bytes.add(pixel);
        bytes.print("encode", which);
    }
}

/// Corners that triangles share, as in an object.
struct SomeMesh {
    std::vector<TransformedVertex> vertices;
    std::vector<CameraNormal> normals;
    std::vector<std::uint32_t> triangle_vertices;
};

constexpr std::uint32_t vertex_count = 300, triangle_count = 500;

SomeMesh some_mesh(Numbers& number) {
    SomeMesh mesh;
    for (std::uint32_t i = 0; i < vertex_count; ++i) {
        TransformedVertex v;
        v.clip_w = number.between(1, 9);
        v.clip_x = number.between(-1, 1) * v.clip_w;
        v.clip_y = number.between(-1, 1) * v.clip_w;
        v.x = number.between(-3, 3);
        v.y = number.between(-3, 3);
        v.z = -v.clip_w;
        mesh.vertices.push_back(v);
        const Float3 n = number.unit();
        mesh.normals.push_back({n.x, n.y, n.z});
    }
    for (std::uint32_t i = 0; i < 3 * triangle_count; ++i)
        mesh.triangle_vertices.push_back(number.bits() % vertex_count);
    return mesh;
}

void place_all(Numbers& number) {
    const SomeMesh mesh = some_mesh(number);
    InterpolateJob job;
    job.vertices = mesh.vertices.data();
    job.normals = mesh.normals.data();
    job.triangle_vertices = mesh.triangle_vertices.data();
    job.width = 640;
    job.height = 480;
    Hash hash;
    std::vector<std::uint32_t> plane(640 * 200);
    job.seen = plane.data();
    for (int which = 0; which < 200; ++which) {
        const PixelGroup group{static_cast<std::uint32_t>(640 * which + 16 * (which % 40)), 0, 0xFFFF};
        std::uint32_t* seen = &plane[group.first_pixel];
        const int alike = 1 + which % 12;  // the number of neighbours with the same value
        for (int i = 0; i < static_cast<int>(block_size); ++i) {
            const std::uint32_t triangle = number.bits() % triangle_count;  // fixes the order of calls
            seen[i] = seen_code<std::uint32_t>(triangle, number.bits() % 2 != 0);
            if (i % alike != 0) seen[i] = seen[i - 1];
        }
        job.two_sided = which % 2 != 0;
        PointBlock out{};
        std::uint8_t told = 0;
        GLINT_ISA::drawing.surface.interpolate(job, &group, 1, &out, &told);
        hash.add(std::uint32_t{told});
        if (!told) continue;
        for (const auto& numbers : {&out.x, &out.y, &out.z, &out.nx, &out.ny, &out.nz})
            for (const float a : *numbers) hash.add(a);
        std::array<float, 3 * block_size> weights{};
        GLINT_ISA::drawing.surface.weigh(job, &group, 1, weights.data(), &told);
        hash.add(std::uint32_t{told});
        for (const float a : weights) hash.add(a);
    }
    hash.print("place", 200);
}

void place_vertices_and_normals(Numbers& number) {
    constexpr std::size_t count = 203;  // not a multiple of any width
    std::vector<float> numbers;
    for (std::size_t i = 0; i < 3 * count; ++i) numbers.push_back(number.between(-6, 6));
    std::vector<TransformedVertex> vertices(count);
    std::vector<ScreenVertex> on_screen(count);
    VertexJob job;
    job.positions = numbers.data();
    job.view_from_object = {{{0.8, 0.6, 0, 0}, {-0.6, 0.8, 0, 0}, {0, 0, 1, 0}, {0.1, 0.2, -4, 1}}};
    job.clip_from_view = {{{1.4, 0, 0, 0}, {0, 2.4, 0, 0}, {0, 0, -1.02, -1}, {0, 0, -0.2, 0}}};
    job.viewport = {640, 480, false};
    job.vertices = vertices.data();
    job.on_screen = on_screen.data();
    GLINT_ISA::drawing.geometry.transform_vertices(job, 0, count);
    Hash hash;
    for (const TransformedVertex& v : vertices) {
        for (const float a : {v.clip_x, v.clip_y, v.clip_w, v.x, v.y, v.z}) hash.add(a);
        hash.add(v.outside);
    }
    for (const ScreenVertex& v : on_screen) {
        hash.add(static_cast<std::uint32_t>(v.x));
        hash.add(static_cast<std::uint32_t>(v.y));
        hash.add(v.inv_w);
    }
    hash.print("vertices", count);
    std::vector<CameraNormal> in_camera(count);
    const Matrix3 matrix{{{0.8, 0.6, 0}, {-1.2, 1.6, 0}, {0, 0, 1}}};
    GLINT_ISA::drawing.geometry.transform_normals({numbers.data(), matrix, in_camera.data()}, 0, count);
    Hash normals;
    for (const CameraNormal& n : in_camera)
        for (const float a : {n.x, n.y, n.z}) normals.add(a);
    normals.print("normals", count);
}

/// A vertex up to `spread` pixels from the centre of the first tile.
ScreenVertex some_vertex(Numbers& number, float spread) {
    const float x = 32 + number.between(-spread, spread), y = 32 + number.between(-spread, spread);
    return {static_cast<std::int32_t>(x * subpixels), static_cast<std::int32_t>(y * subpixels),
            number.between(0, 1), number.bits() % 50 == 0 ? 1u << number.bits() % 7 : 0u};
}

void sort_and_draw(Numbers& number, float spread) {
    std::vector<ScreenVertex> screen;
    for (std::uint32_t i = 0; i < vertex_count; ++i) screen.push_back(some_vertex(number, spread));
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t i = 0; i < 3 * triangle_count; ++i) vertices.push_back(number.bits() % vertex_count);
    BinJob sort;
    sort.triangle_vertices = vertices.data();
    sort.screen = screen.data();
    sort.width = 640;
    sort.height = 480;
    sort.clipped_bits = 0x70;
    sort.beyond_bits = 0x3f;
    sort.drop_clockwise = spread > 50;
    std::vector<TriangleBox> boxes(triangle_count + 1);
    std::vector<std::uint32_t> to_clip(triangle_count + 1);
    BinnedTriangles sorted{boxes.data(), 0, to_clip.data(), 0};
    GLINT_ISA::drawing.visibility.bin(sort, 0, triangle_count, sorted);
    Hash hash;
    std::vector<TileEntry> entries;
    for (std::size_t i = 0; i < sorted.box_count; ++i) {
        const std::uint32_t n = boxes[i].number;
        hash.add(n);
        hash.add(boxes[i].tiles);
        entries.push_back({n, {vertices[3 * n], vertices[3 * n + 1], vertices[3 * n + 2]}});
    }
    for (std::size_t i = 0; i < sorted.to_clip_count; ++i) hash.add(to_clip[i]);
    const DrawnObject object{screen.data(), 0, triangle_count, false};
    TileJob job;
    job.objects = &object;
    job.triangle_count = triangle_count;
    job.entries = entries.data();
    job.count = entries.size();
    static TilePixels tile;
    GLINT_ISA::drawing.visibility.draw(job, tile);
    for (const std::int32_t code : tile.seen) hash.add(static_cast<std::uint32_t>(code));
    for (const float inv_w : tile.inv_w) hash.add(inv_w);
    static std::uint32_t seen[tile_size][tile_size];
    static std::uint16_t covered[tile_size][tile_size / block_size];
    const int within = spread < 100 ? tile_size : 53;  // the visible part of a tile at the picture's border
    GLINT_ISA::drawing.visibility.take_rows(
        tile, {&seen[0][0], &covered[0][0], tile_size, tile_size / block_size, within, within});
    for (const auto& row : seen)
        for (const std::uint32_t code : row) hash.add(code);
    for (const auto& row : covered)
        for (const std::uint16_t bits : row) hash.add(std::uint32_t{bits});
    hash.print("sort and draw", static_cast<int>(spread));
}

void blend_all(Numbers& number, const std::vector<PointBlock>& points) {
    const std::vector<LightSource> lights = some_lights(number);
    const std::vector<ColorBlock> lit_points = lit(some_job(number, lights, Reflection::Phong), points);
    std::vector<ColorRecord> corners;
    for (const ColorBlock& c : lit_points)
        for (std::size_t i = 0; i < block_size; ++i) corners.push_back({c.r[i], c.g[i], c.b[i], 0});
    constexpr int each = 3;
    std::vector<std::uint32_t> numbers(blocks * each * block_size);
    std::vector<float> weights(numbers.size());
    for (std::uint32_t& n : numbers) n = number.bits() % (blocks * block_size);
    for (float& w : weights) w = number.between(0, 1);
    std::vector<ColorBlock> colors(blocks);
    Hash blended, picked;
    GLINT_ISA::colors.shade.blend(corners.data(), numbers.data(), weights.data(), each, colors.data(),
                                  blocks);
    blended.add(colors);
    blended.print("blend", each);
    GLINT_ISA::colors.shade.pick(corners.data(), numbers.data(), colors.data(), blocks);
    picked.add(colors);
    picked.print("pick", 1);
}

}  // namespace

int main() {
    Numbers number;
    const std::vector<PointBlock> points = some_points(number);
    light_all(number, points);
    place_all(number);
    place_vertices_and_normals(number);
    for (const float spread : {4.0f, 40.0f, 400.0f, 400000.0f}) sort_and_draw(number, spread);
    blend_all(number, points);
}
