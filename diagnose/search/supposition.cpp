#include "diagnose/search/supposition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "models/fields/choices.h"
#include "models/fields/scene_fields.h"
#include "models/scene/mistakes.h"

namespace glint {
namespace {

// The cost of believing each kind of explanation: an explanation that costs 1 more must halve the residual.
constexpr double of_left_out = 0.7, of_setting = 0.85, of_mistake = 0.95, of_number = 1.6, of_pair = 2.2;
constexpr double of_restriction = 0.4, of_other_form = 0.05;

Supposition edit_of(ExplanationKind kind, double belief, std::string name, std::string words,
                    std::vector<std::string> set, SceneEdit edit) {
    Supposition e;
    e.kind = kind;
    e.belief = belief;
    e.name = std::move(name);
    e.words = std::move(words);
    e.set = std::move(set);
    e.edits.push_back(std::move(edit));
    return e;
}

}  // namespace

Scene under_mistakes(Scene scene, const MistakeSet& mistakes) {
    scene.shading.mistakes = {};
    for (const std::size_t i : mistakes) scene.shading.mistakes.*mistake_names()[i].flag = true;
    return scene;
}

std::string name_of(const MistakeSet& mistakes) {
    if (mistakes.empty()) return "right";
    std::string name;
    for (const std::size_t i : mistakes) {
        if (!name.empty()) name += " + ";
        name += mistake_names()[i].name;
    }
    return name;
}

Scene Supposition::program(const Scene& right) const {
    Scene scene = right;
    for (const SceneEdit& edit : convention_edits) edit(scene);
    return scene;
}

Scene Supposition::applied(const Scene& right) const {
    Scene scene = program(right);
    for (const SceneEdit& edit : edits) edit(scene);
    return scene;
}

bool Supposition::makes(bool Mistakes::*flag) const {
    return std::any_of(mistakes.begin(), mistakes.end(),
                       [flag](std::size_t m) { return mistake_names()[m].flag == flag; });
}

bool Supposition::is_axes_form() const {
    return kind == ExplanationKind::Mistake &&
           mistake_names()[mistakes.front()].flag == &Mistakes::normals_axes_exchanged;
}

// Display curves.

std::string_view tone_name(ToneCurve tone) {
    constexpr std::array names{"",
                               "Reinhard's curve x / (1 + x)",
                               "Reinhard's curve of the luminance",
                               "the curve 1 - exp(-x)",
                               "ACES's curve, after K. Narkowicz",
                               "Hable's curve"};
    return names[static_cast<std::size_t>(tone)];
}

glm::vec3 toned(ToneCurve tone, glm::vec3 c) {
    switch (tone) {
    case ToneCurve::None:
        break;
    case ToneCurve::Reinhard:
        return c / (1.0f + c);
    case ToneCurve::ReinhardLuminance:
        return c / (1.0f + glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f)));
    case ToneCurve::Exponential:
        return 1.0f - glm::exp(-c);
    case ToneCurve::Aces:
        return glm::clamp((c * (2.51f * c + 0.03f)) / (c * (2.43f * c + 0.59f) + 0.14f), 0.0f, 1.0f);
    case ToneCurve::Hable: {
        const auto curve = [](glm::vec3 x) {
            return (x * (0.15f * x + 0.05f) + 0.004f) / (x * (0.15f * x + 0.5f) + 0.06f) - 0.02f / 0.3f;
        };
        return curve(2.0f * c) / curve(glm::vec3(11.2f));
    }
    }
    return c;
}

// Conventions.

std::span<const ConventionName> convention_names() {
    static constexpr std::array names{
        ConventionName{"specular_behind_surface", "Ungated highlight",
                       "It does not test n·l before the highlight"},
        ConventionName{"interpolated_lengths", "Normalized per pixel",
                       "Its normals are normalized at the pixel, but not at the corners"},
        ConventionName{"local_viewer", "Other viewer",
                       "Its viewer is infinitely far away where the scene's is at the eye, or the reverse"},
        ConventionName{"rules", "Other rules",
                       "It follows OpenGL's fixed-function pipeline, or the scene does"},
        ConventionName{"weighting", "Other weights", "It averages normals with other weights"},
        ConventionName{"highlight_normalized", "Normalized highlight",
                       "It multiplies the highlight by a factor, as three.js does"}};
    return names;
}

