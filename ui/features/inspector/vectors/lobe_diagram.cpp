// The plane of incidence, seen from the side.
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "models/scene/reflection.h"
#include "renderer/reflectance/lobes.h"
#include "ui/features/inspector/equation/words.h"
#include "ui/features/inspector/inspector.h"
#include "ui/features/inspector/vectors/arrows.h"
#include "ui/features/inspector/vectors/vectors_tab.h"
#include "ui/picture/draw_picture.h"
#include "ui/ui.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/parts.h"

namespace glint {
namespace {

constexpr int lobe_steps = 120;

/// The plane of n and l as two axes: `up` along n, `across` away from the light.
struct IncidencePlane {
    glm::vec3 up{0, 1, 0}, across{1, 0, 0};
    [[nodiscard]] glm::vec2 of(glm::vec3 v) const { return {glm::dot(v, across), glm::dot(v, up)}; }
};

IncidencePlane plane_of(const ExplainedPoint& point, const ExplainedLight& light) {
    const glm::vec3 n = point.normal.camera, away = n * light.n_dot_l - light.l.camera;
    if (glm::length(away) > 1e-4f) return {n, glm::normalize(away)};
    const glm::vec3 v = point.view.camera, side = v - n * glm::dot(n, v);  // l along n: towards the viewer
    return {n, glm::length(side) > 1e-4f ? glm::normalize(side) : glm::vec3(1, 0, 0)};
}

class Diagram {
  public:
    /// `lowest`: how far an arrow extends below the ground, as a share of a unit vector.
    explicit Diagram(float lowest) {
        const float width = ImGui::GetContentRegionAvail().x;
        reach_ = std::min(0.36f * width, px(110));
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float below = std::max(lowest * reach_ + px(20), px(16));
        const float height = reach_ + px(34) + below;
        foot_ = {low.x + width / 2, low.y + height - below};
        left_ = low.x, right_ = low.x + width;
        ImGui::Dummy({width, height});
    }
    [[nodiscard]] ImVec2 at(glm::vec2 p) const { return {foot_.x + p.x * reach_, foot_.y - p.y * reach_}; }

    void ground() const {
        list_.AddLine({left_ + px(8), foot_.y}, {right_ - px(8), foot_.y}, to_u32(theme().dim_text), px(1));
    }
    void arrow(glm::vec2 to, Symbol symbol, bool thick) const {
        const ImVec2 tip = at(to);
        const ImU32 ink = to_u32(theme()[symbol]);
        list_.AddLine(foot_, tip, ink, px(thick ? 4.0f : 2.0f));
        list_.AddCircleFilled(tip, px(3), ink);
        const float out = px(symbol == Symbol::H ? 23 : 11);  // h is often close to n
        const float size = std::max(std::hypot(to.x, to.y), 0.05f);
        centred(tip + out / size * ImVec2(to.x, -to.y), ink, letter_of(symbol));
    }
    /// Draws an arc clockwise from n, with its angle in degrees outside.
    void arc(double degrees, double radius, Symbol symbol) const {
        const auto angle = static_cast<float>(degrees * std::numbers::pi / 180);
        const auto r = static_cast<float>(radius);
        constexpr float up = -std::numbers::pi_v<float> / 2;
        if (std::abs(angle) < 0.02f) return;
        list_.PathArcTo(foot_, r * reach_, up, up + angle, 20);
        list_.PathStroke(to_u32(theme()[symbol]), 0, px(1));
        centred(at((r + 0.17f) * glm::vec2(std::sin(angle / 2), std::cos(angle / 2))),
                to_u32(theme()[symbol]), fmt::format("{:.0f}°", std::abs(degrees)));
    }
    void lobe(const std::vector<glm::vec2>& outline, const ImVec4& colour) const {
        for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
            list_.AddTriangleFilled(foot_, at(outline[i]), at(outline[i + 1]), to_u32(colour, 0.13f));
            list_.AddLine(at(outline[i]), at(outline[i + 1]), to_u32(colour, 0.8f), px(1));
        }
    }

  private:
    void centred(ImVec2 middle, ImU32 ink, const std::string& text) const {
        list_.AddText(middle - ImGui::CalcTextSize(text.c_str()) / 2, ink, text.c_str());
    }

    ImDrawList& list_ = *ImGui::GetWindowDrawList();
    ImVec2 foot_;
    float reach_ = 1, left_ = 0, right_ = 0;
};

/// The lobe in polar form, scaled so that its longest ray is a unit vector.
std::vector<glm::vec2> lobe_outline(const UiState& state, double light_deg) {
    const Shading& shading = explained_scene(state).shading;
    const Reflector reflector{shading.reflection, state.on_screen.explanation->material, shading.terms};
    const std::vector<LobeSample> slice = lobe_slice(reflector, light_deg, lobe_steps);
    const auto strength = [&](const LobeSample& s) {
        return (s.reflected.diffuse + s.reflected.specular)[state.get<InspectorState>().channel];
    };
    float most = 1e-6f;
    for (const LobeSample& sample : slice) most = std::max(most, strength(sample));
    std::vector<glm::vec2> outline;
    for (const LobeSample& sample : slice) {
        const double angle = sample.view_deg * std::numbers::pi / 180;
        outline.push_back(strength(sample) / most * glm::vec2(std::sin(angle), std::cos(angle)));
    }
    return outline;
}

}  // namespace

void lobe_diagram(const UiState& state, const ExplainedPoint& point, const ExplainedLight& light) {
    const auto pointed = state.get<InspectorState>().pointed_vector;
    const IncidencePlane plane = plane_of(point, light);
    const float lowest = -std::min({plane.of(light.l.camera).y, plane.of(light.r.camera).y,
                                    plane.of(light.h.camera).y, plane.of(point.view.camera).y, 0.0f});
    const Diagram diagram(lowest);
    ImGui::PushFont(fonts().small);
    diagram.ground();
    const double light_deg = angle_deg(light.n_dot_l);
    if (light_deg < 89.5) diagram.lobe(lobe_outline(state, light_deg), theme()[Symbol::Specular]);
    const ReflectionInfo model = info_of(state.on_screen.explanation->reflection);
    const auto arrow = [&](Symbol symbol, const InBothFrames& v) {
        diagram.arrow(plane.of(v.camera), symbol, pointed == symbol);
    };
    arrow(Symbol::N, point.normal);
    if (model.uses_r()) {
        arrow(Symbol::R, light.r);
        diagram.arc(light_deg, 0.5, Symbol::R);
    }
    if (model.uses_h) arrow(Symbol::H, light.h);
    arrow(Symbol::L, light.l);
    arrow(Symbol::V, point.view);
    diagram.arc(-light_deg, 0.5, Symbol::L);
    ImGui::PopFont();
    const float out_of_plane = glm::length(plane.of(point.view.camera));
    small_dim(
        fmt::format("The plane of n and l; v is {:.0f}° out of it. The lobe is the reflected light by "
                    "direction, longest = 1.",
                    angle_deg(out_of_plane)));
}

}  // namespace glint
