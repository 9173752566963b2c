#include "ui/widgets/named_controls.h"

#include "ui/widgets/shortcut.h"

namespace glint {
namespace {

std::vector<NamedControl>* listed = nullptr;

}  // namespace

void list_controls_in(std::vector<NamedControl>* list) { listed = list; }

void list_control(const char* name, const std::string& key, const Rect& at) {
    if (listed == nullptr) return;
    listed->push_back({name, key, keys_of_value(key), at, ImGui::IsRectVisible(at.low, at.high)});
}

}  // namespace glint
