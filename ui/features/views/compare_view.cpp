#include "ui/features/views/compare_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/fields/choices.h"
#include "ui/features/views/small_pictures.h"
#include "ui/picture/tool.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Copies the pixels from `low` up to, but not including, `high` to the same position in another picture.
void copy_pixels(const Picture& from, Picture& to, glm::ivec2 low, glm::ivec2 high) {
    if (high.x <= low.x) return;
    const auto count = static_cast<std::ptrdiff_t>(high.x - low.x);
    for (int y = low.y; y < high.y; ++y) {
        const auto at = static_cast<std::ptrdiff_t>(to.pixel(low.x, y));
        std::copy_n(from.rgba.begin() + 4 * at, 4 * count, to.rgba.begin() + 4 * at);
        if (!to.linear.empty())
            std::copy_n(from.linear.begin() + 3 * at, 3 * count, to.linear.begin() + 3 * at);
    }
}

/// Draws the parts whose scenes have not been drawn yet.
void draw_parts(CompareState& state, const DrawnScene& drawn) {
    const CompareChoice& choice = state.choice;
    state.renderers.resize(choice.parts.size());
    state.refinements.resize(choice.parts.size());
    state.pictures.assign(choice.parts.size(), &drawn.picture);
    state.drawn_by.assign(choice.parts.size(), &drawn.renderer);
    state.ms = 0;
    for (std::size_t i = 0; i < choice.parts.size(); ++i) {
        if (choice.parts[i].kind == Variant::Kind::Mine && choice.mine) {
            state.fitted = fitted_picture(*choice.mine, drawn.scene, drawn.picture, choice.difference);
            state.pictures[i] = &state.fitted;
            continue;
        }
        const Scene scene = scene_under(choice.parts[i], drawn.scene, choice.stored.get());
        if (scene == drawn.scene) continue;
        if (!state.renderers[i]) state.renderers[i] = std::make_unique<Renderer>(drawn.threads);
        state.pictures[i] = &state.refinements[i].begin(*state.renderers[i], scene, drawn.picture.size,
                                                        !drawn.picture.linear.empty(), false);
        state.drawn_by[i] = state.renderers[i].get();
        state.ms += state.renderers[i]->stats().total_ms;
    }
}

void compose_difference(CompareState& state) {
    const Picture &first = *state.pictures.front(), &last = *state.pictures.back();
    const Result<Comparison> numbers = compare(first, last);
    if (const auto* found = std::get_if<Comparison>(&numbers)) state.numbers = *found;
    state.picture = difference_picture(first, last, state.choice.gain);
}

}  // namespace

int length_of(const CompareChoice& choice, PictureSize size) {
    return choice.stacked ? size.height : size.width;
}

int first_of(const CompareChoice& choice, int part, int length) {
    if (part <= 0) return 0;
    if (part >= static_cast<int>(choice.parts.size())) return length;
    const double share = choice.wipes[static_cast<std::size_t>(part - 1)];
    return static_cast<int>(std::round(std::clamp(share, 0.0, 1.0) * length));
}

int part_at(const CompareChoice& choice, int along, int length) {
    int part = 0;
    while (part + 1 < static_cast<int>(choice.parts.size()) && first_of(choice, part + 1, length) <= along)
        ++part;
    return part;
}

PartRect part_rect(const CompareChoice& choice, int part, PictureSize size) {
    const int length = length_of(choice, size);
    const int first = first_of(choice, part, length), end = first_of(choice, part + 1, length);
    return choice.stacked ? PartRect{{0, first}, {size.width, end}}
                          : PartRect{{first, 0}, {end, size.height}};
}

void borrow_comparison(CompareState& state) {
    if (state.borrowers++ == 0) state.own = state.choice;
}

void give_comparison_back(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (--state.borrowers > 0) return;
    const auto stored = choice.stored;
    choice = *std::exchange(state.own, std::nullopt);
    choice.stored = stored;
}

