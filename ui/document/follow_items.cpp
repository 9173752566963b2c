#include "ui/document/follow_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "models/json/json_pointer.h"
#include "ui/features/export/animation.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/views/debug_view_controls.h"
#include "ui/features/views/term_grid.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// The pointer with the item's new index, if it refers into that list; empty if the item was deleted.
template <class Item>
std::string followed(const std::string& pointer, std::string_view list, const std::vector<Item>& before,
                     const std::vector<Item>& after) {
    const std::optional<ListItem> item = item_in(pointer, list);
    if (!item || item->place >= static_cast<int>(before.size())) return pointer;
    const int place = place_in(before, after, item->place);
    return place < 0 ? "" : fmt::format("{}{}{}", list, place, item->rest);
}

template <class Item>
void follow_number(UiState& state, std::string_view list, const std::vector<Item>& before,
                   const std::vector<Item>& after) {
    const std::string& pointer = state.get<AnimateState>().animation.pointer;
    const std::string place = followed(pointer, list, before, after);
    if (place.empty() && !pointer.empty())
        forget_number(state);
    else
        state.get<AnimateState>().animation.pointer = place;
}

void follow_lights(UiState& state, const std::vector<Light>& before) {
    const std::vector<Light>& after = state.editor.scene().lights;
    const auto is_one = [&before](int light) {
        return light >= 0 && light < static_cast<int>(before.size());
    };
    const auto follow = [&](int& light) {
        if (!is_one(light)) return true;
        const int place = place_in(before, after, light);
        if (place >= 0) light = place;
        return place >= 0;
    };
    (void)follow(state.get<DebugViewState>().set.choice.light);  // the neighbour's if it was deleted
    TermGridState& grid = state.get<TermGridState>();
    if (grid.solo && !follow(grid.solo->light)) grid.solo.reset();
    std::erase_if(grid.muted, [&](GridCell& cell) { return !follow(cell.light); });
    auto& marked = state.get<InspectorState>().marked;
    if (marked && !follow(marked->light)) marked.reset();
    AnimateState& animate = state.get<AnimateState>();
    if (!follow(animate.animation.light) && animate.animation.motion == Motion::Circle)
        animate.playing = false;
    follow_number(state, "/lights/", before, after);
}

}  // namespace

void follow_items(UiState& state) {
    const Scene& scene = state.editor.scene();
    std::optional<FollowedItems>& known = state.editor.followed;
    if (!known) known.emplace(FollowedItems{scene.lights, scene.objects});
    if (known->lights != scene.lights) {
        if (known->lights.size() != scene.lights.size()) follow_lights(state, known->lights);
        known->lights = scene.lights;
    }
    if (known->objects != scene.objects) {
        if (known->objects.size() != scene.objects.size())
            follow_number(state, "/objects/", known->objects, scene.objects);
        known->objects = scene.objects;
    }
}

}  // namespace glint
