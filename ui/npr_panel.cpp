#include "ui/npr_panel.h"

#include <imgui.h>

#include "ui/widgets.h"

namespace glint {
namespace {

/// Draws `fields` dimmed while they change nothing.
template <class Fields> bool dimmed(bool unused, const Fields& fields) {
    if (unused) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
    const bool edited = fields();
    if (unused) ImGui::PopStyleVar();
    return edited;
}

bool tone_fields(Npr& npr) {
    const Npr initial;
    const Number share{.min = 0, .initial = initial.alpha, .speed = 0.004f, .format = "%.2f", .shown_max = 1};
    Number warm_share = share;
    warm_share.initial = initial.beta;
    bool edited = false;
    edited |= colour_field("Cool", npr.cool, initial.cool,
                           {"Tone of what is turned away from the light", "/npr/cool"});
    edited |=
        colour_field("Warm", npr.warm, initial.warm, {"Tone of what is turned to the light", "/npr/warm"});
    edited |=
        number_field("Alpha", npr.alpha, share, {"Share of k_d mixed into the cool tone", "/npr/alpha"});
    edited |=
        number_field("Beta", npr.beta, warm_share, {"Share of k_d mixed into the warm tone", "/npr/beta"});
    return edited;
}

bool stroke_fields(Npr& npr) {
    const Npr initial;
    bool edited = false;
    edited |= colour_field("Stroke", npr.stroke, initial.stroke, {"Colour of the strokes", "/npr/stroke"});
    edited |= number_field("Width", npr.stroke_width_px,
                           {.min = 0,
                            .max = 100,
                            .initial = initial.stroke_width_px,
                            .speed = 0.02f,
                            .format = "%.1f px",
                            .unit = "pixels",
                            .shown_max = 10},
                           {"Of the strokes, in pixels of the picture", "/npr/stroke_width_px"});
    return edited;
}

}  // namespace

bool npr_panel(Npr& npr) {
    const Npr initial;
    bool edited = false;
    section("Cool to warm");
    edited |=
        switch_field("Tones", npr.cool_to_warm,
                     {"k_w = (1 + n·l)/2 mixes a warm and a cool tone, in place of emission, ambient and "
                      "diffuse; l of the first light that is on",
                      "/npr/cool_to_warm"});
    edited |= dimmed(!npr.cool_to_warm, [&] { return tone_fields(npr); });
    section("Strokes");
    edited |= switch_field("Silhouettes", npr.silhouettes,
                           {"Edges between a face seen from before and one seen from behind, and open edges",
                            "/npr/silhouettes"});
    edited |= switch_field("Creases", npr.creases,
                           {"Edges at which two faces meet at more than the angle below", "/npr/creases"});
    edited |= dimmed(!npr.creases, [&] {
        return number_field(
            "Crease at", npr.crease_deg,
            {.min = 0,
             .max = 180,
             .initial = initial.crease_deg,
             .speed = 0.2f,
             .format = "%.1f°",
             .unit = "°",
             .shown_max = 180},
            {"Angle between the normals of two faces above which their edge is drawn", "/npr/crease_deg"});
    });
    edited |= dimmed(!npr.silhouettes && !npr.creases, [&] { return stroke_fields(npr); });
    return edited;
}

}  // namespace glint
