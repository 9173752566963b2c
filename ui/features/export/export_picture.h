#pragma once
// Pictures out of the window: at a chosen size and number of samples into a file, or onto the clipboard.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "models/scene_file/scene_file.h"
#include "renderer/picture.h"
#include "ui/document/file_dialog.h"
#include "ui/document/job.h"
#include "ui/shell/layout.h"
#include "ui/shell/notifications.h"

namespace glint {

struct UiInput;
struct UiState;

struct ExportOptions {
    PictureSize size{1920, 1080};
    int samples = 4;
};

/// What was written last. "Copy as command" repeats it as long as the document is the same.
struct LastExport {
    ExportOptions options;
    std::string file;      // its name
    std::string document;  // the document's path
};

struct ExportState {
    bool open = false;
    ExportOptions options;
    std::optional<LastExport> last;
    JobPtr<Notification> job;  // its result: what to say when it is done
};

/// Returns the scene whose picture of that size shows what the window would: the field of view that the
/// window widens for a narrow picture (fitted()) is written out.
[[nodiscard]] Scene as_shown(Scene scene, PictureSize size);

/// The bytes of a picture file: PNG that carries its scene, PFM or EXR, by the extension of `path`; mesh
/// paths in the carried scene lead to the meshes from there. Draws with a renderer of its own.
[[nodiscard]] Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                               const std::string& path, int threads);

/// The words of a command about a document, whose file has the scene `in_file`.
using CommandText = std::function<std::string(const SceneDocument& document, const Scene& in_file)>;
/// Returns `text` for the open document with the scene that the picture shows. A new scene may have begun as
/// the default scene, which has a file: the text based on that file is taken if it is shorter.
[[nodiscard]] std::string shortest_command(const UiState& state, const CommandText& text);

extern const FilePurpose save_picture_purpose, export_purpose;
/// Asks for the name of a picture file, and names what it will show or lack.
void ask_for_picture(UiState& state, const FilePurpose& purpose);
/// Draws and writes in the background; a notification then names the file, its folder, and what the picture
/// shows or lacks.
void begin_export(UiState& state, const ExportOptions& options, const std::string& path);
/// Copies the picture as it is shown onto the clipboard, in the background.
void begin_copy(UiState& state);
/// Copies the command line that draws the shown scene with these options into the file `out`.
void copy_render_command(UiState& state, const ExportOptions& options, const std::string& out);
/// Copies the command line with the options of the scene's last export, or for the picture as it is shown if
/// there was none. Precondition: the picture is drawn.
void copy_last_command(UiState& state);
/// Once a frame: if the job is done, shows its result as a notification and ends it.
void poll_job(JobPtr<Notification>& job, Notifications& notifications);

/// The question about size and samples; the file's name is asked for after it.
void export_dialog(UiState& state, const UiInput& input);

}  // namespace glint
