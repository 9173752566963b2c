#include "ui/features/views/small_pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <mutex>
#include <utility>
#include <vector>

#include "diagnose/search/display_change.h"
#include "ui/picture/screen.h"
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

namespace {

constexpr std::uint8_t beyond = 118;  // the grey that surrounds every picture (Theme::surround)

/// Computes linear colours, before exposure, from the displayed bytes.
void fill_linear(Picture& picture, const Display& display) {
    picture.linear.resize(3 * picture.size.pixels());
    const Code code = display.transfer == Transfer::Srgb ? Code::Decoded : Code::Same;
    for (std::size_t i = 0; i < picture.linear.size(); ++i) {
        const auto level = static_cast<float>(picture.rgba[i / 3 * 4 + i % 3]);
        picture.linear[i] = coded(code, level / 255) / std::max(display.exposure, 1e-6f);
    }
}

}  // namespace

PixelsBetween pixels_between(const Camera& camera, PictureSize from, PictureSize to) {
    const ScreenMap first = screen_map(camera, from), second = screen_map(camera, to);
    const double depth = glm::distance(camera.eye, camera.target);
    const auto carried = [&](glm::dvec2 pixel) {
        return project(second, unproject(first, pixel, depth)).pixel;
    };
    const glm::dvec2 end(from.width, from.height), low = carried({0, 0});
    return {(carried(end) - low) / end, low};
}

std::optional<glm::ivec2> pixel_in(const PixelsBetween& between, glm::ivec2 pixel, PictureSize to) {
    const glm::dvec2 at = between(glm::dvec2(pixel) + 0.5);
    if (!is_inside(to, at)) return std::nullopt;
    return nearest_pixel(to, at);
}

Picture fitted_picture(const Picture& picture, const Scene& scene, const Picture& shown, bool fills) {
    const PictureSize size = shown.size;
    const PixelsBetween between = pixels_between(scene.camera, size, picture.size);
    Picture fitted{size, fills ? shown.rgba : std::vector<std::uint8_t>(4 * size.pixels(), beyond), {}};
    std::vector<int> columns(static_cast<std::size_t>(size.width), -1);
    for (int x = 0; x < size.width; ++x) {
        const double at = std::floor(between({x + 0.5, 0}).x);
        if (at >= 0 && at < picture.size.width) columns[static_cast<std::size_t>(x)] = static_cast<int>(at);
    }
    for (int y = 0; y < size.height; ++y) {
        const double row = std::floor(between({0, y + 0.5}).y);
        for (int x = 0; x < size.width; ++x) {
            const std::size_t to = 4 * size.index(x, y);
            fitted.rgba[to + 3] = 255;
            const int column = columns[static_cast<std::size_t>(x)];
            if (column < 0 || row < 0 || row >= picture.size.height) continue;
            std::copy_n(&picture.rgba[4 * picture.pixel(column, static_cast<int>(row))], 3, &fitted.rgba[to]);
        }
    }
    if (!shown.linear.empty()) fill_linear(fitted, scene.display);
    return fitted;
}

}  // namespace glint
