#pragma once
// Keeps a drag fluent: when a picture of full size takes too long, smaller ones are drawn while the hand
// moves, and the full one as soon as it rests. A state machine of its own: milliseconds in, a divisor out.

#include "renderer/picture.h"

namespace glint {

/// A picture at full size that takes longer than this is drawn smaller while something moves.
inline constexpr double slow_picture_ms = 33;

struct FramePace {
    double slow_ms = slow_picture_ms;  // infinite where no hand waits
    int divisor = 1;                   // of the picture's width and height, for the next picture
    double full_ms = 0;                // what one of full size took, or is judged to take
    bool in_vain = false;              // smaller ones are not faster: the time goes elsewhere
    double rests_since = 0;            // seconds on the clock that the caller keeps: the last change
    int drawn_at = 0;  // divisor of the picture drawn in this frame; 0: none was, or nothing moves
    // For want of memory, pictures of this size are divided by that, hand or no hand. Now and then a larger
    // one is tried.
    PictureSize memory_divided{0, 0};
    int memory_divisor = 1;
    double memory_wait = 0, memory_rests_until = 0;  // seconds, on the clock as above
    bool memory_tries_again = false;
};

/// Smaller ones are chosen to take about this.
inline constexpr double wanted_picture_ms = 24;
inline constexpr int largest_divisor = 4;
/// The hand rests when nothing has changed for so long, in seconds: then the full picture is drawn.
inline constexpr double rest_before_full = 0.15;

/// A gesture has ended: the next picture is a full one.
void end_of_motion(FramePace& pace);

/// Learns from a picture drawn at `divisor` in `ms`, while something moves.
void picture_took(FramePace& pace, int divisor, double ms);

/// `full` divided, each side at least 1.
[[nodiscard]] PictureSize divided(PictureSize full, int divisor);

}  // namespace glint
