#include "ui/features/inspector/inspector.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "renderer/explain/equation_text.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/inspector/equation/equation_tab.h"
#include "ui/features/inspector/mistake_row.h"
#include "ui/features/inspector/outside_view.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/features/plots/plot.h"
#include "ui/features/views/term_grid.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/picture_notes.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {

extern const Feature inspector_feature;

const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation) {
    if (!explanation.lit_per_corner || explanation.corners.empty()) return explanation.at;
    const auto last = static_cast<int>(explanation.corners.size()) - 1;
    return explanation.corners[static_cast<std::size_t>(std::clamp(state.corner, 0, last))].at;
}

const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point) {
    const auto find = [&](int index) {
        return std::find_if(point.lights.begin(), point.lights.end(),
                            [index](const ExplainedLight& light) { return light.index == index; });
    };
    if (point.lights.empty()) return nullptr;
    if (const auto it = find(state.get<InspectorState>().pointed_light); it != point.lights.end())
        return &*it;
    const Selection& selection = state.editor.selection;
    if (selection.kind == Selection::Kind::Light)
        if (const auto it = find(selection.index); it != point.lights.end()) return &*it;
    const auto adds = [](const ExplainedLight& light) {
        const glm::vec3 share = added_by(light);
        return share.x + share.y + share.z;
    };
    return &*std::max_element(
        point.lights.begin(), point.lights.end(),
        [&](const ExplainedLight& a, const ExplainedLight& b) { return adds(a) < adds(b); });
}

Scene with_term_alone(Scene scene, Symbol term) {
    scene.shading.terms = {term == Symbol::Emission, term == Symbol::Ambient, term == Symbol::Diffuse,
                           term == Symbol::Specular};
    return scene;
}

void show_instead(UiState& state, const Scene& scene, const std::string& name, bool rests) {
    if (same_description(scene, state.editor.scene())) return;  // a click has just applied `scene`
    if (!has_turn(state, inspector_feature)) return;
    InspectorState& inspector = state.get<InspectorState>();
    inspector.instead = scene;
    inspector.instead_rests = rests;
    inspector.preview_name = name;
}

Scene with_light_alone(Scene scene, int light) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        scene.lights[i].enabled = static_cast<int>(i) == light;
    scene.global_ambient = glm::vec3(0);
    scene.shading.terms.emission = false;
    return scene;
}

