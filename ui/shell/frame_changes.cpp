#include "ui/shell/frame_changes.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace glint {

namespace {

/// One command with the triangles that it draws.
struct DrawnCommand {
    const DrawnList& list;
    const ImDrawCmd& command;

    [[nodiscard]] std::size_t triangles() const { return command.ElemCount / 3; }
    [[nodiscard]] const ImDrawVert& corner(std::size_t triangle, std::size_t i) const {
        return list.vertices[command.VtxOffset + list.indices[command.IdxOffset + 3 * triangle + i]];
    }
};

constexpr float far = std::numeric_limits<float>::max();

bool is_empty(const Rect& rect) { return rect.low.x >= rect.high.x || rect.low.y >= rect.high.y; }

Rect around(const Rect& a, const Rect& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

float area(const Rect& rect) { return rect.size().x * rect.size().y; }

bool draw_alike(const ImDrawCmd& a, const ImDrawCmd& b) {
    return std::memcmp(&a.ClipRect, &b.ClipRect, sizeof a.ClipRect) == 0 && a.TextureId == b.TextureId &&
           a.UserCallback == b.UserCallback && a.UserCallbackData == b.UserCallbackData;
}

bool same_triangle(const DrawnCommand& a, std::size_t i, const DrawnCommand& b, std::size_t j) {
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (std::memcmp(&a.corner(i, corner), &b.corner(j, corner), sizeof(ImDrawVert)) != 0) return false;
    return true;
}

/// What the triangles from `first` to before `last` may cover.
Rect bounds_of(const DrawnCommand& drawn, std::size_t first, std::size_t last) {
    Rect bounds{{far, far}, {-far, -far}};
    for (std::size_t triangle = first; triangle < last; ++triangle)
        for (std::size_t i = 0; i < 3; ++i) {
            const ImVec2 at = drawn.corner(triangle, i).pos;
            bounds = around(bounds, {at, at});
        }
    const ImVec4 clip = drawn.command.ClipRect;
    return {{std::max(bounds.low.x, clip.x), std::max(bounds.low.y, clip.y)},
            {std::min(bounds.high.x, clip.z), std::min(bounds.high.y, clip.w)}};
}

/// Adds the areas in which two commands differ. Triangles that are equal at both ends are left out: text that
/// changes in the middle of a panel leaves what was drawn before and after it as it was.
void compare(const DrawnCommand& before, const DrawnCommand& now, std::vector<Rect>& changed) {
    const std::size_t was = before.triangles(), is = now.triangles(), both = std::min(was, is);
    std::size_t start = 0, end = 0;
    if (draw_alike(before.command, now.command)) {
        while (start < both && same_triangle(before, start, now, start)) ++start;
        while (end < both - start && same_triangle(before, was - 1 - end, now, is - 1 - end)) ++end;
    }
    add_rect(changed, bounds_of(before, start, was - end));
    add_rect(changed, bounds_of(now, start, is - end));
}

}  // namespace

void add_rect(std::vector<Rect>& rects, Rect rect) {
    if (is_empty(rect)) return;
    for (std::size_t i = 0; i < rects.size();) {
        if (!overlap(rects[i], rect)) {
            ++i;
            continue;
        }
        rect = around(rects[i], rect);
        rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;  // the larger one may touch those that the smaller did not
    }
    rects.push_back(rect);
    if (rects.size() <= max_changed_rects) return;
    std::size_t nearest = 0;  // joining it with the new one adds the least area to draw
    const auto growth = [&](std::size_t i) { return area(around(rects[i], rect)) - area(rects[i]); };
    for (std::size_t i = 1; i + 1 < rects.size(); ++i)
        if (growth(i) < growth(nearest)) nearest = i;
    const Rect joined = around(rects[nearest], rect);
    rects.pop_back();
    rects.erase(rects.begin() + static_cast<std::ptrdiff_t>(nearest));
    add_rect(rects, joined);
}

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
        const DrawnList nothing;
        const ImDrawCmd draws_nothing;
        for (std::size_t i = 0; i < std::max(now.size(), before_.size()); ++i) {
            const DrawnList& a = i < before_.size() ? before_[i] : nothing;
            const DrawnList& b = i < now.size() ? now[i] : nothing;
            for (std::size_t c = 0; c < std::max(a.commands.size(), b.commands.size()); ++c)
                compare({a, c < a.commands.size() ? a.commands[c] : draws_nothing},
                        {b, c < b.commands.size() ? b.commands[c] : draws_nothing}, changed);
        }
    }
    before_ = std::move(now);
    size_ = size;
    return changed;
}

}  // namespace glint
