#include "diagnose/search/score.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

/// The colours that a picture may show at the pixels of a row, channels in the scene's order.
class ExpectedRow {
  public:
    /// `ranges` are those of `change`. All arguments but the last must outlive this.
    ExpectedRow(const Picture& drawn, const BareMask* bare, const ByteRanges& ranges,
                const DisplayChange& change, const Ground& ground, int y)
        : drawn_(drawn),
          bare_(bare != nullptr && !bare->empty() && ground.is_known ? bare : nullptr),
          ranges_(ranges),
          scatter_(change.scatter()),
          ground_(ground),
          first_(drawn.pixel(0, y)) {
        if (change.soft) near_.emplace(drawn, y);
    }

    [[nodiscard]] std::array<ByteRange, 3> at(int x) const {
        const std::size_t pixel = first_ + static_cast<std::size_t>(x);
        std::array<ByteRange, 3> expected;
        if (bare_ != nullptr && (*bare_)[pixel] != 0) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float level = ground_.levels[c];
                expected[c] = {level - scatter_, level, level + scatter_, false};
            }
            return expected;
        }
        for (std::size_t c = 0; c < 3; ++c) expected[c] = ranges_[drawn_.rgba[4 * pixel + c]];
        if (!near_) return expected;
        const RgbBounds near = near_->at(x);  // allowed because no curve decreases
        for (std::size_t c = 0; c < 3; ++c) {
            expected[c].low = ranges_[near.low[c]].low;
            expected[c].high = ranges_[near.high[c]].high;
        }
        return expected;
    }

    /// The difference in levels between the darkest and the brightest of a pixel and its neighbours as drawn,
    /// without the range that rounding and clamping allow. Precondition: the change is soft.
    [[nodiscard]] float contrast_at(int x, std::size_t channel) const {
        const RgbBounds near = near_->at(x);
        return ranges_[near.high[channel]].middle - ranges_[near.low[channel]].middle;
    }

  private:
    const Picture& drawn_;
    const BareMask* bare_;  // null: the drawing shows a surface everywhere
    const ByteRanges& ranges_;
    float scatter_;
    const Ground& ground_;
    std::size_t first_;              // the index of the row's first pixel
    std::optional<RowBounds> near_;  // only if the change is soft
};

/// Whether a softened picture would vary around a pixel, but the wrong picture hardly does. Neighbours of
/// very different colours allow any colour between them, but softening keeps a share of their contrast.
bool lacks_contrast(const Exhibit& e, const DisplayChange& change, const ExpectedRow& expected,
                    const std::array<ByteRange, 3>& explained, glm::ivec2 at) {
    constexpr float far_apart = 48, least_share = 1.0f / 6;  // in levels; as a fraction of the contrast
    std::optional<RgbBounds> mine;                           // most pixels need none
    for (std::size_t c = 0; c < 3; ++c) {
        if (explained[c].high - explained[c].low < far_apart) continue;
        const float contrast = expected.contrast_at(at.x, c);
        if (contrast < far_apart) continue;
        if (!mine) mine = bounds_around(e.wrong, changed_place(change, e.wrong.size, at));
        const std::size_t channel = changed_channel(change, c);
        if (static_cast<float>(mine->high[channel] - mine->low[channel]) < least_share * contrast)
            return true;
    }
    return false;
}

/// Adds a pixel to `row`. Returns whether it is unlike the explanation. `misses`: count it as unlike
/// even if its colour is in the explained range.
bool add_pixel(Score& row, const std::array<ByteRange, 3>& explained, const std::array<ByteRange, 3>& right,
               Rgb mine, glm::ivec2 at, bool misses) {
    float off = 0, off_right = 0, told = 0, apart = 0, apart_right = 0;
    bool open = false;  // the drawn colour was clamped, and may have been the wrong picture's before
    for (std::size_t c = 0; c < 3; ++c) {
        const float d = explained[c].distance(mine[c]), d_right = right[c].distance(mine[c]);
        off = std::max(off, d);
        off_right = std::max(off_right, d_right);
        told += d_right - 2 * explained[c].from_middle(mine[c]);
        open |= explained[c].off(mine[c]) < explained[c].from_middle(mine[c]);
        row.excess += double(excess_of(d));
        row.squares += double(d) * double(d);
        apart = std::max(apart, explained[c].off(mine[c]));
        apart_right = std::max(apart_right, right[c].off(mine[c]));
    }
    const bool is_wrong = off_right > visible_levels, is_unlike = misses || off > visible_levels;
    if (misses) row.excess += double(excess_of(off + 2 * visible_levels));
    ++row.compared;
    row.unlike += is_unlike ? 1 : 0;
    row.far += off > clear_levels ? 1 : 0;
    row.wrong += is_wrong ? 1 : 0;
    row.explained += is_wrong && !is_unlike ? 1 : 0;
    row.off += is_wrong ? double(apart) : 0;
    row.off_right += is_wrong ? double(apart_right) : 0;
    constexpr float of_open = 1.0f / 1024;  // an open pixel counts only if no other is decisive
    if (open) told *= of_open;
    if (told > row.told_best) {
        row.told_best = told;
        row.pixel = at;
    }
    return is_unlike;
}

void add(Score& all, const Score& row) {
    all.compared += row.compared;
    all.unlike += row.unlike;
    all.far += row.far;
    all.wrong += row.wrong;
    all.explained += row.explained;
    all.excess += row.excess;
    all.off += row.off;
    all.off_right += row.off_right;
    all.squares += row.squares;
    if (row.told_best <= all.told_best) return;
    all.told_best = row.told_best;
    all.pixel = row.pixel;
}

}  // namespace

double Score::residual() const {
    return compared == 0 ? 0 : std::sqrt(squares / (3.0 * static_cast<double>(compared)));
}

