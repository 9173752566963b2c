#include "ui/features/export/save_with_command.h"

#include <fmt/core.h>

#include <filesystem>

#include "ui/document/document_actions.h"
#include "ui/features/export/export_picture.h"
#include "ui/ui.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// An unused file name in pictures_folder(): "scene.png", "scene-2.png".
std::string free_name(const UiState& state) {
    const fs::path offered = pictures_folder() / fs::path(offered_name(state, ".png")).filename();
    std::error_code failed;
    fs::path name = offered;
    for (int i = 2; fs::exists(name, failed); ++i)
        name.replace_filename(fmt::format("{}-{}.png", offered.stem().string(), i));
    return name.string();
}

}  // namespace

void save_with_command(UiState& state, const ExportOptions& options) {
    const std::string name = free_name(state);
    copy_render_command(state, options, name);
    begin_export(state, options, name);
}

void save_with_command(UiState& state) {
    const std::optional<LastExport>& last = state.get<ExportState>().last;
    const bool again = last && last->document == state.editor.document.path;
    save_with_command(state, again ? last->options : ExportOptions{state.full_size, 1});
}

}  // namespace glint
