#pragma once
// Draws thumbnails in the background, one after the other, onto a sheet that the window shows: the examples,
// the open scene under each mistake.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "ui/document/job.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

/// The result of drawing one thumbnail.
struct SmallPicture {
    Picture picture;    // has the sheet's cell size; without bytes, only the text is shown
    std::string words;  // text about it, or shown in its place
};
/// Draws the picture with that index; called in order, from 0, on a background thread. It may only touch its
/// own data.
using DrawSmall = std::function<SmallPicture(Renderer& renderer, int index)>;

struct DrawnSmall;  // the pictures finished so far

struct SmallPictures {
    PictureSheet sheet;
    std::vector<std::string> words;  // text of each picture collected so far
    int taken = 0;        // collected pictures of the last job, from index 0; the rest are old pictures
    std::string problem;  // why the rest is not drawn; empty: no problem
    std::shared_ptr<DrawnSmall> drawn;  // the job's finished pictures; null: no more are wanted
    JobPtr<int> job;                    // at most one draws, on one thread, with its own renderer
};

/// Starts drawing `count` pictures of this size on a thread named `name`. If size and count have not changed,
/// the sheet shows each old picture until the new one is drawn. Precondition: no job is running.
void begin_small_pictures(Jobs& jobs, SmallPictures& small, const std::string& name, PictureSize cell,
                          int count, DrawSmall draw);
/// Stops collecting pictures; the job ends after its current one.
void stop_small_pictures(SmallPictures& small);
/// Copies newly drawn pictures to the sheet. Once a frame while there is a job.
void take_small_pictures(SmallPictures& small);

}  // namespace glint
