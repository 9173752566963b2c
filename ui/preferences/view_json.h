#pragma once
// ViewPreferences as JSON.

#include <algorithm>
#include <cmath>

#include "models/json/json_value.h"
#include "ui/preferences/view_preferences.h"

namespace glint {

// Members of a JSON object that anyone may have written anything into: what cannot be understood leaves the
// value as it is.

using Json = JsonValue;

inline void read(const Json& json, const char* name, bool& value) {
    if (const Json* found = json.find(name); found != nullptr && found->is_boolean())
        value = found->boolean();
}

/// Brought into low .. high.
template <class Real> void read(const Json& json, const char* name, Real& value, Real low, Real high) {
    const Json* found = json.find(name);
    if (found == nullptr || !found->is_number()) return;
    const double number = found->number();
    if (!std::isfinite(number)) return;
    value = static_cast<Real>(std::clamp(number, static_cast<double>(low), static_cast<double>(high)));
}

[[nodiscard]] Json view_json(const ViewPreferences& memory);
/// What can be understood; the rest has its default.
[[nodiscard]] ViewPreferences read_view(const Json& json);

}  // namespace glint
