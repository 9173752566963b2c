#pragma once
// Everything that a menu item or a key does, once: menus, keys and the sheet of shortcuts read one table.

#include <optional>
#include <span>
#include <string>

#include "ui/ui.h"

namespace glint {

enum class Action {
    New,
    Open,
    Save,
    SaveAs,
    SavePicture,
    ExportPicture,
    CopyPicture,
    CopyCommand,
    Quit,
    Undo,
    Redo,
    Duplicate,
    Delete,
    AddLight,
    MoveByHand,
    RotateByHand,
    RotateAboutPicked,
    ScaleByHand,
    FrameAll,
    FrameSelected,
    ViewFront,
    ViewBack,
    ViewRight,
    ViewLeft,
    ViewTop,
    ViewBottom,
    SwitchProjection,
    SavedCamera,
    KeepView,
    NextView,
    Fold,
    Vectors,
    LeftColumn,
    RightColumn,
    SwitchTheme,
    ResetLayout,
    Projector,
    CleanFeed,
    Freeze,
    Pen,
    WipePen,
    NextScene,
    PreviousScene,
    StepWedge,
    Animate,
    TypeNumbers,
    Shortcuts,
    Palette,
    Scope,
    Compare,
    Magnify,
    LitDots,
    Needles,
    NextLook,
    PreviousLook,
    OverRange,
    ShowB,
    StoreB,
    Flat,
    Facet,
    Gouraud,
    Phong,
    Emission,
    Ambient,
    Diffuse,
    Specular
};

/// The menu in which an action stands, in the table's order. None: it has a key, and is found by the palette.
enum class Menu { None, File, Edit, View, Lecture, Help };

struct ActionInfo {
    Action action;
    const char* name;
    const char* keys = "";       // as shown; empty when there is none
    KeyPress press = {};         // Key::Other when there is none
    Menu menu = Menu::None;      // of an action with several keys the first row counts
    bool after_line = false;     // a line stands above it in the menu
    const char* menu_name = "";  // there, where it is called otherwise than in lists
};
[[nodiscard]] std::span<const ActionInfo> actions();
/// The action's first row.
[[nodiscard]] const ActionInfo& info_of(Action action);
/// All its keys: "Ctrl+Shift+Z or Ctrl+Y".
[[nodiscard]] std::string keys_of(Action action);

/// Why it cannot be done now; empty when it can.
[[nodiscard]] std::string why_not(const UiState& state, Action action);
[[nodiscard]] inline bool can_run(const UiState& state, Action action) {
    return why_not(state, action).empty();
}
/// Whether what the action switches is on; nothing when it is no switch.
[[nodiscard]] std::optional<bool> is_on(const UiState& state, Action action);
/// Does it, if can_run().
void run_action(UiState& state, Action action);
void run_keys(UiState& state, const UiInput& input);

/// Opens a file or begins anew, asking first when changes are not saved.
void begin_pending(UiState& state, Pending pending);
/// Goes on with what waited, after the answer or after saving.
void finish_pending(UiState& state);
/// Puts another document in hand. All that was about the scene before goes: gesture, probe, explanation, what
/// was about to be done to one of its lights or objects.
void take_scene(UiState& state, SceneDocument document);
/// A name to offer for a file: the document's own, with the ending that fits.
[[nodiscard]] std::string offered_name(const UiState& state, const char* ending);
/// Saves; asks for a name when there is none yet, and first when another program has changed the file. True
/// when it is saved now.
bool save(UiState& state);
/// Saves whatever is in the file. True when it is saved now.
bool save_over(UiState& state);
/// Opens the document's file again, giving up what is not saved.
void reload(UiState& state);

}  // namespace glint
