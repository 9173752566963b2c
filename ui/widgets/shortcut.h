#pragma once
// The shortcuts of commands, for controls that do the same. The table of commands (ui/commands/command.h)
// defines these functions, so that each key is defined once.

#include <string>
#include <string_view>

namespace glint {

/// The commands that code refers to; all others are only rows in the table.
enum class CommandId {
    None,
    Open,
    Quit,
    CopyCommand,
    Undo,
    Redo,
    Duplicate,
    Delete,
    AddLight,
    SelectMainLight,
    MoveByHand,
    RotateByHand,
    ScaleByHand,
    Palette,
    ViewFront,
    ViewBack,
    ViewRight,
    ViewLeft,
    ViewTop,
    ViewBottom,
    Scope,
    NextDebugView,
    PreviousDebugView,
    OverRange,
    Magnify,
    LitDots,
    Compare,
    ShowB,
    StoreB,
    KeepView,
    NextView,
    Freeze,
    Pen,
    WipePen,
    Count  // not a command: the number of commands
};

/// Returns all keys of a command as shown: "Ctrl+Shift+Z or Ctrl+Y"; empty if it has none.
[[nodiscard]] std::string keys_of(CommandId command);

/// Returns the keys of the command that sets a value of the scene. The value is given by its JSON pointer
/// ("/shading/terms/diffuse"), for a closed set together with the choice ("/shading/mode = \"flat\""). Empty
/// if no command sets that value.
[[nodiscard]] std::string keys_of_value(std::string_view value);

}  // namespace glint
