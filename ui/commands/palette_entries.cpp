#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "models/fields/choices.h"
#include "models/scene/mistakes.h"
#include "ui/commands/command.h"
#include "ui/commands/match.h"
#include "ui/commands/menus.h"
#include "ui/document/document_actions.h"
#include "ui/document/loading.h"
#include "ui/document/scene_edit.h"
#include "ui/feature.h"
#include "ui/fields/panels.h"
#include "ui/picture/handles/light_place.h"
#include "ui/widgets/parts.h"

namespace glint {
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

/// A switch, looked up again in the current scene.
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

/// The actions of the selected light's panel.
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

/// The actions of the selected object's panel.
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

/// The items of the + buttons of both lists, except for the light that has a key.
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

/// The answers to the offer to recover unsaved work.
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
    for (PaletteEntry& entry : entries)  // a row is one line, even if the item's name contains line breaks
        for (std::string* text : {&entry.name, &entry.group})
            std::replace_if(text->begin(), text->end(), breaks_line, ' ');
    return entries;
}

}  // namespace glint
