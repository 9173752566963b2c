#include "ui/features/lecture/lecture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

#include "models/io/file.h"
#include "renderer/renderer.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/lessons/lesson.h"
#include "ui/picture/draw_picture.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

ImU32 grey(int value) { return IM_COL32(value, value, value, 255); }

/// Draws a clickable patch in its cell of the row.
void patch(ImDrawList& list, WedgeRow& row, int index, const Rect& cell) {
    const ImVec2 size = cell.size();
    const int step = wedge_steps[static_cast<std::size_t>(index)];
    const float half = std::min(0.6f * size.x, 0.55f * size.y) / 2;
    const ImVec2 middle{cell.middle().x, cell.low.y + 0.45f * size.y}, corner{half, half};
    list.AddRectFilled(middle - corner, middle + corner, grey(row.ground + row.sign * step));
    ImGui::SetCursorScreenPos(cell.low);
    ImGui::PushID(index);
    if (hit_area("##patch", size)) row.seen = index;
    ImGui::PopID();
    const bool chosen = row.seen == index;
    const ImU32 ink = row.ground < 128 ? grey(150) : grey(row.ground == 255 ? 110 : 20);
    const ImVec2 inset = px(3) * ImVec2(1, 1);
    if (chosen || ImGui::IsItemHovered())
        list.AddRect(cell.low + inset, cell.high - inset, ink, px(4), 0, px(chosen ? 2.0f : 1.0f));
    const std::string label = std::to_string(step);
    const ImVec2 text = ImGui::CalcTextSize(label.c_str());
    list.AddText({middle.x - text.x / 2, cell.high.y - text.y - px(7)}, ink, label.c_str());
}

/// Draws the patches of a row across the full width.
void patches(WedgeRow& row, float height) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + ImVec2(width, height), grey(row.ground));
    const float cell = width / float(wedge_steps.size());
    for (int i = 0; i < static_cast<int>(wedge_steps.size()); ++i) {
        const ImVec2 corner = low + ImVec2(float(i) * cell, 0);
        patch(list, row, i, {corner, corner + ImVec2(cell, height)});
    }
    ImGui::SetCursorScreenPos(low + ImVec2(0, height + px(4)));
}

/// Draws the step wedge, which covers the entire window while it is open.
void step_wedge(WedgeState& wedge) {
    if (!wedge.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(window);
    ImGui::Begin("##wedge", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("Step wedge");
    ImGui::PopFont();
    ImGui::SameLine(window.x - px(100));
    if (ImGui::Button("Close", {px(88), 0})) wedge.open = false;
    wrapped_dim("The number on a patch is its difference from the background, in steps of 1/255");
    const float wrap = ImGui::GetContentRegionAvail().x;
    const auto words_height = [wrap](const WedgeRow& row) {
        return ImGui::CalcTextSize(wedge_words(row).c_str(), nullptr, false, wrap).y;
    };
    float room = ImGui::GetContentRegionAvail().y;
    for (const WedgeRow& row : wedge.rows)
        room -= words_height(row) + ImGui::GetStyle().ItemSpacing.y + px(10);
    for (WedgeRow& row : wedge.rows) {
        ImGui::PushID(row.name);
        patches(row, std::max(room / float(wedge.rows.size()), px(20)));
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(wedge_words(row).c_str());
        ImGui::PopTextWrapPos();
        ImGui::Dummy({0, px(2)});
        ImGui::PopID();
    }
    ImGui::End();
}

}  // namespace

std::string wedge_words(const WedgeRow& row) {
    if (row.seen < 0)
        return fmt::format("On {}: click the first patch that is visible from the last row of the room",
                           row.name);
    if (row.seen == 0) return fmt::format("On {} every step is visible", row.name);
    const auto seen = std::min(static_cast<std::size_t>(row.seen), wedge_steps.size() - 1);
    return fmt::format("On {} this projector loses steps below {}/255: colours {:.3f} apart look the same",
                       row.name, wedge_steps[seen], double(wedge_steps[seen - 1]) / 255);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_order = 1 << 16;  // bytes

/// Sorts the names listed in the folder's lecture_order.txt first, in that order.
void sort_for_lecture(std::vector<std::string>& names, const std::string& folder) {
    std::sort(names.begin(), names.end(), natural_less);
    const Result<std::string> order =
        read_file((fs::path(folder) / "lecture_order.txt").string(), longest_order);
    std::vector<std::string> listed;
    if (const auto* text = std::get_if<std::string>(&order)) {
        std::istringstream lines(*text);
        for (std::string name; std::getline(lines, name);) listed.push_back(name);
    }
    const auto place_of = [&listed](const std::string& name) {
        return std::find(listed.begin(), listed.end(), fs::path(name).stem().string()) - listed.begin();
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return place_of(a) < place_of(b); });
}

/// The scene `step` positions after `path` (before it if `step` is negative) among those on the command line,
/// empty if there is none; nullopt if `path` is not among them.
std::optional<std::string> given_scene_beside(const std::vector<std::string>& given, const std::string& path,
                                              int step) {
    const auto found = std::find(given.begin(), given.end(), path);
    if (found == given.end()) return {};
    const std::ptrdiff_t at = found - given.begin() + step;
    return at >= 0 && at < std::ssize(given) ? given[static_cast<std::size_t>(at)] : "";
}

}  // namespace

