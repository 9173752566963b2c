#include "renderer/answers/reflectance_answers.h"

#include "models/fields/choices.h"
#include "models/json/json.h"

namespace glint {
namespace {

using glint::json_of;  // in addition to the overloads below

Json json_of(const LobeSample& s) {
    return {{"view_deg", s.view_deg},
            {"ambient", json_of(s.reflected.ambient)},
            {"diffuse", json_of(s.reflected.diffuse)},
            {"specular", json_of(s.reflected.specular)},
            {"intensity", json_of(s.reflected.intensity())},
            {"brdf", json_of(s.brdf)}};
}

const char* name_of(RayFate fate) {
    switch (fate) {
    case RayFate::Free:
        return "free";
    case RayFate::Shadowed:
        return "shadowed";
    case RayFate::Masked:
        return "masked";
    case RayFate::Inward:
        return "inward";
    }
    return "";  // unreachable
}

Json json_of(const FacetRay& ray) {
    return {{"facet", ray.facet},    {"from", json_of(ray.from)}, {"at", json_of(ray.at)},
            {"to", json_of(ray.to)}, {"out_deg", ray.out_deg},    {"fate", name_of(ray.fate)}};
}

Json json_of(const MicrofacetOptions& o, const MicrofacetPicture& p, const std::vector<LobeBin>& lobe) {
    Json json{{"roughness", o.roughness},
              {"sigma_deg", p.sigma_deg},
              {"light_deg", o.light_deg},
              {"view_deg", o.view_deg},
              {"seed", o.seed}};
    json["shares"] = {{"free", p.free}, {"shadowed", p.shadowed}, {"masked", p.masked}, {"inward", p.inward}};
    json["smith_g1"] = p.smith_g1;
    json["h_deg"] = p.h_deg;
    json["shining"] = {{"share", p.shining_share},
                       {"expected", p.shining_expected},
                       {"within_deg", shining_deg},
                       {"facets", p.shining}};
    json["histogram"] = {{"from_deg", -90}, {"bin_deg", 5}, {"shares", p.histogram}};
    json["lobe"] = Json::array();
    for (const LobeBin& bin : lobe)
        json["lobe"].push_back({{"from_deg", bin.from_deg},
                                {"to_deg", bin.to_deg},
                                {"share", bin.share},
                                {"expected", bin.expected}});
    json["profile"] = Json::array();
    for (const glm::dvec2& point : p.profile) json["profile"].push_back(json_of(point));
    json["rays"] = Json::array();
    for (const FacetRay& ray : p.rays) json["rays"].push_back(json_of(ray));
    return json;
}

}  // namespace

Json lobe_json(const Reflector& reflector, const std::string& object, double light_deg,
               const std::vector<LobeSample>& slice) {
    Json json{{"object", object},
              {"reflection", name_of(reflector.reflection)},
              {"light_deg", light_deg},
              {"specular_energy", json_of(specular_energy(reflector, light_deg))},
              {"directional_albedo", json_of(directional_albedo(reflector, light_deg))},
              {"reciprocity_error", reciprocity_error(reflector)},
              {"slice", Json::array()}};
    for (const LobeSample& s : slice) json["slice"].push_back(json_of(s));
    return json;
}

Json microfacets_json(const MicrofacetOptions& options, int lobe_rays) {
    return json_of(options, microfacet_picture(options),
                   facet_lobe(options.roughness, options.light_deg, lobe_rays, options.seed));
}

}  // namespace glint
