#pragma once
// The state of the WHY column, independent of the scene, and its current selection: which pixel, which of its
// lit points, which light.

#include <optional>
#include <string>
#include <vector>

#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "renderer/explain/explanation.h"
#include "renderer/explain/quantity.h"
#include "renderer/transport/traced.h"
#include "ui/features/inspector/blocks_in_sight.h"
#include "ui/widgets/theme.h"

namespace glint {

/// Each tab answers "why that colour?"; labels and order are in ui/features/inspector/tabs.cpp.
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

/// A number of the equation that is highlighted for the user.
struct MarkedQuantity {
    Quantity quantity = Quantity::Result;
    int light = -1;                       // index of its light; -1: none
    double scrolls_until = 0, until = 0;  // ImGui time: end of scrolling into view; end of the mark
};

struct InspectorState {
    InspectorTab tab = InspectorTab::Equation;
    InspectorTab tab_before = InspectorTab::Equation;  // the tab before the user's picture was opened
    int corner = 0;   // the corner whose numbers are listed under Gouraud and flat
    int channel = 0;  // the channel written out as products: 0 red, 1 green, 2 blue
    bool shows_vectors = true, shows_facet = false;  // drawn in the picture
    bool world_frame = false;                        // vectors are listed in world coordinates, else camera
    int mirror_step = 0;      // 1 to 4: r is built up in the picture; 0: r is simply drawn
    float normal_length = 1;  // length of the n from which r is constructed
    float look_at_y = 0;      // y of the gluLookAt() line in the Program tab, when last drawn
    // The vector hovered in the column in the last frame: its arrow is drawn thick.
    std::optional<Symbol> pointed_vector;
    int pointed_light = -1;
    // From the shown point, in the scene on the screen:
    std::vector<TracedLight> rays;               // to each of its lights; to the middle of an area light
    std::vector<PathStep> path;                  // empty: no path is shown
    bool shows_ray = false, shows_path = false;  // drawn in the picture
    int path_number = 1;                         // from 1
    // The scene that the next picture shows in place of the edited one, while a line with a preview is
    // hovered (a term alone, another model, a mistake).
    std::optional<Scene> instead;
    bool instead_rests = false;                   // it remains after hovering ends: cells of the grid
    std::string preview_name;                     // the name of `instead`
    std::optional<MarkedQuantity> marked;         // highlighted in the equation for a moment
    const MistakeName* wanted_mistake = nullptr;  // the Mistakes tab scrolls to it
    bool sorts_lights = false;                    // sorts the equation's lights, largest share first
    BlocksInSight cards{10};                      // cards of the equation, one per light
};

struct UiState;
struct PictureView;

/// The lit point whose numbers are shown: the pixel's own, or the chosen corner or flat point.
[[nodiscard]] const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation);

/// The light whose vectors are shown: the hovered one in the column, else the selected one, else the one that
/// contributes most. Null if no light is on.
[[nodiscard]] const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point);

// The rays behind the equation: to the lights, and one path of bounced light.

/// Traces the rays and the path from the shown point, unless a preview is on the screen.
void trace_shown(UiState& state);
/// Draws the error of bounced light, the switches, and the steps of the shown path.
void traced_controls(UiState& state, const ExplainedPoint& point);
/// Draws the rays and the path if they are switched on.
void draw_traced(ImDrawList& list, const UiState& state, const PictureView& view);

// While a line of the equation is hovered, the picture shows a scene with only that part.

/// One term alone. `term`: Ambient, Diffuse, Specular or Emission.
[[nodiscard]] Scene with_term_alone(Scene scene, Symbol term);
/// One light alone: no other, no emission, no global ambient light.
[[nodiscard]] Scene with_light_alone(Scene scene, int light);

/// Shows `scene` in the next frame, with its name on the badge. `rests`: it remains after hovering ends, and
/// picking uses it.
void show_instead(UiState& state, const Scene& scene, const std::string& name, bool rests = false);

}  // namespace glint
