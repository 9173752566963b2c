// Opens the user's picture in the window, and runs the diagnosis of it.
#include "ui/features/diagnosis/my_picture.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <thread>
#include <utility>

#include "diagnose/search/undone.h"
#include "models/io/file.h"
#include "renderer/image/image_file.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/loading.h"
#include "ui/feature.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/views/compare_view.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/fitted_picture.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double stillness = 0.3;    // seconds before a diagnosis begins
constexpr double look_again = 0.05;  // seconds between checks of its progress

/// The window keeps one core for itself.
int threads_beside() {
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 1 ? static_cast<int>(cores - 1) : 1;
}

/// Reports to the job's own progress, and stops the diagnosis when that is cancelled.
PictureAnswer answer_of(const SceneDocument& document, const Picture& wrong, bool pairs,
                        LoadProgress& progress) {
    DiagnosisOptions options{pairs, threads_beside(), {}};
    options.progress = [&progress](std::size_t done, std::size_t all) {
        progress.total = all;
        progress.done = done;
        if (progress.cancelled) throw LoadCancelled();
    };
    PictureAnswer answer;
    answer.diagnosis = diagnose(document, wrong, options);
    answer.mine = std::make_shared<const Picture>(undone(wrong, answer.diagnosis.display.change));
    Renderer renderer(options.threads);
    for (const Candidate& candidate : answer.diagnosis.candidates)
        answer.thumbnails.push_back(
            renderer.render(under_mistakes(document.scene, candidate.mistakes), thumbnail_size(wrong.size)));
    return answer;
}

void show_answer(UiState& state, PictureAnswer answer) {
    MyPictureState& mine = state.get<MyPictureState>();
    mine.chosen = 0;
    mine.sheet.reset(thumbnail_size(mine.shown->size), 1,
                     std::max(1, static_cast<int>(answer.thumbnails.size())));
    for (std::size_t i = 0; i < answer.thumbnails.size(); ++i)
        mine.sheet.put(static_cast<int>(i), answer.thumbnails[i]);
    state.get<CompareState>().choice.mine = answer.mine;
    mine.answer = std::move(answer);
    mine.current = true;
}

BroughtPicture brought(const std::string& path, const std::shared_ptr<const Picture>& file,
                       const Display& display) {
    if (!file->rgba.empty()) return {path, file, file, display};
    return {path, file, std::make_shared<const Picture>(as_shown(*file, display)), display};
}

/// Adds a loaded picture to the comparison and shows its tab.
void take_picture(UiState& state, BroughtPicture picture) {
    MyPictureState& mine = state.get<MyPictureState>();
    CompareChoice& choice = state.get<CompareState>().choice;
    leave(mine.job, mine.ending);
    if (!mine.shown) {
        borrow_comparison(state.get<CompareState>());
        state.get<InspectorState>().tab_before = state.get<InspectorState>().tab;
    }
    mine.path = picture.path;
    mine.name = mine.reading->name();
    mine.shown = std::move(picture.shown);
    mine.file = std::move(picture.file);
    mine.display = picture.display;
    mine.pairs = false;
    mine.answer.reset();
    mine.tried.reset();
    ask_again(mine);
    choice.mine = mine.shown;
    choice.on = true;
    choice.shows_stored = false;
    state.get<LectureState>().frozen.reset();  // it would be compared with a scene that is not the edited one
    set_parts(choice, {{}, {Variant::Kind::Mine, 0}});
    state.get<DebugViewState>().set.choice.view = DebugView::Picture;
    state.get<InspectorState>().tab = InspectorTab::MyPicture;
    state.left_shows_inspector = state.layout.right = true;
}

void poll_reading(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (!mine.reading) return;
    redraw_within(look_again);
    if (!mine.reading->done()) return;
    Result<BroughtPicture> read = mine.reading->take();
    if (const Problem* problem = problem_of(read))
        state.notifications.add(*problem);
    else
        take_picture(state, std::get<BroughtPicture>(std::move(read)));
    mine.reading.reset();
}

void begin_diagnosis(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    SceneDocument document = state.editor.document;
    document.scene = mine.asked_of;
    mine.job = state.jobs.start<PictureAnswer>(
        mine.name,
        [document = std::move(document), wrong = mine.shown, pairs = mine.pairs](LoadProgress& progress)
            -> Result<PictureAnswer> { return answer_of(document, *wrong, pairs, progress); });
}

