#include "ui/inspector/equation/formula.h"

#include "ui/inspector/equation/text_line.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

void power(TextLine& f, Quantity cosine) { f.plain("(").symbol(cosine).plain(")").symbol(Quantity::Power); }

void highlight(TextLine& f, Reflection reflection) {
    const ReflectionInfo info = info_of(reflection);
    if (!info.has_highlight) return;
    f.plain("+").symbol(Quantity::MaterialSpecular).symbol(Quantity::LightSpecular);
    switch (info.cosine) {
    case HighlightCosine::RV:
        return power(f, Quantity::RV);
    case HighlightCosine::NH:
        return power(f, Quantity::NH);
    case HighlightCosine::LV:
        return power(f, Quantity::LV);
    case HighlightCosine::None:
        break;
    }
    if (reflection != Reflection::CookTorrance) return (void)f.symbol(Quantity::Highlight);
    f.gap(2).symbol(Quantity::QuarterPi).gap(2).symbol(Quantity::Facets).symbol(Quantity::Masking);
    f.symbol(Quantity::Fresnel).plain("/").symbol(Quantity::NV);
}

}  // namespace

void formula(Reflection reflection) {
    if (!info_of(reflection).is_lit) return dim_text("No lighting: the mesh's own colours.");
    TextLine f(20);
    f.symbol(Quantity::Result).plain(" = ").symbol(Quantity::MaterialEmission);
    f.plain("+").symbol(Quantity::MaterialAmbient).symbol(Quantity::GlobalAmbient);
    f.plain("+Σ").symbol(Quantity::Share);
    f.plain("(").symbol(Quantity::MaterialAmbient).symbol(Quantity::LightAmbient);
    f.plain("+").symbol(Quantity::MaterialDiffuse).symbol(Quantity::LightDiffuse);
    f.symbol(Quantity::NL);
    if (info_of(reflection).rough_diffuse) f.symbol(Quantity::Rough);
    highlight(f, reflection);
    f.plain(")");
}

}  // namespace glint
