#include "renderer/renderer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>
#include <utility>

#include "models/fields/choices.h"
#include "models/memory_limit.h"
#include "models/problem.h"
#include "models/scene/scene.h"
#include "renderer/explain/explain.h"
#include "renderer/lighting/display.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"
#include "renderer/simd/isa/kernel_set.h"
#include "renderer/stages.h"
#include "renderer/threads.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct Renderer::Kept {
    explicit Kept(int threads) : arena(threads) {}
    tbb::task_arena arena;
    KeptStages stages;
    FrameStats stats;
    Warnings warnings;
    PathProgress on_paths;
    bool drawn = false;
    Picture scoped;                     // the last picture drawn with scoped mistakes
    std::optional<Scene> scoped_scene;  // its scene, if no other picture has been drawn since

    /// Releases all memory; the next picture is drawn from scratch.
    void forget() {
        const bool follow = stages.lighting.moving_light.allowed;
        const BlockChoice blocks = stages.surface.wanted_blocks;
        stages = KeptStages{};
        stages.surface.wanted_blocks = blocks;
        stages.lighting.moving_light.allowed = follow;
        warnings.clear();
        drawn = false;
    }

    void draw(const Scene& scene, PictureSize size, bool linear, int samples);

    template <class Update> bool run(Stage stage, const Update& update) {
        const auto i = static_cast<std::size_t>(stage);
        const Clock::time_point start = Clock::now();
        stats.redone[i] = update();
        stats.ms[i] = stats.redone[i] ? ms_since(start) : 0;
        return stats.redone[i];
    }

    void collect_warnings(const Scene& scene) {
        WarningList of_normals;
        for (std::size_t o = 0; o < scene.objects.size(); ++o)
            for (const std::string& w : stages.surface.normals[o].of_mesh->warnings)
                of_normals.add(source_name(scene.objects[o].source) + ": " + w);
        warnings = of_normals.take();
        if ((scene.npr.silhouettes || scene.npr.creases) && scene.npr.stroke_width_px > max_stroke_width_px)
            warnings.emplace_back("a stroke wider than 100 pixels is drawn 100 pixels wide");
        if (scene.shading.rules != Rules::OpenGL2) return;
        const auto clamped = std::count_if(scene.objects.begin(), scene.objects.end(), [](const Object& o) {
            return o.material.shininess > opengl_max_shininess;
        });
        warn(warnings, static_cast<std::size_t>(clamped),
             "material has a shininess above 128, which the rules opengl2 clamp to 128",
             "materials have a shininess above 128, which the rules opengl2 clamp to 128");
    }
};

