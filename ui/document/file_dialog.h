#pragma once
// A small file browser of our own: one types a path or clicks through folders.

#include <optional>
#include <string>
#include <vector>

namespace glint {

enum class FilePurpose {
    OpenScene,
    OpenMesh,
    MyPicture,
    SaveScene,
    SavePicture,
    ExportPicture,
    SaveFrames,
    SaveAnswers
};

/// An entry of a folder; folders first, then by name without regard to case. Hidden ones are left out.
struct FolderEntry {
    std::string name;
    bool folder = false;
};
/// Whether the answer is about the scene in hand: the dialog closes when another takes its place.
[[nodiscard]] bool is_about_scene(FilePurpose purpose);

/// Entries of `folder` that serve the purpose (its extensions). Nothing when it cannot be read.
[[nodiscard]] std::vector<FolderEntry> list_folder(const std::string& folder, FilePurpose purpose);

/// Where frame `frame`, from 0, of an animation goes: beside NAME.png as NAME-0001.png, NAME-0002.png, ...
[[nodiscard]] std::string frame_path(const std::string& path, int frame);
/// Whether writing to `path` may replace a file: of frames as PNGs any of that name, whatever its number.
[[nodiscard]] bool may_replace(const std::string& path, FilePurpose purpose);

struct FileDialog {
    bool open = false;
    FilePurpose purpose = FilePurpose::OpenScene;
    std::string folder, name;
    std::vector<FolderEntry> entries;
    bool asks_overwrite = false;
    bool offers_name = false;    // until the name is in hand: all of it is selected then, and typed over
    bool asks_keyboard = false;  // for the name, when the next frame is drawn
    std::string warning;         // below the name, in place of the hint; ask() clears it

    /// Opens the dialog in the folder of `path` (the working directory's, when empty) with its name filled
    /// in.
    void ask(FilePurpose asked_for, const std::string& path);
};

/// Draws the dialog. Precondition: it is open. Returns the path once, when the user decides. `enter`: the
/// Enter key was pressed.
[[nodiscard]] std::optional<std::string> draw_file_dialog(FileDialog& dialog, bool enter);

}  // namespace glint
