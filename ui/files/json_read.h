#pragma once
// Members of a JSON object that anyone may have written anything into: what cannot be understood leaves the
// value as it is.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace glint {

using Json = nlohmann::ordered_json;

inline void read(const Json& json, const char* name, bool& value) {
    if (const auto found = json.find(name); found != json.end() && found->is_boolean()) value = *found;
}

/// Brought into low .. high.
template <class Real> void read(const Json& json, const char* name, Real& value, Real low, Real high) {
    const auto found = json.find(name);
    if (found == json.end() || !found->is_number()) return;
    const double number = found->get<double>();
    if (!std::isfinite(number)) return;
    value = static_cast<Real>(std::clamp(number, static_cast<double>(low), static_cast<double>(high)));
}

}  // namespace glint
