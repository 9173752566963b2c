#include "ui/document/file_dialog.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "models/gltf/gltf.h"
#include "models/io/file.h"
#include "models/mesh/formats/mesh_file.h"
#include "ui/shell/modal.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

bool serves(const std::string& name, const FilePurpose& purpose) {
    const std::vector<std::string>& known = purpose.extensions;
    return std::find(known.begin(), known.end(), lower_extension(name)) != known.end() ||
           (purpose.takes_meshes && (is_mesh_path(name) || is_gltf_path(name)));
}

bool writes_many(const std::string& path, const FilePurpose& purpose) {
    return purpose.writes_many != nullptr && purpose.writes_many(path);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Removes the digits at the front of `text` and returns them without leading zeros.
std::string_view take_number(std::string_view& text) {
    std::size_t length = 0;
    while (length < text.size() && is_digit(text[length])) ++length;
    std::string_view digits = text.substr(0, length);
    text.remove_prefix(length);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
    return digits;
}

/// Returns a negative number, 0 or a positive number if `a` sorts before, equal to or after `b`.
int natural_order(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        if (is_digit(a[0]) && is_digit(b[0])) {
            const std::string_view m = take_number(a), n = take_number(b);
            if (m.size() != n.size()) return m.size() < n.size() ? -1 : 1;
            if (const int order = m.compare(n); order != 0) return order;
            continue;
        }
        if (lower(a[0]) != lower(b[0])) return lower(a[0]) < lower(b[0]) ? -1 : 1;
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    return a.empty() ? (b.empty() ? 0 : -1) : 1;
}

void go_to(FileDialog& dialog, const fs::path& folder) {
    std::error_code failed;
    const fs::path whole = fs::absolute(folder, failed).lexically_normal();
    dialog.folder = failed ? folder.string() : whole.string();
    dialog.entries = list_folder(dialog.folder, *dialog.purpose);
    dialog.asks_overwrite = false;
}

/// Expands "~/name" to a path in the home directory.
std::string from_home(const std::string& name) {
    const char* home = name == "~" || name.starts_with("~/") ? std::getenv("HOME") : nullptr;
    return home != nullptr ? home + name.substr(1) : name;
}

/// Joins folder and name; with an absolute name the folder is ignored.
fs::path place_of(const FileDialog& dialog) { return fs::path(dialog.folder) / from_home(dialog.name); }

/// Returns the path of the file, with the required extension.
std::string whole_path(const FileDialog& dialog) {
    const std::string path = place_of(dialog).string();
    const bool is_named = !dialog.purpose->saves || serves(path, *dialog.purpose);
    return is_named ? path : path + dialog.purpose->extensions.front();
}

/// Opens a folder, asks before overwriting, or returns the chosen path.
std::optional<std::string> decide(FileDialog& dialog) {
    if (dialog.name.empty()) return {};
    std::error_code failed;
    if (const fs::path folder = place_of(dialog); fs::is_directory(folder, failed)) {
        dialog.name.clear();
        dialog.offers_name = dialog.asks_keyboard = true;  // the user types a name in that folder next
        go_to(dialog, folder);
        return {};
    }
    const std::string path = whole_path(dialog);
    if (dialog.purpose->saves && !dialog.asks_overwrite && may_replace(path, *dialog.purpose)) {
        dialog.asks_overwrite = true;
        return {};
    }
    dialog.open = false;
    return path;
}

void folder_line(FileDialog& dialog) {
    if (icon_button("##up", Icon::Up)) go_to(dialog, fs::path(dialog.folder).parent_path());
    tooltip("Up", "To the parent folder");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (text_field("##folder", "", dialog.folder, ImGuiInputTextFlags_EnterReturnsTrue))
        go_to(dialog, from_home(dialog.folder));
}

/// Returns the message shown in place of an empty list.
const char* nothing_words(const FileDialog& dialog) {
    std::error_code failed;
    return fs::is_directory(dialog.folder, failed) ? dialog.purpose->nothing : "This folder does not exist";
}

/// The result of a click or double-click on an entry.
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
        if (!entry.folder || !dialog.purpose->saves) dialog.name = entry.name;
        dialog.asks_overwrite = false;
        clicked.decided |= twice && !entry.folder;
    }
    draw_icon(*ImGui::GetWindowDrawList(), entry.folder ? Icon::Folder : Icon::File,
              {low.x + 0.6f * line, low.y + line / 2}, 0.8f * line, to_u32(theme().dim_text));
}

/// Returns the button's label, "Save in ~/Pictures". If the path does not fit into `width`, only its end is
/// shown.
std::string button_label(const FileDialog& dialog, float width) {
    const FilePurpose& purpose = *dialog.purpose;
    const char* const verb = dialog.asks_overwrite ? "Replace" : purpose.button;
    if (!purpose.saves) return verb;
    std::string folder = place_of(dialog).parent_path().string();
    const std::string home = from_home("~");
    if ((folder + "/").starts_with(home + "/")) folder.replace(0, home.size(), "~");
    for (std::size_t cut = 0; cut != std::string::npos; cut = folder.find('/', cut + 1)) {
        const char* const before = cut > 0 ? "…" : "";
        const std::string label = whole_label(fmt::format("{} in {}{}", verb, before, folder.substr(cut)));
        if (ImGui::CalcTextSize(label.c_str()).x <= width) return label + "###decide";
    }
    return fmt::format("{}###decide", verb);
}

/// Draws the list of entries. True when a file was double-clicked.
bool entry_list(FileDialog& dialog) {
    Clicked clicked;
    const float below =
        2 * ImGui::GetFrameHeight() + ImGui::GetTextLineHeight() + 3 * ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("##entries", {0, -below}, true);
    ImGuiListClipper in_sight;  // a folder may contain tens of thousands of entries
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

std::vector<FolderEntry> list_folder(const std::string& folder, const FilePurpose& purpose) {
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

bool natural_less(std::string_view a, std::string_view b) {
    const int order = natural_order(a, b);
    return order != 0 ? order < 0 : a < b;  // "a1" and "a01" still need a fixed order
}

bool may_replace(const std::string& path, const FilePurpose& purpose) {
    std::error_code failed;
    return writes_many(path, purpose) ? purpose.may_replace_many(path) : fs::exists(path, failed);
}

void FileDialog::ask(const FilePurpose& asked_for, const std::string& path) {
    purpose = &asked_for;
    open = offers_name = true;
    warning.clear();
    const fs::path given(path);
    name = asked_for.saves ? given.filename().string() : "";
    go_to(*this, given.has_parent_path() ? given.parent_path() : fs::path("."));
}

std::optional<std::string> draw_file_dialog(FileDialog& dialog, bool enter) {
    const FilePurpose& say = *dialog.purpose;
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
    ImGui::SetNextItemWidth(-1);
    // Otherwise ImGui would restore the field's previous selection.
    const int selects = dialog.offers_name ? ImGuiInputTextFlags_AutoSelectAll : 0;
    if (text_field("##name", "name or path", dialog.name, selects)) dialog.asks_overwrite = false;
    if (ImGui::IsItemActive()) dialog.offers_name = false;
    const float width = ImGui::GetContentRegionAvail().x - px(84) - ImGui::GetStyle().ItemSpacing.x;
    const std::string label = button_label(dialog, width - px(14));
    decided |= ImGui::Button(label.c_str(), {width, 0}) || enter_answers(enter);
    list_control(say.button, label, last_item());
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {px(84), 0})) dialog.open = false;
    const bool many = writes_many(whole_path(dialog), say);
    const char* const question =
        many ? "Frames with that name already exist. Replace them?" : "The file already exists. Replace it?";
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
