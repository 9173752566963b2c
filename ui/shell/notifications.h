#pragma once
// Short messages over the picture. Errors use the same text as the command line and stay until closed.

#include <imgui.h>

#include <string>
#include <vector>

#include "models/problem.h"

namespace glint {

enum class Tone { Done, Warning, Error };

struct Notification {
    Tone tone = Tone::Done;
    std::string text;
    double until = 0;     // ImGui time; infinity: until closed
    bool of_key = false;  // reports what a key did: the next key's message replaces it
    double since = 0;     // ImGui time
    int frame = 0;        // ImGui's frame count at that time
};

struct Notifications {
    std::vector<Notification> list;

    /// Cuts the middle out of a text of more than about nine lines.
    void add(Tone tone, const std::string& text);
    /// Reports what a key did, replacing messages of keys from earlier frames. A refusal is a warning.
    void tell(const std::string& text, Tone tone = Tone::Done);
    void add(const Problem& problem) { add(Tone::Error, problem.text()); }
    void add(const Warnings& warnings);
};

/// Draws them upwards from the corner `low_right` to `top`, newest at the bottom, and drops expired ones. In
/// front of a dialog, those added while it was open stay for some seconds.
void draw_notifications(Notifications& notifications, ImVec2 low_right, float top, float max_width);

}  // namespace glint