double Score::share_explained() const {
    return wrong == 0 ? 1 : static_cast<double>(explained) / static_cast<double>(wrong);
}

bool Score::comes_nearer() const {
    constexpr double share = 0.5;
    return off <= share * off_right;
}

bool Score::fits() const {
    constexpr std::uint64_t few = 4, per_solid = 2000, per_unlike = 100;
    if (!may_fit()) return false;
    // A highlight's cut or a spot's edge may be off by a pixel, which affects many pixels in lines, but no
    // area.
    return solid <= few || (unlike * per_unlike <= compared && solid * per_solid <= compared);
}

bool Score::may_fit() const {
    constexpr std::uint64_t per_unlike = 16;
    return compared > 0 && unlike * per_unlike <= compared;
}

Exhibit::Exhibit(const Picture& wrong_picture, const Picture& right_picture,
                 const std::vector<PixelKind>& of_pixels, float noise)
    : wrong(wrong_picture), right(right_picture), kinds(of_pixels) {
    least_change.noise = noise;
    for (DisplayChange turned : ways_of_turning()) {
        turned.noise = noise;
        grounds[way_turned(turned)] = background_of(wrong, kinds, turned);
        bare_grounds[way_turned(turned)] = ground_of(wrong, kinds, turned);
    }
}

namespace {

/// Counts the marked pixels whose four neighbours are marked, excluding the picture's border.
std::uint64_t count_solid(const std::vector<std::uint8_t>& marked, PictureSize size) {
    std::uint64_t count = 0;
    for (int y = 1; y + 1 < size.height; ++y)
        for (int x = 1; x + 1 < size.width; ++x)
            if (marked[size.index(x, y)] && marked[size.index(x - 1, y)] && marked[size.index(x + 1, y)] &&
                marked[size.index(x, y - 1)] && marked[size.index(x, y + 1)])
                ++count;
    return count;
}

/// The expected colour where a drawing is bare, in the order of the scene's channels.
Ground bare_ground(const Exhibit& e, const DisplayChange& change) {
    Ground ground = e.bare_grounds[way_turned(change)];
    ground.levels = exchanged(change, ground.levels);
    return ground;
}

}  // namespace

Score score(const Exhibit& e, const Drawing& drawn, const DisplayChange& change, int step) {
    const ByteRanges ranges = byte_ranges(change);
    const Ground ground = bare_ground(e, change);
    const PictureSize size = e.right.size;
    std::vector<Score> rows(static_cast<std::size_t>(size.height / step));
    std::vector<std::uint8_t> unlike(step == 1 ? size.pixels() : 0);
    tbb::parallel_for(0, size.height / step, [&](int row) {
        const int y = row * step + step / 2;
        const ExpectedRow explained(drawn.picture, &drawn.bare, ranges, change, ground, y);
        const ExpectedRow right(e.right, nullptr, ranges, change, ground, y);
        for (int x = 0; x < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            const std::array<ByteRange, 3> expected = explained.at(x);
            const bool misses = change.soft && lacks_contrast(e, change, explained, expected, {x, y});
            const bool is_unlike = add_pixel(rows[static_cast<std::size_t>(row)], expected, right.at(x),
                                             mine_at(e.wrong, change, x, y), {x, y}, misses);
            if (step == 1) unlike[size.index(x, y)] = is_unlike ? 1 : 0;
        }
    });
    Score all;
    for (const Score& row : rows) add(all, row);  // in order, so the sums do not depend on threads
    if (step == 1 && all.may_fit() && all.unlike > 0) all.solid = count_solid(unlike, size);
    return all;
}

PixelCounts count_unlike(const Exhibit& e, const Drawing& drawing, const DisplayChange& change) {
    const Picture& drawn = drawing.picture;
    const ByteRanges ranges = byte_ranges(change);
    std::optional<Rgb> background = e.grounds[way_turned(change)];
    if (background) background = exchanged(change, *background);
    const Ground ground = bare_ground(e, change);
    PixelCounts counts;
    for (int y = 0; y < drawn.size.height; ++y) {
        const ExpectedRow expected(drawn, &drawing.bare, ranges, change, ground, y);
        for (int x = 0; x < drawn.size.width; ++x) {
            const PixelKind kind = e.kinds[drawn.size.index(x, y)];
            const Rgb mine = mine_at(e.wrong, change, x, y);
            const std::array<ByteRange, 3> ours = expected.at(x);
            float off = 0;
            for (std::size_t c = 0; c < 3; ++c)
                off =
                    std::max(off, kind == PixelKind::Background && background
                                      ? std::abs(float((*background)[c]) - float(mine[c])) - change.scatter()
                                      : ours[c].distance(mine[c]));
            PixelCount& count = counts[static_cast<std::size_t>(kind)];
            ++count.pixels;
            count.unlike += off > visible_levels ? 1 : 0;
            count.most = std::max(count.most, off);
        }
    }
    return counts;
}

Rgb shown(const ByteRanges& ranges, Rgb drawn) {
    Rgb colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const long level = std::lround(ranges[drawn[c]].middle);
        colour[c] = static_cast<std::uint8_t>(std::clamp(level, 0L, 255L));
    }
    return colour;
}

Rgb shown_beside(const ByteRanges& ranges, Rgb drawn, Rgb mine) {
    Rgb colour = shown(ranges, drawn);
    for (std::size_t c = 0; c < 3; ++c)
        if (ranges[drawn[c]].off(mine[c]) == 0) colour[c] = mine[c];
    return colour;
}

Rgb mine_at(const Picture& wrong, const DisplayChange& change, int x, int y) {
    return exchanged(change, rgb_at(wrong, changed_index(change, wrong.size, x, y)));
}

}  // namespace glint