std::vector<std::string> folder_scenes(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator it(folder.empty() ? "." : folder, failed);
         !failed && it != fs::directory_iterator(); it.increment(failed)) {
        std::error_code unknown;
        const std::string name = it->path().filename().string();
        if (lower_extension(name) == ".json" && !name.starts_with(".") && it->is_regular_file(unknown))
            names.push_back(name);
    }
    sort_for_lecture(names, folder);
    for (std::string& name : names) name = (fs::path(folder) / name).string();
    return names;
}

std::string scene_beside(const std::string& path, int step) {
    const fs::path file(path);
    std::vector<std::string> scenes = folder_scenes(file.parent_path().string());
    const std::string own = (file.parent_path() / file.filename()).string();
    if (std::find(scenes.begin(), scenes.end(), own) == scenes.end()) {
        const auto is_after = [&own](const std::string& scene) { return natural_less(own, scene); };
        scenes.insert(std::find_if(scenes.begin(), scenes.end(), is_after), own);
    }
    const std::ptrdiff_t at = std::find(scenes.begin(), scenes.end(), own) - scenes.begin() + step;
    return at >= 0 && at < std::ssize(scenes) ? scenes[static_cast<std::size_t>(at)] : "";
}

// The features for a lecture: freezing, paging through scenes, the step wedge, the pen, the clean picture.

