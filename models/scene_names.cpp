#include "models/scene_names.h"

namespace glint {

std::string_view name_of(LightKind kind) {
    switch (kind) {
    case LightKind::Directional:
        return "directional";
    case LightKind::Point:
        return "point";
    case LightKind::Spot:
        return "spot";
    case LightKind::Area:
        return "area";
    }
    return {};
}

std::string_view name_of(LightSpace space) {
    switch (space) {
    case LightSpace::World:
        return "world";
    case LightSpace::Camera:
        return "camera";
    }
    return {};
}

std::string_view name_of(NormalSource source) {
    switch (source) {
    case NormalSource::Auto:
        return "auto";
    case NormalSource::File:
        return "file";
    case NormalSource::Facet:
        return "facet";
    case NormalSource::Vertex:
        return "vertex";
    case NormalSource::Analytic:
        return "analytic";
    }
    return {};
}

std::string_view name_of(NormalWeighting weighting) {
    switch (weighting) {
    case NormalWeighting::Uniform:
        return "uniform";
    case NormalWeighting::Area:
        return "area";
    case NormalWeighting::Angle:
        return "angle";
    }
    return {};
}

std::string_view name_of(ShadingMode mode) {
    switch (mode) {
    case ShadingMode::Flat:
        return "flat";
    case ShadingMode::Facet:
        return "facet";
    case ShadingMode::Gouraud:
        return "gouraud";
    case ShadingMode::Phong:
        return "phong";
    }
    return {};
}

std::string_view name_of(Reflection reflection) {
    switch (reflection) {
    case Reflection::None:
        return "none";
    case Reflection::Lambert:
        return "lambert";
    case Reflection::Phong:
        return "phong";
    case Reflection::BlinnPhong:
        return "blinn-phong";
    case Reflection::Retro:
        return "retro";
    case Reflection::OrenNayar:
        return "oren-nayar";
    case Reflection::CookTorrance:
        return "cook-torrance";
    }
    return {};
}

std::string_view name_of(Interpolation interpolation) {
    switch (interpolation) {
    case Interpolation::Perspective:
        return "perspective";
    case Interpolation::Screen:
        return "screen";
    case Interpolation::Scanline:
        return "scanline";
    }
    return {};
}

std::string_view name_of(FlatPoint point) {
    switch (point) {
    case FlatPoint::Centroid:
        return "centroid";
    case FlatPoint::Provoking:
        return "provoking";
    }
    return {};
}

std::string_view name_of(Cull cull) {
    switch (cull) {
    case Cull::None:
        return "none";
    case Cull::Back:
        return "back";
    case Cull::Front:
        return "front";
    }
    return {};
}

std::string_view name_of(Rules rules) {
    switch (rules) {
    case Rules::Lecture:
        return "lecture";
    case Rules::OpenGL2:
        return "opengl2";
    }
    return {};
}

std::string_view name_of(Transfer transfer) {
    switch (transfer) {
    case Transfer::None:
        return "none";
    case Transfer::Srgb:
        return "srgb";
    }
    return {};
}

std::string_view name_of(Primitive primitive) {
    const bool known = primitive >= Primitive::Sphere && primitive <= Primitive::TJunction;
    return known ? primitive_name(primitive) : std::string_view();
}

std::string source_name(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source)) return file->path;
    return std::string(name_of(std::get<PrimitiveMesh>(source).primitive));
}

std::string_view name_of(const Projection& projection) {
    if (std::holds_alternative<Perspective>(projection)) return "perspective";
    return std::holds_alternative<Orthographic>(projection) ? "orthographic" : "frustum";
}

}  // namespace glint
