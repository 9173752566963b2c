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
    /// Copied: is copied to and from framebuffers only. Its channels have the window's order: in software,
    /// copying is then a copy of memory and takes a quarter of the time. Sampled: is drawn by ImGui. If a
    /// shader samples a Copied texture, llvmpipe (Mesa 22.3) leaves out the tiles that a rectangle covers
    /// whole.
    enum class Use { Sampled, Copied };

    /// Precondition: a GL context is current. `ready()` is false when it lacks a function.
    explicit Texture(Use use);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] bool ready() const { return name_ != 0; }
    [[nodiscard]] PictureSize size() const { return size_; }
    /// Makes room for a picture of this size; the contents are undefined if the size has changed.
    void allocate(PictureSize size);
    void upload(const Picture& picture);
    /// Uploads `part` of a picture whose corner is at (`left`, `top`) of the texture. The part must fit in.
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