namespace {

/// Returns the next scene on the command line, otherwise the next one in the folder. If the open scene has no
/// file, returns one that comes with the program. Skips a scene that could not be opened.
std::string other_scene(const UiState& state, int step) {
    const AskedScene& asked = state.get<LectureState>().asked;
    const std::string& open = state.editor.document.path;
    const bool failed = !asked.path.empty() && state.loading.failed == asked.path;
    const bool goes_on = failed && asked.step == step && asked.from == open;
    const std::string& path = goes_on ? asked.path : open;
    const bool has_file = !path.empty() && path != "-";
    const std::string& place = has_file ? path : state.get<LectureState>().last_given;
    if (const auto given = given_scene_beside(state.get<LectureState>().given_scenes, place, step))
        return *given;
    if (has_file) return scene_beside(path, step);
    const auto scenes = folder_scenes(state.shipped_scenes);
    if (state.shipped_scenes.empty() || scenes.empty()) return {};
    return step > 0 ? scenes.front() : scenes.back();
}

void open_other(UiState& state, int step) {
    if (state.get<LessonState>().course) return page_lesson(state, step);
    const std::string path = other_scene(state, step);
    if (path.empty())
        return state.notifications.tell(step > 0 ? "This is the last scene" : "This is the first scene");
    state.get<LectureState>().asked = {state.editor.document.path, path, step};
    ask_to_open(state, path);
}

void switch_projector(UiState& state) {
    LayoutState& layout = state.layout;
    layout.projector = !layout.projector;
    if (layout.projector) {
        layout.left_before = layout.left;
        layout.right_before = layout.right;
    }
    // The equation stays visible, enlarged, in place of the scene's list; a lesson keeps its own column.
    layout.left = !layout.projector && layout.left_before;
    layout.right = layout.projector || layout.right_before;
    if (!layout.lesson) state.left_shows_inspector |= layout.projector;
}

void switch_frozen(UiState& state) {
    if (state.get<LectureState>().frozen)
        state.get<LectureState>().frozen.reset();
    else
        freeze(state);
}

std::optional<OtherScene> show_frozen(const UiState& state) {
    const LectureState& lecture = state.get<LectureState>();
    if (!lecture.frozen) return {};
    const std::string key = keys_of(CommandId::Freeze);
    return OtherScene{
        .scene = *lecture.frozen,
        .name = "the frozen picture",
        .label = "Frozen",
        .note = "Frozen picture",
        .key = CommandId::Freeze,
        .end = [](UiState& s) { s.get<LectureState>().frozen.reset(); },
        .selection = lecture.frozen_selection,
        .refusal = "The picture is frozen: " + key + " unfreezes it",
        .hint = "Frozen · " + key + ": unfreeze",
        .press = [](UiState& s) { s.notifications.tell(s.on_screen.refusal(), Tone::Warning); }};
}

std::vector<WindowCommand> lecture_commands() {
    return {
        {.name = "Next scene in the folder",
         .keys = {{Key::PageDown}},
         .section = Section::LecturePages,
         .run = [](UiState& s) { open_other(s, 1); },
         .quiet = true},
        {.name = "Previous scene in the folder",
         .keys = {{Key::PageUp}},
         .section = Section::LecturePages,
         .run = [](UiState& s) { open_other(s, -1); },
         .quiet = true},
        {.name = "Projector: large type, high contrast",
         .keys = {{Key::F9}},
         .section = Section::LectureShow,
         .run = switch_projector,
         .is_on = [](const UiState& s) { return s.layout.projector; },
         .line_above = true,
         .quiet = true,
         .words = "presentation font size beamer"},
        {.name = "Clean picture: no handles, no panels",
         .keys = {{Key::F10}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.layout.hides_all ^= true; },
         .is_on = [](const UiState& s) { return s.layout.hides_all; },
         .quiet = true},
        {.name = "Freeze the picture",
         .keys = {{Key::F8}},
         .section = Section::LectureShow,
         .run = switch_frozen,
         .is_on = [](const UiState& s) { return s.get<LectureState>().frozen.has_value(); },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .id = CommandId::Freeze,
         .words = "pause hold"},
    };
}

void leave_with_lecture(UiState& state, const SceneDocument& next) {
    LectureState& lecture = state.get<LectureState>();
    if (is_another(state, next)) lecture.frozen.reset();
    if (given_scene_beside(lecture.given_scenes, next.path, 0)) lecture.last_given = next.path;
}

std::string unless_drawn_on(const UiState& state) {
    return unless(!state.get<PenState>().lines.empty(), "Nothing has been drawn");
}

std::vector<WindowCommand> pen_commands() {
    return {
        {.name = "Pen",
         .keys = {{Key::W, !ctrl, shift}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.get<PenState>().on ^= true; },
         .is_on = [](const UiState& s) { return s.get<PenState>().on; },
         .id = CommandId::Pen,
         .line_above = true,
         .quiet = true,
         .words = "draw annotate"},
        {.name = "Erase all pen strokes",
         .keys = {{Key::W, !ctrl, !shift, alt}},
         .section = Section::LectureShow,
         .run = [](UiState& s) { s.get<PenState>().lines.clear(); },
         .why_disabled = unless_drawn_on,
         .id = CommandId::WipePen,
         .quiet = true},
        {.name = "Pen: undo the last stroke",
         .run = [](UiState& s) { s.get<PenState>().lines.pop_back(); },
         .why_disabled = unless_drawn_on,
         .quiet = true,
         .words = "undo"},
        {.name = "Pen: next colour",
         .run =
             [](UiState& s) { s.get<PenState>().colour = (s.get<PenState>().colour + 1) % pen_colour_count; },
         .why_disabled =
             [](const UiState& s) { return unless(s.get<PenState>().on, "The pen is not active"); },
         .quiet = true},
    };
}

void reshape_pen(UiState& state, const Reshape& reshape) {
    for (PenLine& line : state.get<PenState>().lines)
        for (glm::vec2& place : line.places) place *= reshape.in_heights;
}

std::vector<WindowCommand> wedge_commands() {
    return {
        {.name = "Step wedge: what does this projector show?",
         .section = Section::LectureWedge,
         .run = [](UiState& s) { s.get<WedgeState>().open ^= true; },
         .is_on = [](const UiState& s) { return s.get<WedgeState>().open; },
         .line_above = true,
         .quiet = true},
    };
}

}  // namespace

