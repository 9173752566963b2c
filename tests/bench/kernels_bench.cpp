// Times the lighting kernels alone, on points that stay in the cache, in ns per light and pixel for each
// model. The fastest repetition shows the machine's speed; slower ones were disturbed by other processes.
// Also times the steps before lighting: drawing, and decimating a mesh.
//
//   GLINT_ISA=avx2 kernels_bench --benchmark_filter=blinn

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "models/mesh/primitives/primitives.h"
#include "models/mesh/resolution/resolution.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "renderer/shade/light_sources.h"
#include "renderer/simd/isa/kernel_set.h"
#include "renderer/surface/surface.h"
#include "tests/places.h"

namespace glint::bench {
namespace {

constexpr std::size_t blocks = 1024;

Scene knot(int detail = 572) {
    const std::string path = project_file("tests/bench/knot.json");
    const Result<SceneDocument> opened =
        open_document(path, {{"/objects/0/mesh/detail", std::to_string(detail)}});
    return std::get<SceneDocument>(opened).scene;
}

/// Points sampled from the picture, 16 consecutive blocks at a time at regular intervals; they fit in the
/// second-level cache.
std::vector<PointBlock> points_of(const Scene& scene) {
    Geometry geometry;
    Visibility visibility;
    Surface surface;
    update_geometry(geometry, scene, {1920, 1080});
    update_visibility(visibility, geometry, scene.shading.cull, 1, true);
    update_surface(surface, scene, geometry, visibility, true);
    std::vector<PointBlock> points;
    constexpr std::size_t in_a_row = 16;
    const std::size_t step = surface.points.size() / (blocks / in_a_row);
    for (std::size_t i = 0; i < blocks; ++i)
        points.push_back(surface.points[i / in_a_row * step + i % in_a_row]);
    return points;
}

/// How many of the eight lights reach the points.
enum class Reached { Some, All, None };

/// Copies the first light, a point light with falloff, to positions in front of the points or behind them.
void put_all(std::vector<LightSource>& sources, float z) {
    const LightSource first = sources.front();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        sources[i] = first;
        sources[i].xyz = {0.1f * static_cast<float>(i), 0.3f, z};
    }
}

/// A wall of points at random positions, 5 to 6 units away, that faces the eye.
void make_wall(std::vector<PointBlock>& points) {
    std::minstd_rand random(1);
    std::uniform_real_distribution<float> around(-0.5f, 0.5f);
    for (PointBlock& block : points) {
        for (std::size_t i = 0; i < block_size; ++i) {
            block.x[i] = around(random);
            block.y[i] = around(random);
            block.z[i] = around(random) - 5.5f;
            block.nx[i] = block.ny[i] = 0;
            block.nz[i] = 1;
        }
    }
}

void light(benchmark::State& state, Reflection model, Reached reached) {
    Scene scene = knot();
    scene.shading.reflection = model;
    std::vector<LightSource> sources = light_sources(scene);
    std::vector<PointBlock> points = points_of(scene);
    if (reached != Reached::Some) {
        put_all(sources, reached == Reached::All ? 1.0f : -20.0f);
        make_wall(points);
    }
    const LightJob job = light_job(scene, {1920, 1080}, scene.objects.front().material, sources, false);
    std::vector<ColorBlock> colors(blocks);
    for (auto _ : state) {
        lighting_kernels().light(job, points.data(), nullptr, nullptr, colors.data(), blocks);
        benchmark::DoNotOptimize(colors.data());
        benchmark::ClobberMemory();
    }
    const auto pixel_lights = static_cast<double>(blocks * block_size * sources.size());
    state.counters["pixel-lights"] = benchmark::Counter(
        pixel_lights, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Times the work of a camera drag before lighting, on one thread, in triangles per second.
void draw(benchmark::State& state, Stage last, int detail) {
    Scene scene = knot(detail);
    Geometry geometry;
    Visibility visibility;
    Surface surface;
    for (auto _ : state) {
        scene.camera.eye.x = scene.camera.eye.x > 0 ? -0.01f : 0.01f;
        update_geometry(geometry, scene, {1920, 1080});
        if (last >= Stage::Visibility) update_visibility(visibility, geometry, scene.shading.cull, 1, true);
        if (last >= Stage::Surface) update_surface(surface, scene, geometry, visibility, true);
    }
    state.counters["triangles"] =
        benchmark::Counter(geometry.triangle_count, benchmark::Counter::kIsIterationInvariantRate);
}

/// Decimates the knot from 69 thousand triangles to 2 thousand, which the window does in the background.
void decimate(benchmark::State& state) {
    const Mesh mesh = make_primitive(Primitive::Knot, 525);
    for (auto _ : state) benchmark::DoNotOptimize(with_resolution(mesh, {2000, 0}));
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

void declare(const char* name, Reflection model, Reached reached = Reached::Some) {
    benchmark::RegisterBenchmark(name, light, model, reached)
        ->Repetitions(200)
        ->MinTime(0.003)
        ->ComputeStatistics("least", least)
        ->DisplayAggregatesOnly();
}

void declare_drawing(const char* name, Stage last, int detail) {
    benchmark::RegisterBenchmark(fmt::format("{}/detail {}", name, detail).c_str(), draw, last, detail)
        ->Repetitions(10)
        ->Unit(benchmark::kMillisecond)
        ->ComputeStatistics("least", least)
        ->DisplayAggregatesOnly();
}

void declare_decimating() {
    benchmark::RegisterBenchmark("decimate/to 2000", decimate)
        ->Repetitions(10)
        ->Unit(benchmark::kMillisecond)
        ->ComputeStatistics("least", least)
        ->DisplayAggregatesOnly();
}

}  // namespace
}  // namespace glint::bench

int main(int count, char** words) {
    using glint::Reflection;
    benchmark::Initialize(&count, words);
    benchmark::AddCustomContext("instruction_set", glint::instruction_set_name());
    glint::bench::declare("light/lambert", Reflection::Lambert);
    glint::bench::declare("light/phong", Reflection::Phong);
    glint::bench::declare("light/blinn-phong", Reflection::BlinnPhong);
    glint::bench::declare("light/retro", Reflection::Retro);
    glint::bench::declare("light/oren-nayar", Reflection::OrenNayar);
    glint::bench::declare("light/cook-torrance", Reflection::CookTorrance);
    glint::bench::declare("all lit/lambert", Reflection::Lambert, glint::bench::Reached::All);
    glint::bench::declare("all lit/blinn-phong", Reflection::BlinnPhong, glint::bench::Reached::All);
    glint::bench::declare("none lit/blinn-phong", Reflection::BlinnPhong, glint::bench::Reached::None);
    for (const int detail : {90, 572, 2000}) {
        glint::bench::declare_drawing("geometry", glint::Stage::Geometry, detail);
        glint::bench::declare_drawing("to visibility", glint::Stage::Visibility, detail);
        glint::bench::declare_drawing("to surface", glint::Stage::Surface, detail);
    }
    glint::bench::declare_decimating();
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    benchmark::RunSpecifiedBenchmarks();
}
