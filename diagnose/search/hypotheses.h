#pragma once
// Tries explanations together with display changes at probes, and keeps the likeliest to be judged on the
// complete picture.

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/search/probes.h"
#include "diagnose/search/score.h"
#include "diagnose/search/supposition.h"
#include "models/scene/scene.h"
#include "renderer/renderer.h"

namespace glint {

// Draws the scene under explanations: the complete picture, or probes only. Fits numbers to a picture.

/// Draws the explanations of one scene. Light is a sum: an edit of one part of the equation is drawn as the
/// unedited picture, minus the unedited part, plus the edited part.
class Drawings {
  public:
    /// `right`: the scene without mistakes. Precondition: `renderer` and `right` outlive this object.
    Drawings(Renderer& renderer, const Scene& right, PictureSize size)
        : renderer_(renderer), right_(right), size_(size) {}

    /// See Renderer::draw_blocks().
    void draw_blocks(BlockChoice blocks) { renderer_.draw_blocks(std::move(blocks)); }
    [[nodiscard]] const Scene& right() const { return right_; }
    [[nodiscard]] const Renderer& renderer() const { return renderer_; }

    [[nodiscard]] Picture whole(const Supposition& e);
    /// Whether the last picture drawn shows no surface at a pixel. Precondition: whole() or at_probes() was
    /// called.
    [[nodiscard]] bool is_bare(int x, int y) const { return renderer_.object_at(x, y) < 0; }
    /// Precondition: draw_blocks() includes the probes and their neighbours (blocks_of()). `probes` outlive
    /// the next call.
    [[nodiscard]] DrawnProbes at_probes(const Supposition& e, const std::vector<Probe>& probes);
    /// The same for a scene, without neighbours.
    [[nodiscard]] ProbeLevels levels_at(const Scene& scene, const std::vector<Probe>& probes);

  private:
    using Linear = std::vector<float>;  // three channels per pixel or probe
    const Picture& render(const Scene& scene, bool linear) { return renderer_.render(scene, size_, linear); }
    Linear linear_of(const Scene& scene, const std::vector<Probe>* probes);
    const Linear& kept(const std::string& key, const Scene& scene, const std::vector<Probe>* probes);
    Linear composed(const Supposition& e, const std::vector<Probe>* probes);

    Renderer& renderer_;
    const Scene& right_;
    PictureSize size_;
    std::map<std::string, Linear> kept_;  // parts of the correct picture at the probes
    const std::vector<Probe>* kept_at_ = nullptr;
};

/// Returns the RGBA bytes of linear colours, before the exposure is applied.
[[nodiscard]] std::vector<std::uint8_t> bytes_of_linear(const std::vector<float>& linear,
                                                        const Display& display);

/// Returns the edits of one number under which the scene is much closer to `wrong`, the levels at the probes.
[[nodiscard]] std::vector<Supposition> fitted_numbers(Drawings& drawings, const std::vector<Probe>& probes,
                                                      const ProbeLevels& wrong,
                                                      const std::vector<Convention>& conventions);

/// An explanation of a picture, and possible display changes, the likeliest first.
struct Hypothesis {
    Supposition explanation;
    std::vector<DisplayChange> changes;
    std::vector<Supposition> same;  // others that give the same colours at the probes
};

/// The cost of an explanation, lower is likelier: log2(excess + free), plus the cost of believing it, plus 1
/// for each part of the change. So an additional change must more than halve `excess` + `free`. `excess` is
/// the sum of excess_of().
[[nodiscard]] double explanation_cost(double excess, double free, double belief, const DisplayChange& change);

/// Called with the number of finished steps and the total number of steps, on the thread that started the
/// search. An exception that it throws ends the search.
using DiagnosisProgress = std::function<void(std::size_t done, std::size_t all)>;

struct SearchJob {
    const Picture &wrong, &right;  // right: without mistakes
    const std::vector<PixelKind>& kinds;
    float noise = 0;              // as in DisplayChange
    std::array<bool, 4> turns{};  // which flips are tried: see way_turned()
    bool pairs = false;
    const std::vector<std::string>& declared;  // conventions that the program is known to follow
    std::size_t count = 12;
    DiagnosisProgress progress;
};

/// Returns the likeliest explanations. The first is that the picture is right, without conventions; the
/// others are sorted by cost.
[[nodiscard]] std::vector<Hypothesis> likely_hypotheses(Drawings& drawings, const SearchJob& job);

}  // namespace glint
