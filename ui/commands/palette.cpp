#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/problem.h"
#include "models/scene/mistakes.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/document/loading.h"
#include "ui/document/scene_edit.h"
#include "ui/feature.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_handles.h"
#include "ui/ui.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

constexpr int rows_shown = 11;

/// The rank of an entry; lower is better. The text may match its name, the beginning of a search term, or its
/// name together with its group.
std::optional<int> rank_of(const PaletteEntry& entry, const std::string& text) {
    const std::optional<int> by_name = match_rank(text, entry.name);
    if (by_name && *by_name <= 2) return by_name;
    if (match_rank(text, entry.words).value_or(3) <= 2) return 3;
    if (by_name) return *by_name + 1;
    if (match_rank(text, entry.name + " " + entry.group).value_or(4) <= 3) return 6;
    return {};
}

/// Draws an entry; true when clicked.
bool entry_row(const PaletteEntry& entry, bool chosen, int index) {
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushID(index);
    const bool clicked = hit_area("##entry", {width, height});
    if (ImGui::IsItemHovered() && !entry.refused.empty()) tooltip(entry.name.c_str(), entry.refused.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || ImGui::IsItemHovered())
        list.AddRectFilled(low, {low.x + width, low.y + height},
                           to_u32(chosen ? theme().field_active : theme().field), px(4));
    const float y = low.y + (height - ImGui::GetTextLineHeight()) / 2;
    const bool possible = entry.refused.empty();
    list.AddText({low.x + px(8), y}, to_u32(possible ? theme().text : theme().disabled_text),
                 entry.name.c_str());
    const std::string note = possible ? entry.group : entry.refused;
    const float keys_width = entry.keys.empty() ? 0 : ImGui::CalcTextSize(entry.keys.c_str()).x + px(14);
    const float note_width = ImGui::CalcTextSize(note.c_str()).x;
    const float right = low.x + width - px(8);
    const float name_end = low.x + px(20) + ImGui::CalcTextSize(entry.name.c_str()).x;
    if (right - keys_width - note_width > name_end)
        list.AddText({right - keys_width - note_width, y}, to_u32(theme().dim_text), note.c_str());
    if (!entry.keys.empty())
        list.AddText({right - keys_width + px(14), y}, to_u32(theme().accent), entry.keys.c_str());
    ImGui::PopID();
    return clicked;
}

/// Draws the visible rows, and also the chosen one if it has to be scrolled into view. Returns the index of
/// the clicked entry, or -1.
int entry_rows(const PaletteState& state, bool shows_chosen) {
    int clicked = -1;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(1)});
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(state.matches.size()), ImGui::GetFrameHeight() + px(1));
    if (shows_chosen) rows.ForceDisplayRangeByIndices(state.chosen, state.chosen + 1);
    while (rows.Step())
        for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
            const int index = state.matches[static_cast<std::size_t>(i)];
            if (entry_row(state.entries[static_cast<std::size_t>(index)], i == state.chosen, i))
                clicked = index;
            if (shows_chosen && i == state.chosen) ImGui::SetScrollHereY(0.5f);
        }
    ImGui::PopStyleVar();
    return clicked;
}

/// Draws the list. Returns the index of the confirmed entry, or -1.
int entry_list(PaletteState& state, const UiInput& input) {
    if (state.matches.empty())
        wrapped_dim(
            fmt::format("Nothing matches “{}”. The search covers commands, fields, scenes and lessons",
                        shortened(state.text)));
    const int before = state.chosen, count = static_cast<int>(state.matches.size());
    const int shown = std::clamp(count, 1, rows_shown);
    const bool entered = choose_by_keys(state.chosen, count, 1, input) && !state.takes_keyboard;
    ImGui::BeginChild("##entries", {0, static_cast<float>(shown) * (ImGui::GetFrameHeight() + px(1))});
    const int clicked = entry_rows(state, state.chosen >= 0 && state.chosen != before);
    ImGui::EndChild();
    if (clicked >= 0 || !entered) return clicked;
    return state.matches[static_cast<std::size_t>(state.chosen)];
}

void run_entry(UiState& state, int index) {
    const PaletteEntry entry = state.palette.entries[static_cast<std::size_t>(index)];
    if (!entry.refused.empty()) return state.notifications.add(Tone::Warning, entry.refused);
    state.palette.open = false;
    entry.run(state);
}

