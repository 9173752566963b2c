#include "app/window/canvas.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glint {

// Comparing draw lists.

namespace {

bool same_vertex(const ImDrawVert& a, const ImDrawVert& b) {
    return a.pos.x == b.pos.x && a.pos.y == b.pos.y && a.uv.x == b.uv.x && a.uv.y == b.uv.y && a.col == b.col;
}

bool same_rectangle(const ImVec4& a, const ImVec4& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

/// A draw command with its triangles.
struct DrawnCommand {
    const DrawnList& list;
    const ImDrawCmd& command;

    [[nodiscard]] std::size_t triangles() const { return command.ElemCount / 3; }
    [[nodiscard]] const ImDrawVert& corner(std::size_t triangle, std::size_t i) const {
        return list.vertices[command.VtxOffset + list.indices[command.IdxOffset + 3 * triangle + i]];
    }
    [[nodiscard]] bool same_state(const DrawnCommand& other) const {
        const ImDrawCmd &a = command, &b = other.command;
        return same_rectangle(a.ClipRect, b.ClipRect) && a.TextureId == b.TextureId &&
               a.UserCallback == b.UserCallback && a.UserCallbackData == b.UserCallbackData;
    }
    [[nodiscard]] bool same_triangle(std::size_t triangle, const DrawnCommand& other,
                                     std::size_t its_triangle) const {
        for (std::size_t i = 0; i < 3; ++i)
            if (!same_vertex(corner(triangle, i), other.corner(its_triangle, i))) return false;
        return true;
    }
    /// Bounds of the area that the triangles in [first, last) may cover.
    [[nodiscard]] Rect bounds(std::size_t first, std::size_t last) const {
        constexpr float far = std::numeric_limits<float>::max();
        ImVec2 low{far, far}, high{-far, -far};
        for (std::size_t triangle = first; triangle < last; ++triangle)
            for (std::size_t i = 0; i < 3; ++i) {
                const ImVec2 at = corner(triangle, i).pos;
                low = {std::min(low.x, at.x), std::min(low.y, at.y)};
                high = {std::max(high.x, at.x), std::max(high.y, at.y)};
            }
        const ImVec4 clip = command.ClipRect;
        return {{std::max(low.x, clip.x), std::max(low.y, clip.y)},
                {std::min(high.x, clip.z), std::min(high.y, clip.w)}};
    }
};

/// Adds the areas in which two draw commands differ. Skips equal triangles at the beginning and end: text
/// that changes in the middle of a panel leaves the text before and after it unchanged.
void compare(const DrawnCommand& before, const DrawnCommand& now, std::vector<Rect>& changed) {
    const std::size_t count_before = before.triangles(), count = now.triangles();
    const std::size_t common = std::min(count_before, count);
    std::size_t start = 0, end = 0;
    if (before.same_state(now)) {
        while (start < common && before.same_triangle(start, now, start)) ++start;
        while (end < common - start && before.same_triangle(count_before - 1 - end, now, count - 1 - end))
            ++end;
    }
    add_rect(changed, before.bounds(start, count_before - end));
    add_rect(changed, now.bounds(start, count - end));
}

Rect around(const Rect& a, const Rect& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

float area(const Rect& rect) { return rect.size().x * rect.size().y; }

}  // namespace

std::vector<Rect> FrameChanges::update(const ImDrawData& data) {
    std::vector<DrawnList> now(static_cast<std::size_t>(data.CmdListsCount));
    for (std::size_t i = 0; i < now.size(); ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        now[i].commands.assign(list.CmdBuffer.begin(), list.CmdBuffer.end());
        now[i].indices.assign(list.IdxBuffer.begin(), list.IdxBuffer.end());
        now[i].vertices.assign(list.VtxBuffer.begin(), list.VtxBuffer.end());
    }
    std::vector<Rect> changed;
    const ImVec2 low = data.DisplayPos, size = data.DisplaySize;
    if (size.x != size_.x || size.y != size_.y) {
        changed.push_back({low, low + size});
    } else {
        const DrawnList no_list;
        const ImDrawCmd no_command;
        for (std::size_t i = 0; i < std::max(now.size(), before_.size()); ++i) {
            const DrawnList& a = i < before_.size() ? before_[i] : no_list;
            const DrawnList& b = i < now.size() ? now[i] : no_list;
            for (std::size_t c = 0; c < std::max(a.commands.size(), b.commands.size()); ++c)
                compare({a, c < a.commands.size() ? a.commands[c] : no_command},
                        {b, c < b.commands.size() ? b.commands[c] : no_command}, changed);
        }
    }
    before_ = std::move(now);
    size_ = size;
    return changed;
}

void add_rect(std::vector<Rect>& rects, Rect rect) {
    if (rect.low.x >= rect.high.x || rect.low.y >= rect.high.y) return;
    for (std::size_t i = 0; i < rects.size();) {
        if (!overlap(rects[i], rect)) {
            ++i;
            continue;
        }
        rect = around(rects[i], rect);
        rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;  // the larger rectangle may overlap rectangles that the smaller one did not
    }
    rects.push_back(rect);
    if (rects.size() <= max_changed_rects) return;
    std::size_t nearest = 0;  // the rectangle that grows least when merged with the new one
    const auto growth = [&](std::size_t i) { return area(around(rects[i], rect)) - area(rects[i]); };
    for (std::size_t i = 1; i + 1 < rects.size(); ++i)
        if (growth(i) < growth(nearest)) nearest = i;
    const Rect merged = around(rects[nearest], rect);
    rects.pop_back();
    rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(nearest));
    add_rect(rects, merged);
}

// Drawing rectangles.

Texture::Texture(Use use) : use_(use) {
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Texture::~Texture() {
    glDeleteFramebuffers(1, &framebuffer_);  // ignores 0
    glDeleteTextures(1, &name_);
}

void Texture::allocate(PictureSize size) {
    if (size_ == size) return;
    glBindTexture(GL_TEXTURE_2D, name_);
    // GL chooses how to store an unsized RGBA texture, and follows the channel order given here.
    const bool copied = use_ == Use::Copied;
    glTexImage2D(GL_TEXTURE_2D, 0, copied ? GL_RGBA : GL_RGBA8, size.width, size.height, 0,
                 copied ? GL_BGRA : GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    size_ = size;
}

void Texture::upload(const Picture& picture) {
    allocate(picture.size);
    upload(picture, {0, 0, size_.width, size_.height}, 0, 0);
}

void Texture::upload(const Picture& picture, const PixelRect& part, int left, int top) {
    glBindTexture(GL_TEXTURE_2D, name_);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, picture.size.width);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, part.left);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, part.top);
    glTexSubImage2D(GL_TEXTURE_2D, 0, left + part.left, top + part.top, part.width(), part.height(), GL_RGBA,
                    GL_UNSIGNED_BYTE, picture.rgba.data());
    for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS})
        glPixelStorei(name, 0);  // as ImGui's backend expects
}

