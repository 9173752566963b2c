// Opens the user's picture in the window and runs its diagnosis.
#include "ui/features/diagnosis/my_picture.h"

#include <fmt/chrono.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <thread>
#include <utility>

#include "diagnose/diagnosis_format.h"
#include "diagnose/search/display_change.h"
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
#include "ui/features/views/small_pictures.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double settling_time = 0.3;  // seconds without a change before a diagnosis begins
constexpr double look_again = 0.05;    // seconds between checks on the diagnosis

/// All cores but one, which the window keeps for itself.
int threads_beside() {
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 1 ? static_cast<int>(cores - 1) : 1;
}

/// Reports progress to the job, and stops the diagnosis when the job is cancelled.
PictureAnswer answer_of(SceneDocument document, Picture wrong, const std::string& arrived,
                        DiagnosisOptions options, LoadProgress& progress) {
    // Fits the projection to the picture once, because the diagnosis also draws at other sizes.
    Projection& projection = document.scene.camera.projection;
    projection = fitted(projection, wrong.size);
    const bool keeps_width = std::exchange(wrong.size.keeps_width, false);
    options.progress = [&progress](std::size_t done, std::size_t all) {
        progress.total = all;
        progress.done = done;
        if (progress.cancelled) throw LoadCancelled();
    };
    PictureAnswer answer;
    answer.diagnosis = diagnose(document, wrong, options);
    answer.diagnosis.display.arrived = arrived;
    Picture mine = undone(wrong, answer.diagnosis.display.change);
    mine.size.keeps_width = keeps_width;
    answer.mine = std::make_shared<const Picture>(std::move(mine));
    Renderer renderer(options.threads);
    for (const Candidate& candidate : answer.diagnosis.candidates)
        answer.thumbnails.push_back(
            renderer.render(scene_under(document.scene, candidate), thumbnail_size(wrong.size)));
    return answer;
}

void show_answer(UiState& state, PictureAnswer answer) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (is_shader(mine.path)) answer.mine = mine.shown;  // for a shader, the window made the bytes
    mine.chosen = 0;
    mine.sheet.reset(thumbnail_size(mine.shown->size), 1,
                     std::max(1, static_cast<int>(answer.thumbnails.size())));
    for (std::size_t i = 0; i < answer.thumbnails.size(); ++i)
        mine.sheet.put(static_cast<int>(i), answer.thumbnails[i]);
    state.get<CompareState>().choice.mine = answer.mine;
    mine.verdicts.insert(
        mine.verdicts.begin(),
        fmt::format("{:%H:%M:%S}  {}", fmt::localtime(std::time(nullptr)), finding_of(answer.diagnosis)));
    mine.verdicts.resize(std::min<std::size_t>(mine.verdicts.size(), 3));
    mine.answer = std::move(answer);
    mine.current = true;
}

/// Whether the picture at `path` has the wider field of view of Glint's own pictures
/// (PictureSize::keeps_width). A picture with the aspect ratio of the picture from which the open scene was
/// loaded is assumed to have it.
bool keeps_width(const std::string& path, PictureSize size, const std::optional<PictureSize>& opened) {
    return fitted_size_in(path) || (opened && size.width * opened->height == size.height * opened->width);
}

BroughtPicture brought(const std::string& path, const std::shared_ptr<const Picture>& file,
                       const Scene& scene) {
    auto [picture, undone] = as_arrived(as_shown(*file, scene.display), scene);
    return {.path = path,
            .file = file,
            .shown = std::make_shared<const Picture>(std::move(picture)),
            .display = scene.display,
            .arrived = std::move(undone)};
}

/// Returns `picture` at half its brightness, or a black picture if `picture` is null.
std::shared_ptr<const Picture> dimmed(const Picture* picture, PictureSize size) {
    Picture dark =
        picture != nullptr ? *picture : Picture{size, std::vector<std::uint8_t>(4 * size.pixels()), {}};
    for (std::size_t i = 0; i < dark.rgba.size(); ++i) dark.rgba[i] = i % 4 == 3 ? 255 : dark.rgba[i] / 2;
    return std::make_shared<const Picture>(std::move(dark));
}

