#pragma once
// Executes the runs of a lesson: returns the JSON of the commands of the same names, by the same code
// (docs/command_line.md). Used by `glint lessons`, and by the window for the student's current scene.

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

    /// Applies these last to every later scene: a test switches a mistake on and finds the claims that fail.
    void set_always(std::vector<Assignment> assignments) { always_ = std::move(assignments); }

    /// Opens a lesson's scene with its meshes; caches the last scene.
    [[nodiscard]] Result<SceneDocument> open(const Lesson& lesson);

    /// Returns the document with the assignments applied. A problem with one is reported at `line` of the
    /// lesson.
    [[nodiscard]] static Result<SceneDocument> with(const SceneDocument& document,
                                                    const std::vector<Assignment>& set, const Lesson& lesson,
                                                    int line);

    /// The scene of a step's picture on paper: unless it is for the `key`, the step's `picture` assignments
    /// hide the answer. `document` is the step's scene.
    [[nodiscard]] static Result<SceneDocument> for_paper(const SceneDocument& document,
                                                         const LessonStep& step, const Lesson& lesson,
                                                         bool key);

    /// The answers of the runs on that scene, by name. A problem has the lesson's file and the line of the
    /// run.
    [[nodiscard]] Result<NamedValues> answers(const SceneDocument& document, const Lesson& lesson,
                                              const std::vector<LessonRun>& runs);

    /// The scene as a picture, with `always` applied.
    [[nodiscard]] Result<Picture> picture(const SceneDocument& document, const Lesson& lesson,
                                          PictureSize size, int samples);

  private:
    Result<Json> answer(const SceneDocument& document, const Lesson& lesson, const LessonRun& run,
                        NamedPictures& pictures);
    /// Many rays, independent of the scene: caches answers.
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

/// The right answer of a prediction on that scene: a number; the number of an option, from 0; a pixel; a
/// list; a colour.
struct RightAnswer {
    Json value;
    double tolerance = 0;     // 0 for a choice
    std::vector<Json> wrong;  // the values of Prediction::wrong
};
[[nodiscard]] Result<RightAnswer> right_answer(LessonRunner& runner, const SceneDocument& document,
                                               const Lesson& lesson, const Prediction& prediction);

/// The distance of `given` from the right answer, both of the same kind: the difference of two numbers; 0 or
/// 1 for a choice; pixels between two positions; the root mean square for a sketch; the largest difference of
/// a channel for a colour. An answer is right if this is at most the tolerance.
/// Precondition: lists of equal length.
[[nodiscard]] double how_far(PredictionKind kind, const Json& given, const Json& right);

/// The misconception behind a given answer; empty if it is right, or if none is known.
[[nodiscard]] std::string thought_behind(const Prediction& question, const RightAnswer& right,
                                         const Json& given);

}  // namespace glint
