#include "diagnose/diagnosis_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "diagnose/search/display_change.h"
#include "models/json/json.h"
#include "models/scene/mistakes.h"
#include "models/utf8.h"
#include "renderer/image/compare.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

std::string text_of(Rgb c) { return fmt::format("({}, {}, {})", c[0], c[1], c[2]); }

/// Whether the nearest candidate explains so much that only something small can be wrong in addition.
bool is_nearest_near(const Diagnosis& d) {
    constexpr double much = 0.95;
    return d.verdict == Verdict::NotInCatalogue && !d.candidates.empty() && d.candidates[0].explained >= much;
}

std::string verdict_line(const Diagnosis& d) {
    switch (d.verdict) {
    case Verdict::NoMistake:
        return "No mistake: the picture shows the scene as Glint does.";
    case Verdict::NotComparable:
        return "Not comparable: " + d.why + ".";
    case Verdict::NotReadable:
        return "Not readable: " + d.why + ".";
    case Verdict::NotInCatalogue:
        return fmt::format("Not in the catalogue: {} of the pixels are wrong, and no {}.",
                           percent_text(count_of(d.pixels, PixelKind::Surface).share()),
                           is_nearest_near(d) ? "single mistake explains all of them"
                           : d.of_pairs
                               ? "mistake explains them, alone or paired; pairs were tried on a small picture"
                               : "single mistake explains them");
    case Verdict::LeftOut:
    case Verdict::AnotherSetting:
    case Verdict::Mistake:
    case Verdict::AnotherNumber:
        break;
    }
    const Candidate& best = d.candidates.front();
    std::string verdict(verdict_text(d.verdict));
    verdict[0] = static_cast<char>(std::toupper(verdict[0]));
    return fmt::format("{}: {}{}. {}", verdict, best.name, best.almost ? ", almost exactly" : "", best.words);
}

/// A line of a program, as `glint code` writes it, and the mistakes that can be made there.
struct ProgramLine {
    std::string_view line, mistakes;
};
constexpr ProgramLine program_lines[] = {
    {"l = unit(light - p)",
     "unnormalized_light light_direction_reversed position_is_direction "
     "divided_by_square light_vector_interpolated"},
    {"h = unit(l + v)", "unnormalized_half"},
    {"r = 2 (n·l) n - l", "reflect_sign reflect_of_difference"},
    {"v = unit(eye - p)",
     "viewer_at_origin_of_world unnormalized_view view_reversed perspective_view_in_ortho"},
    {"diffuse = max(n·l, 0)", "no_clamp_of_cosine absolute_cosine half_lambert missing_pi"},
    {"the highlight's cosine to the power of the shininess",
     "half_angle_with_phong_shininess shininess_as_fraction shininess_inverted power_zero_is_nan "
     "power_of_negative_is_nan specular_without_cosine fresnel_of_view_angle highlight_normalized "
     "alpha_not_squared"},
    {"if (n·l <= 0) the highlight is 0", "specular_behind_surface"},
    {"ambient * k_a + diffuse * k_d + highlight * k_s",
     "coefficients_swapped ambient_without_material highlight_tinted lit_in_srgb "
     "ambient_per_light_added_twice ambient_not_attenuated"},
    {"sum = sum + the light's share", "clamp_each_light last_light_only average_of_lights"},
    {"1 / (constant + linear r + quadratic r^2), r = length(light - p)",
     "falloff_of_directional falloff_without_constant falloff_inverted falloff_forgotten distance_is_one "
     "distance_includes_w distance_across_spaces"},
    {"the test for a spot's cone: dot(-l, direction) >= cos(radians(cutoff))",
     "degrees_for_radians cutoff_as_full_angle aim_stays_at_origin cone_cosines_swapped "
     "spot_direction_left_in_world"},
    {"the matrix that moves lights: the view, with w = 1 for positions and w = 0 for directions",
     "light_in_wrong_space light_moved_twice light_by_inverse_view direction_is_position"},
    {"the space of p: lights, p and n must be in one space", "lit_after_projection"},
    {"the normal matrix: the inverse transpose of view times model, with w = 0",
     "normals_by_model_matrix normals_left_in_object normals_left_in_world normals_as_points "
     "normals_without_model normals_by_inverse normals_by_projection"},
    {"n = unit(n), at the corner or at the pixel",
     "unnormalized_normals interpolated_normals_not_normalized interpolated_lengths zero_normal_is_nan"},
    {"the normal attribute, as the mesh provides it",
     "no_normals_given normals_flipped normals_axes_exchanged positions_as_normals "
     "normals_by_position_index"},
    {"a facet's normal: cross(b - a, c - a), averaged at the corners",
     "some_faces_flipped cross_reversed facet_normals_of_screen_points cross_component_wrong "
     "facet_normal_of_first_corners last_facet_wins"},
    {"the choice of front and back: by the winding on the screen",
     "mirror_turns_inside_out flipped_by_view flipped_twice culled_by_light"},
    {"the last line: clamp to 0 to 1, encode once, round to a byte", "encoded_twice bytes_wrap"},
};

