#include "ui/features/export/export_picture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/views/views.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/picture_notes.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_a_look = 0.1;  // between checks for a finished job

/// Returns the open document, but with the scene that the picture shows.
SceneDocument shown_document(const UiState& state) {
    SceneDocument document = state.editor.document;
    document.scene = as_made(state, shown_scene(state));
    // Nothing else in the file indicates that the scene is incomplete.
    if (const auto& other = state.on_screen.resting; other && other->is_partial) {
        std::string& about = document.scene.about;
        about = about.empty() ? other->note : other->note + ". " + about;
    }
    return document;
}

/// Draws the shown scene in the background into a picture file for `path` and passes the file's bytes to
/// `deliver`.
void begin_picture(UiState& state, const ExportOptions& options, const std::string& path,
                   const std::function<Result<Notification>(const std::string& bytes)>& deliver) {
    const int threads = state.renderer->stats().threads;
    state.get<ExportState>().job = state.jobs.start<Notification>(
        fs::path(path).filename().string(),
        [document = shown_document(state), options, path, threads,
         deliver](LoadProgress& progress) -> Result<Notification> {
            const Result<std::string> bytes = picture_file(document, options, path, threads);
            if (const Problem* problem = problem_of(bytes)) return *problem;
            if (progress.cancelled) return Problem{path, "", "writing was cancelled", ""};
            return deliver(std::get<std::string>(bytes));
        });
}

}  // namespace

std::string shortest_command(const UiState& state, const CommandText& text) {
    const SceneDocument document = shown_document(state);
    std::string own = text(document, state.editor.saved);
    if (!document.path.empty() || state.shipped_scenes.empty()) return own;
    const std::string first = (fs::path(state.shipped_scenes) / "default.json").string();
    const Result<std::string> read = read_file(first, std::size_t{1} << 20);
    if (problem_of(read) != nullptr) return own;
    const Result<Scene> scene = parse_scene(std::get<std::string>(read), first);
    if (problem_of(scene) != nullptr) return own;
    SceneDocument as_first = document;
    as_first.path = first;
    std::string from_first = text(as_first, std::get<Scene>(scene));
    return from_first.size() < own.size() ? from_first : own;
}

Scene as_shown(Scene scene, PictureSize size) {
    size.keeps_width = true;
    scene.camera.projection = fitted(scene.camera.projection, size);
    return scene;
}

ExportOptions export_options(const UiState& state) {
    ExportOptions options = state.get<ExportState>().options;
    if (options.size == PictureSize{0, 0}) options.size = state.full_size;
    return options;
}

Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                 const std::string& path, int threads) {
    const Result<PictureFormat> known = picture_format(path);
    if (const Problem* problem = problem_of(known)) return *problem;
    const auto format = std::get<PictureFormat>(known);
    Renderer renderer(threads);
    const PictureSize size{options.size.width, options.size.height, true};
    const Picture& picture = renderer.render(document.scene, size, is_linear(format), options.samples);
    return picture_bytes(picture, format, document.scene.display.exposure,
                         carried_scene_text(document.scene, document.mesh_dir, path));
}

const FilePurpose save_picture_purpose{.title = "Save the picture",
                                       .button = "Save",
                                       .hint = "Picture (.png) with its scene embedded",
                                       .extensions = {".png"},
                                       .saves = true,
                                       .use = [](UiState& s, const std::string& path) {
                                           begin_export(s, {s.full_size, 1}, path);
                                       }};

const FilePurpose export_purpose{
    .title = "Export the picture",
    .button = "Export",
    .hint = "Picture: .png (with its scene), .pfm, .exr (linear float)",
    .extensions = {".png", ".pfm", ".exr"},
    .saves = true,
    .use = [](UiState& s, const std::string& path) { begin_export(s, export_options(s), path); }};

void ask_for_picture(UiState& state, const FilePurpose& purpose) {
    state.files.ask(purpose, offered_name(state, ".png"));
    state.files.warning = file_warning(notes_of_shown(state));
}

