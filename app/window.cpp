#include "app/window.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <cstdio>

namespace glint {
namespace {

/// GLFW's own words would be a second line; what matters is said once, by us.
void stay_quiet(int /*code*/, const char* /*words*/) {}

int no_display() {
    fmt::print(
        stderr,
        "glint: error: no display to open a window on; use \"glint render FILE -o OUT.png\" for a picture\n");
    return 1;
}

}  // namespace

int run_window(const WindowOptions& options) {
    (void)options;
    glfwSetErrorCallback(stay_quiet);
    if (glfwInit() == GLFW_FALSE) return no_display();
    glfwTerminate();
    return 0;
}

}  // namespace glint
