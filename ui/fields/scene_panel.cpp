#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "models/numbers.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/picture/orbit.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/shortcut.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// Draws a row with an icon and a name; true when clicked. Leaves `reserve` free at its right end.
bool item_row(Icon icon, ImU32 colour, const char* name, bool selected, float indent, float reserve) {
    const float height = ImGui::GetFrameHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(name);
    const bool clicked = hit_area("##row", {width - reserve, height});
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    if (selected || hovered)
        list.AddRectFilled(low, {low.x + width, low.y + height},
                           to_u32(selected ? theme().accent : theme().field_hovered, selected ? 0.3f : 0.6f),
                           ImGui::GetStyle().FrameRounding);
    draw_icon(list, icon, {low.x + indent + 0.5f * height, low.y + 0.5f * height}, 0.58f * height, colour);
    const float right = low.x + width - reserve;
    const ImVec2 from{low.x + indent + 1.15f * height, low.y + ImGui::GetStyle().FramePadding.y};
    cut_text(list, from, right, name);
    if (from.x + ImGui::CalcTextSize(name).x > right) tooltip(name, "");
    return clicked;
}

/// Draws a row whose name is edited in place, until the field loses keyboard focus.
void typed_row(Icon icon, ImU32 colour, std::string& name, float indent, float reserve, LightFocus& focus) {
    const float height = ImGui::GetFrameHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    draw_icon(*ImGui::GetWindowDrawList(), icon, {low.x + indent + 0.5f * height, low.y + 0.5f * height},
              0.58f * height, colour);
    ImGui::Dummy({indent + 1.05f * height, height});
    ImGui::SameLine(0, 0);
    if (!focus.is_typed) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - reserve, px(20)));
    bare_name("##name", name, max_name_characters, ImGuiInputTextFlags_AutoSelectAll);
    if (focus.is_typed && !ImGui::IsItemActive()) focus.renamed = -1;
    focus.is_typed = ImGui::IsItemActive();
    list_control("Name in the list", "", last_item());
}

/// Draws the row of a light or an object. A click selects it, a double-click edits its name.
void named_row(Icon icon, ImU32 colour, std::string& name, Selection row, float reserve, Selection& selection,
               LightFocus& focus) {
    if (focus.renamed == number_of(row)) return typed_row(icon, colour, name, px(8), reserve, focus);
    if (item_row(icon, colour, whole_label(name).c_str(), selection == row, px(8), reserve)) selection = row;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        focus.renamed = number_of(row), focus.is_typed = false;
}

bool plain_row(Icon icon, const char* name, Selection::Kind kind, Selection& selection) {
    const bool clicked = item_row(icon, to_u32(theme().dim_text), name, selection.kind == kind, 0, 0);
    if (clicked) selection = {kind, 0};
    return clicked;
}

/// Draws the context menu of a row: duplicate or delete its item, show a light alone or leave it out. True if
/// the list has changed.
bool row_menu(Scene& scene, Selection& selection, Selection row, LightFocus* focus = nullptr) {
    const std::size_t items = scene.lights.size() + scene.objects.size();
    if (!ImGui::BeginPopupContextItem("##menu")) return false;
    selection = row;
    if (focus != nullptr) {
        if (ImGui::MenuItem("Solo", "S", focus->solo == row.index)) focus->toggle_solo(row.index);
        if (ImGui::MenuItem("Mute", "M", !focus->shows(row.index))) focus->toggle_muted(row.index);
        ImGui::Separator();
    }
    if (ImGui::MenuItem("Duplicate", keys_of(CommandId::Duplicate).c_str())) duplicate(scene, selection);
    if (ImGui::MenuItem("Delete", keys_of(CommandId::Delete).c_str())) remove(scene, selection);
    ImGui::EndPopup();
    return scene.lights.size() + scene.objects.size() != items;
}