void freeze(UiState& state) {
    LectureState& lecture = state.get<LectureState>();
    // If B or an animation is shown, nothing is selected.
    lecture.frozen_selection = state.on_screen.is_out_of_hand()
                                   ? Selection{}
                                   : valid_selection(state.editor.selection, state.rendered_scene);
    lecture.frozen = as_made(state, state.rendered_scene);
}

extern const Feature lecture_feature, pen_feature, wedge_feature, clean_picture_feature;

const Feature lecture_feature{
    .shows = show_frozen,
    .commands = lecture_commands,
    .is_presented =
        [](const UiState& s) { return s.layout.projector || s.get<LectureState>().frozen.has_value(); },
    .leave_document = leave_with_lecture,
    .put_away = [](UiState& s) { s.get<LectureState>().frozen.reset(); }};

const Feature pen_feature{
    .draw = [](UiState& s, const Layout&) { pen_bar(s.get<PenState>(), picture_in_sight(s)); },
    .tool = &pen_tool,
    .overlay = [](ImDrawList& list, UiState& s,
                  const PictureView& view) { draw_pen(list, s.get<PenState>(), view); },
    .overlay_stays = true,
    .reshape = reshape_pen,
    .commands = pen_commands,
    .escape = [](UiState& s) { return std::exchange(s.get<PenState>().on, false); },
    .is_presented = [](const UiState& s) { return s.get<PenState>().on; }};

const Feature wedge_feature{
    .draw = [](UiState& s, const Layout&) { step_wedge(s.get<WedgeState>()); },
    .commands = wedge_commands,
    .escape = [](UiState& s) { return std::exchange(s.get<WedgeState>().open, false); }};

const Feature clean_picture_feature{
    .escape = [](UiState& s) { return std::exchange(s.layout.hides_all, false); }};

