#include "ui/why/equation.h"

#include <imgui.h>

#include "ui/fonts.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace glint {
namespace {

/// Pieces of a formula on one line; `low` pieces are subscripts.
class Formula {
  public:
    Formula& plain(const char* text) { return piece(text, theme().dim_text, false); }
    Formula& term(Symbol symbol, const char* letter, const char* index = "") {
        piece(letter, theme()[symbol], false);
        return *index != 0 ? piece(index, theme()[symbol], true) : *this;
    }
    /// "(a·b)", each letter in its colour.
    Formula& dot(Symbol a, const char* name_a, Symbol b, const char* name_b) {
        return plain("(").term(a, name_a).plain("·").term(b, name_b).plain(")");
    }

  private:
    Formula& piece(const char* text, const ImVec4& colour, bool low) {
        if (!first_) ImGui::SameLine(0, 0);
        first_ = false;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (low) ImGui::PushFont(fonts().small);
        const ImVec2 size = ImGui::CalcTextSize(text);
        ImGui::GetWindowDrawList()->AddText({at.x, at.y + (low ? px(4) : 0)}, packed(colour), text);
        if (low) ImGui::PopFont();
        ImGui::Dummy({size.x, ImGui::GetTextLineHeight()});
        return *this;
    }
    bool first_ = true;
};

void highlight_formula(Formula& f, Reflection reflection) {
    const auto power = [&f](Symbol a, const char* name_a, Symbol b, const char* name_b) {
        f.plain(" + ").term(Symbol::Specular, "k", "s").dot(a, name_a, b, name_b).plain("ⁿ");
    };
    switch (reflection) {
    case Reflection::None:
    case Reflection::Lambert:
    case Reflection::OrenNayar:
        return;
    case Reflection::Phong:
        return power(Symbol::R, "r", Symbol::V, "v");
    case Reflection::BlinnPhong:
        return power(Symbol::N, "n", Symbol::H, "h");
    case Reflection::Retro:
        return power(Symbol::L, "l", Symbol::V, "v");
    case Reflection::CookTorrance:
        f.plain(" + ")
            .term(Symbol::Specular, "k", "s")
            .plain(" π D G F / 4(")
            .term(Symbol::N, "n")
            .plain("·");
        f.term(Symbol::V, "v").plain(")");
        return;
    }
}

}  // namespace

void equation(Reflection reflection) {
    if (reflection == Reflection::None) return dim_text("No lighting: the mesh's own colours.");
    Formula f;
    f.plain("I = ").term(Symbol::Emission, "e").plain(" + ").term(Symbol::Ambient, "k", "a");
    f.term(Symbol::Ambient, "I", "a").plain(" + Σ F (").term(Symbol::Diffuse, "k", "d");
    f.dot(Symbol::N, "n", Symbol::L, "l");
    if (reflection == Reflection::OrenNayar) f.plain(" (A + B…)");
    highlight_formula(f, reflection);
    f.plain(")");
}

}  // namespace glint
