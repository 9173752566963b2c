#pragma once
// The state of the WHY column, which is not part of the scene, and its current selection: the pixel, one of
// its lit points, and a light.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/scene/mistakes.h"
#include "models/scene/scene.h"
#include "models/scene/shading.h"
#include "renderer/explain/explain.h"
#include "renderer/explain/quantity.h"
#include "renderer/transport/traced.h"
#include "ui/widgets/theme.h"

namespace glint {

// Draws only the visible part of a column with thousands of lights or objects.

/// Keeps the height of each block from frame to frame, since all heights may differ.
class BlocksInSight {
  public:
    /// `lines`: the estimated height, in lines of text, of a block that has not been drawn yet.
    explicit BlocksInSight(float lines) : lines_(lines) {}

    /// Draws `count` blocks, one below the other, with draw(index). A block far outside the view is not
    /// drawn but keeps its last height. The block `wanted`, to be scrolled to or measured, and the one with
    /// the mouse or the focus are always drawn.
    template <class Draw> void draw(int count, const Draw& draw, int wanted = -1) {
        begin(count);
        for (int i = 0; i < count; ++i) {
            if (!begin_block(i, i == wanted)) continue;
            draw(i);
            end_block(i);
        }
        end();
    }

  private:
    void begin(int count);
    /// False if the block is skipped.
    bool begin_block(int index, bool is_wanted);
    void end_block(int index);
    void end();