/// Draws the eye at the right end of a row, which is open while the row's item is visible in the picture.
bool eye_button(bool& open, const char* state, const char* what, const std::string& pointer) {
    ImGui::SameLine(0, 0);
    const bool pressed = icon_button("##eye", open ? Icon::Eye : Icon::EyeOff);
    tooltip(state, what, "", pointer);
    if (pressed) open = !open;
    return pressed;
}

/// Draws the eye of a light, which is also closed while another light is shown alone. A click then shows the
/// light again.
void light_eye(Light& light, int index, LightFocus& focus) {
    const bool shown = focus.shows(index);
    const char* const state = focus.solo == index ? "Solo" : !shown ? "Muted" : light.enabled ? "On" : "Off";
    bool open = light.enabled && shown;
    const bool pressed = eye_button(open, state, "Whether this light shines. Alt+click: this light alone",
                                    "/lights/" + std::to_string(index) + "/enabled");
    if (!pressed) return;
    if (ImGui::GetIO().KeyAlt)
        focus.toggle_solo(index);
    else if (!shown)
        focus = {};
    else
        light.enabled = !light.enabled;
}

void space_button(Light& light, const Camera& camera) {
    const bool world = light.space == LightSpace::World;
    const float size = ImGui::GetFrameHeight();
    const bool pressed = hit_area("##space", {size, size});
    const ImVec2 low = ImGui::GetItemRectMin();
    const char* letter = world ? "W" : "C";
    const ImVec2 text = ImGui::CalcTextSize(letter);
    ImGui::GetWindowDrawList()->AddText({low.x + (size - text.x) / 2, low.y + (size - text.y) / 2},
                                        to_u32(ImGui::IsItemHovered() ? theme().text : theme().dim_text),
                                        letter);
    tooltip(
        world ? "World light" : "Camera light",
        world ? "Fixed in the world. Click: attach it to the camera at its current position"
              : "Attached to the camera. Click: fix it in the world at its current position",
        "Alt+click: keep its coordinates; the light jumps to that position in the other coordinate system");
    const LightSpace other = world ? LightSpace::Camera : LightSpace::World;
    if (pressed && ImGui::GetIO().KeyAlt)
        light.space = other;
    else if (pressed)
        light = in_space(light, other, camera);
}

/// Draws a warning mark at the right end of the row drawn last.
void warning_mark(const std::string& why) {
    const Rect row = last_item();
    const ImVec2 size = ImGui::CalcTextSize("!");
    const ImVec2 at{row.high.x - size.x - px(6), row.middle().y - size.y / 2};
    ImGui::GetWindowDrawList()->AddText(at, to_u32(theme().warning), "!");
    const Rect area{at - px(1) * ImVec2(6, 4), at + size + px(1) * ImVec2(6, 4)};
    if (ImGui::IsMouseHoveringRect(area.low, area.high)) tooltip("Light without effect", why.c_str());
    list_control("Light without effect", why, area);
}

/// Draws a light's row. The row's menu may change the list.
void light_row(Scene& scene, int index, Selection& selection, LightFocus& focus) {
    Light& light = scene.lights[static_cast<std::size_t>(index)];
    const Selection row{Selection::Kind::Light, index};
    const float size = ImGui::GetFrameHeight();
    ImGui::PushID(index);
    const ImVec2 low = ImGui::GetCursorScreenPos(),
                 high = low + ImVec2(ImGui::GetContentRegionAvail().x, size);
    const ImU32 colour = to_u32(legible(colour_of(light)), light.enabled && focus.shows(index) ? 1 : 0.4f);
    named_row(icon_of(light.kind), colour, light.name, row, 2 * size, selection, focus);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high)) focus.hovered = index;
    const auto which = static_cast<std::size_t>(index);
    if (which < focus.warnings.size() && !focus.warnings[which].empty()) warning_mark(focus.warnings[which]);
    if (!row_menu(scene, selection, row, &focus)) {
        ImGui::SameLine(0, 0);
        space_button(light, scene.camera);
        light_eye(light, index, focus);
    }
    ImGui::PopID();
}

