// The user's lighting.glsl: drawn in a separate process, edited in the panel, and started as a blank file.
#include <fmt/core.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "models/io/file.h"
#include "programs/program.h"
#include "shader/shader_process.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Writes a file with the steps of the open scene's equation, and opens it.
void start_blank(UiState& state, const std::string& path) {
    const Scene scene = under_mistakes(state.editor.scene(), {});
    const Result<Program> program = write_program({scene, state.full_size, "scene", true}, Language::Glsl);
    if (const Problem* problem = problem_of(program)) return state.notifications.add(*problem);
    for (const ProgramFile& file : std::get<Program>(program).texts) {
        if (file.name != "lighting.glsl") continue;
        const auto written = write_file_at_once(path, file.text);
        if (const Problem* problem = problem_of(written)) return state.notifications.add(*problem);
    }
    bring_picture(state, path);
}

/// Draws the numbers of the lines that are visible in `text`, the child window of the field drawn last. Lines
/// with a message are highlighted.
void line_numbers(const MyPictureState& mine, const ImGuiWindow& text, int lines) {
    const float height = ImGui::GetTextLineHeight(), pad = ImGui::GetStyle().FramePadding.y;
    const Rect field = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({0, field.low.y}, {field.low.x, field.high.y});
    for (int i = static_cast<int>(text.Scroll.y / height); i < lines; ++i) {
        const std::string number = fmt::format("{}", i + 1);
        const ImVec2 at{field.low.x - px(6) - ImGui::CalcTextSize(number.c_str()).x,
                        field.low.y + pad + float(i) * height - text.Scroll.y};
        if (at.y > field.high.y) break;
        const bool is_marked = std::any_of(mine.messages.begin(), mine.messages.end(),
                                           [i](const Problem& problem) { return problem.line == i + 1; });
        list.AddText(at, to_u32(is_marked ? theme().warning : theme().dim_text), number.c_str());
    }
    list.PopClipRect();
}

/// Draws the text with its line numbers. Returns whether Ctrl+Enter was pressed in the text.
bool text_area(MyPictureState& mine) {
    ShaderEditor& editor = mine.editor;
    ImGui::PushFont(fonts().figures);
    const int lines = 1 + static_cast<int>(std::count(editor.text.begin(), editor.text.end(), '\n'));
    const float margin = ImGui::CalcTextSize(fmt::format("{}", lines).c_str()).x + px(8);
    constexpr int fewest = 8, most = 20;
    const float height = float(std::clamp(lines, fewest, most)) * ImGui::GetTextLineHeight() +
                         2 * ImGui::GetStyle().FramePadding.y;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + margin);
    const std::string before = editor.text;
    const bool enter =
        ImGui::InputTextMultiline("##shader", &editor.text, {ImGui::GetContentRegionAvail().x, height},
                                  ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_EnterReturnsTrue);
    // Escape ends editing and keeps the text; ImGui would revert it.
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) editor.text = before;
    editor.is_active = ImGui::IsItemActive();
    line_numbers(mine, *ImGui::GetCurrentWindow()->DC.ChildWindows.back(), lines);
    ImGui::PopFont();
    return enter;
}

}  // namespace

bool is_shader(const std::string& path) { return lower_extension(path) == ".glsl"; }

Result<BroughtPicture> drawn_by_shader(const std::string& path, const Scene& scene, PictureSize size,
                                       const ChildLimits& limits) {
    return result_of("the scene", [&] {
        BroughtPicture out{path, {}, {}, scene.display};
        constexpr std::chrono::milliseconds settles{20};  // editors write such short files in one go
        out.watched.emplace(path, settles);
        out.text = value_or_throw(read_shader(path));
        Scene with_meshes = scene;
        std::erase_if(with_meshes.objects, [](const Object& object) { return !object.mesh; });
        CornerCache cache;
        ShaderAnswer answer = shade_in_process(value_or_throw(shader_scene(with_meshes, size, cache)),
                                               out.text, ShaderOutput::Displayed, limits);
        const std::string name = std::filesystem::path(path).filename().string();
        out.messages = problems_of(answer, name);
        for (const std::string& warning : warnings_of(answer, name))
            out.messages.push_back({"", "", warning, ""});
        if (answer.end != ShaderAnswer::End::Drawn) return out;
        out.file = out.shown = std::make_shared<const Picture>(std::move(answer.picture.picture));
        return out;
    });
}

void save_shader(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    const auto written = write_file_at_once(mine.path, mine.editor.text);
    if (const Problem* problem = problem_of(written)) return state.notifications.add(*problem);
    mine.editor.saved = mine.editor.text;
    read_again(state);
}

void shader_editor(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    small_dim(fmt::format("{} is redrawn whenever any program saves it.", mine.path));
    if (!fold("Edit here", false)) return;
    constexpr std::size_t longest = 50'000;  // ImGui measures the entire text in every frame
    if (mine.editor.text.size() > longest) return wrapped_dim("The shader is too long to edit here.");
    const bool enter = text_area(mine);
    if (ImGui::Button("Save and draw") || enter) save_shader(state);
    tooltip("Save and draw", "Writes the file and draws the scene with it", "", "Ctrl+Enter or Ctrl+S");
    if (mine.editor.text == mine.editor.saved) return;
    ImGui::SameLine();
    small_dim("not saved");
}

const FilePurpose my_shader_purpose{.title = "My shader",
                                    .button = "Draw",
                                    .hint = "A lighting equation in GLSL (.glsl)",
                                    .nothing = "No folders or shaders here",
                                    .extensions = {".glsl"},
                                    .use = bring_picture};

const FilePurpose blank_shader_purpose{.title = "Blank shader",
                                       .button = "Begin",
                                       .hint = "A new file with the steps of the equation to fill in (.glsl)",
                                       .extensions = {".glsl"},
                                       .saves = true,
                                       .use = start_blank};

}  // namespace glint
