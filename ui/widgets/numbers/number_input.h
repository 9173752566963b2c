#pragma once
// The bare number of a field: dragged, typed, or chosen from its menu. Label, tooltip and row are those of
// ui/widgets/widgets.h.

#include <imgui.h>

#include <string>
#include <vector>

#include "models/fields/field_kinds.h"
#include "ui/widgets/theme.h"

namespace glint {

/// The lowest and highest floats that are in a range.
[[nodiscard]] float lowest(const Range& range);
[[nodiscard]] float highest(const Range& range);

/// Brings the value as near to `wanted` as the range allows; true when it is another value than before.
bool assign(float& value, double wanted, const Range& range);

/// How far along its slider a value is: 0 at the low end of its range, 1 at Real::usual_max, more beyond; and
/// back, within its range. Precondition: has_slider(kind).
[[nodiscard]] double slider_share(double value, const Real& kind);
[[nodiscard]] double slider_value(double share, const Real& kind);
/// Whether the kind has a low end and a usual largest value, so that a bar can show how much of it there is.
[[nodiscard]] bool has_slider(const Real& kind);

/// The colour of a slider's bar on `ground`, opaque: text upon it can be read.
[[nodiscard]] ImVec4 slider_fill(const Theme& theme, const ImVec4& ground);

/// Returns the step of a drag with Ctrl: 1, 2 or 5 times a power of ten, about as much as ten pixels.
[[nodiscard]] double drag_step(const Real& kind, double value);

/// Formats `value` for display: at least two significant digits, no -0, and a power of ten where it would not
/// fit into a field; or as copied and typed: the shortest text that reads back as the same float.
[[nodiscard]] std::string shown_text(float value, const Real& kind);
[[nodiscard]] std::string exact_text(float value);
/// shown_text(), or with as many digits as fit into `width` in the current font: what is cut off at its end
/// reads as another number.
[[nodiscard]] std::string fitting_text(float value, const Real& kind, float width);

struct NumberInput {
    const Real& kind;
    float initial = 0;    // its default; NaN: it has none
    std::string pointer;  // JSON pointer of its value in the scene file; empty: it has none
    float width = 0;      // in ImGui's units
    bool slider =
        false;  // has_slider(kind), and is drawn as one: a drag of all its width goes from end to end
};

/// Draws the number and lets it be edited; true when it was. It never leaves its range.
///
/// Dragging changes the number: with Shift in ten times finer steps, with Ctrl in those of drag_step(). A
/// press without a drag, or Tab from the field before, starts typing. The text is read by calculated() and
/// takes effect at once. Escape restores the value from before, and so does a text that is not a number,
/// which is reported (take_said()). The right button opens a menu.
[[nodiscard]] bool number_input(const char* id, float& value, const NumberInput& input);

/// Notes that the scene does not allow what was edited in this frame, and why. The caller has restored the
/// value. Typing then ends with the value from before and reports it; a drag stays at the last possible
/// number; a value that was chosen or pasted is reported at once.
void refuse_edit(const std::string& why);
/// Says that a number was brought into its range.
void say_out_of_range(double wanted, const Range& range, float taken);

/// The number at `pointer`, or the first below it, takes the keyboard if it is drawn in this frame.
void type_into(const std::string& pointer);

/// Ends the editing of a number, text or colour, which keeps its present value, and closes menus. Call it
/// when another scene replaces this one: what was typed, held or asked was about the scene before. A dialog
/// stays as it is.
void let_go_of_fields();

/// Whether a number is being typed or dragged: Escape is then about that number alone.
[[nodiscard]] bool number_in_hand();

/// A line from a control, for a notification.
struct Said {
    std::string line;
    bool refuses = false;  // what the user asked for was not done, or not entirely
};
void say(const std::string& line);
void say_refused(const std::string& line);
/// Withdraws the last line.
void unsay();
/// Returns the lines since the last call, oldest first.
[[nodiscard]] std::vector<Said> take_said();
/// Returns, once, the last text that was not a number: whoever draws the field may understand it better.
[[nodiscard]] std::string take_refused_text();

/// The menu of a number, while it is open: Copy, Paste, Reset, Copy pointer. True when it set the value.
[[nodiscard]] bool number_menu(float& value, const NumberInput& input);
inline constexpr const char* number_menu_id = "##number menu";

}  // namespace glint
