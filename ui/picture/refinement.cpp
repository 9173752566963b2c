#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/picture/draw_picture.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int rays_at_first = 1;
constexpr int growth = 4;            // each picture has this many times the rays of the last one
constexpr double look_again = 0.05;  // seconds between checks of the job

/// Returns the largest number of rays per point of the scene: paths, or shadow rays to an area light. 0 if
/// there are so few that refinement is not needed.
int wanted_rays(const Scene& scene) {
    if (scene.transport.model == TransportModel::Local) return 0;
    int rays = scene.transport.model == TransportModel::Bounces ? scene.transport.paths : 0;
    for (const Light& light : scene.lights)
        if (light.enabled && light.kind == LightKind::Area) rays = std::max(rays, light.area.samples);
    return rays;
}

/// Returns the scene with at most `rays` of each kind; 0: all.
Scene with_rays(Scene scene, int rays) {
    if (rays == 0) return scene;
    scene.transport.paths = std::min(scene.transport.paths, rays);
    const int side = static_cast<int>(std::sqrt(static_cast<double>(rays)));
    for (Light& light : scene.lights) light.area.samples = std::min(light.area.samples, side * side);
    return scene;
}

/// Whether the two scenes have the same bounced light, because they differ only in later steps.
bool same_light(Scene a, const Scene& b) {
    a.display = b.display;
    a.shading.terms = b.shading.terms;
    a.global_ambient = b.global_ambient;
    return same_description(a, b) && same_surfaces(a, b);
}

}  // namespace

const Picture& Refinement::begin(Renderer& renderer, const Scene& scene, PictureSize size, bool linear,
                                 bool passes) {
    if (wanted_rays(scene) == 0 && !wanted_ && !kept_) return renderer.render(scene, size, linear);
    const Wanted now{scene, size, linear};
    if (wanted_ == now) return renderer.render(with_rays(scene, rays_), size, linear);
    const bool light_stays = wanted_ && wanted_->size == size && same_light(wanted_->scene, scene);
    const bool resting_is_good = rays_ > rays_at_first && !passing_;
    leave(job_, ending_);
    passing_ = passes;
    since_ = ImGui::GetTime();
    failed_ = false;
    if (spare_ && has_ended(ending_) && (kept_ == now || (passes && resting_is_good))) {
        exchange(renderer);
        std::swap(wanted_, kept_);
        std::swap(rays_, kept_rays_);
        if (wanted_ == now) return renderer.render(with_rays(scene, rays_), size, linear);
    } else if (!passes && wanted_rays(scene) == 0) {
        spare_.reset();
        kept_.reset();
    }
    rays_ = std::min(light_stays ? std::max(rays_, rays_at_first) : rays_at_first, wanted_rays(scene));
    wanted_.reset();
    const Picture& picture = renderer.render(with_rays(scene, rays_), size, linear);
    if (wanted_rays(scene) > 0) wanted_ = now;
    return picture;
}

void Refinement::exchange(Renderer& renderer) {
    std::swap(renderer, *spare_);
    renderer.on_paths({});
}

const Picture* Refinement::advance(Renderer& renderer, Jobs& jobs, int threads) {
    if (job_ && job_->done()) {
        const Result<int> result = std::exchange(job_, nullptr)->take();
        if (const auto* problem = std::get_if<Problem>(&result)) {
            failed_ = true;
            say_refused(problem->text());
            return nullptr;
        }
        exchange(renderer);
        kept_ = wanted_;
        kept_rays_ = std::exchange(rays_, std::get<int>(result));
        const Wanted& now = *wanted_;
        return &renderer.render(with_rays(now.scene, rays_), now.size, now.linear);
    }
    if (!wanted_ || failed_ || rays_ >= wanted_rays(wanted_->scene)) return nullptr;
    redraw_within(look_again);
    const bool moves = ImGui::GetTime() - since_ < rest_before_full;
    if (job_ || moves || !has_ended(ending_)) return nullptr;
    if (!spare_) spare_ = std::make_shared<Renderer>(threads);
    kept_.reset();
    const int rays = std::min(growth * rays_, wanted_rays(wanted_->scene));
    job_ = jobs.start<int>("Light paths", [spare = spare_, now = *wanted_, rays](LoadProgress& progress) {
        spare->on_paths([&progress](int done, int) { progress.done = static_cast<std::uint64_t>(done); });
        (void)spare->render(with_rays(now.scene, rays), now.size, now.linear);
        return Result<int>(rays);
    });
    return nullptr;
}

float Refinement::progress() const {
    const int all = wanted_ && !failed_ ? wanted_rays(wanted_->scene) : 0;
    if (rays_ >= all) return 1;
    const int followed = job_ ? static_cast<int>(job_->progress().done) : 0;
    // Stays below 1, because the picture with the last path is not ready yet.
    return static_cast<float>(std::clamp(followed, rays_, all - 1)) / static_cast<float>(all);
}

void draw_refinement(ImDrawList& list, const PictureView& view, float progress) {
    if (progress >= 1) return;
    const ImVec2 end = view.end(), low{view.origin.x, end.y - px(3)};
    const float reached = low.x + std::max(progress, 0.01f) * (end.x - low.x);
    list.AddRectFilled(low, end, rim_colour(0.5f));
    list.AddRectFilled(low, {reached, end.y}, to_u32(theme().accent));
    const std::string label = fmt::format("Light paths: {:.0f} %", std::floor(100 * progress));
    const ImVec2 size = ImGui::CalcTextSize(label.c_str()), at{low.x + px(8), low.y - size.y - px(6)};
    list.AddRectFilled(at - ImVec2(px(5), px(2)), at + size + ImVec2(px(5), px(2)), rim_colour(0.5f), px(3));
    list.AddText(at, to_u32(dark_theme().text), label.c_str());
    list_control("Light paths", label.c_str(), {low, end});
}

}  // namespace glint
