#pragma once
// The WHY column: the picked pixel, and tabs that each look at it in another way. Its tabs are a closed list.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>

#include "models/scene/camera.h"
#include "models/scene/light.h"
#include "models/scene/shading.h"
#include "renderer/explain/explanation.h"
#include "ui/features/inspector/inspector.h"

namespace glint {

struct UiState;
struct PictureView;

/// Seconds that the scene has stood still before something is measured or drawn beside the window.
inline constexpr double stillness = 0.25;

/// The scene that a tab is about.
enum class TabScene {
    Edited,
    Asked,  // explained_scene(), whose numbers cannot be edited where it is not the edited one
    Shown   // what rests on the screen; the tab says so itself
};

/// A tab: what it is called, what its tooltip says, and what draws it below the tab bar.
struct InspectorTabInfo {
    InspectorTab tab;
    const char* label;
    const char* what;
    void (*draw)(UiState&, const PictureView&);
    TabScene scene = TabScene::Edited;
    bool is_first = false;  // it stands in the bar, not behind More
};

/// All tabs: first those of the bar from left to right, then those behind More. To add one: a name in
/// InspectorTab, its line here in tabs.cpp, its own file.
[[nodiscard]] std::span<const InspectorTabInfo> inspector_tabs();

/// Draws heading, tab bar and the chosen tab into the current window. After the picture, so that numbers are
/// of what is on the screen.
void inspector(UiState& state, const PictureView& view);

/// Draws a tab that needs a pixel while none is picked; `promise` says what it would show.
void inspector_empty_state(const char* promise);

// The models tab shows the picked pixel under flat, facet, Gouraud and Phong shading, side by side, and how
// each comes by its colour.

/// Pointing at a model shows the whole picture under it, a click takes it.
void models_tab(UiState& state, const PictureView& view);

/// The pixel under each mode of ShadingMode, in its order, whatever the scene's own mode is.
/// Precondition: the picture is of the edited scene, or of one with other lights, materials or shading.
[[nodiscard]] std::array<Explanation, 4> under_each_mode(const UiState& state,
                                                         const Explanation& explanation);
/// The pixel lit at its own point. Nothing if the explanation is not of the edited scene.
[[nodiscard]] std::optional<Explanation> under_phong(const UiState& state, const Explanation& explanation);

// The mistakes that students really make are switches: on, one sees how each is recognised; pointed at, one
// sees it for as long as the mouse rests there.

void mistakes_tab(UiState& state, const PictureView& view);

/// How many mistakes are on.
[[nodiscard]] int mistakes_on(const Mistakes& mistakes);
/// "Mistake: Reflect sign", "3 mistakes: Reflect sign, Missing pi, …"; empty when none is on.
[[nodiscard]] std::string mistakes_text(const Mistakes& mistakes);
/// Opens the Mistakes tab at that mistake; for null, at the first one that is on.
void show_mistake(UiState& state, const MistakeName* mistake = nullptr);

// The matrices tab shows the camera's matrices and what they do: each light's position in camera coordinates,
// and the picked point on its way from the mesh to its pixel, with the place of lighting marked.

void matrices_tab(UiState& state, const PictureView& view);

/// A light's position in both frames, w as in the scene: a direction stays a direction. `mistakes` may carry
/// the light into wrong frames, as they do in the picture.
struct CarriedLight {
    glm::dvec4 world{0}, camera{0};
};
[[nodiscard]] CarriedLight carried(const Light& light, const Camera& camera, const Mistakes& mistakes = {});

// The program tab shows the calls by which OpenGL draws the scene: every number can be dragged where it
// stands, a light's place can be dragged to the other side of gluLookAt(), a transform past another.

void program_tab(UiState& state, const PictureView& view);

// The sensitivity tab sorts every number of the scene by how much the picked pixel moves with it.

void sensitivity_tab(UiState& state, const PictureView& view);

}  // namespace glint
