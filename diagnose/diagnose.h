#pragma once
// Finds the mistake in a picture that another program drew of a scene: draws the scene without mistakes and
// with each mistake in models/scene/mistakes.h, and names the explanation that gives the same picture. It
// does not guess: a picture that none of them explains is reported as not in the catalogue.

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/search/camera_fit.h"
#include "diagnose/search/display_change.h"
#include "diagnose/search/hypotheses.h"
#include "diagnose/search/score.h"
#include "diagnose/search/supposition.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// NotReadable: one of several files is not a picture; diagnose() does not return it.
enum class Verdict {
    NoMistake,
    LeftOut,
    AnotherSetting,
    Mistake,
    AnotherNumber,
    NotInCatalogue,
    NotComparable,
    NotReadable
};
/// Whether the first candidate explains the picture.
[[nodiscard]] inline bool is_explained(Verdict verdict) {
    return verdict >= Verdict::LeftOut && verdict <= Verdict::AnotherNumber;
}

/// Differences that were discounted because they are not lighting mistakes: display changes, camera,
/// softness.
struct DisplayFinding {
    DisplayChange change;
    ToneCurve tone = ToneCurve::None;
    std::optional<Rgb> background;  // as the picture shows it, if it differs from the scene's
    bool smooth_edges = false;      // silhouettes are anti-aliased
    bool lossy = false;             // individual pixels differ, but the means of squares hardly do
    std::optional<CameraDifference> camera;
    std::string camera_words, arrived;  // the differences that were reversed first, as text
    glm::vec2 shift{0};                 // pixels to the right and down; 0 if not displaced
    bool smoothed = false;              // within surfaces as well, and not because of a shift
    // Only for a smoothed or shifted picture: how many surface pixels differ from the drawing itself, but are
    // within the range of the pixel's neighbours, and by how many levels at most.
    std::uint64_t softened = 0;
    int softened_most = 0;
};

/// An explanation of the picture, with its evidence.
struct Candidate : Supposition {
    bool almost = false;                  // a small residual remains
    std::vector<std::string> also_named;  // other explanations that give the same picture
    std::vector<MistakeSet> also;  // sets under which this scene's surfaces look the same to within one level
    DisplayChange change;          // the change under which it explains the picture
    double residual = 0;           // RMS in levels from 0 to 255, over all comparable pixels
    double explained = 0;          // share of the wrong pixels that it explains, 0 to 1
    // The pixel of the scene's picture that distinguishes this candidate best from the correct picture, and
    // its colours, channels in the scene's order: in the wrong picture, and in pictures drawn without and
    // with the mistake, as this display would show them.
    glm::ivec2 pixel{0};
    Rgb mine{}, reference{}, as_mistaken{};

    /// The `--set` options that draw the picture, conventions first.
    [[nodiscard]] std::vector<std::string> options() const;
};
/// Returns the scene with the candidate's conventions and edits.
[[nodiscard]] Scene scene_under(const Scene& scene, const Candidate& candidate);

/// An object on which an unexplained difference is visible.
struct DifferenceRegion {
    int object = 0;                // in Scene::objects
    std::uint64_t pixels = 0;      // how many of its comparable pixels are wrong
    double share = 0;              // the fraction of its comparable pixels that are wrong
    glm::ivec2 low{0}, high{0};    // the box around them, both corners included
    std::array<double, 3> mean{};  // of the absolute differences, in levels
};
/// Represents the sum of a term over all lights, in place of a light's index.
inline constexpr int all_lights = -2;
/// A term of the equation to which the difference is proportional.
struct DifferenceTerm {
    std::string term;      // emission, global_ambient, ambient, diffuse, specular; all: all terms of a light
    int light = -1;        // in Scene::lights; -1 for terms without a light; or all_lights
    double factor = 1;     // the apparent factor of the term
    double explained = 0;  // share of the difference's energy that this explains, 0 to 1
    std::array<double, 3> channels{};  // a factor for each channel, in place of `factor`; 0: none
    int object = -1;                   // the only object with this factor; -1: all
    [[nodiscard]] bool is_by_channel() const { return channels != std::array<double, 3>{}; }
};

/// The change to the scene that makes the candidates look most different.
struct Experiment {
    std::vector<Assignment> set;
    glm::ivec2 pixel{0};
    std::vector<MistakeSet> mistakes;
    std::vector<Rgb> shows;  // the pixel's colour under each candidate
};

struct Diagnosis {
    PictureSize size;
    bool of_pairs = false;  // the search included pairs of mistakes
    Verdict verdict = Verdict::NotComparable;
    std::string why;  // for NotComparable and NotReadable
    DisplayFinding display;
    std::vector<Candidate> candidates;  // best first
    // The pixels that differ, by PixelKind, from the correct picture, or from the first candidate if that is
    // the verdict:
    PixelCounts pixels{};
    std::vector<DifferenceRegion> regions;
    std::vector<DifferenceTerm> terms;
    std::vector<std::string> conventions;  // those that the program is assumed to follow
    std::optional<Experiment> experiment;
};

struct DiagnosisOptions {
    bool pairs = false;
    std::vector<std::string> conventions = {};  // from convention_names(): those the program follows
    int threads = 0;                            // 0: all cores; the result does not depend on it
    DiagnosisProgress progress = {};            // called during the search, which takes most of the time
};

/// Diagnoses `wrong`, whose bytes must be filled in (see as_shown()). Mistakes that are switched on in the
/// scene itself are ignored.
[[nodiscard]] Diagnosis diagnose(const SceneDocument& document, const Picture& wrong,
                                 const DiagnosisOptions& options);

/// Fills in the picture's bytes from its linear numbers, which already include exposure, as the scene's
/// display would; NaN is black. A picture that has bytes is unchanged.
[[nodiscard]] Picture as_shown(Picture picture, const Display& display);

/// Returns the small change to the camera, a light or a material under which the pictures of the given
/// mistakes differ most from each other; nothing for fewer than two, or if none of the changes tried
/// makes them differ by more than a few levels. Throws LoadCancelled when this thread's load is cancelled
/// (models/progress.h).
[[nodiscard]] std::optional<Experiment> find_experiment(const SceneDocument& document, PictureSize size,
                                                        const std::vector<MistakeSet>& mistakes, int threads);

}  // namespace glint