/// Keeps showing the last picture, dimmed, and does not diagnose it.
void show_outdated(UiState& state, std::vector<Problem> messages) {
    MyPictureState& mine = state.get<MyPictureState>();
    leave(mine.job, mine.ending);
    state.get<CompareState>().choice.mine = dimmed(mine.shown.get(), state.full_size);
    if (!mine.shown) mine.shown = mine.file = state.get<CompareState>().choice.mine;
    mine.messages = std::move(messages);
    mine.is_outdated = mine.settled = true;
    mine.current = false;
}

void show_in_editor(ShaderEditor& editor, const std::string& text) {
    const bool is_edited = editor.text != editor.saved;
    editor.saved = text;
    if (is_edited || text == editor.text) return;
    if (editor.is_active) let_go_of_fields();  // otherwise ImGui would restore its own copy of the text
    editor.text = text;
}

/// Watches the file on a thread, so the window can sleep.
void watch(UiState& state, WatchedFile file) {
    MyPictureState& mine = state.get<MyPictureState>();
    leave(mine.watching);
    mine.watching = state.jobs.start<std::monostate>(
        mine.name, [file = std::move(file)](LoadProgress& progress) mutable -> Result<std::monostate> {
            while (!progress.cancelled &&
                   file.update(std::chrono::steady_clock::now()) == WatchedFile::Change::None)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            return std::monostate();
        });
}

/// Adds the new picture to the comparison and shows its tab.
void show_picture(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    CompareChoice& choice = state.get<CompareState>().choice;
    if (!mine.shown) {
        borrow_comparison(state.get<CompareState>());
        state.get<InspectorState>().tab_before = state.get<InspectorState>().tab;
    }
    mine.shown.reset();
    mine.answer.reset();
    mine.verdicts.clear();
    choice.on = true;
    choice.shows_stored = false;
    state.get<LectureState>().frozen.reset();  // otherwise the picture would be compared with a frozen scene
    set_parts(choice, {{}, {Variant::Kind::Mine, 0}});
    state.get<DebugViewState>().set.choice.view = DebugView::Picture;
    state.get<InspectorState>().tab = InspectorTab::MyPicture;
    state.left_shows_inspector = state.layout.right = true;
}

void take_picture(UiState& state, BroughtPicture picture) {
    MyPictureState& mine = state.get<MyPictureState>();
    leave(mine.job, mine.ending);
    if (!mine.follows) show_picture(state);
    if (mine.path != picture.path) mine.editor = {};
    mine.path = picture.path;
    mine.name = mine.reading->name();
    watch(state, std::move(*picture.watched));
    mine.pairs = false;
    mine.tried.reset();
    show_in_editor(mine.editor, picture.text);
    if (!picture.shown) return show_outdated(state, std::move(picture.messages));
    mine.shown = std::move(picture.shown);
    mine.file = std::move(picture.file);
    mine.arrived = std::move(picture.arrived);
    mine.display = picture.display;
    mine.messages = std::move(picture.messages);
    mine.is_outdated = false;
    ask_again(mine);
    state.get<CompareState>().choice.mine = mine.shown;
}

void poll_reading(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (!mine.reading || !mine.reading->done()) return;
    Result<BroughtPicture> read = mine.reading->take();
    if (Problem* problem = std::get_if<Problem>(&read); problem != nullptr && mine.follows)
        show_outdated(state, {std::move(*problem)});
    else if (problem != nullptr)
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
        [document = std::move(document), wrong = mine.shown, arrived = mine.arrived,
         options = DiagnosisOptions{mine.pairs, mine.conventions, threads_beside()}](LoadProgress& progress)
            -> Result<PictureAnswer> { return answer_of(document, *wrong, arrived, options, progress); });
}

/// Starts loading a file. For `follows`, see MyPictureState.
void begin_reading(UiState& state, const std::string& path, bool follows) {
    MyPictureState& mine = state.get<MyPictureState>();
    leave(mine.reading);
    mine.reading_since = ImGui::GetTime();
    mine.follows = follows;
    mine.drawn_of = under_mistakes(state.editor.scene(), {});
    mine.reading = state.jobs.start<BroughtPicture>(
        std::filesystem::path(path).filename().string(),
        [path, scene = mine.drawn_of, size = state.full_size, opened = state.editor.document.fitted_to,
         limits = mine.shader_limits](LoadProgress& progress) mutable -> Result<BroughtPicture> {
            limits.is_cancelled = [&progress] { return progress.cancelled.load(); };
            if (is_shader(path)) return drawn_by_shader(path, scene, size, limits);
            const WatchedFile watched(path);
            Result<Picture> read = read_picture(path);
            if (const Problem* problem = problem_of(read)) return *problem;
            auto& file = std::get<Picture>(read);
            file.size.keeps_width = keeps_width(path, file.size, opened);
            BroughtPicture picture = brought(path, std::make_shared<const Picture>(std::move(file)), scene);
            picture.watched = watched;
            return picture;
        });
}

