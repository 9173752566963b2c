#pragma once
// A picture drawn by Mesa's OpenGL into memory (OSMesa): no window, no display.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/scene/camera.h"

namespace glint::oracle {

/// What OpenGL left in its colour buffer: RGBA, first row at the top. Alpha is 1 where a surface was drawn,
/// else 0. Floats are unclamped.
template <class Channel> struct GlPicture {
    PictureSize size;
    std::vector<Channel> rgba;

    [[nodiscard]] const Channel* at(int x, int y) const {
        return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                          static_cast<std::size_t>(x))];
    }
};

/// An OpenGL compatibility context that draws into memory. One at a time, on one thread.
class GlCanvas {
  public:
    GlCanvas();
    ~GlCanvas();
    GlCanvas(const GlCanvas&) = delete;
    GlCanvas& operator=(const GlCanvas&) = delete;

    /// The picture that `draw` makes of a float buffer (no clamping anywhere but where `draw` asks for it) or
    /// of one with 8 bits a channel. Throws std::runtime_error when OpenGL refuses or reports an error.
    [[nodiscard]] GlPicture<float> floats(PictureSize size, const std::function<void()>& draw);
    [[nodiscard]] GlPicture<std::uint8_t> bytes(PictureSize size, const std::function<void()>& draw);

    /// Version and renderer, for the figure of a run.
    [[nodiscard]] std::string description();

  private:
    struct Destroy {
        void operator()(void* context) const;
    };
    std::unique_ptr<void, Destroy> context_;
};

}  // namespace glint::oracle
