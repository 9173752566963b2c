#pragma once
// The controls of every panel: a label and a field in a row, with a tooltip that explains it and shows unit,
// range, default and key in the scene file. Each edits its value; some return whether they did.

#include <imgui.h>

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "models/fields/field_kinds.h"
#include "models/numbers.h"
#include "ui/widgets/area.h"

namespace glint {

/// The description of a control. `pointer` is the JSON pointer of its value in the scene file.
struct Help {
    const char* what = "";
    std::string pointer;
};

/// Label and draggable number of that kind. Values always stay in its range, however they are entered. It can
/// be dragged, typed after a click, and has a menu: ui/widgets/numbers/number_input.h.
bool number_field(const char* label, float& value, const Real& kind, float initial, const Help& help);
/// The bare draggable number, `width` wide, for use within text; same behaviour and tooltip.
bool bare_number(const char* label, float& value, const Real& kind, float initial, const Help& help,
                 float width);
/// Integers in the range of `count`; the caller must reject values that are not allowed.
bool integer_field(const char* label, int& value, const Count& count, int initial, const Help& help);
/// Three numbers of that kind.
void vector_field(const char* label, glm::vec3& value, const Real& kind, glm::vec3 initial, const Help& help);
/// Linear RGB, each >= 0, with a swatch that opens a picker and presets.
void colour_field(const char* label, glm::vec3& value, glm::vec3 initial, const Help& help);
bool switch_field(const char* label, bool& value, const Help& help);
void name_field(const char* label, std::string& name, std::size_t max_characters, const Help& help);

/// The bare text of a name, as wide as ImGui's next item; flags are ImGuiInputTextFlags.
void bare_name(const char* id, std::string& name, std::size_t max_characters, int flags = 0);

/// The chosen index; `chosen` if nothing changed. As a drop-down, alone or in a row, or as joined buttons.
[[nodiscard]] int drop_down(const char* label, int chosen, std::span<const Choice> options, const Help& help);
[[nodiscard]] int choose(const char* label, int chosen, std::span<const Choice> options, const Help& help);
[[nodiscard]] int segments(const char* id, int chosen, std::span<const Choice> options, const Help& help);
/// Width that segments() takes if there is room; with less, its labels are closer together.
[[nodiscard]] float segments_width(std::span<const Choice> options);

/// A tooltip for the item drawn last, after the pointer hovered over it: title, explanation, and two lower
/// lines (range and default; the key). Empty ones are left out.
void tooltip(const char* title, const char* what, const std::string& range = "", const std::string& key = "");

/// A user's name or a path as a label that ImGui draws completely and on one line: it would omit everything
/// after "##".
[[nodiscard]] std::string whole_label(const std::string& name);

/// Requests another frame within `seconds`, e.g. when a tooltip is due. next_redraw() is the earliest request
/// since reset_next_redraw(); infinity if there was none.
void redraw_within(double seconds);
void reset_next_redraw();
[[nodiscard]] double next_redraw();

/// Whether controls drawn now are read-only: between ImGui's BeginDisabled() and EndDisabled().
[[nodiscard]] bool is_read_only();

/// A rectangle that receives the mouse and draws nothing, for a control that draws itself; true when clicked.
/// At least one unit wide and high: ImGui terminates the program over an invisible button without an area,
/// and reads a negative size as a distance from the right.
bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);

/// Starts a row: the label in its column, the field after it. Returns the width left for the field.
float label_cell(const char* label);
void section_heading(const char* title);
void dim_text(const char* text);
/// A count in the common format: "12 946".
[[nodiscard]] std::string with_thousands(std::uint64_t n);
/// Text in figures of equal width.
void mono_text(const std::string& text);

/// A colour to choose: one of the pure ones used in lectures, or that of a lamp.
struct ColourPreset {
    const char* name;
    glm::vec3 linear;  // linear sRGB, the largest channel at most 1
    int kelvin = 0;    // for a lamp, the temperature of the black body with this chromaticity; else 0
};

/// The lamps come after the others, from the warmest to the coldest.
[[nodiscard]] std::span<const ColourPreset> colour_presets();

// Lists the controls of a frame by name and position, so that tests find them directly. The program itself
// lists none.

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

// One-line text fields.

/// A text field that shows `hint` while it is empty. Returns true when the text was changed, or with
/// EnterReturnsTrue (flags are ImGuiInputTextFlags) when Enter ended the typing. During an edit Dear ImGui
/// stores text in 16 bits per character: an edit turns an emoji, or a byte that is not UTF-8, into U+FFFD.
/// Focus without an edit does not.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0);

/// During its lifetime a line break within pasted text becomes a space, and one at its end is dropped. Dear
/// ImGui would drop all of them: a pasted column of numbers would become one number.
class PasteInOneLine {
  public:
    PasteInOneLine();
    ~PasteInOneLine();
    PasteInOneLine(const PasteInOneLine&) = delete;
    PasteInOneLine& operator=(const PasteInOneLine&) = delete;
};

}  // namespace glint
