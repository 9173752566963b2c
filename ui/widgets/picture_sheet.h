#pragma once
// Small pictures of the same size, laid out in one picture with one texture.

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "renderer/picture.h"
#include "ui/widgets/theme.h"

namespace glint {

struct PictureSheet {
    PictureSize cell{1, 1};  // size of each small picture
    int columns = 1;
    Picture picture;                // all small pictures in one
    std::uint64_t serial = 0;       // incremented by each change, so that the texture is updated
    ImTextureID texture = nullptr;  // set by the window

    /// Clears the sheet and makes room for `count` pictures.
    void reset(PictureSize cell_size, int column_count, int count) {
        cell = cell_size;
        columns = column_count;
        picture.size = {columns * cell.width, (count + columns - 1) / columns * cell.height};
        picture.rgba.assign(4 * picture.size.pixels(), 0);
        ++serial;
    }
    /// Precondition: `index` is in range, and `small` has the cell's size.
    void put(int index, const Picture& small) {
        const int left = index % columns * cell.width, top = index / columns * cell.height;
        for (int y = 0; y < cell.height; ++y)
            std::copy_n(small.rgba.begin() + static_cast<std::ptrdiff_t>(4 * small.pixel(0, y)),
                        4 * cell.width,
                        picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * picture.pixel(left, top + y)));
        ++serial;
    }
    /// `strength`: 0 to 1; 0 leaves the background unchanged.
    void draw(ImDrawList& list, int index, ImVec2 low, ImVec2 high, float strength = 1) const {
        const float across = 1 / float(columns), down = float(cell.height) / float(picture.size.height);
        const int whole_rows = index / columns;
        const auto column = float(index % columns), row = float(whole_rows);
        list.AddImage(texture, low, high, {column * across, row * down},
                      {(column + 1) * across, (row + 1) * down}, to_u32({1, 1, 1, 1}, strength));
    }
};

}  // namespace glint