void add_light_menu(Scene& scene, Selection& selection) {
    if (!ImGui::BeginPopup("##add-light")) return;
    for (const LightKind kind : enumerators<LightKind>) {
        const Choice choice = choice_of(kind);
        const std::string keys = kind == LightKind::Point ? keys_of(CommandId::AddLight) : "";
        if (ImGui::MenuItem(choice.label, keys.c_str())) (void)add_light(scene, selection, kind);
        tooltip(choice.label, choice.meaning);
    }
    ImGui::EndPopup();
}

void add_object_menu(Scene& scene, Selection& selection, bool& browse_mesh) {
    if (!ImGui::BeginPopup("##add-object")) return;
    if (ImGui::MenuItem("Mesh file…")) browse_mesh = true;
    ImGui::Separator();
    for (const Primitive primitive : enumerators<Primitive>)
        if (ImGui::MenuItem(choice_of(primitive).label))
            (void)add_object(scene, selection, default_mesh(primitive));
    ImGui::EndPopup();
}

/// Draws a heading with a plus button at its right end, and to the left of that a button for light setups.
void list_heading(const char* title, const char* popup, bool full, bool* asks_sets = nullptr) {
    const float size = ImGui::GetFrameHeight();
    ImGui::AlignTextToFramePadding();
    dim_text(title);
    if (asks_sets != nullptr) {
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 2 * size);
        if (icon_button("##sets", Icon::More)) *asks_sets = true;
        tooltip("Light setups", "Three-point, rim and others, previewed in the picture; your own presets");
    }
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - size);
    ImGui::BeginDisabled(full);
    if (icon_button(popup, Icon::Plus)) ImGui::OpenPopup(popup);
    ImGui::EndDisabled();
    tooltip("Add", full ? is_full : "Add one to the scene");
}

void object_row(Scene& scene, int index, Selection& selection, LightFocus& focus) {
    const Selection row{Selection::Kind::Object, index};
    Object& object = scene.objects[static_cast<std::size_t>(index)];
    ImGui::PushID(static_cast<int>(max_lights) + index);
    named_row(Icon::Object, to_u32(theme().dim_text, object.visible ? 1 : 0.4f), object.name, row,
              ImGui::GetFrameHeight(), selection, focus);
    if (!row_menu(scene, selection, row))
        (void)eye_button(object.visible, object.visible ? "Shown" : "Hidden", "Whether this object is drawn",
                         "/objects/" + std::to_string(index) + "/visible");
    ImGui::PopID();
}

float row_step() { return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y; }

/// Scrolls just far enough to make a row visible; the list begins at the cursor.
void scroll_to_row(int index) {
    const float low = ImGui::GetCursorPosY() + static_cast<float>(index) * row_step();
    const float high = low + row_step(), sight = ImGui::GetWindowHeight();
    if (low < ImGui::GetScrollY()) ImGui::SetScrollY(low);
    if (high > ImGui::GetScrollY() + sight) ImGui::SetScrollY(high - sight);
}

/// Draws the visible rows. If a row changes the list, no further row is drawn in this frame.
template <class Item, class DrawRow> void rows(const std::vector<Item>& items, DrawRow draw_row) {
    const std::size_t count = items.size();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), row_step());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd && items.size() == count; ++i) draw_row(i);
}

}  // namespace

void LightFocus::toggle_solo(int light) {
    solo = solo == light ? -1 : light;
    muted.clear();
}

void LightFocus::toggle_muted(int light) {
    solo = -1;
    if (std::erase(muted, light) == 0) muted.push_back(light);
}

