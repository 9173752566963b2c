#pragma once
// A picture on the graphics card.

#include <bit>
#include <cstdint>

#include "renderer/picture.h"

namespace glint {

/// Pixels of the window or of a picture, from its upper left corner; right and bottom are the first ones
/// outside.
struct PixelRect {
    int left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] int width() const { return right - left; }
    [[nodiscard]] int height() const { return bottom - top; }
    [[nodiscard]] bool is_empty() const { return right <= left || bottom <= top; }
};

/// What lies in both; empty where nothing does.
[[nodiscard]] PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// A GL texture of the current context, its first row the picture's top.
class Texture {
  public:
    /// Copied: to and from framebuffers alone. Its channels have the order of the window's: in software,
    /// copying is then a copy of memory and takes a quarter of the time. Where a shader samples such a
    /// texture, llvmpipe (Mesa 22.3) leaves out the tiles that a rectangle covers whole; what ImGui draws is
    /// Sampled.
    enum class Use { Sampled, Copied };

    /// Precondition: a GL context is current. `ready()` is false when it lacks a function.
    explicit Texture(Use use);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] bool ready() const { return name_ != 0; }
    [[nodiscard]] PictureSize size() const { return size_; }
    /// Room for a picture of this size; what is in it is undefined where the size is another than before.
    void allocate(PictureSize size);
    void upload(const Picture& picture);
    /// Puts `part` of a picture to where the picture begins at `left`, `top`. All of it lies in the texture.
    void upload(const Picture& picture, const PixelRect& part, int left, int top);
    /// The name by which ImGui's backend draws it.
    [[nodiscard]] void* id() const { return std::bit_cast<void*>(std::uintptr_t{name_}); }
    /// A framebuffer that is this texture, to copy from and to draw in.
    [[nodiscard]] unsigned framebuffer();

  private:
    Use use_;
    unsigned framebuffer_ = 0;  // made when first needed
    unsigned name_ = 0;
    PictureSize size_{0, 0};
};

}  // namespace glint
