#pragma once
// A cached result of a slow computation, with its key.

#include <imgui.h>

#include <optional>
#include <utility>

#include "ui/widgets/widgets.h"

namespace glint {

template <class Key, class Value> class Kept {
  public:
    /// Whether the cached result belongs to `key`, compared by ==.
    [[nodiscard]] bool is_of(const Key& key) const { return key_ == key; }
    /// The last result, for any key; null before the first.
    [[nodiscard]] const Value* value() const { return key_ ? &value_ : nullptr; }
    [[nodiscard]] const std::optional<Key>& key() const { return key_; }

    void keep(const Key& key, Value value) {
        value_ = std::move(value);
        key_ = key;
    }
    /// The result for `key`: calls compute() if another key's is cached.
    template <class Compute> const Value& of(const Key& key, const Compute& compute) {
        if (!is_of(key)) keep(key, compute());
        return value_;
    }
    void forget() { *this = {}; }

  private:
    std::optional<Key> key_;
    Value value_{};
};

/// Recomputes something that takes a few milliseconds, but not during a drag.
template <class Key, class Value, class Compute>
void update_at_rest(Kept<Key, Value>& kept, const Key& key, const Compute& compute) {
    if (kept.is_of(key)) return;
    if (ImGui::IsAnyMouseDown()) return redraw_within(0.1);
    kept.keep(key, compute());
}

}  // namespace glint
