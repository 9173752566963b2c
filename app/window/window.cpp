#include "app/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/assets.h"
#include "app/failure.h"
#include "app/window/clipboard.h"
#include "app/window/ending_signals.h"
#include "app/window/window_frames.h"
#include "app/window/x_errors.h"
#include "ui/document/averaged_normals.h"
#include "ui/document/loading.h"
#include "ui/lessons/lesson.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

namespace glint {
namespace {

constexpr int least_width = 320, least_height = 240;  // of the window, in its own units
constexpr double longest_farewell = 0.3;              // seconds that a closed window's loads may take to end
// What a file may take to open before the window does; then the window shows how far it has come, and Cancel.
constexpr std::chrono::milliseconds longest_without_window{1000};

/// What keeps the window from opening, with the way to do without it.
Failure impossible(const std::string& what, const std::string& expected) {
    const std::string without = ", or \"glint render FILE -o OUT.png\" for a picture without a window";
    return {ExitStatus::Impossible, {"", "", what, expected + without}};
}

/// The scene that a newcomer meets.
SceneDocument default_document(const std::vector<Assignment>& assignments) {
    const std::string path = asset_path("scenes/default.json");
    if (path.empty()) return first_scene();
    SceneDocument document = take(open_document(path, assignments));
    document.path.clear();  // Ctrl+S must not write over the program's own scene: it is a new one
    document.assignments.clear();
    return document;
}

/// What the window begins with: a document, and a lesson where it is one's.
struct Beginning {
    SceneDocument document;
    std::shared_ptr<const Course> course;
    std::optional<Opening> awaited;  // what takes its time: the default scene is shown until it is there
};

Beginning beginning(const WindowOptions& options) {
    if (options.lesson.empty() && options.file.empty())
        return {default_document(options.assignments), nullptr, std::nullopt};
    Opening opening = options.lesson.empty() ? opening_of(options.file, options.assignments)
                                             : opening_of_lesson(options.lesson);
    if (!opening.job->wait_for(longest_without_window))
        return {default_document({}), nullptr, std::move(opening)};
    SceneDocument document = take(opening.job->take());
    return {std::move(document), opening.course ? *opening.course : nullptr, std::nullopt};
}

/// Ends GLFW on every way out.
struct Glfw {
    bool ready;
    Glfw() {
        // GLFW's own words would be a second line; what matters is said once, by us.
        glfwSetErrorCallback([](int, const char*) {});
        ready = glfwInit() == GLFW_TRUE;
    }
    ~Glfw() {
        end_within(5);
        glfwTerminate();
        end_within(0);
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

GLFWwindow* make_window(const Preferences& remembered) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    int x = 0, y = 0, width = 1440, height = 900;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int free_width = 0, free_height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &free_width, &free_height);
        // All of a small display; most of a large one.
        width = free_width <= 1440 ? free_width : free_width * 9 / 10;
        height = free_height <= 900 ? free_height : free_height * 9 / 10;
        const bool fits = remembered.width <= free_width && remembered.height <= free_height;
        if (remembered.width > 0 && remembered.height > 0 && fits)
            width = remembered.width, height = remembered.height;
    }
    glfwWindowHint(GLFW_MAXIMIZED, remembered.maximized ? GLFW_TRUE : GLFW_FALSE);
    return glfwCreateWindow(std::max(width, least_width), std::max(height, least_height), "Glint", nullptr,
                            nullptr);
}

UiState* open_state = nullptr;  // of the window that is open

/// Ends the program when the connection to the display breaks: unsaved work is kept for the next window. Xlib
/// may be in the middle of anything, so only half-written files are removed.
void end_without_display() {
    const bool kept = open_state != nullptr && keep_unsaved_work(*open_state);
    fmt::print(stderr, "glint: error: the display has gone{}\n",
               kept ? "; a copy of the unsaved work is kept, and the next window offers it" : "");
    std::quick_exit(static_cast<int>(ExitStatus::Impossible));
}

}  // namespace

void run_window(const WindowOptions& options) {
    UiState state(options.threads);
    Beginning first = beginning(options);
    take_document(state.editor, std::move(first.document));
    state.shipped_scenes = asset_path("scenes");
    state.lesson.folder = asset_path("lessons");
    state.lesson.inventory = asset_path("inventory.md");
    if (options.files.size() > 1) state.lecture.given_scenes = options.files;
    for (const std::string& warning : state.editor.document.warnings) say_warning(warning);
    begin_persistence(state, state_folder());
    const Glfw glfw;
    if (!glfw.ready)
        throw impossible("no display to open a window on", "one that DISPLAY or WAYLAND_DISPLAY names");
    GLFWwindow* handle = make_window(state.persistence.preferences);
    if (handle == nullptr) throw impossible("the display has no OpenGL 3.0", "a driver that has it");
    glfwSetWindowSizeLimits(handle, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    open_state = &state;
    handle_x_errors(end_without_display);
    WindowFrames window(handle, state, end_without_display);
    if (!window.ready()) throw impossible("the display has no OpenGL 3.0", "a driver that has it");
    tell_averaged_normals(state);
    if (first.course) begin_lesson(state, first.course);
    if (first.awaited) await_opening(state, *std::move(first.awaited));
    std::optional<EndingSignals> signals(std::in_place);
    try {
        window.run(*signals);
    } catch (...) {
        (void)keep_unsaved_work(state);
        throw;
    }
    open_state = nullptr;
    const int signal = signals->number();
    // Without a signal the user closed the window and answered all questions: unsaved work is not wanted.
    const bool kept = signal != 0 && keep_unsaved_work(state);
    if (signal != 0 && !kept && state.editor.unsaved())
        (void)std::fputs("glint: error: no copy of the unsaved work could be kept\n", stderr);
    end_persistence(state, kept);
    leave_lesson(state);
    signals.reset();
    if (signal != 0) std::raise(signal);  // a shell is told it
    // Ends jobs that nobody waits for any more. Everything that was to be kept is written.
    glfwHideWindow(handle);
    if (!end_jobs(state, longest_farewell)) std::quick_exit(0);
}

}  // namespace glint