extern const Feature inspector_feature;
namespace {

/// Stops showing single terms or a preview in place of the picture.
void end_cells(UiState& state) {
    state.get<TermGridState>().solo.reset();
    state.get<TermGridState>().muted.clear();
    state.get<InspectorState>().instead.reset();
}

constexpr std::array tabs{
    InspectorTabInfo{InspectorTab::Equation, "Equation",
                     "The lighting equation at the picked pixel, with its numbers", equation_tab,
                     TabScene::Asked, true},
    InspectorTabInfo{InspectorTab::Vectors, "Vectors",
                     "n, l, v, r and h at the picked point, and the facet's own normal", vectors_tab,
                     TabScene::Asked, true},
    InspectorTabInfo{InspectorTab::Mistakes, "Mistakes",
                     "Mistakes that people really make, each with a switch", mistakes_tab, TabScene::Edited,
                     true},
    InspectorTabInfo{InspectorTab::Models, "Shadings",
                     "The same pixel under flat, facet, Gouraud and Phong shading", models_tab,
                     TabScene::Edited, false, "models flat gouraud phong"},
    InspectorTabInfo{InspectorTab::MyPicture, "My picture",
                     "Mistakes in a picture of this scene that your own program drew", my_picture_tab},
    InspectorTabInfo{InspectorTab::Program, "Program",
                     "The OpenGL calls that draw this scene, with draggable numbers", program_tab,
                     TabScene::Edited, false, "opengl calls code gl"},
    InspectorTabInfo{InspectorTab::Plots, "Plots",
                     "Falloff, highlight, cone, lobes and microfacets as curves", plots_tab, TabScene::Asked,
                     false, "curves falloff lobes"},
    InspectorTabInfo{InspectorTab::Grid, "Light × term",
                     "Every term of every light as a small picture, to show alone or leave out",
                     term_grid_tab, TabScene::Shown},
    InspectorTabInfo{InspectorTab::Sensitivity, "Sensitivity",
                     "Every number, sorted by its effect on the pixel", sensitivity_tab},
    InspectorTabInfo{InspectorTab::Matrices, "Matrices",
                     "The view matrix, its inverse, the projection, and the point at each stage",
                     matrices_tab, TabScene::Asked, false, "transform projection spaces"},
    InspectorTabInfo{InspectorTab::Outside, "From outside",
                     "The eye, its view volume and the lights, seen from outside", outside_tab,
                     TabScene::Edited, false, "frustum view volume"},
};

/// The position of the heading's colour swatch.
struct Square {
    ImVec2 low;
    float edge;
    [[nodiscard]] ImVec2 high() const { return {low.x + edge, low.y + edge}; }
};

void nothing_picked(const Square& square) {
    ImGui::GetWindowDrawList()->AddRect(square.low, square.high(), to_u32(theme().line), px(4));
    ImGui::Dummy({square.edge, square.edge});
    ImGui::SameLine(0, px(10));
    dim_text("No pixel is picked");
}

/// Writes the parts that fit next to the close button; the position is always written.
void pixel_line(const std::string& what, const std::string& place, const std::string& bytes) {
    ImGui::PushFont(fonts().figures);
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - px(4);
    const auto fits = [room](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x <= room; };
    const std::string all = what + place + bytes, bare = place + bytes;
    ImGui::TextUnformatted((fits(all) ? all : fits(bare) ? bare : place).c_str());
    ImGui::PopFont();
}

void picked(UiState& state, const Explanation& explanation, const Square& square) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto [r, g, b] = explanation.byte;
    list.AddRectFilled(square.low, square.high(), IM_COL32(r, g, b, 255), px(4));
    list.AddRect(square.low, square.high(), to_u32(theme().line), px(4));
    ImGui::Dummy({square.edge, square.edge});
    tooltip("Colour", "As on the screen: red, green, blue from 0 to 255",
            fmt::format("{} {} {}   #{:02x}{:02x}{:02x}", r, g, b, r, g, b));
    ImGui::SameLine(0, px(10));
    ImGui::BeginGroup();
    pixel_line(fmt::format("{} ", asks_at_cursor(state) ? "at the cursor" : "pixel"),
               fmt::format("{}, {}", state.on_screen.pixel.x, state.on_screen.pixel.y),
               fmt::format("   {} {} {}", r, g, b));
    if (explanation.hit) {
        const char* const side = explanation.front_facing ? "front side" : "back side";
        const float room = ImGui::GetContentRegionAvail().x - px(26) - ImGui::CalcTextSize(side).x - px(12);
        const std::string what =
            fmt::format("{}, face {}", whole_label(explanation.object), explanation.face);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const bool clicked = ImGui::Selectable("##object", false, 0, {room, 0});
        if (clicked && is_explained(state))
            state.editor.selection = {Selection::Kind::Object, explanation.object_index};
        tooltip("Object", is_explained(state) ? "Click to show its panel" : "In the scene on the screen",
                what);
        cut_text(list, at, at.x + room, what);
        ImGui::SameLine(0, px(12));
        coloured(is_plain_front(explanation) ? theme().dim_text : theme().warning, side);
        tooltip("Side", "Front: corners run counter-clockwise on the screen (clockwise on a mirrored object)",
                "Here: " + side_words(explanation));
    } else {
        dim_text("background");
    }
    ImGui::EndGroup();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, square.low.y});
    if (icon_button("##forget", Icon::Close)) ask_about(state.viewport, {});
    tooltip("Forget this pixel", "Click the picture to pick a different one");
}

/// Draws a swatch of the pixel's colour, its byte values, its position, and its object. A click on the object
/// selects it; a click on the close button clears the picked pixel. Without a picked pixel, a placeholder of
/// the same height keeps the tabs below from moving.
void heading(UiState& state) {
    const Square square{ImGui::GetCursorScreenPos(), 2 * ImGui::GetTextLineHeight() + px(6)};
    if (state.on_screen.explanation)
        picked(state, *state.on_screen.explanation, square);
    else
        nothing_picked(square);
    ImGui::SetCursorScreenPos({square.low.x, square.high().y + px(8)});
}

/// A button of the tab bar; the chosen one is underlined in the accent colour.
bool tab_button(const char* label, const char* what, bool chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? theme().field_active : theme().panel);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? theme().text : theme().dim_text);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, small_padding());
    const bool clicked = ImGui::Button(label);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    const auto [low, high] = last_item();
    if (chosen)
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - px(2)}, high, to_u32(theme().accent));
    tooltip(label, what);
    return clicked;
}

