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

}  // namespace glint
