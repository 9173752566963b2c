#pragma once
// Copies pictures and commands to the clipboard. Pictures need desktop tools, because GLFW's clipboard
// supports only text.

#include <atomic>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "models/problem.h"
#include "models/scene_file/scene_file.h"

namespace glint {

/// The reason why pictures cannot be copied, as text for the user; empty if they can.
[[nodiscard]] std::string clipboard_disabled_reason();

/// Runs a program with the file `input` as its standard input and returns its exit status; -1 if it did not
/// run, or was killed because `cancelled` was set. Must not be called on the window's thread.
[[nodiscard]] int run_tool(const std::vector<std::string>& command, int input,
                           const std::atomic<bool>* cancelled = nullptr);
/// The reason why no MP4 can be written; empty if one can.
[[nodiscard]] std::string mp4_disabled_reason();

/// Copies PNG bytes to the clipboard and waits until the tool has read them. Must not be called on the
/// window's thread.
[[nodiscard]] Result<std::monostate> copy_png(const std::string& bytes);

/// Quotes the text as one word of a POSIX shell: unchanged if that is safe, otherwise in single quotes.
[[nodiscard]] std::string shell_word(const std::string& text);
/// A path as a word that cannot be read as an option: "./-a.json".
[[nodiscard]] std::string file_word(const std::string& path);

/// `glint render FILE --set … --size WxH -o OUT` for a POSIX shell in the working directory: differences from
/// the file are passed with --set. `in_file`: the scene in the document's file. If the document has no file,
/// or its file was deleted, the command sets everything on an empty scene from standard input. `samples`: 1,
/// 2, 4 or 8.
[[nodiscard]] std::string render_command_text(const SceneDocument& document, const Scene& in_file,
                                              PictureSize size, int samples, const std::string& out);
/// `glint profile FILE --set … --size WxH --from X,Y --to X,Y`, composed like render_command_text(). `from`
/// and `to` are pixels of that picture.
[[nodiscard]] std::string profile_command_text(const SceneDocument& document, const Scene& in_file,
                                               PictureSize size, glm::ivec2 from, glm::ivec2 to);

}  // namespace glint
