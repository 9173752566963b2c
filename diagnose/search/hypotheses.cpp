#include "diagnose/search/hypotheses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <queue>

#include "models/scene/mistakes.h"

namespace glint {
namespace {

constexpr std::size_t even_probes = 1500, wrong_probes = 1200, changes_kept = 3;
constexpr std::size_t likely_in_many = 48;  // how many of a large batch are tried on all probes
constexpr double free_in_probes = 12;

/// Every way in which a display may have changed colours, with a gain that is fitted later. `is_encoded`: the
/// levels are encoded, so a gain in light is not a gain in levels.
std::vector<DisplayChange> all_changes(const std::array<bool, 4>& turns, bool is_encoded) {
    std::vector<DisplayChange> all;
    for (const auto& [before, after] : {std::pair{Code::Same, Code::Same},
                                        {Code::Encoded, Code::Same},
                                        {Code::Decoded, Code::Same},
                                        {Code::Same, Code::Encoded},
                                        {Code::Decoded, Code::Encoded}}) {
        if (before == Code::Decoded && after == Code::Encoded && !is_encoded) continue;
        for (DisplayChange change : ways_of_turning()) {
            if (!turns[way_turned(change)]) continue;
            change.before = before;
            change.after = after;
            for (const bool exchanged : {false, true}) {
                change.red_blue = exchanged;
                all.push_back(change);
            }
        }
    }
    return all;
}

struct CostedChange {
    DisplayChange change;
    double cost = 0;
};

/// Returns the excess above which a change costs more than `cost`. The result is slightly larger, so that
/// rounding never ends the trial of an equally expensive change too early.
double most_excess(double cost, double belief, const DisplayChange& change) {
    constexpr double hair = 1 + 1e-9;
    return std::exp2(cost - explanation_cost(1, 0, belief, change)) * hair - free_in_probes;
}

/// The range of gains that is believed together with an edit of the scene. Without an edit a wider range is
/// believed.
constexpr float least_gain = 0.33f, most_gain = 3.0f;
bool is_believed(float gain, const DisplayChange& change, const Supposition& e) {
    if (gain >= least_gain && gain <= most_gain) return true;
    const bool alone = e.kind == ExplanationKind::Right && e.conventions.empty() && change.encodings() == 0;
    return alone && gain > least_gain / 5 && gain < 5 * most_gain;
}

/// Probes, with the wrong and the correct picture's levels at them.
struct Sample {
    std::vector<Probe> probes;
    BlockChoice blocks;
    WrongProbes wrong;
    DrawnProbes right;  // the correct picture without conventions

    Sample(std::vector<Probe> of, Drawings& drawings, const SearchJob& job)
        : probes(std::move(of)),
          blocks(blocks_of(probes, job.wrong.size)),
          wrong(probes, job.wrong, job.kinds, job.noise) {
        drawings.draw_blocks(blocks);
        right = drawings.at_probes({}, probes);
    }
    Sample(const Sample&) = delete;  // Drawings remembers the address of the probes
};

/// Tries every display change, each with the gain that fits it best, assuming that the picture was drawn as
/// `drawn`. `enough(change)` returns the excess above which the cost does not matter. `take(change, cost)`
/// receives a cost that is exact up to there.
template <class Enough, class Take>
void try_changes(const std::vector<DisplayChange>& changes, const Supposition& e, const DrawnProbes& drawn,
                 const WrongProbes& wrong, const Enough& enough, const Take& take) {
    constexpr float no_gain = 0.007f;  // a gain that is closer to 1 changes no level visibly
    const bool may_be_soft = drawn.low != drawn.at;
    const auto attempt = [&](DisplayChange change) {
        change.noise = wrong.noise();
        const ByteBounds bounds = byte_bounds(change);
        for (const bool soft : {false, true}) {
            if (soft && !may_be_soft) continue;
            change.soft = soft;
            const double excess = excess_at(drawn, wrong, change, bounds, enough(change));
            take(change, explanation_cost(excess, free_in_probes, e.belief, change));
        }
    };
    for (DisplayChange change : changes) {
        if (change.after == Code::Same) attempt(change);  // without a gain, the other changes are equivalent
        const auto gain = fitted_gain(drawn, wrong, change);
        if (!gain || std::abs(*gain - 1) < no_gain || !is_believed(*gain, change, e)) continue;
        change.gain = *gain;
        attempt(change);
    }
}

/// The largest of the `count` smallest costs that have been added so far; infinity until `count` costs have
/// been added.
class CostBound {
  public:
    explicit CostBound(std::size_t count) : count_(count) {}

