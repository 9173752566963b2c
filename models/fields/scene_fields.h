#pragma once
// Lists every value of a scene once: its key in the scene file, its texts, its range. `fields(light, visit)`
// calls visit(row, kind, member) for each member in file order; defaults are taken from `Light{}`. Visitors
// read, write and document scenes, draw panels, find numbers to animate or to differentiate, and name the
// undo steps. A new member needs one row here, and code for its effect in the renderer. Conditions that
// involve several members are at the end of this file.

#include <fmt/core.h>

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/fields/choices.h"
#include "models/fields/field_kinds.h"
#include "models/problem.h"
#include "models/scene/mistakes.h"
#include "models/scene/scene.h"

namespace glint {

template <class T, class Struct>
concept Of = std::same_as<std::remove_const_t<T>, Struct>;

// One function per struct.

template <Of<Falloff> F, class Visit> void fields(F& f, Visit&& visit) {
    const Real share{.range = at_least_zero, .step = 0.004f, .usual_max = 2};
    visit(Row{"constant", "Constant", "c₀, the constant term"}, share, f.constant);
    visit(Row{"linear", "Linear", "c₁, multiplied by the distance"}, share, f.linear);
    visit(Row{"quadratic", "Quadratic", "c₂, multiplied by the square of the distance"}, share, f.quadratic);
}

template <Of<SpotCone> C, class Visit> void fields(C& c, Visit&& visit) {
    visit(Row{"direction", "Aim", "Direction of the cone's axis, of any length, in the light's coordinates"},
          Vector{.condition = "not zero", .step = 0.005f}, c.direction);
    visit(Row{"cutoff_deg", "Cutoff", "Angle from the axis to the edge of the cone; 180: no cone"},
          Real{.range = {0, 90, "0 to 90, or 180", false, false, 180},
               .unit = "°",
               .step = 0.1f,
               .format = "%.1f°",
               .usual_max = 90},
          c.cutoff_deg);
    visit(Row{"exponent", "Exponent",
              "Power of cos(angle from the axis): 0 is uniform, larger values fade towards the edge"},
          Real{.range = at_least_zero, .step = 0.02f, .format = "%.2f", .usual_max = 64, .logarithmic = true},
          c.exponent);
    visit(Row{"inner_deg", "Inner",
              "Angle from the axis at which the soft edge begins; at or beyond the cutoff: no soft edge"}
              .omitted_by_default(),
          Real{.range = {0, 90, "0 to 90, or 180", false, false, 180},
               .unit = "°",
               .step = 0.1f,
               .format = "%.1f°",
               .usual_max = 90},
          c.inner_deg);
}

constexpr bool is_square(int n) {
    for (int side = 1; side * side <= n; ++side)
        if (side * side == n) return true;
    return false;
}

template <Of<AreaShape> A, class Visit> void fields(A& a, Visit&& visit) {
    const Vector edge{.condition = "neither zero nor parallel to the other", .step = 0.005f};
    visit(Row{"edge_u", "Edge u", "Half of an edge of the parallelogram, in the light's coordinates"}, edge,
          a.edge_u);
    visit(Row{"edge_v", "Edge v", "Half of an edge of the parallelogram, in the light's coordinates"}, edge,
          a.edge_v);
    visit(Row{"samples", "Samples", "Points that represent the area, at the centres of n × n equal cells"},
          Count{1, 64, is_square, "1, 4, 9, 16, 25, 36, 49 or 64"}, a.samples);
}

template <Of<Light> L, class Visit> void fields(L& l, Visit&& visit) {
    visit(Row{"name", "Name", "Name of the light"}.undone_as("Rename {}"), Text{max_name_characters}, l.name);
    visit(Row{"type", "Type", "Kind of light"}.undone_as("Type of {}"), OneOf{}, l.kind);
    visit(Row{"space", "Space", "Coordinate system of its position, direction and edges"}, OneOf{}, l.space);
    visit(Row{"position", l.kind == LightKind::Directional ? "Comes from" : "Position",
              "Homogeneous: the direction towards the light if w = 0, a position divided by w if w > 0"},
          Homogeneous{l.kind}, l.position);
    visit(Row{"ambient", "Ambient", "Colour for the ambient term"}.undone_as("Colour of {}"), Colour{},
          l.ambient);
    visit(Row{"diffuse", "Diffuse", "Colour for the diffuse term"}.undone_as("Colour of {}"), Colour{},
          l.diffuse);
    visit(Row{"specular", "Specular", "Colour for the highlight"}.undone_as("Colour of {}"), Colour{},
          l.specular);
    visit(Row{"intensity", "Intensity", "Multiplies the light's three colours"}.undone_as("Brightness of {}"),
          Real{.range = at_least_zero, .step = 0.005f, .usual_max = 4}, l.intensity);
    visit(Row{"enabled", "On", "Whether the light is on"}, Switch{}, l.enabled);
    visit(Row{"falloff", "Falloff  1 / (c₀ + c₁ dist + c₂ dist²)",
              "Divides the light that arrives at distance dist"}
              .undone_as("Falloff of {}")
              .when(l.kind == LightKind::Point || l.kind == LightKind::Spot),
          Group{}, l.falloff);
    visit(Row{"spot", "Cone",
              "cos(angle from the axis)^exponent inside the cutoff, 0 outside; softer beyond the inner angle"}
              .undone_as("Cone of {}")
              .when(l.kind == LightKind::Spot),
          Group{}, l.spot);
    visit(Row{"area", "Area", "A parallelogram centred on the position that emits light from both sides"}
              .undone_as("Area of {}")
              .when(l.kind == LightKind::Area),
          Group{}, l.area);
}

/// Visits the fields that every mesh has.
template <class M, class Visit> void resolution_fields(M& m, Visit&& visit) {
    visit(Row{"decimate", "Decimate", "Maximum number of triangles, by quadric error decimation; 0: no limit"}
              .omitted_by_default(),
          Count{.low = 0, .high = max_faces_wanted, .zero = "all"}, m.decimate);
    visit(Row{"subdivide", "Subdivide",
              "Subdivision steps after decimation: Loop if all faces are triangles, else Catmull–Clark"}
              .omitted_by_default(),
          Count{0, max_subdivisions}, m.subdivide);
}

template <Of<MeshFile> M, class Visit> void fields(M& m, Visit&& visit) {
    visit(Row{"file", "File",
              "Path of a mesh file, relative to the scene file; a byte that is not UTF-8 is written as "
              "U+EF00 + byte"},
          Path{}, m.path);
    visit(Row{"part", "Part", "Index of the mesh in a file that has several; in glTF, of the primitive"}
              .omitted_by_default(),
          Count{0, max_parts - 1}, m.part);
    resolution_fields(m, visit);
}

template <Of<PrimitiveMesh> M, class Visit> void fields(M& m, Visit&& visit) {
    visit(Row{"primitive", "Mesh", "A shape that needs no file"}, OneOf{}, m.primitive);
    visit(Row{"detail", "Detail", "Tessellation of the shape"}, Count{1, info_of(m.primitive).max_detail},
          m.detail);
    resolution_fields(m, visit);
}

template <Of<Transform> T, class Visit> void fields(T& t, Visit&& visit) {
    visit(Row{"translate", "Move", "Position of its origin in world coordinates"}.undone_as("Move {}"),
          Vector{}, t.translate);
    visit(Row{"rotate_deg", "Rotate", "About x, then y, then z"}.undone_as("Rotate {}"),
          Vector{.unit = "°", .step = 0.5f, .format = "%.1f"}, t.rotate_deg);
    visit(Row{"scale", "Scale", "Along its own axes, before rotation; negative values mirror"}.undone_as(
              "Scale {}"),
          Vector{.condition = "none is 0"}, t.scale);
}

/// An angle from 0 to 180 degrees.
inline constexpr Real angle_field{
    .range = half_turn_deg, .unit = "°", .step = 0.3f, .format = "%.1f°", .usual_max = 180};

template <Of<NormalOptions> N, class Visit> void fields(N& n, Visit&& visit) {
    visit(Row{"source", "Source", "Source of the corners' normals"}, OneOf{}, n.source);
    visit(Row{"weighting", "Weights", "Weight of each facet when normals are averaged"}, OneOf{},
          n.weighting);
    visit(Row{"crease_deg", "Crease",
              "Facets that meet at a larger angle are not averaged across their edge; 180 averages all"},
          angle_field, n.crease_deg);
    visit(Row{"flip", "Flip normals", "Reverses all normals, for a mesh whose faces are wound the wrong way"}
              .omitted_by_default(),
          Switch{}, n.flip);
}

template <Of<Material> M, class Visit> void fields(M& m, Visit&& visit) {
    visit(Row{"ambient", "Ambient", "k_a: fraction of ambient light reflected"}, Colour{}, m.ambient);
    visit(Row{"diffuse", "Diffuse", "k_d: fraction reflected evenly in all directions"}, Colour{}, m.diffuse);
    visit(Row{"specular", "Specular", "k_s: fraction reflected into the highlight"}, Colour{}, m.specular);
    visit(Row{"emission", "Emission", "Light that the surface emits"}, Colour{}, m.emission);
    visit(
        Row{"shininess", "Shininess", "Exponent of the highlight: larger values make it smaller and sharper"},
        Real{.range = {0, 10'000, "0 to 10000"}, .format = "%.1f", .usual_max = 1000, .logarithmic = true},
        m.shininess);
    visit(Row{"roughness", "Roughness", "0 smooth, 1 rough; Oren–Nayar and Cook–Torrance"},
          Real{.range = zero_to_one, .step = 0.004f, .format = "%.2f", .usual_max = 1}, m.roughness);
    visit(Row{"f0", "F0", "Reflectance at normal incidence; Cook–Torrance"}, Colour{}, m.f0);
    visit(Row{"reflection", "Reflection", "Reflection model to use instead of the scene's"}
              .omitted_by_default(),
          OneOf{}, m.reflection);
}

template <Of<Object> O, class Visit> void fields(O& o, Visit&& visit) {
    visit(Row{"name", "Name", "Name of the object"}.undone_as("Rename {}"), Text{max_name_characters},
          o.name);
    visit(Row{"visible", "Shown", "Whether the object is drawn"}.omitted_by_default(), Switch{}, o.visible);
    visit(Row{"double_sided", "Both sides", "Its back faces are drawn even if `cull` is set"}
              .omitted_by_default(),
          Switch{}, o.double_sided);
    visit(Row{"mesh", "Mesh", "The shape: a primitive, or a file"}.undone_as("Mesh of {}"), OneMesh{},
          o.source);
    visit(
        Row{"transform", "Transform", "From object to world coordinates: scale, then rotate, then translate"}
            .undone_as("Transform {}"),
        Group{}, o.transform);
    visit(Row{"normals", "Normals", "Normals of the corners"}.undone_as("Normals of {}"), Group{}, o.normals);
    visit(Row{"material", "Material", "How the surface reflects light"}
              .undone_as("Material of {}")
              .of_lighting(),
          Group{}, o.material);
}

/// Visits near and far, which every projection has.
template <class P, class Visit> void depth_fields(P& p, Visit&& visit) {
    const Real depth{.range = above_zero, .logarithmic = true};
    visit(Row{"near", "Near", "Distance of the near clipping plane; less than far"}, depth, p.near);
    visit(Row{"far", "Far", "Distance of the far clipping plane"}, depth, p.far);
}

template <Of<Perspective> P, class Visit> void fields(P& p, Visit&& visit) {
    visit(Row{"fov_y_deg", "View angle", "Full vertical angle of view"},
          Real{.range = {0, 180, "more than 0, less than 180", true, true},
               .unit = "°",
               .step = 0.2f,
               .format = "%.1f°",
               .usual_max = 179},
          p.fov_y_deg);
    depth_fields(p, visit);
}

template <Of<Orthographic> O, class Visit> void fields(O& o, Visit&& visit) {
    visit(Row{"height", "Height", "Height of the view in scene units"},
          Real{.range = above_zero, .logarithmic = true}, o.height);
    depth_fields(o, visit);
}

template <Of<Frustum> F, class Visit> void fields(F& f, Visit&& visit) {
    const Real edge{.step = 0.001f, .format = "%.4f"};
    visit(Row{"left", "Left", "Edge of the window on the near plane; must differ from right"}, edge, f.left);
    visit(Row{"right", "Right", "Edge of the window on the near plane"}, edge, f.right);
    visit(Row{"bottom", "Bottom", "Edge of the window on the near plane; must differ from top"}, edge,
          f.bottom);
    visit(Row{"top", "Top", "Edge of the window on the near plane"}, edge, f.top);
    depth_fields(f, visit);
}

template <Of<Camera> C, class Visit> void fields(C& c, Visit&& visit) {
    visit(Row{"eye", "Eye", "Position of the eye in world coordinates"},
          Vector{.condition = "not target", .step = 0.02f}, c.eye);
    visit(Row{"target", "Target", "Point at the centre of the picture, in world coordinates"},
          Vector{.step = 0.02f}, c.target);
    visit(Row{"up", "Up", "Direction that is up in the picture, in world coordinates"},
          Vector{.condition = "not along the viewing direction", .step = 0.02f}, c.up);
    visit(Row{"projection", "Projection", "How the view volume is projected"}, OneProjection{}, c.projection);
}

template <Of<Terms> T, class Visit> void fields(T& t, Visit&& visit) {
    visit(Row{"emission", "Emission", "Light that the surface emits"}, Switch{}, t.emission);
    visit(Row{"ambient", "Ambient", "Global ambient light, and the ambient light of each light"}, Switch{},
          t.ambient);
    visit(Row{"diffuse", "Diffuse", "Light reflected evenly"}, Switch{}, t.diffuse);
    visit(Row{"specular", "Specular", "The highlight"}, Switch{}, t.specular);
}

template <Of<Mistakes> M, class Visit> void fields(M& m, Visit&& visit) {
    for (const MistakeName& mistake : mistake_names())
        visit(Row{mistake.name, mistake.name.data(), mistake.what.data()}.omitted_by_default(), Switch{},
              m.*mistake.flag);
    visit(Row{"form", "Form", "Form of the mistake if it has several, counted from 0"}.omitted_by_default(),
          Count{0, axes_forms - 1}, m.form);
    visit(Row{"highlight_form", "Highlight", "Form of highlight_normalized, counted from 0"}
              .omitted_by_default(),
          Count{0, 3}, m.highlight_form);
    const Count index_or_all{-1, 1'000'000};
    visit(Row{"only_light", "Only light", "Mistakes are made for this light only; -1: for all"}
              .omitted_by_default(),
          index_or_all, m.only.light);
    visit(Row{"only_lights", "Only lights", "Mistakes are made for lights of this type only"}
              .omitted_by_default(),
          OneOf{}, m.only.lights);
    visit(Row{"only_object", "Only object", "Mistakes are made on this object only; -1: on all"}
              .omitted_by_default(),
          index_or_all, m.only.object);
    visit(Row{"only_term", "Only term", "Mistakes are made in this term only"}.omitted_by_default(), OneOf{},
          m.only.term);
}

constexpr bool is_table_size(int entries) { return entries != 1; }

template <Of<Shading> S, class Visit> void fields(S& s, Visit&& visit) {
    visit(Row{"mode", "Mode", "Where the lighting equation is evaluated"}.undone_as("Shading mode"), OneOf{},
          s.mode);
    visit(Row{"reflection", "Reflection", "How a surface reflects light"}.undone_as("Reflection"), OneOf{},
          s.reflection);
    visit(Row{"interpolation", "Interpolate", "How values are interpolated between corners"}, OneOf{},
          s.interpolation);
    visit(Row{"flat_point", "Flat lit at", "Point of a polygon that is lit in flat mode"}, OneOf{},
          s.flat_point);
    visit(Row{"two_sided", "Two-sided", "Reverses the normals of faces that are seen from behind"}, Switch{},
          s.two_sided);
    visit(Row{"local_viewer", "Local view",
              "v points to the eye; off: v = (0, 0, 1) in camera coordinates, as for a distant viewer"},
          Switch{}, s.local_viewer);
    visit(Row{"cull", "Cull",
              "Faces that are left out, by their winding on the screen (reversed for a mirrored object)"},
          OneOf{}, s.cull);
    visit(Row{"rules", "Rules of", "Rules of the lighting equation"}, OneOf{}, s.rules);
    visit(Row{"terms", "Terms of the equation", "Off: the term is left out of the sum"}.undone_as("Terms"),
          Group{}, s.terms);
    visit(Row{"power_table", "cosˢ table",
              "Size of a lookup table of cosˢ, evenly spaced for cosines 0 to 1, nearest entry used; 0: "
              "computed"}
              .omitted_by_default(),
          Count{0, 65536, is_table_size, "0, or 2 to 65536 entries", "computed"}, s.power_table);
    visit(Row{"mistakes", "Mistakes", "Mistakes made on purpose, to see what they look like"}.undone_as(
              "Mistakes"),
          Group{}, s.mistakes);
}

template <Of<Transport> T, class Visit> void fields(T& t, Visit&& visit) {
    const bool bounces = t.model == TransportModel::Bounces;
    visit(Row{"model", "Light paths", "How light reaches a point"}.of_lighting(), OneOf{}, t.model);
    visit(Row{"paths", "Paths", "Random paths per lit point; four times as many halve the noise"}
              .of_lighting()
              .when(bounces),
          Count{1, 65536}, t.paths);
    visit(
        Row{"bounces", "Bounces", "Maximum number of surfaces that a path meets"}.of_lighting().when(bounces),
        Count{0, 64}, t.bounces);
    visit(Row{"seed", "Seed", "A different seed gives different random numbers"}.of_lighting().when(bounces),
          Count{0, 1'000'000}, t.seed);
}

template <Of<Npr> N, class Visit> void fields(N& n, Visit&& visit) {
    const Real share{.step = 0.004f, .format = "%.2f", .usual_max = 1};
    visit(Row{"cool_to_warm", "Cool to warm",
              "k_w (warm + beta k_d) + (1 − k_w) (cool + alpha k_d), k_w = (1 + n·l)/2 of the first enabled "
              "light, replacing emission, ambient and diffuse"},
          Switch{}, n.cool_to_warm);
    visit(Row{"cool", "Cool", "Tone of surfaces that face away from the light"}.when(n.cool_to_warm),
          Colour{}, n.cool);
    visit(Row{"warm", "Warm", "Tone of surfaces that face the light"}.when(n.cool_to_warm), Colour{}, n.warm);
    visit(Row{"alpha", "Alpha", "Fraction of k_d mixed into the cool tone"}.when(n.cool_to_warm), share,
          n.alpha);
    visit(Row{"beta", "Beta", "Fraction of k_d mixed into the warm tone"}.when(n.cool_to_warm), share,
          n.beta);
    visit(Row{"silhouettes", "Silhouettes",
              "Strokes along edges between a front facet and a back facet, (e·n₀)(e·n₁) ≤ 0, and along "
              "boundary edges"},
          Switch{}, n.silhouettes);
    visit(Row{"creases", "Creases",
              "Strokes along edges whose facets' normals differ by the crease angle or more"},
          Switch{}, n.creases);
    visit(Row{"crease_deg", "Crease at",
              "Smallest angle between the normals of two facets that makes their edge a crease"}
              .when(n.creases),
          angle_field, n.crease_deg);
    visit(Row{"stroke", "Stroke", "Colour of the strokes"}.when(n.silhouettes || n.creases), Colour{},
          n.stroke);
    visit(Row{"stroke_width_px", "Width", "Width of the strokes in pixels; at most 100"}.when(n.silhouettes ||
                                                                                              n.creases),
          Real{.range = at_least_zero, .unit = "pixels", .step = 0.02f, .format = "%.1f px", .usual_max = 10},
          n.stroke_width_px);
}

template <Of<Display> D, class Visit> void fields(D& d, Visit&& visit) {
    visit(Row{"background", "Background", "Colour of pixels without an object"}, Colour{}, d.background);
    visit(Row{"transfer", "Encoding", "How linear light is encoded for the display (gamma)"}, OneOf{},
          d.transfer);
    visit(Row{"exposure", "Exposure", "Multiplies the linear colour before display"},
          Real{.range = above_zero, .logarithmic = true}, d.exposure);
}

template <Of<Scene> S, class Visit> void fields(S& s, Visit&& visit) {
    visit(Row{"about", "About", "One line: what to look at in the scene, and what to try"}
              .undone_as("Caption")
              .of_lighting()
              .omitted_by_default(),
          Text{}, s.about);
    visit(Row{"camera", "Camera", "The eye and its projection"}.undone_as("Camera"), Group{}, s.camera);
    visit(Row{"global_ambient", "Ambient", "Light from all directions, independent of the lights"}
              .undone_as("Global ambient")
              .of_lighting(),
          Colour{}, s.global_ambient);
    visit(Row{"lights", "Lights", "The light sources"}.undone_as("Edit lights").of_lighting(),
          List{max_lights, "lights"}, s.lights);
    visit(Row{"objects", "Objects", "The lit objects"}.undone_as("Edit objects"),
          List{max_objects, "objects"}, s.objects);
    visit(Row{"shading", "Shading", "How points are lit and how the lit points fill the picture"}.undone_as(
              "Shading"),
          Group{}, s.shading);
    visit(Row{"transport", "Light paths", "Shadows, and light from other surfaces"}
              .undone_as("Light paths")
              .of_lighting()
              .omitted_by_default(),
          Group{}, s.transport);
    visit(Row{"npr", "Strokes and tones", "Non-photorealistic: cool-to-warm tones, silhouettes, creases"}
              .undone_as("Strokes and tones"),
          Group{}, s.npr);
    visit(Row{"display", "Display", "From linear light to bytes"}.undone_as("Display").of_lighting(), Group{},
          s.display);
}

/// Visits the fields of the projection that the variant holds.
template <Of<Projection> P, class Visit> void fields(P& projection, Visit&& visit) {
    std::visit([&](auto& p) { fields(p, visit); }, projection);
}

/// Visits the fields of the mesh source that the variant holds.
template <Of<MeshSource> M, class Visit> void fields(M& source, Visit&& visit) {
    std::visit([&](auto& s) { fields(s, visit); }, source);
}

/// Visits the fields of `value`, each with its default: visit(row, kind, member, initial).
template <class T, class Visit> void fields_with_defaults(T& value, Visit&& visit) {
    static const std::remove_const_t<T> defaults{};
    std::vector<const void*> initial;  // members of `defaults`, in the order of the fields
    fields(defaults, [&](const Row&, const auto&, const auto& member) { initial.push_back(&member); });
    std::size_t i = 0;
    fields(value, [&]<class Kind, class Member>(const Row& row, const Kind& kind, Member& member) {
        visit(row, kind, member, *static_cast<const std::remove_const_t<Member>*>(initial[i++]));
    });
}

/// The kind of a single number in a triple: a channel of a colour or a component of a vector.
inline constexpr Real channel_field{.range = at_least_zero, .step = 0.004f, .format = "%.2f"};
[[nodiscard]] constexpr Real component_of(const Colour&) { return channel_field; }
[[nodiscard]] constexpr Real component_of(const Vector& v) {
    return {.unit = v.unit, .step = v.step, .format = v.format};
}
[[nodiscard]] constexpr Real component_of(const Homogeneous& h) {
    return {.step = h.is_direction() ? 0.005f : 0.01f, .format = "%.2f"};
}

// Lists every number of a scene by its JSON pointer, to animate it, to differentiate a pixel with respect to
// it, or to drag it in the equation. No other code enumerates numbers.

/// One number of a scene.
struct SceneNumber {
    std::string pointer;  // RFC 6901: "/lights/0/falloff/linear", "/camera/eye/2"
    std::string words;    // its description, without the item it belongs to: "view angle", "diffuse red"
    double value = 0;     // the current value
    double initial = 0;   // its default
    Real kind;            // range, unit, step; for a count, only its range
    std::optional<Count> count;  // for a count: samples, the detail of a shape
    const char* help = "";       // the help of its field
    bool moves_faces = true;     // false: it affects how a pixel is lit, but never which face is visible
    bool applies = true;  // false: it has no effect now, such as the cone of a light that is not a spot
    bool is_w = false;    // w of a position; the position is divided by it at once, so an input field would
                          // lose the typed value
    float* place = nullptr;  // its address, valid until the scene's lists change; null for a count and for a
                             // const scene
};

/// Lists all numbers in the order of the scene file.
[[nodiscard]] std::vector<SceneNumber> numbers_of(const Scene& scene);

/// The number at that pointer, if there is one.
[[nodiscard]] std::optional<SceneNumber> number_at(Scene& scene, const std::string& pointer);
[[nodiscard]] std::optional<SceneNumber> number_at(const Scene& scene, const std::string& pointer);

/// Sets the number at `pointer`, like `--set`: a light's position is divided by a new w, and an object whose
/// detail changes loses its mesh (load_meshes makes a new one). If the number does not exist, or the value is
/// out of range or breaks a condition below, the scene stays unchanged and the function returns a problem
/// without a file.
[[nodiscard]] std::optional<Problem> set_number(Scene& scene, const std::string& pointer, double value);

/// Returns SceneNumber::words of the number at `pointer`; for a vector, the same without the component
/// ("eye"); for any other pointer, its keys.
[[nodiscard]] std::string words_of_pointer(const Scene& scene, const std::string& pointer);

// Conditions that involve several numbers of a scene, which no single field can express. The reader rejects a
// scene that breaks them and the window never creates one, so every saved scene can be opened again
// (docs/scene_file.md).

// A violation is a Problem without a file. Its pointer is relative to the value: "/spot/direction", empty for
// the value itself.

template <class Number> [[nodiscard]] Problem out_of_range(Number number, std::string expected) {
    return {"", "", fmt::format("{} is out of range", number), std::move(expected)};
}

/// Directions count as parallel if the sine of the angle between them is below this: a float has seven
/// digits.
inline constexpr double parallel_sine = 1e-6;

/// Requires that eye and target differ, `up` is not parallel to the viewing direction, 0 < near < far, and
/// the frustum's window has a non-zero area.
[[nodiscard]] std::optional<Problem> violation_of(const Camera& camera);
/// Requires that direction, axis and area are non-zero, and that at least one falloff factor is above 0.
[[nodiscard]] std::optional<Problem> violation_of(const Light& light);
/// Requires w = 0 for a directional light and w > 0 for a light with a position.
[[nodiscard]] std::optional<Problem> violation_of_w(LightKind kind, double w);
/// Requires that the position divided by its w is within the range of positions.
[[nodiscard]] std::optional<Problem> violation_of_division(const glm::dvec4& position);
/// Requires that no component of the scale is zero.
[[nodiscard]] std::optional<Problem> violation_of(const Object& object);
/// Returns the first violation in the camera, the lights and the objects, with the pointer into the scene.
[[nodiscard]] std::optional<Problem> violation_of(const Scene& scene);

/// Returns the first number outside the range of its field. For a scene, it checks the scene's own numbers,
/// not its lights and objects.
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Camera& camera);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Light& light);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Object& object);
[[nodiscard]] std::optional<Problem> violation_of_ranges(const Scene& scene);

/// Returns the condition or range that keeps a scene file from representing `now`, or nullopt if a file can
/// represent it. `valid` is a scene that a file can represent, so only lights and objects that differ from
/// those of `valid` are checked.
[[nodiscard]] std::optional<Problem> violation_since(const Scene& valid, const Scene& now);

/// Returns a light's homogeneous position for the renderer: unchanged if w = 0, else divided by w, so that w
/// = 1.
[[nodiscard]] glm::vec4 divided_by_w(glm::dvec4 position);

}  // namespace glint