Renderer::Renderer(int threads) : kept_(std::make_unique<Kept>(arena_threads(threads))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::Kept::draw(const Scene& scene, PictureSize size, bool linear, int samples) {
    KeptStages& s = stages;
    arena.execute([&] {
        const bool geometry = run(Stage::Geometry, [&] { return update_geometry(s.geometry, scene, size); });
        const bool visibility = run(Stage::Visibility, [&] {
            return update_visibility(s.visibility, s.geometry, scene.shading.cull, samples, geometry,
                                     culled_by_light(scene, s.geometry));
        });
        const bool surface = run(Stage::Surface, [&] {
            return update_surface(s.surface, scene, s.geometry, s.visibility, visibility);
        });
        const Clock::time_point strokes_start = Clock::now();
        const bool strokes = update_strokes(s.strokes, scene, s.geometry, s.visibility, visibility);
        stats.strokes_redone = strokes;
        stats.strokes_ms = strokes ? ms_since(strokes_start) : 0;
        const bool transport = run(Stage::Transport, [&] {
            return update_transport(s.transport, scene, s.geometry, s.visibility, s.surface,
                                    visibility || surface, on_paths);
        });
        const bool lighting = run(Stage::Lighting, [&] {
            return update_lighting(s.lighting, scene, s.geometry, s.visibility, s.surface, s.strokes,
                                   s.transport.arrivals(), linear, {visibility, surface, strokes, transport});
        });
        if (surface || lighting) collect_warnings(scene);
    });
    if (!drawn || s.scene != scene) s.scene = scene;
    drawn = true;
}

const Picture& Renderer::render(const Scene& scene, PictureSize size, bool linear, int samples) {
    Kept& k = *kept_;
    KeptStages& s = k.stages;
    if (has_scope(scene)) {
        k.scoped = draw_scoped(*this, scene, size, samples);
        k.scoped_scene = scene;
        if (!linear) k.scoped.linear.clear();
        return k.scoped;
    }
    k.scoped_scene.reset();
    const Clock::time_point start = Clock::now();
    if (const auto problem = too_large(scene, size, samples)) throw LimitExceeded(*problem);
    try {
        k.draw(scene, size, linear, samples);
    } catch (...) {  // some stages have this scene's results, others the previous one's
        RayScene rays = std::move(s.transport.rays);  // complete or none
        k.forget();
        s.transport.rays = std::move(rays);
        throw;
    }
    s.lighting.picture.samples = samples;
    k.stats.total_ms = ms_since(start);
    k.stats.triangles = s.geometry.triangle_count;
    k.stats.shaded_pixels = s.surface.pixel_count;
    k.stats.evaluations =
        scene.shading.reflection == Reflection::None ? 0 : s.surface.point_count * s.lighting.sources.size();
    k.stats.threads = k.arena.max_concurrency();
    k.stats.instruction_set = instruction_set_name();
    return s.lighting.picture;
}

void Renderer::draw_blocks(BlockChoice blocks) { kept_->stages.surface.wanted_blocks = std::move(blocks); }
void Renderer::keep_sums(bool keep) { kept_->stages.lighting.moving_light.allowed = keep; }
void Renderer::on_paths(std::function<void(int, int)> progress) { kept_->on_paths = std::move(progress); }
bool Renderer::has_rays() const { return kept_->stages.transport.rays.is_of(kept_->stages.scene); }
std::vector<TracedLight> Renderer::shadow_rays(int x, int y, int corner) const {
    return trace_lights(kept_->stages, x, y, corner);
}
std::vector<PathStep> Renderer::bounce_path(int x, int y, int path, int corner) const {
    return trace_path(kept_->stages, x, y, path, corner);
}
const FrameStats& Renderer::stats() const { return kept_->stats; }
const Warnings& Renderer::warnings() const { return kept_->warnings; }
Explanation Renderer::explain(int x, int y) const {
    if (kept_->scoped_scene) return explain_scoped(*this, *kept_->scoped_scene, x, y);
    return explain_pixel(kept_->stages, x, y);
}
Explanation Renderer::explain_as(const Scene& other, int x, int y) const {
    if (has_scope(other)) return explain_scoped(*this, other, x, y);
    return explain_pixel_as(kept_->stages, other, x, y);
}

float Renderer::stroke_at(int x, int y) const {
    const KeptStages& s = kept_->stages;
    return s.strokes.coverage_at(s.lighting.picture.pixel(x, y));
}

int Renderer::object_at(int x, int y) const {
    const KeptStages& s = kept_->stages;
    const std::uint32_t triangle = s.visibility.triangle_at(s.lighting.picture.pixel(x, y));
    return triangle == no_triangle ? -1 : static_cast<int>(s.geometry.object_of(triangle));
}

std::optional<SeenPoint> Renderer::seen_at(int x, int y) const {
    const KeptStages& s = kept_->stages;
    const std::size_t pixel = s.lighting.picture.pixel(x, y);
    const std::uint32_t triangle = s.visibility.triangle_at(pixel);
    if (triangle == no_triangle) return std::nullopt;
    const SampleFace face = sample_face(s.surface.choice, s.geometry, s.visibility, x, y);
    const PositionNormal at = pixel_point(s.surface, s.geometry, face);
    return SeenPoint{static_cast<int>(face.object),
                     s.geometry.triangle(face.object, triangle).face,
                     at.p,
                     at.n,
                     !s.visibility.back_at(pixel),
                     triangle};
}

float Renderer::depth_at(int x, int y) const {
    if (object_at(x, y) < 0) return 0;
    const KeptStages& s = kept_->stages;
    const SampleFace face = sample_face(s.surface.choice, s.geometry, s.visibility, x, y);
    return -pixel_point(s.surface, s.geometry, face).p.z;
}

namespace {

bool is_meant(const MistakeScope& scope, const Scene& scene, std::size_t light) {
    return (scope.light < 0 || static_cast<std::size_t>(scope.light) == light) &&
           (scope.lights == ScopeLights::All ||
            static_cast<int>(scene.lights[light].kind) + 1 == static_cast<int>(scope.lights));
}

}  // namespace

bool has_scope(const Scene& scene) {
    const Mistakes& mistakes = scene.shading.mistakes;
    return !mistakes.only.is_all() && !mistakes.culled_by_light;
}

Scene isolated(Scene scene, const MistakeScope& scope) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].enabled = scene.lights[i].enabled && is_meant(scope, scene, i);
    scene.global_ambient = glm::vec3(0);
    Terms& terms = scene.shading.terms;
    terms.emission = false;
    if (scope.term == ScopeTerm::All) return scene;
    terms.ambient = false;
    (scope.term == ScopeTerm::Diffuse ? terms.specular : terms.diffuse) = false;
    return scene;
}

