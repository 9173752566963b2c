// The question about size and samples of a picture to be written.
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/document/document_actions.h"
#include "ui/shell/modal.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

struct NamedSize {
    const char* name;
    PictureSize size;
};
constexpr std::array sizes{NamedSize{"HD", {1280, 720}}, NamedSize{"Full HD", {1920, 1080}},
                           NamedSize{"4K", {3840, 2160}}, NamedSize{"Square", {1024, 1024}}};
constexpr std::array<int, 4> samples{1, 2, 4, 8};

bool size_button(const char* name, PictureSize size, ExportOptions& options) {
    const bool pressed = chosen_button(name, options.size == size);
    if (pressed) options.size = size;
    return pressed;
}

void size_rows(UiState& state, ExportOptions& options) {
    label_cell("Size");
    if (state.rendered != nullptr) {
        size_button("As shown", state.rendered->size, options);
        ImGui::SameLine(0, px(3));
    }
    for (const NamedSize& named : sizes) {
        size_button(named.name, named.size, options);
        ImGui::SameLine(0, px(3));
    }
    ImGui::NewLine();
    const Help help{"Of the picture, in pixels", ""};
    (void)integer_field("Width", options.size.width, 1, 16384, 1920, help);
    (void)integer_field("Height", options.size.height, 1, 16384, 1080, help);
}

}  // namespace

void export_dialog(UiState& state) {
    ExportState& exporting = state.exporting;
    static constexpr const char* id = "Export the picture##export";
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(px(470), window.x), 0});
    if (!begin_modal(id, &exporting.open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
    size_rows(state, exporting.options);
    std::vector<Choice> options;
    constexpr const char* names[] = {"1", "2", "4", "8"};
    for (const char* name : names) options.push_back({name, name, "Samples a pixel"});
    const auto at = std::find(samples.begin(), samples.end(), exporting.options.samples) - samples.begin();
    label_cell("Samples");
    const int chosen = segments("##samples", static_cast<int>(at), options,
                                {"More make the edges smooth; inside a face nothing changes", ""});
    exporting.options.samples = samples[static_cast<std::size_t>(chosen)];
    ImGui::Dummy({0, px(4)});
    dim_text(".png carries its scene; .pfm and .exr hold linear float numbers");
    ImGui::Dummy({0, px(4)});
    if (ImGui::Button("Choose a name…", {px(150), 0})) {
        exporting.open = false;
        state.files.ask(FilePurpose::ExportPicture, offered_name(state, ".png"));
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(90), 0})) exporting.open = false;
    if (!exporting.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace glint
