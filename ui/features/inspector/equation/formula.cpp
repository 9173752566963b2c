#include "ui/features/inspector/equation/formula.h"

#include "ui/features/inspector/equation/text_line.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// The highlight's factor.
void highlight(TextLine& f, Reflection reflection) {
    const ReflectionInfo info = info_of(reflection);
    const auto power = [&f](Quantity cosine) {
        f.plain("(").symbol(cosine).plain(")").symbol(Quantity::Power);
    };
    switch (info.cosine) {
    case HighlightCosine::RV:
        return power(Quantity::RV);
    case HighlightCosine::NH:
        return power(Quantity::NH);
    case HighlightCosine::LV:
        return power(Quantity::LV);
    case HighlightCosine::None:
        break;
    }
    if (reflection != Reflection::CookTorrance) return (void)f.symbol(Quantity::Highlight);
    f.gap(2).symbol(Quantity::QuarterPi).gap(2).symbol(Quantity::Facets).symbol(Quantity::Masking);
    f.symbol(Quantity::Fresnel).plain("/").symbol(Quantity::NV);
}

}  // namespace

void formula(Reflection reflection, TransportModel transport) {
    const ReflectionInfo info = info_of(reflection);
    if (!info.is_lit) return dim_text("No lighting: the mesh's own colours.");
    TextLine f(20);
    f.symbol(Quantity::Result).plain(" = ").symbol(Quantity::MaterialEmission);
    f.together([&] {
        if (transport == TransportModel::Bounces)
            f.plain("+").symbol(Quantity::MaterialDiffuse).symbol(Quantity::Bounced);
        else
            f.plain("+").symbol(Quantity::MaterialAmbient).symbol(Quantity::GlobalAmbient);
    });
    f.together([&] {
        f.plain("+Σ").symbol(Quantity::Share);
        if (transport != TransportModel::Local) f.gap(2).symbol(Quantity::Reach).gap(2);
        f.plain("(");
        f.symbol(Quantity::MaterialAmbient).symbol(Quantity::LightAmbient);
    });
    f.together([&] {
        f.plain("+").symbol(Quantity::MaterialDiffuse).symbol(Quantity::LightDiffuse).symbol(Quantity::NL);
        if (info.rough_diffuse) f.symbol(Quantity::Rough);
        if (!info.has_highlight) f.plain(")");
    });
    if (!info.has_highlight) return;
    f.together([&] {
        f.plain("+").symbol(Quantity::MaterialSpecular).symbol(Quantity::LightSpecular);
        highlight(f, reflection);
        f.plain(")");
    });
}

}  // namespace glint
