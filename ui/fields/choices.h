#pragma once
// Fields for the closed sets of a scene (models/fields/choices.h).

#include "models/fields/choices.h"
#include "ui/widgets/widgets.h"

namespace glint {

/// A drop-down for the enumerators of E.
template <class E> bool choice_field(const char* label, E& value, const Help& help) {
    const E before = value;
    value = static_cast<E>(choose(label, static_cast<int>(value), choices<E>, help));
    return value != before;
}

/// Joined buttons for the enumerators of E, in a row with a label.
template <class E> bool segment_field(const char* label, E& value, const Help& help) {
    row(label);
    const E before = value;
    value = static_cast<E>(segments(label, static_cast<int>(value), choices<E>, help));
    return value != before;
}

}  // namespace glint