std::vector<Convention> conventions_of(const Scene& scene) {
    std::vector<Convention> all;
    const auto add_mistake = [&all](std::size_t mistake, const std::string& words, int form) {
        const Supposition e = mistake_edit(mistake, form);
        all.push_back({e.name, words, e.set, e.edits.front()});
    };
    add_mistake(mistake_index(&Mistakes::specular_behind_surface),
                "it does not test n·l before the highlight; that is common", 0);
    add_mistake(mistake_index(&Mistakes::interpolated_lengths),
                "its normals are normalized at the pixel, but not at the corners; that is common", 0);
    const bool local = !scene.shading.local_viewer;
    all.push_back({"local_viewer",
                   local ? "its viewer is at the eye" : "its viewer is infinitely far away",
                   {fmt::format("/shading/local_viewer={}", local)},
                   [local](Scene& s) { s.shading.local_viewer = local; }});
    const Rules rules = scene.shading.rules == Rules::Lecture ? Rules::OpenGL2 : Rules::Lecture;
    all.push_back({"rules",
                   rules == Rules::OpenGL2 ? "it follows the rules of OpenGL's fixed-function pipeline"
                                           : "it follows the lecture's rules, and not those of OpenGL 2",
                   {fmt::format("/shading/rules={}", name_of(rules))},
                   [rules](Scene& s) { s.shading.rules = rules; }});
    for (const NormalWeighting weighting :
         {NormalWeighting::Uniform, NormalWeighting::Area, NormalWeighting::Angle}) {
        std::vector<std::string> set;
        const std::string word(name_of(weighting));
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (scene.objects[i].normals.weighting != weighting)
                set.push_back(fmt::format("/objects/{}/normals/weighting={}", i, word));
        if (set.empty()) continue;
        all.push_back({"weighting=" + word, "it averages normals with the weights \"" + word + "\"", set,
                       [weighting](Scene& s) {
                           for (Object& o : s.objects) o.normals.weighting = weighting;
                       }});
    }
    const std::size_t normalized = mistake_index(&Mistakes::highlight_normalized);
    const MistakeName& row = mistake_names()[normalized];
    for (int form = 0; form < form_count(row); ++form)
        add_mistake(normalized, "it multiplies the highlight by " + form_words(row, form), form);
    return all;
}

Supposition with_convention(Supposition e, const Convention& convention) {
    e.conventions.push_back(convention.name + ": " + convention.words);
    e.convention_edits.push_back(convention.edit);
    e.convention_set.insert(e.convention_set.end(), convention.set.begin(), convention.set.end());
    e.belief += convention.cost;
    return e;
}

// Left out.

namespace {

void add_terms_left_out(std::vector<Supposition>& all) {
    struct Row {
        const char* name;
        bool Terms::*flag;
    };
    constexpr std::array rows{Row{"specular", &Terms::specular}, Row{"ambient", &Terms::ambient},
                              Row{"diffuse", &Terms::diffuse}, Row{"emission", &Terms::emission}};
    for (unsigned bits = 1; bits < 16; ++bits) {
        std::string names;
        std::vector<std::string> set;
        int count = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if ((bits >> i & 1u) == 0) continue;
            names += (names.empty() ? "" : " and ") + std::string(rows[i].name);
            set.push_back(fmt::format("/shading/terms/{}=false", rows[i].name));
            ++count;
        }
        if (count > 2) continue;
        all.push_back(edit_of(
            ExplanationKind::LeftOut, of_left_out + 0.15 * (count - 1), names + " term",
            fmt::format("The {} {} left out everywhere.", names, count == 1 ? "term is" : "terms are"),
            std::move(set), [bits, rows](Scene& s) {
                for (std::size_t i = 0; i < rows.size(); ++i)
                    if ((bits >> i & 1u) != 0) s.shading.terms.*rows[i].flag = false;
            }));
    }
}

