#pragma once
// Intensity along a line in the picture, with its differences. They show Mach bands, which are caused by a
// discontinuity in the first difference. Lecture: "Gouraud Shading Artifacts" (Mach bands: discontinuity of
// the first derivative).

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/picture.h"
#include "renderer/renderer.h"

namespace glint {

/// One pixel on the line, with the picture's unmodified value.
struct ProfileSample {
    glm::ivec2 pixel{0};
    double position = 0;  // along the line, in pixels from its first sample
    glm::vec3 color{0};   // linear RGB before exposure, not clamped
    double intensity = 0;
    std::optional<double> first_difference;   // from the previous sample; empty at the first
    std::optional<double> second_difference;  // I(i + 1) - 2 I(i) + I(i - 1); empty at both ends
    std::optional<SeenPoint> seen;            // empty on the background
};

/// Luminance of linear RGB with sRGB primaries: 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709). For greys it
/// equals the channels.
[[nodiscard]] double intensity_of(glm::vec3 linear);

/// The pixels nearest to the line from `from` to `to`, ends included, one for each step along the line's
/// longer axis. Neighbours are one pixel apart on a horizontal or vertical line, up to sqrt(2) on others.
/// from = to gives one sample. Preconditions: the picture is the last one drawn by `renderer`, with `linear`;
/// both ends are inside it.
[[nodiscard]] std::vector<ProfileSample> profile(const Renderer& renderer, const Picture& picture,
                                                 glm::ivec2 from, glm::ivec2 to);

/// The slopes (first differences) before and after a discontinuity in the slope.
struct SlopeJump {
    double before = 0, after = 0;
};
/// Returns the slope discontinuity at a sample. A discontinuity between two samples is divided between their
/// second differences, so neither shows its full height. Returns nullopt if the intensity is smooth or is
/// itself discontinuous.
[[nodiscard]] std::optional<SlopeJump> slope_jump_at(const std::vector<ProfileSample>& samples,
                                                     std::size_t at);

/// Returns the intensities as perceived: I + (c - s), where c and s are the means under a narrow and a wide
/// Gaussian with standard deviations of 1 and `surround_px` (> 1) pixels along the line, truncated at four
/// deviations and at the ends of the line. The weights of a mean sum to 1, so constant and linear intensities
/// are unchanged, and a band appears only where the slope changes: dark before an increase, bright after it.
/// One value per sample. Source: the receptive field as a difference of Gaussians (R. Rodieck 1965); F.
/// Ratliff, "Mach Bands" (1965).
[[nodiscard]] std::vector<double> perceived(const std::vector<ProfileSample>& samples, double surround_px);

/// A header and one line per sample; missing values are empty fields. Numbers use the shortest text that
/// parses to the same value.
[[nodiscard]] std::string profile_csv(const std::vector<ProfileSample>& samples);

}  // namespace glint
