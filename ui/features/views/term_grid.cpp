#include "ui/features/views/term_grid.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "ui/feature.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/lecture/lecture.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

extern const Feature inspector_feature;
namespace {

constexpr int max_rows = 64;     // of the sheet; lights beyond that have no picture
constexpr int cell_width = 84;   // pixels
constexpr double budget_ms = 8;  // per frame, for thumbnails

/// Returns the cell's index in grid_cells().
std::size_t index_of(GridCell cell) {
    return static_cast<std::size_t>(cell.light < 0 ? cell.term : 2 + 3 * cell.light + cell.term);
}

bool is_among(const std::vector<GridCell>& cells, GridCell cell) {
    return std::find(cells.begin(), cells.end(), cell) != cells.end();
}

void begin_sheet(TermGridState& grid, const Scene& scene, PictureSize size) {
    const int height = std::clamp(cell_width * size.height / std::max(size.width, 1), 20, 2 * cell_width);
    const int rows = std::min(static_cast<int>(scene.lights.size()) + 1, max_rows);
    grid.sheet.reset({cell_width, height, size.keeps_width}, 3, 3 * rows);
    grid.drawn_of = scene;
    grid.gains.clear();
    grid.next = 0;
}

void draw_cell(TermGridState& grid, const Scene& scene, GridCell cell) {
    const int row = cell.light + 1;
    if (row >= max_rows) return;
    const PictureSize size = grid.sheet.cell;
    Scene alone = with_cells(scene, {cell});
    alone.transport.paths = std::min(alone.transport.paths, 4);  // limited because the window waits for it
    const int gain =
        gain_of(*grid.renderer, grid.renderer->render(alone, size, true), scene.display.exposure);
    grid.gains.push_back(gain);
    grid.sheet.put(3 * row + cell.term, grid.renderer->render(brightened(alone, gain), size));
}

const char* name_of(GridCell cell) {
    static constexpr std::array with_light{"ambient", "diffuse", "specular"},
        without{"emission", "global ambient", ""};
    const auto term = static_cast<std::size_t>(cell.term);
    return cell.light < 0 ? without[term] : with_light[term];
}

/// "Bulb: diffuse", "emission".
std::string label_of(const Scene& scene, GridCell cell) {
    if (cell.light < 0) return name_of(cell);
    return fmt::format("{}: {}", scene.lights[static_cast<std::size_t>(cell.light)].name, name_of(cell));
}

void toggle_muted(TermGridState& grid, GridCell cell) {
    const auto at = std::find(grid.muted.begin(), grid.muted.end(), cell);
    if (at != grid.muted.end())
        grid.muted.erase(at);
    else
        grid.muted.push_back(cell);
    grid.solo.reset();
}

/// The gain of a cell if it has been drawn, otherwise 1.
int gain_shown(const TermGridState& grid, GridCell cell) {
    const std::size_t at = index_of(cell);
    return at < grid.gains.size() ? grid.gains[at] : 1;
}

/// Draws text in a corner of a thumbnail, with its lower left corner at `at`.
void small_note(ImDrawList& list, ImVec2 at, const std::string& text) {
    ImGui::PushFont(fonts().small);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    rimmed_text(list, {at.x + size.x / 2, at.y - size.y / 2}, {1, 1, 1, 1}, text);
    ImGui::PopFont();
}

/// Draws a thumbnail: a click shows it alone, a right click leaves it out. True while hovered.
bool cell_button(TermGridState& grid, GridCell cell, float width) {
    const PictureSize size = grid.sheet.cell;
    const float height = width * float(size.height) / float(size.width);
    ImGui::PushID(3 * (cell.light + 1) + cell.term);
    const bool clicked = hit_area("##cell", {width, height});
    const bool right = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    const auto [low, high] = last_item();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int row = cell.light + 1;
    if (row < max_rows && grid.sheet.serial > 0) grid.sheet.draw(list, 3 * row + cell.term, low, high);
    const int gain = gain_shown(grid, cell);
    if (gain != 1)
        small_note(list, {low.x + px(4), high.y - px(3)},
                   gain == 0 ? "adds nothing" : fmt::format("× {}", gain));
    const bool solo = grid.solo == cell, muted = is_among(grid.muted, cell);
    if (muted) list.AddRectFilled(low, high, to_u32(theme().panel, 0.75f));
    if (muted) list.AddLine(low, high, to_u32(theme().warning), px(2));
    const bool pointed = is_pointed_at();
    list.AddRect(low, high,
                 to_u32(solo      ? theme().accent
                        : pointed ? theme().text
                                  : theme().line),
                 0, 0, px(solo ? 2.5f : 1));
    tooltip(name_of(cell), "Click: show alone · Right click: leave out · both end when this tab is closed",
            solo        ? "shown alone"
            : muted     ? "left out"
            : gain > 1  ? fmt::format("here {} times as bright as in the picture", gain)
            : gain == 0 ? "contributes nothing"
                        : "");
    if (clicked) grid.solo = solo ? std::nullopt : std::optional(cell), grid.muted.clear();
    if (right) toggle_muted(grid, cell);
    ImGui::PopID();
    return pointed;
}

void row_heading(const Scene& scene, int light) {
    if (light < 0) return small_dim("Without a light: emission, global ambient");
    const Light& l = scene.lights[static_cast<std::size_t>(light)];
    light_icon(l);
    ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(ImGui::GetTextLineHeight() + px(6), 0));
    small_dim(l.name + (l.enabled ? "" : " (off)"));
}