    float lines_;
    std::vector<float> heights_;          // ImGui's units; 0: not drawn yet
    int held_ = -1;                       // the block with the control being edited
    float top_ = 0, low_ = 0, high_ = 0;  // where the block begins; the visible range with a margin
};

/// Each tab answers "why that colour?"; labels and order are in ui/features/inspector/inspector.cpp.
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

/// A number in the equation that is highlighted for the user.
struct MarkedQuantity {
    Quantity quantity = Quantity::Result;
    int light = -1;                       // index of its light; -1: none
    double scrolls_until = 0, until = 0;  // ImGui time: end of scrolling into view; end of the mark
};

struct InspectorState {
    InspectorTab tab = InspectorTab::Equation;
    InspectorTab tab_before = InspectorTab::Equation;  // the tab before the user's picture was opened
    int corner = 0;   // the corner whose numbers are listed under Gouraud and flat shading
    int channel = 0;  // the channel written out as products: 0 red, 1 green, 2 blue
    bool shows_vectors = true, shows_facet = false;  // drawn in the picture
    bool world_frame = false;                        // list vectors in world instead of camera coordinates
    int mirror_step = 0;      // 1 to 4: r is built up in the picture; 0: r is simply drawn
    float normal_length = 1;  // length of the n from which r is constructed
    float look_at_y = 0;      // y of the gluLookAt() line in the Program tab, when last drawn
    // The vector hovered in the column in the last frame: its arrow is drawn thick.
    std::optional<Symbol> pointed_vector;
    int pointed_light = -1;
    // Rays and a path from the shown point, in the scene on the screen:
    std::vector<TracedLight> rays;               // to each light; to the centre of an area light
    std::vector<PathStep> path;                  // empty: no path is shown
    bool shows_ray = false, shows_path = false;  // drawn in the picture
    int path_number = 1;                         // counted from 1
    // The scene that the next picture shows in place of the edited one, while a line with a preview is
    // hovered (a term alone, a different model, a mistake).
    std::optional<Scene> instead;
    bool instead_rests = false;            // `instead` stays after hovering ends, as for a cell of the grid
    std::string preview_name;              // the name of `instead`
    std::optional<MarkedQuantity> marked;  // highlighted in the equation for a moment
    const MistakeName* wanted_mistake = nullptr;  // the Mistakes tab scrolls to it
    bool sorts_lights = false;                    // sorts the equation's lights, largest share first
    BlocksInSight cards{10};                      // cards of the equation, one per light
};

struct UiState;
struct PictureView;

/// The lit point whose numbers are shown: the pixel's own, or the chosen corner or flat point.
[[nodiscard]] const ExplainedPoint& asked_point(const InspectorState& state, const Explanation& explanation);

/// The light whose vectors are shown: the hovered one in the column, otherwise the selected one, otherwise
/// the one that contributes most. Null if no light is on.
[[nodiscard]] const ExplainedLight* asked_light(const UiState& state, const ExplainedPoint& point);

// The rays behind the equation: to the lights, and one path of bounced light.

/// Traces the rays and the path from the shown point, unless a preview is on the screen.
void trace_shown(UiState& state);
/// Draws the error of bounced light, the switches, and the steps of the shown path.
void traced_controls(UiState& state, const ExplainedPoint& point);
/// Draws the rays and the path if they are switched on.
void draw_traced(ImDrawList& list, const UiState& state, const PictureView& view);

// While a line of the equation is hovered, the picture shows a scene with only that part.

/// The scene with one term alone. `term`: Ambient, Diffuse, Specular or Emission.
[[nodiscard]] Scene with_term_alone(Scene scene, Symbol term);
/// The scene with one light alone: no other lights, no emission, no global ambient light.
[[nodiscard]] Scene with_light_alone(Scene scene, int light);

/// Shows `scene` in the next frame, with `name` on the badge. `rests`: the scene stays after hovering ends,
/// and picking uses it.
void show_instead(UiState& state, const Scene& scene, const std::string& name, bool rests = false);

// The WHY column: the picked pixel, and tabs with different views of it. The list of tabs is fixed.

struct UiState;
struct PictureView;

/// Seconds without a change to the scene before background measuring or drawing begins.
inline constexpr double stillness = 0.25;

/// The scene that a tab is about.
enum class TabScene {
    Edited,
    Asked,  // explained_scene(), read-only if it is not the edited one
    Shown   // the scene on the screen; the tab itself names it
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

/// All tabs: first those in the bar from left to right, then those behind More. To add one, add a name to
/// InspectorTab, a row to `tabs` in inspector.cpp, and a file with its draw function.
[[nodiscard]] std::span<const InspectorTabInfo> inspector_tabs();

/// Draws the heading, the tab bar and the chosen tab into the current window. Called after the picture is
/// drawn, so that the numbers match the screen.
void inspector(UiState& state, const PictureView& view);

/// Draws a tab that needs a pixel, before one is picked; `promise` describes what the tab would show.
void inspector_empty_state(const char* promise);

// The models tab shows the picked pixel under flat, facet, Gouraud and Phong shading, side by side, and how
// each computes its colour.

/// Hovering over a model previews the picture under it; a click applies the model.
void models_tab(UiState& state, const PictureView& view);

/// The pixel under each mode of ShadingMode, in the enum's order, regardless of the scene's own mode.
/// Precondition: the picture shows the edited scene, or one that differs only in lights, materials or
/// shading.
[[nodiscard]] std::array<Explanation, 4> under_each_mode(const UiState& state,
                                                         const Explanation& explanation);
/// The pixel lit at its own point, as under Phong shading. nullopt if the explanation does not match the
/// explained scene.
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

/// A light's position in both frames, with w as in the scene, so a direction remains a direction. `mistakes`
/// may put the light into the wrong frame, as in the picture.
struct CarriedLight {
    glm::dvec4 world{0}, camera{0};
};
[[nodiscard]] CarriedLight carried(const Light& light, const Camera& camera, const Mistakes& mistakes = {});

// The program tab shows the OpenGL calls that draw the scene. Every number can be dragged; a light's position
// can be dragged to the other side of gluLookAt(), and a transform past its neighbours.

void program_tab(UiState& state, const PictureView& view);
/// The command that writes a program for this scene, in a supported language.
[[nodiscard]] std::string whole_program_words(const Scene& scene);

// The sensitivity tab sorts every number in the scene by its effect on the picked pixel.

void sensitivity_tab(UiState& state, const PictureView& view);

}  // namespace glint
