#include "ui/features/lessons/lessons_dialog.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "ui/document/document_actions.h"
#include "ui/features/lessons/lesson.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/named_controls.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::vector<LessonEntry> lessons_in(const UiState& state, const std::string& folder) {
    std::vector<LessonEntry> entries;
    const Result<std::vector<std::string>> files = lesson_files({folder});
    const Json records = lesson_records(state);
    for (const std::string& path : std::holds_alternative<Problem>(files)
                                       ? std::vector<std::string>()
                                       : std::get<std::vector<std::string>>(files)) {
        LessonEntry entry{path, fs::path(path).filename().string(), "", {}};
        const Result<Lesson> read = read_lesson(path);
        if (const auto* lesson = std::get_if<Lesson>(&read)) {
            entry.title = lesson->title;
            entry.topic = lesson->topic;
        }
        if (const Json* record = find_member(records, record_key(state.get<LessonState>().folder, path)))
            entry.record = read_record(*record);
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// Draws the progress at the right end of the row.
void draw_record(ImDrawList& list, const LessonRecord& record, ImVec2 low, float width) {
    const CourseScore& score = record.score;
    const std::size_t came = record.at + (score.locked > 0 || record.at > 0 ? 1 : 0);
    const float share = std::min(float(came) / float(record.stations), 1.0f);
    const float y = low.y + px(12);
    list.AddRectFilled({low.x, y}, {low.x + width, y + px(5)}, to_u32(theme().line), px(2.5f));
    if (share > 0)
        list.AddRectFilled({low.x, y}, {low.x + share * width, y + px(5)}, to_u32(theme().accent), px(2.5f));
    const std::string words = score.locked > 0 ? fmt::format("{} of {} right", score.right, score.locked)
                                               : fmt::format("{} of {}", came, record.stations);
    list.AddText(fonts().small, small_text_height(), {low.x, y + px(9)}, to_u32(theme().dim_text),
                 words.c_str());
}

bool lesson_row(const LessonEntry& entry, bool is_open, bool is_chosen) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, high = px(52), number = px(40), bar = px(110);
    ImGui::PushID(entry.path.c_str());
    const bool clicked = hit_area("##row", {width, high});
    ImGui::PopID();
    const bool hovered = ImGui::IsItemHovered();
    list_control(entry.title.c_str(), entry.path, last_item());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = low + ImVec2(width, high - px(3));
    list.AddRectFilled(low, end, to_u32(hovered || is_chosen ? theme().field_hovered : theme().field), px(5));
    if (is_open || is_chosen) list.AddRect(low, end, to_u32(theme().accent), px(5), 0, px(is_open ? 2 : 1));
    list.AddText(fonts().heading, fonts().heading->FontSize * ImGui::GetIO().FontGlobalScale,
                 low + ImVec2(px(10), px(11)), to_u32(theme().accent), number_of(entry).c_str());
    const ImVec4 clip(low.x + number, low.y, end.x - bar - px(20), end.y);
    const float body = fonts().body->FontSize * ImGui::GetIO().FontGlobalScale;
    list.AddText(fonts().body, body, low + ImVec2(number, px(6)), to_u32(theme().text), entry.title.c_str(),
                 nullptr, 0, &clip);
    list.AddText(fonts().small, small_text_height(), low + ImVec2(number, px(27)), to_u32(theme().dim_text),
                 entry.topic.c_str(), nullptr, 0, &clip);
    if (entry.record) draw_record(list, *entry.record, {end.x - bar - px(10), low.y}, bar);
    return clicked;
}

}  // namespace

std::string number_of(const LessonEntry& entry) {
    const std::string name = fs::path(entry.path).stem().string();
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    return name.substr(0, digits);
}

void list_own_lessons(UiState& state) {
    state.get<LessonListState>().own = state.get<LessonState>().folder.empty()
                                           ? std::vector<LessonEntry>()
                                           : lessons_in(state, state.get<LessonState>().folder);
}

void open_lessons(UiState& state) {
    LessonListState& lessons = state.get<LessonListState>();
    lessons.open = true;
    lessons.chosen = -1;
    keep_progress(state);
    list_own_lessons(state);
    lessons.beside.clear();
    if (!state.get<LessonState>().course) return;
    const std::string folder = fs::path(state.get<LessonState>().course->lesson.path).parent_path().string();
    std::error_code failed;
    if (!fs::equivalent(folder.empty() ? "." : folder, state.get<LessonState>().folder, failed))
        lessons.beside = lessons_in(state, folder.empty() ? "." : folder);
}

void lessons_dialog(UiState& state, const UiInput& input) {
    LessonListState& lessons = state.get<LessonListState>();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ImVec2 size{std::min(px(680), window.x - px(40)), std::min(px(720), window.y - px(40))};
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(size);
    if (!begin_modal("Lessons: predict first, then look##lessons", &lessons.open,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return;
    std::string chosen;
    const int before = lessons.chosen, count = static_cast<int>(lessons.beside.size() + lessons.own.size());
    const bool entered = choose_by_keys(lessons.chosen, count, 1, input);
    int index = 0;
    ImGui::BeginChild("##list");
    for (const auto* entries : {&lessons.beside, &lessons.own}) {
        if (entries->empty()) continue;
        if (!lessons.beside.empty())
            section_heading(entries == &lessons.beside ? "Next to the open lesson" : "Of Glint");
        for (const LessonEntry& entry : *entries) {
            const bool is_open =
                state.get<LessonState>().course && state.get<LessonState>().course->lesson.path == entry.path;
            const bool is_chosen = index++ == lessons.chosen;
            if (lesson_row(entry, is_open, is_chosen) || (is_chosen && entered)) chosen = entry.path;
            if (is_chosen && lessons.chosen != before) ImGui::SetScrollHereY(0.5f);
        }
    }
    ImGui::EndChild();
    if (!chosen.empty()) lessons.open = false;
    if (!lessons.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!chosen.empty()) ask_to_open(state, chosen);
}

}  // namespace glint
