#pragma once
// Lists the controls of a frame by name and position, so that tests find them directly. The program itself
// lists none.

#include <string>
#include <vector>

#include "ui/widgets/area.h"

namespace glint {

struct NamedControl {
    std::string name;      // the title of its tooltip
    std::string key;       // its tooltip's last line: the JSON pointer of its value, or keys of the keyboard
    std::string shortcut;  // the shortcut, if `key` is a value of the scene
    Rect at;               // position in the window
    bool in_sight = false;
};

/// Lists everything drawn from now on; null: lists nothing.
void list_controls_in(std::vector<NamedControl>* list);

/// Lists a control. tooltip() does so for the item drawn last; a clickable item without a tooltip calls this.
void list_control(const char* name, const std::string& key, const Rect& at);

}  // namespace glint