/// The less common tabs, behind a button that shows the name of the open one.
void more_tabs(InspectorState& inspector, float right) {
    const auto shown = std::find_if(tabs.begin(), tabs.end(), [&](const InspectorTabInfo& info) {
        return info.tab == inspector.tab && !info.is_first;
    });
    const bool is_one = shown != tabs.end();
    const std::string label = fmt::format("{} ▾", is_one ? shown->label : "More");
    same_line_if_fits(ImGui::CalcTextSize(label.c_str()).x + px(12), px(1), right);
    if (tab_button(label.c_str(),
                   is_one ? shown->what : "Shadings, curves, each light's terms, sensitivity, matrices",
                   is_one))
        ImGui::OpenPopup("##more");
    if (!ImGui::BeginPopup("##more")) return;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6), px(5)});
    for (const InspectorTabInfo& info : tabs) {
        if (info.is_first) continue;
        if (ImGui::Selectable(info.label, info.tab == inspector.tab)) inspector.tab = info.tab;
        tooltip(info.label, info.what);
    }
    ImGui::PopStyleVar();
    ImGui::EndPopup();
}

/// Draws the buttons in as many rows as needed.
void tab_bar(InspectorState& inspector) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(fonts().small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(1), px(1)});
    for (const InspectorTabInfo& info : tabs) {
        if (!info.is_first) continue;
        if (&info != &tabs.front())
            same_line_if_fits(ImGui::CalcTextSize(info.label).x + px(12), px(1), right);
        if (tab_button(info.label, info.what, inspector.tab == info.tab)) inspector.tab = info.tab;
    }
    more_tabs(inspector, right);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({low.x, low.y}, {right, low.y}, to_u32(theme().line));
    ImGui::Dummy({0, px(3)});
}

/// Draws a tab while the explanation belongs to a scene other than the edited one.
void draw_beside_other(UiState& state, const InspectorTabInfo& info, const PictureView& view) {
    const char* const which = state.on_screen.explained_other->name;
    if (info.scene == TabScene::Edited)
        wrapped_dim(fmt::format("The {} is from {}. The rest is about the edited scene.",
                                state.on_screen.explanation ? "pixel" : "picture", which));
    if (info.scene != TabScene::Asked) return info.draw(state, view);
    wrapped_dim(fmt::format("Numbers for {}: read-only.", which));
    ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1);  // the text should stay legible
    ImGui::BeginDisabled();
    info.draw(state, view);
    ImGui::EndDisabled();
    ImGui::PopStyleVar();
}

}  // namespace

std::span<const InspectorTabInfo> inspector_tabs() { return tabs; }

void inspector(UiState& state, const PictureView& view) {
    const std::optional<Symbol> pointed_vector =
        std::exchange(state.get<InspectorState>().pointed_vector, std::nullopt);
    const int pointed_light = std::exchange(state.get<InspectorState>().pointed_light, -1);
    heading(state);
    tab_bar(state.get<InspectorState>());
    for (const InspectorTabInfo& info : tabs) {
        if (info.tab != state.get<InspectorState>().tab) continue;
        ImGui::BeginChild(info.label);  // each tab has its own scroll position
        if (state.on_screen.explained_other)
            draw_beside_other(state, info, view);
        else
            info.draw(state, view);
        ImGui::EndChild();
    }
    if (pointed_vector != state.get<InspectorState>().pointed_vector ||
        pointed_light != state.get<InspectorState>().pointed_light)
        redraw_within(0);  // the picture's arrows were drawn earlier
}

void inspector_empty_state(const char* promise) {
    for (const char* text :
         {promise, "The pixel stays picked while you drag lights and sliders, and the numbers follow.",
          "Hold Alt to explain the pixel under the cursor without a click."}) {
        ImGui::Dummy({0, px(5)});
        wrapped_dim(text);
    }
}

