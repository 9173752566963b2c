#pragma once
// Where the controls of a frame stand, by their names: tests find them so, instead of trying pixel after
// pixel. The program lists none.

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

/// tooltip() calls this of the item drawn last; whoever draws what can be pointed at but has no tooltip calls
/// it.
void list_control(const char* name, const std::string& key, const Rect& at);

}  // namespace glint
