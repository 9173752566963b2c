#pragma once
// The catalogue of mistakes: the name of each in the scene file (`/shading/mistakes/NAME`), what the wrong
// program does, how to recognize it, and where people have asked about it.

#include <span>
#include <string>
#include <string_view>

#include "models/scene/shading.h"

namespace glint {

/// The step of drawing that a mistake changes. To find its code, search for its flag: `git grep -w NAME
/// renderer`.
enum class MistakeStage { Equation, Viewer, Lights, Materials, Normals, Faces, Display };

/// The first visible symptom.
enum class SeenAs {
    MovesWithCamera,
    WrongSide,
    WrongFaces,
    WrongBrightness,
    WrongHighlight,
    WrongReach,  // a lamp's cone or falloff is wrong
    SpotsAndHoles
};
/// Lists show these groups in this order, and within a group the order of struct Mistakes.
inline constexpr SeenAs all_seen_as[] = {SeenAs::MovesWithCamera, SeenAs::WrongSide,      SeenAs::WrongFaces,
                                         SeenAs::WrongBrightness, SeenAs::WrongHighlight, SeenAs::WrongReach,
                                         SeenAs::SpotsAndHoles};
/// The heading of a group: "Light moves with the camera".
[[nodiscard]] std::string_view heading_of(SeenAs seen_as);

struct MistakeName {
    std::string_view name;
    bool Mistakes::*flag;
    MistakeStage stage;
    SeenAs seen_as;
    std::string_view what;         // the behaviour of the wrong program: for tooltips and documents
    std::string_view looks;        // how to recognize it in a picture
    std::string_view look_alikes;  // names of mistakes that look similar, separated by spaces
    std::string_view sources;      // discussions of the mistake, separated by "; "; may be empty
    std::string_view forms = {};   // names of its forms, separated by "|"; empty if there is only one
};

/// All mistakes, in the order of struct Mistakes.
[[nodiscard]] std::span<const MistakeName> mistake_names();
/// The index of a switch in mistake_names().
[[nodiscard]] std::size_t mistake_index(bool Mistakes::*flag);

/// The number of forms of a mistake, at least 1, and the name of one of them; empty if it has only one.
[[nodiscard]] int form_count(const MistakeName& mistake);
[[nodiscard]] std::string form_words(const MistakeName& mistake, int form);

/// A form of normals_axes_exchanged: a permutation of the axes with signs. All but the identity exist.
struct AxesForm {
    int from[3];  // the source of each component
    int sign[3];  // 1 or -1
};
inline constexpr int axes_forms = 47;
[[nodiscard]] AxesForm axes_form(int form);

}  // namespace glint
