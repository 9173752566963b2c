#include "ui/document/file_dialog.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/formats/mesh_file.h"
#include "renderer/image/animation_file.h"
#include "ui/features/lecture/lecture.h"
#include "ui/shell/modal.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/text/text_field.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// The extensions of the files that serve a purpose, beside meshes; a new file's name gets the first one.
std::vector<std::string> extensions(FilePurpose purpose) {
    switch (purpose) {
    case FilePurpose::OpenScene:
        return {".json", ".png", ".md"};
    case FilePurpose::OpenMesh:
        return {};
    case FilePurpose::SaveScene:
    case FilePurpose::SaveAnswers:
        return {".json"};
    case FilePurpose::SavePicture:
        return {".png"};
    case FilePurpose::MyPicture:
    case FilePurpose::ExportPicture:
        return {".png", ".pfm", ".exr"};
    case FilePurpose::SaveFrames:
        return {".gif", ".webp", ".png"};
    }
    return {};  // not reached
}

bool saves(FilePurpose purpose) {
    return purpose != FilePurpose::OpenScene && purpose != FilePurpose::OpenMesh &&
           purpose != FilePurpose::MyPicture;
}

bool serves(const std::string& name, FilePurpose purpose) {
    const std::vector<std::string> known = extensions(purpose);
    return std::find(known.begin(), known.end(), lower_extension(name)) != known.end() ||
           (!saves(purpose) && purpose != FilePurpose::MyPicture &&
            (is_mesh_path(name) || is_gltf_path(name)));
}

/// Whether each frame of an animation gets a file of its own.
bool writes_many(const std::string& path, FilePurpose purpose) {
    return purpose == FilePurpose::SaveFrames && !animation_format(path);
}

struct Words {
    const char *title, *button, *hint;
};
Words words(FilePurpose purpose) {
    switch (purpose) {
    case FilePurpose::OpenScene:
        return {"Open", "Open",
                "Scenes (.json .glb .gltf), pictures of Glint (.png), meshes (.obj .ply .off .stl), "
                "lessons (.md)"};
    case FilePurpose::OpenMesh:
        return {"Choose a mesh", "Choose", "Meshes (.obj .ply .off .stl .glb .gltf)"};
    case FilePurpose::MyPicture:
        return {"Compare my picture", "Compare", "A picture of this scene by any program (.png .pfm .exr)"};
    case FilePurpose::SaveScene:
        return {"Save the scene", "Save", "Scene file (.json)"};
    case FilePurpose::SaveAnswers:
        return {"Save my answers", "Save", "Answers (.json), which `glint quiz` counts"};
    case FilePurpose::SavePicture:
        return {"Save the picture", "Save", "Picture (.png), which carries its scene"};
    case FilePurpose::SaveFrames:
        return {"Write frames", "Write", "One file (.gif .webp), or one a frame: NAME-0001.png …"};
    case FilePurpose::ExportPicture:
        return {"Export the picture", "Export",
                "Picture: .png (carries its scene), .pfm, .exr (linear float)"};
    }
    return {"", "", ""};  // not reached
}

void go_to(FileDialog& dialog, const fs::path& folder) {
    std::error_code failed;
    const fs::path whole = fs::absolute(folder, failed).lexically_normal();
    dialog.folder = failed ? folder.string() : whole.string();
    dialog.entries = list_folder(dialog.folder, dialog.purpose);
    dialog.asks_overwrite = false;
}

/// "~/name" is in the home directory.
std::string from_home(const std::string& name) {
    const char* home = name == "~" || name.starts_with("~/") ? std::getenv("HOME") : nullptr;
    return home != nullptr ? home + name.substr(1) : name;
}

/// Where folder and name lead; an absolute name stands alone.
fs::path place_of(const FileDialog& dialog) { return fs::path(dialog.folder) / from_home(dialog.name); }

/// The path of the file, with the ending that it needs.
std::string whole_path(const FileDialog& dialog) {
    const std::string path = place_of(dialog).string();
    const bool is_named = !saves(dialog.purpose) || serves(path, dialog.purpose);
    return is_named ? path : path + extensions(dialog.purpose).front();
}

/// Opens a folder, asks before overwriting, or gives the chosen path.
std::optional<std::string> decide(FileDialog& dialog) {
    if (dialog.name.empty()) return {};
    std::error_code failed;
    if (const fs::path folder = place_of(dialog); fs::is_directory(folder, failed)) {
        dialog.name.clear();
        dialog.offers_name = dialog.asks_keyboard = true;  // the name in that folder is typed next
        go_to(dialog, folder);
        return {};
    }
    const std::string path = whole_path(dialog);
    if (saves(dialog.purpose) && !dialog.asks_overwrite && may_replace(path, dialog.purpose)) {
        dialog.asks_overwrite = true;
        return {};
    }
    dialog.open = false;
    return path;
}

void folder_line(FileDialog& dialog) {
    if (icon_button("##up", Icon::Up)) go_to(dialog, fs::path(dialog.folder).parent_path());
    tooltip("Up", "To the folder that holds this one");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (text_field("##folder", "", dialog.folder, ImGuiInputTextFlags_EnterReturnsTrue))
        go_to(dialog, from_home(dialog.folder));
}

/// Returns the words that stand in place of an empty list.
const char* nothing_words(const FileDialog& dialog) {
    std::error_code failed;
    if (!fs::is_directory(dialog.folder, failed)) return "There is no such folder";
    switch (dialog.purpose) {
    case FilePurpose::OpenScene:
        return "No folder and no scene here";
    case FilePurpose::OpenMesh:
        return "No folder and no mesh file here";
    case FilePurpose::MyPicture:
        return "No folder and no picture here";
    case FilePurpose::SaveScene:
    case FilePurpose::SavePicture:
    case FilePurpose::ExportPicture:
    case FilePurpose::SaveFrames:
    case FilePurpose::SaveAnswers:
        return "No folder and no file of this kind here yet";
    }
    return "";  // not reached
}

