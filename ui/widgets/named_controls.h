#pragma once
// Lists the controls of a frame by name and place, so that tests find them without trying pixel after pixel.
// The program itself lists none.

#include <string>
#include <vector>

#include "ui/widgets/area.h"

namespace glint {

struct NamedControl {
    std::string name;      // the title of its tooltip
    std::string key;       // its tooltip's last line: the JSON pointer of its value, or keys of the keyboard
    std::string shortcut;  // the keys that do the same, where the key names a value of the scene
    Rect at;               // in the window
    bool in_sight = false;
};

/// Takes what is drawn from now on; null: nothing is listed.
void list_controls_in(std::vector<NamedControl>* list);

/// Lists a control. tooltip() does so for the item drawn last; whoever draws something to point at without a
/// tooltip calls this.
void list_control(const char* name, const std::string& key, const Rect& at);

}  // namespace glint