/// Reloads the file when it has changed, and redraws a shader when the scene has changed.
void follow_file(UiState& state, const Scene& now) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (is_held(state) || (mine.reading && !mine.follows)) return;
    const bool has_changed = mine.watching && mine.watching->done();
    const bool is_of_before = is_shader(mine.path) && !mine.reading && !(now == mine.drawn_of);
    if (has_changed || is_of_before) read_again(state);
}

/// The label of the picture in a comparison.
std::string label_of_mine(const MyPictureState& mine) {
    const std::string label = is_shader(mine.path) ? "My shader" : "My picture";
    if (mine.is_outdated) return label + ": see the error";
    return mine.current ? label + ": " + finding_of(mine.answer->diagnosis) : label;
}

/// Recomputes the bytes of a linear picture when the open scene's transfer function has changed.
void keep_shown_by_the_display(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    const Scene& scene = state.editor.scene();
    if (!mine.file->rgba.empty() || scene.display.transfer == mine.display.transfer) return;
    mine.shown = brought(mine.path, mine.file, scene).shown;
    mine.display = scene.display;
    state.get<CompareState>().choice.mine = mine.shown;
}

/// Whether the file is a picture with no embedded scene that Glint could open.
bool is_bare_picture(const std::string& path) {
    const Result<PictureFormat> format = picture_format(path);
    if (problem_of(format) != nullptr) return false;
    std::error_code failed;
    return std::filesystem::exists(path, failed) && !carries_scene(path);
}

/// Call this once a frame. Collects finished results, and begins a new diagnosis when the scene, apart from
/// its mistakes, has changed and then stayed the same for a moment.
void poll_my_picture(UiState& state) {
    poll_reading(state);
    MyPictureState& mine = state.get<MyPictureState>();
    mine.editor.is_active = false;  // until the editor is drawn
    if (!mine.shown) return;
    keep_shown_by_the_display(state);
    const Scene now = under_mistakes(state.editor.scene(), {});
    follow_file(state, now);
    state.get<CompareState>().label_of_mine = label_of_mine(mine);
    if (!(now == mine.asked_of) && !(mine.tried && now == mine.tried->scene)) {
        leave(mine.job, mine.ending);
        mine.asked_of = now;
        mine.tried.reset();
        mine.settled = mine.current = false;
        mine.asked_since = ImGui::GetTime();
    }
    if (mine.settled || mine.is_outdated || mine.reading || awaits_mesh(state)) return;
    redraw_within(look_again);
    if (!mine.job && has_ended(mine.ending) && !ImGui::IsAnyMouseDown() &&
        ImGui::GetTime() - mine.asked_since >= settling_time)
        begin_diagnosis(state);
    if (!mine.job || !mine.job->done()) return;
    Result<PictureAnswer> answer = mine.job->take();
    mine.job.reset();
    mine.settled = true;
    if (const Problem* problem = problem_of(answer)) return state.notifications.add(*problem);
    show_answer(state, std::get<PictureAnswer>(std::move(answer)));
}

}  // namespace

void bring_picture(UiState& state, const std::string& path) {
    if (is_held(state))
        return state.notifications.add(Tone::Warning,
                                       "Answer the lesson's question first, then drop the picture");
    begin_reading(state, path, false);
}

void read_again(UiState& state) {
    const std::string& path = state.get<MyPictureState>().path;
    watch(state, WatchedFile(path));
    begin_reading(state, path, true);
}

