#pragma once
// Lights and objects are identified by their index in the scene's lists. When items before one are added or
// deleted, every reference to it gets the new index.

#include <cstddef>
#include <optional>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

struct UiState;

/// The lists of a scene at the last update.
struct FollowedItems {
    std::vector<Light> lights;
    std::vector<Object> objects;
};

/// Returns the index in `after` of the item at `index` of `before`, or -1 if it was deleted. Equal items at
/// the beginning and at the end are the same items; those in between were added or deleted. If the length has
/// not changed, each item keeps its index.
template <class Item>
[[nodiscard]] int place_in(const std::vector<Item>& before, const std::vector<Item>& after, int index) {
    if (before.size() == after.size()) return index;
    const std::size_t shorter = before.size() < after.size() ? before.size() : after.size();
    std::size_t first = 0, last = 0;  // number of equal items at each end
    while (first < shorter && before[first] == after[first]) ++first;
    while (last < shorter - first && before[before.size() - 1 - last] == after[after.size() - 1 - last])
        ++last;
    const auto place = static_cast<std::size_t>(index);
    if (place < first) return index;
    if (place + last < before.size()) return -1;
    return static_cast<int>(place + after.size() - before.size());
}

/// Updates the indices in the window's tools after changes to the edited scene: the light of n·l, the cells
/// of Light × term, the animated number, the highlighted quantity. Called after each action that may add or
/// delete lights or objects, before any of them is drawn.
void follow_items(UiState& state);

}  // namespace glint
