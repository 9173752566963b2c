// The tab "Program": the scene as calls of fixed-function OpenGL, live.

#include <fmt/core.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "models/numbers.h"
#include "models/scene/mistakes.h"
#include "models/scene_file/scene_file.h"
#include "programs/gl_calls.h"
#include "programs/program.h"
#include "renderer/explain/equation_text.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/export/clipboard.h"
#include "ui/features/inspector/equation/text_line.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/mistake_row.h"
#include "ui/features/inspector/program/program_state.h"
#include "ui/fields/panels.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Highlights in the picture what a call sets: a light shines alone, an object glows.
void light_up(UiState& state, const std::string& about) {
    constexpr glm::vec3 glow{0.3f, 0.22f, 0};
    Scene scene = state.editor.scene();
    if (const auto light = item_in(about, "/lights/"))
        return show_instead(state, with_light_alone(scene, light->place),
                            scene.lights[static_cast<std::size_t>(light->place)].name + " alone");
    if (about == "/global_ambient")
        return show_instead(state, with_term_alone(scene, Symbol::Ambient), "Ambient light alone");
    const auto item = item_in(about, "/objects/");
    if (!item) return;
    Object& object = scene.objects[static_cast<std::size_t>(item->place)];
    object.material.emission += glow;
    scene.shading.terms.emission = true;
    show_instead(state, scene, object.name);
}

