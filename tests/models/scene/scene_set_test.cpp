// --set POINTER=JSON: applied to the document as written, checked once at the end.
#include "models/memory_limit.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

constexpr const char* smallest = R"({"glint": 1})";

/// Reads the scene `text` with each option given to --set.
Result<Scene> assigned(const std::string& text, const std::vector<std::string>& options) {
    std::vector<Assignment> assignments;
    for (const std::string& option : options) {
        const Result<Assignment> assignment = parse_assignment(option);
        if (const Problem* problem = problem_of(assignment)) return *problem;
        assignments.push_back(std::get<Assignment>(assignment));
    }
    return parse_scene(text, "s.json", assignments);
}

Scene scene_with(const std::string& text, const std::vector<std::string>& options) {
    const Result<Scene> result = assigned(text, options);
    INFO((problem_of(result) != nullptr ? problem_of(result)->text() : ""));
    REQUIRE(problem_of(result) == nullptr);
    return std::get<Scene>(result);
}

std::string problem_with(const std::string& text, const std::vector<std::string>& options) {
    const Result<Scene> result = assigned(text, options);
    return problem_of(result) != nullptr ? problem_of(result)->text() : "no problem";
}

}  // namespace

TEST_CASE("the option --set creates missing objects, lists, and vectors with their defaults", "[scene_set]") {
    CHECK(scene_with(smallest, {"/display/exposure=2"}).display.exposure == 2);
    CHECK(scene_with(smallest, {"/shading/terms/ambient=false"}).shading.terms.ambient == false);
    CHECK(scene_with(smallest, {"/camera/eye/0=3"}).camera.eye == glm::vec3(3, 0, 5));
    const Scene scene = scene_with(smallest, {"/lights/0/spot/cutoff_deg=12", "/lights/-/name=Second",
                                              "/objects/-/mesh/primitive=torus", "/lights/1/position/1=7"});
    REQUIRE(scene.lights.size() == 2);
    CHECK(scene.lights[0].spot.cutoff_deg == 12);
    CHECK(scene.lights[1].name == "Second");
    CHECK(scene.lights[1].position == glm::vec4(0, 7, 2, 1));
    REQUIRE(scene.objects.size() == 1);
    CHECK(std::get<PrimitiveMesh>(scene.objects[0].source) == PrimitiveMesh{Primitive::Torus, 48});
}

TEST_CASE("the option --set accepts JSON values, and takes a bare word as a string", "[scene_set]") {
    CHECK(scene_with(smallest, {"/shading/mode=gouraud"}).shading.mode == ShadingMode::Gouraud);
    CHECK(scene_with(smallest, {"/shading/mode=\"gouraud\""}).shading.mode == ShadingMode::Gouraud);
    CHECK(scene_with(smallest, {"/shading/reflection=blinn-phong"}).shading.reflection ==
          Reflection::BlinnPhong);
    CHECK(scene_with(smallest, {"/lights/0/name=a_1-B"}).lights[0].name == "a_1-B");
    CHECK(scene_with(smallest, {"/lights/0/name=\"a=b\""}).lights[0].name == "a=b");
    CHECK(scene_with(smallest, {"/global_ambient=[1, 2, 3]"}).global_ambient == glm::vec3(1, 2, 3));
    CHECK(scene_with(smallest, {"/lights=[{},{\"type\":\"spot\"}]"}).lights[1].kind == LightKind::Spot);
    const std::string expected = "; expected a JSON value such as 2, [1, 2, 3] or \"text\"; or a word";
    CHECK(problem_with(smallest, {"/lights/0/name=1a"}) ==
          "--set: /lights/0/name: \"1a\" is neither JSON nor a word: unexpected \"a\"" + expected);
    CHECK(problem_with(smallest, {"/lights/0/name="}) ==
          "--set: /lights/0/name: \"\" is neither JSON nor a word: the text is empty" + expected);
    CHECK(problem_with(smallest, {"/lights/0/intensity=1e999"}) ==
          "--set: /lights/0/intensity: 1e999 is out of range; expected a number between -1e7 and 1e7");
    CHECK(problem_with(smallest, {"/lights/0/position=[0, -1e400, 0]"}) ==
          "--set: /lights/0/position/1: -1e400 is out of range; expected a number between -1e7 and 1e7");
    CHECK(problem_with(smallest, {"/lights/0/name=two words"}).find("neither JSON nor a word") !=
          std::string::npos);
    CHECK(problem_with(smallest, {"/camera/eye=[1,2"}).find("the text ends too early") != std::string::npos);
    CHECK(problem_with(smallest, {"/display/exposure=NaN"}) ==
          "--set: /display/exposure: \"NaN\" is a string; expected a number");
    CHECK(problem_with(smallest, {"/display/exposure=1e999"}).find("1e999 is out of range") !=
          std::string::npos);
    CHECK(problem_with(smallest, {"/npr={\"alpha\":1,\"alpha\":2}"}).find("duplicate key") !=
          std::string::npos);
    CHECK(problem_with(smallest, {"/display/exposure=null"}) ==
          "--set: /display/exposure: null is not a value; expected a number");
}

