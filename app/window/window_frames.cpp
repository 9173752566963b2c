#include "app/window/window_frames.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/arguments.h"
#include "ui/features/lecture/lecture.h"
#include "ui/widgets/theme.h"

namespace glint {

WindowFrames::WindowFrames(GLFWwindow* window, UiState& state) : window_(window), state_(state) {
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    collect_input(window, input_);
    if (!ImGui_ImplGlfw_InitForOpenGL(window, true) || !ImGui_ImplOpenGL3_Init("#version 150"))
        throw Failure{ExitStatus::Impossible, {"", "", "OpenGL cannot be loaded", "libGL.so.1"}};
    collect_text(window);
    canvas_ = std::make_unique<Canvas>();
    files_ = find_fonts();
}

WindowFrames::~WindowFrames() {
    canvas_.reset();
    sheets_.clear();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
}

void WindowFrames::run(const volatile std::sig_atomic_t& ending_signal) {
    bool shown = false;
    while (true) {
        const UiRequests wants = frame();
        if (wants.quit || ending_signal != 0) return;
        if (!shown) glfwShowWindow(window_);
        shown = true;
        wait(wants.sleep_s);
    }
}

void WindowFrames::wait(double seconds) {
    if (frames_due_ > 0) {
        --frames_due_;
        return glfwPollEvents();
    }
    const double start = glfwGetTime();
    if (std::isinf(seconds))
        glfwWaitEvents();
    else
        glfwWaitEventsTimeout(std::max(seconds, shows_ ? 0.001 : quiet_frame));
    // A tooltip is measured in its first frame and visible in its second.
    frames_due_ = glfwGetTime() - start < seconds ? frames_after_event - 1 : 1;
}

void WindowFrames::measure() {
    glfwGetWindowSize(window_, &extent_.size.x, &extent_.size.y);
    glfwGetFramebufferSize(window_, &extent_.dots.x, &extent_.dots.y);
    glfwGetWindowSize(window_, &extent_.size_after.x, &extent_.size_after.y);
    float down = 1;
    glfwGetWindowContentScale(window_, &extent_.content_scale, &down);
}

void WindowFrames::follow_scale() {
    const DisplayScale display = display_scale(extent_, display_);
    const bool projector = state_.layout.projector;
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

void WindowFrames::use_extent() const {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {float(extent_.size_after.x), float(extent_.size_after.y)};
    io.DisplayFramebufferScale = {display_.dots_per_unit, display_.dots_per_unit};
}

void WindowFrames::note_size() {
    if (extent_.size == noted_ && !input_.maximize_changed) return;
    noted_ = extent_.size;
    input_.maximize_changed = false;
    Preferences& settings = state_.persistence.preferences;
    settings.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    if (!settings.maximized) settings.width = noted_.x, settings.height = noted_.y;
    state_.persistence.preferences_changed = ImGui::GetTime();  // written after a pause
}

UiRequests WindowFrames::frame() {
    measure();
    follow_scale();
    note_size();
    read_held_keys(window_, input_.ui);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    use_extent();
    if (feed_input(window_, input_)) frames_due_ = frames_after_event;
    ImGui::NewFrame();
    name_sheets();
    UiRequests wants = ui_frame(state_, input_.ui);
    ImGui::Render();
    input_.ui = {};
    draws_all_ = draws_all_ || std::exchange(input_.refresh_asked, false);
    upload_sheets();
    const Background background{state_.displayed, state_.picture_serial, state_.picture_rect.picture,
                                state_.picture_rect.room, theme().panel};
    shows_ = canvas_->draw(*ImGui::GetDrawData(), background, {extent_.dots.x, extent_.dots.y},
                           display_.dots_per_unit, draws_all_);
    if (shows_) {
        draws_all_ = false;
        glfwSwapBuffers(window_);
    }
    if (!wants.title.empty() && wants.title != title_) {
        title_ = wants.title;
        glfwSetWindowTitle(window_, title_.c_str());
    }
    return wants;
}

void WindowFrames::name_sheets() {
    for (PictureSheet* sheet : sheets_of(state_)) {
        if (!sheets_[sheet].texture)
            sheets_[sheet].texture = std::make_unique<Texture>(Texture::Use::Sampled);
        sheet->texture = sheets_[sheet].texture->id();
    }
}

void WindowFrames::upload_sheets() {
    for (auto& [sheet, shown] : sheets_) {
        if (sheet->serial == shown.serial) continue;
        shown.texture->upload(sheet->picture);
        shown.serial = sheet->serial;
        draws_all_ = true;  // the sheet may be shown anywhere
    }
}

}  // namespace glint