namespace {

/// A preview on hover waits until the latest edit has been drawn and explained, because the numbers next to
/// it are those of the edited scene.
std::optional<OtherScene> show_listed(const UiState& state) {
    const InspectorState& inspector = state.get<InspectorState>();
    const bool is_explained = inspector.instead_rests || state.edited_drawn == state.editor.scene();
    if (!inspector.instead || !is_explained) return {};
    if (!inspector.instead_rests)
        return OtherScene{.scene = *inspector.instead,
                          .note = inspector.preview_name.empty() ? "" : "Preview: " + inspector.preview_name,
                          .passes = true};
    return OtherScene{.scene = *inspector.instead,
                      .name = "the cells that are shown",
                      .label = "The cells that are shown",
                      .note = inspector.preview_name,
                      .end = end_cells,
                      .is_partial = true,
                      .of_edited = !resting_below(state, inspector_feature)};
}

std::vector<WindowCommand> inspector_commands() {
    return {
        {.name = "Vectors at the picked point",
         .keys = {{Key::V}},
         .section = Section::InspectVectors,
         .run = [](UiState& s) { s.get<InspectorState>().shows_vectors ^= true; },
         .is_on = [](const UiState& s) { return s.get<InspectorState>().shows_vectors; }},
    };
}

std::string why_no_copy(const UiState& state) {
    const auto& explanation = state.on_screen.explanation;
    return explanation && explanation->hit ? "" : "Pick a pixel on an object first";
}

void add_entries(std::vector<PaletteEntry>& entries, UiState& state) {
    for (const InspectorTabInfo& info : tabs)
        entries.push_back({fmt::format("Why: {}", info.label), "Column", "", "",
                           [tab = info.tab](UiState& s) {
                               s.get<InspectorState>().tab = tab;
                               s.left_shows_inspector = s.layout.right = true;
                           },
                           info.words});
    for (const CopyFormat& format : copy_formats())
        entries.push_back({fmt::format("Copy the explanation as {}", format.label), "Action", "",
                           why_no_copy(state), [&format](UiState& s) {
                               // The pixel may have been cleared since the entry was made.
                               const std::string refused = why_no_copy(s);
                               if (!refused.empty()) return s.notifications.add(Tone::Warning, refused);
                               copy_explanation(s, format);
                           }});
}

/// Names the mistakes that are on; a click opens their tab. During a lesson's question this would reveal the
/// answer.
float mistakes_mark(UiState& state, ImVec2 right) {
    const std::string text = mistakes_text(state.editor.scene().shading.mistakes);
    if (text.empty() || is_held(state)) return 0;
    const float width = ImGui::CalcTextSize(text.c_str()).x, gap = px(14);
    ImGui::SetCursorScreenPos({right.x - width - gap, right.y});
    coloured(theme().warning, text);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked()) show_mistake(state);
    tooltip("Mistakes", "The picture is wrong on purpose; click to show the mistake", "",
            "/shading/mistakes");
    return width + gap;
}

std::optional<PictureNote> note_of_mistakes(const UiState& state, const Scene& scene) {
    const std::string text = mistakes_text(scene.shading.mistakes);
    if (text.empty()) return {};
    const MistakeEffect& effect = state.get<MistakeEffect>();
    return PictureNote{.kind = PictureNote::Kind::InScene,
                       .name = text,
                       .end = [](UiState& s) { s.editor.scene().shading.mistakes = {}; },
                       .remark = effect.is_none && effect.of == scene ? " (no effect here)" : ""};
}

}  // namespace

const Feature inspector_feature{.update =
                                    [](UiState& s) {  // hovering takes effect in the next frame
                                        s.get<InspectorState>().instead.reset();
                                        s.get<InspectorState>().preview_name.clear();
                                        trace_shown(s);
                                    },
                                .shows = show_listed,
                                .overlay =
                                    [](ImDrawList& list, UiState& s, const PictureView& view) {
                                        draw_traced(list, s, view);
                                        draw_point_vectors(list, s, view);
                                    },
                                .note = note_of_mistakes,
                                .why =
                                    [](UiState& s, const PictureView& view) {
                                        inspector(s, view);
                                        return true;
                                    },
                                .status = mistakes_mark,
                                .commands = inspector_commands,
                                .palette = add_entries,
                                .follow =
                                    [](UiState& s, const ItemPlaces& places) {
                                        auto& marked = s.get<InspectorState>().marked;
                                        if (marked && !places.follow_light(marked->light)) marked.reset();
                                    },
                                .leave_document =
                                    [](UiState& s, const SceneDocument& next) {
                                        if (is_another(s, next)) end_cells(s);
                                    },
                                .put_away = end_cells};

void BlocksInSight::begin(int count) {
    heights_.resize(static_cast<std::size_t>(count));
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const float low = list.GetClipRectMin().y, high = list.GetClipRectMax().y;
    // A margin on both sides lets the Tab key find the next field and scroll to it.
    low_ = low - (high - low) / 2, high_ = high + (high - low) / 2;
    top_ = ImGui::GetCursorScreenPos().y;
}

bool BlocksInSight::begin_block(int index, bool is_wanted) {
    const float height = heights_[static_cast<std::size_t>(index)];
    const float room = height > 0 ? height : lines_ * ImGui::GetTextLineHeightWithSpacing();
    const bool is_near = top_ <= high_ && top_ + room >= low_;
    if (!is_near && !is_wanted && index != held_) {
        top_ += room;
        return false;
    }
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, top_});
    ImGui::BeginGroup();
    return true;
}

void BlocksInSight::end_block(int index) {
    ImGui::EndGroup();
    if (ImGui::IsItemActive())
        held_ = index;
    else if (held_ == index)
        held_ = -1;
    const float below = ImGui::GetCursorScreenPos().y;
    heights_[static_cast<std::size_t>(index)] = below - top_;
    top_ = below;
}

void BlocksInSight::end() { ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, top_}); }

}  // namespace glint
