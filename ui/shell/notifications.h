#pragma once
// Short messages over the picture. Errors use the same text as the command line and stay until closed.

#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

#include "models/problem.h"

namespace glint {

struct UiState;

enum class Tone { Done, Warning, Error };

struct Notification {
    Tone tone = Tone::Done;
    std::string text;
    double until = 0;                               // ImGui time; infinity: until closed
    bool of_key = false;                            // reports what a key did, so undo and redo remove it
    double since = 0;                               // ImGui time
    int frame = 0;                                  // ImGui's frame count at that time
    std::string button = {};                        // the label of its button; empty: none
    std::function<void(UiState&)> press = nullptr;  // on a click, which also closes the notification
};

struct Notifications {
    std::vector<Notification> list;  // at most one notification
    int told = 0;                    // number of tell() calls

    /// Replaces the current notification. But if the current one was added in this frame, or is an error from
    /// the last two seconds, the text is added to it as another line. Cuts the middle out of a text that is
    /// longer than about nine lines.
    void add(Tone tone, const std::string& text);
    /// Reports what a key did. A refusal is shown as a warning.
    void tell(const std::string& text, Tone tone = Tone::Done);
    void add(const Problem& problem) { add(Tone::Error, problem.text()); }
    void add(const Warnings& warnings);
};

/// Draws the notification upwards from the corner `low_right` to at most `top`, or drops it once it has
/// expired. A notification added while a dialog is open stays in front of the dialog for some seconds.
void draw_notifications(UiState& state, ImVec2 low_right, float top, float max_width);

}  // namespace glint
