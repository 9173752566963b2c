// Tests of docs/scene_file.md: its example can be read, and it names every key and every accepted word.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "models/fields/choices.h"
#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/field_table.h"

using namespace glint;

namespace {

std::string document() {
    return std::get<std::string>(read_file(project_file("docs/scene_file.md"), 1 << 20));
}

void collect_keys(const nlohmann::json& value, std::set<std::string>& keys) {
    for (const auto& [key, inner] : value.items()) {
        if (value.is_object()) keys.insert(key);
        if (inner.is_structured()) collect_keys(inner, keys);
    }
}

/// A scene whose file has every key except the mistakes' keys, which docs/diagnose.md lists.
Scene full_scene() {
    Scene scene;
    scene.lights.emplace_back();
    scene.objects.resize(2);
    scene.objects[1].source = MeshFile{"bunny.obj"};
    return scene;
}

/// Whether `word` is formatted as code, alone or as the end of a path.
bool is_documented(const std::string& text, const std::string& word) {
    return text.find("`" + word + "`") != std::string::npos ||
           text.find("/" + word + "`") != std::string::npos;
}

template <class Enum> void check_names(const std::string& text) {
    for (const std::string& name : names_of<Enum>()) {
        INFO(name);
        CHECK(is_documented(text, name));
    }
}

}  // namespace

TEST_CASE("the example in the documentation is a scene", "[docs]") {
    const std::string text = document();
    const std::size_t start = text.find("```json\n") + 8;
    const Result<Scene> scene = parse_scene(text.substr(start, text.find("```", start) - start), "example");
    REQUIRE(problem_of(scene) == nullptr);
    CHECK(std::get<Scene>(scene).objects.size() == 2);
}

TEST_CASE("the documentation names every key in a scene", "[docs]") {
    const std::string text = document();
    std::set<std::string> keys;
    Scene scene = full_scene();
    for (const Projection& projection :
         {Projection(Perspective{}), Projection(Orthographic{}), Projection(Frustum{})}) {
        scene.camera.projection = projection;
        collect_keys(nlohmann::json::parse(scene_text(scene)), keys);
    }
    CHECK(keys.size() > 50);
    for (const std::string& key : keys) {
        INFO(key);
        const bool section = key == "terms" || text.find("/" + key + "`") != std::string::npos ||
                             text.find("`" + key + "/") != std::string::npos;
        CHECK((section || is_documented(text, key)));
    }
}

TEST_CASE("the documentation names every word that a key accepts", "[docs]") {
    const std::string text = document();
    check_names<LightKind>(text);
    check_names<LightSpace>(text);
    check_names<Primitive>(text);
    check_names<NormalSource>(text);
    check_names<NormalWeighting>(text);
    check_names<ShadingMode>(text);
    check_names<Reflection>(text);
    check_names<Interpolation>(text);
    check_names<FlatPoint>(text);
    check_names<Cull>(text);
    check_names<Rules>(text);
    check_names<Transfer>(text);
}

namespace {

/// Compares the lines from `<!-- rows: NAME -->` to `<!-- end -->`, or writes them if GLINT_UPDATE is set.
void check_table(const std::string& name, const std::string& expected) {
    INFO("GLINT_UPDATE=1 updates this table of docs/scene_file.md: " << name);
    std::string text = document();
    const std::string begin = "<!-- rows: " + name + " -->\n";
    const std::size_t start = text.find(begin);
    REQUIRE(start != std::string::npos);
    const std::size_t from = start + begin.size(), end = text.find("<!-- end -->", from);
    REQUIRE(end != std::string::npos);
    if (std::getenv("GLINT_UPDATE") != nullptr) {
        text.replace(from, end - from, expected);
        REQUIRE(problem_of(write_file(project_file("docs/scene_file.md"), text)) == nullptr);
        return;
    }
    CHECK(text.substr(from, end - from) == expected);
}

}  // namespace

TEST_CASE("the tables in the documentation match the fields' rows", "[docs]") {
    check_table("camera", test::field_table(Camera{}));
    check_table("light", test::field_table(Light{}));
    check_table("object", test::field_table(Object{}));
    check_table("primitives", test::primitive_table());
    check_table("shading", test::field_table(Shading{}));
    check_table("npr", test::field_table(Npr{}));
    check_table("transport", test::field_table(Transport{}));
    check_table("display", test::field_table(Display{}));
}