/// ImGui focuses a field two frames after the request, and drops letters typed until then. So letters are
/// stored, and entered once the field has focus. If other keys were pressed before the key that opens the
/// list, it is unknown which letters are meant for the list, and none are stored.
void type_ahead(PaletteState& state, const UiInput& input) {
    ImVector<ImWchar>& queue = ImGui::GetIO().InputQueueCharacters;
    std::vector<ImWchar>& ahead = state.typed_ahead;
    if (state.has_keyboard) {
        for (std::size_t i = 0; i < ahead.size(); ++i) queue.insert(queue.begin() + i, ahead[i]);
        return ahead.clear();
    }
    const auto opens = std::find_if(input.presses.begin(), input.presses.end(), [](KeyPress press) {
        return text_of(press) == keys_of(CommandId::Palette);
    });
    if (opens == input.presses.begin() || opens == input.presses.end())
        ahead.insert(ahead.end(), queue.begin(), queue.end());
}

}  // namespace

std::vector<int> palette_matches(const std::vector<PaletteEntry>& entries, const std::string& text) {
    std::vector<std::tuple<int, bool, int>> ranked;  // rank, whether it cannot run, index
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto rank = rank_of(entries[i], text))
            ranked.emplace_back(*rank, !text.empty() && !entries[i].refused.empty(), static_cast<int>(i));
    std::sort(ranked.begin(), ranked.end());
    std::vector<int> indices;
    indices.reserve(ranked.size());
    for (const auto& [rank, refused, index] : ranked) indices.push_back(index);
    return indices;
}

void open_palette(UiState& state) {
    PaletteState& palette = state.palette;
    palette = {};
    palette.open = palette.takes_keyboard = true;
    palette.entries = palette_entries(state);
    palette.matches = palette_matches(palette.entries, "");
    palette.made_for = item_counts(state.editor.scene());
    const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
    for (const PaletteEntry& entry : palette.entries)
        palette.width = std::max(palette.width, width(entry.name) + width(entry.keys) + px(60));
}

