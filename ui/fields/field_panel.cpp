#include "ui/fields/field_panel.h"

#include <imgui.h>

namespace glint {

bool dimmed_unless(bool applies, const std::function<bool()>& draw) {
    if (applies) return draw();
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f * ImGui::GetStyle().Alpha);
    const bool edited = draw();
    ImGui::PopStyleVar();
    return edited;
}

bool draw_field(const Row& row, const Vector& kind, glm::vec3& value, const glm::vec3& initial,
                const Help& help) {
    return vector_field(row.label, value, component_of(kind), initial, help);
}

bool draw_field(const Row& row, const Homogeneous& kind, glm::vec4& value, const glm::vec4& initial,
                const Help& help) {
    glm::vec3 xyz(value);
    if (!vector_field(row.label, xyz, component_of(kind), glm::vec3(initial), help)) return false;
    value = {xyz, value.w};
    return true;
}

bool draw_field(const Row& row, const Count& kind, int& value, int initial, const Help& help) {
    int edited = value;
    if (!integer_field(row.label, edited, kind.low, kind.high, initial, help) || edited == value)
        return false;
    // The nearest number that is allowed, in the direction of the edit.
    const int step = edited > value ? 1 : -1;
    while (edited >= kind.low && edited <= kind.high && !kind.contains(edited)) edited += step;
    if (!kind.contains(edited)) return false;
    value = edited;
    return true;
}

}  // namespace glint
