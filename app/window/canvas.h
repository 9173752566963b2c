#pragma once
// Draws the window. The canvas keeps the window's pixels, compares what ImGui draws with the previous frame,
// and redraws only the rectangles that have changed. Without a GPU, panels full of text take longer to draw
// than the picture.

#include <imgui.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "renderer/picture.h"
#include "ui/widgets/area.h"

namespace glint {

/// Drawing a rectangle means scanning all draw lists, so a few large ones cost less than many small ones.
inline constexpr std::size_t max_changed_rects = 4;

/// Adds `rect` to rectangles that do not overlap, and merges it with those that it overlaps. At most
/// `max_changed_rects` remain.
void add_rect(std::vector<Rect>& rects, Rect rect);

/// A copy of one of ImGui's draw lists, which ImGui reuses in the next frame.
struct DrawnList {
    std::vector<ImDrawCmd> commands;
    std::vector<ImDrawIdx> indices;
    std::vector<ImDrawVert> vertices;
};

/// Compares what ImGui draws in this frame with the previous frame.
class FrameChanges {
  public:
    /// Returns rectangles in ImGui's units that cover every pixel that `data` draws differently from the
    /// previous call. They are not empty and do not overlap. Returns the entire display at the first call and
    /// when its size has changed. Textures are compared by name, not by content.
    [[nodiscard]] std::vector<Rect> update(const ImDrawData& data);

  private:
    std::vector<DrawnList> before_;
    ImVec2 size_{-1, -1};
};

/// Pixels of the window or of a picture, from its upper left corner; right and bottom are exclusive.
struct PixelRect {
    int left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] int width() const { return right - left; }
    [[nodiscard]] int height() const { return bottom - top; }
    [[nodiscard]] bool is_empty() const { return right <= left || bottom <= top; }
};

/// A GL texture whose first row is the top of a picture. Precondition: a GL context is current.
class Texture {
  public:
    /// Sampled: ImGui draws the texture. Copied: the texture is a framebuffer, and pixels are copied to and
    /// from it. Its channels are then in the window's order, so llvmpipe can copy memory directly, in a
    /// quarter of the time. A shader cannot sample a Copied texture: llvmpipe (Mesa 22.3) skips tiles that a
    /// rectangle covers completely.
    enum class Use { Sampled, Copied };

    explicit Texture(Use use);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] PictureSize size() const { return size_; }
    /// Allocates a picture of this size; its contents are undefined if the size has changed.
    void allocate(PictureSize size);
    void upload(const Picture& picture);
    /// Uploads `part` of a picture whose upper left corner is at (`left`, `top`) of the texture.
    /// Precondition: the part is inside the picture and the texture.
    void upload(const Picture& picture, const PixelRect& part, int left, int top);
    /// Returns the texture's name for ImGui.
    [[nodiscard]] void* id() const { return std::bit_cast<void*>(std::uintptr_t{name_}); }
    /// Returns the framebuffer whose pixels are this texture.
    [[nodiscard]] unsigned framebuffer();

  private:
    Use use_;
    unsigned framebuffer_ = 0;  // created on first use
    unsigned name_ = 0;
    PictureSize size_{0, 0};
};

/// The picture and the colour that are drawn below ImGui's data.
struct Background {
    const Picture* picture = nullptr;  // null: none
    std::uint64_t serial = 0;          // changes whenever the picture's pixels do
    Rect place, room;                  // the picture fills `place`, clipped to `room`
    ImVec4 color;                      // around the picture
};

class Canvas {
  public:
    /// Draws the parts of a frame that have changed since the last call, or all of it, into the current
    /// context's back buffer of `size` pixels. ImGui's units are `dots_per_unit` pixels each. Returns false,
    /// and draws nothing, if nothing has changed or the window has no pixels.
    bool draw(const ImDrawData& data, const Background& background, PictureSize size, float dots_per_unit,
              bool all);

  private:
    void draw_part(const ImDrawData& data, const PixelRect& part);
    void draw_background(const PixelRect& part);
    void draw_lists(const ImDrawData& data, const PixelRect& part);
    void stretch(const Picture& picture, const PixelRect& to, const PixelRect& part);
    void fill(const PixelRect& rect, const ImVec4& color);
    void copy_to_window();

    FrameChanges changes_;
    Background background_;  // background drawn by the last call
    float dots_per_unit_ = 1;
    Texture pixels_{Texture::Use::Copied};     // the window's pixels
    Texture stretched_{Texture::Use::Copied};  // a picture shown at a different size
};

}  // namespace glint
