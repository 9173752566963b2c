#include "ui/document/recently_changed.h"

#include <algorithm>

#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"

namespace glint {
namespace {

constexpr std::size_t most = 12;

}  // namespace

bool drops_changes(const UiState& state) {
    const std::string& path = state.editor.document.path;
    return !path.empty() && is_among_shipped(state, path);
}

void keep_changes(UiState& state, const std::string& title) {
    std::vector<ChangedScene>& list = state.get<RecentlyChanged>().list;
    std::erase_if(list, [&](const ChangedScene& other) { return other.title == title; });
    ChangedScene changed{title, document_as_made(state), {}};
    changed.changed = std::exchange(changed.document.scene, state.editor.saved);
    list.insert(list.begin(), std::move(changed));
    if (list.size() > most) list.pop_back();
}

void reopen_changed(UiState& state, const ChangedScene& changed) {
    ask_first(state, [changed](UiState& s) {
        cancel_loads(s);
        take_scene(s, changed.document);
        s.editor.scene() = changed.changed;
        s.editor.edits_camera = true;
        std::erase_if(s.get<RecentlyChanged>().list,
                      [&](const ChangedScene& other) { return other.title == changed.title; });
    });
}

extern const Feature recently_changed_feature;
const Feature recently_changed_feature{
    .palette =
        [](std::vector<PaletteEntry>& entries, UiState& state) {
            for (const ChangedScene& changed : state.get<RecentlyChanged>().list)
                entries.push_back({"Changed: " + changed.title, "Recently changed", "", "",
                                   [changed](UiState& s) { reopen_changed(s, changed); }});
        },
    .leave_document =
        [](UiState& state, const SceneDocument&) {
            if (state.editor.unsaved() && drops_changes(state)) keep_changes(state, state.editor.title());
        }};

}  // namespace glint
