#pragma once
// The bare number of a field, which can be dragged, typed, or chosen from its menu. For the label, tooltip
// and row see ui/widgets/widgets.h.

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "models/fields/field_kinds.h"
#include "ui/widgets/theme.h"

namespace glint {

/// Return the lowest and highest floats in a range.
[[nodiscard]] float lowest(const Range& range);
[[nodiscard]] float highest(const Range& range);

/// Sets the value as close to `wanted` as the range allows; true if that changes it.
bool assign(float& value, double wanted, const Range& range);

/// Returns a value's position on its slider: 0 at the low end of its range, 1 at Real::usual_max, above 1
/// beyond that; and the inverse, clamped to the range. Precondition: has_slider(kind).
[[nodiscard]] double slider_share(double value, const Real& kind);
[[nodiscard]] double slider_value(double share, const Real& kind);
/// Whether the kind has a low end and a usual maximum, so that a bar can show the value.
[[nodiscard]] bool has_slider(const Real& kind);

/// Returns the opaque colour of a slider's bar on `ground`, on which text stays legible.
[[nodiscard]] ImVec4 slider_fill(const Theme& theme, const ImVec4& ground);

/// Returns the step of a drag with Ctrl: 1, 2 or 5 times a power of ten, close to the change per ten pixels.
[[nodiscard]] double drag_step(const Real& kind, double value);

/// Format `value`: for display, with at least two significant digits, no -0, and a power of ten if it would
/// not fit into a field; for copying and typing, as the shortest text that parses to the same float.
[[nodiscard]] std::string shown_text(float value, const Real& kind);
[[nodiscard]] std::string exact_text(float value);
/// Like shown_text(), but with only as many digits as fit into `width` in the current font, because a
/// truncated number would look like a different one.
[[nodiscard]] std::string fitting_text(float value, const Real& kind, float width);

struct NumberInput {
    const Real& kind;
    float initial = 0;    // default value; NaN if it has none
    std::string pointer;  // JSON pointer of its value in the scene file; empty if it has none
    float width = 0;      // width in ImGui's units
    bool slider =
        false;  // has_slider(kind), and is drawn as one: a drag over its full width covers the range
};

/// Draws the number and lets the user edit it; true if edited. It never leaves its range.
///
/// Dragging changes the number: with Shift in ten times finer steps, with Ctrl in steps of drag_step(). A
/// press without a drag, or Tab from the previous field, starts typing. The text is read by calculated() and
/// takes effect at once. Escape restores the previous value. A text that is not a number also restores it,
/// and is reported (take_said()). The right button opens a menu.
bool number_input(const char* id, float& value, const NumberInput& input);

/// Records that the scene rejects this frame's edit, and why. The caller has restored the value. If the
/// number is being typed, typing ends with the previous value and then reports the reason; a drag stays at
/// the last valid number; a value that was chosen or pasted is reported at once.
void refuse_edit(const std::string& why);
/// Reports that a number was clamped to its range.
void say_out_of_range(double wanted, const Range& range, float taken);

/// Focuses the number at `pointer`, or the first below it, if it is drawn in this frame.
void type_into(const std::string& pointer);

/// Ends the editing of a number, text or colour, which keeps its current value, and closes menus. Call this
/// when another scene replaces the current one, because pending input was about that one. A dialog stays
/// open.
void let_go_of_fields();

/// Whether a number is being typed or dragged, or was until this frame. Escape then affects only that number.
[[nodiscard]] bool number_in_hand();

/// A message from a control, for a notification.
struct Said {
    std::string line;
    bool refuses = false;  // the user's input was rejected, or only partly accepted
};
void say(const std::string& line);
void say_refused(const std::string& line);
/// Withdraws the last message.
void unsay();
/// Returns the messages since the last call, oldest first.
[[nodiscard]] std::vector<Said> take_said();
/// Returns the last text that was not a number, and forgets it. The code that draws the field may be able to
/// interpret it.
[[nodiscard]] std::string take_refused_text();

// Parses the text of a number field: a number or a small calculation. Does not draw.

struct Calculated {
    double value = 0;     // finite if `problem` is empty
    std::string problem;  // the error, a clause: "“)” is missing"
};

/// Calculates + − * / ^ ( ), also written × · and ÷, with pi (π), deg (π/180), sqrt, abs, and sin, cos, tan
/// of radians. A comma is a decimal point. A unit sign at the end (° or px) is ignored.
///
/// A text that begins with +, * or / continues from `before`: "+0.1", "*2", "/2"; so do "+=0.1", "-=0.1",
/// "*=2" and "/=2". But "-0.1" is a negative number. Problem: the text is empty, is not a calculation, or has
/// no finite value.
[[nodiscard]] Calculated calculated(std::string_view text, double before);

}  // namespace glint
