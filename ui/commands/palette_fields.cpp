// The palette's entries generated from the rows of models/fields/scene_fields.h: every field of the scene,
// and the values of its switches and closed sets.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "models/fields/scene_fields.h"
#include "ui/commands/menus.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/ui.h"

namespace glint {
namespace {

using Entries = std::vector<PaletteEntry>;

constexpr int most_items = 50;  // lights and objects whose fields are listed

/// Something with a panel.
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

/// An entry that shows the panel and focuses the field.
void add_field(Entries& entries, const FieldOwner& owner, const Row& row, const std::string& pointer,
               const std::string& component = "", const std::string& name_of_component = "") {
    entries.push_back({row.label + name_of_component, owner.group, "", "",
                       [selection = owner.selection, pointer, component](UiState& s) {
                           show_field(s, selection, pointer, component);
                       },
                       row.help});
}

/// The fields of a struct and of the structs in it.
template <class T>
void add_fields(Entries& entries, const T& value, const std::string& pointer, const FieldOwner& owner) {
    fields(value, [&]<class Kind, class Member>(const Row& row, const Kind&, const Member& member) {
        const std::string at = pointer + "/" + std::string(row.key);
        if constexpr (std::is_same_v<Kind, OneProjection> || std::is_same_v<Kind, OneMesh>) {
            add_fields(entries, member, at, owner);
        } else if constexpr (std::is_same_v<Member, Mistakes>) {
            // Mistakes have a tab and entries of their own.
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

/// Lights or objects: the selected one first, because the first of several equal matches wins.
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

/// Entries that set the switches and closed sets of a part of the scene.
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