const Picture& compose(CompareState& state, const DrawnScene& drawn) {
    draw_parts(state, drawn);
    if (state.choice.difference) {
        compose_difference(state);
        return state.picture;
    }
    const PictureSize size = drawn.picture.size;
    state.picture.size = size;
    state.picture.rgba.resize(drawn.picture.rgba.size());
    state.picture.linear.resize(drawn.picture.linear.size());
    for (int part = 0; part < static_cast<int>(state.pictures.size()); ++part) {
        const PartRect rect = part_rect(state.choice, part, size);
        copy_pixels(*state.pictures[static_cast<std::size_t>(part)], state.picture, rect.low, rect.high);
    }
    return state.picture;
}

bool refine_parts(CompareState& state, Jobs& jobs, int threads, float& progress) {
    progress = 1;
    bool better = false;
    for (std::size_t i = 0; i < state.drawn_by.size(); ++i) {
        if (state.drawn_by[i] == nullptr || state.drawn_by[i] != state.renderers[i].get()) continue;
        better |= state.refinements[i].advance(*state.renderers[i], jobs, threads) != nullptr;
        progress = std::min(progress, state.refinements[i].progress());
    }
    return better;
}

void forget_parts(CompareState& state) {
    state.refinements.clear();
    state.drawn_by.clear();
    state.pictures.clear();
    state.renderers.clear();
    state.fitted = {};
    state.picture = {};
}

int part_of(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    if (!state.choice.on || state.choice.difference || state.picture.size != size) return -1;
    return part_at(state.choice, state.choice.stacked ? pixel.y : pixel.x, length_of(state.choice, size));
}

const Renderer* part_renderer(const CompareState& state, glm::ivec2 pixel, PictureSize size) {
    const auto part = static_cast<std::size_t>(part_of(state, pixel, size));  // -1 becomes the largest value
    return part < state.drawn_by.size() ? state.drawn_by[part] : nullptr;
}

std::vector<DrawnPart> drawn_parts(const CompareState& state, const Renderer& drawn, PictureSize size) {
    if (part_of(state, {0, 0}, size) < 0) return {{&drawn, {{0, 0}, {size.width, size.height}}, {}}};
    const CompareChoice& choice = state.choice;
    std::vector<DrawnPart> parts;
    for (int i = 0; i < static_cast<int>(choice.parts.size()); ++i) {
        const Variant variant = choice.parts[static_cast<std::size_t>(i)];
        if (variant.kind == Variant::Kind::Mine && choice.mine) continue;
        parts.push_back({state.drawn_by[static_cast<std::size_t>(i)], part_rect(choice, i, size), variant});
    }
    return parts;
}

// The comparison in the window: dragging its lines, its labels, and its controls in the row above the
// picture.

namespace {

constexpr double apart = 0.02;  // the smallest distance between lines, as a fraction of the length

/// The position of a line in the window: x, or y if the parts are stacked.
float line_at(const CompareChoice& choice, int wipe, const PictureView& view) {
    const int at = first_of(choice, wipe + 1, length_of(choice, view.map.size));
    const ImVec2 place = view.to_window({at, at});
    return choice.stacked ? place.y : place.x;
}

/// The part of the window that a part of the comparison covers.
Rect part_rect(const CompareChoice& choice, int part, const PictureView& view) {
    const PartRect rect = part_rect(choice, part, view.map.size);
    return {view.to_window(rect.low), view.to_window(rect.high)};
}

/// The position of a part's label: centred at the top of the part.
Rect label_rect(const CompareState& state, int part, const PictureView& view) {
    const Rect room = part_rect(state.choice, part, view);
    const float left = room.low.x, right = room.high.x;
    const std::string label = part_label(state, static_cast<std::size_t>(part));
    const ImVec2 text = fonts().small->CalcTextSizeA(small_text_height(), 1e9f, 0, label.c_str());
    const ImVec2 half{std::min(text.x / 2 + px(8), (right - left) / 2), text.y / 2 + px(4)};
    const ImVec2 middle{(left + right) / 2, room.low.y + px(8) + half.y};
    return {middle - half, middle + half};
}

void find_under(CompareState& state, const PictureView& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
        if (label_rect(state, i, view).holds(mouse)) state.label_under = i;
    if (state.label_under >= 0 || state.choice.difference) return;
    for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i)
        if (std::abs((state.choice.stacked ? mouse.y : mouse.x) - line_at(state.choice, i, view)) <=
            px(tool_line_reach))
            state.under = i;
}