/// Recomputes the bytes of a linear picture when the open scene's transfer function has changed.
void keep_shown_by_the_display(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    const Display& display = state.editor.scene().display;
    if (!mine.file->rgba.empty() || display.transfer == mine.display.transfer) return;
    mine.shown = brought(mine.path, mine.file, display).shown;
    mine.display = display;
    state.get<CompareState>().choice.mine = mine.shown;
}

}  // namespace

bool is_bare_picture(const std::string& path) {
    const Result<PictureFormat> format = picture_format(path);
    if (problem_of(format) != nullptr) return false;
    std::error_code failed;
    return std::filesystem::exists(path, failed) && !carries_scene(path);
}

void bring_picture(UiState& state, const std::string& path) {
    if (is_held(state))
        return state.notifications.add(Tone::Warning, "The lesson asks first: answer, then drop the picture");
    MyPictureState& mine = state.get<MyPictureState>();
    cancel_reading(mine);
    mine.reading_since = ImGui::GetTime();
    const Display display = state.editor.scene().display;
    mine.reading = state.jobs.start<BroughtPicture>(
        std::filesystem::path(path).filename().string(),
        [path, display](LoadProgress&) -> Result<BroughtPicture> {
            Result<Picture> read = read_picture(path);
            if (const Problem* problem = problem_of(read)) return *problem;
            return brought(path, std::make_shared<const Picture>(std::get<Picture>(std::move(read))),
                           display);
        });
}

void put_picture_away(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    cancel_reading(mine);
    leave(mine.job, mine.ending);
    if (!mine.shown) return;
    CompareState& compare = state.get<CompareState>();
    give_comparison_back(compare);
    compare.choice.mine.reset();
    if (compare.borrowers > 0) compare.choice.on = false;
    mine.shown.reset();
    mine.file.reset();
    mine.answer.reset();
    mine.tried.reset();
    mine.right.reset();
    mine.mistaken.reset();
    if (state.get<InspectorState>().tab == InspectorTab::MyPicture)
        state.get<InspectorState>().tab = state.get<InspectorState>().tab_before;
}

void cancel_reading(MyPictureState& mine) { leave(mine.reading); }

void cancel_diagnosis(MyPictureState& mine) {
    leave(mine.job, mine.ending);
    mine.settled = true;
}

void ask_again(MyPictureState& mine) {
    mine.settled = mine.current = false;
    mine.asked_since = ImGui::GetTime() - stillness;
}

void ask_for_pairs(MyPictureState& mine) {
    mine.pairs = true;
    ask_again(mine);
}

std::string why_no_pairs(const MyPictureState& mine) {
    if (!mine.answer || !mine.current) return "No picture was compared with this scene";
    if (mine.pairs) return "The search for two mistakes at once is already done";
    return mine.answer->diagnosis.verdict == Verdict::NotInCatalogue
               ? std::string()
               : "There is nothing left for two mistakes to explain";
}

void poll_my_picture(UiState& state) {
    poll_reading(state);
    MyPictureState& mine = state.get<MyPictureState>();
    if (!mine.shown) return;
    keep_shown_by_the_display(state);
    const Scene now = under_mistakes(state.editor.scene(), {});
    if (!(now == mine.asked_of) && !(mine.tried && now == mine.tried->scene)) {
        leave(mine.job, mine.ending);
        mine.asked_of = now;
        mine.tried.reset();
        mine.settled = mine.current = false;
        mine.asked_since = ImGui::GetTime();
    }
    if (mine.settled || awaits_mesh(state)) return;
    redraw_within(look_again);
    if (!mine.job && has_ended(mine.ending) && !ImGui::IsAnyMouseDown() &&
        ImGui::GetTime() - mine.asked_since >= stillness)
        begin_diagnosis(state);
    if (!mine.job || !mine.job->done()) return;
    Result<PictureAnswer> answer = mine.job->take();
    mine.job.reset();
    mine.settled = true;
    if (const Problem* problem = problem_of(answer)) return state.notifications.add(*problem);
    show_answer(state, std::get<PictureAnswer>(std::move(answer)));
}

PictureSize thumbnail_size(PictureSize size) {
    constexpr int longest = 168;
    const int most = std::max({size.width, size.height, 1});
    return {std::max(longest * size.width / most, 1), std::max(longest * size.height / most, 1)};
}

