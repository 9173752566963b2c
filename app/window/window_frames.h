#pragma once
// What the open window does in each frame: it takes input, runs ui/, and draws what has changed.

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/window/canvas.h"
#include "app/window/clipboard.h"
#include "app/window/texture.h"
#include "app/window/window_input.h"
#include "ui/shell/frame_changes.h"
#include "ui/ui.h"
#include "ui/widgets/display_scale.h"
#include "ui/widgets/fonts.h"

struct GLFWwindow;

namespace glint {

class EndingSignals;

class WindowFrames {
  public:
    /// Takes the window over and destroys it at its end. `state` must outlive it; `display_gone` as in
    /// x_errors.h.
    WindowFrames(GLFWwindow* window, UiState& state, void (*display_gone)());
    ~WindowFrames();
    WindowFrames(const WindowFrames&) = delete;
    WindowFrames& operator=(const WindowFrames&) = delete;

    /// False where the display has no OpenGL 3.0.
    [[nodiscard]] bool ready() const { return canvas_ && canvas_->ready(); }

    /// Draws frame after frame until the window is closed or a signal asks it to end. Precondition: ready().
    void run(const EndingSignals& signals);

  private:
    /// ImGui needs a frame or two after an event until all that follows from it is drawn.
    static constexpr int frames_after_event = 3;
    /// Seconds to the next frame after one that showed nothing new, and so did not wait for the display.
    static constexpr double quiet_frame = 1 / 120.0;
    void wait(double seconds);
    /// Asks only once a frame: while the window is being resized, two questions get two answers.
    void measure();
    /// Type and theme follow the display's scale and the user's choice.
    void follow_scale();
    /// Overrides the backend's sizes: it asks for them itself and divides answers that need not fit.
    void use_extent() const;
    /// Asked only when something changed: the display takes its time to answer.
    void note_size();
    UiRequests frame();
    /// Gives every sheet of small pictures its texture.
    void name_sheets();
    void upload_sheets();
    [[nodiscard]] PixelRect pixels_of(const Rect& rect) const;
    [[nodiscard]] PixelRect pixels_around(const Rect& rect) const;
    /// Draws what has changed and shows it. Returns false, and does nothing, if nothing has.
    bool draw(std::vector<Rect> changed);
    void draw_within(const PixelRect& part);

    GLFWwindow* window_;
    UiState& state_;
    void (*display_gone_)();
    WindowInput input_;
    struct ShownSheet {
        std::unique_ptr<Texture> texture;
        std::uint64_t serial = 0;
    };
    Clipboard clipboard_;
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

}  // namespace glint
