#pragma once
// Small pictures are drawn beside the window, one after the other, onto a sheet that it shows: the examples,
// the open scene under each mistake.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "ui/document/job.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

/// What came of drawing one.
struct SmallPicture {
    Picture picture;    // of the sheet's cell; without bytes: there is none
    std::string words;  // about it, or in its place
};
/// Draws the one with that number; they come in order, from 0. It runs on another thread than the window and
/// may only touch what it holds itself.
using DrawSmall = std::function<SmallPicture(Renderer& renderer, int index)>;

struct DrawnSmall;  // what the job has finished so far

struct SmallPictures {
    PictureSheet sheet;
    std::vector<std::string> words;  // of each, as taken last
    int taken = 0;        // of those begun last, from the front; the rest show what was there before
    std::string problem;  // why the rest of them is not drawn; empty: nothing stands in the way
    std::shared_ptr<DrawnSmall> drawn;  // what the job has drawn; null: no more of it is wanted
    JobPtr<int> job;                    // at most one draws, on one thread, with a renderer of its own
};

/// Begins `count` pictures of this size on a thread named `name`. If size and count stay the same, the sheet
/// shows each old picture until the new one is drawn. Precondition: there is no job.
void begin_small_pictures(Jobs& jobs, SmallPictures& small, const std::string& name, PictureSize cell,
                          int count, DrawSmall draw);
/// Wants no more of them: none is taken, and the job ends after the picture that it is at.
void stop_small_pictures(SmallPictures& small);
/// Puts onto the sheet what has been drawn since. Once a frame while there is a job.
void take_small_pictures(SmallPictures& small);

}  // namespace glint
