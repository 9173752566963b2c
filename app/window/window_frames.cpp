#include "app/window/window_frames.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/ending_signals.h"
#include "app/window/gl.h"
#include "app/window/x_errors.h"
#include "ui/widgets/theme.h"

namespace glint {

WindowFrames::WindowFrames(GLFWwindow* window, UiState& state, void (*display_gone)())
    : window_(window), state_(state), display_gone_(display_gone), clipboard_(window) {
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    collect_input(window, input_);
    ready_ = ImGui_ImplGlfw_InitForOpenGL(window, true) && ImGui_ImplOpenGL3_Init("#version 130");
    collect_text(window);
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // by Canvas, where GL has none
    if (ready_) clipboard_.serve_imgui();
    if (ready_ && gl().complete) canvas_ = std::make_unique<Canvas>();
    files_ = find_fonts();
}

WindowFrames::~WindowFrames() {
    canvas_.reset();
    sheets_.clear();
    if (ready_) ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
}

void WindowFrames::run(const EndingSignals& signals) {
    bool shown = false;
    while (true) {
        const UiRequests wants = frame();
        if (wants.quit || signals.number() != 0) return;
        if (!shown) glfwShowWindow(window_);
        shown = true;
        wait(wants.sleep_s);
    }
}

void WindowFrames::wait(double seconds) {
    handle_x_errors(display_gone_);
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

void WindowFrames::measure() {
    glfwGetWindowSize(window_, &extent_.size.x, &extent_.size.y);
    glfwGetFramebufferSize(window_, &extent_.dots.x, &extent_.dots.y);
    glfwGetWindowSize(window_, &extent_.size_after.x, &extent_.size_after.y);
    float down = 1;
    glfwGetWindowContentScale(window_, &extent_.content_scale, &down);
}

void WindowFrames::follow_scale() {
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
    state_.persistence.preferences_changed = ImGui::GetTime();  // written when the hand rests
}

UiRequests WindowFrames::frame() {
    measure();
    follow_scale();
    if (const auto error = take_x_error()) state_.notifications.add(Tone::Warning, *error);
    if (const auto problem = clipboard_.take_problem()) state_.notifications.add(Tone::Warning, *problem);
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
    const std::vector<Rect> changed = changes_.update(*ImGui::GetDrawData());
    shows_ = draw(changed);
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
        draws_all_ = true;  // wherever it is shown
    }
}

PixelRect WindowFrames::pixels_of(const Rect& rect) const {
    const float dots = display_.dots_per_unit;
    return {int(std::lround(rect.low.x * dots)), int(std::lround(rect.low.y * dots)),
            int(std::lround(rect.high.x * dots)), int(std::lround(rect.high.y * dots))};
}

PixelRect WindowFrames::pixels_around(const Rect& rect) const {
    const float dots = display_.dots_per_unit;
    return {int(std::floor(rect.low.x * dots)), int(std::floor(rect.low.y * dots)),
            int(std::ceil(rect.high.x * dots)), int(std::ceil(rect.high.y * dots))};
}

bool WindowFrames::draw(std::vector<Rect> changed) {
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

void WindowFrames::draw_within(const PixelRect& part) {
    canvas_->draw_picture(state_.displayed, pixels_of(placed_.picture), pixels_of(placed_.room), part,
                          theme().panel);
    canvas_->draw(*ImGui::GetDrawData(), part, display_.dots_per_unit);
}

}  // namespace glint
