#pragma once
// The keys of a command, for whatever draws a control that does the same. The table of commands
// (ui/commands/command.h) defines these functions, so that no key is written down twice.

#include <string>
#include <string_view>

namespace glint {

/// The commands that code names; all others are rows of the table and nothing more.
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
    Count  // no command: how many there are
};

/// All keys of a command, as shown: "Ctrl+Shift+Z or Ctrl+Y"; empty when it has none.
[[nodiscard]] std::string keys_of(CommandId command);

/// The keys of the command that sets a value of the scene, by the value's JSON pointer
/// ("/shading/terms/diffuse"), or one of a closed set ("/shading/mode = \"flat\""). Empty when there is none.
[[nodiscard]] std::string keys_of_value(std::string_view value);

}  // namespace glint
