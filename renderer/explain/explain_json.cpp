#include <utility>

#include "models/fields/choices.h"
#include "models/json/json.h"
#include "renderer/explain/equation_text.h"

namespace glint {
namespace {

using glint::json_of;  // in addition to the overloads below

Json json_of(const InBothFrames& v) { return {{"camera", json_of(v.camera)}, {"world", json_of(v.world)}}; }

Json json_of(const ExplainedLight& light, const std::string& name) {
    Json json;
    json["name"] = name;
    json["index"] = light.index;
    if (light.samples.empty()) {  // an area light has these in its samples
        json["l"] = json_of(light.l);
        json["r"] = json_of(light.r);
        json["h"] = json_of(light.h);
        json["n_dot_l"] = light.n_dot_l;
        json["r_dot_v"] = light.r_dot_v;
        json["n_dot_h"] = light.n_dot_h;
        json["distance"] = light.distance;
        json["spot_angle_deg"] = light.spot_angle_deg;
        json["diffuse_factor"] = light.diffuse_factor;
        json["specular_factor"] = json_of(light.specular_factor);
    }
    if (light.reached < 1) {
        json["reached"] = light.reached;
        json["blocker"] = light.blocker;
        json["blocked_by"] = light.blocked_by;
    }
    json["falloff"] = light.falloff;
    json["spot"] = light.spot;
    json["ambient"] = json_of(light.ambient);
    json["diffuse"] = json_of(light.diffuse);
    json["specular"] = json_of(light.specular);
    if (light.samples.empty()) json["share"] = json_of(light.share);
    if (!light.samples.empty()) {
        json["samples"] = Json::array();
        for (const ExplainedLight& sample : light.samples) json["samples"].push_back(json_of(sample, name));
    }
    return json;
}

void add_place(Json& json, const ExplainedPoint& at) {
    json["point"] = json_of(at.point);
    json["normal"] = json_of(at.normal);
    json["view"] = json_of(at.view);
}

void add_terms(Json& json, const ExplainedPoint& at) {
    json["base"] = json_of(at.base);
    Json& lights = json["lights"] = Json::array();
    for (const ExplainedLight& light : at.lights) lights.push_back(json_of(light, light.name));
    json["emission"] = json_of(at.emission);
    json["global_ambient"] = json_of(at.global_ambient);
    if (at.bounces.used)
        json["bounces"] = {{"arrives", json_of(at.bounces.arrives)},
                           {"standard_error", json_of(at.bounces.standard_error)},
                           {"paths", at.bounces.paths},
                           {"term", json_of(at.bounces.term)}};
    if (!at.cool_to_warm.used) return;
    const ExplainedTone& tone = at.cool_to_warm;
    json["cool_to_warm"] = {{"n_dot_l", tone.n_dot_l},
                            {"k_w", tone.k_w},
                            {"cool", json_of(tone.cool)},
                            {"warm", json_of(tone.warm)},
                            {"color", json_of(tone.color)}};
}

Json json_of(const ExplainedCorner& corner) {
    Json json;
    json["weight"] = corner.weight;
    add_place(json, corner.at);
    add_terms(json, corner.at);
    json["sum"] = json_of(corner.at.sum);
    return json;
}

void add_hit(Json& json, const Explanation& e) {
    json["object"] = e.object;
    json["object_index"] = e.object_index;
    json["face"] = e.face;
    json["triangle"] = e.triangle;
    json["front_facing"] = e.front_facing;
    json["vertices"] = e.corner;
    json["weights"] = json_of(e.weights);
    const ExplainedSpaces& in = e.spaces;
    json["spaces"] = {{"object", json_of(in.object)}, {"world", json_of(in.world)},
                      {"camera", json_of(in.camera)}, {"clip", {in.clip.x, in.clip.y, in.clip.z, in.clip.w}},
                      {"ndc", json_of(in.ndc)},       {"pixel", {in.pixel.x, in.pixel.y}}};
    json["mode"] = name_of(e.mode);
    json["reflection"] = name_of(e.reflection);
    add_place(json, e.at);
    if (!e.lit_per_corner) {
        add_terms(json, e.at);
        return;
    }
    json["corners"] = Json::array();
    for (const ExplainedCorner& corner : e.corners) json["corners"].push_back(json_of(corner));
}

}  // namespace

Json explanation_json(const Explanation& e) {
    Json json;
    json["pixel"] = {e.x, e.y};
    json["hit"] = e.hit;
    if (e.hit) add_hit(json, e);
    if (e.stroke.coverage > 0)
        json["stroke"] = {{"coverage", e.stroke.coverage},
                          {"color", json_of(e.stroke.color)},
                          {"shaded", json_of(e.stroke.shaded)}};
    json["sum"] = json_of(e.sum);
    json["displayed"] = json_of(e.displayed);
    json["byte"] = e.byte;
    return json;
}

std::string explain_json(const Explanation& e) { return json_text(explanation_json(e)); }

}  // namespace glint
