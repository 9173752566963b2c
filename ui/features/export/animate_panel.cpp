#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "models/fields/scene_fields.h"
#include "models/problem.h"
#include "ui/commands/command.h"
#include "ui/features/export/animation.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/export/export_picture.h"
#include "ui/fields/field_panel.h"
#include "ui/shell/layout.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int max_frames = 2000;
constexpr int numbers_listed = 7;

/// The JSON pointers to the numbers that have an effect and match the search, best match first.
std::vector<std::string> matching(const Scene& scene, const std::string& text) {
    const std::vector<SceneNumber> numbers = numbers_of(scene);
    std::vector<std::pair<int, std::size_t>> ranked;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!numbers[i].applies) continue;
        if (const auto rank = match_rank(text, number_words(scene, numbers[i])))
            ranked.emplace_back(*rank, i);
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<std::string> found;
    for (const auto& [rank, i] : ranked) {
        found.push_back(numbers[i].pointer);
        if (found.size() == numbers_listed) break;
    }
    return found;
}

/// The initial far end of the interval: twice the number, or half of it if that would be out of range.
double other_end(const SceneNumber& number) {
    const double twice = number.value == 0 ? 1 : 2 * number.value;
    const double far = number.kind.range.contains(twice) ? twice : number.value / 2;
    return number.count ? number.count->nearest(far) : far;
}

/// The result of matching(), cached: with thousands of objects it takes longer than a frame.
const std::vector<std::string>& found_numbers(AnimateState& animate, const Scene& scene) {
    if (animate.searched != animate.search) animate.found.forget();
    animate.searched = animate.search;
    const auto find = [&] { return matching(scene, animate.search); };
    if (animate.found.value() == nullptr) return animate.found.of(scene, find);
    update_at_rest(animate.found, scene, find);
    return *animate.found.value();
}

/// Draws a row of the list of numbers. The number is chosen by a click, or by Enter (`entered`).
void offer_number(AnimateState& animate, const Scene& scene, const SceneNumber& number, bool entered) {
    Animation& animation = animate.animation;
    const std::string words = number_words(scene, number);
    const std::string label =
        fmt::format("{}  =  {:.5g}##{}", whole_label(words), number.value, number.pointer);
    const bool clicked = ImGui::Selectable(label.c_str(), number.pointer == animation.pointer);
    tooltip(whole_label(words).c_str(), number.help, "", number.pointer);
    if (!clicked && !entered) return;
    animation.pointer = number.pointer;
    animate.number = words;
    animation.from = number.value;
    animation.to = other_end(number);
    animate.began = ImGui::GetTime();
}

