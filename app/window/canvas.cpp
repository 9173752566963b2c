#include "app/window/canvas.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "app/window/gl.h"
#include "ui/shell/short_lists.h"

namespace glint {

using namespace gl_value;

namespace {

/// The pixels that a command may change. ImGui's backend for GL cuts fractions off likewise.
PixelRect pixels_of(const ImVec4& clip, float dots_per_unit) {
    return {int(clip.x * dots_per_unit), int(clip.y * dots_per_unit), int(clip.z * dots_per_unit),
            int(clip.w * dots_per_unit)};
}

/// Returns the clip rectangle that the backend turns into these pixels. It counts GL's rows from below, so
/// upper and lower edge change places; it cuts the fractions off, which are far from the next pixel.
ImVec4 clip_of(const PixelRect& pixels, float dots_per_unit) {
    return {(float(pixels.left) + 0.25F) / dots_per_unit, (float(pixels.bottom) + 0.5F) / dots_per_unit,
            (float(pixels.right) + 0.5F) / dots_per_unit, (float(pixels.top) + 0.25F) / dots_per_unit};
}

/// Returns a length in units that the backend, which cuts fractions off, turns into `pixels`.
float units(int pixels, float dots_per_unit) {
    const float exact = float(pixels) / dots_per_unit;
    return int(exact * dots_per_unit) < pixels ? std::nextafter(exact, float(pixels) + 1) : exact;
}

void set_scissor(const PixelRect& rect) {
    gl().enable(scissor_test);
    gl().scissor(rect.left, rect.top, rect.right - rect.left, rect.bottom - rect.top);
}

}  // namespace

bool Canvas::resize(PictureSize size) {
    if (texture_.size() == size) return false;
    texture_.allocate(size);
    return true;
}

void Canvas::bind() { gl().bind_framebuffer(draw_framebuffer, texture_.framebuffer()); }

void Canvas::fill(const PixelRect& rect, const ImVec4& color) {
    if (rect.is_empty()) return;
    bind();
    set_scissor(rect);
    // Only whole levels are used: between two, a driver may round a part differently from the whole canvas.
    const auto whole = [](float c) { return std::round(c * 255) / 255; };
    gl().clear_color(whole(color.x), whole(color.y), whole(color.z), 1);
    gl().clear(color_buffer_bit);
    gl().disable(scissor_test);
}

namespace {

struct Span {
    int from_low, from_high, to_low, to_high;
};

/// `count` pixels of a picture are stretched over the canvas from low to high. Returns the smallest range of
/// whole picture pixels that covers part_low to part_high, and the range of the canvas that they fill:
/// drivers refuse to copy lengths of some 50,000. If the picture's pixels are not all the same whole number
/// of canvas pixels long, returns the whole ranges.
Span covering(int count, int low, int high, int part_low, int part_high) {
    const int each = (high - low) / count;
    if (each < 1 || each * count != high - low) return {0, count, low, high};
    const int first = (part_low - low) / each, last = (part_high - low + each - 1) / each;
    return {first, last, low + first * each, low + last * each};
}

}  // namespace

void Canvas::scale(const Picture& picture, const PixelRect& to, const PixelRect& part) {
    small_.upload(picture);
    const Span x = covering(picture.size.width, to.left, to.right, part.left, part.right);
    const Span y = covering(picture.size.height, to.top, to.bottom, part.top, part.bottom);
    gl().bind_framebuffer(read_framebuffer, small_.framebuffer());
    bind();
    set_scissor(part);
    gl().blit_framebuffer(x.from_low, y.from_low, x.from_high, y.from_high, x.to_low, y.to_low, x.to_high,
                          y.to_high, color_buffer_bit, nearest);
    gl().disable(scissor_test);
}

void Canvas::draw_picture(const Picture* picture, const PixelRect& to, const PixelRect& room,
                          const PixelRect& within, const ImVec4& around) {
    const PixelRect part = intersection(intersection(to, room), within);
    if (picture == nullptr || part.is_empty()) return fill(within, around);
    if (to.width() == picture->size.width && to.height() == picture->size.height) {
        const PixelRect from{part.left - to.left, part.top - to.top, part.right - to.left,
                             part.bottom - to.top};
        texture_.upload(*picture, from, to.left, to.top);
    } else {
        scale(*picture, to, part);
    }
    fill({within.left, within.top, within.right, part.top}, around);
    fill({within.left, part.bottom, within.right, within.bottom}, around);
    fill({within.left, part.top, part.left, part.bottom}, around);
    fill({part.right, part.top, within.right, part.bottom}, around);
}

void Canvas::draw(const ImDrawData& data, const PixelRect& within, float dots_per_unit) {
    std::vector<std::pair<ImDrawCmd*, ImVec4>> clips;  // as they were
    std::vector<ImDrawList*> lists;
    std::vector<std::unique_ptr<ImDrawList>> made;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        bool seen = false;
        for (ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
            clips.emplace_back(&command, command.ClipRect);
            const PixelRect part = intersection(pixels_of(command.ClipRect, dots_per_unit), within);
            command.ClipRect = part.is_empty() ? ImVec4() : clip_of(part, dots_per_unit);
            seen = seen || !part.is_empty();
        }
        if (!seen) continue;
        if (!counts_from_further_on(*data.CmdLists[i])) {
            lists.push_back(data.CmdLists[i]);
            continue;
        }
        for (std::unique_ptr<ImDrawList>& list : short_lists(*data.CmdLists[i])) {
            lists.push_back(list.get());
            made.push_back(std::move(list));
        }
    }
    ImDrawData part = data;
    part.CmdLists = lists.data();
    part.CmdListsCount = int(lists.size());
    // Upside down: the canvas begins with its upper row.
    const float width = units(texture_.size().width, dots_per_unit);
    const float height = units(texture_.size().height, dots_per_unit);
    part.DisplayPos = {0, height};
    part.DisplaySize = {width, -height};
    part.FramebufferScale = {dots_per_unit, -dots_per_unit};
    bind();
    ImGui_ImplOpenGL3_RenderDrawData(&part);
    for (const auto& [command, clip] : clips) command->ClipRect = clip;
}

void Canvas::show() {
    const PictureSize size = texture_.size();
    gl().bind_framebuffer(read_framebuffer, texture_.framebuffer());
    gl().bind_framebuffer(draw_framebuffer, 0);
    gl().blit_framebuffer(0, 0, size.width, size.height, 0, size.height, size.width, 0, color_buffer_bit,
                          nearest);
    gl().bind_framebuffer(read_framebuffer, 0);
}

}  // namespace glint
