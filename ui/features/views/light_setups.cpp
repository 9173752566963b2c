// Light setups: sets of lights for any scene, previewed while the mouse hovers over them. The user's own
// setups are kept with the window's settings.
#include <fmt/core.h>
#include <imgui.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "models/json/json.h"
#include "ui/commands/command.h"
#include "ui/document/document_actions.h"
#include "ui/feature.h"
#include "ui/fields/panels.h"
#include "ui/picture/orbit.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/widgets.h"

namespace glint {
namespace {

/// A light of a setup, seen from the target: its angles in degrees to the right of the viewer and above.
struct SetupLight {
    const char* name;
    float right_deg, up_deg, intensity;
    bool is_soft = false;  // without a highlight of its own
    LightKind kind = LightKind::Point;
    bool at_eye = false;
};

struct Setup {
    const char *name, *what;
    std::vector<SetupLight> lights;
};

const std::vector<Setup>& setups() {
    static const std::vector<Setup> all{
        {"Three-point",
         "Key, fill and rim, as in a studio",
         {{"Key", -40, 35, 0.9f}, {"Fill", 50, 10, 0.3f, true}, {"Rim", 160, 40, 0.7f}}},
        {"Rim",
         "From behind on both sides: the outline shines",
         {{"Rim left", -145, 20, 1}, {"Rim right", 145, 20, 1}}},
        {"Rembrandt",
         "High from one side, with almost no fill",
         {{"Key", -50, 45, 1}, {"Fill", 60, 0, 0.08f, true}}},
        {"Flat",
         "Equal light from both sides of the viewer: hardly any shape",
         {{"Left", -35, 10, 0.55f, true}, {"Right", 35, 10, 0.55f, true}}},
        {"Headlight",
         "At the eye, and moving with it",
         {{"Headlight", 0, 0, 1, false, LightKind::Point, true}}},
        {"Noon", "A sun straight above", {{"Sun", 0, 90, 1, false, LightKind::Directional}}}};
    return all;
}

std::vector<Light> lights_of(const Setup& setup, const Camera& camera) {
    constexpr double distance = 0.8, degree = 3.14159265358979 / 180;  // relative to the eye's distance
    const glm::dvec3 target(camera.target), up = glm::normalize(glm::dvec3(camera.up));
    const glm::dvec3 arm = glm::dvec3(camera.eye) - target;
    const glm::dvec3 level = glm::normalize(arm - glm::dot(arm, up) * up), right = glm::cross(up, level);
    std::vector<Light> lights;
    for (const SetupLight& each : setup.lights) {
        const double a = double(each.right_deg) * degree, b = double(each.up_deg) * degree;
        const glm::dvec3 way = std::cos(b) * (std::cos(a) * level + std::sin(a) * right) + std::sin(b) * up;
        Light light;
        light.name = each.name;
        light.kind = each.kind;
        light.intensity = each.intensity;
        if (each.is_soft) light.specular = glm::vec3(0);
        light.position = each.kind == LightKind::Directional
                             ? glm::vec4(glm::vec3(way), 0)
                             : glm::vec4(glm::vec3(target + distance * glm::length(arm) * way), 1);
        if (each.at_eye) light.space = LightSpace::Camera, light.position = {0, 0, 0, 1};
        lights.push_back(light);
    }
    return lights;
}

struct OwnSetup {
    std::string name;
    std::vector<Light> lights;
};

struct LightSetups {
    std::vector<OwnSetup> own;
    std::string name;                         // name of the next setup to save
    std::optional<std::vector<Light>> shown;  // lights of the previewed setup
    std::string shown_name;
    JobPtr<SceneDocument> import;
};

constexpr std::size_t max_own = 20;

void use(UiState& state, const std::vector<Light>& lights) { state.editor.scene().lights = lights; }

/// A menu item, previewed while the mouse hovers over it.
void setup_item(UiState& state, const std::string& name, const char* what, const std::vector<Light>& lights) {
    if (ImGui::MenuItem(whole_label(name).c_str())) use(state, lights);
    if (ImGui::IsItemHovered()) {
        state.get<LightSetups>().shown = lights;
        state.get<LightSetups>().shown_name = fmt::format("{} · {}", name, what);
    }
    list_control(name.c_str(), "", last_item());
}

void save_own(UiState& state) {
    LightSetups& setups = state.get<LightSetups>();
    const std::string name = std::exchange(setups.name, "");
    std::erase_if(setups.own, [&](const OwnSetup& other) { return other.name == name; });
    setups.own.insert(setups.own.begin(), {name, state.editor.scene().lights});
    if (setups.own.size() > max_own) setups.own.pop_back();
    state.notifications.tell("Saved the lights as " + name);
}

void save_row(UiState& state) {
    LightSetups& setups = state.get<LightSetups>();
    ImGui::SetNextItemWidth(px(150));
    const bool entered = text_field("##name", "name", setups.name, ImGuiInputTextFlags_EnterReturnsTrue);
    list_control("Name of the preset", "", last_item());
    ImGui::SameLine();
    ImGui::BeginDisabled(setups.name.empty());
    const bool pressed = ImGui::Button("Save lights as preset");
    ImGui::EndDisabled();
    tooltip("Save lights as preset", "Saves the scene's lights to this list for use in other scenes");
    if ((pressed || entered) && !setups.name.empty()) save_own(state);
}

const FilePurpose lights_purpose{.title = "Import lights from a scene",
                                 .button = "Import",
                                 .hint = "Scenes (.json .glb .gltf), pictures by Glint (.png)",
                                 .nothing = "No folders or scenes here",
                                 .extensions = {".json", ".png", ".glb", ".gltf"},
                                 .use = [](UiState& s, const std::string& path) {
                                     s.get<LightSetups>().import = s.jobs.start<SceneDocument>(
                                         path, [path](LoadProgress&) { return open_document(path); });
                                 }};

void draw_setups(ImDrawList&, UiState& state, const PictureView&) {
    if (std::exchange(state.get<LightFocus>().asks_setups, false)) ImGui::OpenPopup("##light setups");
    if (!ImGui::BeginPopup("##light setups")) return;
    LightSetups& own = state.get<LightSetups>();
    for (const Setup& setup : setups())
        setup_item(state, setup.name, setup.what, lights_of(setup, state.editor.scene().camera));
    if (!own.own.empty()) ImGui::Separator();
    std::optional<std::size_t> forgotten;
    for (std::size_t i = 0; i < own.own.size(); ++i) {
        setup_item(state, own.own[i].name, "Right click: delete", own.own[i].lights);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) forgotten = i;
    }
    if (forgotten) own.own.erase(own.own.begin() + static_cast<std::ptrdiff_t>(*forgotten));
    ImGui::Separator();
    save_row(state);
    if (ImGui::MenuItem("Import lights from a scene…"))
        state.files.ask(lights_purpose, state.editor.document.path);
    list_control("Import lights", "", last_item());
    ImGui::EndPopup();
}

void poll_import(UiState& state) {
    LightSetups& setups = state.get<LightSetups>();
    if (!setups.import || !setups.import->done()) return;
    const Result<SceneDocument> opened = setups.import->take();
    setups.import.reset();
    if (const Problem* problem = problem_of(opened)) return state.notifications.add(*problem);
    use(state, std::get<SceneDocument>(opened).scene.lights);
}

std::optional<OtherScene> show_setup(const UiState& state) {
    const LightSetups& setups = state.get<LightSetups>();
    if (!setups.shown) return {};
    Scene scene = state.editor.scene();
    scene.lights = *setups.shown;
    return OtherScene{.scene = std::move(scene), .note = "Preview: " + setups.shown_name, .passes = true};
}

Json text_json(const std::vector<Light>& lights) {
    Scene scene;
    scene.lights = lights;
    return *find_member(json_or_null(scene_text(scene)), "lights");
}

void write_own(const UiState& state, Json& settings) {
    Json list = Json::array();
    for (const OwnSetup& own : state.get<LightSetups>().own)
        list.push_back({{"name", own.name}, {"lights", text_json(own.lights)}});
    if (!list.empty()) settings["light_setups"] = list;
}

/// The user's own setups are kept when the layout is reset.
void read_own(UiState& state, const Json& settings) {
    const Json* const list = find_member(settings, "light_setups");
    if (list == nullptr || !list->is_array()) return;
    std::vector<OwnSetup> own;
    for (const Json& each : elements_of(*list)) {
        const Json *const name = find_member(each, "name"), *const lights = find_member(each, "lights");
        if (name == nullptr || !name->is_string() || lights == nullptr || own.size() == max_own) continue;
        const Result<Scene> read =
            parse_scene(json_line(Json{{"glint", 1}, {"lights", *lights}}), "settings");
        if (const auto* scene = std::get_if<Scene>(&read))
            own.push_back({name->get<std::string>(), scene->lights});
    }
    state.get<LightSetups>().own = std::move(own);
}

void add_setups(std::vector<PaletteEntry>& entries, UiState& state) {
    for (const Setup& setup : setups())
        entries.push_back({fmt::format("Light setup: {}", setup.name), "Lights", "", "",
                           [&setup](UiState& s) { use(s, lights_of(setup, s.editor.scene().camera)); }});
    for (const OwnSetup& own : state.get<LightSetups>().own)
        entries.push_back({fmt::format("Light setup: {}", own.name), "Lights", "", "",
                           [lights = own.lights](UiState& s) { use(s, lights); }});
}

}  // namespace

extern const Feature light_setups_feature;
const Feature light_setups_feature{
    .update = [](UiState& s) { s.get<LightSetups>().shown.reset(); },
    .end = poll_import,
    .shows = show_setup,
    .overlay = draw_setups,
    .commands =
        [] {
            return std::vector<WindowCommand>{
                {.name = "Light setups…",
                 .section = Section::Edit,
                 .run = [](UiState& s) { s.get<LightFocus>().asks_setups = true; },
                 .line_above = true,
                 .words = "presets studio three-point rembrandt rim noon import lights"}};
        },
    .palette = add_setups,
    .write_settings = write_own,
    .read_settings = read_own};

}  // namespace glint
