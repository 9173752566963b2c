#pragma once
// Members of a JSON object that anyone may have written anything into: what cannot be understood leaves the
// value as it is.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace glint {

using Json = nlohmann::ordered_json;

/// A document that anyone may have written. Null when it is no JSON, nested deeper than any of ours (what
/// copies and writes such values calls itself once for each level), or of more values than any of ours.
[[nodiscard]] inline Json parse_untrusted(const std::string& text) {
    constexpr int deepest = 64;
    constexpr std::size_t most_values = 2'000'000;
    struct TooMuch {};
    std::size_t values = 0;
    const auto bounded = [&values](int depth, Json::parse_event_t /*event*/, const Json& /*value*/) {
        if (depth > deepest || ++values > most_values) throw TooMuch();
        return true;
    };
    try {
        Json json = Json::parse(text, bounded, false);
        return json.is_discarded() ? Json() : json;
    } catch (const TooMuch&) {
        return {};
    }
}

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