/// The program line in which this mistake is made.
std::string_view line_of(std::string_view mistake) {
    const auto row =
        std::find_if(std::begin(program_lines), std::end(program_lines), [mistake](const ProgramLine& l) {
            return (" " + std::string(l.mistakes) + " ").find(fmt::format(" {} ", mistake)) !=
                   std::string::npos;
        });
    return row == std::end(program_lines) ? "" : row->line;
}

/// The colour of a pixel, as the wrong picture stores its channels.
std::string stored_text(const DisplayChange& change, Rgb c) { return text_of(exchanged(change, c)); }

std::string candidate_lines(const Candidate& c, PictureSize size) {
    const glm::ivec2 place = changed_place(c.change, size, c.pixel);
    std::string text = fmt::format(
        "It explains {} % of the wrong pixels and leaves an error of {:.2f} levels. At {},{} your picture "
        "has {}; it should have {}, and with the mistake it would have {}",
        explained_percent(c), c.residual, place.x, place.y, stored_text(c.change, c.mine),
        stored_text(c.change, c.reference), stored_text(c.change, c.as_mistaken));
    text +=
        place == c.pixel ? ".\n" : fmt::format("; in the scene that is pixel {},{}.\n", c.pixel.x, c.pixel.y);
    if (!c.also_named.empty())
        text +=
            fmt::format("In this scene surfaces look the same under {}.\n", fmt::join(c.also_named, ", "));
    return text;
}

/// "draw the scene with --set ...: pixel 4,2 is then (1, 2, 3) with a, (4, 5, 6) with b.\n"
std::string experiment_line(const Experiment& e) {
    std::vector<std::string> options, shows;
    for (const Assignment& a : e.set) options.push_back(fmt::format("--set {}={}", a.pointer, a.json));
    for (std::size_t i = 0; i < e.shows.size(); ++i)
        shows.push_back(fmt::format("{} with {}", text_of(e.shows[i]), name_of(e.mistakes[i])));
    return fmt::format("draw the scene with {}: pixel {},{} is then {}.\n", fmt::join(options, " "),
                       e.pixel.x, e.pixel.y, fmt::join(shows, ", "));
}

/// "the specular term of Sun", "all light from Sun", "the specular term of all lights".
std::string term_words(const DifferenceTerm& t, const Scene& scene) {
    const bool is_all = t.term == "all";
    std::string words = is_all ? "all light" : "the " + t.term + " term";
    const char* const of = is_all ? " from " : " of ";
    if (t.light == all_lights) words += std::string(of) + "all lights";
    if (t.light >= 0) words += of + on_one_line(scene.lights[static_cast<std::size_t>(t.light)].name);
    return words;
}

