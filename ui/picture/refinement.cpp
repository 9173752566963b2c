#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/picture/draw_picture.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int paths_at_first = 1;
constexpr int growth =
    4;  // of the paths from picture to picture: each of the two renderers follows most of them
constexpr double look_again = 0.05;  // seconds between checks of the job

int wanted_paths(const Scene& scene) {
    return scene.transport.model == TransportModel::Bounces ? scene.transport.paths : 0;
}

Scene with_paths(Scene scene, int paths) {
    scene.transport.paths = std::min(scene.transport.paths, paths);
    return scene;
}

/// Whether both scenes have the same bounced light: their difference lies after it.
bool same_light(Scene a, const Scene& b) {
    a.display = b.display;
    a.shading.terms = b.shading.terms;
    a.global_ambient = b.global_ambient;
    return same_description(a, b) && same_surfaces(a, b);
}

}  // namespace

const Picture& Refinement::begin(Renderer& renderer, const Scene& scene, PictureSize size, bool linear,
                                 bool passes) {
    if (wanted_paths(scene) == 0 && !wanted_ && !kept_) return renderer.render(scene, size, linear);
    const Wanted now{scene, size, linear};
    if (wanted_ == now) return renderer.render(with_paths(scene, std::max(paths_, 1)), size, linear);
    const bool light_stays = wanted_ && wanted_->size == size && same_light(wanted_->scene, scene);
    const bool resting_is_good = paths_ > paths_at_first && !passing_;
    leave(job_, ending_);
    passing_ = passes;
    since_ = ImGui::GetTime();
    failed_ = false;
    if (spare_ && has_ended(ending_) && (kept_ == now || (passes && resting_is_good))) {
        exchange(renderer);
        std::swap(wanted_, kept_);
        std::swap(paths_, kept_paths_);
        if (wanted_ == now) return renderer.render(with_paths(scene, paths_), size, linear);
    } else if (!passes && wanted_paths(scene) == 0) {
        spare_.reset();
        kept_.reset();
    }
    paths_ = std::min(light_stays ? std::max(paths_, paths_at_first) : paths_at_first, wanted_paths(scene));
    wanted_.reset();
    const Picture& picture = renderer.render(with_paths(scene, std::max(paths_, 1)), size, linear);
    if (wanted_paths(scene) > 0) wanted_ = now;
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
        kept_paths_ = std::exchange(paths_, std::get<int>(result));
        const Wanted& now = *wanted_;
        return &renderer.render(with_paths(now.scene, paths_), now.size, now.linear);
    }
    if (!wanted_ || failed_ || paths_ >= wanted_paths(wanted_->scene)) return nullptr;
    redraw_within(look_again);
    const bool moves = ImGui::GetTime() - since_ < rest_before_full;
    if (job_ || moves || !has_ended(ending_)) return nullptr;
    if (!spare_) spare_ = std::make_shared<Renderer>(threads);
    kept_.reset();
    const int paths = std::min(growth * paths_, wanted_->scene.transport.paths);
    job_ = jobs.start<int>("Bounced light", [spare = spare_, now = *wanted_, paths](LoadProgress& progress) {
        spare->on_paths([&progress](int done, int) { progress.done = static_cast<std::uint64_t>(done); });
        (void)spare->render(with_paths(now.scene, paths), now.size, now.linear);
        return Result<int>(paths);
    });
    return nullptr;
}

float Refinement::progress() const {
    const int all = wanted_ && !failed_ ? wanted_paths(wanted_->scene) : 0;
    if (paths_ >= all) return 1;
    const int followed = job_ ? static_cast<int>(job_->progress().done) : 0;
    // The last path's picture is still on its way.
    return static_cast<float>(std::clamp(followed, paths_, all - 1)) / static_cast<float>(all);
}

void draw_refinement(ImDrawList& list, const PictureView& view, float progress) {
    if (progress >= 1) return;
    const ImVec2 end = view.end(), low{view.origin.x, end.y - px(3)};
    const float reached = low.x + std::max(progress, 0.01f) * (end.x - low.x);
    list.AddRectFilled(low, end, rim_colour(0.5f));
    list.AddRectFilled(low, {reached, end.y}, to_u32(theme().accent));
    list_control("Bounced light", "", {low, end});
}

}  // namespace glint
