// Temporary panels over the picture: the current load, with a cancel button, and the offer to recover a copy
// left by a crash.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ui/document/document_actions.h"
#include "ui/document/loading.h"
#include "ui/feature.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr double shown_after = 0.25;      // seconds: a quicker load shows no panel
constexpr double seconds_a_frame = 0.03;  // time between frames while something loads

/// A progress bar; if the share is unknown, a segment that runs along it.
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

/// Begins a panel over the middle of the picture's upper edge, at most `widest` wide and never cut off at the
/// window's sides; end_over_picture() must follow. Returns its width.
float begin_over_picture(const char* id, float widest, const Rect& picture, ImGuiWindowFlags more = 0) {
    const float window = ImGui::GetIO().DisplaySize.x, width = std::min(widest, window - px(20));
    const float middle = std::clamp((picture.low.x + picture.high.x) / 2, width / 2, window - width / 2);
    ImGui::SetNextWindowPos({middle, picture.low.y + px(14)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | more);
    return width;
}

void end_over_picture() {
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace

std::string progress_words(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    const auto megabytes = [](std::uint64_t bytes) { return static_cast<double>(bytes) * 1e-6; };
    switch (progress.stage.load()) {
    case LoadStage::Reading:
        if (total == 0) return "reading";
        return fmt::format("reading {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Parsing:
        return fmt::format("parsing {:.1f} of {:.1f} MB", megabytes(done), megabytes(total));
    case LoadStage::Building:
        if (total > 0) return fmt::format("building the mesh: {} of {} faces", done, total);
        return done == 0 ? "building the mesh" : fmt::format("building the mesh: {} faces", done);
    }
    return {};  // not reached
}

float progress_share(const LoadProgress& progress) {
    const std::uint64_t done = progress.done, total = progress.total;
    if (total == 0) return -1;
    return static_cast<float>(std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

bool progress_panel(const AnyJob& job, double since, const Rect& picture) {
    redraw_within(seconds_a_frame);
    if (ImGui::GetTime() - since < shown_after) return false;
    const float width = begin_over_picture("##loading", px(400), picture, ImGuiWindowFlags_NoNav);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(file_title(job.name()).c_str());
    ImGui::SameLine(width - px(90));
    const bool cancelled = ImGui::Button("Cancel", {px(80), 0});
    tooltip("Cancel", "The scene stays as it is");
    ImGui::PushFont(fonts().small);
    dim_text(progress_words(job.progress()).c_str());
    ImGui::PopFont();
    bar(progress_share(job.progress()));
    end_over_picture();
    return cancelled;
}

void loading_panel(UiState& state, const Rect& picture) {
    const LoadJob* job = state.loading.document ? state.loading.document.get() : state.loading.meshes.get();
    if (job != nullptr && progress_panel(*job, state.loading.since, picture)) cancel_loads(state);
}

namespace {

/// Whether the window is presented to an audience: then nothing pops up by itself.
bool is_shown_to_others(const UiState& state) {
    const auto is_presented = [&state](const Feature* feature) {
        return feature->is_presented != nullptr && feature->is_presented(state);
    };
    return state.layout.hides_columns || state.layout.hides_all ||
           std::any_of(features().begin(), features().end(), is_presented);
}

}  // namespace

void answer_copy(UiState& state, CopyAnswer answer) {
    auto& left = state.persistence.orphans;
    if (answer == CopyAnswer::Recover)
        return ask_first(state, [path = left.front().lock.path](UiState& s) { recover_autosave(s, path); });
    const std::string copy = left.front().lock.path;
    std::error_code failed;
    if (answer == CopyAnswer::Discard) std::filesystem::remove(copy, failed);
    if (failed)
        state.notifications.add(
            Problem{copy, "", "cannot be removed: " + failed.message(), "a folder of your own"});
    left.erase(left.begin());
}

void recovery_panel(UiState& state, const Rect& picture) {
    auto& left = state.persistence.orphans;
    if (left.empty() || state.pending.asking || state.loading.active() || is_shown_to_others(state)) return;
    const float width = begin_over_picture("##recovery", px(470), picture);
    ImGui::PushTextWrapPos(width - px(14));
    ImGui::TextUnformatted(fmt::format("Glint ended while {} had unsaved changes. A copy from {} was kept.",
                                       left.front().title, left.front().when)
                               .c_str());
    ImGui::PopTextWrapPos();
    const bool open = ImGui::Button("Recover", {px(110), 0});
    tooltip("Recover", "Opens the copy; the file stays as it is until you save");
    ImGui::SameLine();
    const bool discard = ImGui::Button("Discard", {px(110), 0});
    tooltip("Discard", "Deletes the copy");
    ImGui::SameLine();
    const bool later = ImGui::Button("Not now", {px(110), 0});
    tooltip("Not now", "Asks again at the next start");
    small_dim(fmt::format("{}: recover, discard, not now", keys_of(CommandId::Palette)));
    end_over_picture();
    if (open) return answer_copy(state, CopyAnswer::Recover);
    if (discard) return answer_copy(state, CopyAnswer::Discard);
    if (later) answer_copy(state, CopyAnswer::NotNow);
}

}  // namespace glint