std::string difference_lines(const Diagnosis& d, const Scene& scene) {
    std::string text;
    if (!d.regions.empty()) {
        const DifferenceRegion& r = d.regions.front();
        text += fmt::format(
            "Most of it is on {}, where {} of the pixels are wrong, from {},{} to {},{}, by {} levels on "
            "average.\n",
            on_one_line(scene.objects[static_cast<std::size_t>(r.object)].name), percent_text(r.share),
            r.low.x, r.low.y, r.high.x, r.high.y,
            fmt::format("({:.0f}, {:.0f}, {:.0f})", r.mean[0], r.mean[1], r.mean[2]));
    }
    if (!d.terms.empty()) {
        const DifferenceTerm& t = d.terms.front();
        const std::string factor = t.is_by_channel() ? fmt::format("({:.2f}, {:.2f}, {:.2f})", t.channels[0],
                                                                   t.channels[1], t.channels[2])
                                                     : fmt::format("{:.2f}", t.factor);
        text += fmt::format(
            "The difference is as if {} were multiplied by {}{}, which explains {:.0f} % of it.\n",
            term_words(t, scene), factor,
            t.object < 0 ? "" : " on " + on_one_line(scene.objects[static_cast<std::size_t>(t.object)].name),
            100 * t.explained);
    }
    if (!d.candidates.empty()) {
        const Candidate& nearest = d.candidates.front();
        const std::string brightness = own_brightness(d, nearest);
        const std::string name = nearest.name + (brightness.empty() ? "" : " " + brightness);
        text += is_nearest_near(d)
                    ? fmt::format(
                          "Begin with {}, which explains {} % of them but leaves an error of {:.1f} "
                          "levels; something else also differs.\n",
                          name, explained_percent(nearest), nearest.residual)
                    : fmt::format("The nearest is {}, which explains {} % of the wrong pixels: too few.\n",
                                  name, explained_percent(nearest));
    }
    return text;
}

/// Describes differences that do not count as wrong: at edges, or in too few pixels. Empty if there are none.
std::string still_unlike_line(const PixelCounts& counts, float noise) {
    std::vector<std::string> kinds;
    const auto add = [&](PixelKind kind, std::string_view where) {
        const PixelCount& count = count_of(counts, kind);
        if (count.unlike > 0) kinds.push_back(fmt::format("{} of {} {}", count.unlike, count.pixels, where));
    };
    add(PixelKind::Surface, "on surfaces, too few for a mistake");
    add(PixelKind::Edge, "at edges, which are not compared");
    add(PixelKind::Background, "in the background, which is not compared");
    if (kinds.empty()) return "";
    return fmt::format("Pixels that differ by more than {} levels{}: {}.\n", visible_levels,
                       noise > 0 ? " beyond what noise explains" : "", fmt::join(kinds, "; "));
}

}  // namespace

std::string_view verdict_text(Verdict verdict) {
    constexpr std::array texts{"no mistake",     "left out",       "another setting",
                               "mistake",        "another number", "not in the catalogue",
                               "not comparable", "not readable"};
    return texts[static_cast<std::size_t>(verdict)];
}

std::string display_text(const DisplayFinding& display) {
    const DisplayChange& c = display.change;
    std::vector<std::string> words;
    if (display.tone != ToneCurve::None) words.emplace_back(tone_name(display.tone));
    if (c.upside_down && c.mirrored) {
        words.emplace_back("turned by 180 degrees");
    } else if (c.upside_down || c.mirrored) {
        words.emplace_back(c.upside_down ? "upside down" : "mirrored");
    }
    if (c.red_blue) words.emplace_back("red and blue swapped");
    if (c.is_by_power())
        words.push_back(
            c.encodings() > 0
                ? fmt::format("encoded once too often, by a power of {}", encoding_power)
                : fmt::format("encoded by a power of {} in place of sRGB's curve", encoding_power));
    else if (c.encodings() != 0)
        words.emplace_back(c.encodings() > 0 ? "sRGB-encoded once too often"
                                             : "sRGB-encoded one time too few");
    if (c.gain != 1)
        words.push_back(fmt::format("brightness multiplied by {:.3g}, in {}", c.gain,
                                    c.before == Code::Decoded ? "linear light" : "stored levels"));
    if (c.noise > 0) words.push_back(fmt::format("noise of about {:.1f} levels", c.noise));
    if (!display.arrived.empty()) words.push_back(display.arrived);
    if (!display.camera_words.empty()) words.push_back(display.camera_words);
    if (display.lossy) words.emplace_back("errors in single pixels, as from lossy compression");
    if (display.background) words.push_back("a different background, " + text_of(*display.background));
    if (display.shift != glm::vec2(0))
        words.push_back(fmt::format("shifted by {:.2f} pixels to the right and {:.2f} down", display.shift.x,
                                    display.shift.y));
    if (display.smooth_edges)
        words.emplace_back("smooth edges");
    else if (display.smoothed)
        words.emplace_back("smoothed");
    if (display.softened > 0)
        words.push_back(fmt::format("within surfaces by up to {} levels in {} pixels", display.softened_most,
                                    display.softened));
    return fmt::format("{}", fmt::join(words, "; "));
}

