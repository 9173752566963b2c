#include "app/window/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "app/assets.h"
#include "app/failure.h"
#include "app/window/canvas.h"
#include "app/window/gl.h"
#include "app/window/texture.h"
#include "app/window/window_input.h"
#include "app/window/x_errors.h"
#include "ui/document/averaged_normals.h"
#include "ui/lessons/lesson.h"
#include "ui/preferences/persistence.h"
#include "ui/shell/frame_changes.h"
#include "ui/ui.h"
#include "ui/widgets/display_scale.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"

namespace glint {
namespace {

constexpr int least_width = 320, least_height = 240;  // of the window, in its own units
constexpr double longest_farewell = 0.3;              // seconds that a closed window's loads may take to end

/// What keeps the window from opening, with the way to do without it.
Failure impossible(const std::string& what, const std::string& expected) {
    const std::string without = ", or \"glint render FILE -o OUT.png\" for a picture without a window";
    return {ExitStatus::Impossible, {"", "", what, expected + without}};
}

Result<SceneDocument> first_document(const WindowOptions& options) {
    if (!options.file.empty()) return open_document(options.file, options.assignments);
    // The scene that a newcomer meets.
    const std::string path = asset_path("scenes/default.json");
    if (path.empty()) return first_scene();
    Result<SceneDocument> opened = open_document(path, options.assignments);
    // Ctrl+S must not write over the program's own scene: it is a new one, its meshes found where they are.
    if (auto* document = std::get_if<SceneDocument>(&opened)) document->path.clear();
    return opened;
}

/// Ends GLFW on every way out.
struct Glfw {
    bool ready;
    Glfw() {
        // GLFW's own words would be a second line; what matters is said once, by us.
        glfwSetErrorCallback([](int, const char*) {});
        ready = glfwInit() == GLFW_TRUE;
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

GLFWwindow* make_window(const Preferences& remembered) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
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

/// The window with all that draws in it.
class Window {
  public:
    Window(GLFWwindow* window, UiState& state) : window_(window), state_(state) {
        glfwMakeContextCurrent(window);
        glfwSwapInterval(1);
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        collect_input(window, input_);
        ready_ = ImGui_ImplGlfw_InitForOpenGL(window, true) && ImGui_ImplOpenGL3_Init("#version 130");
        if (ready_ && gl().complete) canvas_ = std::make_unique<Canvas>();
        files_ = find_fonts();
    }
    ~Window() {
        canvas_.reset();
        sheets_.clear();
        if (ready_) ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        glfwDestroyWindow(window_);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] bool ready() const { return canvas_ && canvas_->ready(); }

    void run() {
        bool shown = false;
        while (true) {
            const UiRequests wants = frame();
            if (wants.quit) return;
            if (!shown) glfwShowWindow(window_);
            shown = true;
            wait(wants.sleep_s);
        }
    }

  private:
    /// ImGui needs a frame or two after an event until all that follows from it is drawn.
    static constexpr int frames_after_event = 3;
    /// Seconds to the next frame after one that showed nothing new, and so did not wait for the display.
    static constexpr double quiet_frame = 1 / 120.0;

    void wait(double seconds) {
        handle_x_errors(end_without_display);
        if (frames_due_ > 0) {
            --frames_due_;
            return glfwPollEvents();
        }
        const double start = glfwGetTime();
        if (std::isinf(seconds))
            glfwWaitEvents();
        else
            glfwWaitEventsTimeout(std::max(seconds, shows_ ? 0.001 : quiet_frame));
        // A tooltip is measured in its first frame and seen in its second.
        frames_due_ = glfwGetTime() - start < seconds ? frames_after_event - 1 : 1;
    }

    /// Asks only once a frame: while the window is being resized, two questions get two answers.
    void measure() {
        glfwGetWindowSize(window_, &extent_.size.x, &extent_.size.y);
        glfwGetFramebufferSize(window_, &extent_.dots.x, &extent_.dots.y);
        glfwGetWindowSize(window_, &extent_.size_after.x, &extent_.size_after.y);
        float down = 1;
        glfwGetWindowContentScale(window_, &extent_.content_scale, &down);
    }

    /// Type and theme follow the display's scale and the user's choice.
    void follow_scale() {
        const DisplayScale display = display_scale(extent_, display_);
        const bool projector = state_.lecture.projector;
        const float scale = projector ? display.design * projector_scale : display.design;
        const Theme& wanted = projector     ? projector_theme(state_.dark)
                              : state_.dark ? dark_theme()
                                            : light_theme();
        const bool scaled = scale != scale_ || display.dots_per_unit != display_.dots_per_unit;
        if (scaled) {
            load_fonts(files_, scale, display.dots_per_unit);
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            ImGui_ImplOpenGL3_CreateFontsTexture();
        }
        if (!scaled && &wanted == &theme()) return;
        apply_theme(wanted, scale);
        draws_all_ = true;
        scale_ = scale;
        display_ = display;
    }

    /// Overrides the backend's sizes: it asks for them itself and divides answers that need not fit.
    void use_extent() const {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {float(extent_.size_after.x), float(extent_.size_after.y)};
        io.DisplayFramebufferScale = {display_.dots_per_unit, display_.dots_per_unit};
    }

    /// Asked only when something changed: the display takes its time to answer.
    void note_size() {
        if (extent_.size == noted_ && !input_.maximize_changed) return;
        noted_ = extent_.size;
        input_.maximize_changed = false;
        Preferences& settings = state_.persistence.preferences;
        settings.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
        if (!settings.maximized) settings.width = noted_.x, settings.height = noted_.y;
    }

    UiRequests frame() {
        measure();
        follow_scale();
        if (const auto error = take_x_error()) state_.notifications.add(Tone::Warning, *error);
        note_size();
        read_held_keys(window_, input_.ui);
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        use_extent();
        if (feed_keys(window_, input_)) frames_due_ = frames_after_event;
        if (feed_button(input_)) frames_due_ = frames_after_event;
        ImGui::NewFrame();
        name_sheets();
        UiRequests wants = ui_frame(state_, input_.ui);
        ImGui::Render();
        input_.ui = {};
        draws_all_ = draws_all_ || std::exchange(input_.refresh_asked, false);
        upload_sheets();
        const std::vector<Rect> changed = changes_.update(*ImGui::GetDrawData());
        shows_ = draw(changed);
        if (!wants.title.empty() && wants.title != title_) {
            title_ = wants.title;
            glfwSetWindowTitle(window_, title_.c_str());
        }
        return wants;
    }

    /// Gives every sheet of small pictures its texture.
    void name_sheets() {
        for (PictureSheet* sheet : sheets_of(state_)) {
            if (!sheets_[sheet].texture)
                sheets_[sheet].texture = std::make_unique<Texture>(Texture::Use::Sampled);
            sheet->texture = sheets_[sheet].texture->id();
        }
    }
    void upload_sheets() {
        for (auto& [sheet, shown] : sheets_) {
            if (sheet->serial == shown.serial) continue;
            shown.texture->upload(sheet->picture);
            shown.serial = sheet->serial;
            draws_all_ = true;  // wherever it is shown
        }
    }

    [[nodiscard]] PixelRect pixels_of(const Rect& rect) const {
        const float dots = display_.dots_per_unit;
        return {int(std::lround(rect.low.x * dots)), int(std::lround(rect.low.y * dots)),
                int(std::lround(rect.high.x * dots)), int(std::lround(rect.high.y * dots))};
    }
    [[nodiscard]] PixelRect pixels_around(const Rect& rect) const {
        const float dots = display_.dots_per_unit;
        return {int(std::floor(rect.low.x * dots)), int(std::floor(rect.low.y * dots)),
                int(std::ceil(rect.high.x * dots)), int(std::ceil(rect.high.y * dots))};
    }

    /// Draws what has changed and shows it. Returns false, and does nothing, if nothing has.
    bool draw(std::vector<Rect> changed) {
        const PlacedPicture& placed = state_.picture_rect;
        if (state_.picture_serial != shown_ || placed != placed_) {
            add_rect(changed, placed.room);
            add_rect(changed, placed_.room);
        }
        placed_ = placed;
        shown_ = state_.picture_serial;
        const PictureSize size{extent_.dots.x, extent_.dots.y};
        if (size.width <= 0 || size.height <= 0) return false;  // iconified
        const PixelRect whole{0, 0, size.width, size.height};
        if (canvas_->resize(size) || draws_all_) {
            draw_within(whole);
        } else {
            if (changed.empty()) return false;
            for (const Rect& rect : changed) {
                const PixelRect part = intersection(pixels_around(rect), whole);
                if (!part.is_empty()) draw_within(part);
            }
        }
        draws_all_ = false;
        canvas_->show();
        glfwSwapBuffers(window_);
        return true;
    }

    void draw_within(const PixelRect& part) {
        canvas_->draw_picture(state_.displayed, pixels_of(placed_.picture), pixels_of(placed_.room), part,
                              theme().panel);
        canvas_->draw(*ImGui::GetDrawData(), part, display_.dots_per_unit);
    }

    GLFWwindow* window_;
    UiState& state_;
    WindowInput input_;
    struct ShownSheet {
        std::unique_ptr<Texture> texture;
        std::uint64_t serial = 0;
    };
    std::unique_ptr<Canvas> canvas_;
    FrameChanges changes_;
    PlacedPicture placed_;  // as drawn last
    std::map<PictureSheet*, ShownSheet> sheets_;
    FontFiles files_;
    std::string title_;
    WindowExtent extent_;
    glm::ivec2 noted_{0};  // the size that the settings know
    DisplayScale display_;
    float scale_ = 0;          // of the design, as applied; 0 before the first frame
    std::uint64_t shown_ = 0;  // the picture drawn last
    int frames_due_ = frames_after_event;
    bool ready_ = false;
    bool draws_all_ = true;  // what is on the canvas is not what it was, or the display lost it
    bool shows_ = true;      // the last frame showed something new
};

}  // namespace

void run_window(const WindowOptions& options) {
    UiState state(options.threads);
    std::shared_ptr<const Course> course;
    if (!options.lesson.empty()) course = take(open_course(options.lesson));
    take_document(state.editor, course ? course->document : take(first_document(options)));
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
    Window window(handle, state);
    if (!window.ready()) throw impossible("the display has no OpenGL 3.0", "a driver that has it");
    tell_averaged_normals(state);
    if (course) begin_lesson(state, course);
    try {
        window.run();
    } catch (...) {
        (void)keep_unsaved_work(state);
        throw;
    }
    open_state = nullptr;  // all is answered: what is not saved was not to be
    end_persistence(state);
    // Ends jobs that nobody waits for any more. Everything that was to be kept is written.
    glfwHideWindow(handle);
    if (!end_jobs(state, longest_farewell)) std::quick_exit(0);
}

}  // namespace glint
