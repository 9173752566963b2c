#pragma once
// The command line that draws the picture on the screen.

#include <string>

#include "models/scene_file/scene_file.h"

namespace glint {

/// `glint render FILE --set … --size WxH -o OUT` for a POSIX shell: what differs from the file stands in
/// --set. `in_file`: the scene as the document's file has it. A document without a file, or whose file is
/// gone, is set whole on an empty scene from standard input. `samples`: 1, 2, 4 or 8.
[[nodiscard]] std::string render_command_text(const SceneDocument& document, const Scene& in_file,
                                              PictureSize size, int samples, const std::string& out);

}  // namespace glint
