#pragma once
// A headless window: ImGui without a backend, driven by mouse and keys, frame by frame.

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/catch.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/features/diagnosis/my_picture.h"
#include "ui/features/export/animation.h"
#include "ui/features/export/export_picture.h"
#include "ui/features/games/match.h"
#include "ui/features/games/quiz.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/mistake_row.h"
#include "ui/features/inspector/outside_view.h"
#include "ui/features/inspector/sensitivity.h"
#include "ui/features/lecture/lecture.h"
#include "ui/features/lessons/lesson.h"
#include "ui/features/views/scope.h"
#include "ui/features/views/term_grid.h"
#include "ui/features/views/views.h"
#include "ui/fields/panels.h"
#include "ui/picture/magnifier.h"
#include "ui/preferences/persistence.h"
#include "ui/shell/columns.h"
#include "ui/shell/modal.h"
#include "ui/ui.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace glint::test {

/// A command by its name in the menus.
inline const WindowCommand& command_named(std::string_view name) {
    for (const WindowCommand& command : commands())
        if (command.name == name) return command;
    FAIL("missing command " << name);
    return commands()[0];
}

/// Makes `clipboard`, which must outlive its use, the window's clipboard. Precondition: there is a window.
inline void use_clipboard(std::string& clipboard) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = &clipboard;
    io.SetClipboardTextFn = [](void* to, const char* text) { *static_cast<std::string*>(to) = text; };
    io.GetClipboardTextFn = [](void* from) { return static_cast<std::string*>(from)->c_str(); };
}

class HeadlessWindow {
  public:
    explicit HeadlessWindow(ImVec2 size = {1280, 800}) : state(1) {
        context_ = ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as in the program's window
        io.DisplaySize = size;
        io.DeltaTime = 1.0f / 60;
        apply_theme(dark_theme(), 1);
        load_fonts({}, 1, 1);  // ImGui's own font: the same on every machine
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        state.pace.slow_ms = HUGE_VAL;  // test results must not depend on the machine's load
        take_document(state.editor, first_scene());
        list_controls_in(&controls_);
    }
    ~HeadlessWindow() {
        list_controls_in(nullptr);
        ImGui::DestroyContext(context_);
    }
    HeadlessWindow(const HeadlessWindow&) = delete;
    HeadlessWindow& operator=(const HeadlessWindow&) = delete;