void scene_panel(Scene& scene, Selection& selection, LightFocus& focus, bool& browse_mesh) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, px(1)});
    // Scrolls to an item that was selected elsewhere: in the picture or with keys.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const int before = std::exchange(*storage.GetIntRef(ImGui::GetID("shown"), -1), number_of(selection));
    const bool is_other = before != number_of(selection);
    plain_row(Icon::Camera, "Camera", Selection::Kind::Camera, selection);
    plain_row(Icon::Shading, "Shading", Selection::Kind::Shading, selection);
    plain_row(Icon::Display, "Display", Selection::Kind::Display, selection);
    list_heading("Lights", "##add-light", scene.lights.size() >= max_lights, &focus.asks_setups);
    add_light_menu(scene, selection);
    if (is_other && selection.kind == Selection::Kind::Light) scroll_to_row(selection.index);
    rows(scene.lights, [&](int i) { light_row(scene, i, selection, focus); });
    if (scene.lights.empty())
        dim_text(("   No light yet: press + or " + keys_of(CommandId::AddLight)).c_str());
    list_heading("Objects", "##add-object", scene.objects.size() >= max_objects);
    add_object_menu(scene, selection, browse_mesh);
    if (is_other && selection.kind == Selection::Kind::Object) scroll_to_row(selection.index);
    rows(scene.objects, [&](int i) { object_row(scene, i, selection, focus); });
    if (scene.objects.empty()) dim_text("   Nothing to light yet: press +");
    ImGui::PopStyleVar();
    selection = valid_selection(selection, scene);
}

// The panels of the items that a scene has exactly one of: camera, shading, display.

namespace {

/// Returns half the height of the view, one unit in front of the eye or, for an orthographic view, at the
/// target.
double half_height(const Camera& camera) {
    if (const auto* p = std::get_if<Perspective>(&camera.projection))
        return std::tan(p->fov_y_deg / 2 * degree);
    if (const auto* o = std::get_if<Orthographic>(&camera.projection))
        return o->height / 2 / std::max(target_depth(camera), 1e-6);
    const auto& f = std::get<Frustum>(camera.projection);
    return std::abs(f.top - f.bottom) / 2 / f.near;
}

/// Draws six buttons, each for a view of the target from one side.
void look_from(Camera& camera) {
    static constexpr struct {
        const char* label;
        CommandId command;
        ViewFrom from;
    } sides[] = {
        {"Front", CommandId::ViewFront, ViewFrom::Front}, {"Right", CommandId::ViewRight, ViewFrom::Right},
        {"Above", CommandId::ViewTop, ViewFrom::Top},     {"Behind", CommandId::ViewBack, ViewFrom::Back},
        {"Left", CommandId::ViewLeft, ViewFrom::Left},    {"Below", CommandId::ViewBottom, ViewFrom::Bottom}};
    section_heading("Look from");
    const float gap = px(3), width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (int i = 0; i < 6; ++i) {
        if (i % 3 != 0) ImGui::SameLine(0, gap);
        if (ImGui::Button(sides[i].label, {width, 0})) camera = seen_from(camera, sides[i].from);
        tooltip(sides[i].label, "Views the target from this side, at the same distance", "",
                keys_of(sides[i].command));
    }
}

}  // namespace

void note_fitted(const Camera& camera, PictureSize size) {
    const Projection drawn = fitted(camera.projection, size);
    if (drawn == camera.projection) return;
    if (const auto* p = std::get_if<Perspective>(&drawn))
        wrapped_dim(fmt::format(
            "Drawn with {:.1f}° to keep the view's width, because the picture is narrower than 16:9",
            p->fov_y_deg));
    else if (const auto* o = std::get_if<Orthographic>(&drawn))
        wrapped_dim(fmt::format(
            "Drawn {:.3g} high to keep the view's width, because the picture is narrower than 16:9",
            o->height));
}

Projection as_projection(const Camera& camera, ProjectionKind kind, PictureSize size) {
    // A frustum is not widened for a narrow picture, so switching to or from it converts the visible region.
    const bool is_frustum = kind == ProjectionKind::Frustum;
    const bool was_frustum = kind_of(camera.projection) == ProjectionKind::Frustum;
    const double aspect = static_cast<double>(size.width) / size.height;
    Camera shown = camera;
    if (is_frustum) shown.projection = fitted(camera.projection, size);
    const bool will_be_widened = was_frustum && !is_frustum && is_widened(size);
    const double half = half_height(shown) * (will_be_widened ? aspect / composed_aspect : 1);
    const float near = near_of(camera.projection), far = far_of(camera.projection);
    if (kind == ProjectionKind::Perspective)
        return Perspective{std::clamp(static_cast<float>(2 * std::atan(half) / degree), 0.1f, 179.0f), near,
                           far};
    if (kind == ProjectionKind::Orthographic)
        return Orthographic{static_cast<float>(2 * half * target_depth(camera)), near, far};
    const auto top = static_cast<float>(half * near), right = static_cast<float>(half * near * aspect);
    return Frustum{-right, right, -top, top, near, far};
}

