#pragma once
// The window's pixels, kept from frame to frame: what did not change is not drawn again.

#include <imgui.h>

#include "app/window/texture.h"

namespace glint {

/// A framebuffer as large as the window's, which it is copied to. Its first row is the window's top.
class Canvas {
  public:
    [[nodiscard]] bool ready() const { return texture_.ready(); }
    /// All functions need a current GL context. Returns true if the size has changed: then nothing of what
    /// was drawn is left.
    bool resize(PictureSize size);

    /// Draws the part inside `within`: the picture at `to`, clipped to `room`, taking the nearest pixel where
    /// the sizes differ, and one colour around it. A null `picture` leaves the colour alone.
    void draw_picture(const Picture* picture, const PixelRect& to, const PixelRect& room,
                      const PixelRect& within, const ImVec4& around);
    /// Draws what of ImGui's data lies in `within`. ImGui's units are `dots_per_unit` pixels each.
    void draw(const ImDrawData& data, const PixelRect& within, float dots_per_unit);
    /// Copies all of it to the window's back buffer.
    void show();

  private:
    void bind();  // to draw in
    void fill(const PixelRect& rect, const ImVec4& color);
    void scale(const Picture& picture, const PixelRect& to, const PixelRect& part);

    Texture texture_{Texture::Use::Copied};
    Texture small_{Texture::Use::Copied};  // a picture that is shown in another size
};

}  // namespace glint
