#include "renderer/answers/answers.h"

#include <algorithm>
#include <glm/mat4x4.hpp>
#include <map>
#include <span>

#include "models/fields/choices.h"
#include "models/json/json.h"

namespace glint {
namespace {

/// Converts to four rows of four numbers. GLM's matrices are column-major.
Json rows_of(const glm::dmat4& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
    return rows;
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

}  // namespace

Json info_json(const Mesh& mesh, NormalSource source) {
    constexpr std::size_t max_places = 20;
    const MeshInfo info = mesh_info(mesh);
    Json findings = Json::array();
    for (const MeshFinding& finding : info.findings) {
        Json places = Json::array();
        for (const glm::vec3& place :
             std::span(finding.places).first(std::min(finding.places.size(), max_places)))
            places.push_back(json_of(place));
        findings.push_back({{"name", finding.name},
                            {"count", finding.count},
                            {"what", finding.what},
                            {"effect", finding.effect},
                            {"places", std::move(places)}});
    }
    return {{"vertices", info.vertices},
            {"faces", info.faces},
            {"triangles", info.triangles},
            {"quads", info.quads},
            {"polygons", info.polygons},
            {"edges", info.edges},
            {"boundary_edges", info.boundary_edges},
            {"non_manifold_edges", info.non_manifold_edges},
            {"degenerate_faces", info.degenerate_faces},
            {"duplicate_faces", info.duplicate_faces},
            {"bounds", {{"min", json_of(info.bounds.min)}, {"max", json_of(info.bounds.max)}}},
            {"offset", {info.offset.x, info.offset.y, info.offset.z}},
            {"normals", name_of(used_source(mesh, source))},
            {"findings", std::move(findings)},
            {"warnings", info.warnings},
            {"load_ms", info.load_ms}};
}

Json info_json(const Scene& scene, PictureSize size) {
    Json objects = Json::array();
    std::map<const Mesh*, Json> meshes;  // computed once for each mesh, even if several objects share it
    for (const Object& object : scene.objects) {
        const auto [mesh, is_new] = meshes.try_emplace(object.mesh.get());
        if (is_new) mesh->second = info_json(*object.mesh);
        Json one{{"name", object.name}, {"mesh", mesh->second}};
        one["mesh"]["normals"] = name_of(used_source(*object.mesh, object.normals.source));
        objects.push_back(std::move(one));
    }
    return {{"lights", scene.lights.size()},
            {"objects", objects},
            {"matrices",
             {{"view_from_world", rows_of(view_from_world(scene.camera))},
              {"world_from_view", rows_of(world_from_view(scene.camera))},
              {"clip_from_view", rows_of(clip_from_view(scene.camera.projection, size))}}}};
}

Json stats_json(const Renderer& renderer, PictureSize size) {
    const FrameStats& s = renderer.stats();
    Json json{{"width", size.width},
              {"height", size.height},
              {"evaluations", s.evaluations},
              {"shaded_pixels", s.shaded_pixels},
              {"triangles", s.triangles},
              {"threads", s.threads},
              {"instruction_set", s.instruction_set}};
    json["ms"] = s.total_ms;
    json["stages"] = {{"geometry", s.ms[0]},
                      {"visibility", s.ms[1]},
                      {"surface", s.ms[2]},
                      {"transport", s.ms[3]},
                      {"lighting", s.ms[4]}};
    return json;
}

Json comparison_json(const Comparison& c) {
    Json json;
    json["width"] = c.size.width;
    json["height"] = c.size.height;
    json["differing_pixels"] = c.differing_pixels;
    json["unit"] = "byte";
    json["max_error"] = c.max_error;
    json["max"] = c.max;
    json["mean"] = c.mean;
    json["rmse"] = c.rmse;
    json["alpha_max"] = c.alpha_max;
    json["gain"] = difference_gain(c);
    return json;
}

Json profile_json(const std::vector<ProfileSample>& samples) {
    Json columns;
    const auto column = [&](const char* name, auto value_of) {
        Json& list = columns[name] = Json::array();
        for (const ProfileSample& s : samples) list.push_back(value_of(s));
    };
    using Sample = ProfileSample;
    column("position", [](const Sample& s) { return Json(s.position); });
    column("r", [](const Sample& s) { return Json(s.color.x); });
    column("g", [](const Sample& s) { return Json(s.color.y); });
    column("b", [](const Sample& s) { return Json(s.color.z); });
    column("intensity", [](const Sample& s) { return Json(s.intensity); });
    column("first_difference", [](const Sample& s) { return number_or_null(s.first_difference); });
    column("second_difference", [](const Sample& s) { return number_or_null(s.second_difference); });
    column("face", [](const Sample& s) { return s.seen ? Json(s.seen->face) : Json(); });
    column("object", [](const Sample& s) { return s.seen ? Json(s.seen->object) : Json(); });
    column("x", [](const Sample& s) { return Json(s.pixel.x); });
    column("y", [](const Sample& s) { return Json(s.pixel.y); });
    return columns;
}

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
