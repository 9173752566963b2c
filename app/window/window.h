#pragma once
// The window: GLFW, a GL texture and the frame loop around ui/. The command line starts it.

#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"

namespace glint {

struct WindowOptions {
    std::string file;                     // what open_document() takes; empty: the default scene
    std::vector<Assignment> assignments;  // applied to the file as it is opened
    int threads = 0;                      // 0: all cores
    std::vector<std::string> files;       // `file` and those that PgDn shows after it
    std::string lesson;                   // its file; then no other file is opened
};

/// Opens the window and stays until it is closed. A file that takes long to open is awaited in the window.
/// Throws Failure (app/failure.h), for the one line on standard error, when the file cannot be opened or
/// drawn before that, there is no display, or the display has no OpenGL 3.0.
void run_window(const WindowOptions& options);

}  // namespace glint