/// The number of decimals with which the number is written.
int decimals_of(const std::string& text) {
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

float grip_width() { return 0.8f * TextLine::height(); }

/// A grip that drags a line past other lines. True while dragged.
bool grip(const std::string& name, const char* drag, const std::string& what, const char* effect,
          const std::string& pointer) {
    const float edge = TextLine::height();
    (void)hit_area(name.c_str(), {grip_width(), edge});
    const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    const auto [low, high] = last_item();
    if (held || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const ImU32 ink = to_u32(held || hovered ? theme().text : theme().dim_text);
    for (const float y : {0.32f, 0.5f, 0.68f})
        ImGui::GetWindowDrawList()->AddLine({low.x + 0.15f * edge, low.y + y * edge},
                                            {high.x - 0.2f * edge, low.y + y * edge}, ink, px(1.2f));
    tooltip(drag, what.c_str(), effect, pointer);
    list_control(name.c_str(), "", {low, high});
    ImGui::SameLine(0, 0);
    return held;
}

/// The grip of a light's position, which can be dragged past gluLookAt().
void light_grip(UiState& state, int light_index) {
    Light& light = state.editor.scene().lights[static_cast<std::size_t>(light_index)];
    const char* what = light.space == LightSpace::Camera
                           ? "Before gluLookAt: its numbers are camera coordinates"
                           : "After gluLookAt: its numbers are world coordinates";
    if (!grip(fmt::format("grip of light {}", light_index), "Drag past gluLookAt", what,
              "Its numbers stay, and mean a different position",
              fmt::format("/lights/{}/space", light_index)))
        return;
    const float y = ImGui::GetIO().MousePos.y, line = state.get<InspectorState>().look_at_y;
    if (light.space == LightSpace::Camera && y > line + TextLine::height()) light.space = LightSpace::World;
    if (light.space == LightSpace::World && y < line) light.space = LightSpace::Camera;
}

/// The text up to and including the first space.
std::string_view first_word(std::string_view text) {
    const std::size_t space = text.find(' ');
    return space == text.npos ? text : text.substr(0, space + 1);
}

/// Draws the text word by word, so that a line can wrap between any two words.
void words(TextLine& line, std::string_view text, const ImVec4& colour) {
    while (!text.empty()) {
        const std::string_view word = first_word(text);
        line.code(std::string(word), colour);
        text.remove_prefix(word.size());
    }
}

/// Draws a call whose numbers edit `scene`. Returns its area, over the column's full width.
Rect draw_call(UiState& state, Scene& scene, const GlCall& call) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float right = low.x + ImGui::GetContentRegionAvail().x;
    if (call.place_of_light >= 0 && call.pieces.front().text.find("GL_POSITION") != std::string::npos)
        light_grip(state, call.place_of_light);
    TextLine line(22);
    line.copied_as(call_text(call));
    std::string_view punctuation;  // after the previous number, on its line: ", " or "));"
    for (std::size_t i = 0; i < call.pieces.size(); ++i) {
        const CallPiece& piece = call.pieces[i];
        NumberHandle number;
        if (!piece.pointer.empty()) number = number_handle({scene, &scene}, piece.pointer);
        // The w of a position is plain text: the position is divided by w at once, so a typed w would become
        // 1 again.
        if (piece.pointer.empty() || number.number.is_w) {
            words(line, std::string_view(piece.text).substr(punctuation.size()),
                  call.is_remark ? theme().warning : theme().dim_text);
            punctuation = {};
            continue;
        }
        if (i + 1 < call.pieces.size()) punctuation = first_word(call.pieces[i + 1].text);
        number.number.kind.format = decimal_format(number.number.value, std::max(decimals_of(piece.text), 1));
        line.together([&] {
            const bool edited = line.handle(number, theme().text);
            state.editor.edits_camera |= edited && piece.pointer.starts_with("/camera");
            line.code(std::string(punctuation), theme().dim_text);
        });
    }
    const Rect area{low, {right, last_item().high.y}};
    if (call.is_look_at) state.get<InspectorState>().look_at_y = low.y;
    if (!ImGui::IsAnyMouseDown() && is_pointed_at(area)) light_up(state, call.about);
    return area;
}

/// Draws the calls of an object as written, and applies drags. `written_scene`: the scene of these calls,
/// with the transforms' numbers as written. True if `written` has changed.
bool draw_object(UiState& state, Scene& written_scene, int index, WrittenTransform& written,
                 const std::vector<GlCall>& calls) {
    Object& object = state.editor.scene().objects[static_cast<std::size_t>(index)];
    Object& edited = written_scene.objects[static_cast<std::size_t>(index)];
    const WrittenTransform before = written;
    std::array<Rect, 3> areas{};
    std::optional<TransformStep> last, held;
    std::size_t block = 0;  // in the order of the lines
    for (const GlCall& call : calls) {
        const auto step = step_of(call);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (step && step != last) {
            const char* name = call.pieces.front().text.c_str();
            const std::string word(name, std::string_view(name).find('('));
            if (grip(fmt::format("grip of {} {}", word, index), "Drag past another transform",
                     "The last one written is applied first", "Its numbers stay, and the object moves",
                     fmt::format("/objects/{}/transform", index)))
                held = step;
            areas[block++].low = low;
        } else if (step) {
            ImGui::Dummy({grip_width(), TextLine::height()});
            ImGui::SameLine(0, 0);
        }
        last = step;
        const Rect area = draw_call(state, written_scene, call);
        if (step) areas[block - 1].high = area.high;
    }
    written.numbers = edited.transform;
    if (held) written.order = dragged_order(written.order, *held, ImGui::GetIO().MousePos.y, areas);
    std::optional<Transform> transform = in_file_order(written.numbers, written.order);
    if (!transform) {
        wrapped_dim(
            "glScalef is not uniform: written before glRotatef it would shear the object, which a scene file "
            "cannot express.");
        written.order = before.order;
        transform = in_file_order(written.numbers, written.order);
    }
    object.material = edited.material;
    const bool changed = transform && written != before;
    if (changed) object.transform = *transform;
    order_note(written, object.transform);
    return changed;
}

/// Names each light whose coordinate space has changed since the scene was opened or saved while its numbers
/// have not: the same as the mistake "light in wrong space".
void wrong_space_notes(UiState& state) {
    const Scene& now = state.editor.scene();
    const Scene& saved = state.editor.saved;
    for (std::size_t i = 0; i < std::min(now.lights.size(), saved.lights.size()); ++i) {
        const Light &light = now.lights[i], &before = saved.lights[i];
        if (light.space == before.space || light.position != before.position) continue;
        const bool camera = light.space == LightSpace::Camera;
        wrapped_dim(
            fmt::format("The numbers of {} were given in {} coordinates and are now read as {} coordinates.",
                        light.name, camera ? "world" : "camera", camera ? "camera" : "world"));
        const auto names = mistake_names();
        const auto row = std::find_if(names.begin(), names.end(),
                                      [](const MistakeName& m) { return m.name == "light_in_wrong_space"; });
        const std::string label = "Mistake: " + title_of(*row);
        if (small_button(label.c_str())) show_mistake(state, &*row);
        tooltip(label.c_str(), std::string(row->what).c_str(), "Click to show it in its list");
    }
}

bool is_open_at_first(const UiState& state, const GlCallGroup& group) {
    return group.about.empty() || selection_in(group.about) == state.editor.selection;
}

void copy_button(UiState& state, const std::vector<GlCallGroup>& groups) {
    if (small_button("Copy")) {
        ImGui::SetClipboardText(calls_text(groups).c_str());
        state.notifications.tell("The calls are on the clipboard");
    }
    const Scene& scene = state.editor.scene();
    std::string program;
    if (ImGui::IsItemHovered())
        program = state.get<ProgramState>().program.of(scene, [&] { return whole_program_words(scene); });
    tooltip("Copy all calls", "As a function in C or C++", program);
}

WrittenCalls written_calls(const Scene& scene) {
    WrittenCalls calls{scene, {}, {}};
    for (Object& object : calls.scene.objects) {
        calls.transforms.push_back(
            written_transform(static_cast<int>(calls.transforms.size()), object.transform));
        object.transform = calls.transforms.back().numbers;
    }
    calls.groups = gl_calls(calls.scene);
    for (GlCallGroup& group : calls.groups)
        if (const auto object = item_in(group.about, "/objects/"))
            put_in_order(group.calls, calls.transforms[static_cast<std::size_t>(object->place)].order);
    return calls;
}

/// Returns the index of the first element that satisfies `is`, or the number of elements if none does.
template <class T, class Is> int index_of(const std::vector<T>& all, Is is) {
    return static_cast<int>(std::find_if(all.begin(), all.end(), is) - all.begin());
}

/// The camera's calls, and the lights' positions before and after gluLookAt(). That call is drawn even if it
/// is scrolled away, because a light's position can be dragged past it.
void draw_places(UiState& state, const std::vector<GlCall>& calls, const PictureView& view) {
    state.get<ProgramState>().places.draw(
        static_cast<int>(calls.size()),
        [&](int i) { (void)draw_call(state, state.editor.scene(), calls[static_cast<std::size_t>(i)]); },
        index_of(calls, [](const GlCall& call) { return call.is_look_at; }));
    note_fitted(state.editor.scene().camera, view.map.size);
    wrong_space_notes(state);
}

/// Draws a group. Returns the transform of its object as it is now written, if that has changed.
std::optional<WrittenTransform> draw_group(UiState& state, Scene& written_scene, const WrittenCalls& calls,
                                           const GlCallGroup& group, const PictureView& view) {
    if (!fold(whole_label(group.title).c_str(), is_open_at_first(state, group))) return {};
    const std::optional<ListItem> object = item_in(group.about, "/objects/");
    if (object) {
        WrittenTransform written = calls.transforms[static_cast<std::size_t>(object->place)];
        const bool changed = draw_object(state, written_scene, object->place, written, group.calls);
        return changed ? std::optional(written) : std::nullopt;
    }
    if (group.about.empty())
        draw_places(state, group.calls, view);
    else
        for (const GlCall& call : group.calls) (void)draw_call(state, state.editor.scene(), call);
    return {};
}

}  // namespace

