// The features of lessons: the open lesson, the list of lessons, and *Predict*.

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/lessons/lesson_parts.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

const char* column_name(const UiState& state) { return state.get<LessonState>().course ? "Lesson" : nullptr; }

void lecturer_button(UiState& state, float right) {
    const float width = ImGui::CalcTextSize("Lecturer").x + px(16);
    ImGui::SameLine(right - width);
    if (chosen_button("Lecturer", state.get<LessonState>().lecturer, width)) switch_lecturer(state);
    tooltip("Lecturer", "Shows questions without answer fields, for an audience; nothing is recorded");
}

/// The caption of a lesson's scene. Empty if the lesson's column, which describes the scene, is visible.
std::optional<std::string> caption(const UiState& state) {
    if (!state.get<LessonState>().course) return {};
    return state.layout.hides_columns ? lesson_caption(state) : std::string();
}

std::optional<Opening> open_file(const std::string& path) {
    if (!is_lesson_file(path)) return {};
    return opening_of_lesson(path);
}

std::string why_lesson_holds(const UiState& state) {
    return open_question(state.get<LessonState>()) ? "First answer the lesson's question" : "";
}

std::vector<WindowCommand> lesson_commands() {
    return {
        {.name = "Lecturer: a lesson's questions without the answers",
         .section = Section::LectureLesson,
         .run = switch_lecturer,
         .is_on = [](const UiState& s) { return s.get<LessonState>().lecturer; },
         .why_disabled =
             [](const UiState& s) {
                 return unless(s.get<LessonState>().course != nullptr, "No lesson is open");
             },
         .quiet = true},
    };
}

std::vector<WindowCommand> list_commands() {
    return {
        {.name = "Lessons…",
         .keys = {{Key::L, ctrl}},
         .section = Section::FileOpen,
         .run = open_lessons,
         .why_disabled =
             [](const UiState& s) {
                 return unless(!s.get<LessonState>().folder.empty() || s.get<LessonState>().course,
                               "Glint's lessons are not installed");
             }},
    };
}

/// Adds entries that find lessons by number, title, topic and the words in the file's name.
void add_lessons(std::vector<PaletteEntry>& entries, UiState& state) {
    if (state.get<LessonListState>().own.empty()) list_own_lessons(state);
    for (const LessonEntry& lesson : state.get<LessonListState>().own) {
        const std::string file = with_spaces(std::filesystem::path(lesson.path).stem().string());
        const std::string name =
            lesson.title.empty() ? file : fmt::format("{} {}", number_of(lesson), lesson.title);
        entries.push_back({"Lesson: " + name, "Glint's lessons", "", "",
                           [path = lesson.path](UiState& s) { ask_to_open(s, path); },
                           file + " " + lesson.topic, true});
    }
}

std::vector<WindowCommand> predict_commands() {
    return {
        {.name = "Predict a colour in a frozen picture",
         .keys = {{Key::Q}},
         .section = Section::LecturePredict,
         .run = switch_prediction,
         .is_on = [](const UiState& s) { return s.get<PredictState>().stage != PredictStage::Off; },
         .why_disabled = [](const UiState& s) { return unless_drawn(s.rendered); },
         .line_above = true,
         .noun = "Predict a colour"},
    };
}

bool leave_prediction(UiState& state) {
    if (state.get<PredictState>().stage == PredictStage::Off) return false;
    end_prediction(state);
    return true;
}

}  // namespace

Opening opening_of_lesson(const std::string& path) {
    const auto course = std::make_shared<std::shared_ptr<const Course>>();
    const auto work = [path, course](LoadProgress&) -> Result<SceneDocument> {
        Result<std::shared_ptr<const Course>> opened = open_course(path);
        if (const Problem* problem = problem_of(opened)) return *problem;
        *course = std::get<std::shared_ptr<const Course>>(std::move(opened));
        return (*course)->document;
    };
    return {path, std::make_shared<LoadJob>(std::filesystem::path(path).filename().string(), work),
            [course](UiState& state) { begin_lesson(state, *course); }};
}

extern const Feature lesson_feature, lesson_list_feature, prediction_feature;

const Feature lesson_feature{.settle = hold_lesson,
                             .end = poll_lesson,
                             .tool = &lesson_tool,
                             .overlay = draw_lesson,
                             .column = {column_name, lesson_column, close_lesson, lecturer_button},
                             .caption = caption,
                             .commands = lesson_commands,
                             .key = answer_by_key,
                             .open = open_file,
                             .why_held = why_lesson_holds,
                             .leave_document = [](UiState& s, const SceneDocument&) { leave_lesson(s); }};

const Feature lesson_list_feature{
    .dialog = {[](const UiState& s) { return s.get<LessonListState>().open; },
               [](UiState& s) { s.get<LessonListState>().open = false; }, lessons_dialog},
    .commands = list_commands,
    .palette = add_lessons};

const Feature prediction_feature{
    .update = poll_prediction,
    .reshape =
        [](UiState& s, const Reshape& reshape) {
            if (auto& probe = s.get<PredictState>().probe) reshape.follow(*probe);
        },
    .why = [](UiState& s, const PictureView&) { return predict_panel(s); },
    .commands = predict_commands,
    .key = predict_by_key,
    .escape = leave_prediction,
    .leave_document = [](UiState& s, const SceneDocument&) { end_prediction(s); }};

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

/// Draws a lesson's progress at the right end of the lesson's row.
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
            section_heading(entries == &lessons.beside ? "Next to the open lesson" : "Glint's lessons");
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
