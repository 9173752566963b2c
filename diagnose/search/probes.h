#pragma once
// The colours of pictures at a few chosen pixels, which are enough to test a large number of explanations of
// a wrong picture.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "diagnose/search/display_change.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "renderer/simd/lanes.h"

namespace glint {

// The pixels of a scene's picture that another program must draw in the same way, however it draws edges.

enum class PixelKind : std::uint8_t {
    Background,  // it and its eight neighbours show no surface
    Edge,        // a silhouette, a crease, a neighbour of these, or what a stroke covers, however wide
    Surface      // it and its neighbours show one surface
};

/// The kind of each pixel of the renderer's last picture, which was drawn with one sample.
[[nodiscard]] std::vector<PixelKind> pixel_kinds(const Renderer& renderer, PictureSize size);

/// For each pixel of a picture, 1 if it shows no surface; empty if these are the same pixels as in the
/// correct picture.
using BareMask = std::vector<std::uint8_t>;

/// Computes the masks of the pictures that one renderer draws. Call of() after each picture.
class BareMasks {
  public:
    /// Returns the mask of the renderer's last picture. The first picture is the correct one.
    [[nodiscard]] BareMask of(const Renderer& renderer, PictureSize size);

  private:
    BareMask right_, last_;
};

using Rgb = std::array<std::uint8_t, 3>;
[[nodiscard]] inline Rgb rgb_at(const Picture& picture, std::size_t pixel) {
    return {picture.rgba[4 * pixel], picture.rgba[4 * pixel + 1], picture.rgba[4 * pixel + 2]};
}

/// The difference between two colours, in levels, in the channel in which it is largest.
[[nodiscard]] inline int most_apart(Rgb a, Rgb b) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a[c]} - int{b[c]}));
    return most;
}

/// Each channel's smallest and largest level among a pixel of a picture and those around it.
struct RgbBounds {
    Rgb low{255, 255, 255}, high{};
    void add(Rgb color) {
        for (std::size_t c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], color[c]);
            high[c] = std::max(high[c], color[c]);
        }
    }
    /// The difference between the two, in levels, in the channel in which it is largest.
    [[nodiscard]] int spread() const { return most_apart(low, high); }
};
[[nodiscard]] RgbBounds bounds_around(const Picture& picture, glm::ivec2 pixel);

/// bounds_around() for all pixels of a row, faster than one at a time.
class RowBounds {
  public:
    RowBounds(const Picture& picture, int y);
    [[nodiscard]] RgbBounds at(int x) const {
        const std::size_t i = 4 * static_cast<std::size_t>(x);
        return {{low_[i], low_[i + 1], low_[i + 2]}, {high_[i], high_[i + 1], high_[i + 2]}};
    }

  private:
    std::vector<std::uint8_t> low_, high_;  // four channels of each pixel
};

struct Probe {
    int x = 0, y = 0;
};

/// The blocks that contain the probes and the eight pixels around each.
[[nodiscard]] BlockChoice blocks_of(const std::vector<Probe>& probes, PictureSize size);

/// Three channels per probe, one probe after another.
using ProbeLevels = std::vector<std::uint8_t>;

/// A drawn picture at the probes.
struct DrawnProbes {
    ProbeLevels at, low, high;       // low, high: each channel's bounds among the 3 x 3 pixels around
    std::vector<std::uint8_t> bare;  // for each probe, 1: no surface shows there; empty if all show one
    bool operator==(const DrawnProbes&) const = default;
};
/// Whether a pixel of a drawn picture shows no surface; empty if all probes show one.
using IsBare = std::function<bool(int x, int y)>;
[[nodiscard]] DrawnProbes drawn_at(const std::vector<Probe>& probes, const Picture& picture,
                                   const IsBare& is_bare);

/// Returns the colour that more than `share` of the scene's background pixels have in the wrong picture,
/// within the noise of `change`; nothing if none has. Precondition: `share` is at least 0.5.
/// Of `change`, only the noise and the flip are used.
[[nodiscard]] std::optional<Rgb> background_of(const Picture& wrong, const std::vector<PixelKind>& kinds,
                                               const DisplayChange& change, double share = 0.5);

/// What the wrong picture must show where a mistake removes the surface.
struct Ground {
    bool is_known = false;          // false: the scene shows no background; the drawing is compared there
    std::array<float, 3> levels{};  // of the wrong picture's channels. If its background is not one colour,
                                    // it is not this scene's: the levels are then ones that no byte has
};
[[nodiscard]] Ground ground_of(const Picture& wrong, const std::vector<PixelKind>& kinds,
                               const DisplayChange& change);

/// The picture under diagnosis at the probes, for each way of flipping it and swapping its channels.
class WrongProbes {
  public:
    /// `noise`: as in DisplayChange.
    WrongProbes(const std::vector<Probe>& probes, const Picture& wrong, const std::vector<PixelKind>& kinds,
                float noise);
    [[nodiscard]] float noise() const { return noise_; }
    /// Levels in the order of the scene's channels, like those of ground().
    [[nodiscard]] const ProbeLevels& at(const DisplayChange& change) const { return at_[way(change)]; }
    [[nodiscard]] const Ground& ground(const DisplayChange& change) const { return ground_[way(change)]; }

  private:
    static std::size_t way(const DisplayChange& change) {
        return 2 * way_turned(change) + (change.red_blue ? 1U : 0U);
    }

    std::array<ProbeLevels, 8> at_;
    std::array<Ground, 8> ground_;
    float noise_;
};

/// A difference up to this is due to rounding and does not count.
inline constexpr float free_levels = 1;
/// The weight of a difference in levels: its square beyond the free levels, at most 16.
template <Number F> [[nodiscard]] F excess_of(F levels) {
    const F beyond = max0(levels - F(free_levels));
    return min(beyond * beyond, F(16));
}

/// Sum of excess_of() over all channels of all probes; the sum stops once it exceeds `enough`. `bounds` are
/// those of `change`.
[[nodiscard]] double excess_at(const DrawnProbes& drawn, const WrongProbes& wrong,
                               const DisplayChange& change, const ByteBounds& bounds, double enough);

/// The gain under which `change` explains most channels; nothing if too few channels show it.
[[nodiscard]] std::optional<float> fitted_gain(const DrawnProbes& drawn, const WrongProbes& wrong,
                                               const DisplayChange& change);

}  // namespace glint
