#pragma once
// Short messages over the picture. Errors have the words that the command line would print, and stay until
// closed.

#include <imgui.h>

#include <string>
#include <vector>

#include "models/problem.h"

namespace glint {

enum class Tone { Done, Warning, Error };

struct Notification {
    Tone tone = Tone::Done;
    std::string text;
    double until = 0;     // ImGui's time; infinity: until closed
    bool of_key = false;  // what a key did: the next key's takes its place
    double since = 0;     // ImGui's time
    int frame = 0;        // ImGui's count of frames then
};

struct Notifications {
    std::vector<Notification> list;

    /// A text of more than some nine lines is shown without its middle.
    void add(Tone tone, const std::string& text);
    /// Reports what a key did, in place of what the keys of earlier frames did. A refusal is a warning.
    void tell(const std::string& text, Tone tone = Tone::Done);
    void add(const Problem& problem) { add(Tone::Error, problem.text()); }
    void add(const Warnings& warnings);
};

/// Draws them upwards from the corner `low_right` to `top`, newest at the bottom, and drops those whose time
/// is over. In front of a dialog, those that came while it was open stand for some seconds.
void draw_notifications(Notifications& notifications, ImVec2 low_right, float top, float max_width);

}  // namespace glint
