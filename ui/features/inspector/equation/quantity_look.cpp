#include "ui/features/inspector/equation/quantity_look.h"

namespace glint {

Symbol colour_of(Quantity quantity) {
    switch (quantity) {
    case Quantity::EmissionTerm:
    case Quantity::MaterialEmission:
        return Symbol::Emission;
    case Quantity::AmbientTerm:
    case Quantity::BouncedTerm:
    case Quantity::MaterialAmbient:
    case Quantity::GlobalAmbient:
    case Quantity::LightAmbient:
        return Symbol::Ambient;
    case Quantity::DiffuseTerm:
    case Quantity::MaterialDiffuse:
    case Quantity::LightDiffuse:
    case Quantity::Rough:
        return Symbol::Diffuse;
    case Quantity::SpecularTerm:
    case Quantity::MaterialSpecular:
    case Quantity::LightSpecular:
    case Quantity::Power:
    case Quantity::Highlight:
    case Quantity::QuarterPi:
    case Quantity::Facets:
    case Quantity::Masking:
    case Quantity::Fresnel:
        return Symbol::Specular;
    case Quantity::N:
    case Quantity::NL:
    case Quantity::NH:
    case Quantity::NV:
        return Symbol::N;
    case Quantity::L:
    case Quantity::LV:
        return Symbol::L;
    case Quantity::V:
        return Symbol::V;
    case Quantity::R:
    case Quantity::RV:
        return Symbol::R;
    case Quantity::H:
        return Symbol::H;
    default:
        return Symbol::Construction;
    }
}

std::pair<Quantity, Quantity> vectors_of(Quantity cosine) {
    if (cosine == Quantity::RV) return {Quantity::R, Quantity::V};
    if (cosine == Quantity::NH) return {Quantity::N, Quantity::H};
    if (cosine == Quantity::LV) return {Quantity::L, Quantity::V};
    if (cosine == Quantity::NV) return {Quantity::N, Quantity::V};
    return {Quantity::N, Quantity::L};
}

}  // namespace glint
