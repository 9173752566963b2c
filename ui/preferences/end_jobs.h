#pragma once
// What the window still does aside when it closes.

namespace glint {

struct UiState;

/// Cancels every load, export and search at once and waits for them, at most `seconds`. False when one goes
/// on: a thread in the middle of a mesh or a picture cannot be stopped. What is cancelled begins to write no
/// file.
[[nodiscard]] bool end_jobs(UiState& state, double seconds);

}  // namespace glint