void switch_mistakes(Scene& scene, const MistakeSet& mistakes) {
    const Scene under = under_mistakes(scene, mistakes);
    scene = under == scene ? under_mistakes(scene, {}) : under;
}

void try_experiment(UiState& state, const Experiment& experiment) {
    const Result<Scene> changed = scene_variant(state.editor.document, experiment.set);
    if (const Problem* problem = problem_of(changed)) return state.notifications.add(*problem);
    Scene& scene = state.editor.scene();
    state.editor.edits_camera |= std::get<Scene>(changed).camera != scene.camera;
    scene = std::get<Scene>(changed);
    state.get<MyPictureState>().tried = TriedExperiment{experiment, under_mistakes(scene, {})};
    const PictureSize size = state.rendered->size;
    const glm::dvec2 there = glm::dvec2(experiment.pixel) + 0.5;
    const glm::dvec2 here =
        pixels_between(scene.camera, state.get<MyPictureState>().shown->size, size)(there);
    if (is_inside(size, here)) ask_about(state.viewport, here / glm::dvec2(size.width, size.height));
}

const Experiment* offered_experiment(const UiState& state) {
    const MyPictureState& mine = state.get<MyPictureState>();
    // Its pointers refer to the diagnosed scene.
    if (!mine.answer || !mine.current || shown_experiment(state) != nullptr) return nullptr;
    const std::optional<Experiment>& found = mine.answer->diagnosis.experiment;
    return found ? &*found : nullptr;
}

const Experiment* shown_experiment(const UiState& state) {
    const auto& tried = state.get<MyPictureState>().tried;
    return tried && under_mistakes(state.editor.scene(), {}) == tried->scene ? &tried->experiment : nullptr;
}

const FilePurpose my_picture_purpose{.title = "Compare my picture",
                                     .button = "Compare",
                                     .hint = "A picture of this scene by any program (.png .pfm .exr)",
                                     .nothing = "No folder and no picture here",
                                     .extensions = {".png", ".pfm", ".exr"},
                                     .use = bring_picture};

namespace {

std::vector<WindowCommand> my_picture_commands() {
    return {
        {.name = "Compare my picture…",
         .section = Section::ComparePicture,
         .run = [](UiState& s) { s.files.ask(my_picture_purpose, s.editor.document.path); },
         .line_above = true,
         .words = "diagnose wrong mistake image"},
        {.name = "Close my picture",
         .section = Section::ComparePicture,
         .run = put_picture_away,
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<MyPictureState>().shown != nullptr,
                               "No picture to compare with is open");
             }},
        {.name = "Look for two mistakes at once",
         .run = [](UiState& s) { ask_for_pairs(s.get<MyPictureState>()); },
         .why_disabled = [](const UiState& s) { return why_no_pairs(s.get<MyPictureState>()); },
         .words = "diagnose my picture pairs"},
        {.name = "Change the scene this way to be sure",
         .run = [](UiState& s) { try_experiment(s, *offered_experiment(s)); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(offered_experiment(s) != nullptr,
                               "No change would narrow down the mistake in a picture");
             },
         .words = "diagnose my picture experiment"},
    };
}

bool drop_picture(UiState& state, const std::string& path) {
    if (!is_bare_picture(path)) return false;
    bring_picture(state, path);
    return true;
}

void draw_reading(UiState& state, const Layout& layout) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (mine.reading && !state.loading.active() &&
        progress_panel(*mine.reading, mine.reading_since, layout.centre))
        cancel_reading(mine);
}

bool leave_picture(UiState& state) {
    const MyPictureState& mine = state.get<MyPictureState>();
    if (!mine.shown && !mine.reading) return false;
    put_picture_away(state);
    return true;
}

}  // namespace

extern const Feature my_picture_feature;
const Feature my_picture_feature{.begin = [](UiState& s, const UiInput&) { poll_my_picture(s); },
                                 .draw = draw_reading,
                                 .sheet = [](UiState& s) { return &s.get<MyPictureState>().sheet; },
                                 .commands = my_picture_commands,
                                 .escape = leave_picture,
                                 .drop = drop_picture,
                                 .leave_document =
                                     [](UiState& s, const SceneDocument& next) {
                                         if (is_another(s, next)) put_picture_away(s);
                                     }};

}  // namespace glint
