#pragma once
// What the scene file would refuse, the window does not let happen: what is saved opens again. Ranges of
// single numbers are kept by the widgets; here are the conditions between numbers (docs/interface.md).

#include "models/scene.h"

namespace glint {

/// Eye apart from the target, up not along the view, 0 < near < far, a frustum with area.
[[nodiscard]] bool is_valid(const Camera& camera);
/// A direction, an axis and an area that are not zero; a falloff that is not all zero.
[[nodiscard]] bool is_valid(const Light& light);
/// No zero in the scale.
[[nodiscard]] bool is_valid(const Object& object);

/// `edited` if it is valid, else as it was `before`. True when the edit stands.
template <class Item> bool keep_valid(Item& edited, const Item& before) {
    if (is_valid(edited)) return true;
    edited = before;
    return false;
}

inline constexpr std::size_t max_lights = 4096, max_objects = 10'000;

}  // namespace glint
