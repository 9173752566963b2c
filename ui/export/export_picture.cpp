#include "ui/export/export_picture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/export/clipboard.h"
#include "ui/export/save_with_command.h"
#include "ui/picture/draw_picture.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/numbers/number_input.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_a_look = 0.1;  // between looks whether it is done

struct NamedSize {
    const char* name;
    PictureSize size;
};
constexpr std::array sizes{NamedSize{"HD", {1280, 720}}, NamedSize{"Full HD", {1920, 1080}},
                           NamedSize{"4K", {3840, 2160}}, NamedSize{"Square", {1024, 1024}}};
constexpr std::array<int, 4> samples{1, 2, 4, 8};

/// All of `text`, but for spaces around it, as a side of a picture.
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
    if (state.rendered != nullptr) offered.insert(offered.begin(), {"As shown", state.rendered->size});
    const auto count = static_cast<float>(offered.size());
    const float width = (room - (count - 1) * gap) / count;
    for (const NamedSize& named : offered) {
        if (named.name != offered.front().name) ImGui::SameLine(0, gap);
        if (chosen_button(named.name, options.size == named.size, width)) options.size = named.size;
        list_control(named.name, "", last_item());
    }
    const Help help{"Size of the picture, in pixels; 800x600 sets both", ""};
    (void)take_refused_text();  // of another field
    (void)integer_field("Width", options.size.width, Count{1, max_picture_side}, 1920, help);
    (void)integer_field("Height", options.size.height, Count{1, max_picture_side}, 1080, help);
    if (const std::optional<PictureSize> both = size_in(take_refused_text())) {
        options.size = *both;
        (void)take_said();
    }
}

/// The open document with the scene that the picture shows, as it shows it.
SceneDocument shown_document(const UiState& state) {
    SceneDocument document = state.editor.document;
    document.scene = as_made(state, shown_scene(state));
    return document;
}