std::string experiment_text(const std::optional<Experiment>& experiment) {
    return experiment ? "To distinguish them, " + experiment_line(*experiment)
                      : "No change that was tried separates them by more than a level.\n";
}

std::string percent_text(double share) {
    return share > 0 && share < 0.005 ? "less than 1 %" : fmt::format("{:.0f} %", 100 * share);
}

int explained_percent(const Candidate& candidate) {
    return static_cast<int>(std::floor(100 * candidate.explained));
}

std::string diagnosis_text(const Diagnosis& d, const Scene& scene) {
    std::string text = verdict_line(d) + "\n";
    if (d.verdict == Verdict::NotComparable || d.verdict == Verdict::NotReadable) return text;
    if (d.verdict == Verdict::Mistake)
        text += fmt::format("Look in your program for {}.\n",
                            line_of(mistake_names()[d.candidates.front().mistakes.front()].name));
    if (d.experiment) text += "To be sure, " + experiment_line(*d.experiment);
    if (is_explained(d.verdict)) text += candidate_lines(d.candidates.front(), d.size);
    if (const std::string display = display_text(d.display); !display.empty())
        text += "Set aside first, because it is not a lighting mistake: " + display + ".\n";
    for (const std::string& convention : d.conventions)
        text +=
            "Your program differs in a convention: " + convention.substr(convention.find(": ") + 2) + ".\n";
    if (d.verdict == Verdict::NoMistake) text += still_unlike_line(d.pixels, d.display.change.noise);
    if (d.verdict == Verdict::NoMistake && d.display.softened > 0)
        text +=
            "A small highlight that is lit differently can look like a softened one. Use a larger picture "
            "to be sure.\n";
    if (d.verdict == Verdict::NotInCatalogue) text += difference_lines(d, scene);
    return text;
}

std::string own_brightness(const Diagnosis& diagnosis, const Candidate& candidate) {
    constexpr float hardly = 0.005f;
    const float gain = candidate.change.gain, told = diagnosis.display.change.gain;
    if (std::abs(gain - told) <= hardly * std::max(gain, told)) return {};
    return fmt::format("with brightness multiplied by {:.3g}", gain);
}