void palette(UiState& state, const UiInput& input) {
    PaletteState& palette = state.palette;
    // Entries refer to lights and objects by index.
    if (item_counts(state.editor.scene()) != palette.made_for) palette.open = false;
    if (!palette.open) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(std::clamp(palette.width, px(380), px(560)), window.x - px(20));
    ImGui::SetNextWindowPos({(window.x - width) / 2, std::min(px(90), window.y / 8)});
    ImGui::SetNextWindowSize({width, 0});
    if (palette.takes_keyboard) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("##palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
    if (palette.takes_keyboard) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    type_ahead(palette, input);
    if (text_field("##text", "What would you like to do?", palette.text)) {
        palette.matches = palette_matches(palette.entries, palette.text);
        palette.chosen = palette.text.empty() ? -1 : 0;
    }
    palette.has_keyboard = ImGui::IsItemActive();
    const int decided = entry_list(palette, input);
    const bool left = !palette.takes_keyboard && !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    const bool entered = std::any_of(input.presses.begin(), input.presses.end(),
                                     [](const KeyPress& press) { return press.key == Key::Enter; });
    palette.takes_keyboard = entered && decided < 0;  // Enter removed the focus from the text field
    ImGui::End();
    ImGui::PopStyleVar(2);
    if (left) palette.open = false;
    if (decided >= 0) run_entry(state, decided);
}

namespace {

using Entries = std::vector<PaletteEntry>;

void add(Entries& entries, std::string name, std::string group, std::function<void(UiState&)> run,
         std::string refused = "") {
    entries.push_back({std::move(name), std::move(group), "", std::move(refused), std::move(run)});
}

void add_commands(Entries& entries, const UiState& state) {
    for (const WindowCommand& command : commands()) {
        if (command.id == CommandId::Palette) continue;
        const auto on = is_on(state, command);
        entries.push_back({command.name, on ? (*on ? "Action · on" : "Action · off") : "Action",
                           keys_of(command), why_disabled(state, command),
                           [&command](UiState& s) { run_command(s, command); }, command.words});
    }
}

/// Adds a switch, which is looked up again in the current scene when it is used.
template <class Find>
void add_switch(Entries& entries, const UiState& state, std::string name, const char* group, Find find) {
    const bool on = find(const_cast<Scene&>(state.editor.scene()));
    add(entries, std::move(name), fmt::format("{} · {}", group, on ? "on" : "off"),
        [find](UiState& s) { find(s.editor.scene()) ^= true; });
}

void add_mistakes(Entries& entries, const UiState& state) {
    for (const MistakeName& mistake : mistake_names())
        add_switch(entries, state, "Mistake: " + with_spaces(mistake.name), "Mistake",
                   [flag = mistake.flag](Scene& s) -> bool& { return s.shading.mistakes.*flag; });
}

/// Adds the actions of the selected light's panel.
void add_light_choices(Entries& entries, const UiState& state) {
    const int index = selected_light(state.editor.selection);
    if (index < 0) return;
    const auto at = static_cast<std::size_t>(index);
    const Light& light = state.editor.scene().lights[at];
    const bool rides = light.space == LightSpace::Camera;
    add(entries,
        fmt::format("{}: {}", light.name, rides ? "leave it in the world" : "attach it to the camera"),
        "Light", [at, rides](UiState& s) {
            Light& l = s.editor.scene().lights[at];
            l = in_space(l, rides ? LightSpace::World : LightSpace::Camera, s.editor.scene().camera);
        });
    for (const LightKind kind : enumerators<LightKind>)
        add(entries, fmt::format("{}: {}", light.name, choice_of(kind).label), "Light",
            [at, kind](UiState& s) {
                Scene& scene = s.editor.scene();
                const ScreenMap map = screen_map(scene.camera, s.rendered->size);
                const Dome dome = sun_dome(scene.camera.target, scene_bounds(scene), map);
                scene.lights[at] = as_kind(scene.lights[at], kind, dome, map);
            });
}

/// Adds the actions of the selected object's panel.
void add_object_choices(Entries& entries, const UiState& state) {
    const Selection selection = state.editor.selection;
    const bool selected = selection.kind == Selection::Kind::Object;
    const auto at = static_cast<std::size_t>(std::max(selection.index, 0));
    for (const MaterialPreset& preset : material_presets())
        add(
            entries, fmt::format("Material: {}", preset.name), "Preset",
            [at, &preset](UiState& s) { apply(preset, s.editor.scene().objects[at].material); },
            selected ? "" : "No object is selected");
    if (!selected) return;
    const Object& object = state.editor.scene().objects[at];
    const auto* present = std::get_if<PrimitiveMesh>(&object.source);
    for (const Primitive primitive : enumerators<Primitive>) {
        if (present != nullptr && present->primitive == primitive) continue;
        add(entries, fmt::format("{}: {}", object.name, choice_of(primitive).label), "Mesh",
            [at, primitive](UiState& s) {
                Object& o = s.editor.scene().objects[at];
                o.source = default_mesh(primitive);
                o.mesh = nullptr;  // built in the background
            });
    }
    add(entries, fmt::format("{}: mesh file…", object.name), "Mesh",
        [at](UiState& s) { ask_mesh(s, static_cast<int>(at)); });
}

/// Adds the entries behind the + buttons of the two lists, except for the light that a key adds.
void add_additions(Entries& entries, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const char* const no_light = scene.lights.size() >= max_lights ? is_full : "";
    const char* const no_object = scene.objects.size() >= max_objects ? is_full : "";
    for (const LightKind kind : enumerators<LightKind>) {
        if (kind == LightKind::Point) continue;
        add(
            entries, fmt::format("Add a light: {}", choice_of(kind).label), "Scene",
            [kind](UiState& s) { add_light(s.editor.scene(), s.editor.selection, kind); }, no_light);
    }
    add(
        entries, "Add an object: mesh file…", "Scene", [](UiState& s) { ask_mesh(s, -1); }, no_object);
    for (const Primitive primitive : enumerators<Primitive>)
        add(
            entries, fmt::format("Add an object: {}", choice_of(primitive).label), "Scene",
            [primitive](UiState& s) {
                add_object(s.editor.scene(), s.editor.selection, default_mesh(primitive));
            },
            no_object);
}

void add_items(Entries& entries, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const auto select = [&](const std::string& name, Selection selection) {
        add(entries, fmt::format("Select {}", name), "Scene",
            [selection](UiState& s) { s.editor.selection = selection; });
    };
    select("the camera", {Selection::Kind::Camera, 0});
    select("shading", {Selection::Kind::Shading, 0});
    select("display", {Selection::Kind::Display, 0});
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        select(scene.lights[i].name, {Selection::Kind::Light, static_cast<int>(i)});
        add_switch(entries, state, fmt::format("Light: {}", scene.lights[i].name), "Light",
                   [i](Scene& s) -> bool& { return s.lights[i].enabled; });
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        select(scene.objects[i].name, {Selection::Kind::Object, static_cast<int>(i)});
}

void add_open(Entries& entries, std::string name, std::string group, const std::string& path) {
    add(entries, std::move(name), std::move(group), [path](UiState& s) { ask_to_open(s, path); });
}

void add_recent(Entries& entries, const UiState& state) {
    for (const std::string& path : state.persistence.preferences.recent) {
        const std::filesystem::path file(path);
        add_open(entries, fmt::format("Open recent: {}", file.filename().string()),
                 file.parent_path().string(), path);
    }
}

/// Adds the possible answers to the offer to recover unsaved work.
void add_answers_of_copy(Entries& entries, const UiState& state) {
    if (state.persistence.orphans.empty()) return;
    const std::string title = state.persistence.orphans.front().title;
    const auto answer = [&](const std::string& name, CopyAnswer what) {
        add(entries, name, "Copy of unsaved work", [what](UiState& s) {
            if (!s.persistence.orphans.empty()) answer_copy(s, what);
        });
    };
    answer(fmt::format("Recover the copy of {}", title), CopyAnswer::Recover);
    answer(fmt::format("Discard the copy of {}", title), CopyAnswer::Discard);
    answer(fmt::format("Not now: keep the copy of {} for the next start", title), CopyAnswer::NotNow);
}

}  // namespace

std::vector<PaletteEntry> palette_entries(UiState& state) {
    Entries entries;
    add_commands(entries, state);
    add_answers_of_copy(entries, state);
    add_recent(entries, state);
    const std::size_t of_the_scene = entries.size();
    add_field_entries(entries, state);
    add_mistakes(entries, state);
    add_light_choices(entries, state);
    add_additions(entries, state);
    add_object_choices(entries, state);
    add_items(entries, state);
    for (const Feature* feature : features())
        if (feature->palette != nullptr) feature->palette(entries, state);
    const std::string held = why_held(state);
    for (std::size_t i = of_the_scene; i < entries.size() && !held.empty(); ++i)
        if (!entries[i].quiet) entries[i].refused = held;
    for (PaletteEntry& entry :
         entries)  // a row is a single line, even if the item's name contains line breaks
        for (std::string* text : {&entry.name, &entry.group})
            std::replace_if(text->begin(), text->end(), breaks_line, ' ');
    return entries;
}

// The palette's entries generated from the rows of models/fields/scene_fields.h: every field of the scene,
// and the values of its switches and closed sets.

namespace {

using Entries = std::vector<PaletteEntry>;

constexpr int most_items = 50;  // maximum number of lights or objects whose fields are listed

/// An item with a panel.
struct FieldOwner {
    std::string group;
    Selection selection;
};

void show_field(UiState& state, const Selection& selection, const std::string& pointer,
                const std::string& component) {
    state.editor.selection = selection;
    state.layout.left = true;
    state.layout.hides_columns = state.left_shows_inspector = false;
    state.left_shows_scene = true;
    ask_for_field(pointer, component);
}

/// Adds an entry that shows the panel and focuses the field.
void add_field(Entries& entries, const FieldOwner& owner, const Row& row, const std::string& pointer,
               const std::string& component = "", const std::string& name_of_component = "") {
    entries.push_back({row.label + name_of_component, owner.group, "", "",
                       [selection = owner.selection, pointer, component](UiState& s) {
                           show_field(s, selection, pointer, component);
                       },
                       row.help});
}

/// Adds the fields of a struct and of the structs in it.
template <class T>
void add_fields(Entries& entries, const T& value, const std::string& pointer, const FieldOwner& owner) {
    fields(value, [&]<class Kind, class Member>(const Row& row, const Kind&, const Member& member) {
        const std::string at = pointer + "/" + std::string(row.key);
        if constexpr (std::is_same_v<Kind, OneProjection> || std::is_same_v<Kind, OneMesh>) {
            add_fields(entries, member, at, owner);
        } else if constexpr (std::is_same_v<Member, Mistakes>) {
            // Mistakes have their own tab and entries.
        } else if constexpr (std::is_same_v<Kind, Group>) {
            if (row.applies) add_fields(entries, member, at, owner);  // the panel omits fields without effect
        } else if constexpr (!std::is_same_v<Kind, List> && !std::is_same_v<Kind, Path>) {
            add_field(entries, owner, row, at);
            if constexpr (std::is_same_v<Kind, Vector> || std::is_same_v<Kind, Homogeneous>)
                for (int i = 0; i < Member::length(); ++i)
                    add_field(entries, owner, row, at, fmt::format("/{}", i), fmt::format(" {}", "xyzw"[i]));
        }
    });
}

/// Adds the fields of lights or objects, the selected one first, because the first of several equal matches
/// wins.
template <class Item>
void add_item_fields(Entries& entries, const std::vector<Item>& items, const char* list, Selection::Kind kind,
                     const Selection& selected) {
    for (const bool is_selected : {true, false})
        for (int i = 0; i < static_cast<int>(items.size()); ++i) {
            if ((selected == Selection{kind, i}) != is_selected || (!is_selected && i >= most_items))
                continue;
            const Item& item = items[static_cast<std::size_t>(i)];
            add_fields(entries, item, fmt::format("/{}/{}", list, i), {"Field · " + item.name, {kind, i}});
        }
}

/// Sets the member with that key.
template <class T, class E> void set_member(T& owner, std::string_view key, E value) {
    fields(owner, [&](const Row& row, const auto&, auto& member) {
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, E>)
            if (row.key == key) member = value;
    });
}

/// Adds entries that set the switches and closed sets in one part of the scene.
template <class T>
void add_settings(Entries& entries, const Scene& scene, T Scene::*part, const char* group) {
    fields(scene.*part, [&]<class Kind, class Member>(const Row& row, const Kind&, const Member& member) {
        const auto add = [&](const std::string& name, Member value) {
            entries.push_back(
                {fmt::format("{}: {}", row.label, name), group, "", "",
                 [part, key = row.key, value](UiState& s) { set_member(s.editor.scene().*part, key, value); },
                 row.help});
        };
        if constexpr (std::is_same_v<Kind, Switch>) add(member ? "switch off" : "switch on", !member);
        if constexpr (std::is_same_v<Kind, OneOf>)
            for (const Member value : enumerators<Member>) add(choice_of(value).label, value);
    });
}

/// The kind of projection is not a row of the scene's fields, because each kind has different fields.
void add_projections(Entries& entries) {
    for (const ProjectionKind kind : enumerators<ProjectionKind>)
        entries.push_back({fmt::format("Projection: {}", choice_of(kind).label), "Camera", "", "",
                           [kind](UiState& s) {
                               if (s.rendered == nullptr) return;
                               Camera& camera = s.editor.scene().camera;
                               camera.projection = as_projection(camera, kind, s.rendered->size);
                               s.editor.edits_camera = true;
                           },
                           choice_of(kind).meaning});
}

}  // namespace