/// The labels above the columns of all lights.
void column_headings(float width, float gap) {
    static constexpr std::array symbols{Symbol::Ambient, Symbol::Diffuse, Symbol::Specular};
    const float left = ImGui::GetCursorPosX();
    ImGui::Dummy({0, px(2)});
    ImGui::PushFont(fonts().small);
    for (int term = 0; term < 3; ++term) {
        if (term > 0) ImGui::SameLine(left + float(term) * (width + gap));
        coloured(symbols[static_cast<std::size_t>(term)], name_of({0, term}));
    }
    ImGui::PopFont();
}

/// Draws the cells of a light, or those without a light (-1), below their heading. Returns the hovered one.
std::optional<GridCell> cell_row(TermGridState& grid, const Scene& scene, int light) {
    const float gap = px(4), width = (ImGui::GetContentRegionAvail().x - px(10)) / 3;
    if (light == 0) column_headings(width, gap);
    row_heading(scene, light);
    std::optional<GridCell> pointed;
    for (int term = 0; term < (light < 0 ? 2 : 3); ++term) {
        if (term > 0) ImGui::SameLine(0, gap);
        if (cell_button(grid, {light, term}, width)) pointed = GridCell{light, term};
    }
    return pointed;
}

void sum_note(const Scene& scene) {
    if (scene.npr.cool_to_warm) return warning_text("Cool to warm: the tones replace the sum.");
    if (scene.shading.mistakes.clamp_each_light)
        return warning_text("Each light is clamped (a mistake): the cells do not add up.");
    small_dim(
        "Hover over a cell to preview it alone; click to keep it; right-click to leave it out. In linear "
        "colours, before clipping, the cells add up to the picture.");
}

/// Draws the next few thumbnails if some of the scene's have not been drawn yet. `size`: of the large
/// picture.
void update_term_grid(TermGridState& grid, const Scene& scene, PictureSize size) {
    if (!grid.drawn_of || !(*grid.drawn_of == scene)) {
        if (ImGui::IsAnyMouseDown()) return;  // waits until no mouse button is down
        begin_sheet(grid, scene, size);
    }
    const std::vector<GridCell> cells = grid_cells(scene);
    if (grid.next >= cells.size()) return;
    if (!grid.renderer) grid.renderer = std::make_unique<Renderer>(1);
    const auto start = std::chrono::steady_clock::now();
    const auto spent = [start] {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    };
    try {
        do draw_cell(grid, scene, cells[grid.next++]);
        while (grid.next < cells.size() && spent() < budget_ms);
    } catch (...) {
        grid.next = cells.size();  // the others would fail for the same reason
        throw;
    }
    if (grid.next < cells.size()) redraw_within(0);
}

}  // namespace