std::string whole_program_words(const Scene& scene) {
    const std::vector<Language> able = languages_for({scene, {}, ""});
    if (able.empty()) return "glint code cannot write this scene as a program";
    return fmt::format("A whole program: glint code FILE --language {} -o FOLDER", name_of(able.front()));
}

void program_tab(UiState& state, const PictureView& view) {
    ProgramState& program = state.get<ProgramState>();
    const WrittenCalls& calls =
        program.calls.of(state.editor.scene(), [&] { return written_calls(state.editor.scene()); });
    Scene written_scene = calls.scene;
    copy_button(state, calls.groups);
    bool any_changed = false;
    const auto draw = [&](int i) {
        const GlCallGroup& group = calls.groups[static_cast<std::size_t>(i)];
        ImGui::PushID(i);
        const auto changed = draw_group(state, written_scene, calls, group, view);
        ImGui::PopID();
        if (!changed) return;
        const int object = item_in(group.about, "/objects/")->place;
        keep_written(object, *changed,
                     state.editor.scene().objects[static_cast<std::size_t>(object)].transform);
        any_changed = true;
    };
    program.groups.draw(static_cast<int>(calls.groups.size()), draw,
                        index_of(calls.groups, [](const GlCallGroup& group) { return group.about.empty(); }));
    if (any_changed) program.calls.forget();
}

