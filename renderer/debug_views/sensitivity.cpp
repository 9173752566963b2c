#include "renderer/debug_views/sensitivity.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "models/fields/scene_fields.h"
#include "renderer/renderer.h"
#include "renderer/shade/light_sources.h"
#include "renderer/shade/lighting.h"

namespace glint {
namespace {

/// The scene reduced to the visible object, and the pointers of its numbers in the entire scene. Keeps all
/// objects if there is a stroke over the pixel, which may belong to a different object.
struct PinnedScene {
    SceneDocument document;
    int object = -1;
    bool is_alone = true;  // whether all other objects have been removed

    [[nodiscard]] std::string pointer_in_whole(const std::string& pointer) const {
        constexpr std::string_view first = "/objects/0/";
        if (!is_alone || !pointer.starts_with(first)) return pointer;
        return fmt::format("/objects/{}/{}", object, pointer.substr(first.size()));
    }
    /// Returns the numbers to measure. If there are many objects, returns only the numbers of the visible
    /// object.
    [[nodiscard]] std::vector<SceneNumber> measured_numbers() const {
        std::vector<SceneNumber> numbers = numbers_of(document.scene);
        if (!is_alone && document.scene.objects.size() <= max_stroking_objects) return numbers;
        const int shows = is_alone && object >= 0 ? 0 : object;  // -1: none
        const std::string own = fmt::format("/objects/{}/", shows);
        std::erase_if(numbers, [&own](const SceneNumber& n) {
            return n.pointer.starts_with("/objects/") && !n.pointer.starts_with(own);
        });
        return numbers;
    }
};

/// Evaluates one pixel in variants of a scene.
class PixelProbe {
  public:
    /// `pinned` must outlive this object.
    PixelProbe(const PinnedScene& pinned, const SceneDocument& whole, PictureSize size, int x, int y,
               int threads)
        : pinned_(pinned), whole_(whole), size_(size), x_(x), y_(y), still_(threads), moved_(threads) {
        (void)still_.render(pinned_.document.scene, size_);
    }

    [[nodiscard]] glm::dvec3 color_now() const {
        return color_of(still_.explain(x_, y_), pinned_.document.scene);
    }
    /// Returns the colour after changing one number, or nullopt if the scene does not allow the value.
    [[nodiscard]] std::optional<glm::dvec3> color_with(const SceneNumber& number, double value) {
        Scene scene = pinned_.document.scene;
        if (set_number(scene, number.pointer, value)) return std::nullopt;
        if (problem_of(load_meshes(scene, pinned_.document.path, pinned_.document.mesh_dir)) != nullptr)
            return std::nullopt;
        if (!decides_face(number, scene)) return color_of(still_.explain_as(scene, x_, y_), scene);
        (void)moved_.render(scene, size_);
        return color_of(moved_.explain(x_, y_), scene);
    }
    /// Like color_with(), but for a large change, which may uncover the objects behind.
    [[nodiscard]] std::optional<glm::dvec3> color_far(const SceneNumber& number, double value) {
        Scene scene = whole_.scene;
        if (set_number(scene, pinned_.pointer_in_whole(number.pointer), value)) return std::nullopt;
        if (!decides_face(number, scene)) return color_with(number, value);
        if (problem_of(load_meshes(scene, whole_.path, whole_.mesh_dir)) != nullptr) return std::nullopt;
        (void)moved_.render(scene, size_);
        return color_of(moved_.explain(x_, y_), scene);
    }

  private:
    /// Whether a number affects the face or the stroke that the pixel shows, which requires drawing the
    /// picture again.
    static bool decides_face(const SceneNumber& number, const Scene& scene) {
        return number.moves_faces || lights_cull(scene);
    }
    static glm::dvec3 color_of(const Explanation& e, const Scene& scene) {
        return glm::dvec3(e.sum) * static_cast<double>(scene.display.exposure);
    }