    UiRequests frame(const UiInput& input = {}) {
        controls_.clear();
        ImGui::NewFrame();
        UiRequests wants = ui_frame(state, input);
        ImGui::Render();
        return wants;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) (void)frame();
    }
    void type(const char* letters) {
        for (; *letters != 0; ++letters) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(*letters));
        frames(2);
    }
    void move(ImVec2 to) {
        ImGui::GetIO().MousePos = to;
        (void)frame();
    }
    void button(bool down, int which = 0) {
        ImGui::GetIO().MouseDown[which] = down;
        (void)frame();
    }
    void click(ImVec2 at) {
        move(at);
        button(true);
        button(false);
    }
    /// Clicks a control, by its name or key, and lets the window respond.
    void click_on(std::string_view name_or_key) {
        click(control(name_or_key));
        frames(2);
    }
    void drag(ImVec2 from, ImVec2 to, int which = 0) {
        move(from);
        button(true, which);
        for (int i = 1; i <= 5; ++i)
            move({from.x + (to.x - from.x) * float(i) / 5, from.y + (to.y - from.y) * float(i) / 5});
        button(false, which);
    }
    UiRequests key(Key key, bool ctrl = false, bool shift = false) {
        UiInput input;
        input.presses.push_back({key, ctrl, shift, false});
        return frame(input);
    }

    void drop(const std::string& path) {
        UiInput input;
        input.dropped = {path};
        (void)frame(input);
    }
    /// Drops a file and waits until it is loaded.
    void open(const std::string& path) {
        drop(path);
        wait_for_loads();
    }

    /// Starts a comparison with these parts.
    void compare(std::vector<Variant> parts) {
        set_parts(state.get<CompareState>().choice, std::move(parts));
        (void)key(Key::C);
        frames(2);
    }

    /// The number of notifications that contain this text.
    [[nodiscard]] std::size_t notes_with(const std::string& words) const {
        const auto& list = state.notifications.list;
        return std::size_t(std::count_if(list.begin(), list.end(), [&words](const Notification& note) {
            return note.text.find(words) != std::string::npos;
        }));
    }

    /// Runs frames until no load is in progress.
    void wait_for_loads() {
        do {
            (void)frame();
            std::this_thread::yield();
        } while (state.loading.active());
        (void)frame();
    }

    /// All characters drawn in the last frame, without spaces; '?' for those that ImGui's own font lacks.
    [[nodiscard]] static std::string text() {
        std::map<std::pair<float, float>, ImWchar> characters;  // by their place in the font's texture
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
            for (const ImFontGlyph& glyph : font->Glyphs)
                if (glyph.Visible) characters[{glyph.U0, glyph.V0}] = static_cast<ImWchar>(glyph.Codepoint);
        std::string text;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int i = 0; i < drawn.CmdListsCount; ++i)
            for (const ImDrawVert& corner : drawn.CmdLists[i]->VtxBuffer) {
                const auto found = characters.find({corner.uv.x, corner.uv.y});
                std::array<char, 5> utf8{};
                if (found != characters.end()) text += ImTextCharToUtf8(utf8.data(), found->second);
            }
        return text;
    }
    /// Returns the controls of the last frame.
    [[nodiscard]] const std::vector<NamedControl>& controls() const { return controls_; }
    /// Returns the rectangle of a visible control within `area`, by its name or its key in the scene file,
    /// "/lights/0/diffuse"; if several match, the first one drawn.
    [[nodiscard]] Rect area_of(std::string_view name_or_key, const Rect& area) const {
        for (const NamedControl& control : controls_) {
            const ImVec2 at = middle_of(control.at);
            const bool inside =
                at.x >= area.low.x && at.y >= area.low.y && at.x < area.high.x && at.y < area.high.y;
            const bool named = control.name == name_or_key || control.key == name_or_key;
            if (inside && named && control.in_sight) return control.at;
        }
        FAIL("control " << name_or_key << " is not visible");
        return {};
    }
    [[nodiscard]] Rect area_of(std::string_view name_or_key) const {
        return area_of(name_or_key, {{0, 0}, ImGui::GetIO().DisplaySize});
    }
    [[nodiscard]] static ImVec2 middle_of(const Rect& area) {
        return {(area.low.x + area.high.x) / 2, (area.low.y + area.high.y) / 2};
    }
    [[nodiscard]] ImVec2 control(std::string_view name_or_key) const {
        return middle_of(area_of(name_or_key));
    }

    [[nodiscard]] Scene& scene() { return state.editor.scene(); }
    /// The window position of a pixel in the picture.
    [[nodiscard]] ImVec2 at_pixel(glm::dvec2 pixel) const {
        const ImVec2 low = picture_area(window_layout(state).centre, 1).low;
        return {low.x + float(pixel.x), low.y + float(pixel.y)};
    }
    [[nodiscard]] glm::dvec2 handle_pixel(int light) {
        const ScreenMap map = screen_map(scene().camera, state.rendered->size);
        const Dome dome = sun_dome(scene().camera.target, scene_bounds(scene()), map);
        return project(map, handle_of(scene().lights[static_cast<std::size_t>(light)], dome, map)).pixel;
    }

    UiState state;

  private:
    std::vector<NamedControl> controls_;
    ImGuiContext* context_ = nullptr;
};

/// A window that has been drawn, so that it has a layout and a picture.
struct DrawnWindow : HeadlessWindow {
    explicit DrawnWindow(ImVec2 size = {1280, 800}) : HeadlessWindow(size) { frames(2); }
};

/// A drawn window that keeps its settings and copies of unsaved work in a folder.
struct RememberingWindow : HeadlessWindow {
    explicit RememberingWindow(const std::string& folder, ImVec2 size = {1280, 800}) : HeadlessWindow(size) {
        begin_persistence(state, folder);
        frames(2);
    }
};

}  // namespace glint::test
