// The table of features: to add one, add its row here.
#include <array>

#include "ui/feature.h"

namespace glint {

extern const Feature lecture_feature, wedge_feature, animation_feature, pen_feature, clean_picture_feature,
    lesson_feature, match_feature, scope_feature, prediction_feature, inspector_feature, probe_feature,
    compare_feature, debug_view_feature, lit_dots_feature, my_picture_feature, stored_scene_feature,
    export_feature, examples_feature, lesson_list_feature, quiz_feature, mistake_pictures_feature,
    term_grid_feature, sensitivity_feature, outside_feature, light_focus_feature, find_pixel_feature,
    recently_changed_feature, picture_menu_feature, orientation_feature, mesh_check_feature,
    light_setups_feature;

std::span<const Feature* const> features() {
    static constexpr std::array all{
        &lecture_feature,    // freezes the picture
        &wedge_feature,      // tests a projector
        &animation_feature,  // animates a turntable or a number
        &pen_feature,        // draws over the picture
        &clean_picture_feature, &lesson_feature,
        &match_feature,  // a game
        &scope_feature,  // intensity along a line
        &prediction_feature,
        &inspector_feature,   // the WHY column, with previews of its rows
        &probe_feature,       // the picked pixel
        &compare_feature,     // parts separated by wipe lines
        &debug_view_feature,  // a quantity in place of the picture
        &lit_dots_feature,    // marks where the equation is evaluated
        &my_picture_feature,  // diagnoses a picture from another program
        &stored_scene_feature,
        &light_focus_feature,  // solo and mute
        &find_pixel_feature,   // finds special pixels, such as the brightest
        &export_feature,        &examples_feature,         &lesson_list_feature,
        &quiz_feature,          &mistake_pictures_feature, &term_grid_feature,
        &sensitivity_feature,   &outside_feature,          &recently_changed_feature,
        &picture_menu_feature,  // opens on a right-click
        &mesh_check_feature,    &light_setups_feature,
        &orientation_feature,  // axes and grid
    };
    return all;
}

PictureNeeds picture_needs(const UiState& state) {
    PictureNeeds all;
    for (const Feature* feature : features()) {
        if (feature->needs == nullptr) continue;
        const PictureNeeds needs = feature->needs(state);
        all.linear |= needs.linear;
        all.full_size |= needs.full_size;
    }
    return all;
}

std::string why_held(const UiState& state) {
    for (const Feature* feature : features())
        if (feature->why_held != nullptr)
            if (std::string why = feature->why_held(state); !why.empty()) return why;
    return {};
}

bool is_held(const UiState& state) { return !why_held(state).empty(); }

}  // namespace glint
