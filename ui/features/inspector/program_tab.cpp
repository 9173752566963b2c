// The tab "Program": the scene as live calls to fixed-function OpenGL.

#include <fmt/core.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
#include "ui/fields/panels.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

// The calls of an object's transforms can be dragged past each other. Their numbers do not change, so the
// object moves to where the new order puts it; the scene stores the result in the file's fixed order.

/// An object's transform as written in the tab.
struct WrittenTransform {
    TransformOrder order = file_order;
    Transform numbers;
    bool operator==(const WrittenTransform&) const = default;
};

/// A scene's calls as written in the tab.
struct WrittenCalls {
    Scene scene;  // the scene with the transforms' numbers as written
    std::vector<WrittenTransform> transforms;
    std::vector<GlCallGroup> groups;
};

/// An object's transform as last edited in the tab, and the result in the scene.
struct KeptTransform {
    WrittenTransform written;
    Transform result;
    bool operator==(const KeptTransform&) const = default;
};

struct ProgramState {
    Kept<Scene, WrittenCalls> calls;     // with thousands of objects, computing them takes up to a second
    Kept<Scene, std::string> program;    // whole_program_words()
    BlocksInSight groups{1}, places{1};  // the groups of calls; the calls for light positions
    std::map<int, KeptTransform> transforms;  // by the object's index
};

/// Returns how the object with that index is written: as last edited, or in the file's order if something
/// else has changed `transform` since.
WrittenTransform written_transform(const ProgramState& program, int object, const Transform& transform) {
    const auto kept = program.transforms.find(object);
    if (kept == program.transforms.end() || kept->second.result != transform) return {file_order, transform};
    return kept->second.written;
}

/// The kind of transform that a call applies; nullopt for other calls.
std::optional<TransformStep> step_of(const GlCall& call) {
    const std::string_view name = call.pieces.front().text;
    if (name.starts_with("glTranslatef(")) return TransformStep::Translate;
    if (name.starts_with("glRotatef(")) return TransformStep::Rotate;
    if (name.starts_with("glScalef(")) return TransformStep::Scale;
    return std::nullopt;
}

bool is_before(const TransformOrder& order, TransformStep a, TransformStep b) {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

/// Puts the calls of the three transforms, which must be consecutive, into that order.
void put_in_order(std::vector<GlCall>& calls, const TransformOrder& order) {
    const auto is_step = [](const GlCall& call) { return step_of(call).has_value(); };
    const auto first = std::find_if(calls.begin(), calls.end(), is_step);
    std::stable_sort(first, std::find_if_not(first, calls.end(), is_step),
                     [&order](const GlCall& a, const GlCall& b) {
                         return *step_of(a) != *step_of(b) && is_before(order, *step_of(a), *step_of(b));
                     });
}

/// Returns the order while the step's lines are dragged to height `mouse_y`. They pass a neighbour as soon
/// as they would be under the mouse after the swap. `areas`: the area of each step's lines, in written order.
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

/// Explains, below the calls, the effect of an order other than the file's; draws nothing in the file's
/// order.
void order_note(const WrittenTransform& written, const Transform& transform) {
    if (written.order == file_order) return;
    std::string note = "The order has been changed.";
    if (is_before(written.order, TransformStep::Rotate, TransformStep::Translate))
        note +=
            " Because it is moved before it is turned, the object turns about the world's origin, not its "
            "own.";
    if (is_before(written.order, TransformStep::Scale, TransformStep::Translate))
        note += " Because it is moved before it is scaled, the object is moved by a scaled distance.";
    const glm::vec3& t = transform.translate;
    wrapped_dim(fmt::format("{} In the scene file, where translate comes first: [{}, {}, {}].", note,
                            number_text(t.x), number_text(t.y), number_text(t.z)));
}

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

/// The number of decimals in the written number.
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
              "Its numbers stay the same but mean a different position",
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
            line.handle(number, theme().text);
            line.code(std::string(punctuation), theme().dim_text);
        });
    }
    const Rect area{low, {right, last_item().high.y}};
    if (call.is_look_at) state.get<InspectorState>().look_at_y = low.y;
    if (!ImGui::IsAnyMouseDown() && is_pointed_at(area)) light_up(state, call.about);
    return area;
}