/// Returns every subset of a few lights; for more lights, each light alone and all lights but one.
std::vector<std::vector<std::size_t>> sets_of_lights(const std::vector<std::size_t>& on) {
    constexpr std::size_t few = 6;
    std::vector<std::vector<std::size_t>> sets;
    if (on.size() <= few) {
        for (unsigned bits = 1; bits < 1u << on.size(); ++bits) {
            std::vector<std::size_t> off;
            for (std::size_t i = 0; i < on.size(); ++i)
                if ((bits >> i & 1u) != 0) off.push_back(on[i]);
            sets.push_back(off);
        }
        return sets;
    }
    constexpr std::size_t most = 64;
    for (std::size_t i = 0; i < std::min(on.size(), most); ++i) {
        sets.push_back({on[i]});
        std::vector<std::size_t> others = on;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        sets.push_back(others);
    }
    sets.push_back(on);
    return sets;
}

void add_lights_left_out(std::vector<Supposition>& all, const Scene& scene) {
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].enabled) on.push_back(i);
    for (const std::vector<std::size_t>& off : sets_of_lights(on)) {
        std::vector<std::string> set;
        std::string names;
        for (const std::size_t i : off) {
            set.push_back(fmt::format("/lights/{}/enabled=false", i));
            names += (names.empty() ? "" : ", ") + scene.lights[i].name;
        }
        const bool whole = off.size() == on.size();
        const double more =
            whole ? 0 : 0.1 * static_cast<double>(std::min(off.size(), on.size() - off.size()) - 1);
        all.push_back(edit_of(ExplanationKind::LeftOut, of_left_out + more, whole ? "all lights" : names,
                              whole ? "All lights are off: only global ambient light and emission remain."
                                    : names + (off.size() == 1 ? " is" : " are") + " left out.",
                              set, [off](Scene& s) {
                                  for (const std::size_t i : off) s.lights[i].enabled = false;
                              }));
    }
    if (on.size() < 2) return;
    const auto add_terms_of = [&](const std::string& whose, const std::vector<std::size_t>& lights,
                                  double more) {
        using Row = std::pair<const char*, glm::vec3 Light::*>;
        for (const Row& row : {Row{"specular", &Light::specular}, Row{"diffuse", &Light::diffuse},
                               Row{"ambient", &Light::ambient}}) {
            const char* const term = row.first;
            glm::vec3 Light::*const color = row.second;
            std::vector<std::string> set;
            set.reserve(lights.size());
            for (const std::size_t i : lights) set.push_back(fmt::format("/lights/{}/{}=[0,0,0]", i, term));
            const std::string name = fmt::format("{} term of {}", term, whose);
            all.push_back(edit_of(ExplanationKind::LeftOut, of_left_out + more, name,
                                  fmt::format("The {} is left out.", name), set, [lights, color](Scene& s) {
                                      for (const std::size_t i : lights) s.lights[i].*color = glm::vec3(0);
                                  }));
        }
    };
    for (const std::size_t i : on) add_terms_of(scene.lights[i].name, {i}, 0.2);
    for (const LightKind kind :
         {LightKind::Directional, LightKind::Point, LightKind::Spot, LightKind::Area}) {
        std::vector<std::size_t> of_kind;
        for (const std::size_t i : on)
            if (scene.lights[i].kind == kind) of_kind.push_back(i);
        if (of_kind.size() > 1 && of_kind.size() < on.size())
            add_terms_of(fmt::format("{} lights", name_of(kind)), of_kind, 0.25);
    }
}

}  // namespace

std::vector<Supposition> left_out_edits(const Scene& scene) {
    std::vector<Supposition> all;
    add_terms_left_out(all);
    if (scene.global_ambient != glm::vec3(0))
        all.push_back(edit_of(ExplanationKind::LeftOut, of_left_out + 0.05, "global ambient light",
                              "The global ambient light is left out.", {"/global_ambient=[0,0,0]"},
                              [](Scene& s) { s.global_ambient = glm::vec3(0); }));
    add_lights_left_out(all, scene);
    // A single emission gives the surfaces a single colour, from which nothing can be concluded.
    if (std::any_of(scene.objects.begin(), scene.objects.end(), [&scene](const Object& o) {
            return o.material.emission != scene.objects[0].material.emission;
        }))
        all.push_back(edit_of(
            ExplanationKind::LeftOut, of_left_out + 0.1, "all light",
            "Nothing is lit: only emission remains.",
            {"/shading/terms/ambient=false", "/shading/terms/diffuse=false", "/shading/terms/specular=false"},
            [](Scene& s) {
                s.shading.terms = {.emission = true, .ambient = false, .diffuse = false, .specular = false};
            }));
    all.push_back(edit_of(ExplanationKind::LeftOut, of_left_out + 0.3, "lighting",
                          "Nothing is lit: the mesh's own colours are shown.", {"/shading/reflection=none"},
                          [](Scene& s) { s.shading.reflection = Reflection::None; }));
    return all;
}

