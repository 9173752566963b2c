#pragma once
// Work that is not begun because it would be far too much.

#include <memory>
#include <new>
#include <string>
#include <utility>

#include "models/problem.h"

namespace glint {

/// A std::bad_alloc with words: whoever can go on without memory can go on after this.
class Refused : public std::bad_alloc {
  public:
    explicit Refused(Problem problem) {
        std::string text = problem.text();
        told_ = std::make_shared<const Told>(Told{std::move(problem), std::move(text)});
    }
    [[nodiscard]] const Problem& problem() const { return told_->problem; }
    [[nodiscard]] const char* what() const noexcept override { return told_->text.c_str(); }

  private:
    struct Told {
        Problem problem;
        std::string text;
    };
    std::shared_ptr<const Told> told_;  // exceptions are copied, and that must not throw
};

}  // namespace glint