namespace {

constexpr std::array kind_texts{"right", "left out", "setting", "mistake", "number"};

Json display_json(const DisplayFinding& display) {
    const DisplayChange& c = display.change;
    Json json = Json::object();
    if (c.upside_down) json["upside_down"] = true;
    if (c.mirrored) json["mirrored"] = true;
    if (c.red_blue) json["red_blue_exchanged"] = true;
    if (c.encodings() != 0) json["srgb"] = c.encodings() > 0 ? "encoded" : "decoded";
    if (c.is_by_power()) json["power"] = encoding_power;
    if (c.gain != 1) {
        json["gain"] = c.gain;
        json["gain_of"] = c.before == Code::Decoded ? "linear light" : "stored levels";
    }
    if (c.noise > 0) json["noise"] = c.noise;
    if (display.tone != ToneCurve::None) json["curve"] = tone_name(display.tone);
    if (display.background) json["background"] = *display.background;
    if (display.shift != glm::vec2(0)) json["shift"] = Json{display.shift.x, display.shift.y};
    if (display.camera) {
        const CameraDifference& d = *display.camera;
        json["camera"] = display.camera_words;
        if (const auto* p = std::get_if<Perspective>(&d.camera.projection)) json["fov_y_deg"] = p->fov_y_deg;
        if (d.scale != glm::dvec2(1)) json["scale"] = Json{d.scale.x, d.scale.y};
        if (d.shift != glm::dvec2(0)) json["shift"] = Json{d.shift.x, d.shift.y};
        if (d.eye != glm::dvec3(0)) json["eye"] = Json{d.eye.x, d.eye.y, d.eye.z};
    }
    if (!display.arrived.empty()) json["arrived"] = display.arrived;
    if (display.lossy) json["lossy"] = true;
    if (display.smooth_edges) json["smooth_edges"] = true;
    if (display.smoothed) json["smoothed"] = true;
    if (display.softened > 0)
        json["softened"] = {{"pixels", display.softened}, {"levels", display.softened_most}};
    return json;
}

Json candidate_json(const Candidate& c) {
    Json json;
    json["kind"] = kind_texts[static_cast<std::size_t>(c.kind)];
    json["name"] = c.name;
    json["set"] = c.options();
    json["also"] = c.also_named;
    json["conventions"] = c.conventions;
    json["almost"] = c.almost;
    json["residual"] = c.residual;
    json["explained"] = c.explained;
    json["gain"] = c.change.gain;
    json["pixel"] = json_of(c.pixel);
    json["mine"] = c.mine;
    json["reference"] = c.reference;
    json["as_mistaken"] = c.as_mistaken;
    return json;
}

Json answer_json(const Experiment& e) {
    Json json;
    Json& set = json["set"] = Json::array();
    for (const Assignment& a : e.set) set.push_back(a.pointer + "=" + a.json);
    json["pixel"] = json_of(e.pixel);
    Json& shows = json["shows"] = Json::array();
    for (std::size_t i = 0; i < e.shows.size(); ++i)
        shows.push_back({{"name", name_of(e.mistakes[i])}, {"color", e.shows[i]}});
    return json;
}

Json term_json(const DifferenceTerm& t, const Scene& scene) {
    Json json{{"term", t.term}, {"factor", t.factor}, {"explained", t.explained}};
    if (t.is_by_channel()) json["channels"] = t.channels;
    if (t.object >= 0) json["object"] = scene.objects[static_cast<std::size_t>(t.object)].name;
    if (t.light >= 0) json["light"] = scene.lights[static_cast<std::size_t>(t.light)].name;
    return json;
}

Json difference_json(const Diagnosis& d, const Scene& scene) {
    Json json;
    json["wrong"] = count_of(d.pixels, PixelKind::Surface).share();
    Json& regions = json["regions"] = Json::array();
    for (const DifferenceRegion& r : d.regions)
        regions.push_back({{"object", scene.objects[static_cast<std::size_t>(r.object)].name},
                           {"pixels", r.pixels},
                           {"share", r.share},
                           {"from", json_of(r.low)},
                           {"to", json_of(r.high)},
                           {"mean", r.mean}});
    Json& terms = json["terms"] = Json::array();
    for (const DifferenceTerm& t : d.terms) terms.push_back(term_json(t, scene));
    return json;
}

Json pixels_json(const PixelCounts& counts) {
    Json json;
    for (const auto& [name, kind] : {std::pair{"surface", PixelKind::Surface},
                                     {"edge", PixelKind::Edge},
                                     {"background", PixelKind::Background}}) {
        const PixelCount& count = count_of(counts, kind);
        json[name] = {{"pixels", count.pixels}, {"unlike", count.unlike}};
    }
    return json;
}

Json answer_json(const DiagnosedPicture& p, const Scene& scene) {
    const Diagnosis& d = p.diagnosis;
    Json json;
    json["picture"] = p.name;
    json["verdict"] = verdict_text(d.verdict);
    if (!d.why.empty()) json["why"] = d.why;
    if (d.verdict == Verdict::NotReadable) return json;
    json["width"] = d.size.width;
    json["height"] = d.size.height;
    json["display"] = display_json(d.display);
    json["conventions"] = d.conventions;
    json["pixels"] = pixels_json(d.pixels);
    Json& candidates = json["candidates"] = Json::array();
    for (const Candidate& c : d.candidates) candidates.push_back(candidate_json(c));
    if (d.verdict == Verdict::NotInCatalogue) json["difference"] = difference_json(d, scene);
    json["experiment"] = d.experiment ? answer_json(*d.experiment) : Json();
    return json;
}

}  // namespace