/// Draws the calls of an object as written, and applies edits and drags. `written_scene`: the scene of these
/// calls, with the transforms' numbers as written.
void draw_object(UiState& state, Scene& written_scene, int index, WrittenTransform written,
                 const std::vector<GlCall>& calls) {
    Object& object = state.editor.scene().objects[static_cast<std::size_t>(index)];
    Object& edited = written_scene.objects[static_cast<std::size_t>(index)];
    const WrittenTransform before = written;
    std::array<Rect, 3> areas{};
    std::optional<TransformStep> last, held;
    std::size_t block = 0;  // index, in the order of the lines
    for (const GlCall& call : calls) {
        const auto step = step_of(call);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (step && step != last) {
            const char* name = call.pieces.front().text.c_str();
            const std::string word(name, std::string_view(name).find('('));
            if (grip(fmt::format("grip of {} {}", word, index), "Drag past another transform",
                     "The last one written is applied first", "Its numbers stay the same; the object moves",
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
            "glScalef is not uniform: before glRotatef, it would shear the object, which a scene file "
            "cannot express.");
        written.order = before.order;
        transform = in_file_order(written.numbers, written.order);
    }
    object.material = edited.material;
    if (transform && written != before) {
        object.transform = *transform;
        state.get<ProgramState>().transforms[index] = {written, *transform};
    }
    order_note(written, object.transform);
}

/// Names each light whose coordinate space has changed since the scene was opened or saved while its numbers
/// have not. This is the mistake "light in wrong space".
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
        tooltip(label.c_str(), std::string(row->what).c_str(), "Click to show it in the list");
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

WrittenCalls written_calls(const ProgramState& program, const Scene& scene) {
    WrittenCalls calls{scene, {}, {}};
    for (Object& object : calls.scene.objects) {
        calls.transforms.push_back(
            written_transform(program, static_cast<int>(calls.transforms.size()), object.transform));
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
/// is scrolled out of view, because a light's position can be dragged past it.
void draw_places(UiState& state, const std::vector<GlCall>& calls, const PictureView& view) {
    state.get<ProgramState>().places.draw(
        static_cast<int>(calls.size()),
        [&](int i) { (void)draw_call(state, state.editor.scene(), calls[static_cast<std::size_t>(i)]); },
        index_of(calls, [](const GlCall& call) { return call.is_look_at; }));
    note_fitted(state.editor.scene().camera, view.map.size);
    wrong_space_notes(state);
}

void draw_group(UiState& state, Scene& written_scene, const WrittenCalls& calls, const GlCallGroup& group,
                const PictureView& view) {
    if (!fold(whole_label(group.title).c_str(), is_open_at_first(state, group))) return;
    if (const std::optional<ListItem> object = item_in(group.about, "/objects/"))
        draw_object(state, written_scene, object->place,
                    calls.transforms[static_cast<std::size_t>(object->place)], group.calls);
    else if (group.about.empty())
        draw_places(state, group.calls, view);
    else
        for (const GlCall& call : group.calls) (void)draw_call(state, state.editor.scene(), call);
}

}  // namespace

std::string whole_program_words(const Scene& scene) {
    const std::vector<Language> able = languages_for({scene, {}, ""});
    if (able.empty()) return "glint code cannot write this scene as a program";
    return fmt::format("A complete program: glint code FILE --language {} -o FOLDER", name_of(able.front()));
}

void program_tab(UiState& state, const PictureView& view) {
    ProgramState& program = state.get<ProgramState>();
    const Scene& scene = state.editor.scene();
    const Camera camera = scene.camera;
    const auto transforms = program.transforms;
    const WrittenCalls& calls = program.calls.of(scene, [&] { return written_calls(program, scene); });
    Scene written_scene = calls.scene;
    copy_button(state, calls.groups);
    const auto draw = [&](int i) {
        const GlCallGroup& group = calls.groups[static_cast<std::size_t>(i)];
        ImGui::PushID(i);
        draw_group(state, written_scene, calls, group, view);
        ImGui::PopID();
    };
    program.groups.draw(static_cast<int>(calls.groups.size()), draw,
                        index_of(calls.groups, [](const GlCallGroup& group) { return group.about.empty(); }));
    state.editor.edits_camera |= scene.camera != camera;
    if (program.transforms != transforms) program.calls.forget();
}

}  // namespace glint