void choose_number(AnimateState& animate, const Scene& scene) {
    Animation& animation = animate.animation;
    ImGui::SetNextItemWidth(label_cell("Number"));
    if (std::exchange(animate.takes_keys, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = text_field("##search", "part of a name, e.g. roughness", animate.search,
                                    ImGuiInputTextFlags_EnterReturnsTrue);
    tooltip("Number", "The number to animate; Enter chooses the first match");
    const std::vector<std::string>& found = found_numbers(animate, scene);
    if (found.empty() && !animate.search.empty())
        wrapped_dim(fmt::format("No number in the scene matches “{}”", shortened(animate.search)));
    for (const std::string& pointer : found)
        if (const auto number = number_at(scene, pointer))  // it may have been removed during a drag
            offer_number(animate, scene, *number, entered && &pointer == &found.front());
    const std::optional<SceneNumber> number = number_at(scene, animation.pointer);
    if (!number) return;
    ImGui::Separator();
    const Real ends{.range = number->kind.range, .format = "%.4g"};
    float from = static_cast<float>(animation.from), to = static_cast<float>(animation.to);
    const Help help{"One end of the interval", animation.pointer};
    if (number_field("From", from, ends, 0, help)) animation.from = double(from);
    if (number_field("To", to, ends, 0, help)) animation.to = double(to);
}

void choose_circle(Animation& animation, const Scene& scene) {
    if (scene.lights.empty()) return wrapped_dim("The scene has no lights.");
    ImGui::SetNextItemWidth(label_cell("Light"));
    if (light_combo("##light", animation.light, scene.lights)) tooltip("Light", "The light that moves");
    if (segment_field("Axis", animation.axis,
                      {"The axis of the light's circle, through the camera's target", ""}))
        animation.radius = 0;
    const Light& light = scene.lights[static_cast<std::size_t>(animation.light)];
    if (light.position.w == 0)
        return wrapped_dim("A directional light has no radius: only its direction changes.");
    const auto present =
        static_cast<float>(radius_of(light, scene.camera, axis_of(scene.camera, animation.axis)));
    float radius = animation.radius > 0 ? static_cast<float>(animation.radius) : present;
    const Help help{"Distance from the axis, initially that of the light", ""};
    if (number_field("Radius", radius, Real{.range = above_zero, .step = 0.01f}, present, help))
        animation.radius = radius == present ? 0 : double(radius);
}

/// The length of a period in seconds and in frames: changing one changes the other.
void time_fields(AnimateState& animate) {
    Animation& animation = animate.animation;
    const int rate = animate.frames_a_second;
    const auto seconds = static_cast<float>(animation.frames) / static_cast<float>(rate);
    const auto framed = [&](float s) {
        return std::clamp(static_cast<int>(std::lround(s * float(animate.frames_a_second))), 1, max_frames);
    };
    float wanted = seconds;
    const bool turns = animation.motion != Motion::PingPong;
    const Real length{.range = {0.02, 2000, "0.02 to 2000"},
                      .step = 0.02f,
                      .format = "%.2f s",
                      .usual_max = 60,
                      .logarithmic = true};
    if (number_field(turns ? "Per turn" : "Per cycle", wanted, length, 1.92f,
                     {"Length of one period, after which the motion repeats", ""}))
        animation.frames = framed(wanted);
    integer_field("Frames", animation.frames, Count{1, max_frames}, 48,
                  {"Frames in one period, after which the motion repeats", ""});
    if (integer_field("Frames / s", animate.frames_a_second, Count{1, 50}, 25, {"Frames per second", ""}))
        animation.frames = framed(seconds);
}

void write_buttons(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    if (animate.job) {
        const LoadProgress& progress = animate.job->progress();
        const auto done = progress.done.load(), total = progress.total.load();
        ImGui::ProgressBar(total == 0 ? 0 : float(done) / float(total), {-px(90), 0},
                           fmt::format("frame {} of {}", done, total).c_str());
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {px(80), 0})) animate.job->cancel();
        return;
    }
    const bool possible = animate.refused.empty();
    ImGui::BeginDisabled(!possible);
    const char* const play = animate.playing ? "Stop" : "Play";
    if (ImGui::Button(play, {px(90), 0})) switch_playing(state);
    tooltip(play, "The scene stays as it is: only the picture is animated", "", "Enter");
    ImGui::SameLine();
    const std::string missing = animate.file == AnimationFile::Mp4 ? mp4_disabled_reason() : "";
    ImGui::BeginDisabled(!missing.empty());
    const std::string label = missing.empty() ? "Export animation…" : missing;
    if (ImGui::Button((label + "###export").c_str(), {-1, 0})) ask_for_frames(state);
    ImGui::EndDisabled();
    const ExportOptions options = export_options(state);
    tooltip("Export animation", choice_of(animate.file).meaning,
            fmt::format("{} × {}, samples per pixel: {}; set in Export picture", options.size.width,
                        options.size.height, options.samples));
    ImGui::EndDisabled();
}

}  // namespace

void animate_panel(UiState& state) {
    AnimateState& animate = state.get<AnimateState>();
    if (!animate.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, px(top_height + views_height + 44)}, ImGuiCond_Appearing,
                            {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(px(400), window.x - px(20)), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    // While frames are being written, the panel stays open and shows the progress.
    if (ImGui::Begin("Animate", animate.job ? nullptr : &animate.open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        animate.has_keyboard = ImGui::IsWindowFocused();
        const Animation before = animate.animation;
        if (segment_field("Motion", animate.animation.motion, {"What moves", ""}))
            begin_animation(state, animate.animation.motion);
        if (animate.animation.motion == Motion::PingPong) choose_number(animate, state.editor.scene());
        if (animate.animation.motion == Motion::Circle)
            choose_circle(animate.animation, state.editor.scene());
        if (std::exchange(animate.takes_keys, false)) ImGui::SetKeyboardFocusHere();
        time_fields(animate);
        segment_field("File", animate.file, {"What Export animation writes", ""});
        if (!(animate.animation == before)) animate.refused.clear();
        if (!animate.refused.empty()) {
            ImGui::PushTextWrapPos();
            ImGui::TextUnformatted(animate.refused.c_str());
            ImGui::PopTextWrapPos();
        }
        write_buttons(state);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (!animate.open) animate.playing = false;
}

}  // namespace glint