std::string experiment_json(const std::optional<Experiment>& experiment) {
    return json_text(experiment ? answer_json(*experiment) : Json());
}

std::string diagnoses_json(const std::vector<DiagnosedPicture>& pictures, const Scene& scene) {
    std::string lines;
    for (const DiagnosedPicture& p : pictures) lines += json_line(answer_json(p, scene)) + "\n";
    return lines;
}

// Diagnoses of many pictures as a table, in CSV and in HTML.

namespace {

constexpr int thumbnail_side = 160;

PictureSize thumbnail_size(PictureSize size) {
    const int longest = std::max({size.width, size.height, thumbnail_side});
    return {std::max(1, size.width * thumbnail_side / longest),
            std::max(1, size.height * thumbnail_side / longest)};
}

constexpr std::array columns{"picture",  "verdict", "mistake",    "also", "explained",
                             "residual", "display", "experiment", "why"};
using Row = std::array<std::string, columns.size()>;

Row row_of(const DiagnosedPicture& p) {
    const Diagnosis& d = p.diagnosis;
    Row row;
    row[0] = on_one_line(p.name);
    row[1] = verdict_text(d.verdict);
    if (!d.candidates.empty() && is_explained(d.verdict)) {
        const Candidate& c = d.candidates.front();
        row[2] = c.name;
        row[3] = fmt::format("{}", fmt::join(c.also_named, ", "));
        row[4] = fmt::format("{:.3f}", c.explained);
        row[5] = fmt::format("{:.2f}", c.residual);
    }
    row[6] = display_text(d.display);
    if (d.experiment)
        for (const Assignment& a : d.experiment->set)
            row[7] = fmt::format("{}{}--set {}={}", row[7], row[7].empty() ? "" : " ", a.pointer, a.json);
    row[8] = d.why;
    return row;
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == text.npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

constexpr std::string_view style =
    "body{font:16px/1.4 system-ui,sans-serif;margin:2em}table{border-collapse:collapse}"
    "th,td{text-align:left;vertical-align:top;padding:.5em .8em;border-bottom:1px solid #8884}"
    "code{font-size:.9em}img{display:block}:root{color-scheme:light dark}";

std::string html_row(const DiagnosedPicture& p) {
    const Row row = row_of(p);
    std::string words = fmt::format("<b>{}</b>", html_escaped(row[1]));
    if (!row[2].empty()) words += fmt::format("<br><code>{}</code>", html_escaped(row[2]));
    if (!row[3].empty()) words += fmt::format("<br>looks the same: <code>{}</code>", html_escaped(row[3]));
    if (!row[8].empty()) words += fmt::format("<br>{}", html_escaped(row[8]));
    const std::string share =
        row[4].empty() ? "" : fmt::format("{} %", explained_percent(p.diagnosis.candidates[0]));
    const auto image = [](const Picture& picture, const char* alt) {
        return picture.rgba.empty() ? std::string() : html_image(picture, alt);
    };
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td><code>{}</code></td></"
        "tr>\n",
        html_escaped(row[0]), image(p.thumbnail, "as submitted"), image(p.as_explained, "as Glint draws it"),
        words, share, html_escaped(row[6]), html_escaped(row[7]));
}

}  // namespace

DiagnosedPicture diagnosed_picture(const std::string& name, Diagnosis diagnosis, const Scene& scene,
                                   const Picture& wrong, int threads) {
    const PictureSize size = thumbnail_size(wrong.size);
    const Scene shown = is_explained(diagnosis.verdict) ? scene_under(scene, diagnosis.candidates.front())
                                                        : under_mistakes(scene, {});
    Renderer renderer(threads);
    return {name, std::move(diagnosis), resampled(wrong, size), renderer.render(shown, size)};
}

std::string diagnoses_csv(const std::vector<DiagnosedPicture>& pictures) {
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const DiagnosedPicture& p : pictures) {
        Row row = row_of(p);
        // Still names the file. A spreadsheet would treat a field that begins with one of these as a formula.
        if (!p.name.empty() && std::string_view("=+-@").find(p.name[0]) != std::string_view::npos)
            row[0].insert(0, "./");
        for (std::string& field : row) field = csv_field(field);
        text += fmt::format("{}\n", fmt::join(row, ","));
    }
    return text;
}

