#pragma once
// What the scene file would refuse, the window does not let happen: what is saved opens again. Ranges of
// single numbers are kept by the fields; conditions between numbers are those of models/fields/scene_rules.h.

#include "models/fields/scene_rules.h"

namespace glint {

/// `edited` if it breaks no condition, else as it was `before`. True when the edit stands.
template <class Item> bool keep_valid(Item& edited, const Item& before) {
    if (!violation_of(edited)) return true;
    edited = before;
    return false;
}

}  // namespace glint
