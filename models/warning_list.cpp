#include "models/warning_list.h"

#include <functional>
#include <utility>

namespace glint {

void WarningList::add(const std::string& line) {
    if (known_.insert(std::hash<std::string>()(line)).second && first_.size() < most) first_.push_back(line);
}

Warnings WarningList::take() {
    warn(first_, known_.size() - first_.size(), "more warning of this kind", "more warnings of this kind");
    known_.clear();
    return std::exchange(first_, {});
}

}  // namespace glint