void add_field_entries(Entries& entries, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const Selection& selected = state.editor.selection;
    add_item_fields(entries, scene.lights, "lights", Selection::Kind::Light, selected);
    add_item_fields(entries, scene.objects, "objects", Selection::Kind::Object, selected);
    add_fields(entries, scene.camera, "/camera", {"Field · Camera", {Selection::Kind::Camera, 0}});
    const FieldOwner shading{"Field · Shading", {Selection::Kind::Shading, 0}};
    add_fields(entries, scene.shading, "/shading", shading);
    add_fields(entries, scene.transport, "/transport", shading);
    fields(scene, [&]<class Kind>(const Row& row, const Kind&, const auto&) {  // the global ambient light
        if constexpr (std::is_same_v<Kind, Colour>)
            add_field(entries, shading, row, "/" + std::string(row.key));
    });
    add_fields(entries, scene.npr, "/npr", {"Field · Strokes and tones", {Selection::Kind::Shading, 0}});
    add_fields(entries, scene.display, "/display", {"Field · Display", {Selection::Kind::Display, 0}});
    add_projections(entries);
    add_settings(entries, scene, &Scene::shading, "Shading");
    add_settings(entries, scene, &Scene::transport, "Shading");
    add_settings(entries, scene, &Scene::npr, "Strokes and tones");
    add_settings(entries, scene, &Scene::display, "Display");
}

}  // namespace glint