void begin_export(UiState& state, const ExportOptions& options, const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    if (const auto problem = why_not_writable(path)) return state.notifications.add(*problem);
    state.get<ExportState>().last = {options, name, state.editor.document.path};
    std::error_code failed;  // a missing folder is reported on writing
    const std::string folder = fs::absolute(path, failed).lexically_normal().parent_path().string();
    begin_picture(state, options, path,
                  [path, name, folder, options,
                   notes = notes_of_shown(state)](const std::string& bytes) -> Result<Notification> {
                      const auto written = write_file_at_once(path, bytes);
                      if (const Problem* problem = problem_of(written)) return *problem;
                      return file_message(
                          fmt::format("Saved {} in {} ({} × {}, {} {} per pixel)", name, folder,
                                      options.size.width, options.size.height, options.samples,
                                      options.samples == 1 ? "sample" : "samples"),
                          notes);
                  });
}

/// Describes the copied picture, which is not the picture on the screen if the latter is composed.
static const char* copied_words(const UiState& state) {
    return is_composed(state) ? "the scene's own picture" : "this picture";
}

void begin_copy(UiState& state) {
    const PictureSize size = state.full_size;
    begin_picture(state, {size, 1}, "clipboard.png",
                  [size, what = copied_words(state),
                   notes = notes_of_shown(state)](const std::string& bytes) -> Result<Notification> {
                      const auto copied = copy_png(bytes);
                      if (const Problem* problem = problem_of(copied)) return *problem;
                      return file_message(
                          fmt::format("Copied {} to the clipboard ({} × {})", what, size.width, size.height),
                          notes);
                  });
}

void copy_render_command(UiState& state, const ExportOptions& options, const std::string& out) {
    const std::string name = fs::path(out).filename().string();
    const std::string command = shortest_command(state, [&](const SceneDocument& of, const Scene& in_file) {
        return render_command_text(of, in_file, options.size, options.samples, name);
    });
    ImGui::SetClipboardText(command.c_str());
    state.notifications.add(
        Tone::Done, fmt::format("The command that draws {} is on the clipboard: {} × {}, {} {} per pixel, {}",
                                copied_words(state), options.size.width, options.size.height, options.samples,
                                options.samples == 1 ? "sample" : "samples", name));
}

void copy_last_command(UiState& state) {
    const std::optional<LastExport>& last = state.get<ExportState>().last;
    if (last && last->document == state.editor.document.path)
        return copy_render_command(state, last->options, last->file);
    copy_render_command(state, {state.full_size, 1}, offered_name(state, ".png"));
}

void poll_job(JobPtr<Notification>& job, Notifications& notifications) {
    if (!job) return;
    if (!job->done()) return redraw_within(seconds_a_look);
    const Result<Notification> result = job->take();
    job.reset();
    if (const Problem* problem = problem_of(result)) return notifications.add(*problem);
    const auto& done = std::get<Notification>(result);
    notifications.add(done.tone, done.text);
}

