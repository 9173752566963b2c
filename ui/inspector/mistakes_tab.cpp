#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "models/scene/mistakes.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/tabs.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

std::string title_of(const MistakeName& mistake) {
    std::string title(mistake.name);
    std::replace(title.begin(), title.end(), '_', ' ');
    if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

namespace {

/// The words of its tooltip: what looks like it, and who asked about it.
std::string notes_on(const MistakeName& mistake) {
    std::string notes = "Rest here to see it, click to keep it.";
    if (!mistake.look_alikes.empty()) {
        std::string names(mistake.look_alikes);
        std::replace(names.begin(), names.end(), ' ', '\n');
        std::replace(names.begin(), names.end(), '_', ' ');
        notes += "\nLooks like:\n" + names;
    }
    if (!mistake.sources.empty()) notes += fmt::format("\nAsked in: {}", mistake.sources);
    return notes;
}

/// A switch with its words below; pointed at, the picture shows the other position of the switch.
void mistake_row(UiState& state, const MistakeName& mistake) {
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    const std::string title = title_of(mistake);
    const std::string pointer = fmt::format("/shading/mistakes/{}", mistake.name);
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(2), px(1)});
    (void)ImGui::Checkbox(title.c_str(), &(mistakes.*mistake.flag));
    ImGui::PopStyleVar();
    const bool pointed = is_pointed_at();
    tooltip(title.c_str(), notes_on(mistake).c_str(), "off by default", pointer);
    ImGui::Indent(px(24));
    small_dim(fmt::format("{} {}", mistake.what, mistake.looks));
    ImGui::Unindent(px(24));
    ImGui::EndGroup();
    if (!pointed && !is_pointed_at(last_item())) return;
    Scene other = state.editor.scene();
    other.shading.mistakes.*mistake.flag ^= true;
    show_instead(state, other, mistakes.*mistake.flag ? "without: " + title : title);
}

}  // namespace

int mistakes_on(const Mistakes& mistakes) {
    const auto names = mistake_names();
    return static_cast<int>(
        std::count_if(names.begin(), names.end(), [&](const MistakeName& m) { return mistakes.*m.flag; }));
}

void mistakes_tab(UiState& state, const PictureView&) {
    Mistakes& mistakes = state.editor.scene().shading.mistakes;
    const int on = mistakes_on(mistakes);
    if (on == 0) {
        small_dim(
            "Each switch does one thing wrong, so that it can be recognised. Rest on a line to see it.");
    } else {
        warning_text(fmt::format("{} on: the picture is wrong on purpose", on));
        if (ImGui::Button("All off")) mistakes = {};
        tooltip("All off", "The equation as it should be");
    }
    for (const SeenAs seen_as : all_seen_as) {
        section_heading(std::string(heading_of(seen_as)).c_str());
        for (const MistakeName& mistake : mistake_names())
            if (mistake.seen_as == seen_as) mistake_row(state, mistake);
    }
}

}  // namespace glint