    [[nodiscard]] double get() const {
        return count_ > 0 && smallest_.size() == count_ ? smallest_.top()
                                                        : std::numeric_limits<double>::infinity();
    }
    void add(double cost) {
        smallest_.push(cost);
        if (smallest_.size() > count_) smallest_.pop();
    }

  private:
    std::size_t count_;
    std::priority_queue<double> smallest_;
};

/// An explanation, drawn at the probes.
struct Drawn {
    Supposition explanation;
    DrawnProbes at;
    double cost = 0;  // of the likeliest change; a cost above the bound need not be exact
    double misfit = std::numeric_limits<double>::infinity();  // the cost of its excess
    std::vector<Supposition> same = {};
};

class Search {
  public:
    Search(Drawings& drawings, const SearchJob& job)
        : drawings_(drawings),
          job_(job),
          changes_(all_changes(job.turns, drawings.right().display.transfer == Transfer::Srgb)),
          encoded_changes_(all_changes(job.turns, true)),
          bound_(job.count) {
        choose_probes();
        leave_out_exchanges();
    }

    std::vector<Hypothesis> likeliest() {
        try_right();
        if (!is_plainly_right()) {
            try_singles();
            if (!is_explained()) try_details();
            if (job_.pairs && !is_explained()) try_pairs();
            try_same();
        }
        drawings_.draw_blocks(nullptr);
        return hypotheses();
    }

  private:
    void choose_probes();
    template <class TakeSome>
    void draw_batch(std::vector<Supposition>& batch, const Sample& sample, CostBound& bound,
                    const TakeSome& take_some);
    void take(std::vector<Supposition> batch);
    void keep(Drawn d);
    void try_right();
    void try_singles();
    void add_conventions();
    void try_details();
    void try_pairs();
    void try_same();
    [[nodiscard]] std::vector<Convention> conventions_in(const Supposition& e) const;
    [[nodiscard]] std::vector<Supposition> singles() const;
    std::vector<Supposition> take_likely(std::vector<Supposition> batch, std::size_t count = likely_in_many);
    void leave_out_exchanges();
    std::vector<Hypothesis> hypotheses();
    Hypothesis judged(const Drawn& drawn) const;
    void find_cost(Drawn& drawn, const WrongProbes& wrong, double bound) const;
    [[nodiscard]] static bool fits(const Drawn& d) {
        constexpr double few = 1;  // times the free excess
        return d.misfit < std::log2((1 + few) * free_in_probes);
    }
    [[nodiscard]] bool is_plainly_right() const;
    [[nodiscard]] bool shows_background_of(ToneCurve tone) const;
    [[nodiscard]] bool is_explained() const {
        return std::any_of(kept_.begin(), kept_.end(), [this](const Drawn& d) { return fits(d); });
    }
    /// Returns the explanation under the conventions that fit the correct scene best.
    [[nodiscard]] Supposition as_usual(const Supposition& e) const {
        Supposition with = e;
        for (const Convention& c : usual_) with = with_convention(with, c);
        return with;
    }
    /// Adds the explanation as it is, and under the usual conventions; if the user declared them, only
    /// under those.
    void add_as_usual(std::vector<Supposition>& to, const Supposition& e) const {
        if (!are_declared_) to.push_back(e);
        if (!usual_.empty()) to.push_back(as_usual(e));
    }
    [[nodiscard]] const std::vector<DisplayChange>& changes_for(const Supposition& e) const {
        return e.makes(&Mistakes::encoded_twice) ? encoded_changes_ : changes_;
    }
    void progress(std::size_t done, std::size_t all) const {
        if (job_.progress) job_.progress(done, all);
    }

