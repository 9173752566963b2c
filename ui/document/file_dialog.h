#pragma once
// A small file browser: the user types a path or clicks through folders.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct UiState;

/// The purpose for which a file is chosen.
struct FilePurpose {
    const char *title, *button, *hint;
    const char* nothing = "No folders or files of this kind here yet";  // text in place of an empty list
    std::vector<std::string> extensions = {};  // in addition to meshes; a new file's name gets the first one
    bool takes_meshes = false;
    bool saves = false;          // the file is written
    bool is_about_scene = true;  // about the open scene: the dialog closes when the scene is replaced
    // If several files are written for one path: whether writing them would replace an existing file.
    bool (*writes_many)(const std::string& path) = nullptr;
    bool (*may_replace_many)(const std::string& path) = nullptr;
    void (*use)(UiState& state, const std::string& path) = nullptr;
};

/// An entry in a folder. Folders are listed first, then files, each by name, ignoring case; hidden entries
/// are left out.
struct FolderEntry {
    std::string name;
    bool folder = false;
};
/// Returns the entries of `folder` with the purpose's extensions. Empty if the folder cannot be read.
[[nodiscard]] std::vector<FolderEntry> list_folder(const std::string& folder, const FilePurpose& purpose);

/// Compares numbers in names by value and ignores case: "Step 2" < "step 10" < "step 10b".
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// Whether writing to `path` may replace a file.
[[nodiscard]] bool may_replace(const std::string& path, const FilePurpose& purpose);

struct FileDialog {
    bool open = false;
    const FilePurpose* purpose = nullptr;  // null while the dialog is closed
    std::string folder, name;
    std::vector<FolderEntry> entries;
    bool asks_overwrite = false;
    bool offers_name = false;    // the name field gets focus next, with all of its text selected
    bool asks_keyboard = false;  // focus the name field in the next frame
    std::string warning;         // shown below the name field, in place of the hint; ask() clears it

    /// Opens the dialog in the folder of `path` (the working directory if `path` is empty) with its name
    /// filled in.
    void ask(const FilePurpose& asked_for, const std::string& path);
};

/// Draws the dialog. Precondition: it is open. Returns the path once, when the user confirms. `enter`: the
/// Enter key was pressed.
[[nodiscard]] std::optional<std::string> draw_file_dialog(FileDialog& dialog, bool enter);

}  // namespace glint
