#pragma once
// Draws thumbnails in the background, one after the other, onto a sheet that the window shows: for the
// examples, and for the open scene with each mistake.

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/scene.h"
#include "renderer/picture.h"
#include "renderer/renderer.h"
#include "ui/document/job.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

/// The result of drawing one thumbnail.
struct SmallPicture {
    Picture picture;    // has the sheet's cell size; without bytes, only the text is shown
    std::string words;  // text about it, or shown in its place
};
/// Draws the picture with that index; called in order, from 0, on a background thread. The function may
/// only touch its own data.
using DrawSmall = std::function<SmallPicture(Renderer& renderer, int index)>;

struct DrawnSmall;  // the pictures finished so far

struct SmallPictures {
    PictureSheet sheet;
    std::vector<std::string> words;  // text of each picture collected so far
    int taken = 0;        // collected pictures of the last job, from index 0; the rest are old pictures
    std::string problem;  // why the other pictures are not drawn; empty: no problem
    std::shared_ptr<DrawnSmall> drawn;  // the job's finished pictures; null: no more are wanted
    JobPtr<int> job;                    // at most one job draws, on one thread, with its own renderer
};

/// Starts drawing `count` pictures of this size on a thread named `name`. If size and count have not changed,
/// the sheet shows each old picture until the new one is drawn. Precondition: no job is running.
void begin_small_pictures(Jobs& jobs, SmallPictures& small, const std::string& name, PictureSize cell,
                          int count, DrawSmall draw);
/// Stops collecting pictures; the job ends after its current one.
void stop_small_pictures(SmallPictures& small);
/// Copies newly drawn pictures to the sheet. Once a frame while there is a job.
void take_small_pictures(SmallPictures& small);

// Maps a picture that another program drew through a scene's camera to the window's picture of that scene,
// which may have a different size and aspect ratio.

/// Maps the pixels of one picture to those of another picture from the same camera: `scale` times the
/// position, plus `offset`, in pixels of the other picture.
struct PixelsBetween {
    glm::dvec2 scale{1}, offset{0};

    [[nodiscard]] glm::dvec2 operator()(glm::dvec2 place) const { return scale * place + offset; }
};
[[nodiscard]] PixelsBetween pixels_between(const Camera& camera, PictureSize from, PictureSize to);

/// The pixel of the other picture that contains a pixel's centre; nullopt if that is outside it.
[[nodiscard]] std::optional<glm::ivec2> pixel_in(const PixelsBetween& between, glm::ivec2 pixel,
                                                 PictureSize to);

/// Returns `picture` (bytes) at the size of `shown`, a picture of `scene`: each pixel is taken from the same
/// position. Pixels outside `picture` are grey, or taken from `shown` if `fills`. Linear colours are computed
/// from the bytes if `shown` has them.
[[nodiscard]] Picture fitted_picture(const Picture& picture, const Scene& scene, const Picture& shown,
                                     bool fills);

}  // namespace glint
