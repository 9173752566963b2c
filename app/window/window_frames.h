#pragma once
// The frames of the open window: each takes input, runs ui/, and draws what has changed.

#include <csignal>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <string>

#include "app/window/canvas.h"
#include "app/window/window_input.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"

struct GLFWwindow;

namespace glint {

class WindowFrames {
  public:
    /// Takes ownership of the window. `state` must outlive this object.
    WindowFrames(GLFWwindow* window, UiState& state);
    ~WindowFrames();
    WindowFrames(const WindowFrames&) = delete;
    WindowFrames& operator=(const WindowFrames&) = delete;

    /// Draws frames until the window is closed, or `ending_signal` is set and GLFW's wait ends.
    void run(const volatile std::sig_atomic_t& ending_signal);

  private:
    /// ImGui needs a frame or two after an event to draw all of its effects.
    static constexpr int frames_after_event = 3;
    /// Seconds until the next frame if the last one showed nothing new and so did not wait for the display.
    static constexpr double quiet_frame = 1 / 120.0;
    void wait(double seconds);
    /// Queries sizes once per frame: while the window is being resized, two queries may give different
    /// results.
    void measure();
    /// Applies the display's scale and the user's choice to fonts and theme.
    void follow_scale();
    /// Overrides the sizes set by the backend, which queries them itself and divides sizes that may not
    /// match.
    void use_extent() const;
    /// Stores the window's size in the settings, only when it has changed: querying the display takes time.
    void note_size();
    UiRequests frame();
    /// Assigns each sheet of small pictures its texture.
    void name_sheets();
    void upload_sheets();

    GLFWwindow* window_;
    UiState& state_;
    WindowInput input_;
    struct ShownSheet {
        std::unique_ptr<Texture> texture;
        std::uint64_t serial = 0;
    };
    std::unique_ptr<Canvas> canvas_;
    std::map<PictureSheet*, ShownSheet> sheets_;
    FontFiles files_;
    std::string title_;
    WindowExtent extent_;
    glm::ivec2 noted_{0};  // the size in the settings
    DisplayScale display_;
    float scale_ = 0;  // the last applied scale of the design; 0 before the first frame
    int frames_due_ = frames_after_event;
    bool draws_all_ = true;  // the theme, a texture or the scale has changed, or the display lost the pixels
    bool shows_ = true;      // the last frame showed something new
};

}  // namespace glint