    const PinnedScene& pinned_;
    SceneDocument whole_;
    PictureSize size_;
    int x_, y_;
    Renderer still_, moved_;  // the original scene; the scene with one number changed
};

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The change in the pixel per unit of a number.
struct Slope {
    glm::dvec3 change{0};
    bool is_fixed = false, one_sided = false, is_none = true;
};

/// Returns whether the two colours are bit-identical, or are NaN in the same components.
bool is_same(const glm::dvec3& a, const glm::dvec3& b) {
    for (int c = 0; c < 3; ++c)
        if (!(a[c] == b[c] || (std::isnan(a[c]) && std::isnan(b[c])))) return false;
    return true;
}

Slope slope(PixelProbe& probe, const glm::dvec3& now, const SceneNumber& moved, double h) {
    const auto less = probe.color_with(moved, moved.value - h),
               more = probe.color_with(moved, moved.value + h);
    Slope found;
    found.is_fixed = !less && !more;
    found.one_sided = !less || !more;
    found.change = (more.value_or(now) - less.value_or(now)) / (found.one_sided ? h : 2 * h);
    found.is_none = is_same(less.value_or(now), now) && is_same(more.value_or(now), now);
    return found;
}

/// Returns the slope for a step of a thousandth of the number. If the change in the pixel is only a little
/// larger than rounding errors, as for a number near 0, multiplies the step by ten, up to `wide`. The new
/// slope must agree with the previous one within rounding errors; otherwise the larger step has reached
/// something else, such as the next face.
Slope clear_slope(PixelProbe& probe, const glm::dvec3& now, const SceneNumber& moved) {
    constexpr double last_digits = 0x1p-20;
    const double wide = 1e-2 * std::abs(usual_move(moved));
    double h = 1e-3 * std::max(std::abs(moved.value), 0.1);
    Slope found = slope(probe, now, moved, h);
    double clear = 10;  // a larger step must agree to within 1/100 of the slope
    while (!found.is_fixed && h < wide) {
        const double unsure = last_digits * std::max(1.0, largest(now)) / h;
        if (largest(found.change) > clear * unsure) break;
        clear = 100;
        h = std::min(10 * h, wide);
        const Slope next = slope(probe, now, moved, h);
        if (next.is_fixed || largest(next.change - found.change) > 2 * unsure) break;
        found = next;
    }
    return found;
}

void measure(Sensitivities& s, PixelProbe& probe, const PinnedScene& pinned, const glm::dvec3& now,
             const SceneNumber& moved) {
    const Slope found = clear_slope(probe, now, moved);
    Sensitivity number{pinned.pointer_in_whole(moved.pointer), moved.value, found.change, found.one_sided,
                       moved.is_w};
    if (found.is_fixed) {
        s.fixed.push_back(number.pointer);
        return;
    }
    if (found.is_none) {
        s.no_effect.push_back(number.pointer);
        return;
    }
    number.move = usual_move(moved);
    auto there = probe.color_far(moved, moved.value + number.move);
    if (!there) {
        number.move = -number.move;
        there = probe.color_far(moved, moved.value + number.move);
    }
    number.effect = there.value_or(now) - now;
    s.numbers.push_back(number);
}

PinnedScene pinned_scene(const SceneDocument& document, PictureSize size, int x, int y, int threads) {
    Renderer whole(threads);
    (void)whole.render(document.scene, size);
    const bool is_stroked = whole.explain(x, y).stroke.coverage > 0;
    PinnedScene pinned{document, whole.object_at(x, y), !is_stroked};
    if (is_stroked) return pinned;
    std::vector<Object>& objects = pinned.document.scene.objects;
    objects.clear();
    if (pinned.object >= 0)
        objects.push_back(document.scene.objects[static_cast<std::size_t>(pinned.object)]);
    return pinned;
}

}  // namespace

double usual_move(const SceneNumber& number) {
    constexpr double drag_px = 100, tenth = 0.1;
    const Real& kind = number.kind;
    const double step = double(kind.step);
    if (kind.logarithmic) return drag_px * step * std::max(std::abs(number.value), 10 * step);
    if (kind.usual_max > 0) return tenth * (double(kind.usual_max) - std::max(kind.range.low, 0.0));
    if (kind.range.high < max_number && kind.range.low > -max_number)
        return tenth * (kind.range.high - kind.range.low);
    return drag_px * step;
}

struct SensitivityRun::State {
    State(const SceneDocument& document, PictureSize size, int x, int y, int threads)
        : pinned(pinned_scene(document, size, x, y, threads)),
          probe(pinned, document, size, x, y, threads),
          now(probe.color_now()),
          numbers(pinned.measured_numbers()) {
        for (std::size_t i = 0; i < document.scene.objects.size(); ++i)
            if (pinned.is_alone && static_cast<int>(i) != pinned.object)
                others.push_back(fmt::format("/objects/{}", i));
    }