void drag(CompareState& state, const PictureView& view) {
    std::vector<double>& wipes = state.choice.wipes;
    const auto i = static_cast<std::size_t>(state.dragged);
    const double low = i == 0 ? 0 : wipes[i - 1] + apart;
    const double high = i + 1 == wipes.size() ? 1 : wipes[i + 1] - apart;
    const glm::dvec2 at = view.to_pixel(ImGui::GetIO().MousePos);
    const double share = (state.choice.stacked ? at.y : at.x) / length_of(state.choice, view.map.size);
    wipes[i] = std::clamp(share, std::min(low, high), std::max(low, high));
}

void draw_wipe(ImDrawList& list, const CompareState& state, int wipe, const PictureView& view) {
    const bool stacked = state.choice.stacked;
    const Rect before = part_rect(state.choice, wipe, view);
    const ImVec2 end = before.high,
                 start = stacked ? ImVec2(before.low.x, end.y) : ImVec2(end.x, before.low.y);
    const ImVec2 middle = (start + end) / 2, way = stacked ? ImVec2(0, 1) : ImVec2(1, 0);
    const bool lit = state.under == wipe || state.dragged == wipe;
    const ImU32 white = to_u32({1, 1, 1, 1});
    cased_line(list, start, end, white, lit ? 1.8f : 1);
    rimmed_disc(list, middle, lit ? 8.5f : 6.5f, white);
    for (const float side : {-1.0f, 1.0f})  // the two directions in which the line can move
        arrow_head(list, middle + px(5) * side * way, side * way, 3.5f, 3.5f, to_u32({0.2f, 0.2f, 0.2f, 1}));
}

void draw_label(ImDrawList& list, const CompareState& state, int part, const PictureView& view) {
    const Rect rect = label_rect(state, part, view);
    badge_ground(list, rect, state.label_under == part);
    list.PushClipRect(rect.low, rect.high, true);
    const std::string label = part_label(state, static_cast<std::size_t>(part));
    list.AddText(fonts().small, small_text_height(), rect.low + px(1) * ImVec2(8, 4), to_u32(theme().text),
                 label.c_str());
    list.PopClipRect();
}

/// Draws a row of a list, disabled if `variant` has nothing to show. True when clicked.
bool variant_row(const CompareChoice& choice, const std::string& label, Variant variant, bool chosen) {
    const bool lacks_b = lacks_stored(choice, variant), lacks_mine = lacks_picture(choice, variant);
    const bool can = !lacks_b && !lacks_mine;
    const bool clicked = ImGui::Selectable(label.c_str(), chosen, can ? 0 : ImGuiSelectableFlags_Disabled);
    if (lacks_b) tooltip(label.c_str(), "Store a scene first", "", keys_of(CommandId::StoreB));
    if (lacks_mine) tooltip(label.c_str(), "Drop a picture onto the window first");
    return clicked;
}

void settings_popup(CompareState& state) {
    if (state.asked >= static_cast<int>(state.choice.parts.size())) state.asked = -1;
    if (!ImGui::BeginPopup("##part")) return;
    if (state.asked < 0) ImGui::CloseCurrentPopup();
    Variant::Kind last = Variant::Kind::Edited;
    for (const Variant& setting : all_variants()) {
        if (state.asked < 0) break;
        Variant& part = state.choice.parts[static_cast<std::size_t>(state.asked)];
        if (setting.kind != last) ImGui::Separator();
        last = setting.kind;
        if (variant_row(state.choice, label_of(setting), setting, part == setting)) part = setting;
    }
    ImGui::EndPopup();
}

