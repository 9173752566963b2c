#include "ui/features/views/small_pictures.h"

#include <mutex>
#include <utility>

#include "ui/widgets/widgets.h"

namespace glint {

/// Shared with the drawing job: the job appends, the window removes from the front.
struct DrawnSmall {
    std::mutex mutex;
    std::vector<SmallPicture> done;
};

namespace {

constexpr int sheet_columns = 8;
constexpr double look_again = 0.05;  // seconds between checks for new pictures

Result<int> draw_all(const DrawSmall& draw, int count, DrawnSmall& drawn, const LoadProgress& progress) {
    Renderer renderer(1);  // one thread: the window needs the others
    for (int i = 0; i < count && !progress.cancelled; ++i) {
        SmallPicture one = draw(renderer, i);
        const std::lock_guard lock(drawn.mutex);
        drawn.done.push_back(std::move(one));
    }
    return count;
}

}  // namespace

void begin_small_pictures(Jobs& jobs, SmallPictures& small, const std::string& name, PictureSize cell,
                          int count, DrawSmall draw) {
    const auto many = static_cast<std::size_t>(count);
    if (!(small.sheet.cell == cell) || small.words.size() != many) {
        small.sheet.reset(cell, sheet_columns, count);
        small.words.assign(many, {});
    }
    small.taken = 0;
    small.problem.clear();
    small.drawn = std::make_shared<DrawnSmall>();
    small.job = jobs.start<int>(
        name, [draw = std::move(draw), count, drawn = small.drawn](const LoadProgress& progress) {
            return draw_all(draw, count, *drawn, progress);
        });
}

void stop_small_pictures(SmallPictures& small) {
    small.taken = 0;
    small.drawn.reset();
    if (small.job) small.job->cancel();
}

void take_small_pictures(SmallPictures& small) {
    if (!small.job) return;
    // Checked first: pictures finished from now on are for the next frame.
    const bool done = small.job->done();
    if (small.drawn) {
        const std::lock_guard lock(small.drawn->mutex);
        std::vector<SmallPicture>& all = small.drawn->done;
        for (auto i = static_cast<std::size_t>(small.taken); i < all.size(); ++i) {
            if (!all[i].picture.rgba.empty()) small.sheet.put(static_cast<int>(i), all[i].picture);
            small.words[i] = std::move(all[i].words);
            all[i] = {};
        }
        small.taken = static_cast<int>(all.size());
    }
    if (!done) return redraw_within(look_again);
    const Result<int> result = small.job->take();
    if (const auto* problem = std::get_if<Problem>(&result); small.drawn && problem != nullptr)
        small.problem = problem->text();
    small.drawn.reset();
    small.job.reset();
}

}  // namespace glint
