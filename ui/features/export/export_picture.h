#pragma once
// Exports pictures to a file, with a chosen size and number of samples, or to the clipboard.

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

/// The last export. "Copy as command" repeats it while the same document is open.
struct LastExport {
    ExportOptions options;
    std::string file;      // file name
    std::string document;  // the document's path
};

struct ExportState {
    bool open = false;
    ExportOptions options{.size = {0, 0}};  // the size is 0 x 0 until one is chosen: see export_options()
    std::optional<LastExport> last;
    JobPtr<Notification> job;  // result: the notification when it is done
};

/// Returns the scene whose picture of that size matches the window: the widened field of view for a narrow
/// picture (fitted()) is made explicit.
[[nodiscard]] Scene as_shown(Scene scene, PictureSize size);

/// The bytes of a picture file: PNG with its scene embedded, PFM or EXR, by the extension of `path`; mesh
/// paths in the embedded scene are relative to `path`. Draws with its own renderer.
[[nodiscard]] Result<std::string> picture_file(const SceneDocument& document, const ExportOptions& options,
                                               const std::string& path, int threads);

/// The text of a command about a document, whose file contains the scene `in_file`.
using CommandText = std::function<std::string(const SceneDocument& document, const Scene& in_file)>;
/// Returns `text` for the open document with the scene in the picture. A new scene may have started as the
/// default scene, which has a file: the text based on that file is used if it is shorter.
[[nodiscard]] std::string shortest_command(const UiState& state, const CommandText& text);

/// The options for the next export. The default size is the view's, so the picture is framed the same way.
[[nodiscard]] ExportOptions export_options(const UiState& state);

extern const FilePurpose save_picture_purpose, export_purpose;
/// Opens the dialog for a picture file, with a warning about what the file will show or lack.
void ask_for_picture(UiState& state, const FilePurpose& purpose);
/// Draws and writes the picture in the background; a notification then reports the file, its folder, and what
/// the picture shows or lacks.
void begin_export(UiState& state, const ExportOptions& options, const std::string& path);
/// Copies the shown picture to the clipboard, in the background.
void begin_copy(UiState& state);
/// Copies the command line that draws the shown scene with these options into the file `out`.
void copy_render_command(UiState& state, const ExportOptions& options, const std::string& out);
/// Copies the command line with the options of the scene's last export, or for the shown picture if there was
/// none. Precondition: the picture is drawn.
void copy_last_command(UiState& state);
/// Once a frame: if the job is done, reports its result as a notification and clears it.
void poll_job(JobPtr<Notification>& job, Notifications& notifications);

// A picture and the command line that draws it, in one step.

/// Draws the picture into a new file in pictures_folder() and copies the command for it to the clipboard.
void save_with_command(UiState& state, const ExportOptions& options);
/// The same with the options of the scene's last export, or for the shown picture if there was none.
/// Precondition: the picture is drawn.
void save_with_command(UiState& state);

}  // namespace glint
