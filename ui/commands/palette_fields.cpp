// The palette's entries that follow from the rows of models/fields/scene_fields.h: every field of the scene,
// and what its switches and closed sets can be.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "models/fields/scene_fields.h"
#include "ui/commands/command.h"
#include "ui/commands/palette_rows.h"
#include "ui/fields/field_panel.h"
#include "ui/fields/panels.h"
#include "ui/ui.h"

namespace glint {
namespace {

using Entries = std::vector<PaletteEntry>;

constexpr std::size_t most_items = 50;  // lights, and objects, whose fields are listed

/// What has a panel: where its fields stand in the scene file, and what it is called.
struct FieldOwner {
    std::string pointer, name;
    Selection selection;
};

void show_field(UiState& state, const Selection& selection, const std::string& pointer,
                const std::string& component) {
    state.editor.selection = selection;
    state.layout.left = true;
    state.layout.hides_columns = state.left_shows_inspector = false;
    state.lesson.shows_scene = true;
    ask_for_field(pointer, component);
}

/// Lists the fields of a struct and of the structs in it, an entry a row.
class FieldList {
  public:
    FieldList(Entries& entries, FieldOwner owner) : entries_(entries), owner_(std::move(owner)) {}

    template <class T> void members(const T& value, const std::string& pointer) const {
        fields(value, [&](const Row& row, const auto& kind, const auto& member) {
            at(row, kind, member, pointer + "/" + std::string(row.key));
        });
    }

    /// The colours that are members of the scene itself.
    template <class T> void own_colours(const T& value) const {
        fields(value, [&](const Row& row, const auto& kind, const auto& member) {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, Colour>)
                at(row, kind, member, "/" + std::string(row.key));
        });
    }

  private:
    template <class T>
    void at(const Row& row, const Group&, const T& value, const std::string& pointer) const {
        if (row.applies) members(value, pointer);  // its panel leaves out what has no effect
    }
    /// They have no panel but a tab, and entries of their own.
    void at(const Row&, const Group&, const Mistakes&, const std::string&) const {}
    template <class T>
    void at(const Row&, const OneProjection&, const T& p, const std::string& pointer) const {
        members(p, pointer);
    }
    template <class T>
    void at(const Row&, const OneMesh&, const T& source, const std::string& pointer) const {
        members(source, pointer);
    }
    template <class T> void at(const Row&, const List&, const T&, const std::string&) const {}
    template <class T> void at(const Row&, const Path&, const T&, const std::string&) const {}
    template <class Kind, class T>
    void at(const Row& row, const Kind&, const T&, const std::string& pointer) const {
        add(row, row.label, pointer, "");
        if constexpr (std::is_same_v<Kind, Vector> || std::is_same_v<Kind, Homogeneous>)
            for (int i = 0; i < T::length(); ++i)
                add(row, fmt::format("{} {}", row.label, "xyzw"[i]), pointer, fmt::format("/{}", i));
    }
    void add(const Row& row, std::string name, const std::string& pointer,
             const std::string& component) const {
        entries_.push_back({std::move(name), fmt::format("Field · {}", owner_.name), "", "",
                            [selection = owner_.selection, pointer, component](UiState& s) {
                                show_field(s, selection, pointer, component);
                            },
                            row.help});
    }

    Entries& entries_;
    FieldOwner owner_;
};

template <class T> void add_fields(Entries& entries, const T& value, const FieldOwner& owner) {
    FieldList(entries, owner).members(value, owner.pointer);
}

/// Lights or objects: the selected one first, since of equal matches the first is offered.
template <class Item>
void add_item_fields(Entries& entries, const std::vector<Item>& items, const std::string& list,
                     Selection::Kind kind, const Selection& selected) {
    const auto add = [&](int index) {
        const Item& item = items[static_cast<std::size_t>(index)];
        add_fields(entries, item, {fmt::format("/{}/{}", list, index), item.name, {kind, index}});
    };
    const int count = static_cast<int>(std::min(items.size(), most_items));
    const int first = selected.kind == kind ? selected.index : -1;
    if (first >= 0 && first < static_cast<int>(items.size())) add(first);
    for (int i = 0; i < count; ++i)
        if (i != first) add(i);
}

/// A struct of which a scene has one, whose switches and closed sets can be set from the palette.
template <class T> struct SettingsOf {
    T& (*in)(Scene&);
    const char *pointer, *group;
};

/// Sets the member with that key.
template <class T, class E> void set_member(T& owner, std::string_view key, E value) {
    fields(owner, [&](const Row& row, const auto&, auto& member) {
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, E>)
            if (row.key == key) member = value;
    });
}

