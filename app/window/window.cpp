// glint [FILE...]: the window. Opens it, runs its frames, and keeps a copy of unsaved work when it ends.
#include <semaphore.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/window/window_frames.h"
#include "models/io/file.h"
#include "ui/document/loading.h"
#include "ui/document/scene_edit.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/course.h"
#include "ui/features/lessons/lesson.h"
#include "ui/preferences/persistence.h"
#include "ui/ui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
// Included last, because Xlib defines macros with common names.
#include <X11/Xlib.h>

namespace glint {
namespace {

constexpr int min_width = 320, min_height = 240;  // size of the window, in its own units
// A file that takes longer than this to open is loaded while the window shows the progress and can cancel it.
constexpr std::chrono::milliseconds max_time_without_window{1000};

struct WindowArguments {
    SceneArguments scene;
    std::vector<std::string> more;  // files that PgDn shows after the first
    std::string lesson;             // the lesson's file; if set, no other file is opened
};

/// The error when no window can be opened, with GLFW's message.
Failure no_window() {
    const char* description = nullptr;
    (void)glfwGetError(&description);
    return {
        ExitStatus::Impossible,
        {"", "",
         std::string("no window can be opened: ") +
             (description != nullptr ? description : "GLFW gave no reason"),
         "a display with OpenGL 3.2, or \"glint render FILE -o OUT.png\" for a picture without a window"}};
}

/// The scene that a new user sees first.
SceneDocument default_document(const std::vector<Assignment>& assignments) {
    const std::string path = asset_path("scenes/default.json");
    if (path.empty()) return first_scene();
    SceneDocument document = take(open_document(path, assignments));
    document.path.clear();  // a new scene: Ctrl+S must not overwrite the installed one
    document.assignments.clear();
    return document;
}

/// The initial contents of the window: a document, and what to do once it is open.
struct Beginning {
    SceneDocument document;
    std::function<void(UiState&)> opened;
    std::optional<Opening> loading;  // the default scene is shown until this has loaded
};

Beginning beginning(const WindowArguments& arguments) {
    const auto& [file, assignments, threads] = arguments.scene;
    if (arguments.lesson.empty() && file.empty())
        return {default_document(assignments), nullptr, std::nullopt};
    Opening opening =
        arguments.lesson.empty() ? opening_of(file, assignments) : opening_of_lesson(arguments.lesson);
    if (!opening.job->wait_for(max_time_without_window))
        return {default_document({}), nullptr, std::move(opening)};
    SceneDocument document = take(opening.job->take());
    return {std::move(document), std::move(opening.opened), std::nullopt};
}

struct Glfw {
    Glfw() {
        if (glfwInit() != GLFW_TRUE) throw no_window();
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

GLFWwindow* open_window(const Preferences& remembered) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    int x = 0, y = 0, width = 1440, height = 900;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int free_width = 0, free_height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &free_width, &free_height);
        // On a small display, the window fills it; on a large display, it covers most of it.
        width = free_width <= 1440 ? free_width : free_width * 9 / 10;
        height = free_height <= 900 ? free_height : free_height * 9 / 10;
        const bool fits = remembered.width <= free_width && remembered.height <= free_height;
        if (remembered.width > 0 && remembered.height > 0 && fits)
            width = remembered.width, height = remembered.height;
    }
    glfwWindowHint(GLFW_MAXIMIZED, remembered.maximized ? GLFW_TRUE : GLFW_FALSE);
    GLFWwindow* window =
        glfwCreateWindow(std::max(width, min_width), std::max(height, min_height), "Glint", nullptr, nullptr);
    if (window == nullptr) throw no_window();
    glfwSetWindowSizeLimits(window, min_width, min_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    return window;
}

/// Xlib ends the program on any error by default. GLFW resets the handler while it opens a window.
void handle_x_errors() {
    // Most errors are failed requests to a program that quit while a file was being dragged from it.
    XSetErrorHandler([](::Display*, XErrorEvent*) { return 0; });
    XSetIOErrorHandler([](::Display*) -> int {
        (void)std::fputs("glint: error: the connection to the display was lost\n", stderr);
        std::quick_exit(static_cast<int>(ExitStatus::Impossible));
    });
}

volatile std::sig_atomic_t ending_signal = 0;
sem_t signalled;

/// SIGHUP, SIGINT and SIGTERM end the frame loop. A second signal ends the program at once. An ignored signal
/// (nohup) stays ignored.
void catch_ending_signals() {
    sem_init(&signalled, 0, 0);
    // GLFW keeps waiting after a signal, and a handler must not call GLFW.
    std::thread([] {
        while (sem_wait(&signalled) != 0) {
        }
        glfwPostEmptyEvent();
    }).detach();
    struct sigaction action {};
    action.sa_handler = [](int number) {
        ending_signal = number;
        sem_post(&signalled);
    };
    action.sa_flags = SA_RESTART | SA_RESETHAND;
    for (const int number : {SIGHUP, SIGINT, SIGTERM}) {
        struct sigaction before {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
    }
}

/// Saves the settings and, after a signal, a copy of unsaved work. Then ends the program.
[[noreturn]] void end_window(UiState& state) {
    // Without a signal, the user has answered all questions and does not want to keep unsaved work.
    const bool kept = ending_signal != 0 && keep_unsaved_work(state);
    if (ending_signal != 0 && !kept && state.editor.unsaved())
        (void)std::fputs("glint: error: no copy of the unsaved work could be saved\n", stderr);
    end_persistence(state, kept);
    leave_lesson(state);
    glfwTerminate();
    if (ending_signal != 0) std::raise(ending_signal);  // informs the shell; the handler has been reset
    // Loads and exports may still be running, and a thread that is drawing a picture cannot be stopped.
    std::quick_exit(0);
}

/// Opens the window, runs it until it is closed, and ends the program. Throws Failure if the file,
/// which is opened first, cannot be opened, or if no display with OpenGL 3.2 is available.
[[noreturn]] void run_window(const WindowArguments& arguments) {
    UiState state(arguments.scene.threads);
    state.jobs.when_done = glfwPostEmptyEvent;
    Beginning first = beginning(arguments);
    take_document(state.editor, std::move(first.document));
    state.shipped_scenes = asset_path("scenes");
    state.get<LessonState>().folder = asset_path("lessons");
    state.get<LessonState>().inventory = asset_path("inventory.md");
    if (!arguments.more.empty()) {
        state.get<LectureState>().given_scenes = {arguments.scene.file};
        state.get<LectureState>().given_scenes.insert(state.get<LectureState>().given_scenes.end(),
                                                      arguments.more.begin(), arguments.more.end());
    }
    for (const std::string& warning : state.editor.document.warnings) say_warning(warning);
    begin_persistence(state, state_folder());
    const Glfw glfw;
    WindowFrames window(open_window(state.persistence.preferences), state);
    handle_x_errors();
    tell_averaged_normals(state);
    if (first.opened) first.opened(state);
    if (first.loading) await_opening(state, *std::move(first.loading));
    catch_ending_signals();
    try {
        window.run(ending_signal);
    } catch (...) {
        (void)keep_unsaved_work(state);
        throw;
    }
    end_window(state);
}

Run declare_window(Options& options) {
    auto arguments = std::make_shared<WindowArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "--lesson", "NAME", "open a lesson: its name, number or file (.md)", arguments->lesson);
    options.add_words("MORE", "more files; PgDn and PgUp step through all files in this order",
                      [&more = arguments->more](const std::string& text) { more.push_back(text); });
    return [arguments]() -> Outcome {
        auto& [scene, more, lesson] = *arguments;
        // A missing file is reported now, instead of when PgDn reaches it.
        for (const std::string& file : more)
            if (auto problem = why_not_there(file, "scenes, meshes, or pictures that Glint wrote"))
                throw Failure{ExitStatus::Impossible, *std::move(problem)};
        if (lesson.empty() && is_lesson_file(scene.file)) std::swap(lesson, scene.file);
        if (lesson.empty()) run_window(*arguments);
        if (!scene.file.empty())
            throw wrong_usage("--lesson", "cannot be combined with " + scene.file, "one of the two");
        if (!more.empty())
            throw wrong_usage(more.front(), "cannot be combined with a lesson", "the lesson alone");
        if (!scene.assignments.empty())
            throw wrong_usage("--set", "cannot be combined with a lesson, which has its own scene",
                              "one of the two");
        lesson = lesson_file(lesson);
        run_window(*arguments);
    };
}

}  // namespace

Command window_command() { return {"", "[FILE...]", "open the window", "glint teapot.json", declare_window}; }

}  // namespace glint