unsigned Texture::framebuffer() {
    if (framebuffer_ == 0) {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name_, 0);
    }
    return framebuffer_;
}

namespace {

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

PixelRect nearest_pixels(const Rect& rect, float dots) {
    return {int(std::lround(rect.low.x * dots)), int(std::lround(rect.low.y * dots)),
            int(std::lround(rect.high.x * dots)), int(std::lround(rect.high.y * dots))};
}

PixelRect pixels_around(const Rect& rect, float dots) {
    return {int(std::floor(rect.low.x * dots)), int(std::floor(rect.low.y * dots)),
            int(std::ceil(rect.high.x * dots)), int(std::ceil(rect.high.y * dots))};
}

/// The pixels that a command may change. ImGui's backend truncates in the same way.
PixelRect pixels_of(const ImVec4& clip, float dots) {
    return {int(clip.x * dots), int(clip.y * dots), int(clip.z * dots), int(clip.w * dots)};
}

/// Returns the clip rectangle that the backend converts to these pixels. The backend counts rows from the
/// bottom, so top and bottom are swapped. The fractions added here make its truncation give the right pixels.
ImVec4 clip_of(const PixelRect& pixels, float dots) {
    return {(float(pixels.left) + 0.25F) / dots, (float(pixels.bottom) + 0.5F) / dots,
            (float(pixels.right) + 0.5F) / dots, (float(pixels.top) + 0.25F) / dots};
}

/// Returns a length in units that the backend, which truncates, converts to `pixels`.
float units(int pixels, float dots) {
    const float exact = float(pixels) / dots;
    return int(exact * dots) < pixels ? std::nextafter(exact, float(pixels) + 1) : exact;
}

void set_scissor(const PixelRect& rect) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.left, rect.top, rect.width(), rect.height());
}

struct Span {
    int from_low, from_high, to_low, to_high;
};

/// A picture's `count` pixels are stretched over the canvas from `low` to `high`. Returns the smallest range
/// of whole picture pixels that covers part_low to part_high, and the range of the canvas that they fill.
/// The entire picture is not copied because drivers refuse to copy lengths of about 50,000 pixels. Returns
/// the full ranges unless every picture pixel covers the same whole number of canvas pixels.
Span covering(int count, int low, int high, int part_low, int part_high) {
    const int each = (high - low) / count;
    if (each < 1 || each * count != high - low) return {0, count, low, high};
    const int first = (part_low - low) / each, last = (part_high - low + each - 1) / each;
    return {first, last, low + first * each, low + last * each};
}

}  // namespace

