#include "ui/features/lecture/lecture.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "models/io/file.h"
#include "ui/ui.h"
#include "ui/widgets/area.h"
#include "ui/widgets/fonts.h"
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

/// Draws the row's patches over the full width.
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

}  // namespace

std::string wedge_words(const WedgeRow& row) {
    if (row.seen < 0)
        return fmt::format("On {}: click the first patch that the last row of the room can see", row.name);
    if (row.seen == 0) return fmt::format("On {} every step is visible", row.name);
    const auto seen = std::min(static_cast<std::size_t>(row.seen), wedge_steps.size() - 1);
    return fmt::format("On {} this projector loses steps below {}/255: colours {:.3f} apart look the same",
                       row.name, wedge_steps[seen], double(wedge_steps[seen - 1]) / 255);
}

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
    wrapped_dim("Each patch differs from its background by this many of 255 steps");
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

std::optional<std::string> given_scene_beside(const std::vector<std::string>& given, const std::string& path,
                                              int step) {
    const auto found = std::find(given.begin(), given.end(), path);
    if (found == given.end()) return {};
    const std::ptrdiff_t at = found - given.begin() + step;
    return at >= 0 && at < std::ssize(given) ? given[static_cast<std::size_t>(at)] : "";
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

}  // namespace glint
