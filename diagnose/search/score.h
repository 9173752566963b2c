#pragma once
// Judges one explanation of a wrong picture on every pixel that can be compared.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "diagnose/search/display_change.h"
#include "diagnose/search/probes.h"

namespace glint {

/// A drawn picture, and the pixels at which it shows no surface.
struct Drawing {
    Picture picture;
    BareMask bare;  // empty: as in the correct picture
};

/// The picture under diagnosis, the correct one, and what may be compared. All have the same size.
struct Exhibit {
    const Picture& wrong;
    const Picture& right;
    const std::vector<PixelKind>& kinds;
    // The wrong picture's grounds, indexed by way_turned():
    std::array<std::optional<Rgb>, 4> grounds;  // background_of()
    std::array<Ground, 4> bare_grounds;         // ground_of()
    DisplayChange least_change;                 // a change in noise only

    /// `noise`: as in DisplayChange.
    Exhibit(const Picture& wrong_picture, const Picture& right_picture,
            const std::vector<PixelKind>& of_pixels, float noise = 0);
};

struct Score {
    std::uint64_t compared = 0;     // how many pixels
    std::uint64_t unlike = 0;       // how many differ by more than visible_levels in some channel
    std::uint64_t far = 0;          // of the unlike ones, those that differ by more than clear_levels
    std::uint64_t solid = 0;        // of the unlike ones, those whose four neighbours are unlike
    std::uint64_t wrong = 0;        // how many differ from the correct picture by more than that
    std::uint64_t explained = 0;    // of the wrong ones, those that the explanation matches
    double excess = 0;              // sum of excess_of()
    double squares = 0;             // sum of the squares of the differences in levels, channel by channel
    double off = 0, off_right = 0;  // total error over the wrong pixels, in levels: of the explanation's
                                    // picture, and of the correct picture
    float told_best = -std::numeric_limits<float>::infinity();  // the evidence at `pixel`, in levels
    glm::ivec2 pixel{0};  // of the scene's picture: where it differs most clearly from the correct one

    [[nodiscard]] double residual() const;  // RMS in levels
    [[nodiscard]] double share_explained() const;
    /// Whether the explanation's drawing is nearer to the wrong pixels than the correct picture is. The range
    /// that noise and softness allow around a drawing does not count.
    [[nodiscard]] bool comes_nearer() const;
    /// Whether the explanation matches the entire picture, except for rounding and edges.
    [[nodiscard]] bool fits() const;
    /// Whether few enough pixels are unlike for the explanation to fit.
    [[nodiscard]] bool may_fit() const;
};

/// Another correct program may differ by up to this many levels.
inline constexpr float visible_levels = 2;
/// A larger difference is obvious at a glance.
inline constexpr float clear_levels = 6;

/// `step`: only every `step`-th row is compared. `solid` is filled in only if `step` is 1 and few pixels are
/// unlike.
[[nodiscard]] Score score(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change,
                          int step = 1);

/// How many pixels there are of a kind, and how many of them differ by more than visible_levels.
struct PixelCount {
    std::uint64_t pixels = 0, unlike = 0;
    float most = 0;  // the largest difference, in levels

    [[nodiscard]] double share() const {
        return pixels == 0 ? 0 : static_cast<double>(unlike) / static_cast<double>(pixels);
    }
};
using PixelCounts = std::array<PixelCount, 3>;  // by PixelKind
[[nodiscard]] inline const PixelCount& count_of(const PixelCounts& counts, PixelKind kind) {
    return counts[static_cast<std::size_t>(kind)];
}
/// Counts, for each PixelKind, the pixels that differ from a drawing. The background is compared with the
/// colour that more than half of it has in the wrong picture, if there is one.
[[nodiscard]] PixelCounts count_unlike(const Exhibit& exhibit, const Drawing& drawing,
                                       const DisplayChange& change);

/// What the changed picture would show for a colour of the scene's picture, in whole levels.
[[nodiscard]] Rgb shown(const ByteRanges& ranges, Rgb drawn);
/// Does the same, given the colour of the same pixel in the wrong picture, `mine`: a clamped byte is shown as
/// that of `mine` if it may have had that value before clamping.
[[nodiscard]] Rgb shown_beside(const ByteRanges& ranges, Rgb drawn, Rgb mine);
/// The wrong picture's colour at a pixel of the scene's picture, channels in the scene's order.
[[nodiscard]] Rgb mine_at(const Picture& wrong, const DisplayChange& change, int x, int y);

// Distinguishes a softened picture from one with wrong lighting. A single wrong colour is not enough: it may
// be between the colours of its neighbours by chance.

/// Returns how far the wrong picture's surfaces are shifted to the right and down from the drawing's, in
/// pixels; zero if the shift is unknown or more than four pixels. Reads every `rows`-th row.
[[nodiscard]] glm::vec2 fitted_shift(const Exhibit& exhibit, const Picture& drawn,
                                     const DisplayChange& change, int rows = 1);

/// Whether the wrong picture's silhouettes are much softer than those of the drawing, that is, anti-aliased.
[[nodiscard]] bool has_smooth_edges(const Exhibit& exhibit, const Drawing& drawn,
                                    const DisplayChange& change);

/// Whether the wrong picture was neither blurred nor resampled: its silhouettes are as sharp as the
/// drawing's, and no shift explains most of the difference on surfaces. False if the drawing has too few
/// sharp edges to decide.
[[nodiscard]] bool is_hard(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

/// Whether the surfaces of the wrong picture may be those of the drawing, blurred and perhaps shifted. One
/// filter kernel of 3 x 3 pixels, the same everywhere, must explain part of the difference. A blur spreads
/// brightness but adds none: if the wrong picture is darker nearly everywhere, or brighter nearly everywhere,
/// the kernel must explain most of the difference. Returns false if is_hard(). Precondition: `change` is
/// soft.
[[nodiscard]] bool may_be_softened(const Exhibit& exhibit, const Drawing& drawn, const DisplayChange& change);

// Noise from a sampling renderer, from dithering or from a camera.

/// Returns the standard deviation, in levels, of noise that is independent from pixel to pixel; 0 if the
/// picture has little, or not clearly more than `right`, which has none. Both have the same size.
/// Source: J. Immerkær, Fast Noise Variance Estimation, Computer Vision and Image Understanding 64(2), 1996.
/// We use the median instead of the mean, and only within areas: edges and creases cover few pixels, in
/// lines.
[[nodiscard]] float noise_of(const Picture& wrong, const Picture& right);

}  // namespace glint