// Other settings.

namespace {

/// A different reflection model for the entire scene, which also replaces those of individual materials; or
/// for one object.
void add_reflections(std::vector<Supposition>& all, const Scene& scene) {
    constexpr std::size_t few = 8;  // how many objects are tried one by one
    const auto add = [&all](Reflection model, const std::string& whose, std::vector<std::string> set,
                            SceneEdit edit, double more) {
        all.push_back(
            edit_of(ExplanationKind::Setting, of_setting + more,
                    fmt::format("reflection={}{}", name_of(model), whose),
                    fmt::format("Your picture is this scene with reflection {}{}.", name_of(model), whose),
                    std::move(set), std::move(edit)));
    };
    for (const auto model : {Reflection::Phong, Reflection::BlinnPhong, Reflection::Lambert,
                             Reflection::OrenNayar, Reflection::CookTorrance, Reflection::Retro}) {
        const auto own = static_cast<OwnReflection>(model);
        std::vector<std::string> set{fmt::format("/shading/reflection={}", name_of(model))};
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const Material& material = scene.objects[i].material;
            if (material.reflection != OwnReflection::Scene)
                set.push_back(fmt::format("/objects/{}/material/reflection=scene", i));
            if (reflection_of(material, scene.shading.reflection) != model) others.push_back(i);
        }
        if (!others.empty() || scene.objects.empty())
            add(
                model, "", std::move(set),
                [model](Scene& s) {
                    s.shading.reflection = model;
                    for (Object& o : s.objects) o.material.reflection = OwnReflection::Scene;
                },
                0);
        if (scene.objects.size() < 2 || scene.objects.size() > few) continue;
        for (const std::size_t i : others)
            add(
                model, " for " + scene.objects[i].name,
                {fmt::format("/objects/{}/material/reflection={}", i, name_of(own))},
                [i, own](Scene& s) { s.objects[i].material.reflection = own; }, 0.5);
    }
}

}  // namespace

