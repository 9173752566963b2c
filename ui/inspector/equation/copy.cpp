#include "ui/inspector/equation/copy.h"

#include <imgui.h>

#include <array>

#include "renderer/inspect/explain/explain_format.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/widgets.h"

namespace glint {
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

std::string explained_as(CopyAs format, const Explanation& why, const Scene& scene) {
    switch (format) {
    case CopyAs::Text:
        return explain_text(why, scene);
    case CopyAs::Json:
        return explain_json(why);
    case CopyAs::Latex:
        return explain_latex(why, scene);
    }
    return {};  // not reached
}

void copy_buttons(const Explanation& why, const Scene& scene) {
    section("Copy this explanation as");
    ImGui::PushFont(fonts().small);
    for (const Format& format : formats) {
        if (&format != &formats.front()) ImGui::SameLine();
        if (ImGui::Button(format.label)) ImGui::SetClipboardText(explained_as(format.as, why, scene).c_str());
        tooltip(format.label, format.what);
    }
    ImGui::PopFont();
}

}  // namespace glint