bool Canvas::draw(const ImDrawData& data, const Background& background, PictureSize size, float dots_per_unit,
                  bool all) {
    std::vector<Rect> changed = changes_.update(data);
    if (background.serial != background_.serial || !(background.place == background_.place) ||
        !(background.room == background_.room)) {
        add_rect(changed, background.room);
        add_rect(changed, background_.room);
    }
    background_ = background;
    dots_per_unit_ = dots_per_unit;
    if (size.width <= 0 || size.height <= 0) return false;  // iconified
    const PixelRect window{0, 0, size.width, size.height};
    if (all || !(pixels_.size() == size)) {
        pixels_.allocate(size);
        draw_part(data, window);
    } else {
        if (changed.empty()) return false;
        for (const Rect& rect : changed)
            draw_part(data, intersection(pixels_around(rect, dots_per_unit), window));
    }
    copy_to_window();
    return true;
}

void Canvas::draw_part(const ImDrawData& data, const PixelRect& part) {
    if (part.is_empty()) return;
    draw_background(part);
    draw_lists(data, part);
}

void Canvas::draw_background(const PixelRect& part) {
    const Picture* picture = background_.picture;
    const ImVec4& color = background_.color;
    const PixelRect to = nearest_pixels(background_.place, dots_per_unit_);
    const PixelRect room = nearest_pixels(background_.room, dots_per_unit_);
    const PixelRect seen = intersection(intersection(to, room), part);
    if (picture == nullptr || seen.is_empty()) return fill(part, color);
    if (to.width() == picture->size.width && to.height() == picture->size.height)
        pixels_.upload(*picture,
                       {seen.left - to.left, seen.top - to.top, seen.right - to.left, seen.bottom - to.top},
                       to.left, to.top);
    else
        stretch(*picture, to, seen);
    fill({part.left, part.top, part.right, seen.top}, color);
    fill({part.left, seen.bottom, part.right, part.bottom}, color);
    fill({part.left, seen.top, seen.left, seen.bottom}, color);
    fill({seen.right, seen.top, part.right, seen.bottom}, color);
}

/// Draws the picture at a different size, with nearest-neighbour sampling.
void Canvas::stretch(const Picture& picture, const PixelRect& to, const PixelRect& part) {
    stretched_.upload(picture);
    const Span x = covering(picture.size.width, to.left, to.right, part.left, part.right);
    const Span y = covering(picture.size.height, to.top, to.bottom, part.top, part.bottom);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, stretched_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pixels_.framebuffer());
    set_scissor(part);
    glBlitFramebuffer(x.from_low, y.from_low, x.from_high, y.from_high, x.to_low, y.to_low, x.to_high,
                      y.to_high, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
}

void Canvas::fill(const PixelRect& rect, const ImVec4& color) {
    if (rect.is_empty()) return;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pixels_.framebuffer());
    set_scissor(rect);
    // Rounded to 8-bit levels: a driver may round a colour between two levels differently when it clears part
    // of the canvas than when it clears all of it.
    const auto level = [](float c) { return std::round(c * 255) / 255; };
    glClearColor(level(color.x), level(color.y), level(color.z), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/// Draws ImGui's data clipped to `part`.
void Canvas::draw_lists(const ImDrawData& data, const PixelRect& part) {
    std::vector<std::pair<ImDrawCmd*, ImVec4>> clips;  // the original clip rectangles
    std::vector<ImDrawList*> lists;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        bool seen = false;
        for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
            clips.emplace_back(&command, command.ClipRect);
            const PixelRect clip = intersection(pixels_of(command.ClipRect, dots_per_unit_), part);
            command.ClipRect = clip.is_empty() ? ImVec4() : clip_of(clip, dots_per_unit_);
            seen = seen || !clip.is_empty();
        }
        if (seen) lists.push_back(data.CmdLists[i]);
    }
    ImDrawData drawn = data;
    drawn.CmdLists = lists.data();
    drawn.CmdListsCount = int(lists.size());
    // Upside down: the canvas begins with its top row.
    const float width = units(pixels_.size().width, dots_per_unit_);
    const float height = units(pixels_.size().height, dots_per_unit_);
    drawn.DisplayPos = {0, height};
    drawn.DisplaySize = {width, -height};
    drawn.FramebufferScale = {dots_per_unit_, -dots_per_unit_};
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, pixels_.framebuffer());
    ImGui_ImplOpenGL3_RenderDrawData(&drawn);
    for (const auto& [command, clip] : clips) command->ClipRect = clip;
}

void Canvas::copy_to_window() {
    const int width = pixels_.size().width, height = pixels_.size().height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, pixels_.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, height, width, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

}  // namespace glint
