#pragma once
// The style of the equation's letters in the window.

#include <utility>

#include "renderer/explain/quantity.h"
#include "ui/widgets/theme.h"

namespace glint {

/// The colour of a letter.
[[nodiscard]] Symbol colour_of(Quantity quantity);

/// The two vectors of a cosine. Precondition: is_cosine().
[[nodiscard]] std::pair<Quantity, Quantity> vectors_of(Quantity cosine);

}  // namespace glint
