#pragma once
// Writes a sequence of pictures of one size as a file that repeats for ever: GIF and WebP.

#include <memory>
#include <optional>
#include <string>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// Gif: at most 256 colours per frame, chosen for that frame and dithered; every program shows it. WebP:
/// exactly the pictures' colours, in a smaller file.
enum class AnimationFormat { Gif, WebP };

/// Returns the format by the extension of `path`, in any case; nothing for another extension.
[[nodiscard]] std::optional<AnimationFormat> animation_format(const std::string& path);

class AnimationWriter {
  public:
    virtual ~AnimationWriter() = default;
    /// Adds a frame. Precondition: the picture has the writer's size.
    [[nodiscard]] virtual std::optional<Problem> add(const Picture& picture) = 0;
    /// Returns the bytes of the file. Precondition: this is the first call, and at least one frame was added.
    [[nodiscard]] virtual Result<std::string> finish() = 0;
};

/// Returns a writer, or the problem with pictures of that size. Precondition: 1 to 50 frames a second.
[[nodiscard]] Result<std::unique_ptr<AnimationWriter>> animation_writer(AnimationFormat format,
                                                                        PictureSize size,
                                                                        int frames_a_second);

/// Called by animation_writer().
[[nodiscard]] std::unique_ptr<AnimationWriter> gif_writer(PictureSize size, int frames_a_second);
[[nodiscard]] std::unique_ptr<AnimationWriter> webp_writer(PictureSize size, int frames_a_second);

}  // namespace glint