namespace {

/// The mistakes that are conventions in many programs. If the scene also has other mistakes, these are made
/// everywhere, regardless of the scope.
Mistakes conventions_of(const Mistakes& all) {
    Mistakes conventions;
    conventions.specular_behind_surface = all.specular_behind_surface;
    conventions.interpolated_lengths = all.interpolated_lengths;
    conventions.highlight_normalized = all.highlight_normalized;
    conventions.highlight_form = all.highlight_form;
    Mistakes others = all;
    others.only = {};
    return others == conventions ? Mistakes{} : conventions;
}

/// The scene without its mistakes, and the scene with its mistakes made everywhere.
struct BothScenes {
    explicit BothScenes(const Scene& scene) : right(scene), wrong(scene) {
        right.shading.mistakes = conventions_of(scene.shading.mistakes);
        wrong.shading.mistakes.only = {};
    }
    Scene right, wrong;
};

/// Replaces the terms of the scope's lights with those in `wrong`, which is the same point with the mistakes.
void take_meant(ExplainedPoint& point, const ExplainedPoint& wrong, const Scene& scene) {
    const MistakeScope& scope = scene.shading.mistakes.only;
    for (ExplainedLight& light : point.lights) {
        if (!is_meant(scope, scene, static_cast<std::size_t>(light.index))) continue;
        const auto same = [&light](const ExplainedLight& other) { return other.index == light.index; };
        const auto found = std::ranges::find_if(wrong.lights, same);
        if (found == wrong.lights.end()) continue;
        const ExplainedLight right = std::exchange(light, *found);
        if (scope.term == ScopeTerm::All) continue;
        light.ambient = right.ambient;
        if (scope.term == ScopeTerm::Diffuse) light.specular = right.specular;
        if (scope.term == ScopeTerm::Specular) light.diffuse = right.diffuse;
        if (right.samples.empty()) light.share = light.ambient + light.diffuse + light.specular;
    }
}

}  // namespace

Explanation explain_scoped(const Renderer& renderer, const Scene& scene, int x, int y) {
    const MistakeScope scope = scene.shading.mistakes.only;
    const BothScenes both(scene);
    Explanation e = renderer.explain_as(both.right, x, y);
    if (!e.hit || (scope.object >= 0 && e.object_index != scope.object)) return e;
    Explanation wrong = renderer.explain_as(both.wrong, x, y);
    if (scope.is_of_light()) {
        take_meant(e.at, wrong.at, scene);
        for (std::size_t i = 0; i < std::min(e.corners.size(), wrong.corners.size()); ++i)
            take_meant(e.corners[i].at, wrong.corners[i].at, scene);
        const auto sum_of = [&](const Scene& part) {
            return renderer.explain_as(isolated(part, scope), x, y).sum;
        };
        e.sum = sum_of(both.wrong) + (e.sum - sum_of(both.right));
        if (!e.lit_per_corner) e.at.sum = e.sum;
    } else {
        e = std::move(wrong);
    }
    const DisplayJob job = display_job(scene.display, {});
    for (int i = 0; i < 3; ++i) {
        e.displayed[i] = displayed(job, e.sum[i]);
        e.byte[static_cast<std::size_t>(i)] = byte_of(e.displayed[i]);
    }
    return e;
}

Picture draw_scoped(Renderer& renderer, const Scene& scene, PictureSize size, int samples) {
    const MistakeScope scope = scene.shading.mistakes.only;
    const auto [right, wrong] = BothScenes(scene);
    const auto linear_of = [&](const Scene& of) { return renderer.render(of, size, true, samples).linear; };
    Picture picture = renderer.render(right, size, true, samples);
    std::vector<float>& sum = picture.linear;
    std::vector<float> edited;
    if (scope.is_of_light()) {
        const std::vector<float> before = linear_of(isolated(right, scope));
        edited = linear_of(isolated(wrong, scope));
        for (std::size_t i = 0; i < sum.size(); ++i) edited[i] += sum[i] - before[i];
    }
    const Picture& everywhere = renderer.render(wrong, size, true, samples);  // explain() refers to it
    if (!scope.is_of_light()) edited = everywhere.linear;
    const DisplayJob job = display_job(scene.display, {});
    for (std::size_t i = 0; i < size.pixels(); ++i) {
        const int x = static_cast<int>(i % std::size_t(size.width));
        const int y = static_cast<int>(i / std::size_t(size.width));
        const int object = renderer.object_at(x, y);
        if (object < 0 || (scope.object >= 0 && object != scope.object)) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            sum[3 * i + c] = edited[3 * i + c];
            picture.rgba[4 * i + c] = static_cast<std::uint8_t>(byte_of(displayed(job, edited[3 * i + c])));
        }
    }
    return picture;
}

}  // namespace glint
