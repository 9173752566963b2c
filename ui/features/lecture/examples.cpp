#include "ui/features/lecture/examples.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "renderer/renderer.h"
#include "ui/commands/command.h"
#include "ui/commands/match.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/lecture/lecture.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

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