std::string diagnoses_html(const std::vector<DiagnosedPicture>& pictures, const std::string& title) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
        "charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
        "<body>\n<h1>Pictures of {0}</h1>\n<table>\n<tr><th>Picture</th><th>Yours</th><th>Glint's</th>"
        "<th>Verdict</th><th>Explained</th><th>Set aside first</th><th>To be sure, draw with</th></tr>\n",
        html_escaped(title), style);
    for (const DiagnosedPicture& p : pictures) html += html_row(p);
    return html + "</table>\n</body></html>\n";
}

namespace {

const SheetAxis one_row{"/", {""}};

SheetAxis columns_of(const Diagnosis& d) {
    SheetAxis axis{"/", {"yours", "right"}};
    if (!d.candidates.empty()) axis.values.push_back(name_of(d.candidates.front().mistakes));
    axis.values.emplace_back("yours - right");
    return axis;
}

/// Returns the picture of the scene as the diagnosed display would show it.
Picture as_displayed(Picture picture, const DisplayChange& change) {
    const ByteRanges ranges = byte_ranges(change);
    for (std::size_t pixel = 0; pixel < picture.size.pixels(); ++pixel) {
        const Rgb colour = shown(ranges, rgb_at(picture, pixel));
        std::copy(colour.begin(), colour.end(), &picture.rgba[4 * pixel]);
    }
    return picture;
}

/// The wrong picture the right way up, with its channels in order.
Picture upright(const Picture& wrong, const DisplayChange& change) {
    Picture picture{wrong.size, std::vector<std::uint8_t>(wrong.rgba.size(), 255), {}};
    for (int y = 0; y < wrong.size.height; ++y)
        for (int x = 0; x < wrong.size.width; ++x) {
            const Rgb colour = mine_at(wrong, change, x, y);
            std::copy(colour.begin(), colour.end(), &picture.rgba[4 * wrong.pixel(x, y)]);
        }
    return picture;
}

/// The byte that the change maps closest to this level.
std::uint8_t drawn_byte(const ByteRanges& ranges, std::uint8_t wrong) {
    const auto nearest = std::min_element(
        ranges.begin(), ranges.end(),
        [wrong](const auto& a, const auto& b) { return a.from_middle(wrong) < b.from_middle(wrong); });
    return static_cast<std::uint8_t>(nearest - ranges.begin());
}

}  // namespace

Picture undone(const Picture& wrong, const DisplayChange& change) {
    Picture picture = upright(wrong, change);
    const ByteRanges ranges = byte_ranges(change);
    std::array<std::uint8_t, 256> drawn{};
    for (std::size_t i = 0; i < drawn.size(); ++i)
        drawn[i] = drawn_byte(ranges, static_cast<std::uint8_t>(i));
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = drawn[picture.rgba[i]];
    return picture;
}

PictureSize diagnosis_sheet_size(const Diagnosis& d, const Font& font) {
    return sheet_size(one_row, columns_of(d), d.size, font);
}

Picture diagnosis_sheet(const Diagnosis& d, const Scene& scene, const Picture& wrong, const Font& font,
                        int threads) {
    const DisplayChange& change = d.display.change;
    Renderer renderer(threads);
    std::vector<Picture> cells{upright(wrong, change)};
    cells.push_back(as_displayed(renderer.render(under_mistakes(scene, {}), d.size), change));
    const Comparison far = std::get<Comparison>(compare(cells[0], cells[1]));
    Picture difference = difference_picture(cells[0], cells[1], difference_gain(far));
    if (!d.candidates.empty())
        cells.push_back(
            as_displayed(renderer.render(scene_under(scene, d.candidates.front()), d.size), change));
    cells.push_back(std::move(difference));
    return make_sheet(one_row, columns_of(d), d.size, font,
                      [&](std::size_t, std::size_t column) -> const Picture& { return cells[column]; });
}

}  // namespace glint
