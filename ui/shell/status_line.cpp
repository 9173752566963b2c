// The status line at the bottom.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "ui/feature.h"
#include "ui/picture/tool.h"
#include "ui/shell/columns.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr std::array<const char*, stage_count> stage_names{"geometry", "visibility", "surface", "transport",
                                                           "lighting"};

std::string stats_text(const UiState& state) {
    const std::size_t triangles = state.renderer->stats().triangles,
                      lights = state.rendered_scene.lights.size();
    return fmt::format("{} {}  ·  {} {}", with_thousands(triangles),
                       triangles == 1 ? "triangle" : "triangles", lights, lights == 1 ? "light" : "lights");
}

void stats_tooltip(const FrameStats& stats, double parts_ms) {
    std::string lines = fmt::format("{:.1f} ms\n", stats.total_ms + parts_ms);
    for (std::size_t i = 0; i < stage_count; ++i)
        lines += stats.redone[i] ? fmt::format("{}: {:.2f} ms\n", stage_names[i], stats.ms[i])
                                 : fmt::format("{}: kept\n", stage_names[i]);
    if (stats.strokes_redone) lines += fmt::format("strokes: {:.2f} ms\n", stats.strokes_ms);
    lines += fmt::format("{} pixels show a surface\n{} evaluations of the equation\n{} × {} threads",
                         with_thousands(stats.shaded_pixels), with_thousands(stats.evaluations),
                         stats.instruction_set, stats.threads);
    tooltip("Last picture", "What was recomputed, and how long it took", lines);
}

}  // namespace

void status_line(UiState& state, const Rect& area) {
    ImGui::SetNextWindowPos(area.low);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushFont(fonts().small);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {px(10), (area.size().y - ImGui::GetTextLineHeight()) / 2});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme().window);
    ImGui::Begin("##status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    if (state.rendered != nullptr) {
        const std::string stats = stats_text(state);
        const float width = ImGui::CalcTextSize(stats.c_str()).x;
        const ImVec2 left = ImGui::GetCursorScreenPos();
        const float right = area.high.x - width - px(10);
        float mark = 0;
        for (const Feature* feature : features())
            if (feature->status != nullptr) mark += feature->status(state, {right - mark, left.y});
        const std::string hint = tools_hint(state);
        const float end = std::max(right - mark - px(16), left.x);
        cut_text(*ImGui::GetWindowDrawList(), left, end, hint);
        ImGui::SetCursorScreenPos({right, left.y});
        dim_text(stats.c_str());
        ImGui::PopFont();
        stats_tooltip(state.renderer->stats(), state.parts_ms);
        ImGui::PushFont(fonts().small);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace glint