/// Finds what can be dragged (lines) or clicked (labels).
bool compare_hover(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    state.under = state.label_under = -1;
    if (!state.choice.on || !frame.over) return false;
    find_under(state, frame.view);
    if (state.under >= 0)
        ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    if (state.label_under >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return state.under >= 0 || state.label_under >= 0;
}

int compare_press(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return not_taken;
    state.dragged = state.under;
    if (state.label_under >= 0) {
        state.asked = state.label_under;
        ImGui::OpenPopup("##part");
    }
    return state.dragged >= 0 ? ImGuiMouseButton_Left : not_taken;
}

bool compare_drag(ToolFrame& frame) {
    CompareState& state = frame.state.get<CompareState>();
    if (!state.choice.on || state.dragged >= static_cast<int>(state.choice.wipes.size())) {
        state.dragged = -1;
        return false;
    }
    drag(state, frame.view);
    ImGui::SetMouseCursor(state.choice.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    return true;
}

void compare_release(ToolFrame& frame) { frame.state.get<CompareState>().dragged = -1; }

std::string compare_hint(const UiState& ui) {
    const CompareState& state = ui.get<CompareState>();
    if (!state.choice.on) return {};
    if (state.under >= 0 || state.dragged >= 0) return "Drag the line";
    return state.label_under >= 0 ? "Click to choose what this part shows" : "";
}

/// Describes the difference picture, which may be entirely black.
void difference_caption(ImDrawList& list, const CompareState& state) {
    const CompareChoice& choice = state.choice;
    std::string what =
        fmt::format("|{} − {}|", part_label(state, 0), part_label(state, choice.parts.size() - 1));
    if (choice.gain > 1) what += fmt::format(" × {}", choice.gain);
    const std::string most = state.numbers.differing_pixels == 0
                                 ? "no pixel differs"
                                 : fmt::format("at most {} of 255", state.numbers.max_error);
    const char* const black = state.numbers.differing_pixels == 0 ? "" : ", black where they agree";
    ImGui::PushFont(fonts().small);
    // The text is shorter over a narrow picture.
    const Rect area = clip_area(list);
    const float room = area.size().x - px(20);
    std::string text = most;
    for (const std::string& longer :
         {fmt::format("{}: {}{}", what, most, black), fmt::format("{}: {}", what, most)})
        if (ImGui::CalcTextSize(longer.c_str()).x <= room) {
            text = longer;
            break;
        }
    (void)badge(list, area.top() + ImVec2(0, px(8)), text, {0.5f, 0});
    ImGui::PopFont();
}

struct Preset {
    const char* label;
    std::vector<Variant> parts;
};

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"Flat, Gouraud, Phong",
         {variant_of(ShadingMode::Flat), variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Gouraud, Phong", {variant_of(ShadingMode::Gouraud), variant_of(ShadingMode::Phong)}},
        {"Facet, Phong", {variant_of(ShadingMode::Facet), variant_of(ShadingMode::Phong)}},
        {"Phong, Blinn–Phong", {variant_of(Reflection::Phong), variant_of(Reflection::BlinnPhong)}},
        {"Local, with shadows, with bounces",
         {variant_of(TransportModel::Local), variant_of(TransportModel::Shadows),
          variant_of(TransportModel::Bounces)}},
        {"As edited, B", {{}, {Variant::Kind::Stored, 0}}},
        {"As edited, my picture", {{}, {Variant::Kind::Mine, 0}}}};
    return all;
}

void presets_popup(CompareChoice& choice) {
    if (small_button("Parts##presets")) ImGui::OpenPopup("##presets");
    tooltip("The compared variants", "Or click a label on the picture to change one part");
    ImGui::SameLine(0, px(4));
    if (!ImGui::BeginPopup("##presets")) return;
    for (const Preset& preset : presets()) {
        if (variant_row(choice, preset.label, preset.parts.back(), choice.parts == preset.parts))
            set_parts(choice, preset.parts);
    }
    ImGui::EndPopup();
}

/// Draws the button for the direction, which a difference does not use.
void direction_button(CompareChoice& choice) {
    if (small_chosen_button("Stacked", choice.stacked)) choice.stacked ^= true;
    tooltip("Stacked", "Places the parts one above the other instead of side by side");
}

void difference_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (small_button(fmt::format("×{}###gain", choice.gain).c_str())) double_gain(choice);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) choice.gain = std::max(choice.gain / 2, 1);
    tooltip("Scale of the difference", "Click: double, after ×64 back to ×1 · Right click: halve");
    ImGui::SameLine(0, px(8));
    const Comparison& n = state.numbers;
    mono_text(fmt::format("max {}  mean {:.2f}", n.max_error, (n.mean[0] + n.mean[1] + n.mean[2]) / 3));
    tooltip("How far apart",
            "Largest and mean difference between the first and the last part, in steps of 1/255",
            fmt::format("max {} {} {}\nmean {:.3f} {:.3f} {:.3f}\nroot mean square {:.3f} {:.3f} {:.3f}\n{} "
                        "pixels differ",
                        n.max[0], n.max[1], n.max[2], n.mean[0], n.mean[1], n.mean[2], n.rmse[0], n.rmse[1],
                        n.rmse[2], n.differing_pixels));
    ImGui::SameLine(0, px(4));
}

}  // namespace