namespace {

struct NamedSize {
    const char* name;
    PictureSize size;
};
constexpr std::array sizes{NamedSize{"HD", {1280, 720}}, NamedSize{"Full HD", {1920, 1080}},
                           NamedSize{"4K", {3840, 2160}}, NamedSize{"Square", {1024, 1024}}};
constexpr std::array<int, 4> samples{1, 2, 4, 8};

/// Parses `text`, without surrounding spaces, as the width or height of a picture.
std::optional<int> side_in(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    int side = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return side >= 1 && side <= max_picture_side ? std::optional(side) : std::nullopt;
}

/// "800x600", "800 × 600".
std::optional<PictureSize> size_in(std::string_view text) {
    for (const std::string_view sign : {"x", "X", "×"}) {
        const std::size_t at = text.find(sign);
        if (at == std::string_view::npos) continue;
        const auto width = side_in(text.substr(0, at)), height = side_in(text.substr(at + sign.size()));
        if (width && height) return PictureSize{*width, *height};
    }
    return {};
}

void size_rows(UiState& state, ExportOptions& options) {
    const float room = label_cell("Size"), gap = px(3);
    std::vector<NamedSize> offered(sizes.begin(), sizes.end());
    if (state.rendered != nullptr) offered.insert(offered.begin(), {"As shown", state.full_size});
    const auto count = static_cast<float>(offered.size());
    const float width = (room - (count - 1) * gap) / count;
    for (const NamedSize& named : offered) {
        if (named.name != offered.front().name) ImGui::SameLine(0, gap);
        if (chosen_button(named.name, options.size == named.size, width)) options.size = named.size;
        list_control(named.name, "", last_item());
    }
    const Help help{"Size of the picture, in pixels; 800x600 sets both", ""};
    (void)take_refused_text();  // discards the text that another field refused
    integer_field("Width", options.size.width, Count{1, max_picture_side}, 1920, help);
    integer_field("Height", options.size.height, Count{1, max_picture_side}, 1080, help);
    if (const std::optional<PictureSize> both = size_in(take_refused_text())) {
        options.size = *both;
        unsay();
    }
}

/// Whether the key answers the dialog; while a number is being typed, the key belongs to the field.
bool answers(const UiInput& input, Key key) {
    const auto is_key = [key](const KeyPress& press) { return press == KeyPress{key}; };
    return enter_answers(std::any_of(input.presses.begin(), input.presses.end(), is_key)) &&
           !ImGui::GetIO().WantTextInput;
}

void sample_row(ExportOptions& options, const UiInput& input) {
    std::vector<Choice> choices;
    constexpr const char* names[] = {"1", "2", "4", "8"};
    for (const char* name : names) choices.push_back({name, name, "Samples per pixel"});
    const auto at = std::find(samples.begin(), samples.end(), options.samples) - samples.begin();
    label_cell("Samples");
    int chosen = segments("##samples", static_cast<int>(at), choices,
                          {"More samples smooth the edges; the interior of a face does not change", ""});
    if (answers(input, Key::Left)) --chosen;
    if (answers(input, Key::Right)) ++chosen;
    options.samples = samples[static_cast<std::size_t>(std::clamp(chosen, 0, int(samples.size()) - 1))];
}

void export_buttons(UiState& state, const UiInput& input) {
    ExportState& exporting = state.get<ExportState>();
    const bool saves = state.rendered != nullptr && !exporting.job;
    ImGui::BeginDisabled(!saves);
    std::error_code failed;  // a deleted working directory has no name
    const std::filesystem::path pictures = pictures_folder();
    const std::string folder = (pictures.empty() ? std::filesystem::current_path(failed) : pictures).string();
    const std::string label = whole_label("Save in " + folder) + "###save here";
    if (ImGui::Button(label.c_str(), {-1, 0}) || (saves && answers(input, Key::S))) {
        exporting.open = false;
        save_with_command(state, exporting.options);
    }
    list_control(label.c_str(), "", last_item());
    ImGui::EndDisabled();
    tooltip("Save here and copy its command",
            "Saves to a new file and copies the command line that writes it", folder);
    if (ImGui::Button("Choose a name…", {px(150), 0}) || answers(input, Key::Enter)) {
        exporting.open = false;
        ask_for_picture(state, export_purpose);
    }
    ImGui::SameLine();
    const CommandId copy = CommandId::CopyCommand;
    const bool copies = can_run(state, command(copy));
    ImGui::BeginDisabled(!copies);
    if (ImGui::Button("Copy as command", {px(140), 0}) || (copies && answers(input, Key::C)))
        copy_render_command(state, exporting.options, offered_name(state, ".png"));
    ImGui::EndDisabled();
    tooltip("Copy as command", "The command line that writes this picture", "", keys_of(copy));
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(90), 0})) exporting.open = false;
    ImGui::Dummy({0, px(2)});
    small_dim("Tab: width and height  ·  ← →: samples");
    small_dim("S: save, copy the command  ·  Enter: choose a name  ·  C: copy as command  ·  Esc: cancel");
}