namespace {

ImGuiID key_of(int object, int number) {
    return ImGui::GetID(fmt::format("transform of {}, {}", object, number).c_str());
}

/// The numbers that determine how an object is written, in a fixed order: its translation, and the resulting
/// transform.
std::array<float, 12> numbers_of(const glm::vec3& translate, const Transform& t) {
    return {translate.x,    translate.y,    translate.z,    t.translate.x, t.translate.y, t.translate.z,
            t.rotate_deg.x, t.rotate_deg.y, t.rotate_deg.z, t.scale.x,     t.scale.y,     t.scale.z};
}

int code_of(const TransformOrder& order) {
    return 100 * static_cast<int>(order[0]) + 10 * static_cast<int>(order[1]) + static_cast<int>(order[2]);
}
TransformOrder order_of(int code) {
    const auto step = [](int digit) { return static_cast<TransformStep>(digit % 10); };
    return {step(code / 100), step(code / 10), step(code)};
}

bool is_before(const TransformOrder& order, TransformStep a, TransformStep b) {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

}  // namespace

WrittenTransform written_transform(int object, const Transform& transform) {
    WrittenTransform written{file_order, transform};
    const ImGuiStorage& kept = *ImGui::GetStateStorage();
    std::array<float, 12> numbers{};
    for (int i = 0; i < 12; ++i) numbers[static_cast<std::size_t>(i)] = kept.GetFloat(key_of(object, i));
    const glm::vec3 translate(numbers[0], numbers[1], numbers[2]);
    if (numbers != numbers_of(translate, transform)) return written;  // changed elsewhere in the meantime
    written.order = order_of(kept.GetInt(key_of(object, -1), code_of(file_order)));
    written.numbers.translate = translate;
    return written;
}

void keep_written(int object, const WrittenTransform& written, const Transform& transform) {
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    kept.SetInt(key_of(object, -1), code_of(written.order));
    const std::array<float, 12> numbers = numbers_of(written.numbers.translate, transform);
    for (int i = 0; i < 12; ++i) kept.SetFloat(key_of(object, i), numbers[static_cast<std::size_t>(i)]);
}

std::optional<TransformStep> step_of(const GlCall& call) {
    const std::string_view name = call.pieces.front().text;
    if (name.starts_with("glTranslatef(")) return TransformStep::Translate;
    if (name.starts_with("glRotatef(")) return TransformStep::Rotate;
    if (name.starts_with("glScalef(")) return TransformStep::Scale;
    return std::nullopt;
}

void put_in_order(std::vector<GlCall>& calls, const TransformOrder& order) {
    const auto is_step = [](const GlCall& call) { return step_of(call).has_value(); };
    const auto first = std::find_if(calls.begin(), calls.end(), is_step);
    std::stable_sort(first, std::find_if_not(first, calls.end(), is_step),
                     [&order](const GlCall& a, const GlCall& b) {
                         return *step_of(a) != *step_of(b) && is_before(order, *step_of(a), *step_of(b));
                     });
}

TransformOrder dragged_order(const TransformOrder& order, TransformStep held, float mouse_y,
                             std::span<const Rect, 3> areas) {
    const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), held) - order.begin());
    const float height = areas[at].size().y;
    TransformOrder changed = order;
    if (at > 0 && mouse_y < std::min(areas[at - 1].low.y + height, areas[at - 1].high.y))
        std::swap(changed[at - 1], changed[at]);
    else if (at < 2 && mouse_y > std::max(areas[at + 1].high.y - height, areas[at + 1].low.y))
        std::swap(changed[at + 1], changed[at]);
    return changed;
}

void order_note(const WrittenTransform& written, const Transform& transform) {
    if (written.order == file_order) return;
    std::string note = "The order is swapped.";
    if (is_before(written.order, TransformStep::Rotate, TransformStep::Translate))
        note += " Moved before it is turned, the object turns about the world's origin, not about its own.";
    if (is_before(written.order, TransformStep::Scale, TransformStep::Translate))
        note += " Moved before it is scaled, the object has its translation scaled as well.";
    const glm::vec3& t = transform.translate;
    wrapped_dim(fmt::format("{} In the scene file, where translate comes first: [{}, {}, {}].", note,
                            number_text(t.x), number_text(t.y), number_text(t.z)));
}

}  // namespace glint