TEST_CASE("setting only a light's type also sets its w", "[scene_set]") {
    const std::string sun = R"({"glint": 1, "lights": [{"type": "directional", "position": [1, 2, 3, 0]}]})";
    const std::string bulb = R"({"glint": 1, "lights": [{"position": [2, 4, 6, 2]}]})";
    CHECK(scene_with(sun, {"/lights/0/type=point"}).lights[0].position == glm::vec4(1, 2, 3, 1));
    CHECK(scene_with(bulb, {"/lights/0/type=directional"}).lights[0].position == glm::vec4(1, 2, 3, 0));
    CHECK(scene_with(bulb, {"/lights/0/type=area"}).lights[0].position == glm::vec4(1, 2, 3, 1));
    CHECK(scene_with(bulb, {"/lights/0/type=directional", "/lights/0/position/0=9"}).lights[0].position ==
          glm::vec4(9, 2, 3, 0));
    CHECK(
        scene_with(bulb, {"/lights/0/type=directional", "/lights/0/position=[1,2,3,0]"}).lights[0].position ==
        glm::vec4(1, 2, 3, 0));
    CHECK(scene_with(bulb, {"/lights/0/position/3=0", "/lights/0/type=directional"}).lights[0].position ==
          glm::vec4(2, 4, 6, 0));
    CHECK(problem_with(bulb, {"/lights/0/type=directional", "/lights/0/position=[1,2,3,1]"}) ==
          "--set: /lights/0/position: w is 1; expected w = 0 for a directional light");
    CHECK(problem_with(R"({"glint": 1, "lights": [{"position": [0, 0, 0, 1]}]})",
                       {"/lights/0/type=directional"}) ==
          "--set: /lights/0/position: a zero direction; expected the direction towards the light");
}

TEST_CASE("setting only a projection's type drops the keys of the other projections", "[scene_set]") {
    const std::string text =
        R"({"glint": 1, "camera": {"projection": {"fov_y_deg": 30, "near": 2, "far": 9}}})";
    const Scene scene =
        scene_with(text, {"/camera/projection/type=orthographic", "/camera/projection/height=3"});
    CHECK(std::get<Orthographic>(scene.camera.projection) == Orthographic{3, 2, 9});
    CHECK(problem_with(text, {"/camera/projection/type=orthographic", "/camera/projection/fov_y_deg=3"}) ==
          "--set: /camera/projection/fov_y_deg: not a key of the projection \"orthographic\"; expected type, "
          "height, near "
          "or far");
}

TEST_CASE("a scene is checked once, after the last assignment", "[scene_set]") {
    const std::string text = R"({"glint": 1, "display": {"exposure": -1}})";
    CHECK(scene_with(text, {"/display/exposure=2"}).display.exposure == 2);
    CHECK(scene_with(smallest, {"/camera/eye=[0,0,0]", "/camera/target=[0,0,1]"}).camera.target.z == 1);
    CHECK(scene_with(smallest, {"/display/exposure=0", "/display/exposure=3"}).display.exposure == 3);
}

