// Checks the kernels that draw a tile against the definition of the fill rule, pixel by pixel in 128 bits.
#include <algorithm>
#include <random>
#include <vector>

#include "renderer/visibility/visibility_kernels.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

__extension__ using Wide = __int128;

/// Whether the sample (x, y) belongs to a triangle that runs clockwise (y down): to the right of all three
/// edges, or on top or left ones.
bool belongs(const ScreenVertex* const (&corner)[3], std::int32_t x, std::int32_t y) {
    for (int k = 0; k < 3; ++k) {
        const ScreenVertex &a = *corner[k], &b = *corner[(k + 1) % 3];
        const Wide dx = b.x - a.x, dy = b.y - a.y;
        const Wide side = dx * (y - a.y) - dy * (x - a.x);
        const bool top = dy == 0 && dx > 0, left = dy < 0;
        if (side < 0 || (side == 0 && !top && !left)) return false;
    }
    return true;
}

/// The expected pixel with its centre at (x, y) if only this triangle is drawn.
std::uint32_t expected(const std::vector<ScreenVertex>& v, std::int32_t x, std::int32_t y) {
    const Wide area = Wide{v[1].x - v[0].x} * (v[2].y - v[0].y) - Wide{v[1].y - v[0].y} * (v[2].x - v[0].x);
    if (area == 0) return 0;
    const ScreenVertex* const clockwise[3]{&v[0], &v[area > 0 ? 1 : 2], &v[area > 0 ? 2 : 1]};
    return belongs(clockwise, x, y) ? seen_code<std::uint32_t>(7, area > 0) : 0;
}

void draw(const std::vector<ScreenVertex>& screen, int x0, int y0, TilePixels& tile) {
    const DrawnObject object{screen.data(), 7, 1, false};
    const TileEntry entry{7, {0, 1, 2}};
    TileJob job;
    job.objects = &object;
    job.triangle_count = 8;
    job.entries = &entry;
    job.count = 1;
    job.x0 = x0;
    job.y0 = y0;
    visibility_kernels().draw(job, tile);
}

}  // namespace

TEST_CASE("a triangle of any size covers the samples defined by the fill rule", "[visibility][raster]") {
    std::mt19937 random(29);
    const int x0 = 128, y0 = 64;
    TilePixels tile;
    std::vector<std::uint32_t> seen(tile_size * tile_size);
    std::vector<std::uint16_t> groups(tile_size * tile_size / 16);
    const TileRows rows{seen.data(), groups.data(), tile_size, tile_size / 16, tile_size, tile_size};
    int covered = 0, wrong = 0;
    for (const int spread : {2, 9, 70, 3000, 400000}) {  // pixels; the last needs more than 32 bits
        for (int round = 0; round < 120; ++round) {
            const int grid = round % 3 == 0 ? 128 : 1;  // samples are often exactly on edges
            const auto place = [&](int middle) {
                const auto range = static_cast<std::uint32_t>(2 * spread * subpixels / grid + 1);
                return middle * subpixels +
                       (static_cast<int>(random() % range) - static_cast<int>(range / 2)) * grid;
            };
            const int mx = x0 + static_cast<int>(random() % 64), my = y0 + static_cast<int>(random() % 64);
            std::vector<ScreenVertex> v(3);
            for (ScreenVertex& corner : v) corner = {place(mx), place(my), 0.5f};
            draw(v, x0, y0, tile);
            visibility_kernels().take_rows(tile, rows);
            for (int y = 0; y < tile_size; ++y)
                for (int x = 0; x < tile_size; ++x) {
                    const auto at = static_cast<std::size_t>(y * tile_size + x);
                    const std::uint32_t code = seen[at];
                    wrong += (groups[at / 16] >> at % 16 & 1) != (code != 0);
                    wrong += code != expected(v, (x0 + x) * subpixels + 128, (y0 + y) * subpixels + 128);
                    covered += code != 0;
                }
        }
    }
    CHECK(wrong == 0);
    CHECK(covered > 100000);
}

TEST_CASE("a level edge through pixel centres belongs to the triangle below, at any size",
          "[visibility][raster]") {
    const int middle = 20, level = middle * subpixels + subpixels / 2;
    TilePixels tile;
    std::vector<std::uint32_t> seen(tile_size * tile_size);
    std::vector<std::uint16_t> groups(tile_size * tile_size / 16);
    const TileRows rows{seen.data(), groups.data(), tile_size, tile_size / 16, tile_size, tile_size};
    for (const int spread : {30, 3000, 300000}) {  // pixels
        INFO("spread " << spread);
        const int side = spread * subpixels;
        const auto covers_row = [&](int apex) {
            draw({{-side, level, 0.5f}, {side + 64 * subpixels, level, 0.5f}, {0, apex, 0.5f}}, 0, 0, tile);
            visibility_kernels().take_rows(tile, rows);
            const auto row = seen.begin() + std::ptrdiff_t{middle} * tile_size;
            return std::count_if(row, row + 20, [](std::uint32_t code) { return code != 0; });
        };
        CHECK(covers_row(level + side) == 20);  // its upper edge
        CHECK(covers_row(level - side) == 0);   // its lower one
    }
}

TEST_CASE("a tile's triangles give the same result in any order", "[visibility][raster]") {
    // The same five triangles, numbered as before but reordered: the nearest wins, then the lower number.
    std::vector<ScreenVertex> screen;
    std::mt19937 random(4);
    for (int i = 0; i < 15; ++i)
        screen.push_back({static_cast<int>(random() % 16384), static_cast<int>(random() % 16384),
                          i < 9 ? 0.5f : static_cast<float>(random() % 100) * 0.01f});
    const DrawnObject object{screen.data(), 0, 5, false};
    std::vector<TileEntry> entries;
    for (std::uint32_t n = 0; n < 5; ++n) entries.push_back({n, {3 * n, 3 * n + 1, 3 * n + 2}});
    TileJob job;
    job.objects = &object;
    job.triangle_count = 5;
    job.entries = entries.data();
    job.count = entries.size();
    TilePixels first, again;
    visibility_kernels().draw(job, first);
    CHECK(std::count(first.seen, first.seen + 4096, 0) < 3500);
    for (int round = 0; round < 20; ++round) {
        std::shuffle(entries.begin(), entries.end(), random);
        visibility_kernels().draw(job, again);
        CHECK(std::equal(first.seen, first.seen + 4096, again.seen));
    }
}

TEST_CASE("a tile at the picture's border does not write beyond it", "[visibility][raster]") {
    TilePixels tile;
    draw({{-9000000, -9000000, 0.5f}, {9000000, -9000000, 0.5f}, {0, 9000000, 0.5f}}, 0, 0, tile);
    for (int width = 1; width <= tile_size; width += 7) {
        std::vector<std::uint32_t> seen(tile_size * tile_size, 7);
        std::vector<std::uint16_t> groups(tile_size * tile_size / 16, 7);
        const int height = tile_size + 1 - width;
        visibility_kernels().take_rows(
            tile, {seen.data(), groups.data(), tile_size, tile_size / 16, width, height});
        int wrong = 0;
        for (int y = 0; y < tile_size; ++y)
            for (int x = 0; x < tile_size; ++x) {
                const auto at = static_cast<std::size_t>(y * tile_size + x);
                wrong += (seen[at] == 7) != (x >= width || y >= height);
                if (y < height && x / 16 * 16 < width)
                    wrong += (groups[at / 16] >> x % 16 & 1) != (x < width);
            }
        CHECK(wrong == 0);
    }
}
