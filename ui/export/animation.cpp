#include "ui/export/animation.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "models/fields/scene_numbers.h"
#include "models/json/json_pointer.h"
#include "ui/commands/fuzzy.h"
#include "ui/document/document_actions.h"
#include "ui/fields/field_panel.h"
#include "ui/inspector/equation/words.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/text/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int max_frames = 2000;
constexpr int numbers_listed = 7;

/// "Bulb: intensity"
std::string words_for(const Scene& scene, const SceneNumber& number) {
    return fmt::format("{}: {}", owner_of(number.pointer, scene), number.words);
}

/// The pointers of the numbers that have an effect and match what was typed, best first.
std::vector<std::string> matching(const Scene& scene, const std::string& text) {
    const std::vector<SceneNumber> numbers = numbers_of(scene);
    std::vector<std::pair<int, std::size_t>> scored;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!numbers[i].applies) continue;
        if (const auto match = fuzzy_match(text, words_for(scene, numbers[i])))
            scored.emplace_back(-match->score, i);
    }
    std::sort(scored.begin(), scored.end());
    std::vector<std::string> found;
    for (const auto& [score, i] : scored) {
        found.push_back(numbers[i].pointer);
        if (found.size() == numbers_listed) break;
    }
    return found;
}

/// After lights or objects went, were renamed or came with another scene, the pointer may lead to another.
void forget_number_that_is_gone(UiState& state) {
    AnimateState& animate = state.animate;
    if (animate.animation.pointer.empty()) return;
    const Scene& scene = state.editor.scene();
    const std::optional<SceneNumber> number = number_at(scene, animate.animation.pointer);
    const std::string words = number ? words_for(scene, *number) : "";
    if (animate.number.empty()) animate.number = words;
    if (number && words == animate.number) return;
    forget_number(state);
}

/// The other end of an interval to begin with: twice the number, or half of it where that is too much.
double other_end(const SceneNumber& number) {
    const double twice = number.value == 0 ? 1 : 2 * number.value;
    const double far = number.kind.range.contains(twice) ? twice : number.value / 2;
    return number.count ? number.count->nearest(far) : far;
}

/// As matching(): of thousands of objects it takes longer than a frame has.
const std::vector<std::string>& found_numbers(AnimateState& animate, const Scene& scene) {
    if (animate.searched != animate.search) animate.found.forget();
    animate.searched = animate.search;
    const auto find = [&] { return matching(scene, animate.search); };
    if (animate.found.value() == nullptr) return animate.found.of(scene, find);
    update_at_rest(animate.found, scene, find);
    return *animate.found.value();
}

/// A row of the list; it is taken by a click, or when it is `entered`.
void offer_number(AnimateState& animate, const Scene& scene, const SceneNumber& number, bool entered) {
    Animation& animation = animate.animation;
    const std::string words = words_for(scene, number);
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
    const bool entered = text_field("##search", "a part of its name: roughness …", animate.search,
                                    ImGuiInputTextFlags_EnterReturnsTrue, longest_search);
    tooltip("Number", "What goes to and fro; Enter takes the first");
    const std::vector<std::string>& found = found_numbers(animate, scene);
    if (found.empty() && !animate.search.empty())
        wrapped_dim(fmt::format("No number of the scene is called “{}”", animate.search));
    for (const std::string& pointer : found)
        if (const auto number = number_at(scene, pointer))  // while the mouse drags, it may have gone
            offer_number(animate, scene, *number, entered && &pointer == &found.front());
    if (animation.pointer.empty()) return;
    ImGui::Separator();
    const Real ends{.format = "%.4g"};
    float from = static_cast<float>(animation.from), to = static_cast<float>(animation.to);
    const Help help{"One end of the interval", animation.pointer};
    if (number_field("From", from, ends, 0, help)) animation.from = double(from);
    if (number_field("To", to, ends, 0, help)) animation.to = double(to);
}

/// Says so where a number is to move and none is chosen.
bool refuses_no_number(AnimateState& animate) {
    if (animate.animation.motion != Motion::PingPong || !animate.animation.pointer.empty()) return false;
    animate.refused = "No number is chosen: click one of the list";
    return true;
}

void write_buttons(UiState& state) {
    AnimateState& animate = state.animate;
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
    tooltip(play, "The scene stays as it is: only the picture shows what moves");
    ImGui::SameLine();
    if (ImGui::Button("Write frames…", {px(130), 0})) ask_for_frames(state);
    tooltip("Write frames",
            "As PNG files, one a frame, or as one GIF: by the name's ending. A GIF has 256 colours "
            "a frame, so gradients get steps that are not in the picture",
            "At the size and samples of Export picture");
    ImGui::EndDisabled();
}

/// 0 .. frames - 1.
int within_period(const Animation& animation, int frame) {
    const int period = std::max(animation.frames, 1);
    return ((frame % period) + period) % period;
}

Scene turned(Scene scene, double angle) {
    Camera& camera = scene.camera;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(camera.up)), target(camera.target);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), angle, axis);
    camera.eye = glm::vec3(target + glm::dvec3(turn * glm::dvec4(glm::dvec3(camera.eye) - target, 0)));
    return scene;
}

