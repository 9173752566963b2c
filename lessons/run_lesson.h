#pragma once
// Executes the runs of a lesson. Returns the JSON of the commands with the same names, produced by the same
// code (docs/command_line.md). Used by `glint lessons`, and by the window for the student's current scene.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lessons/lesson.h"
#include "renderer/reflectance/microfacets.h"
#include "renderer/renderer.h"

namespace glint {

using NamedPictures = std::map<std::string, Picture>;

class LessonRunner {
  public:
    /// `threads`: as for Renderer.
    explicit LessonRunner(int threads = 0) : renderer_(threads) {}

    /// Sets assignments that are applied last to every scene from now on. A test uses this to switch a
    /// mistake on and find the claims that fail.
    void set_always(std::vector<Assignment> assignments) { always_ = std::move(assignments); }

    /// Opens a lesson's scene with its meshes. Caches the most recent scene.
    [[nodiscard]] Result<SceneDocument> open(const Lesson& lesson);

    /// Returns the document with the assignments applied. Problems are reported at `line` of the lesson.
    [[nodiscard]] static Result<SceneDocument> with(const SceneDocument& document,
                                                    const std::vector<Assignment>& set, const Lesson& lesson,
                                                    int line);

    /// The scene of a step's printed picture. Unless it is for the `key`, the step's `picture` assignments
    /// hide the answer. `document` is the step's scene.
    [[nodiscard]] static Result<SceneDocument> for_paper(const SceneDocument& document,
                                                         const LessonStep& step, const Lesson& lesson,
                                                         bool key);

    /// Returns the results of the runs for that scene, by name. A problem includes the lesson's file and the
    /// line of the run.
    [[nodiscard]] Result<NamedValues> answers(const SceneDocument& document, const Lesson& lesson,
                                              const std::vector<LessonRun>& runs);

    /// Draws the scene, with the assignments of set_always().
    [[nodiscard]] Result<Picture> picture(const SceneDocument& document, const Lesson& lesson,
                                          PictureSize size, int samples);

  private:
    Result<Json> answer(const SceneDocument& document, const Lesson& lesson, const LessonRun& run,
                        NamedPictures& pictures);
    /// Traces many rays but does not depend on the scene, so results are cached.
    const Json& microfacets_answer(const MicrofacetOptions& options);

    std::vector<Assignment> always_;
    Renderer renderer_;
    SceneDocument opened_;
    struct KeptMicrofacets {
        MicrofacetOptions options;
        Json answer;
    };
    std::vector<KeptMicrofacets> microfacets_;
};

/// The right answer to a prediction for that scene: a number, the index of an option, a pixel, a list, or a
/// colour.
struct RightAnswer {
    Json value;
    double tolerance = 0;     // 0 for a choice
    std::vector<Json> wrong;  // the values of Prediction::wrong
};
[[nodiscard]] Result<RightAnswer> right_answer(LessonRunner& runner, const SceneDocument& document,
                                               const Lesson& lesson, const Prediction& prediction);

/// The distance between `given` and the right answer, both of the same kind: the difference of two numbers; 0
/// or 1 for a choice; pixels between two positions; the root mean square for a sketch; the largest channel
/// difference for a colour. An answer is right if this is at most the tolerance. Precondition: lists have
/// equal lengths.
[[nodiscard]] double how_far(PredictionKind kind, const Json& given, const Json& right);

/// The misconception behind a given answer; empty if the answer is right or matches no known misconception.
[[nodiscard]] std::string thought_behind(const Prediction& question, const RightAnswer& right,
                                         const Json& given);

}  // namespace glint
