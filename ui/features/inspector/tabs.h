#pragma once
// The WHY column: the picked pixel, and tabs with different views of it. Its tabs are a closed list.

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

/// Seconds without a change to the scene before background measuring or drawing begins.
inline constexpr double stillness = 0.25;

/// The scene of a tab.
enum class TabScene {
    Edited,
    Asked,  // explained_scene(), read-only if it is not the edited one
    Shown   // the scene on the screen; the tab names it itself
};

/// A tab: its label, its tooltip, and the function that draws it below the tab bar.
struct InspectorTabInfo {
    InspectorTab tab;
    const char* label;
    const char* what;
    void (*draw)(UiState&, const PictureView&);
    TabScene scene = TabScene::Edited;
    bool is_first = false;   // in the tab bar, not behind More
    const char* words = "";  // search terms for Ctrl+K
};

/// All tabs: first those of the bar from left to right, then those behind More. To add one: a name in
/// InspectorTab, its row here in tabs.cpp, its own file.
[[nodiscard]] std::span<const InspectorTabInfo> inspector_tabs();

/// Draws heading, tab bar and the chosen tab into the current window. Called after the picture is drawn, so
/// that the numbers match the screen.
void inspector(UiState& state, const PictureView& view);

/// Draws a tab that needs a pixel, before one is picked; `promise` describes what the tab would show.
void inspector_empty_state(const char* promise);

// The models tab shows the picked pixel under flat, facet, Gouraud and Phong shading, side by side, and how
// each computes its colour.

/// Hovering over a model previews the picture under it; a click applies the model.
void models_tab(UiState& state, const PictureView& view);

/// The pixel under each mode of ShadingMode, in its order, regardless of the scene's own mode. Precondition:
/// the picture is of the edited scene, or of one with other lights, materials or shading.
[[nodiscard]] std::array<Explanation, 4> under_each_mode(const UiState& state,
                                                         const Explanation& explanation);
/// The pixel lit at its own point, as under Phong shading. Nothing if the explanation is not of the edited
/// scene.
[[nodiscard]] std::optional<Explanation> under_phong(const UiState& state, const Explanation& explanation);

// Mistakes that students actually make, as switches: each shows how the mistake can be recognised. Hovering
// over one previews it.

void mistakes_tab(UiState& state, const PictureView& view);

/// The number of mistakes that are on.
[[nodiscard]] int mistakes_on(const Mistakes& mistakes);
/// "Mistake: Reflect sign", "3 mistakes: Reflect sign, Missing pi, …"; empty without any.
[[nodiscard]] std::string mistakes_text(const Mistakes& mistakes);
/// Opens the Mistakes tab at that mistake; for null, at the first one that is on.
void show_mistake(UiState& state, const MistakeName* mistake = nullptr);

// The matrices tab shows the camera's matrices and their effect: each light's position in camera coordinates,
// and the picked point's coordinates at each stage from mesh to pixel, with the stage of lighting marked.

void matrices_tab(UiState& state, const PictureView& view);

/// A light's position in both frames, w as in the scene: a direction remains a direction. `mistakes` may put
/// the light into wrong frames, as in the picture.
struct CarriedLight {
    glm::dvec4 world{0}, camera{0};
};
[[nodiscard]] CarriedLight carried(const Light& light, const Camera& camera, const Mistakes& mistakes = {});

// The program tab shows the OpenGL calls that draw the scene: every number can be dragged, a light's position
// can be dragged to the other side of gluLookAt(), a transform past another.

void program_tab(UiState& state, const PictureView& view);

// The sensitivity tab sorts every number of the scene by its effect on the picked pixel.

void sensitivity_tab(UiState& state, const PictureView& view);

}  // namespace glint