/// Draws the shown scene aside into a picture file for `path`, whose bytes `deliver` puts where they go.
void begin_picture(UiState& state, const ExportOptions& options, const std::string& path,
                   const std::function<Result<std::string>(const std::string& bytes)>& deliver) {
    const int threads = state.renderer->stats().threads;
    state.exporting.job = std::make_unique<Job<std::string>>(
        fs::path(path).filename().string(),
        [document = shown_document(state), options, path, threads,
         deliver](LoadProgress& progress) -> Result<std::string> {
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

Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                 const std::string& path, int threads) {
    const Result<PictureFormat> known = picture_format(path);
    if (const Problem* problem = problem_of(known)) return *problem;
    const auto format = std::get<PictureFormat>(known);
    const MemoryShare share(memory_need(MemoryUse::Output, file_memory(format, options.size)));
    Renderer renderer(threads);
    const PictureSize size{options.size.width, options.size.height, true};
    const Picture& picture = renderer.render(document.scene, size, is_linear(format), options.samples);
    return picture_bytes(picture, format, document.scene.display.exposure,
                         carried_scene_text(document.scene, document.mesh_dir, path));
}

void begin_export(UiState& state, const ExportOptions& options, const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    state.exporting.last = {options, name, state.editor.document.path};
    std::error_code failed;  // a folder that is gone is told of when it is written to
    const std::string folder = fs::absolute(path, failed).lexically_normal().parent_path().string();
    begin_picture(state, options, path,
                  [path, name, folder, options](const std::string& bytes) -> Result<std::string> {
                      const auto written = write_file_at_once(path, bytes);
                      if (const Problem* problem = problem_of(written)) return *problem;
                      return fmt::format("Saved {} in {} ({} × {}, {} {} a pixel)", name, folder,
                                         options.size.width, options.size.height, options.samples,
                                         options.samples == 1 ? "sample" : "samples");
                  });
}

/// What is copied, in words: not what is composed in the place of the scene's picture.
static const char* copied_words(const UiState& state) {
    return is_composed(state.views) ? "the scene's own picture" : "this picture";
}

void begin_copy(UiState& state) {
    const PictureSize size = state.rendered->size;
    const std::string what = copied_words(state);
    begin_picture(state, {size, 1}, "clipboard.png",
                  [size, what](const std::string& bytes) -> Result<std::string> {
                      const auto copied = copy_png(bytes);
                      if (const Problem* problem = problem_of(copied)) return *problem;
                      return fmt::format("On the clipboard is {} ({} × {})", what, size.width, size.height);
                  });
}

void copy_render_command(UiState& state, const ExportOptions& options, const std::string& out) {
    const std::string name = fs::path(out).filename().string();
    const std::string command = shortest_command(state, [&](const SceneDocument& of, const Scene& in_file) {
        return render_command_text(of, in_file, options.size, options.samples, name);
    });
    ImGui::SetClipboardText(command.c_str());
    state.notifications.add(
        Tone::Done, fmt::format("The command that draws {} is on the clipboard: {} × {}, {} {} a pixel, {}",
                                copied_words(state), options.size.width, options.size.height, options.samples,
                                options.samples == 1 ? "sample" : "samples", name));
}

void copy_last_command(UiState& state) {
    const std::optional<LastExport>& last = state.exporting.last;
    if (last && last->document == state.editor.document.path)
        return copy_render_command(state, last->options, last->file);
    copy_render_command(state, {state.rendered->size, 1}, offered_name(state, ".png"));
}

void poll_export(UiState& state) { poll_job(state.exporting.job, state.notifications); }

void poll_job(std::unique_ptr<Job<std::string>>& job, Notifications& notifications) {
    if (!job) return;
    if (!job->done()) return redraw_within(seconds_a_look);
    const Result<std::string> result = job->take();
    job.reset();
    if (const Problem* problem = problem_of(result)) return notifications.add(*problem);
    notifications.add(Tone::Done, std::get<std::string>(result));
}

void export_dialog(UiState& state) {
    ExportState& exporting = state.exporting;
    static constexpr const char* id = "Export the picture##export";
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(px(470), window.x), 0});
    if (!begin_modal(id, &exporting.open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
    size_rows(state, exporting.options);
    std::vector<Choice> options;
    constexpr const char* names[] = {"1", "2", "4", "8"};
    for (const char* name : names) options.push_back({name, name, "Samples a pixel"});
    const auto at = std::find(samples.begin(), samples.end(), exporting.options.samples) - samples.begin();
    label_cell("Samples");
    const int chosen = segments("##samples", static_cast<int>(at), options,
                                {"More make the edges smooth; inside a face nothing changes", ""});
    exporting.options.samples = samples[static_cast<std::size_t>(chosen)];
    ImGui::Dummy({0, px(4)});
    dim_text(".png carries its scene; .pfm and .exr hold linear float numbers");
    ImGui::Dummy({0, px(4)});
    ImGui::BeginDisabled(state.rendered == nullptr || exporting.job);
    if (ImGui::Button("Save here and copy its command", {-1, 0})) {
        exporting.open = false;
        save_with_command(state, exporting.options);
    }
    ImGui::EndDisabled();
    tooltip(
        "Save here and copy its command",
        "Into a new file of the working directory; the command line that writes it goes onto the clipboard");
    if (ImGui::Button("Choose a name…", {px(150), 0})) {
        exporting.open = false;
        state.files.ask(FilePurpose::ExportPicture, offered_name(state, ".png"));
    }
    ImGui::SameLine();
    const CommandId copy = CommandId::CopyCommand;
    ImGui::BeginDisabled(!can_run(state, command(copy)));
    if (ImGui::Button("Copy as command", {px(140), 0}))
        copy_render_command(state, exporting.options, offered_name(state, ".png"));
    ImGui::EndDisabled();
    tooltip("Copy as command", "The command line that writes this picture", "", keys_of(copy));
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(90), 0})) exporting.open = false;
    if (!exporting.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace glint
