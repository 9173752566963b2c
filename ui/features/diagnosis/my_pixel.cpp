// The picked pixel in the user's picture, the correct pixel, and the pixel under the chosen mistake, term by
// term.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/inspector/equation/words.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/views/fitted_picture.h"
#include "ui/picture/screen.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The pixel as the scene under these mistakes shows it. A mistake may change the visible face, so the scene
/// is drawn.
Explanation explained_under(UiState& state, std::unique_ptr<Renderer>& renderer, const MistakeSet& mistakes,
                            glm::ivec2 pixel) {
    if (!renderer) renderer = std::make_unique<Renderer>(state.threads);
    (void)renderer->render(under_mistakes(state.editor.scene(), mistakes), state.rendered->size);
    return renderer->explain(pixel.x, pixel.y);
}

Rgb bytes_of(const Explanation& e) {
    Rgb colour{};
    std::transform(e.byte.begin(), e.byte.end(), colour.begin(),
                   [](int byte) { return static_cast<std::uint8_t>(byte); });
    return colour;
}

struct TermRow {
    Symbol symbol;
    std::string name;
    float right = 0, mistaken = 0;
};

/// The sums of terms, then the differing terms of single lights.
std::vector<TermRow> term_rows(const Explanation& right, const Explanation& mistaken, int channel) {
    const TermSums a = term_sums(right), b = term_sums(mistaken);
    std::vector<TermRow> rows{{Symbol::Emission, "e  emission", a.emission[channel], b.emission[channel]},
                              {Symbol::Ambient, "a  ambient", a.ambient[channel], b.ambient[channel]},
                              {Symbol::Diffuse, "d  diffuse", a.diffuse[channel], b.diffuse[channel]},
                              {Symbol::Specular, "s  specular", a.specular[channel], b.specular[channel]}};
    if (right.at.lights.size() != mistaken.at.lights.size() || right.lit_per_corner) return rows;
    for (std::size_t i = 0; i < right.at.lights.size(); ++i) {
        const ExplainedLight &x = right.at.lights[i], &y = mistaken.at.lights[i];
        for (const TermRow& row : {TermRow{Symbol::Ambient, "a", x.ambient[channel], y.ambient[channel]},
                                   TermRow{Symbol::Diffuse, "d", x.diffuse[channel], y.diffuse[channel]},
                                   TermRow{Symbol::Specular, "s", x.specular[channel], y.specular[channel]}})
            if (row.right != row.mistaken)
                rows.push_back({row.symbol, row.name + "  " + x.name, row.right, row.mistaken});
    }
    return rows;
}

void number_cell(float value, const ImVec4& colour) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    mono_text(shown_number(value));
    ImGui::PopStyleColor();
}

/// Highlights differing rows.
void term_table(const UiState& state, const Explanation& right, const Explanation& mistaken) {
    constexpr std::array channels{"red", "green", "blue"};
    const int channel = state.get<InspectorState>().channel;
    const float width = std::min(px(70), (ImGui::GetContentRegionAvail().x - px(100)) / 2);
    if (!ImGui::BeginTable("##mine", 3, ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const char* column : {"right", "mistaken"})
        ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthFixed, width);
    ImGui::PushFont(fonts().small);
    ImGui::TableNextRow();
    for (const char* title : {channels[static_cast<std::size_t>(channel)], "right", "mistaken"}) {
        ImGui::TableNextColumn();
        dim_text(title);
    }
    ImGui::PopFont();
    for (const TermRow& row : term_rows(right, mistaken, channel)) {
        const bool same = row.right == row.mistaken;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        coloured(row.symbol, row.name);
        number_cell(row.right, same ? theme().dim_text : theme().text);
        number_cell(row.mistaken, same ? theme().dim_text : theme().warning);
    }
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted("sum");
    number_cell(right.sum[channel], theme().text);
    number_cell(mistaken.sum[channel], theme().text);
    ImGui::EndTable();
}

/// The chosen candidate; null: none.
const Candidate* chosen_candidate(const MyPictureState& mine) {
    if (!mine.answer || mine.answer->diagnosis.candidates.empty()) return nullptr;
    const auto& all = mine.answer->diagnosis.candidates;
    return &all[std::min(mine.chosen, all.size() - 1)];
}

}  // namespace

std::optional<PixelOfMine> pixel_of_mine(UiState& state) {
    MyPictureState& mine = state.get<MyPictureState>();
    const Scene& scene = state.editor.scene();
    if (!mine.shown || !state.on_screen.explanation) return {};
    const glm::ivec2 pixel{state.on_screen.explanation->x, state.on_screen.explanation->y};
    const PictureSize size = state.rendered->size;
    const auto lacks_mesh = [](const Object& object) { return !object.mesh; };
    if (!is_inside(size, pixel) || std::any_of(scene.objects.begin(), scene.objects.end(), lacks_mesh))
        return {};
    const Picture& picture = mine.answer ? *mine.answer->mine : *mine.shown;
    const auto place = pixel_in(pixels_between(scene.camera, size, picture.size), pixel, picture.size);
    if (!place) return {};
    PixelOfMine found{*place,
                      rgb_at(picture, picture.pixel(place->x, place->y)),
                      explained_under(state, mine.right, {}, pixel),
                      {}};
    if (const Candidate* candidate = chosen_candidate(mine))
        found.mistaken = explained_under(state, mine.mistaken, candidate->mistakes, pixel);
    return found;
}

void my_pixel(UiState& state) {
    if (!state.get<MyPictureState>().shown) return;
    section_heading("In my picture");
    const std::optional<PixelOfMine> pixel = pixel_of_mine(state);
    if (!pixel) return wrapped_dim("My picture does not cover this pixel.");
    if (shown_experiment(state) != nullptr)
        small_dim("It shows the scene before the experiment.");
    else
        colour_line(fmt::format("mine, pixel {}, {}", pixel->place.x, pixel->place.y).c_str(), pixel->mine);
    colour_line("right", bytes_of(pixel->right));
    if (!pixel->mistaken) return;
    colour_line(title_of(*chosen_candidate(state.get<MyPictureState>())).c_str(), bytes_of(*pixel->mistaken));
    if (pixel->right.hit && pixel->mistaken->hit) term_table(state, pixel->right, *pixel->mistaken);
}

}  // namespace glint