namespace {

/// Draws the fields of the projection with the values in effect: a narrow picture shows more above and below
/// than the stored values say.
void projection_fields(Projection& written, PictureSize size) {
    Projection drawn = fitted(written, size);
    const Projection before = drawn;
    std::visit([](auto& projection) { field_rows(projection, "/camera/projection"); }, drawn);
    if (before == written) {
        written = drawn;
        return;
    }
    const bool edited = !(drawn == before);
    const double share =
        double(size.width) / size.height / composed_aspect;  // as a fraction of the drawn height
    if (auto* p = std::get_if<Perspective>(&drawn)) {
        const double half = std::tan(p->fov_y_deg / 2 * degree) * share;
        const auto in_wide = static_cast<float>(2 * std::atan(half) / degree);
        small_dim(fmt::format("{:.1f}° in a 16:9 picture of the same width", in_wide));
        p->fov_y_deg = in_wide;
    } else if (auto* o = std::get_if<Orthographic>(&drawn)) {
        o->height = static_cast<float>(o->height * share);
    }
    if (edited) written = drawn;
}

}  // namespace

void camera_panel(Camera& camera, PictureSize size) {
    FieldPanel panel(camera, "/camera");
    panel.draw({"eye", "target"});
    look_from(camera);
    section_heading("Projection");
    ProjectionKind kind = kind_of(camera.projection);
    if (choice_field("Kind", kind, {"How the view volume is projected", "/camera/projection/type"}))
        camera.projection = as_projection(camera, kind, size);
    projection_fields(camera.projection, size);
    if (fold("Advanced", camera.up != Camera{}.up, field_is_asked_below("/camera"))) panel.rest();
}

void shading_panel(Shading& shading, Transport& transport, glm::vec3& global_ambient) {
    static const Shading usual;
    FieldPanel panel(shading, "/shading");
    panel.draw({"mode", "reflection"});
    FieldPanel paths(transport, "/transport");
    paths.draw({"model"});
    const bool bounces = transport.model == TransportModel::Bounces;
    if (bounces || field_is_asked_below("/transport")) paths.rest();
    panel.group("terms", shading.terms, field_rows<Terms>);
    const Help help{"Ambient light from all directions, independent of the lights", "/global_ambient"};
    draw_asked(help.pointer, Typed::Number,
               [&] { colour_field("Global", global_ambient, Scene{}.global_ambient, help); });
    const bool asked = field_is_asked_below("/shading");
    const bool is_usual = shading.cull == usual.cull && !shading.two_sided && shading.local_viewer &&
                          shading.rules == usual.rules && shading.flat_point == usual.flat_point &&
                          shading.power_table == usual.power_table &&
                          shading.interpolation == usual.interpolation;
    if (fold("Advanced", !is_usual, asked)) panel.rest();
}

void display_panel(Display& display) {
    FieldPanel(display, "/display").draw({"exposure", "transfer"}).rest();
}

void npr_panel(Npr& npr) {
    FieldPanel panel(npr, "/npr");
    const bool asked = field_is_asked_below("/npr");
    if (fold("Cool to warm", npr.cool_to_warm, asked))
        panel.draw({"cool_to_warm", "cool", "warm", "alpha", "beta"});
    else
        panel.skip("cool_to_warm").skip("cool").skip("warm").skip("alpha").skip("beta");
    if (fold("Strokes", npr.silhouettes || npr.creases, asked)) panel.rest();
}

}  // namespace glint
