#pragma once
// Moving pictures as GIF, for slides that show nothing else. A frame has at most 256 colours: steps that are
// not in the picture appear in its gradients. Where it can be, a row of PNG files is the better choice.

#include <memory>
#include <string>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

/// GIF89a, endlessly repeated; each frame has a palette of its own (median cut, Heckbert 1982).
class GifWriter {
  public:
    /// `hundredths`: how long each frame is shown. Precondition: the size is 1x1 to 16384x16384.
    GifWriter(PictureSize size, int hundredths);
    ~GifWriter();
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;

    /// Adds a picture of that size. False when there is no memory for it.
    [[nodiscard]] bool add(const Picture& picture);
    /// The whole file, once.
    [[nodiscard]] Result<std::string> finish();

  private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace glint