void put_picture_away(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    leave(mine.reading);
    leave(mine.job, mine.ending);
    if (!mine.shown) return;
    CompareState& compare = state.get<CompareState>();
    give_comparison_back(compare);
    compare.choice.mine.reset();
    compare.label_of_mine.clear();
    leave(mine.watching);
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

void cancel_diagnosis(MyPictureState& mine) {
    leave(mine.job, mine.ending);
    mine.settled = true;
}

void ask_again(MyPictureState& mine) {
    mine.settled = mine.current = false;
    mine.asked_since = ImGui::GetTime() - settling_time;
}

void ask_for_pairs(MyPictureState& mine) {
    mine.pairs = true;
    ask_again(mine);
}

std::string why_no_pairs(const MyPictureState& mine) {
    if (!mine.answer || !mine.current) return "No picture has been compared with this scene";
    if (mine.pairs) return "The search for two mistakes at once is already done";
    return mine.answer->diagnosis.verdict == Verdict::NotInCatalogue
               ? std::string()
               : "There is nothing left for two mistakes to explain";
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

void pick_pixel_of_mine(UiState& state, glm::ivec2 pixel) {
    const PictureSize size = state.rendered->size;
    const glm::dvec2 there = glm::dvec2(pixel) + 0.5;
    const glm::dvec2 here =
        pixels_between(state.editor.scene().camera, state.get<MyPictureState>().shown->size, size)(there);
    if (is_inside(size, here)) ask_about(state.viewport, here / glm::dvec2(size.width, size.height));
}

void try_experiment(UiState& state, const Experiment& experiment) {
    const Result<Scene> changed = scene_variant(state.editor.document, experiment.set);
    if (const Problem* problem = problem_of(changed)) return state.notifications.add(*problem);
    Scene& scene = state.editor.scene();
    state.editor.edits_camera |= std::get<Scene>(changed).camera != scene.camera;
    scene = std::get<Scene>(changed);
    state.get<MyPictureState>().tried = TriedExperiment{experiment, under_mistakes(scene, {})};
    pick_pixel_of_mine(state, experiment.pixel);
}

const Experiment* offered_experiment(const UiState& state) {
    const MyPictureState& mine = state.get<MyPictureState>();
    // The experiment's pointers refer to the diagnosed scene.
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
                                     .hint = "A picture of this scene from any program (.png .pfm .exr)",
                                     .nothing = "No folders or pictures here",
                                     .extensions = {".png", ".pfm", ".exr"},
                                     .use = bring_picture};

namespace {

std::vector<WindowCommand> my_picture_commands() {
    return {
        {.name = "My shader…",
         .section = Section::FileOpen,
         .run = [](UiState& s) { s.files.ask(my_shader_purpose, s.editor.document.path); },
         .words = "glsl equation code"},
        {.name = "Blank shader…",
         .section = Section::FileOpen,
         .run = [](UiState& s) { s.files.ask(blank_shader_purpose, offered_name(s, ".glsl")); },
         .words = "glsl equation code write"},
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
                 return unless(s.get<MyPictureState>().shown != nullptr, "No picture is open for comparison");
             }},
        {.name = "Look for two mistakes at once",
         .run = [](UiState& s) { ask_for_pairs(s.get<MyPictureState>()); },
         .why_disabled = [](const UiState& s) { return why_no_pairs(s.get<MyPictureState>()); },
         .words = "diagnose my picture pairs"},
        {.name = "Change the scene to confirm the mistake",
         .run = [](UiState& s) { try_experiment(s, *offered_experiment(s)); },
         .why_disabled =
             [](const UiState& s) {
                 return unless(offered_experiment(s) != nullptr,
                               "No change to the scene would narrow down the mistake");
             },
         .words = "diagnose my picture experiment"},
    };
}

bool drop_picture(UiState& state, const std::string& path) {
    if (!is_shader(path) && !is_bare_picture(path)) return false;
    bring_picture(state, path);
    return true;
}

void draw_reading(UiState& state, const Layout& layout) {
    MyPictureState& mine = state.get<MyPictureState>();
    if (mine.reading && !state.loading.active() &&
        progress_panel(*mine.reading, mine.reading_since, layout.centre))
        leave(mine.reading);
}

/// Saves the shader while its editor has keyboard focus.
bool press_key(UiState& state, KeyPress press) {
    const bool saves = press == KeyPress{Key::S, ctrl} && state.get<MyPictureState>().editor.is_active;
    if (saves) save_shader(state);
    return saves;
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
                                 .key = press_key,
                                 .escape = leave_picture,
                                 .drop = drop_picture,
                                 .leave_document =
                                     [](UiState& s, const SceneDocument& next) {
                                         if (is_another(s, next)) put_picture_away(s);
                                     }};

}  // namespace glint