const Tool compare_tool{compare_hover, compare_press, compare_drag, compare_release, compare_hint};

void draw_compare(ImDrawList& list, UiState& ui, const PictureView& view) {
    CompareState& state = ui.get<CompareState>();
    if (!state.choice.on) return;
    if (!state.choice.difference) {
        for (int i = 0; i < static_cast<int>(state.choice.wipes.size()); ++i) draw_wipe(list, state, i, view);
        for (int i = 0; i < static_cast<int>(state.choice.parts.size()); ++i)
            draw_label(list, state, i, view);
    }
    ui.label_height = small_text_height() + px(10);
    if (state.choice.difference) difference_caption(list, state);
    settings_popup(state);
}

void compare_controls(CompareState& state) {
    CompareChoice& choice = state.choice;
    if (!choice.on) return;
    presets_popup(choice);
    if (small_chosen_button("Difference", choice.difference)) choice.difference = !choice.difference;
    tooltip("Difference",
            (part_label(state, 0) + " against " + part_label(state, choice.parts.size() - 1)).c_str(),
            "Red, green and blue separately, of the displayed picture");
    ImGui::SameLine(0, px(4));
    const auto rest = [&] { choice.difference ? difference_controls(state) : direction_button(choice); };
    overflow("##compare", px(choice.difference ? 190 : 60), rest);
}

namespace {

template <class E> void add_variants(std::vector<Variant>& all, Variant::Kind kind) {
    for (std::size_t i = 0; i < count_of<E>(); ++i) all.push_back({kind, static_cast<int>(i)});
}

/// A choice that replaces the edited one, with the key of its field and the noun for its label.
struct NamedChoice {
    const char *field = "", *noun = "";
    const Choice* choice = nullptr;
};

/// Precondition: `variant` changes a choice.
NamedChoice choice_in(Variant variant) {
    const auto index = static_cast<std::size_t>(variant.index);
    switch (variant.kind) {
    case Variant::Kind::Edited:
    case Variant::Kind::Stored:
    case Variant::Kind::Mine:
        break;
    case Variant::Kind::Mode:
        return {"mode", "shading", &choices<ShadingMode>[index]};
    case Variant::Kind::Reflection:
        return {"reflection", "lighting", &choices<Reflection>[index]};
    case Variant::Kind::Interpolation:
        return {"interpolation", "interpolation", &choices<Interpolation>[index]};
    case Variant::Kind::LightPaths:
        return {"transport", "light", &choices<TransportModel>[index]};
    }
    return {};  // not reached
}

}  // namespace

Variant variant_of(ShadingMode mode) { return {Variant::Kind::Mode, static_cast<int>(mode)}; }

