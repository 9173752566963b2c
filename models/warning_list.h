#pragma once
// Collects warnings of a scene's parts, of which a file may make as many as it likes.

#include <cstddef>
#include <string>
#include <unordered_set>

#include "models/problem.h"

namespace glint {

/// Keeps each distinct line once, in the order in which they come. Of the lines after the first hundred it
/// keeps only the count.
class WarningList {
  public:
    static constexpr std::size_t most = 100;

    void add(const std::string& line);
    /// All of them; there are none afterwards.
    [[nodiscard]] Warnings take();

  private:
    Warnings first_;
    std::unordered_set<std::size_t> known_;  // hashes: lines may be long
};

}  // namespace glint