/// The dialog for size and samples; the file dialog follows.
void export_dialog(UiState& state, const UiInput& input) {
    ExportState& exporting = state.get<ExportState>();
    static constexpr const char* id = "Export the picture##export";
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(px(470), window.x), 0});
    if (!begin_modal(id, &exporting.open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
    exporting.options = export_options(state);
    size_rows(state, exporting.options);
    const PictureSize size = exporting.options.size, view = state.full_size;
    if (std::int64_t{size.width} * view.height != std::int64_t{size.height} * view.width)
        small_dim("The picture's aspect ratio differs from the view's, so it frames the scene differently.");
    sample_row(exporting.options, input);
    ImGui::Dummy({0, px(4)});
    dim_text(".png embeds its scene; .pfm and .exr store linear floats");
    if (const std::string warning = file_warning(notes_of_shown(state)); !warning.empty())
        warning_text(warning);
    ImGui::Dummy({0, px(4)});
    export_buttons(state, input);
    if (!exporting.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

std::string unless_picture_can_be_written(const UiState& state) {
    return state.rendered == nullptr ? unless_drawn(nullptr)
                                     : unless_busy(bool(state.get<ExportState>().job));
}

std::string copy_disabled_reason(const UiState& state) {
    if (state.get<ExportState>().job) return unless_busy(true);
    return state.rendered == nullptr ? unless_drawn(nullptr) : clipboard_disabled_reason();
}

std::vector<WindowCommand> export_commands() {
    return {
        {.name = "Save picture…",
         .keys = {{Key::F12}},
         .section = Section::FilePicture,
         .run = [](UiState& s) { ask_for_picture(s, save_picture_purpose); },
         .why_disabled = unless_picture_can_be_written,
         .line_above = true,
         .words = "image screenshot png"},
        {.name = "Save picture here and copy its command",
         .keys = {{Key::F12, !ctrl, shift}},
         .section = Section::FilePicture,
         .run = save_with_command,
         .why_disabled = unless_picture_can_be_written},
        {.name = "Export picture…",
         .keys = {{Key::E, ctrl}},
         .section = Section::FilePicture,
         .run = [](UiState& s) { s.get<ExportState>().open = true; },
         .why_disabled = [](const UiState& s) { return unless_busy(bool(s.get<ExportState>().job)); },
         .words = "image png exr resolution"},
        {.name = "Copy picture",
         .keys = {{Key::C, ctrl, shift}},
         .section = Section::FilePicture,
         .run = begin_copy,
         .why_disabled = copy_disabled_reason,
         .words = "image clipboard screenshot"},
        {.name = "Copy as command",
         .keys = {{Key::K, ctrl, shift}},
         .section = Section::FilePicture,
         .run = copy_last_command,
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .id = CommandId::CopyCommand},
    };
}

}  // namespace

extern const Feature export_feature;
const Feature export_feature{
    .end = [](UiState& s) { poll_job(s.get<ExportState>().job, s.notifications); },
    .dialog = {[](const UiState& s) { return s.get<ExportState>().open; },
               [](UiState& s) { s.get<ExportState>().open = false; }, export_dialog, true},
    .commands = export_commands};

namespace {

namespace fs = std::filesystem;

/// An unused file name in pictures_folder(): "scene.png", "scene-2.png".
std::string free_name(const UiState& state) {
    const fs::path offered = pictures_folder() / fs::path(offered_name(state, ".png")).filename();
    std::error_code failed;
    fs::path name = offered;
    for (int i = 2; fs::exists(name, failed); ++i)
        name.replace_filename(fmt::format("{}-{}.png", offered.stem().string(), i));
    return name.string();
}

}  // namespace

void save_with_command(UiState& state, const ExportOptions& options) {
    const std::string name = free_name(state);
    copy_render_command(state, options, name);
    begin_export(state, options, name);
}

void save_with_command(UiState& state) {
    const std::optional<LastExport>& last = state.get<ExportState>().last;
    const bool again = last && last->document == state.editor.document.path;
    save_with_command(state, again ? last->options : ExportOptions{state.full_size, 1});
}

}  // namespace glint