std::vector<Supposition> setting_edits(const Scene& scene) {
    std::vector<Supposition> all;
    const auto add = [&](std::string set, const std::string& words, SceneEdit edit, double more = 0) {
        const std::string name = set.substr(set.rfind('/') + 1);
        all.push_back(edit_of(ExplanationKind::Setting, of_setting + more, name,
                              "Your picture is this scene " + words + ".", {std::move(set)},
                              std::move(edit)));
    };
    const auto each = [&](auto Shading::*member, const char* key, const auto& values) {
        for (const auto value : values)
            if (scene.shading.*member != value)
                add(fmt::format("/shading/{}={}", key, name_of(value)),
                    fmt::format("with {} {}", key, name_of(value)),
                    [member, value](Scene& s) { s.shading.*member = value; });
    };
    each(&Shading::mode, "mode",
         std::array{ShadingMode::Gouraud, ShadingMode::Flat, ShadingMode::Facet, ShadingMode::Phong});
    add_reflections(all, scene);
    each(&Shading::interpolation, "interpolation",
         std::array{Interpolation::Perspective, Interpolation::Screen, Interpolation::Scanline});
    each(&Shading::flat_point, "flat_point", std::array{FlatPoint::Centroid, FlatPoint::Provoking});
    each(&Shading::cull, "cull", std::array{Cull::None, Cull::Back, Cull::Front});
    const auto toggle = [&](bool Shading::*member, const char* key) {
        const bool value = !(scene.shading.*member);
        add(fmt::format("/shading/{}={}", key, value), fmt::format("with {} {}", key, value ? "on" : "off"),
            [member, value](Scene& s) { s.shading.*member = value; });
    };
    toggle(&Shading::two_sided, "two_sided");
    toggle(&Shading::local_viewer, "local_viewer");
    const auto objects = [&](const std::string& assignment, const std::string& words, const auto& edit) {
        constexpr std::size_t few = 24;
        Supposition e = edit_of(ExplanationKind::Setting, of_setting, assignment,
                                "Your picture is this scene with " + words + ".", {}, [edit](Scene& s) {
                                    for (Object& o : s.objects) edit(o);
                                });
        for (std::size_t i = 0; i < std::min(few, scene.objects.size()); ++i)
            e.set.push_back(fmt::format("/objects/{}/normals/{}", i, assignment));
        all.push_back(e);
        if (scene.objects.size() < 2) return;
        for (std::size_t i = 0; i < std::min(few, scene.objects.size()); ++i)
            add(
                fmt::format("/objects/{}/normals/{}", i, assignment),
                "with " + words + " for " + scene.objects[i].name,
                [edit, i](Scene& s) { edit(s.objects[i]); }, 0.2);
    };
    for (const NormalSource source :
         {NormalSource::Vertex, NormalSource::Facet, NormalSource::File, NormalSource::Analytic})
        objects(fmt::format("source={}", name_of(source)), fmt::format("{} normals", name_of(source)),
                [source](Object& o) { o.normals.source = source; });
    for (const float crease : {180.0f, 30.0f, 45.0f, 60.0f})
        objects(fmt::format("crease_deg={}", crease), fmt::format("a crease angle of {} degrees", crease),
                [crease](Object& o) { o.normals.crease_deg = crease; });
    constexpr std::size_t few_lights = 16;
    for (std::size_t i = 0; i < std::min(few_lights, scene.lights.size()); ++i) {
        const Light& light = scene.lights[i];
        if (light.kind != LightKind::Point && light.kind != LightKind::Spot) continue;
        if (light.kind == LightKind::Spot)
            add(fmt::format("/lights/{}/type=point", i), "with " + light.name + " as a point light",
                [i](Scene& s) { s.lights[i].kind = LightKind::Point; });
        add(fmt::format("/lights/{}/type=directional", i), "with " + light.name + " as a directional light",
            [i](Scene& s) {
                s.lights[i].kind = LightKind::Directional;
                s.lights[i].position.w = 0;
            });
    }
    return all;
}

// Mistakes.

Supposition mistake_edit(std::size_t mistake, int form) {
    const MistakeName& row = mistake_names()[mistake];
    int Mistakes::*const of_form =
        row.flag == &Mistakes::highlight_normalized ? &Mistakes::highlight_form : &Mistakes::form;
    Supposition e =
        edit_of(ExplanationKind::Mistake, of_mistake + (form > 0 ? of_other_form : 0), std::string(row.name),
                std::string(row.what), {fmt::format("/shading/mistakes/{}=true", row.name)},
                [flag = row.flag, of_form, form](Scene& s) {
                    s.shading.mistakes.*flag = true;
                    if (form > 0) s.shading.mistakes.*of_form = form;
                });
    e.mistakes = {mistake};
    if (form == 0) return e;
    e.set.push_back(
        fmt::format("/shading/mistakes/{}={}", of_form == &Mistakes::form ? "form" : "highlight_form", form));
    if (const std::string words = form_words(row, form); !words.empty()) e.words += " Here: " + words + ".";
    return e;
}

std::vector<Supposition> mistake_edits() {
    std::vector<Supposition> all;
    for (std::size_t i = 0; i < mistake_names().size(); ++i)
        for (int form = 0; form < form_count(mistake_names()[i]); ++form)
            all.push_back(mistake_edit(i, form));
    return all;
}

std::vector<Supposition> all_lights_reversed(const Scene& scene) {
    constexpr int of_bulbs_with_cones = 2;  // form
    Supposition e = mistake_edit(mistake_index(&Mistakes::light_direction_reversed), of_bulbs_with_cones);
    const std::size_t without = e.set.size();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (light.kind != LightKind::Directional) continue;
        const glm::vec4 p(-glm::vec3(light.position), light.position.w);
        e.set.push_back(fmt::format("/lights/{}/position=[{},{},{},{}]", i, p.x, p.y, p.z, p.w));
        e.edits.emplace_back([i, p](Scene& s) { s.lights[i].position = p; });
    }
    if (e.set.size() == without || e.set.size() == without + scene.lights.size()) return {};
    e.words += " Also for directional lights.";
    return {e};
}

