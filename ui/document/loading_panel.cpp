// What is being loaded, how far it has come, and the way to end it.
#include <imgui.h>

#include <cmath>

#include "ui/export/export_picture.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double shown_after = 0.25;      // seconds: what is quicker does not flash
constexpr double seconds_a_frame = 0.03;  // while something loads

/// A bar; a piece that runs along it when the share is not known.
void bar(float share) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = px(5);
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, to_u32(theme().field_active), px(2));
    float from = 0, to = share;
    if (share < 0) {
        from = static_cast<float>(0.5 - 0.5 * std::cos(ImGui::GetTime() * 3)) * 0.75f;
        to = from + 0.25f;
    }
    list.AddRectFilled({low.x + from * width, low.y}, {low.x + to * width, low.y + height},
                       to_u32(theme().accent), px(2));
}

}  // namespace

void loading_panel(UiState& state, const Rect& picture) {
    const LoadJob* job = state.loading.document ? state.loading.document.get() : state.loading.meshes.get();
    if (job == nullptr) return;
    redraw_within(seconds_a_frame);
    if (ImGui::GetTime() - state.loading.since < shown_after) return;
    const float width = begin_over_picture("##loading", px(400), picture, ImGuiWindowFlags_NoNav);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(job->name().c_str());
    ImGui::SameLine(width - px(90));
    const bool cancelled = ImGui::Button("Cancel", {px(80), 0});
    tooltip("Cancel", "The scene stays as it is");
    ImGui::PushFont(fonts().small);
    dim_text(progress_words(job->progress()).c_str());
    ImGui::PopFont();
    bar(progress_share(job->progress()));
    end_over_picture();
    if (cancelled) cancel_loads(state);
}

}  // namespace glint