/// What a click or two on an entry asked for.
struct Clicked {
    std::string enter_folder;
    bool decided = false;
};

void entry_row(FileDialog& dialog, const FolderEntry& entry, Clicked& clicked) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    const std::string label = whole_label("      " + entry.name);
    if (ImGui::Selectable(label.c_str(), entry.name == dialog.name, ImGuiSelectableFlags_AllowDoubleClick)) {
        const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        if (entry.folder && twice) clicked.enter_folder = entry.name;
        if (!entry.folder || !saves(dialog.purpose)) dialog.name = entry.name;
        dialog.asks_overwrite = false;
        clicked.decided |= twice && !entry.folder;
    }
    draw_icon(*ImGui::GetWindowDrawList(), entry.folder ? Icon::Folder : Icon::File,
              {low.x + 0.6f * line, low.y + line / 2}, 0.8f * line, to_u32(theme().dim_text));
}

/// Draws the list of entries. True when a file was double-clicked.
bool entry_list(FileDialog& dialog) {
    Clicked clicked;
    const float below =
        ImGui::GetFrameHeight() + ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("##entries", {0, -below}, true);
    ImGuiListClipper in_sight;  // a folder may hold tens of thousands
    in_sight.Begin(static_cast<int>(dialog.entries.size()));
    while (in_sight.Step())
        for (int i = in_sight.DisplayStart; i < in_sight.DisplayEnd; ++i)
            entry_row(dialog, dialog.entries[static_cast<std::size_t>(i)], clicked);
    if (dialog.entries.empty()) dim_text(nothing_words(dialog));
    ImGui::EndChild();
    if (!clicked.enter_folder.empty()) {
        dialog.name.clear();
        go_to(dialog, fs::path(dialog.folder) / clicked.enter_folder);
    }
    return clicked.decided;
}

}  // namespace

bool is_about_scene(FilePurpose purpose) {
    return purpose != FilePurpose::OpenScene && purpose != FilePurpose::SaveAnswers;
}

std::vector<FolderEntry> list_folder(const std::string& folder, FilePurpose purpose) {
    std::vector<FolderEntry> entries;
    std::error_code failed;
    fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && it != fs::directory_iterator(); it.increment(failed)) {
        std::error_code unknown;
        const bool is_folder = it->is_directory(unknown);
        const std::string name = it->path().filename().string();
        if (name.starts_with(".") || (!is_folder && !serves(name, purpose))) continue;
        entries.push_back({name, is_folder});
    }
    std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : natural_less(a.name, b.name);
    });
    return entries;
}

std::string frame_path(const std::string& path, int frame) {
    const fs::path file(path);
    return (file.parent_path() / fmt::format("{}-{:04}.png", file.stem().string(), frame + 1)).string();
}

bool may_replace(const std::string& path, FilePurpose purpose) {
    std::error_code failed;
    if (!writes_many(path, purpose)) return fs::exists(path, failed);
    const fs::path file(path), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && it != fs::directory_iterator(); it.increment(failed)) {
        const std::string name = it->path().filename().string(), before = file.stem().string() + "-";
        if (!name.starts_with(before)) continue;
        int number = 0;
        std::from_chars(name.data() + before.size(), name.data() + name.size(), number);
        if (number > 0 && name == fs::path(frame_path(path, number - 1)).filename()) return true;
    }
    return false;
}

void FileDialog::ask(FilePurpose asked_for, const std::string& path) {
    purpose = asked_for;
    open = offers_name = true;
    warning.clear();
    const fs::path given(path);
    name = saves(asked_for) ? given.filename().string() : "";
    go_to(*this, given.has_parent_path() ? given.parent_path() : fs::path("."));
}

std::optional<std::string> draw_file_dialog(FileDialog& dialog, bool enter) {
    const Words say = words(dialog.purpose);
    const std::string id = std::string(say.title) + "##files";
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(px(620), window.x - px(40)), std::min(px(460), window.y - px(40))},
                             ImGuiCond_Appearing);
    std::optional<std::string> chosen;
    if (!begin_modal(id.c_str(), &dialog.open, 0)) return {};
    folder_line(dialog);
    bool decided = entry_list(dialog);
    if (std::exchange(dialog.asks_keyboard, false) || ImGui::IsWindowAppearing())
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-px(180));
    // ImGui would go on with the selection that the field had when it was left last.
    const int selects = dialog.offers_name ? ImGuiInputTextFlags_AutoSelectAll : 0;
    if (text_field("##name", "name or path", dialog.name, selects)) dialog.asks_overwrite = false;
    if (ImGui::IsItemActive()) dialog.offers_name = false;
    ImGui::SameLine();
    decided |=
        ImGui::Button(dialog.asks_overwrite ? "Replace" : say.button, {px(84), 0}) || enter_answers(enter);
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(84), 0})) dialog.open = false;
    const bool many = writes_many(whole_path(dialog), dialog.purpose);
    const char* const question =
        many ? "Frames of that name are there already. Replace them?" : "It is there already. Replace it?";
    if (dialog.asks_overwrite || dialog.warning.empty())
        dim_text(dialog.asks_overwrite ? question : say.hint);
    else
        coloured(theme().warning, dialog.warning);
    if (decided) chosen = decide(dialog);
    if (!dialog.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace glint
