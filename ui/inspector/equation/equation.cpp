#include <imgui.h>

#include <array>

#include "models/scene/reflection.h"
#include "renderer/inspect/explain/explain_format.h"
#include "ui/inspector/equation/equation_tab.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

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
        ImGui::GetWindowDrawList()->AddText({at.x, at.y + (low ? px(4) : 0)}, to_u32(colour), text);
        if (low) ImGui::PopFont();
        ImGui::Dummy({size.x, ImGui::GetTextLineHeight()});
        return *this;
    }
    bool first_ = true;
};

void highlight_formula(Formula& f, Reflection reflection) {
    const ReflectionInfo info = info_of(reflection);
    if (!info.has_highlight) return;
    f.plain(" + ").term(Symbol::Specular, "k", "s");
    switch (info.cosine) {
    case HighlightCosine::RV:
        f.dot(Symbol::R, "r", Symbol::V, "v").plain("ⁿ");
        return;
    case HighlightCosine::NH:
        f.dot(Symbol::N, "n", Symbol::H, "h").plain("ⁿ");
        return;
    case HighlightCosine::LV:
        f.dot(Symbol::L, "l", Symbol::V, "v").plain("ⁿ");
        return;
    case HighlightCosine::None:
        f.plain(" ").plain(info.highlight);
        return;
    }
}

}  // namespace

void equation(Reflection reflection) {
    if (!info_of(reflection).is_lit) return dim_text("No lighting: the mesh's own colours.");
    Formula f;
    f.plain("I = ").term(Symbol::Emission, "e").plain(" + ").term(Symbol::Ambient, "k", "a");
    f.term(Symbol::Ambient, "I", "a").plain(" + Σ F (").term(Symbol::Diffuse, "k", "d");
    f.dot(Symbol::N, "n", Symbol::L, "l");
    if (info_of(reflection).rough_diffuse) f.plain(" (A + B…)");
    highlight_formula(f, reflection);
    f.plain(")");
}

namespace {

struct Format {
    CopyAs as;
    const char* label;
    const char* what;
};
constexpr std::array formats{
    Format{CopyAs::Text, "text", "As `glint explain FILE --pixel X,Y` prints it"},
    Format{CopyAs::Json, "JSON",
           "As `glint explain … --format json` prints it; docs/explain.md tells its keys"},
    Format{CopyAs::Latex, "LaTeX", "As `glint explain … --format latex` prints it, for amsmath"}};

}  // namespace

std::string explained_as(CopyAs format, const Explanation& explanation, const Scene& scene) {
    switch (format) {
    case CopyAs::Text:
        return explain_text(explanation, scene);
    case CopyAs::Json:
        return explain_json(explanation);
    case CopyAs::Latex:
        return explain_latex(explanation, scene);
    }
    return {};  // not reached
}

void copy_buttons(const Explanation& explanation, const Scene& scene) {
    section_heading("Copy this explanation as");
    ImGui::PushFont(fonts().small);
    for (const Format& format : formats) {
        if (&format != &formats.front()) ImGui::SameLine();
        if (ImGui::Button(format.label))
            ImGui::SetClipboardText(explained_as(format.as, explanation, scene).c_str());
        tooltip(format.label, format.what);
    }
    ImGui::PopFont();
}

}  // namespace glint
