#pragma once
// State that features keep from frame to frame. The window's core does not know their types.

#include <memory>
#include <vector>

namespace glint {

/// One value of each requested type, created by the first request for it. Its address never changes.
class FeatureStates {
  public:
    template <class T> [[nodiscard]] T& get() const {
        for (const State& state : states_)
            if (state.type == &type_id<T>) return *static_cast<T*>(state.value.get());
        const auto value = std::make_shared<T>();
        states_.push_back({&type_id<T>, value});
        return *value;
    }

  private:
    template <class T> static inline char type_id = 0;  // its address identifies the type

    struct State {
        const char* type;
        std::shared_ptr<void> value;
    };
    mutable std::vector<State> states_;
};

}  // namespace glint
