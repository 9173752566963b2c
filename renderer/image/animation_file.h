#pragma once
// Writes a sequence of pictures of equal size as an endlessly looping GIF or WebP file.

#include <memory>
#include <optional>
#include <string>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// Gif: at most 256 colours per frame, chosen for each frame and dithered; supported by every program. WebP:
/// the exact colours, in a smaller file.
enum class AnimationFormat { Gif, WebP };

/// Returns the format for the extension of `path`, in any case; nullopt for an unknown extension.
[[nodiscard]] std::optional<AnimationFormat> animation_format(const std::string& path);

class AnimationWriter {
  public:
    virtual ~AnimationWriter() = default;
    /// Adds a frame. Precondition: the picture has the writer's size.
    [[nodiscard]] virtual std::optional<Problem> add(const Picture& picture) = 0;
    /// Returns the bytes of the file. Preconditions: it has not been called before, and at least one frame
    /// has been added.
    [[nodiscard]] virtual Result<std::string> finish() = 0;
};

/// Returns a writer, or a problem if the format does not support pictures of this size. Precondition: 1 to 50
/// frames per second.
[[nodiscard]] Result<std::unique_ptr<AnimationWriter>> animation_writer(AnimationFormat format,
                                                                        PictureSize size,
                                                                        int frames_a_second);

/// Called by animation_writer().
[[nodiscard]] std::unique_ptr<AnimationWriter> gif_writer(PictureSize size, int frames_a_second);
[[nodiscard]] std::unique_ptr<AnimationWriter> webp_writer(PictureSize size, int frames_a_second);

}  // namespace glint