namespace {

namespace fs = std::filesystem;

constexpr PictureSize thumbnail{208, 117};

std::string title_of(const std::string& path) {
    std::string title = fs::path(path).stem().string();
    std::replace(title.begin(), title.end(), '-', ' ');
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
        title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

/// Leaves the picture of an unreadable scene empty: opening the scene reports the reason.
SmallPicture draw_example(Renderer& renderer, const Example& example) {
    const Result<SceneDocument> opened = open_document(example.path);
    const auto* document = std::get_if<SceneDocument>(&opened);
    if (document == nullptr) return {};
    return {renderer.render(document->scene, thumbnail, false, 4), document->scene.about};
}

/// Draws a picture with title and caption, `width` wide. True when clicked.
bool card(const ExamplesState& examples, int index, float width, float height) {
    const Example& example = examples.list[static_cast<std::size_t>(index)];
    ImGui::PushID(index);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool clicked = hit_area("##example", {width, height});
    const bool pointed = ImGui::IsItemHovered();
    list_control(example.title.c_str(), "", last_item());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (pointed || index == examples.chosen)
        list.AddRectFilled(low, low + ImVec2(width, height), to_u32(theme().field_hovered), px(4));
    if (index == examples.chosen)
        list.AddRect(low, low + ImVec2(width, height), to_u32(theme().accent), px(4), 0, px(1));
    const float inset = px(6), wide = width - 2 * inset;
    const ImVec2 corner = low + ImVec2(inset, inset);
    const ImVec2 end = corner + ImVec2(wide, wide * float(thumbnail.height) / float(thumbnail.width));
    list.AddRectFilled(corner, end, to_u32(theme().surround));
    const SmallPictures& pictures = examples.pictures;
    if (index < pictures.taken) pictures.sheet.draw(list, index, corner, end);
    const ImVec2 words{corner.x, end.y + px(4)};
    list.AddText(words, to_u32(theme().text), example.title.c_str());
    const ImVec4 clip(low.x, low.y, low.x + width - inset, low.y + height - px(2));
    list.AddText(fonts().small, fonts().small->FontSize,
                 words + ImVec2(0, ImGui::GetTextLineHeight() + px(1)), to_u32(theme().dim_text),
                 pictures.words[static_cast<std::size_t>(index)].c_str(), nullptr, wide, &clip);
    ImGui::PopID();
    return clicked;
}

/// Opens the dialog; a click in it, or the arrow keys and Enter, opens a scene.
void open_examples(UiState& state) {
    ExamplesState& examples = state.get<ExamplesState>();
    examples.open = true;
    examples.chosen = -1;
    if (!examples.list.empty()) return;
    examples.list = examples_in(state.shipped_scenes);
    begin_small_pictures(state.jobs, examples.pictures, "Examples", thumbnail,
                         static_cast<int>(examples.list.size()),
                         [list = examples.list](Renderer& renderer, int index) {
                             return draw_example(renderer, list[static_cast<std::size_t>(index)]);
                         });
}

/// Draws the dialog. Precondition: it is open.
void examples_dialog(UiState& state, const UiInput& input) {
    ExamplesState& examples = state.get<ExamplesState>();
    take_small_pictures(examples.pictures);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(px(980), window.x - px(40)), std::min(px(720), window.y - px(40))};
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
    if (!begin_modal("Examples, in the order of the lecture##examples", &examples.open,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    ImGui::BeginChild("##cards");
    const float room = ImGui::GetContentRegionAvail().x, gap = px(4);
    const int columns = std::max(1, static_cast<int>(room / px(225)));
    const float width = (room - gap * float(columns - 1)) / float(columns);
    const float height = width * float(thumbnail.height) / float(thumbnail.width) + px(80);
    std::optional<int> chosen;
    const int before = examples.chosen, count = static_cast<int>(examples.list.size());
    if (choose_by_keys(examples.chosen, count, columns, input)) chosen = examples.chosen;
    for (int i = 0; i < count; ++i) {
        if (i % columns != 0) ImGui::SameLine(0, gap);
        if (card(examples, i, width, height)) chosen = i;
        if (i == examples.chosen && i != before) ImGui::SetScrollHereY(0.5f);
    }
    ImGui::EndChild();
    if (chosen) examples.open = false;
    if (!examples.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (chosen) ask_to_open(state, examples.list[static_cast<std::size_t>(*chosen)].path);
}

}  // namespace

std::vector<Example> examples_in(const std::string& folder) {
    std::vector<Example> list;
    for (std::string& path : folder_scenes(folder)) {
        std::string title = title_of(path);
        list.push_back({std::move(path), std::move(title)});
    }
    return list;
}

extern const Feature examples_feature;
const Feature examples_feature{
    .dialog = {[](const UiState& s) { return s.get<ExamplesState>().open; },
               [](UiState& s) { s.get<ExamplesState>().open = false; }, examples_dialog},
    .sheet = [](UiState& s) { return &s.get<ExamplesState>().pictures.sheet; },
    .commands =
        [] {
            return std::vector<WindowCommand>{
                {.name = "Examples…",
                 .keys = {{Key::O, ctrl, shift}},
                 .section = Section::FileOpen,
                 .run = open_examples,
                 .why_disabled =
                     [](const UiState& s) {
                         return unless(!s.shipped_scenes.empty(), "Glint's scenes are not installed");
                     }},
            };
        },
    .palette =
        [](std::vector<PaletteEntry>& entries, UiState& s) {
            if (s.shipped_scenes.empty()) return;
            for (const Example& example : examples_in(s.shipped_scenes)) {
                const std::string name = with_spaces(fs::path(example.path).stem().string());
                entries.push_back({"Scene: " + name, "Glint's scenes", "", "",
                                   [path = example.path](UiState& u) { ask_to_open(u, path); }, "", true});
            }
        }};

}  // namespace glint
