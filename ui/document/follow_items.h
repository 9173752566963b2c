#pragma once
// Lights and objects are named by their place in the scene's lists. When others come or go before one,
// whatever names it follows it to its new place.

#include <cstddef>
#include <optional>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

struct UiState;

/// The lists of a scene as they were followed last.
struct FollowedItems {
    std::vector<Light> lights;
    std::vector<Object> objects;
};

/// Returns where the item at `index` of `before` is in `after`, or -1 where it has gone. What is alike at the
/// beginning and at the end has stayed; between lies what came or went. In a list as long as before each item
/// keeps its place.
template <class Item>
[[nodiscard]] int place_in(const std::vector<Item>& before, const std::vector<Item>& after, int index) {
    if (before.size() == after.size()) return index;
    const std::size_t shorter = before.size() < after.size() ? before.size() : after.size();
    std::size_t first = 0, last = 0;  // how many are alike at each end
    while (first < shorter && before[first] == after[first]) ++first;
    while (last < shorter - first && before[before.size() - 1 - last] == after[after.size() - 1 - last])
        ++last;
    const auto place = static_cast<std::size_t>(index);
    if (place < first) return index;
    if (place + last < before.size()) return -1;
    return static_cast<int>(place + after.size() - before.size());
}

/// Lets what the window's tools name by its place follow the edited scene: the light of n·l, the cells of
/// Light × term, the number that goes to and fro, the quantity that is marked. After each thing that may add
/// or delete lights or objects, before anything is drawn of them.
void follow_items(UiState& state);

}  // namespace glint
