#include <array>

#include "diagnose/diagnosis_format.h"
#include "models/json/json.h"

namespace glint {
namespace {

Json rgb_json(Rgb c) { return {int{c[0]}, int{c[1]}, int{c[2]}}; }

constexpr std::array kind_texts{"right", "left out", "setting", "mistake", "number"};

Json strings_json(const std::vector<std::string>& strings) {
    Json json = Json::array();
    for (const std::string& s : strings) json.push_back(s);
    return json;
}

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
    if (display.background) json["background"] = rgb_json(*display.background);
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
    json["set"] = strings_json(c.options());
    json["also"] = strings_json(c.also_named);
    json["conventions"] = strings_json(c.conventions);
    json["almost"] = c.almost;
    json["residual"] = c.residual;
    json["explained"] = c.explained;
    json["gain"] = c.change.gain;
    json["pixel"] = json_of(c.pixel);
    json["mine"] = rgb_json(c.mine);
    json["reference"] = rgb_json(c.reference);
    json["as_mistaken"] = rgb_json(c.as_mistaken);
    return json;
}

Json answer_json(const Experiment& e) {
    Json json;
    Json& set = json["set"] = Json::array();
    for (const Assignment& a : e.set) set.push_back(a.pointer + "=" + a.json);
    json["pixel"] = json_of(e.pixel);
    Json& shows = json["shows"] = Json::array();
    for (std::size_t i = 0; i < e.shows.size(); ++i)
        shows.push_back({{"name", name_of(e.mistakes[i])}, {"color", rgb_json(e.shows[i])}});
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
    json["conventions"] = strings_json(d.conventions);
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

}  // namespace glint
