#pragma once
// ViewMemory as JSON.

#include "ui/preferences/json_read.h"
#include "ui/preferences/view_memory.h"

namespace glint {

[[nodiscard]] Json view_json(const ViewMemory& memory);
/// What can be understood; the rest has its default.
[[nodiscard]] ViewMemory read_view(const Json& json);

}  // namespace glint
