#pragma once
// Pictures to and from bytes (models/io/file.h writes them): PNG (8 bit, carrying its scene in a text chunk),
// PFM and OpenEXR (linear float).

#include <string>

#include "models/problem.h"
#include "renderer/picture.h"

namespace glint {

enum class PictureFormat { Png, Pfm, Exr };
/// Returns the format by the extension of `path`, in any case. The problem for another extension lists the
/// known ones.
[[nodiscard]] Result<PictureFormat> picture_format(const std::string& path);
/// ".png", ".pfm", ".exr".
[[nodiscard]] const char* extension_of(PictureFormat format);
/// Whether it stores linear floats: then Picture::linear must be filled.
[[nodiscard]] constexpr bool is_linear(PictureFormat format) { return format != PictureFormat::Png; }

/// Returns the bytes of a file. `exposure` is for the linear formats, `scene_json` for PNG: see below.
[[nodiscard]] std::string picture_bytes(const Picture& picture, PictureFormat format, float exposure,
                                        const std::string& scene_json);

/// PNG bytes of the red, green and blue of `rgba`; `scene_json` goes into a text chunk (iTXt, not compressed,
/// keyword png_scene_keyword of models/scene_file/scene_file.h) unless empty. The same input gives the same
/// bytes. Precondition: the size is 1x1 to 16384x16384. Source: PNG specification (W3C, second edition),
/// sections 5.3 and 11.3.4.5.
[[nodiscard]] std::string png_bytes(const Picture& picture, const std::string& scene_json);

/// PFM bytes: "PF", little-endian (scale -1.0), bottom row first, the numbers of `linear` exposed().
/// Precondition: picture.linear is filled. Source: Debevec's PFM, as Netpbm's manual describes it.
[[nodiscard]] std::string pfm_bytes(const Picture& picture, float exposure);

/// OpenEXR bytes: 32-bit float channels R, G, B, losslessly ZIP-compressed, with the same numbers as the PFM.
/// Precondition: picture.linear is filled. Source: OpenEXR 3, academysoftwarefoundation.
[[nodiscard]] std::string exr_bytes(const Picture& picture, float exposure);

/// Reads a PNG of any colour type and depth, up to 16384x16384, as 8-bit RGBA; `linear` stays empty. Samples
/// of any depth are taken as sRGB, as Glint writes them. "-" is standard input.
[[nodiscard]] Result<Picture> read_png(const std::string& path);

/// Reads a PFM (colour or grey, either order of bytes) or an OpenEXR (R, G, B or Y, 16 or 32 bits), of any
/// program, up to 16384x16384: linear numbers exactly as in the file, unbounded, possibly NaN; `rgba` stays
/// empty. "-" is standard input.
[[nodiscard]] Result<Picture> read_pfm(const std::string& path);
[[nodiscard]] Result<Picture> read_exr(const std::string& path);

/// Reads a picture in the format that the file's extension names.
[[nodiscard]] Result<Picture> read_picture(const std::string& path);

}  // namespace glint