Variant variant_of(Reflection reflection) {
    return {Variant::Kind::Reflection, static_cast<int>(reflection)};
}

Variant variant_of(TransportModel model) { return {Variant::Kind::LightPaths, static_cast<int>(model)}; }

std::vector<Variant> all_variants() {
    std::vector<Variant> all{{}};
    add_variants<ShadingMode>(all, Variant::Kind::Mode);
    add_variants<Reflection>(all, Variant::Kind::Reflection);
    add_variants<Interpolation>(all, Variant::Kind::Interpolation);
    add_variants<TransportModel>(all, Variant::Kind::LightPaths);
    all.push_back({Variant::Kind::Stored, 0});
    all.push_back({Variant::Kind::Mine, 0});
    return all;
}

std::string word_of(Variant variant) {
    if (variant.kind == Variant::Kind::Edited) return "edited";
    if (variant.kind == Variant::Kind::Stored) return "stored";
    if (variant.kind == Variant::Kind::Mine) return "mine";
    const NamedChoice named = choice_in(variant);
    return std::string(named.field) + " " + std::string(named.choice->word);
}

std::optional<Variant> variant_named(const std::string& word) {
    for (const Variant& variant : all_variants())
        if (word_of(variant) == word) return variant;
    return {};
}

std::string label_of(Variant variant) {
    if (variant.kind == Variant::Kind::Edited) return "As edited";
    if (variant.kind == Variant::Kind::Stored) return "B, stored";
    if (variant.kind == Variant::Kind::Mine) return "My picture";
    const NamedChoice named = choice_in(variant);
    const std::string label = named.choice->label;
    // "Unlit" and "With shadows" are clear without the noun.
    const bool is_clear = variant == variant_of(Reflection::None) ||
                          (variant.kind == Variant::Kind::LightPaths && variant.index > 0);
    return is_clear ? label : label + " " + named.noun;
}

bool lacks_stored(const CompareChoice& choice, Variant variant) {
    return variant.kind == Variant::Kind::Stored && choice.stored == nullptr;
}

bool lacks_picture(const CompareChoice& choice, Variant variant) {
    return variant.kind == Variant::Kind::Mine && choice.mine == nullptr;
}

std::string part_label(const CompareState& state, std::size_t part) {
    const CompareChoice& choice = state.choice;
    const Variant variant = choice.parts[part];
    if (lacks_stored(choice, variant)) return "B: nothing stored";
    if (variant.kind == Variant::Kind::Edited && !state.resting.empty()) return state.resting;
    if (variant.kind == Variant::Kind::Mine && !state.label_of_mine.empty()) return state.label_of_mine;
    return lacks_picture(choice, variant) ? "My picture: not open" : label_of(variant);
}

Scene scene_under(Variant variant, const Scene& edited, const Scene* stored) {
    const auto index = static_cast<std::size_t>(variant.index);
    Scene scene = edited;
    switch (variant.kind) {
    case Variant::Kind::Edited:
    case Variant::Kind::Mine:
        break;
    case Variant::Kind::Mode:
        scene.shading.mode = static_cast<ShadingMode>(index);
        break;
    case Variant::Kind::Reflection:
        scene.shading.reflection = static_cast<Reflection>(index);
        break;
    case Variant::Kind::Interpolation:
        scene.shading.interpolation = static_cast<Interpolation>(index);
        break;
    case Variant::Kind::LightPaths:
        scene.transport.model = static_cast<TransportModel>(index);
        break;
    case Variant::Kind::Stored:
        if (stored == nullptr) break;
        scene = *stored;
        scene.camera = edited.camera;
        break;
    }
    return scene;
}

void set_parts(CompareChoice& choice, std::vector<Variant> parts) {
    choice.parts = std::move(parts);
    choice.wipes.clear();
    for (std::size_t i = 1; i < choice.parts.size(); ++i)
        choice.wipes.push_back(double(i) / double(choice.parts.size()));
}

}  // namespace glint
