#pragma once
// Values that persist from frame to frame: states by their type, and the cached result of a slow computation
// with its key.

#include <imgui.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/widgets/widgets.h"

namespace glint {

/// One value of each requested type, created by the first request for it. Its address never changes.
class States {
  public:
    template <class T> [[nodiscard]] T& get() const {
        for (const State& state : states_)
            if (state.type == &type_id<T>) return *static_cast<T*>(state.value.get());
        const auto value = std::make_shared<T>();
        states_.push_back({&type_id<T>, value});
        return *value;
    }

  private:
    template <class T> static inline char type_id = 0;  // the address identifies the type

    struct State {
        const char* type;
        std::shared_ptr<void> value;
    };
    mutable std::vector<State> states_;
};

/// Returns the states of widgets, which have no access to the window's state. The current ImGui context owns
/// them.
[[nodiscard]] const States& widget_states();
template <class T> [[nodiscard]] T& widget_state() { return widget_states().get<T>(); }

template <class Key, class Value> class Kept {
  public:
    /// Returns whether the cached result belongs to `key`, compared with ==.
    [[nodiscard]] bool is_of(const Key& key) const { return key_ == key; }
    /// Returns the last result, for whichever key; null before the first one.
    [[nodiscard]] const Value* value() const { return key_ ? &value_ : nullptr; }
    [[nodiscard]] const std::optional<Key>& key() const { return key_; }

    void keep(const Key& key, Value value) {
        value_ = std::move(value);
        key_ = key;
    }
    /// Returns the result for `key`; calls compute() if the cached result is for a different key.
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
