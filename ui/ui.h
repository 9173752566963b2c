#pragma once
// One frame of the window's contents: input in, scene edited, picture drawn, requests out. Draws only with
// ImGui, without GLFW or OpenGL, so that tests can run it without a window.

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "renderer/renderer.h"
#include "ui/commands/command.h"
#include "ui/commands/keys.h"
#include "ui/document/editor.h"
#include "ui/document/file_dialog.h"
#include "ui/document/loading.h"
#include "ui/feature.h"
#include "ui/picture/draw_picture.h"
#include "ui/picture/screen.h"
#include "ui/picture/tool.h"
#include "ui/picture/viewport.h"
#include "ui/preferences/persistence.h"
#include "ui/shell/layout.h"
#include "ui/shell/notifications.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/picture_sheet.h"

namespace glint {

struct UiState;

/// The action that waits for an answer to "save changes?".
struct Pending {
    std::function<void(UiState&)> then;  // null: nothing waits
    bool asking = false;                 // the question is on the screen; else the changes are being saved
};

/// The position of the picture in the window: it fills `picture`, clipped to `room`.
struct PlacedPicture {
    Rect picture, room;
    bool operator==(const PlacedPicture&) const = default;
};

/// The window's state from frame to frame, in addition to ImGui's own context and what widgets store in it
/// (widget_state() in ui/widgets/kept.h).
struct UiState {
    explicit UiState(int thread_count)
        : threads(thread_count), renderer(std::make_unique<Renderer>(thread_count)) {}

    /// Returns the state of a feature, which is defined in the feature's own header.
    template <class T> [[nodiscard]] T& get() { return features.get<T>(); }
    template <class T> [[nodiscard]] const T& get() const { return features.get<T>(); }

    Editor editor;
    ViewportState viewport;
    ToolCapture capture;  // the tool in the picture that is being dragged
    LayoutState layout;
    Notifications notifications;
    FileDialog files;
    PaletteState palette;
    Loading loading;
    Persistence persistence;
    Pending pending;
    double letters_from =
        0;  // ImGui time; letters typed before it were meant for a dialog that has just closed
    std::string shipped_scenes;  // folder of the scenes that come with the program; empty: none
    int mesh_for_object = -1;    // the object for which the file dialog chooses a mesh; -1: a new object
    bool dark = true, shows_shortcuts = false;
    bool left_shows_inspector = false, left_shows_scene = false;  // only if the left column has tabs
    bool types_into_panel = false;  // requested: focus the selected item's first field
    bool quits = false;
    bool close_asked = false;          // requested by the system, and not yet answered
    std::vector<std::string> dropped;  // paths of files that are not yet opened
    bool asks_overwrite = false;       // saving would overwrite another program's changes to the file

    FramePace pace;
    std::vector<Camera> kept_views;  // saved views, of any scene; remembered with the settings
    States features;

    int threads;               // threads of each renderer
    float parts_progress = 1;  // progress of a comparison's parts, like Refinement::progress()
    std::unique_ptr<Renderer> renderer;
    Refinement refinement;              // refinement of the renderer's pictures
    const Picture* rendered = nullptr;  // the last one drawn
    PictureSize full_size;  // size of the picture in the window; `rendered` may be temporarily smaller
    PictureSize failed_size{
        0, 0};  // drawing a picture of this size has failed: the last picture keeps its own size
    const Picture* displayed = nullptr;  // the picture in the window: `rendered`, or one composed by features
    const Picture* unpainted = nullptr;  // `displayed` without stripes and false colours
    std::uint64_t picture_serial = 0;    // incremented with each shown picture, to update the texture
    std::vector<ShownPart> parts;        // the parts of `displayed`
    double parts_ms = 0;                 // time for the parts, in addition to `rendered`
    PlacedPicture picture_rect;          // the picture's position in the window
    float legend_width = 0, label_height = 0;  // size of a feature's overlays at the left and upper edges
    Scene rendered_scene;                      // the scene in `rendered`
    bool rendered_is_edited =
        false;                  // whether `rendered` shows the edited scene: no preview, no awaited mesh
    ImGuiID active_before = 0;  // the active control of the previous frame; 0: none
    Scene
        edited_drawn;  // the last drawn state of the edited scene, even if another scene has been shown since
    OnScreen on_screen;

    Jobs jobs;  // last, because they use the members above
};

struct UiRequests {
    bool quit = false;
    std::string title;                                         // title of the window; empty: unchanged
    double sleep_s = std::numeric_limits<double>::infinity();  // until the next frame, unless an event occurs
};

/// Call this between ImGui::NewFrame() and ImGui::Render(). The caller fills the window with theme().panel,
/// then draws UiState::displayed at UiState::picture_rect, and ImGui's data over both.
[[nodiscard]] UiRequests ui_frame(UiState& state, const UiInput& input);

/// Returns the sheets of thumbnails that the window keeps as textures; their addresses are stable.
[[nodiscard]] std::vector<PictureSheet*> sheets_of(UiState& state);

}  // namespace glint
