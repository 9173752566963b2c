#pragma once
// What the WHY column remembers of the window, none of it the scene's.

#include <optional>
#include <string>

#include "models/scene/scene.h"
#include "ui/inspector/blocked.h"
#include "ui/widgets/theme.h"

namespace glint {

/// One answer to "why that colour?" each; their labels and order are in ui/inspector/tabs.cpp.
enum class InspectorTab { Equation, Vectors, Plots, Grid, Models, Sensitivity, Mistakes, Matrices, Outside };

struct InspectorState {
    InspectorTab tab = InspectorTab::Equation;
    int corner = 0;                                  // whose numbers are listed under Gouraud and flat
    int channel = 0;                                 // whose product is written out: 0 red, 1 green, 2 blue
    bool shows_vectors = true, shows_facet = false;  // in the picture
    bool world_frame = false;                        // vectors are listed in world coordinates, else camera
    int mirror_step = 0;      // 1 to 4: r is built up in the picture; 0: r is simply shown
    float normal_length = 1;  // of the n that r is built from
    // What the mouse points at in the column, of the last frame: its arrow is drawn thick.
    std::optional<Symbol> pointed_vector;
    int pointed_light = -1;
    BlockedState blocked;
    // What the mouse points at in the column alone, or otherwise: the next picture shows it.
    std::optional<Scene> instead;
    std::string preview_name;  // over it; or empty
};

}  // namespace glint
