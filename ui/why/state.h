#pragma once
// What the WHY column remembers of the window, none of it the scene's.

namespace glint {

/// One answer to "why that colour?" each; their labels and order are in ui/why/tabs.cpp.
enum class WhyTab { Equation, Mistakes };

struct WhyState {
    WhyTab tab = WhyTab::Equation;
    int corner = 0;  // whose numbers are listed under Gouraud and flat
};

}  // namespace glint