std::vector<GridCell> grid_cells(const Scene& scene) {
    std::vector<GridCell> cells{{-1, 0}, {-1, 1}};
    for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i)
        for (int term = 0; term < 3; ++term) cells.push_back({i, term});
    return cells;
}

Scene with_cells(const Scene& scene, const std::vector<GridCell>& shown) {
    Scene s = scene;
    std::vector<bool> is_shown(2 + 3 * s.lights.size());
    for (const GridCell cell : shown)
        if (index_of(cell) < is_shown.size()) is_shown[index_of(cell)] = true;
    if (!is_shown[0])
        for (Object& object : s.objects) object.material.emission = glm::vec3(0);
    if (!is_shown[1]) s.global_ambient = glm::vec3(0);
    for (int i = 0; i < static_cast<int>(s.lights.size()); ++i) {
        Light& light = s.lights[static_cast<std::size_t>(i)];
        if (!is_shown[index_of({i, 0})]) light.ambient = glm::vec3(0);
        if (!is_shown[index_of({i, 1})]) light.diffuse = glm::vec3(0);
        if (!is_shown[index_of({i, 2})]) light.specular = glm::vec3(0);
    }
    return s;
}

int gain_of(const Renderer& drawn_by, const Picture& drawn, float exposure) {
    std::vector<float> lit;
    for (int y = 0; y < drawn.size.height; ++y)
        for (int x = 0; x < drawn.size.width; ++x) {
            if (drawn_by.object_at(x, y) < 0) continue;
            const glm::vec3 c = exposure * drawn.linear_at(x, y);
            if (const float most = std::max({c.x, c.y, c.z}); most > 0) lit.push_back(most);
        }
    if (lit.empty()) return 0;
    const auto bright = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) * 19 / 20);
    std::nth_element(lit.begin(), bright, lit.end());
    int gain = 1;
    while (gain < 16 && 2 * float(gain) * *bright <= 1) gain *= 2;
    return gain;
}

Scene brightened(Scene scene, int gain) {
    const auto times = static_cast<float>(std::max(gain, 1));
    scene.display.exposure *= times;
    scene.display.background /= times;
    return scene;
}

void term_grid_tab(UiState& state, const PictureView& view) {
    TermGridState& grid = state.get<TermGridState>();
    if (!has_turn(state, inspector_feature))
        return wrapped_dim(
            "While the picture is frozen or an animation is playing, the cells cannot be changed.");
    const std::optional<OtherScene> other = resting_below(state, inspector_feature);
    const Scene& scene = other ? other->scene : state.editor.scene();
    if (other) small_dim(fmt::format("For {}.", other->name));
    update_term_grid(grid, scene, view.map.size);
    sum_note(scene);
    std::optional<GridCell> pointed;
    grid.rows.draw(static_cast<int>(scene.lights.size()) + 1, [&](int row) {
        if (const auto cell = cell_row(grid, scene, row - 1)) pointed = cell;
    });
    std::optional<GridCell> alone = grid.solo;
    if (alone && alone->light >= static_cast<int>(scene.lights.size()))
        alone.reset();  // B may have fewer lights
    if (pointed) alone = pointed;
    if (!alone && grid.muted.empty()) return;
    std::vector<GridCell> shown, left_out;
    for (const GridCell cell : grid_cells(scene)) {
        const bool is_shown = alone ? cell == *alone : !is_among(grid.muted, cell);
        (is_shown ? shown : left_out).push_back(cell);
    }
    const std::string name = alone                  ? "Only " + label_of(scene, *alone)
                             : left_out.size() == 1 ? "Without " + label_of(scene, left_out.front())
                                                    : fmt::format("Without {} terms", left_out.size());
    show_instead(state, with_cells(scene, shown), name, !pointed);
}

extern const Feature term_grid_feature;
const Feature term_grid_feature{
    .sheet = [](UiState& s) { return &s.get<TermGridState>().sheet; },
    .follow =
        [](UiState& s, const ItemPlaces& places) {
            TermGridState& grid = s.get<TermGridState>();
            if (grid.solo && !places.follow_light(grid.solo->light)) grid.solo.reset();
            std::erase_if(grid.muted, [&](GridCell& cell) { return !places.follow_light(cell.light); });
        }};

}  // namespace glint
