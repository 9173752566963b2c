// Finds an answer's number in the equation.
#include <array>
#include <cstdio>
#include <string_view>

#include "ui/features/inspector/inspector.h"
#include "ui/features/lessons/lesson.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A field of an explanation (docs/explain.md) and the letter under which its number is shown.
struct TermPlace {
    std::string_view field;
    Quantity quantity;
    InspectorTab tab = InspectorTab::Equation;
};
constexpr std::array places{
    TermPlace{"n_dot_l", Quantity::NL},
    TermPlace{"r_dot_v", Quantity::RV},
    TermPlace{"n_dot_h", Quantity::NH},
    TermPlace{"l_dot_v", Quantity::LV},
    TermPlace{"falloff", Quantity::Falloff},
    TermPlace{"spot", Quantity::Spot},
    TermPlace{"distance", Quantity::Distance},
    TermPlace{"diffuse", Quantity::DiffuseTerm},
    TermPlace{"specular", Quantity::SpecularTerm},
    TermPlace{"ambient", Quantity::AmbientTerm},
    TermPlace{"diffuse_factor", Quantity::NL},
    TermPlace{"cool_to_warm.k_w", Quantity::WarmShare},
    TermPlace{"r", Quantity::R, InspectorTab::Vectors},
    TermPlace{"l", Quantity::L, InspectorTab::Vectors},
    TermPlace{"h", Quantity::H, InspectorTab::Vectors},
};

/// The position of a field such as "lights[0].r.world[0]", and the light's index; for an unknown field, the
/// position of the sum.
std::pair<TermPlace, int> place_of(std::string_view term) {
    int light = -1;
    if (std::sscanf(std::string(term).c_str(), "lights[%d]", &light) == 1)
        term.remove_prefix(term.find('.') + 1);
    for (const TermPlace& place : places) {
        if (!term.starts_with(place.field)) continue;
        const std::string_view rest = term.substr(place.field.size());
        if (rest.empty() || rest.front() == '.' || rest.front() == '[') return {place, light};
    }
    return {{"sum", Quantity::Result}, -1};
}

}  // namespace

void mark_in_equation(UiState& state, const Prediction& question) {
    constexpr double seen_s = 5, scrolls_s = 0.3;
    const auto [place, light] = place_of(question.term);
    InspectorState& inspector = state.get<InspectorState>();
    inspector.tab = place.tab;
    inspector.world_frame = question.term.find("world") != std::string::npos;
    if (!question.term.empty())
        inspector.marked = {place.quantity, light, ImGui::GetTime() + scrolls_s, ImGui::GetTime() + seen_s};
    if (light >= 0) {
        state.editor.selection = valid_selection({Selection::Kind::Light, light}, state.editor.scene());
        inspector.corner = 0;
    }
    redraw_within(0);
}

void show_in_equation(UiState& state, const Prediction& question) {
    const Station& station = state.get<LessonState>().station();
    if (station.reveal == nullptr || !station.reveal->pick) return;
    mark_in_equation(state, question);
    ask_about(state.viewport, share_of_lesson_pixel(state, glm::dvec2(*station.reveal->pick) + 0.5));
    state.layout.right = state.left_shows_inspector = true;
}

}  // namespace glint
