#pragma once
// The controls of every panel: a label and a field in a row, with a tooltip that explains it and shows unit,
// range, default and key in the scene file. Each edits its value; some return whether they changed it.

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

/// A label and a number of that kind. Its value always stays in range, however it is entered. The number can
/// be dragged, or typed after a click, and has a menu: see ui/widgets/numbers/number_input.h.
bool number_field(const char* label, float& value, const Real& kind, float initial, const Help& help);
/// Only the number, `width` wide, for use within text; same behaviour and tooltip.
bool bare_number(const char* label, float& value, const Real& kind, float initial, const Help& help,
                 float width);
/// An integer in the range of `count`; the caller must reject values within the range that are not allowed.
bool integer_field(const char* label, int& value, const Count& count, int initial, const Help& help);
/// Three numbers of that kind.
void vector_field(const char* label, glm::vec3& value, const Real& kind, glm::vec3 initial, const Help& help);
/// A colour in linear RGB, each channel >= 0, with a swatch that opens a picker and presets.
void colour_field(const char* label, glm::vec3& value, glm::vec3 initial, const Help& help);
bool switch_field(const char* label, bool& value, const Help& help);
void name_field(const char* label, std::string& name, std::size_t max_characters, const Help& help);

/// Only the text field of a name, as wide as ImGui's next item; flags are ImGuiInputTextFlags.
void bare_name(const char* id, std::string& name, std::size_t max_characters, int flags = 0);

/// Return the chosen index; `chosen` if nothing changed. The choices are a drop-down, alone or in a row, or
/// joined buttons.
[[nodiscard]] int drop_down(const char* label, int chosen, std::span<const Choice> options, const Help& help);
[[nodiscard]] int choose(const char* label, int chosen, std::span<const Choice> options, const Help& help);
[[nodiscard]] int segments(const char* id, int chosen, std::span<const Choice> options, const Help& help);
/// Returns the width that segments() takes up if there is room; with less room, its labels are closer
/// together.
[[nodiscard]] float segments_width(std::span<const Choice> options);

/// Shows a tooltip for the item drawn last, once the pointer has hovered over it: title, explanation, and two
/// more lines (range and default; the key). Empty lines are left out.
void tooltip(const char* title, const char* what, const std::string& range = "", const std::string& key = "");

/// Returns a name or path from the user as a label that ImGui draws completely and on one line; otherwise it
/// would omit everything after "##".
[[nodiscard]] std::string whole_label(const std::string& name);

/// Requests another frame within `seconds`, e.g. when a tooltip is due. next_redraw() is the earliest request
/// since reset_next_redraw(); infinity if there was none.
void redraw_within(double seconds);
void reset_next_redraw();
[[nodiscard]] double next_redraw();

/// Whether controls drawn now are read-only, because they are between ImGui's BeginDisabled() and
/// EndDisabled().
[[nodiscard]] bool is_read_only();

/// A rectangle that receives the mouse and draws nothing, for a control that draws itself; true when clicked.
/// It is made at least one unit wide and high, because ImGui terminates the program over an invisible button
/// without an area, and takes a negative size as a distance from the right.
bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags = 0);

/// Starts a row: the label in its column, the field after it. Returns the width left for the field.
float label_cell(const char* label);
void section_heading(const char* title);
void dim_text(const char* text);
/// Formats a count with spaces between the thousands: "12 946".
[[nodiscard]] std::string with_thousands(std::uint64_t n);
/// Draws text in figures of equal width.
void mono_text(const std::string& text);

/// A colour to choose: one of the pure colours used in lectures, or the colour of a lamp.
struct ColourPreset {
    const char* name;
    glm::vec3 linear;  // linear sRGB; the largest channel is at most 1
    int kelvin = 0;    // for a lamp, the temperature of the black body with this chromaticity; else 0
};

/// Returns the presets; lamps come last, from the warmest to the coldest.
[[nodiscard]] std::span<const ColourPreset> colour_presets();

// Lists the controls of a frame by name and position, so that tests find them directly. The program itself
// does not list any.

struct NamedControl {
    std::string name;      // the title of its tooltip
    std::string key;       // last line of its tooltip: the JSON pointer of its value, or its keys
    std::string shortcut;  // its shortcut, if `key` is a value of the scene
    Rect at;               // position in the window
    bool in_sight = false;
};

/// Adds all controls drawn from now on to `list`; null ends this.
void list_controls_in(std::vector<NamedControl>* list);

/// Lists a control. tooltip() does so for the item drawn last; for a clickable item without a tooltip, call
/// this.
void list_control(const char* name, const std::string& key, const Rect& at);

// One-line text fields.

/// A text field that shows `hint` while it is empty. Returns true if the text was changed or, with
/// EnterReturnsTrue (flags are ImGuiInputTextFlags), if Enter ended the typing. During an edit Dear ImGui
/// stores text in 16 bits per character: an edit turns an emoji, or a byte that is not UTF-8, into U+FFFD.
/// Focus without an edit does not.
[[nodiscard]] bool text_field(const char* label, const char* hint, std::string& text, int flags = 0);

/// During its lifetime, line breaks within pasted text become spaces, and one at its end is dropped. Dear
/// ImGui would drop all of them, so a pasted column of numbers would become one number.
class PasteInOneLine {
  public:
    PasteInOneLine();
    ~PasteInOneLine();
    PasteInOneLine(const PasteInOneLine&) = delete;
    PasteInOneLine& operator=(const PasteInOneLine&) = delete;
};

}  // namespace glint
