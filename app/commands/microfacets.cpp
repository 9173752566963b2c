// glint microfacets: a rough surface as many mirrors, and what becomes of a bundle of rays.
#include "renderer/inspect/reflectance/microfacets.h"

#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/json/json_value.h"
#include "renderer/inspect/reflectance/lobes.h"

namespace glint {
namespace {

using Json = JsonValue;

struct MicrofacetArguments {
    MicrofacetOptions options;
    std::optional<double> view_deg;
    int lobe_rays = 100000, threads = 0;  // threads: taken on every line
};

Json json_of(glm::dvec2 v) { return {v.x, v.y}; }

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
    return "";  // not reached
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

Outcome microfacets(const MicrofacetArguments& arguments) {
    MicrofacetOptions options = arguments.options;
    options.view_deg = arguments.view_deg.value_or(options.light_deg);
    const auto lobe = facet_lobe(options.roughness, options.light_deg, arguments.lobe_rays, options.seed);
    return {json_text(json_of(options, microfacet_picture(options), lobe)), {}, ExitStatus::Done};
}

Run declare(Options& options) {
    auto arguments = std::make_shared<MicrofacetArguments>();
    MicrofacetOptions& o = arguments->options;
    options.add_value("--roughness", "R", "0 to 1, 90 degrees of tilt to 1; 0.25 when not given",
                      [&o](const std::string& text) { o.roughness = read_amount("--roughness", text, 1); });
    options.add_value("--angle", "DEG", "angle of the light to the normal, 0 to 89; 30 when not given",
                      [&o](const std::string& text) { o.light_deg = read_amount("--angle", text, 89); });
    options.add_value(
        "--view", "DEG", "angle of the viewer, 0 to 89 on the other side; the mirror angle when not given",
        [&view = arguments->view_deg](const std::string& text) { view = read_amount("--view", text, 89); });
    options.add_value("--rays", "N", "1 to 100000; 200 when not given",
                      [&o](const std::string& text) { o.rays = read_count("--rays", text, 1, 100000); });
    options.add_value("--facets", "N", "4 to 100000; 400 when not given",
                      [&o](const std::string& text) { o.facets = read_count("--facets", text, 4, 100000); });
    options.add_value("--seed", "S", "another seed, another surface; 1 when not given",
                      [&o](const std::string& text) {
                          o.seed = static_cast<std::uint32_t>(read_count("--seed", text, 0, 2147483647));
                      });
    add_threads(options, arguments->threads);
    return [arguments] { return microfacets(*arguments); };
}

}  // namespace

Command microfacets_command() {
    return {"microfacets", "", "bounces rays off a rough surface of mirrors, as JSON",
            "glint microfacets --roughness 0.3 --angle 60 --rays 1000", declare};
}

}  // namespace glint