Supposition pair_of(const Supposition& a, const Supposition& b) {
    Supposition e = a;
    e.name = a.name + " + " + b.name;
    e.words = a.words + " And: " + b.words;
    e.set.insert(e.set.end(), b.set.begin(), b.set.end());
    e.mistakes.insert(e.mistakes.end(), b.mistakes.begin(), b.mistakes.end());
    std::sort(e.mistakes.begin(), e.mistakes.end());
    e.edits.insert(e.edits.end(), b.edits.begin(), b.edits.end());
    e.belief = of_pair + a.belief - of_mistake + b.belief - of_mistake;
    return e;
}

std::vector<Supposition> restricted(const Supposition& mistake, const Scene& scene) {
    std::vector<Supposition> all;
    const auto add = [&](MistakeScope only, double more = 0) {
        Supposition e = mistake;
        e.only = only;
        if (only.light >= 0) e.set.push_back(fmt::format("/shading/mistakes/only_light={}", only.light));
        if (only.object >= 0) e.set.push_back(fmt::format("/shading/mistakes/only_object={}", only.object));
        if (only.lights != ScopeLights::All)
            e.set.push_back(fmt::format("/shading/mistakes/only_lights={}", name_of(only.lights)));
        if (only.term != ScopeTerm::All)
            e.set.push_back(fmt::format("/shading/mistakes/only_term={}", name_of(only.term)));
        e.words += " Only " + words_of(only, scene) + ".";
        e.belief += of_restriction + more;
        all.push_back(std::move(e));
    };
    const MistakeStage stage = mistake_names()[mistake.mistakes.front()].stage;
    if (stage == MistakeStage::Faces || stage == MistakeStage::Display) return all;
    constexpr int few = 12;
    const int lights = std::min(few, static_cast<int>(scene.lights.size()));
    const int objects = std::min(few, static_cast<int>(scene.objects.size()));
    // All lights share the normals and materials, and all objects share the lights.
    const bool is_of_object = stage == MistakeStage::Normals || stage == MistakeStage::Materials;
    if (stage != MistakeStage::Lights && objects > 1)
        for (int i = 0; i < objects; ++i) add({.object = i});
    if (mistake.is_axes_form()) return all;
    add({.term = ScopeTerm::Diffuse});
    add({.term = ScopeTerm::Specular});
    if (lights < 2 || is_of_object) return all;
    std::array<int, 4> of_kind{};
    for (const Light& l : scene.lights) ++of_kind[static_cast<std::size_t>(l.kind)];
    for (int k = 0; k < 4; ++k) {
        const int count = of_kind[static_cast<std::size_t>(k)];
        if (count > 1 && count < static_cast<int>(scene.lights.size()))
            add({.lights = static_cast<ScopeLights>(k + 1)});
    }
    for (int i = 0; i < lights; ++i) {
        add({.light = i});
        add({.light = i, .term = ScopeTerm::Diffuse}, 0.4);
        add({.light = i, .term = ScopeTerm::Specular}, 0.4);
    }
    return all;
}

std::string words_of(const MistakeScope& only, const Scene& scene) {
    std::string words;
    const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
    if (only.term == ScopeTerm::Diffuse) add("in the diffuse term");
    if (only.term == ScopeTerm::Specular) add("in the highlight");
    if (only.light >= 0) add("for " + scene.lights[static_cast<std::size_t>(only.light)].name);
    if (only.lights != ScopeLights::All) add(fmt::format("for {} lights", name_of(only.lights)));
    if (only.object >= 0) add("on " + scene.objects[static_cast<std::size_t>(only.object)].name);
    return words;
}

// Other numbers.

namespace {

/// The numbers of the JSON value that contains this number.
std::vector<float*> numbers_at(Scene& scene, const FreeNumber& number) {
    std::vector<float*> all;
    all.reserve(static_cast<std::size_t>(number.size));
    for (int i = 0; i < number.size; ++i)
        all.push_back(
            number_at(scene, number.pointer + (number.size == 1 ? "" : fmt::format("/{}", i)))->place);
    return all;
}

std::string json_of(Scene scene, const FreeNumber& number) {
    std::string text;
    for (const float* x : numbers_at(scene, number)) text += fmt::format("{}{}", text.empty() ? "" : ",", *x);
    return number.size == 1 ? text : "[" + text + "]";
}

}  // namespace

