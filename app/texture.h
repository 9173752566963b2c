#pragma once
// The picture on the graphics card: one texture, shown pixel for pixel.

#include <bit>
#include <cstdint>

#include "renderer/picture.h"

namespace glint {

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

  private:
    unsigned name_ = 0;
    PictureSize size_{0, 0};
};

/// Fills the current framebuffer of `width` x `height` pixels with one colour.
void clear_framebuffer(int width, int height, float red, float green, float blue);

}  // namespace glint