template <class T> class SettingList {
  public:
    SettingList(Entries& entries, const SettingsOf<T>& settings) : entries_(entries), settings_(settings) {}

    void of(const T& value) const {
        fields(value,
               [this](const Row& row, const auto& kind, const auto& member) { this->at(row, kind, member); });
    }

  private:
    void add(const Row& row, const std::string& name, const std::string& state, auto value) const {
        entries_.push_back({name, fmt::format("{}{}{}", settings_.group, state.empty() ? "" : " · ", state),
                            "", "",
                            [in = settings_.in, key = row.key, value](UiState& s) {
                                set_member(in(s.editor.scene()), key, value);
                            },
                            row.help});
    }
    void at(const Row& row, const Switch&, bool on) const {
        add(row, fmt::format("{}: switch {}", row.label, on ? "off" : "on"), on ? "on" : "off", !on);
    }
    template <class E> void at(const Row& row, const OneOf&, const E& chosen) const {
        for (const E value : enumerators<E>) {
            // What a command sets stands in the palette as that command.
            if (!keys_of_value(fmt::format("{}/{} = \"{}\"", settings_.pointer, row.key, name_of(value)))
                     .empty())
                continue;
            add(row, fmt::format("{}: {}", row.label, choice_of(value).label),
                value == chosen ? "chosen" : "", value);
        }
    }
    template <class Kind, class V> void at(const Row&, const Kind&, const V&) const {}

    Entries& entries_;
    SettingsOf<T> settings_;
};

template <class T>
void add_settings_of(Entries& entries, const UiState& state, const SettingsOf<T>& settings) {
    Scene scene_only_read = state.editor.scene();
    SettingList<T>(entries, settings).of(settings.in(scene_only_read));
}

/// The kind is not a row of the scene's fields: with another one other fields are there.
void add_projections(Entries& entries, const UiState& state) {
    const ProjectionKind now = kind_of(state.editor.scene().camera.projection);
    for (const ProjectionKind kind : enumerators<ProjectionKind>)
        entries.push_back({fmt::format("Projection: {}", choice_of(kind).label),
                           kind == now ? "Camera · chosen" : "Camera", "", "",
                           [kind](UiState& s) {
                               if (s.rendered == nullptr) return;
                               Camera& camera = s.editor.scene().camera;
                               camera.projection = as_projection(camera, kind, s.rendered->size);
                               s.editor.edits_camera = true;
                           },
                           choice_of(kind).meaning});
}

}  // namespace

void add_fields(Entries& entries, const UiState& state) {
    const Scene& scene = state.editor.scene();
    const Selection& selected = state.editor.selection;
    add_item_fields(entries, scene.lights, "lights", Selection::Kind::Light, selected);
    add_item_fields(entries, scene.objects, "objects", Selection::Kind::Object, selected);
    add_fields(entries, scene.camera, {"/camera", "Camera", {Selection::Kind::Camera, 0}});
    const FieldOwner shading{"/shading", "Shading", {Selection::Kind::Shading, 0}};
    add_fields(entries, scene.shading, shading);
    FieldList(entries, shading).own_colours(scene);  // the ambient light: its row stands in the same panel
    add_fields(entries, scene.npr, {"/npr", "Strokes and tones", {Selection::Kind::Shading, 0}});
    add_fields(entries, scene.display, {"/display", "Display", {Selection::Kind::Display, 0}});
}

void add_settings(Entries& entries, const UiState& state) {
    add_projections(entries, state);
    add_settings_of<Shading>(entries, state,
                             {[](Scene& s) -> Shading& { return s.shading; }, "/shading", "Shading"});
    add_settings_of<Npr>(entries, state,
                         {[](Scene& s) -> Npr& { return s.npr; }, "/npr", "Strokes and tones"});
    add_settings_of<Display>(entries, state,
                             {[](Scene& s) -> Display& { return s.display; }, "/display", "Display"});
}

}  // namespace glint
