#pragma once
// Draws a picture with Mesa's OpenGL into memory (OSMesa): no window, no display.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/scene/scene.h"

namespace glint::oracle {

/// OpenGL's colour buffer: RGBA, top row first. Alpha is 1 on surfaces, otherwise 0. Floats are unclamped.
template <class Channel> struct GlPicture {
    PictureSize size;
    std::vector<Channel> rgba;

    [[nodiscard]] const Channel* at(int x, int y) const {
        return &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                          static_cast<std::size_t>(x))];
    }
};

/// An OpenGL compatibility context that draws into memory. Only one may exist at a time, on one thread.
class GlCanvas {
  public:
    GlCanvas();
    ~GlCanvas();
    GlCanvas(const GlCanvas&) = delete;
    GlCanvas& operator=(const GlCanvas&) = delete;

    /// The picture that `draw` makes in a float buffer (clamped only if `draw` requests it) or in one with 8
    /// bits per channel. Throws std::runtime_error if OpenGL cannot draw it or reports an error.
    [[nodiscard]] GlPicture<float> floats(PictureSize size, const std::function<void()>& draw);
    [[nodiscard]] GlPicture<std::uint8_t> bytes(PictureSize size, const std::function<void()>& draw);

    /// OpenGL version and renderer, to print with a run's results.
    [[nodiscard]] std::string description();

  private:
    struct Destroy {
        void operator()(void* context) const;
    };
    std::unique_ptr<void, Destroy> context_;
};

}  // namespace glint::oracle
