#pragma once
// Encodes and decodes pictures (models/io/file.h writes the bytes): PNG (8 bit, with its scene in a text
// chunk), PFM and OpenEXR (linear float).

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

enum class PictureFormat { Png, Pfm, Exr };
/// Returns the format for the extension of `path`, in any case. The problem for an unknown extension lists
/// the known ones.
[[nodiscard]] Result<PictureFormat> picture_format(const std::string& path);
/// Returns ".png", ".pfm" or ".exr".
[[nodiscard]] const char* extension_of(PictureFormat format);
/// Whether the format stores linear floats, which requires Picture::linear.
[[nodiscard]] constexpr bool is_linear(PictureFormat format) { return format != PictureFormat::Png; }

/// Encodes a picture. `exposure` is for the linear formats, `scene_json` for PNG: see below.
[[nodiscard]] std::string picture_bytes(const Picture& picture, PictureFormat format, float exposure,
                                        const std::string& scene_json);

/// Encodes red, green and blue of `rgba` as PNG. `scene_json`, unless empty, is stored in a text chunk (iTXt,
/// not compressed, keyword png_scene_keyword in models/scene_file/scene_file.h). Equal input gives equal
/// bytes. Precondition: the size is 1x1 to 16384x16384. Source: PNG specification (W3C, second edition),
/// sections 5.3 and 11.3.4.5.
[[nodiscard]] std::string png_bytes(const Picture& picture, const std::string& scene_json);

/// Encodes a PFM: "PF", little-endian (scale -1.0), bottom row first, with the values of `linear` after
/// exposed(). Precondition: picture.linear is filled. Source: Debevec's PFM, as described in Netpbm's manual.
[[nodiscard]] std::string pfm_bytes(const Picture& picture, float exposure);

/// Encodes OpenEXR: 32-bit float channels R, G, B with lossless ZIP compression and the same values as the
/// PFM. Precondition: picture.linear is filled. Source: OpenEXR 3, Academy Software Foundation.
[[nodiscard]] std::string exr_bytes(const Picture& picture, float exposure);

/// Reads a PNG of any colour type and bit depth, up to 16384x16384, as 8-bit RGBA; `linear` stays empty.
/// Treats all samples as sRGB, as in files written by Glint. "-" is standard input.
[[nodiscard]] Result<Picture> read_png(const std::string& path);

/// Reads a PFM (colour or grey, either byte order) or an OpenEXR (R, G, B or Y, 16 or 32 bits), written by
/// any program, up to 16384x16384. Keeps the linear values exactly as stored, unbounded and possibly NaN;
/// `rgba` stays empty. "-" is standard input.
[[nodiscard]] Result<Picture> read_pfm(const std::string& path);
[[nodiscard]] Result<Picture> read_exr(const std::string& path);

/// Reads a picture in the format given by the file's extension.
[[nodiscard]] Result<Picture> read_picture(const std::string& path);

/// The picture as a self-contained HTML element. `alt` is its alternative text.
[[nodiscard]] std::string html_image(const Picture& picture, std::string_view alt);

// Writes a sequence of pictures of equal size as an endlessly looping GIF or WebP file.

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
