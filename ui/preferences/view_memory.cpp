#include "ui/preferences/view_memory.h"

#include <array>
#include <string>
#include <utility>

#include "models/scene_file/scene_file.h"
#include "ui/picture/orbit.h"
#include "ui/preferences/view_json.h"
#include "ui/ui.h"

namespace glint {
namespace {

/// A scene file that holds a camera and nothing else: its writer and its checks serve a kept view too.
Json camera_json(const Camera& camera) {
    Scene scene;
    scene.camera = camera;
    return *Json::parse(scene_text(scene))->find("camera");
}

std::optional<Camera> read_camera(const Json& json) {
    Json file = *Json::parse(scene_text({}));
    file["camera"] = json;
    const Result<Scene> scene = parse_scene(file.text(), "");
    if (const auto* read = std::get_if<Scene>(&scene)) return read->camera;
    return {};
}

Json pair_json(glm::dvec2 v) { return {v.x, v.y}; }

void read_share(const Json& json, const char* name, glm::dvec2& value) {
    const Json* found = json.find(name);
    if (found == nullptr || found->elements().size() != 2) return;
    const Json both{{"x", found->elements()[0]}, {"y", found->elements()[1]}};
    read(both, "x", value.x, 0.0, 1.0);
    read(both, "y", value.y, 0.0, 1.0);
}

Json compare_json(const CompareChoice& choice) {
    Json parts = Json::array();
    for (const Variant& part : choice.parts) parts.push_back(word_of(part));
    return {{"on", choice.on},
            {"parts", parts},
            {"lines", choice.wipes},
            {"stacked", choice.stacked},
            {"difference", choice.difference},
            {"gain", choice.gain}};
}

/// Lines that rise, one fewer than parts; else they stay evenly spread.
void read_lines(const Json& json, CompareChoice& choice) {
    if (!json.is_array() || json.elements().size() != choice.wipes.size()) return;
    std::vector<double> lines;
    for (const Json& line : json.elements()) {
        if (!line.is_number()) return;
        lines.push_back(line.number());
        if (!(lines.back() >= 0 && lines.back() <= 1)) return;
        if (lines.size() > 1 && !(lines.back() >= lines[lines.size() - 2])) return;
    }
    choice.wipes = lines;
}

CompareChoice read_compare(const Json& json) {
    CompareChoice choice;
    if (!json.is_object()) return choice;
    read(json, "on", choice.on);
    read(json, "stacked", choice.stacked);
    read(json, "difference", choice.difference);
    int gain = 1;
    read(json, "gain", gain, 1, most_gain);
    while (2 * choice.gain <= gain) choice.gain *= 2;
    std::vector<Variant> parts;
    if (const Json* found = json.find("parts"))
        for (const Json& part : found->elements())
            if (const auto setting = part.is_string() ? variant_named(part.string()) : std::nullopt)
                parts.push_back(*setting);
    if (parts.size() == 2 || parts.size() == 3) set_parts(choice, parts);
    if (const Json* found = json.find("lines")) read_lines(*found, choice);
    return choice;
}

}  // namespace

Json view_json(const ViewMemory& memory) {
    Json kept = Json::array();
    for (const Camera& camera : memory.kept) kept.push_back(camera_json(camera));
    return {{"compare", compare_json(memory.compare)},
            {"look", info_of(memory.look).label},
            {"over_range", memory.over_range},
            {"dots", memory.dots},
            {"needles", memory.needles},
            {"scope_from", pair_json(memory.scope_from)},
            {"scope_to", pair_json(memory.scope_to)},
            {"scope_channels", memory.scope_channels},
            {"scope_eye", memory.scope_eye},
            {"kept_views", kept}};
}

ViewMemory read_view(const Json& json) {
    ViewMemory memory;
    if (!json.is_object()) return memory;
    if (const Json* found = json.find("compare")) memory.compare = read_compare(*found);
    if (const Json* found = json.find("look"))
        for (int i = 0; i < look_count; ++i)
            if (*found == info_of(static_cast<Look>(i)).label) memory.look = static_cast<Look>(i);
    read(json, "over_range", memory.over_range);
    read(json, "dots", memory.dots);
    read(json, "needles", memory.needles);
    read_share(json, "scope_from", memory.scope_from);
    read_share(json, "scope_to", memory.scope_to);
    read(json, "scope_channels", memory.scope_channels);
    read(json, "scope_eye", memory.scope_eye);
    if (const Json* found = json.find("kept_views"))
        for (const Json& camera : found->elements())
            if (const auto view = read_camera(camera)) keep_view(memory.kept, *view);
    return memory;
}

ViewMemory views_to_remember(const UiState& state) {
    const ViewsState& views = state.views;
    ViewMemory memory;
    memory.compare = views.compare.choice;
    memory.compare.stored.reset();
    memory.compare.shows_stored = false;
    memory.look = views.look.set.choice.look;
    memory.over_range = views.look.set.over_range;
    memory.dots = views.lit.dots;
    memory.needles = views.lit.needles;
    memory.scope_from = views.scope.from;
    memory.scope_to = views.scope.to;
    memory.scope_channels = views.scope.channels;
    memory.scope_eye = views.scope.eye;
    memory.kept = state.kept_views;
    return memory;
}

void recall_views(UiState& state, const ViewMemory& memory) {
    ViewsState& views = state.views;
    std::shared_ptr<const Scene> stored = std::move(views.compare.choice.stored);
    views.compare.choice = memory.compare;
    views.compare.choice.stored = std::move(stored);
    views.look.set = {{memory.look, 0}, memory.over_range};
    views.lit.dots = memory.dots;
    views.lit.needles = memory.needles;
    views.scope.from = memory.scope_from;
    views.scope.to = memory.scope_to;
    views.scope.channels = memory.scope_channels;
    views.scope.eye = memory.scope_eye;
    state.kept_views = memory.kept;
}

}  // namespace glint