    Drawings& drawings_;
    const SearchJob& job_;
    std::vector<DisplayChange> changes_, encoded_changes_;  // the latter if levels are encoded
    std::optional<Sample> sample_, few_;  // few_: some of its probes, for trying many explanations
    CostBound bound_;
    std::vector<Drawn> kept_;              // the likeliest so far; first, that nothing is wrong
    std::vector<Convention> conventions_;  // those that change the picture
    std::vector<Convention> usual_;        // those that fit the correct scene, or that the user declared
    bool are_declared_ = false;
};

/// Appends every n-th element of `from`, with n such that at least `count` are appended if `from` has as
/// many.
template <class T> void add_every(std::vector<T>& to, const std::vector<T>& from, std::size_t count) {
    const std::size_t step = std::max<std::size_t>(1, from.size() / count);
    for (std::size_t i = step / 2; i < from.size(); i += step) to.push_back(from[i]);
}

/// Returns the elements in a shuffled order that is always the same.
template <class T> std::vector<T> mixed(std::vector<T> all) {
    std::uint32_t state = 1;
    for (std::size_t i = all.size(); i > 1; --i) {
        // W. Press et al., Numerical Recipes; the lowest bits have a short period.
        constexpr std::uint32_t factor = 1664525, summand = 1013904223, low_bits = 8;
        state = factor * state + summand;
        std::swap(all[i - 1], all[(state >> low_bits) % i]);
    }
    return all;
}

/// The surface pixels of every `every`-th row.
std::vector<Probe> surface_pixels(const SearchJob& job, int every) {
    const PictureSize size = job.wrong.size;
    std::vector<Probe> surface;
    for (int y = every > 1 ? 1 : 0; y < size.height; y += every)
        for (int x = 0; x < size.width; ++x)
            if (job.kinds[size.index(x, y)] == PixelKind::Surface) surface.push_back({x, y});
    return surface;
}

void Search::choose_probes() {
    constexpr std::size_t rows_of_pixels = 40'000, wrong_blocks = 300, blocks_each = 20;
    constexpr std::size_t least_in_block = 7, least_few = 200;
    const PictureSize size = job_.wrong.size;
    int every = std::max(3, static_cast<int>(3 * size.pixels() / rows_of_pixels));
    if (every > 3 && size.height / every < 8) every = std::max(3, size.height / 8);
    std::vector<Probe> surface = surface_pixels(job_, every);
    if (surface.size() < 2 * even_probes) surface = surface_pixels(job_, 1);  // if objects are thin
    std::vector<Probe> chosen;
    add_every(chosen, surface, even_probes);
    sample_.emplace(chosen, drawings_, job_);
    // Where the picture differs from the correct one under the display change that fits best so far.
    const DisplayChange change = judged({{}, sample_->right, 0}).changes.front();
    const ByteRanges ranges = byte_ranges(change);
    const auto is_wrong = [&](const Probe& p) {
        const Rgb mine = mine_at(job_.wrong, change, p.x, p.y);
        const Rgb right = rgb_at(job_.right, size.index(p.x, p.y));
        for (std::size_t c = 0; c < 3; ++c)
            if (ranges[right[c]].distance(mine[c]) > 2) return true;
        return false;
    };
    struct Block {
        std::vector<Probe> inner, wrong;  // inner: those with both neighbours in the same block
    };
    std::map<std::size_t, Block> blocks;  // each has 16 pixels of a row
    for (const Probe& p : surface_pixels(job_, 1)) {
        constexpr int width = 16;
        Block& block = blocks[size.index(p.x / width, p.y)];
        if (p.x % width != 0 && p.x % width != width - 1) block.inner.push_back(p);
        if (is_wrong(p)) block.wrong.push_back(p);
    }
    std::vector<std::vector<Probe>> even, with_wrong, few_blocks, all_wrong, wrong;
    for (const auto& [place, block] : blocks) {
        if (!block.wrong.empty()) all_wrong.push_back(block.wrong);
        if (block.inner.size() < least_in_block) continue;
        even.push_back(block.inner);
        if (!block.wrong.empty()) with_wrong.push_back(block.inner);
    }
    const auto joined = [](const std::vector<std::vector<Probe>>& lists) {
        std::vector<Probe> all;
        for (const std::vector<Probe>& list : lists) all.insert(all.end(), list.begin(), list.end());
        return all;
    };
    // Shuffled, because a pattern of faces may repeat at the interval at which blocks are taken.
    add_every(wrong, mixed(all_wrong), wrong_blocks);
    add_every(chosen, joined(wrong), wrong_probes);
    sample_.emplace(mixed(chosen), drawings_, job_);  // so that bad explanations are rejected early
    add_every(few_blocks, mixed(even), blocks_each);
    add_every(few_blocks, mixed(with_wrong), blocks_each);
    const std::vector<Probe> few = joined(few_blocks);
    few_.emplace(mixed(few.size() < least_few ? chosen : few), drawings_, job_);
}

/// Skips the changes that swap red and blue if these two differ as in the correct picture.
void Search::leave_out_exchanges() {
    const auto differs_alike = [this](DisplayChange change) {
        change.red_blue = false;
        const ProbeLevels &right = sample_->right.at, &mine = sample_->wrong.at(change);
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < right.size(); i += 3)
            sum += std::int64_t{right[i] - right[i + 2]} * (mine[i] - mine[i + 2]);
        return sum >= 0;
    };
    for (std::vector<DisplayChange>* changes : {&changes_, &encoded_changes_})
        std::erase_if(*changes, [&](const DisplayChange& c) { return c.red_blue && differs_alike(c); });
}

void Search::find_cost(Drawn& d, const WrongProbes& wrong, double bound) const {
    constexpr double rounding = 1e-6;
    double& least = d.cost = std::numeric_limits<double>::infinity();
    const auto enough = [&](const DisplayChange& change) {
        return most_excess(std::min(least, bound + rounding), d.explanation.belief, change);
    };
    try_changes(changes_for(d.explanation), d.explanation, d.at, wrong, enough,
                [&](const DisplayChange& change, double cost) {
                    if (cost >= least) return;
                    least = cost;
                    // Softness can explain much, and a gain reduces any difference somewhat.
                    // Beyond the bound the cost is not exact.
                    const bool is_loose = change.soft || change.gain != 1 || cost > bound + rounding;
                    d.misfit = is_loose ? std::numeric_limits<double>::infinity()
                                        : cost - d.explanation.belief - change.count();
                });
}

/// Returns the likeliest display changes.
Hypothesis Search::judged(const Drawn& d) const {
    std::vector<CostedChange> kept;
    const auto enough = [&](const DisplayChange& change) {
        if (kept.size() < changes_kept) return std::numeric_limits<double>::infinity();
        return most_excess(kept.back().cost, d.explanation.belief, change);
    };
    try_changes(changes_for(d.explanation), d.explanation, d.at, sample_->wrong, enough,
                [&](const DisplayChange& change, double cost) {
                    const auto after = std::find_if(kept.begin(), kept.end(),
                                                    [cost](const CostedChange& c) { return cost < c.cost; });
                    kept.insert(after, {change, cost});
                    if (kept.size() > changes_kept) kept.pop_back();
                });
    Hypothesis hypothesis{d.explanation, {}, d.same};
    for (const CostedChange& c : kept) hypothesis.changes.push_back(c.change);
    return hypothesis;
}

/// Keeps an explanation, or adds it to one that gives the same picture.
void Search::keep(Drawn d) {
    const auto like = std::find_if(kept_.begin(), kept_.end(), [&d](const Drawn& k) { return k.at == d.at; });
    if (like == kept_.end()) {
        kept_.push_back(std::move(d));
        return;
    }
    if (d.explanation.belief < like->explanation.belief) {
        std::swap(d.explanation, like->explanation);
        std::swap(d.cost, like->cost);
        std::swap(d.misfit, like->misfit);
    }
    like->same.push_back(std::move(d.explanation));
}

/// Draws explanations at probes, a batch at a time. Passes those that have an effect, with their costs, to
/// `take_some`.
template <class TakeSome>
void Search::draw_batch(std::vector<Supposition>& batch, const Sample& sample, CostBound& bound,
                        const TakeSome& take_some) {
    constexpr std::size_t together = 64;
    drawings_.draw_blocks(sample.blocks);
    for (std::size_t first = 0; first < batch.size(); first += together) {
        std::vector<Drawn> drawn;
        for (std::size_t i = first; i < std::min(batch.size(), first + together); ++i) {
            Drawn d{std::move(batch[i]), {}, 0};
            d.at = drawings_.at_probes(d.explanation, sample.probes);
            const bool is_plain = kept_.empty();
            if (is_plain || d.at != sample.right) drawn.push_back(std::move(d));
        }
        // The bound is constant while the explanations are judged, so inexact costs do not depend on the
        // number of threads.
        const double enough = bound.get();
        tbb::parallel_for(std::size_t{0}, drawn.size(),
                          [&](std::size_t i) { find_cost(drawn[i], sample.wrong, enough); });
        for (const Drawn& d : drawn) bound.add(d.cost);
        take_some(std::move(drawn));
    }
}

bool is_cheaper(const Drawn& a, const Drawn& b) { return a.cost < b.cost; }

/// Draws explanations, and keeps the likeliest.
void Search::take(std::vector<Supposition> batch) {
    draw_batch(batch, *sample_, bound_, [&](std::vector<Drawn> drawn) {
        for (Drawn& d : drawn) keep(std::move(d));
        std::stable_sort(kept_.begin() + 1, kept_.end(), is_cheaper);
        kept_.resize(std::min(kept_.size(), 3 * job_.count));
    });
}

/// Tries the unedited scene with conventions and tone curves.
void Search::try_right() {
    take({Supposition{}});
    const double plain = kept_.front().cost;
    std::vector<Supposition> batch;
    for (Convention c : conventions_of(drawings_.right())) {
        const bool is_declared =
            std::any_of(job_.declared.begin(), job_.declared.end(),
                        [&c](const std::string& name) { return c.name.starts_with(name); });
        if (is_declared) c.cost = 0;
        const bool has_variants = c.name.find('=') != std::string::npos || c.name == "highlight_normalized";
        if (is_declared && !has_variants) usual_.push_back(c);
        const DrawnProbes at = drawings_.at_probes(with_convention({}, c), sample_->probes);
        if (c.name != "specular_behind_surface" && at == kept_.front().at) continue;
        conventions_.push_back(c);
        batch.push_back(with_convention({}, c));
    }
    for (std::size_t a = 0; a < conventions_.size(); ++a)
        for (std::size_t b = a + 1; b < conventions_.size(); ++b)
            if (conventions_[a].name != conventions_[b].name)
                batch.push_back(with_convention(with_convention({}, conventions_[a]), conventions_[b]));
    for (const ToneCurve tone : all_tones) {
        Supposition e;
        e.tone = tone;
        e.belief = 1;
        batch.push_back(e);
    }
    are_declared_ = !usual_.empty();
    if (are_declared_) batch.push_back(as_usual({}));
    take(std::move(batch));
    if (are_declared_) return;
    // The conventions under which the correct scene fits clearly better.
    constexpr double clearly = 0.3;
    for (const Drawn& d : kept_) {
        if (d.explanation.conventions.empty() || d.cost > plain - clearly) continue;
        usual_ = conventions_in(d.explanation);
        break;
    }
}

std::vector<Convention> Search::conventions_in(const Supposition& e) const {
    std::vector<Convention> all;
    for (const Convention& c : conventions_)
        for (const std::string& name : e.conventions)
            if (name == c.name + ": " + c.words) all.push_back(c);
    return all;
}

bool Search::is_plainly_right() const {
    for (const Drawn& d : kept_) {
        if (d.explanation.kind != ExplanationKind::Right || !fits(d)) continue;
        const DisplayChange change = judged(d).changes.front();
        if (change.gain == 1 && change.encodings() == 0 && !change.soft) return true;
    }
    return false;
}

/// Whether the picture's background is the scene's background under the tone curve, and not as the scene
/// gives it.
bool Search::shows_background_of(ToneCurve tone) const {
    constexpr int near = 2;
    const std::optional<Rgb> mine = background_of(job_.wrong, job_.kinds, {});
    if (!mine) return false;
    const Display& display = drawings_.right().display;
    const glm::vec3 plain = display.background,
                    shown = toned(tone, display.exposure * plain) / display.exposure;
    const std::vector<std::uint8_t> bytes =
        bytes_of_linear({plain.x, plain.y, plain.z, shown.x, shown.y, shown.z}, display);
    return most_apart(*mine, {bytes[0], bytes[1], bytes[2]}) > near &&
           most_apart(*mine, {bytes[4], bytes[5], bytes[6]}) <= near;
}

std::vector<Supposition> Search::singles() const {
    const Scene& scene = drawings_.right();
    std::vector<Supposition> all = left_out_edits(scene);
    for (auto& list : {setting_edits(scene), mistake_edits(), all_lights_reversed(scene)})
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

void Search::try_singles() {
    const std::vector<Supposition> all = singles();
    std::vector<Supposition> batch;
    batch.reserve(2 * all.size());
    for (const Supposition& e : all) add_as_usual(batch, e);
    progress(1, 4);
    const std::vector<Supposition> likeliest = take_likely(std::move(batch));
    if (is_explained()) return;
    progress(2, 4);
    batch.clear();
    for (const Convention& c : conventions_)
        for (const Supposition& e : likeliest)
            if (e.conventions.empty()) batch.push_back(with_convention(e, c));
    (void)take_likely(std::move(batch));
    if (is_explained()) return;
    add_conventions();
    if (is_explained()) return;
    // Tone curves that explain the background.
    batch.clear();
    for (const ToneCurve tone : all_tones)
        if (shows_background_of(tone))
            for (Supposition e : all) {
                e.tone = tone;
                e.belief += 1;
                batch.push_back(as_usual(e));
            }
    (void)take_likely(std::move(batch));
}

/// Adds conventions, one after another, to the likeliest explanations so far.
void Search::add_conventions() {
    constexpr int rounds = 3;
    constexpr std::size_t few = 16;
    for (int round = 0; round < rounds && !is_explained(); ++round) {
        std::vector<Supposition> batch;
        for (std::size_t i = 0; i < std::min(few, kept_.size()); ++i)
            for (const Convention& c : conventions_) {
                const Supposition& e = kept_[i].explanation;
                const auto has = [&c](const std::string& name) { return name.starts_with(c.name + ":"); };
                if (std::none_of(e.conventions.begin(), e.conventions.end(), has))
                    batch.push_back(with_convention(e, c));
            }
        (void)take_likely(std::move(batch), few);
    }
}

/// Tries other numbers, and mistakes in a single light, object or term.
void Search::try_details() {
    progress(3, 4);
    const Scene& scene = drawings_.right();
    const DisplayChange change = judged(kept_.front()).changes.front();
    DisplayChange as_it_is = change;
    as_it_is.gain = 1;
    as_it_is.before = as_it_is.after = Code::Same;
    as_it_is.soft = false;
    const auto try_numbers = [&](const std::vector<Convention>& conventions) {
        drawings_.draw_blocks(few_->blocks);
        take(fitted_numbers(drawings_, few_->probes, few_->wrong.at(as_it_is), conventions));
    };
    if (!are_declared_) try_numbers({});
    if (!usual_.empty() && !is_explained()) try_numbers(usual_);
    std::vector<Supposition> batch, not_gated;
    for (const Supposition& mistake : mistake_edits())
        for (const Supposition& e : restricted(mistake, scene)) add_as_usual(batch, e);
    const std::vector<Supposition> likeliest = take_likely(std::move(batch));
    if (is_explained()) return;
    for (const Supposition& e : likeliest)
        for (const Convention& c : conventions_)
            if (usual_.empty() && c.name == "specular_behind_surface")
                not_gated.push_back(with_convention(e, c));
    take(std::move(not_gated));
    add_conventions();
}

/// Draws a large batch at a few probes, and takes the likeliest explanations. Returns these, the best first.
std::vector<Supposition> Search::take_likely(std::vector<Supposition> batch, std::size_t count) {
    std::vector<Drawn> drawn;
    CostBound bound(count);
    draw_batch(batch, *few_, bound, [&](std::vector<Drawn> some) {
        drawn.insert(drawn.end(), std::move_iterator(some.begin()), std::move_iterator(some.end()));
        std::stable_sort(drawn.begin(), drawn.end(), is_cheaper);
        drawn.resize(std::min(drawn.size(), count));
        progress(3, 4);
    });
    std::vector<Supposition> found;
    found.reserve(drawn.size());
    for (Drawn& d : drawn) found.push_back(std::move(d.explanation));
    take(found);
    return found;
}

void Search::try_pairs() {
    constexpr int most_forms = 4;  // additional forms are not tried in pairs
    std::vector<Supposition> all;
    for (std::size_t i = 0; i < mistake_names().size(); ++i)
        for (int form = 0; form < std::min(form_count(mistake_names()[i]), most_forms); ++form)
            all.push_back(mistake_edit(i, form));
    std::vector<Supposition> batch;
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b)
            if (all[a].mistakes != all[b].mistakes) batch.push_back(as_usual(pair_of(all[a], all[b])));
    (void)take_likely(std::move(batch));
}

/// Tries all single edits under the conventions of the best explanation: some may give the same picture.
void Search::try_same() {
    const Supposition best = std::min_element(kept_.begin(), kept_.end(), is_cheaper)->explanation;
    if (!is_explained() || best.kind == ExplanationKind::Right || best.conventions.empty()) return;
    const std::vector<Convention> of_best = conventions_in(best);
    std::vector<Supposition> batch = singles();
    for (Supposition& e : batch)
        for (const Convention& c : of_best) e = with_convention(e, c);
    (void)take_likely(std::move(batch));
}

std::vector<Hypothesis> Search::hypotheses() {
    // Only a few variants of each edit, so that the list has room for others.
    constexpr int variants = 3;
    std::map<std::string, int> count_of_name;
    std::vector<const Drawn*> chosen;
    for (const Drawn& d : kept_)
        if (chosen.size() < job_.count &&
            (d.explanation.kind == ExplanationKind::Right || ++count_of_name[d.explanation.name] <= variants))
            chosen.push_back(&d);
    std::vector<Hypothesis> found(chosen.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) { found[i] = judged(*chosen[i]); });
    return found;
}

}  // namespace

double explanation_cost(double excess, double free, double belief, const DisplayChange& change) {
    // Softness can explain almost anything, so it ranks last.
    constexpr double nearly = 0.01;
    return std::log2(excess + free) + belief + change.count() + (change.soft ? nearly : 0);
}

std::vector<Hypothesis> likely_hypotheses(Drawings& drawings, const SearchJob& job) {
    Search search(drawings, job);
    return search.likeliest();
}

}  // namespace glint