std::vector<FreeNumber> free_numbers(const Scene& scene) {
    constexpr std::size_t few = 24;
    std::vector<FreeNumber> all;
    const auto add = [&all](FreeNumber number) {
        const bool is_color = number.size == 3 && !number.is_signed();
        for (int i = is_color ? FreeNumber::all_three : 0; i < std::min(number.size, 3); ++i) {
            number.component = i;
            all.push_back(number);
        }
    };
    for (std::size_t i = 0; i < std::min(few, scene.objects.size()); ++i) {
        const ReflectionInfo& info =
            info_of(reflection_of(scene.objects[i].material, scene.shading.reflection));
        const auto of_material = [&](const char* key, int size, float most) {
            add({fmt::format("/objects/{}/material/{}", i, key), size, 0, most, static_cast<int>(i)});
        };
        of_material("diffuse", 3, 1);
        of_material("specular", 3, 1);
        of_material("ambient", 3, 1);
        of_material("emission", 3, 10);
        if (info.uses_shininess()) of_material("shininess", 1, 10'000);
        if (info.uses_roughness) of_material("roughness", 1, 1);
        if (info.uses_f0) of_material("f0", 3, 1);
    }
    if (scene.objects.size() > 1 && info_of(scene.shading.reflection).uses_shininess()) {
        add({"/objects/0/material/shininess", 1, 0, 10'000});
        all.back().is_of_all = true;
    }
    for (std::size_t i = 0; i < std::min(few, scene.lights.size()); ++i) {
        const Light& light = scene.lights[i];
        if (!light.enabled) continue;
        const auto of_light = [&](const char* key, int size = 1, float least = 0, float most = 1e6f) {
            add({fmt::format("/lights/{}/{}", i, key), size, least, most});
        };
        of_light("intensity");
        for (const char* key : {"diffuse", "specular", "ambient"}) of_light(key, 3);
        of_light("position", 4, -1e6f);
        if (light.kind == LightKind::Directional || light.kind == LightKind::Area) continue;
        for (const char* key : {"falloff/constant", "falloff/linear", "falloff/quadratic"}) of_light(key);
        if (light.kind != LightKind::Spot) continue;
        of_light("spot/cutoff_deg", 1, 1, 90);
        of_light("spot/inner_deg", 1, 0, 90);
        of_light("spot/exponent", 1, 0, 128);
        of_light("spot/direction", 3, -1e6f);
    }
    add({"/global_ambient", 3});
    return all;
}

float value_in(Scene scene, const FreeNumber& number) {
    const std::vector<float*> at = numbers_at(scene, number);
    return number.scales_three() ? std::max({*at[0], *at[1], *at[2]})
                                 : *at[static_cast<std::size_t>(number.component)];
}

void set_number(Scene& scene, const FreeNumber& number, float value) {
    const std::vector<float*> at = numbers_at(scene, number);
    const auto allowed = [&number](float x) { return std::clamp(x, number.least, number.most); };
    if (number.scales_three()) {
        const float largest = std::max({*at[0], *at[1], *at[2]});
        for (float* x : at) *x = largest > 0 ? allowed(*x / largest * value) : value;
        return;
    }
    *at[static_cast<std::size_t>(number.component)] = allowed(value);
    for (std::size_t i = 0; number.is_of_all && i < scene.objects.size(); ++i)
        scene.objects[i].material.shininess = *at[0];
}

Supposition number_edit(const FreeNumber& number, float value, const Scene& scene) {
    Scene edited = scene;
    set_number(edited, number, value);
    const std::string given = json_of(scene, number), fits = json_of(edited, number);
    const std::string name = number.is_of_all ? "shininess of all objects" : number.pointer;
    std::vector<std::string> set;
    for (std::size_t i = 0; number.is_of_all && i < scene.objects.size(); ++i)
        set.push_back(fmt::format("/objects/{}/material/shininess={}", i, fits));
    if (set.empty()) set.push_back(fmt::format("{}={}", number.pointer, fits));
    return edit_of(ExplanationKind::Number, of_number, name,
                   fmt::format("Your picture matches {} {}; the scene has {}.", name, fits, given),
                   std::move(set), [number, value](Scene& s) { set_number(s, number, value); });
}

}  // namespace glint
