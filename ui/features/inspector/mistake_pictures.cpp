#include "ui/features/inspector/mistake_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "diagnose/search/supposition.h"
#include "ui/feature.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Thumbnails that look the same are compared in a picture this many times as wide and high.
constexpr int enlarged = 4;
/// A smaller difference is hardly visible, in levels of 0 to 255.
constexpr int seen_levels = 4;

using Bytes = std::vector<std::uint8_t>;

int largest_difference(const Bytes& a, const Bytes& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// Draws the scene without mistakes first, then under each one.
class DrawUnderMistakes {
  public:
    DrawUnderMistakes(Scene right, PictureSize size) : right_(std::move(right)), size_(size) {}

    SmallPicture operator()(Renderer& renderer, int index) {
        const Scene scene = index == 0 ? right_ : under(static_cast<std::size_t>(index - 1));
        SmallPicture small{renderer.render(scene, size_, false, mistake_samples), {}};
        if (index == 0) {
            right_small_ = small.picture.rgba;
            return small;
        }
        const int levels = largest_difference(small.picture.rgba, right_small_);
        if (levels == 0 && looks_right(renderer, scene)) return {{}, no_difference};
        if (levels < seen_levels) small.words = hardly_differs;
        return small;
    }

  private:
    [[nodiscard]] Scene under(std::size_t row) const {
        return under_mistakes(right_, {mistakes_as_seen()[row]});
    }
    /// Compares it to the scene without mistakes in a larger picture: a speck may disappear in a thumbnail.
    bool looks_right(Renderer& renderer, const Scene& scene) {
        const PictureSize size{enlarged * size_.width, enlarged * size_.height, size_.keeps_width};
        if (!right_enlarged_) right_enlarged_ = renderer.render(right_, size).rgba;
        return renderer.render(scene, size).rgba == *right_enlarged_;
    }

    Scene right_;
    PictureSize size_;
    Bytes right_small_;
    std::optional<Bytes> right_enlarged_;
};

/// Whether nothing moves and all meshes are loaded.
bool at_rest(const UiState& state) {
    return !ImGui::IsAnyMouseDown() && !state.get<AnimateState>().frame && !awaits_mesh(state);
}

/// Records that the wanted pictures differ from those last begun.
void ask_again(MistakePictures& m, const Scene& scene, PictureSize size) {
    const bool same_size = m.asked_size == size;
    // The scene is known to have changed: it is compared and copied only when the button is released.
    if (same_size && !m.begun && ImGui::IsAnyMouseDown()) return;
    if (same_size && m.seen == scene) return;
    m.seen = scene;
    Scene right = under_mistakes(scene, {});
    if (same_size && m.asked == right) return;
    m.asked = std::move(right);
    m.asked_size = size;
    m.asked_since = ImGui::GetTime();
    m.begun = false;
    stop_small_pictures(m.pictures);
}

}  // namespace

std::span<const std::size_t> mistakes_as_seen() {
    static const std::vector<std::size_t> order = [] {
        std::vector<std::size_t> places;
        for (const SeenAs seen_as : all_seen_as)
            for (std::size_t i = 0; i < mistake_names().size(); ++i)
                if (mistake_names()[i].seen_as == seen_as) places.push_back(i);
        return places;
    }();
    return order;
}

void look_at_mistake_pictures(UiState& state, PictureSize size) {
    MistakePictures& m = state.get<MistakePictures>();
    m.looked_at = true;
    ask_again(m, state.editor.scene(), size);
    take_small_pictures(m.pictures);
    if (m.begun || m.pictures.job || !at_rest(state)) return;
    const double wait = m.asked_since + stillness - ImGui::GetTime();
    if (wait > 0) return redraw_within(wait);
    m.begun = true;
    begin_small_pictures(state.jobs, m.pictures, "Mistakes", size,
                         static_cast<int>(mistakes_as_seen().size()) + 1, DrawUnderMistakes(m.asked, size));
    redraw_within(0);
}

void rest_mistake_pictures(MistakePictures& of_mistakes) {
    if (std::exchange(of_mistakes.looked_at, false)) return;
    take_small_pictures(of_mistakes.pictures);
    if (of_mistakes.asked_size == PictureSize{0, 0}) return;
    stop_small_pictures(of_mistakes.pictures);
    of_mistakes.seen = of_mistakes.asked = {};
    of_mistakes.asked_size = {0, 0};
    of_mistakes.begun = false;
}

namespace {

/// Draws the scene with and without its mistakes, and compares. Once a frame.
void look_for_effect(UiState& state) {
    MistakeEffect& e = state.get<MistakeEffect>();
    const Scene& scene = state.editor.scene();
    if (mistakes_on(scene.shading.mistakes) == 0 || !at_rest(state)) return leave(e.job, e.ending);
    if (!(e.of == scene) || e.size != state.full_size) {
        leave(e.job, e.ending);
        e = {scene, state.full_size, ImGui::GetTime(), false, false, {}, e.ending};
    }
    if (e.is_known) return;
    redraw_within(stillness / 4);
    if (e.job && e.job->done()) {
        const Result<bool> found = std::exchange(e.job, nullptr)->take();
        e.is_known = true;
        e.is_none = problem_of(found) == nullptr && std::get<bool>(found);
    } else if (!e.job && has_ended(e.ending) && ImGui::GetTime() - e.since > stillness) {
        Scene wrong = scene;
        wrong.transport.paths = 1;  // all paths would take long
        e.job = state.jobs.start<bool>("Mistakes", [wrong, size = e.size](LoadProgress&) -> Result<bool> {
            Renderer renderer(1);
            const Bytes bytes = renderer.render(wrong, size).rgba;
            return renderer.render(under_mistakes(wrong, {}), size).rgba == bytes;
        });
    }
}

}  // namespace

extern const Feature mistake_pictures_feature;
const Feature mistake_pictures_feature{
    .end =
        [](UiState& s) {
            rest_mistake_pictures(s.get<MistakePictures>());
            look_for_effect(s);
        },
    .sheet = [](UiState& s) { return &s.get<MistakePictures>().pictures.sheet; }};

}  // namespace glint
