// The one table of actions: menus, keys, the palette and the sheet of shortcuts read it.
#include <array>

#include "ui/commands/actions.h"

namespace glint {
namespace {

constexpr bool ctrl = true, shift = true, line = true;

constexpr std::array table{
    ActionInfo{Action::New, "New scene", "Ctrl+N", {Key::N, ctrl}, Menu::File},
    ActionInfo{Action::Open, "Open…", "Ctrl+O", {Key::O, ctrl}, Menu::File},
    ActionInfo{Action::Save, "Save", "Ctrl+S", {Key::S, ctrl}, Menu::File, line},
    ActionInfo{Action::SaveAs, "Save as…", "Ctrl+Shift+S", {Key::S, ctrl, shift}, Menu::File},
    ActionInfo{Action::SavePicture, "Save picture…", "F12", {Key::F12}, Menu::File, line},
    ActionInfo{Action::ExportPicture, "Export picture…", "Ctrl+E", {Key::E, ctrl}, Menu::File},
    ActionInfo{Action::CopyPicture, "Copy picture", "Ctrl+Shift+C", {Key::C, ctrl, shift}, Menu::File},
    ActionInfo{Action::CopyCommand, "Copy as command", "Ctrl+Shift+K", {Key::K, ctrl, shift}, Menu::File},
    ActionInfo{Action::Quit, "Quit", "Ctrl+Q", {Key::Q, ctrl}, Menu::File, line},

    ActionInfo{Action::Undo, "Undo", "Ctrl+Z", {Key::Z, ctrl}, Menu::Edit},
    ActionInfo{Action::Redo, "Redo", "Ctrl+Shift+Z", {Key::Z, ctrl, shift}, Menu::Edit},
    ActionInfo{Action::Redo, "Redo", "Ctrl+Y", {Key::Y, ctrl}},
    ActionInfo{Action::Duplicate, "Duplicate", "Ctrl+D", {Key::D, ctrl}, Menu::Edit, line},
    ActionInfo{Action::Delete, "Delete", "Del", {Key::Delete}, Menu::Edit},
    ActionInfo{Action::AddLight, "Add a light", "L", {Key::L}, Menu::Edit},
    ActionInfo{Action::MoveByHand, "Move the object by hand", "G", {Key::G}, Menu::Edit, line},
    ActionInfo{Action::RotateByHand, "Rotate the object by hand", "R", {Key::R}, Menu::Edit},
    ActionInfo{Action::RotateAboutPicked,
               "Rotate it about the picked point",
               "Shift+R",
               {Key::R, !ctrl, shift},
               Menu::Edit},
    ActionInfo{Action::ScaleByHand, "Scale the object by hand", "T", {Key::T}, Menu::Edit},
    ActionInfo{Action::TypeNumbers, "Type into the panel's fields", "Tab", {Key::Tab}, Menu::Edit, line},
    ActionInfo{Action::Palette, "Find an action…", "Ctrl+K", {Key::K, ctrl}, Menu::Edit},

    ActionInfo{Action::FrameSelected, "Frame the selected object, or all", "F", {Key::F}, Menu::View},
    ActionInfo{Action::FrameSelected, "Frame the selected object, or all", "pad .", {Key::PadPoint}},
    ActionInfo{Action::FrameAll, "Frame all", "Shift+F", {Key::F, !ctrl, shift}, Menu::View},
    ActionInfo{Action::SwitchProjection, "Perspective or parallel", "pad 5", {Key::Pad5}, Menu::View},
    ActionInfo{Action::SavedCamera, "Back to the saved camera", "pad 0", {Key::Pad0}, Menu::View},
    ActionInfo{Action::KeepView, "Keep this view", "Shift+U", {Key::U, !ctrl, shift}, Menu::View},
    ActionInfo{Action::NextView, "Next kept view", "U", {Key::U}, Menu::View},
    ActionInfo{Action::ViewFront, "View from the front", "pad 1", {Key::Pad1}},
    ActionInfo{Action::ViewBack, "View from behind", "Ctrl+pad 1", {Key::Pad1, ctrl}},
    ActionInfo{Action::ViewRight, "View from the right", "pad 3", {Key::Pad3}},
    ActionInfo{Action::ViewLeft, "View from the left", "Ctrl+pad 3", {Key::Pad3, ctrl}},
    ActionInfo{Action::ViewTop, "View from above", "pad 7", {Key::Pad7}},
    ActionInfo{Action::ViewBottom, "View from below", "Ctrl+pad 7", {Key::Pad7, ctrl}},
    ActionInfo{Action::Scope, "Scan-line scope", "P", {Key::P}, Menu::View, line},
    ActionInfo{Action::Vectors, "Vectors at the picked point", "V", {Key::V}, Menu::View},
    ActionInfo{Action::NextLook, "Next quantity in place of the picture", "I", {Key::I}, Menu::View},
    ActionInfo{Action::PreviousLook, "Quantity before that", "Shift+I", {Key::I, !ctrl, shift}, Menu::View},
    ActionInfo{Action::OverRange, "Stripes over what is too bright", "O", {Key::O}, Menu::View},
    ActionInfo{Action::Magnify, "Big pixels", "M", {Key::M}, Menu::View},
    ActionInfo{Action::LitDots, "Where the equation is evaluated", "J", {Key::J}, Menu::View},
    ActionInfo{Action::Needles, "Normals there as needles", "N", {Key::N}, Menu::View},
    ActionInfo{Action::Compare, "Compare under wipe lines", "C", {Key::C}, Menu::View},
    ActionInfo{Action::ShowB, "Look at B, the stored scene", "B", {Key::B}, Menu::View},
    ActionInfo{Action::StoreB, "Store the scene as B", "Ctrl+B", {Key::B, ctrl}, Menu::View},
    ActionInfo{Action::LeftColumn, "Scene column", "", {}, Menu::View, line},
    ActionInfo{Action::RightColumn, "Why column", "", {}, Menu::View},
    ActionInfo{Action::Fold, "Picture alone", "F11", {Key::F11}, Menu::View},
    ActionInfo{Action::SwitchTheme, "Light theme", "", {}, Menu::View, line},
    ActionInfo{Action::ResetLayout, "Window as on the first day", "", {}, Menu::View},

    ActionInfo{Action::NextScene, "Next scene of the folder", "PgDn", {Key::PageDown}, Menu::Lecture},
    ActionInfo{Action::PreviousScene, "Scene before it", "PgUp", {Key::PageUp}, Menu::Lecture},
    ActionInfo{
        Action::Projector, "Projector: large type, strong contrast", "F9", {Key::F9}, Menu::Lecture, line},
    ActionInfo{Action::CleanFeed, "Clean picture: no handles, no panels", "F10", {Key::F10}, Menu::Lecture},
    ActionInfo{Action::Freeze, "Freeze the picture", "F8", {Key::F8}, Menu::Lecture},
    ActionInfo{Action::Pen, "Pen", "W", {Key::W}, Menu::Lecture, line},
    ActionInfo{Action::WipePen, "Wipe what the pen drew", "Shift+W", {Key::W, !ctrl, shift}, Menu::Lecture},
    ActionInfo{Action::Animate,
               "Animate: turntable, numbers to and fro…",
               "Ctrl+T",
               {Key::T, ctrl},
               Menu::Lecture,
               line},
    ActionInfo{Action::StepWedge, "Step wedge: what does this projector show?", "", {}, Menu::Lecture, line},

    ActionInfo{Action::Shortcuts, "Keys and mouse", "F1", {Key::F1}, Menu::Help},
    ActionInfo{Action::Shortcuts, "Keys and mouse", "?", {Key::Question, !ctrl, shift}},

    ActionInfo{Action::Flat, "Flat shading", "1", {Key::Digit1}},
    ActionInfo{Action::Facet, "Facet shading", "2", {Key::Digit2}},
    ActionInfo{Action::Gouraud, "Gouraud shading", "3", {Key::Digit3}},
    ActionInfo{Action::Phong, "Phong shading", "4", {Key::Digit4}},
    ActionInfo{Action::Emission, "Emission on or off", "E", {Key::E}},
    ActionInfo{Action::Ambient, "Ambient on or off", "A", {Key::A}},
    ActionInfo{Action::Diffuse, "Diffuse on or off", "D", {Key::D}},
    ActionInfo{Action::Specular, "Specular on or off", "S", {Key::S}},
};

}  // namespace

std::span<const ActionInfo> actions() { return table; }

const ActionInfo& info_of(Action action) {
    for (const ActionInfo& info : table)
        if (info.action == action) return info;
    return table[0];  // not reached: every action is in the table
}

std::string keys_of(Action action) {
    std::string keys;
    for (const ActionInfo& info : table)
        if (info.action == action && *info.keys != 0)
            keys.append(keys.empty() ? "" : " or ").append(info.keys);
    return keys;
}

}  // namespace glint