TEST_CASE("a problem is attributed to --set only if --set caused it", "[scene_set]") {
    CHECK(problem_with(smallest, {"/display/exposure=-1"}) ==
          "--set: /display/exposure: -1 is out of range; expected more than 0, up to 1e7");
    CHECK(problem_with(smallest, {"/display/exposre=1"}) ==
          "--set: /display/exposre: unknown key \"exposre\"; expected \"exposure\"");
    CHECK(problem_with(smallest, {"/camera/eye=[0,0,0]"}) ==
          "--set: /camera: eye and target are the same point; expected two different points");
    CHECK(problem_with(R"({"glint": 1, "npr": {"alpha": "x"}})", {"/display/exposure=1"}) ==
          "s.json: /npr/alpha: \"x\" is a string; expected a number");
    CHECK(problem_with("[]", {"/display/exposure=1"}) ==
          "s.json: the value is an array; expected an object, such as {\"glint\": 1}");
    CHECK(problem_with("{", {"/display/exposure=0"}).find("s.json:1: ") == 0);
}

TEST_CASE("a variant of a scene equals --set on its text, regardless of earlier variants", "[scene_set]") {
    SceneDocument document;
    document.path = "s.json";
    document.scene = scene_with(smallest, {"/lights/0/name=Bulb", "/objects/-/mesh/primitive=torus"});
    REQUIRE(problem_of(load_meshes(document.scene, "s.json", "")) == nullptr);
    const Object& torus = document.scene.objects[0];
    const SceneVariants variants(document);
    const std::string text = scene_text(document.scene);
    for (const std::vector<Assignment>& set :
         std::vector<std::vector<Assignment>>{{{"/lights/0/type", "directional"}, {"/display/exposure", "2"}},
                                              {{"/display/exposure", "-1"}},
                                              {{"/lights/-/name", "Second"}},
                                              {{"/objects/0/mesh/detail", "12"}},
                                              {}}) {
        const Result<Scene> made = variants.with(set), expected = parse_scene(text, "s.json", set);
        REQUIRE((problem_of(made) == nullptr) == (problem_of(expected) == nullptr));
        if (const Problem* problem = problem_of(made)) {
            CHECK(problem->text() == problem_of(expected)->text());
            continue;
        }
        CHECK(same_description(std::get<Scene>(made), std::get<Scene>(expected)));
        const Object& object = std::get<Scene>(made).objects[0];
        REQUIRE(object.mesh != nullptr);
        CHECK((object.mesh == torus.mesh) == (object.source == torus.source));
    }
}

TEST_CASE("a pointer to a missing value is refused", "[scene_set]") {
    const std::string expected = "; expected POINTER=JSON, such as /display/exposure=2";
    CHECK(problem_with(smallest, {"/display"}) == "--set: \"/display\" has no \"=\"" + expected);
    CHECK(problem_with(smallest, {"display=1"}) ==
          "--set: \"display=1\" does not begin with \"/\"" + expected);
    CHECK(problem_with(smallest, {"=1"}) == "--set: \"=1\" does not begin with \"/\"" + expected);
    CHECK(problem_with(smallest, {"/lights/1/name=a"}) ==
          "--set: /lights/1/name: \"1\" is past the end of the array; expected 0 or -, for a new one");
    CHECK(problem_with(R"({"glint": 1, "lights": [{}, {}]})", {"/lights/3/name=a"}) ==
          "--set: /lights/3/name: \"3\" is past the end of the array; expected 0 to 2; 2 or - for a new one "
          "at the end");
    CHECK(problem_with(smallest, {"/camera/eye/4=1"}) ==
          "--set: /camera/eye/4: \"4\" is past the end of the array; expected 0 to 2");
    const std::string escape = problem_with(smallest, {R"(/about="\ud800")"});
    CHECK(escape.find("an escape that JSON does not have") != std::string::npos);
    CHECK(problem_with(smallest, {R"(/about="\")"}).find("a string that does not end") != std::string::npos);
    CHECK(problem_with(smallest, {"/lights/00/name=a"}).find("\"00\" is not an index of an array") !=
          std::string::npos);
    CHECK(problem_with(smallest, {"/lights/99999999999999999999/name=a"}).find("is not an index") !=
          std::string::npos);
    CHECK(problem_with(smallest, {"/glint/x=1"}) ==
          "--set: /glint/x: \"x\" cannot be added to a value that contains no others; expected a pointer to "
          "a value in the scene");
    CHECK(problem_with(smallest, {"/a~b=1"}) ==
          "--set: /a~b: a ~ in the pointer is not followed by 0 or 1; expected ~0 for ~, ~1 for /");
    CHECK(problem_with(smallest, {"/~01~1=1"}) == "--set: /~01~1: unknown key \"~1/\"; expected \"npr\"");
}
