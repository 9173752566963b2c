#include "models/json/json_of_vector.h"
#include "renderer/diagnose/diagnosis_format.h"
#include "renderer/diagnose/diagnosis_table.h"

namespace glint {
namespace {

JsonValue rgb_json(Rgb c) { return {int{c[0]}, int{c[1]}, int{c[2]}}; }

JsonValue names_json(const std::vector<MistakeSet>& sets) {
    JsonValue names = JsonValue::array();
    for (const MistakeSet& set : sets) names.push_back(name_of(set));
    return names;
}

JsonValue display_json(const DisplayFinding& display) {
    const DisplayChange& c = display.change;
    JsonValue json = JsonValue::object();
    if (c.upside_down) json["upside_down"] = true;
    if (c.mirrored) json["mirrored"] = true;
    if (c.red_blue) json["red_blue_exchanged"] = true;
    if (c.encodings() != 0) json["srgb"] = c.encodings() > 0 ? "encoded" : "decoded";
    if (c.is_by_power()) json["power"] = encoding_power;
    if (c.gain != 1) json["gain"] = c.gain;
    if (c.noise > 0) json["noise"] = c.noise;
    if (display.background) json["background"] = rgb_json(*display.background);
    if (display.shift != glm::vec2(0)) json["shift"] = JsonValue{display.shift.x, display.shift.y};
    if (display.smooth_edges) json["smooth_edges"] = true;
    if (display.smoothed) json["smoothed"] = true;
    if (display.softened > 0)
        json["softened"] = {{"pixels", display.softened}, {"levels", display.softened_most}};
    return json;
}

JsonValue candidate_json(const Candidate& c) {
    JsonValue json;
    json["name"] = name_of(c.mistakes);
    json["also"] = names_json(c.also);
    json["residual"] = c.residual;
    json["explained"] = c.explained;
    json["gain"] = c.change.gain;
    json["pixel"] = json_of(c.pixel);
    json["mine"] = rgb_json(c.mine);
    json["reference"] = rgb_json(c.reference);
    json["as_mistaken"] = rgb_json(c.as_mistaken);
    return json;
}

JsonValue answer_json(const Experiment& e) {
    JsonValue json;
    JsonValue& set = json["set"] = JsonValue::array();
    for (const Assignment& a : e.set) set.push_back(a.pointer + "=" + a.json);
    json["pixel"] = json_of(e.pixel);
    JsonValue& shows = json["shows"] = JsonValue::array();
    for (std::size_t i = 0; i < e.shows.size(); ++i)
        shows.push_back({{"name", name_of(e.mistakes[i])}, {"color", rgb_json(e.shows[i])}});
    return json;
}

JsonValue term_json(const DifferenceTerm& t, const Scene& scene) {
    JsonValue json{{"term", t.term}, {"factor", t.factor}, {"explained", t.explained}};
    if (t.light >= 0) json["light"] = scene.lights[static_cast<std::size_t>(t.light)].name;
    return json;
}

JsonValue difference_json(const Diagnosis& d, const Scene& scene) {
    JsonValue json;
    json["wrong"] = count_of(d.pixels, PixelKind::Surface).share();
    JsonValue& regions = json["regions"] = JsonValue::array();
    for (const DifferenceRegion& r : d.regions)
        regions.push_back({{"object", scene.objects[static_cast<std::size_t>(r.object)].name},
                           {"pixels", r.pixels},
                           {"share", r.share},
                           {"from", json_of(r.low)},
                           {"to", json_of(r.high)},
                           {"mean", r.mean}});
    JsonValue& terms = json["terms"] = JsonValue::array();
    for (const DifferenceTerm& t : d.terms) terms.push_back(term_json(t, scene));
    return json;
}

JsonValue pixels_json(const PixelCounts& counts) {
    JsonValue json;
    for (const auto& [name, kind] : {std::pair{"surface", PixelKind::Surface},
                                     {"edge", PixelKind::Edge},
                                     {"background", PixelKind::Background}}) {
        const PixelCount& count = count_of(counts, kind);
        json[name] = {{"pixels", count.pixels}, {"unlike", count.unlike}};
    }
    return json;
}

JsonValue answer_json(const Diagnosis& d, const Scene& scene) {
    JsonValue json;
    json["verdict"] = verdict_text(d.verdict);
    if (d.verdict == Verdict::NotComparable) json["why"] = d.why;
    json["width"] = d.size.width;
    json["height"] = d.size.height;
    json["display"] = display_json(d.display);
    json["pixels"] = pixels_json(d.pixels);
    JsonValue& candidates = json["candidates"] = JsonValue::array();
    for (const Candidate& c : d.candidates) candidates.push_back(candidate_json(c));
    if (d.verdict == Verdict::NotInCatalogue) json["difference"] = difference_json(d, scene);
    if (d.left_out) json["left_out"] = term_json(*d.left_out, scene);
    json["experiment"] = d.experiment ? answer_json(*d.experiment) : JsonValue();
    return json;
}

}  // namespace

std::string diagnosis_json(const Diagnosis& d, const Scene& scene) {
    return json_text(answer_json(d, scene));
}

std::string experiment_json(const std::optional<Experiment>& experiment) {
    return json_text(experiment ? answer_json(*experiment) : JsonValue());
}

std::string diagnoses_json(const std::vector<DiagnosedPicture>& pictures, const Scene& scene) {
    JsonValue all = JsonValue::array();
    for (const DiagnosedPicture& p : pictures)
        all.push_back({{"picture", p.name}, {"answer", answer_json(p.diagnosis, scene)}});
    return json_text(all);
}

}  // namespace glint
