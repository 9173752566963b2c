#pragma once
// What the window remembers of the WHY column, none of it the scene's, and what is being asked: which pixel,
// which of its lit points, which light.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"
#include "renderer/explain/quantity.h"
#include "ui/features/inspector/blocks_in_sight.h"
#include "ui/widgets/kept.h"
#include "ui/widgets/theme.h"

namespace glint {

/// One answer to "why that colour?" each; their labels and order are in ui/features/inspector/tabs.cpp.
enum class InspectorTab {
    Equation,
    Vectors,
    Plots,
    Grid,
    Models,
    Sensitivity,
    Mistakes,
    MyPicture,
    Matrices,
    Outside,
    Program
};

/// Identifies the point whose lights were asked: the picture (UiState::picture_serial), its pixel and corner.
struct BlockedKey {
    std::uint64_t serial = 0;
    glm::ivec2 pixel{-1};
    int corner = -1;
    bool operator==(const BlockedKey&) const = default;
};

/// A number of the equation that the user was led to.
struct MarkedQuantity {
    Quantity quantity = Quantity::Result;
    int light = -1;                       // whose it is; -1: no light's
    double scrolls_until = 0, until = 0;  // ImGui's time: brought into sight; marked
};

struct InspectorState {
    InspectorTab tab = InspectorTab::Equation;
    InspectorTab tab_before = InspectorTab::Equation;  // the user's picture came
    int corner = 0;                                    // whose numbers are listed under Gouraud and flat
    int channel = 0;                                   // whose product is written out: 0 red, 1 green, 2 blue
    bool shows_vectors = true, shows_facet = false;    // in the picture
    bool world_frame = false;                          // vectors are listed in world coordinates, else camera
    int mirror_step = 0;      // 1 to 4: r is built up in the picture; 0: r is simply shown
    float normal_length = 1;  // of the n that r is built from
    float look_at_y = 0;      // of the line gluLookAt() in the tab Program, as it was drawn last
    // What the mouse points at in the column, of the last frame: its arrow is drawn thick.
    std::optional<Symbol> pointed_vector;
    int pointed_light = -1;
    Kept<BlockedKey, std::vector<int>> blocked;  // per light of the point: the object in its way, or -1
    // The scene that the next picture shows in place of the edited one, while the mouse points at a line that
    // asks for it (a term alone, another model, a mistake).
    std::optional<Scene> instead;
    bool instead_rests = false;                   // it stays when the mouse moves on: cells of the grid
    std::string preview_name;                     // of it
    std::optional<MarkedQuantity> marked;         // shown in the equation for a moment
    const MistakeName* wanted_mistake = nullptr;  // the Mistakes tab scrolls to it
    BlocksInSight cards{10};                      // of the equation, one a light
};

struct UiState;
struct PictureView;

/// The lit point whose numbers are shown: the pixel's own, or the chosen corner or flat point.
[[nodiscard]] const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation);

/// The light whose vectors are shown. It is the one pointed at in the column, else the selected one, else the
/// one that adds most. Null when no light is on.
[[nodiscard]] const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point);

// While a line of the equation is pointed at, the picture shows a scene with all but one thing left out.

/// One term alone. `term`: Ambient, Diffuse, Specular or Emission.
[[nodiscard]] Scene with_term_alone(Scene scene, Symbol term);
/// One light alone: no other, no emission, no global ambient light.
[[nodiscard]] Scene with_light_alone(Scene scene, int light);

/// The picture shows `scene` in the next frame, with its name on the badge. `rests`: it does not go with
/// the mouse, so what is asked of the picture is asked of it.
void show_instead(UiState& state, const Scene& scene, const std::string& name, bool rests = false);

}  // namespace glint
