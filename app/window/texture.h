#pragma once
// The picture on the graphics card: one texture, shown pixel for pixel.

#include <bit>
#include <cstdint>

#include "renderer/picture.h"

namespace glint {

/// Pixels of the window, from its upper left corner; right and bottom are the first ones outside.
struct PixelRect {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// A GL texture of the current context. GL is loaded through GLFW: the program links none.
class Texture {
  public:
    /// Precondition: a GL context is current. `ready()` is false when it lacks a function.
    Texture();
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] bool ready() const { return name_ != 0; }
    void upload(const Picture& picture);
    /// The name by which ImGui's backend draws it.
    [[nodiscard]] void* id() const { return std::bit_cast<void*>(std::uintptr_t{name_}); }

    /// Copies all of it to `to` in the window's framebuffer of this height, the nearest pixel where the sizes
    /// differ, and changes nothing outside `clip`. Software that stands in for a graphics card does this
    /// several times as fast as it draws a textured rectangle.
    void copy_to_window(const PixelRect& to, const PixelRect& clip, int height);

  private:
    unsigned frame_ = 0;  // reads from the texture; made when first needed
    unsigned name_ = 0;
    PictureSize size_{0, 0};
};

/// Fills the current framebuffer of `width` x `height` pixels with one colour.
void clear_framebuffer(int width, int height, float red, float green, float blue);

}  // namespace glint