/// The scene with the number at that value; the meshes that this changes are not made yet.
Result<Scene> with_number(Scene scene, const std::string& pointer, double value) {
    const std::optional<SceneNumber> number = number_at(scene, pointer);
    const bool is_count = number && number->count;
    if (const auto problem = set_number(scene, pointer, is_count ? number->count->nearest(value) : value))
        return *problem;
    return scene;
}

/// Whether this frame, or the animation's end that is farther from here, needs a mesh that takes long to
/// make.
bool is_held_up(const SceneDocument& document, const Animation& animation, int frame) {
    const auto of_object = item_in(animation.pointer, "/objects/");
    if (animation.motion != Motion::PingPong || !of_object || !is_within(of_object->rest, "/mesh"))
        return false;
    const auto is_slow_at = [&](double value) {
        const Result<Scene> moved = with_number(document.scene, animation.pointer, value);
        const Scene* scene = std::get_if<Scene>(&moved);
        return scene != nullptr &&
               std::any_of(scene->objects.begin(), scene->objects.end(), awaits_slow_mesh);
    };
    return is_slow_at(animation.to) || is_slow_at(value_at(animation, frame));
}

}  // namespace

void begin_animation(UiState& state, Motion motion) {
    state.animate.open = true;
    state.animate.animation.motion = motion;
    state.animate.takes_keys = motion == Motion::PingPong;
    state.animate.refused.clear();
}

void switch_playing(UiState& state) {
    state.animate.playing = !state.animate.playing;
    state.animate.open |= state.animate.playing;
    state.animate.began = ImGui::GetTime();
}

void ask_for_frames(UiState& state) {
    if (refuses_no_number(state.animate)) {
        state.animate.open = true;  // it says why
        return;
    }
    state.files.ask(FilePurpose::SaveFrames, offered_name(state, ".gif"));
}

void animate_panel(UiState& state) {
    AnimateState& animate = state.animate;
    if (!animate.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, px(top_height + views_height + 44)}, ImGuiCond_Appearing,
                            {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(px(400), window.x - px(20)), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    if (ImGui::Begin("Animate", &animate.open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        const Animation before = animate.animation;
        if (segment_field("Motion", animate.animation.motion, {"What moves", ""}))
            animate.takes_keys = animate.animation.motion == Motion::PingPong;
        if (animate.animation.motion == Motion::PingPong) choose_number(animate, state.editor.scene());
        (void)integer_field("Frames", animate.animation.frames, Count{1, max_frames}, 48,
                            {"Frames of one period; then it begins again", ""});
        (void)integer_field("Speed", animate.frames_a_second, Count{1, 50}, 25, {"Frames a second", ""});
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

void forget_number(UiState& state) {
    AnimateState& animate = state.animate;
    const std::string gone = animate.number.empty() ? animate.animation.pointer : animate.number;
    animate.number.clear();
    animate.animation.pointer.clear();
    animate.refused.clear();
    if (animate.animation.motion != Motion::PingPong) return;
    animate.playing = false;
    state.notifications.tell("Animate: there is no “" + gone + "” any more");
}

void poll_animation(UiState& state) {
    AnimateState& animate = state.animate;
    poll_job(animate.job, state.notifications);
    forget_number_that_is_gone(state);
    animate.frame.reset();
    if (!animate.playing) return;
    const double frame = (ImGui::GetTime() - animate.began) * animate.frames_a_second;
    if (refuses_no_number(animate)) {
        animate.playing = false;
        return;
    }
    const SceneDocument document = document_as_made(state);
    if (is_held_up(document, animate.animation, static_cast<int>(frame))) {
        animate.playing = false;
        return state.notifications.add(
            Tone::Warning,
            "Animate: such meshes take too long to be played; Write frames… makes them beside the window");
    }
    Result<Scene> scene = scene_at(document, animate.animation, static_cast<int>(frame));
    if (const Problem* problem = problem_of(scene)) {
        animate.refused = with_expected(problem->what, problem->expected);
        animate.playing = false;
        if (!animate.open) state.notifications.add(*problem);  // a lesson plays without the panel
        return;
    }
    animate.frame = std::get<Scene>(std::move(scene));
    redraw_within((std::floor(frame) + 1 - frame) / animate.frames_a_second);
}

double value_at(const Animation& animation, int frame) {
    const double share = double(within_period(animation, frame)) / std::max(animation.frames, 1);
    return animation.from + (animation.to - animation.from) * (1 - std::abs(1 - 2 * share));
}

Result<Scene> scene_at(const SceneDocument& document, const Animation& animation, int frame) {
    const int at = within_period(animation, frame);
    if (animation.motion == Motion::Turntable)
        return at == 0 ? document.scene
                       : turned(document.scene, 2 * std::numbers::pi * at / std::max(animation.frames, 1));
    Result<Scene> moved = with_number(document.scene, animation.pointer, value_at(animation, frame));
    if (auto* scene = std::get_if<Scene>(&moved)) {
        const Result<Warnings> warned = load_meshes(*scene, document.path, document.mesh_dir);
        if (const Problem* problem = problem_of(warned)) return *problem;
    }
    return moved;
}

}  // namespace glint
