#pragma once
// An explanation of a picture: conventions of its program, and one edit of the scene. The lists of edits and
// conventions here are the only ones: the search, the reports, the window and the tables read them.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/scene/scene.h"

namespace glint {

/// The mistakes that are made together: none, one, or two. Indices into mistake_names(), ascending.
using MistakeSet = std::vector<std::size_t>;
/// The scene under these mistakes and no others.
[[nodiscard]] Scene under_mistakes(Scene scene, const MistakeSet& mistakes);
/// "unnormalized_light", "a + b"; "right" for none.
[[nodiscard]] std::string name_of(const MistakeSet& mistakes);

/// In order of belief: the first is believed most easily.
enum class ExplanationKind { Right, LeftOut, Setting, Mistake, Number };

/// A tone curve: maps every brightness to 0..1 before encoding.
enum class ToneCurve { None, Reinhard, ReinhardLuminance, Exponential, Aces, Hable };
inline constexpr ToneCurve all_tones[] = {ToneCurve::Reinhard, ToneCurve::ReinhardLuminance,
                                          ToneCurve::Exponential, ToneCurve::Aces, ToneCurve::Hable};
[[nodiscard]] std::string_view tone_name(ToneCurve tone);
[[nodiscard]] glm::vec3 toned(ToneCurve tone, glm::vec3 linear);

using SceneEdit = std::function<void(Scene&)>;

struct Supposition {
    ExplanationKind kind = ExplanationKind::Right;
    std::string name = "right";
    std::string words;             // a sentence: what the program does
    std::vector<std::string> set;  // the --set options that draw it
    MistakeSet mistakes;           // empty unless kind is Mistake
    MistakeScope only;
    std::vector<std::string> conventions, convention_set;
    ToneCurve tone = ToneCurve::None;
    double belief = 0;  // the cost of believing it; an edit that costs 1 more must halve the remaining error
    std::vector<SceneEdit> edits, convention_edits;

    /// Return the scene with the conventions alone, and with conventions and edit; they ignore `only`.
    [[nodiscard]] Scene program(const Scene& right) const;
    [[nodiscard]] Scene applied(const Scene& right) const;
    /// Whether the explanation is this mistake, alone or together with others.
    [[nodiscard]] bool makes(bool Mistakes::*flag) const;
    /// Whether the explanation is normals_axes_exchanged, which has very many forms.
    [[nodiscard]] bool is_axes_form() const;
};

/// A difference between programs that is not a mistake.
struct Convention {
    std::string name;
    std::string words;
    std::vector<std::string> set;
    SceneEdit edit;
    double cost = 0.3;  // of believing that the program follows it; 0 if the user declared it
};
/// A convention as a user declares it; it may select several of conventions_of().
struct ConventionName {
    std::string_view name, label, words;
};
[[nodiscard]] std::span<const ConventionName> convention_names();
[[nodiscard]] std::vector<Convention> conventions_of(const Scene& scene);
[[nodiscard]] Supposition with_convention(Supposition explanation, const Convention& convention);

/// Every missing term or light, every other setting, and every mistake in all its forms.
[[nodiscard]] std::vector<Supposition> left_out_edits(const Scene& scene);
[[nodiscard]] std::vector<Supposition> setting_edits(const Scene& scene);
[[nodiscard]] std::vector<Supposition> mistake_edits();
[[nodiscard]] Supposition mistake_edit(std::size_t mistake, int form);
/// Reverses the lights of all kinds together. Empty for a scene with one kind of light.
[[nodiscard]] std::vector<Supposition> all_lights_reversed(const Scene& scene);
[[nodiscard]] Supposition pair_of(const Supposition& a, const Supposition& b);

/// The same mistake for one light, one kind of light, one object, one term, or one term of one light.
[[nodiscard]] std::vector<Supposition> restricted(const Supposition& mistake, const Scene& scene);
/// "for Bulb", "in the diffuse term".
[[nodiscard]] std::string words_of(const MistakeScope& only, const Scene& scene);

/// A number of the scene that a program may have set to a different value.
struct FreeNumber {
    static constexpr int all_three = -1;
    std::string pointer;           // to the JSON value that contains it
    int size = 1;                  // how many numbers that value contains
    float least = 0, most = 1e6f;  // its range
    int object = -1;               // the only object that the number changes; -1: any
    int component = 0;       // which number of the value; all_three: all of a colour, keeping their ratios
    bool is_of_all = false;  // the shininess of all objects; `pointer` is that of the first
    [[nodiscard]] bool is_signed() const { return least < 0; }  // a coordinate
    [[nodiscard]] bool scales_three() const { return component == all_three; }
};
[[nodiscard]] std::vector<FreeNumber> free_numbers(const Scene& scene);
[[nodiscard]] Supposition number_edit(const FreeNumber& number, float value, const Scene& scene);
/// Reads the number, or the largest of the three.
[[nodiscard]] float value_in(Scene scene, const FreeNumber& number);
/// Sets the number, clamped to its range.
void set_number(Scene& scene, const FreeNumber& number, float value);

}  // namespace glint
