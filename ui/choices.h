#pragma once
// The closed sets of the scene file, with the words that the window shows for them.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/scene.h"
#include "ui/widgets.h"

namespace glint {

template <class E> struct Choice {
    E value;
    const char* label;
    const char* word;  // in the scene file
    const char* what;
};

inline constexpr std::array mode_choices{
    Choice<ShadingMode>{ShadingMode::Flat, "Flat", "flat",
                        "One colour per polygon, lit at one point of it (key 1)"},
    Choice<ShadingMode>{ShadingMode::Facet, "Facet", "facet",
                        "Every pixel lit with the polygon's normal (key 2)"},
    Choice<ShadingMode>{ShadingMode::Gouraud, "Gouraud", "gouraud",
                        "Corners lit, their colours interpolated (key 3)"},
    Choice<ShadingMode>{ShadingMode::Phong, "Phong", "phong",
                        "Normals interpolated, every pixel lit with its own (key 4)"}};

inline constexpr std::array reflection_choices{
    Choice<Reflection>{Reflection::None, "None", "none", "No lighting: the mesh's own corner colours"},
    Choice<Reflection>{Reflection::Lambert, "Lambert", "lambert", "Diffuse only: max(n·l, 0)"},
    Choice<Reflection>{Reflection::Phong, "Phong", "phong", "Highlight max(r·v, 0) to the shininess"},
    Choice<Reflection>{Reflection::BlinnPhong, "Blinn", "blinn-phong",
                       "Highlight max(n·h, 0) to the shininess"},
    Choice<Reflection>{Reflection::Retro, "Retro", "retro",
                       "Highlight back to the light: max(l·v, 0) to the shininess"},
    Choice<Reflection>{Reflection::OrenNayar, "Oren–Nayar", "oren-nayar", "Rough diffuse, by roughness"},
    Choice<Reflection>{Reflection::CookTorrance, "Cook–Torrance", "cook-torrance",
                       "Microfacets: GGX, Schlick, by roughness and f0"}};

inline constexpr std::array interpolation_choices{
    Choice<Interpolation>{Interpolation::Perspective, "Perspective", "perspective",
                          "Correct under perspective"},
    Choice<Interpolation>{Interpolation::Screen, "Screen", "screen",
                          "Linear on the screen over each triangle"},
    Choice<Interpolation>{Interpolation::Scanline, "Scanline", "scanline",
                          "Along the polygon's edges, then along the scanline"}};

inline constexpr std::array flat_point_choices{
    Choice<FlatPoint>{FlatPoint::Centroid, "Centroid", "centroid",
                      "Mean of the polygon's corners, facet normal"},
    Choice<FlatPoint>{FlatPoint::Provoking, "Provoking", "provoking",
                      "OpenGL's: each triangle's last corner"}};

inline constexpr std::array cull_choices{
    Choice<Cull>{Cull::None, "None", "none", "Both sides are drawn"},
    Choice<Cull>{Cull::Back, "Back", "back", "Faces turned away are left out"},
    Choice<Cull>{Cull::Front, "Front", "front", "Faces turned towards us are left out"}};

inline constexpr std::array rules_choices{
    Choice<Rules>{Rules::Lecture, "Lecture", "lecture", "As the equation says"},
    Choice<Rules>{Rules::OpenGL2, "OpenGL 2", "opengl2",
                  "Fixed function's: colours clamped before interpolation"}};

inline constexpr std::array transfer_choices{
    Choice<Transfer>{Transfer::None, "None", "none", "The numbers as they are, as the lecture and OpenGL do"},
    Choice<Transfer>{Transfer::Srgb, "sRGB", "srgb", "Linear light encoded for the display"}};

inline constexpr std::array light_kind_choices{
    Choice<LightKind>{LightKind::Directional, "Directional", "directional",
                      "Parallel rays from far away, no falloff"},
    Choice<LightKind>{LightKind::Point, "Point", "point", "A bulb: the same in all directions"},
    Choice<LightKind>{LightKind::Spot, "Spot", "spot", "A bulb with a cone"},
    Choice<LightKind>{LightKind::Area, "Area", "area", "A shining parallelogram, as many point samples"}};

inline constexpr std::array space_choices{
    Choice<LightSpace>{LightSpace::World, "World", "world", "Stays with the scene"},
    Choice<LightSpace>{LightSpace::Camera, "Camera", "camera", "Rides along with the viewer"}};

inline constexpr std::array normal_source_choices{
    Choice<NormalSource>{NormalSource::Auto, "Auto", "auto", "From the file, else analytic, else averaged"},
    Choice<NormalSource>{NormalSource::File, "File", "file", "As the mesh file gives them"},
    Choice<NormalSource>{NormalSource::Facet, "Facet", "facet", "Each polygon's own"},
    Choice<NormalSource>{NormalSource::Vertex, "Vertex", "vertex",
                         "Facet normals averaged round each vertex"},
    Choice<NormalSource>{NormalSource::Analytic, "Analytic", "analytic", "From the surface's formula"}};

inline constexpr std::array weighting_choices{
    Choice<NormalWeighting>{NormalWeighting::Uniform, "Uniform", "uniform", "Every facet counts the same"},
    Choice<NormalWeighting>{NormalWeighting::Area, "Area", "area", "By the facet's area"},
    Choice<NormalWeighting>{NormalWeighting::Angle, "Angle", "angle", "By the facet's angle at the vertex"}};

template <class E, std::size_t N> std::array<Option, N> options_of(const std::array<Choice<E>, N>& choices) {
    std::array<Option, N> options;
    for (std::size_t i = 0; i < N; ++i) options[i] = {choices[i].label, choices[i].word, choices[i].what};
    return options;
}

template <class E, std::size_t N> int index_of(const std::array<Choice<E>, N>& choices, E value) {
    for (std::size_t i = 0; i < N; ++i)
        if (choices[i].value == value) return static_cast<int>(i);
    return 0;
}

/// A drop-down for one of `choices`.
template <class E, std::size_t N>
bool choice_field(const char* label, E& value, const std::array<Choice<E>, N>& choices, const Help& help) {
    const int before = index_of(choices, value);
    const int after = choose(label, before, options_of(choices), help);
    value = choices[static_cast<std::size_t>(after)].value;
    return after != before;
}

/// Joined buttons for one of `choices`, in a row with a label.
template <class E, std::size_t N>
bool segment_field(const char* label, E& value, const std::array<Choice<E>, N>& choices, const Help& help) {
    row(label);
    const int before = index_of(choices, value);
    const int after = segments(label, before, options_of(choices), help);
    value = choices[static_cast<std::size_t>(after)].value;
    return after != before;
}

}  // namespace glint