    PinnedScene pinned;
    PixelProbe probe;
    glm::dvec3 now;
    std::vector<SceneNumber> numbers;
    std::vector<std::string> others;  // objects not visible at the pixel
    std::size_t measured = 0;
    Sensitivities found;
};

SensitivityRun::SensitivityRun(const SceneDocument& document, PictureSize size, int x, int y, int threads)
    : state_(std::make_unique<State>(document, size, x, y, threads)) {}
SensitivityRun::~SensitivityRun() = default;

bool SensitivityRun::step() {
    State& s = *state_;
    if (s.measured == s.numbers.size()) return false;
    measure(s.found, s.probe, s.pinned, s.now, s.numbers[s.measured++]);
    return s.measured < s.numbers.size();
}

std::size_t SensitivityRun::measured() const { return state_->measured; }
std::size_t SensitivityRun::count() const { return state_->numbers.size(); }

Sensitivities SensitivityRun::result() const {
    Sensitivities s = state_->found;
    s.no_effect.insert(s.no_effect.end(), state_->others.begin(), state_->others.end());
    std::stable_sort(s.numbers.begin(), s.numbers.end(), [](const Sensitivity& a, const Sensitivity& b) {
        return largest(a.change) > largest(b.change);
    });
    return s;
}

Result<Sensitivities> sensitivities(const SceneDocument& document, PictureSize size, int x, int y,
                                    int threads, const SensitivityProgress& measured) {
    const std::size_t lights = document.scene.lights.size();
    if (lights > max_sensitivity_lights)
        return Problem{document.path, "/lights", fmt::format("{} lights are too many to measure", lights),
                       fmt::format("at most {}", max_sensitivity_lights), 0};
    SensitivityRun run(document, size, x, y, threads);
    while (run.measured() < run.count()) {
        run.step();
        if (measured) measured(run.measured(), run.count());
    }
    return run.result();
}

namespace {

/// Formats a change for its column, in scientific notation if fixed decimals would show 0.
std::string change_text(double change) {
    const bool is_small = change != 0 && std::abs(change) < 1e-5;
    return is_small ? fmt::format("{:+9.1e}", change) : fmt::format("{:+.6f}", change);
}

}  // namespace

std::string sensitivity_text(const Sensitivities& s) {
    std::string text =
        "Change in the pixel (linear RGB times exposure) per unit of each number, largest first:\n";
    for (const Sensitivity& n : s.numbers)
        text += fmt::format("  {} {} {}  {} = {}{}\n", change_text(n.change.x), change_text(n.change.y),
                            change_text(n.change.z), n.pointer, static_cast<float>(n.value),
                            n.one_sided ? "  (can change in one direction only)" : "");
    const auto list = [&text](const char* title, const std::vector<std::string>& pointers) {
        if (pointers.empty()) return;
        text += title;
        text += '\n';
        for (const std::string& pointer : pointers) text += "  " + pointer + "\n";
    };
    list("Numbers with no effect on the pixel:", s.no_effect);
    list("Numbers that cannot change by a small step:", s.fixed);
    return text;
}

}  // namespace glint
