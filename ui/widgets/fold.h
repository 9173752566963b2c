#pragma once
// A heading that folds away what stands below it.

namespace glint {

/// The heading; true while what is below it shall be drawn. A click opens and closes it; it stays so for as
/// long as the window is open. `open_at_first`: how it is until somebody clicks. `opens`: it opens now.
[[nodiscard]] bool fold(const char* title, bool open_at_first, bool opens = false);

}  // namespace glint
