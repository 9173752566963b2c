// Compares the rows of models/fields/scene_fields.h with the printed, read and written values of a scene.
#include "models/fields/scene_fields.h"

#include <map>
#include <set>

#include "models/json/json.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/random_scene.h"

using namespace glint;

namespace {

/// Every number of a document except the version, by its pointer.
void collect_numbers(const Json& at, const std::string& pointer, std::map<std::string, double>& numbers) {
    if (at.is_number() && pointer != "/glint") numbers[pointer] = at.get<double>();
    if (!at.is_structured()) return;
    for (const auto& item : at.items()) collect_numbers(item.value(), pointer + "/" + item.key(), numbers);
}

Scene everything() {
    Scene scene;
    scene.lights.emplace_back();
    scene.objects.emplace_back();
    return scene;
}

/// Calls check(row) for all rows of all structs.
template <class Check> class EveryRow {
  public:
    explicit EveryRow(Check check) : check_(check) {}
    template <class Kind, class T> void operator()(const Row& row, const Kind& kind, const T& member) const {
        check_(row);
        inside(kind, member);
    }
    template <class T> void of(const T& value) const {
        std::set<std::string_view> keys;
        fields(value, [&](const Row& row, const auto&, const auto&) {
            INFO(row.key);
            CHECK(keys.insert(row.key).second);
        });
        fields(value, *this);
    }

  private:
    template <class T> void inside(const Group&, const T& value) const { of(value); }
    template <class T> void inside(const List&, const std::vector<T>&) const { of(T{}); }
    void inside(const OneProjection&, const Projection&) const {
        of(Perspective{});
        of(Orthographic{});
        of(Frustum{});
    }
    void inside(const OneMesh&, const MeshSource&) const {
        of(PrimitiveMesh{});
        of(MeshFile{});
    }
    template <class Kind, class T> void inside(const Kind&, const T&) const {}

    Check check_;
};

}  // namespace

TEST_CASE("every field has its own key, a label and a help text", "[fields]") {
    int rows = 0;
    EveryRow([&](const Row& row) {
        ++rows;
        INFO(row.key);
        CHECK_FALSE(row.key.empty());
        CHECK(*row.label != 0);
        CHECK(*row.help != 0);
    }).of(everything());
    CHECK(rows > 100);
}

/// Whether the text omits the number because the value is its default.
bool is_omitted(const std::string& pointer, double value) {
    if (pointer.ends_with("/spot/inner_deg")) return value == 180;
    if (pointer.starts_with("/shading/mistakes/only_")) return value == -1;
    if (value != 0) return false;
    return pointer == "/shading/power_table" || pointer.ends_with("/form") ||
           pointer.ends_with("/highlight_form") || pointer.ends_with("/mesh/part") ||
           pointer.ends_with("/mesh/decimate") || pointer.ends_with("/mesh/subdivide");
}

TEST_CASE("the numbers of a scene are those in its JSON text", "[fields]") {
    RandomScene random(11);
    for (int i = 0; i < 60; ++i) {
        const Scene scene = random.scene();
        std::map<std::string, double> printed, found;
        collect_numbers(Json::parse(scene_text(scene)), "", printed);
        for (const SceneNumber& number : numbers_of(scene)) {
            if (is_omitted(number.pointer, number.value)) continue;
            if (scene.transport == Transport{} && number.pointer.starts_with("/transport/")) continue;
            CHECK(found.emplace(number.pointer, number.value).second);
            const auto alone = number_at(scene, number.pointer);
            REQUIRE(alone);
            CHECK(alone->value == number.value);
        }
        REQUIRE(found.size() == printed.size());
        for (const auto& [pointer, value] : printed) {
            INFO(pointer);
            REQUIRE(found.contains(pointer));
            CHECK(static_cast<float>(found[pointer]) == static_cast<float>(value));
        }
    }
}

TEST_CASE("setting a number in place gives the same scene as setting it in the text", "[fields]") {
    Scene scene = everything();
    Light sun;
    sun.kind = LightKind::Directional;
    sun.position = {1, 2, 3, 0};
    scene.lights.push_back(sun);
    const SceneDocument document{scene, "s.json", "", {}};
    for (const SceneNumber& number : numbers_of(scene)) {
        for (const double value :
             {-1e8, -2.0, 0.0, 1e-40, 1e-20, 0.25, 1.0, 4.0, 45.0, 100.0, 180.0, 5000.0, 1e6, 1e7}) {
            INFO(number.pointer << " = " << value);
            Scene set = scene;
            const std::optional<Problem> refused = set_number(set, number.pointer, value);
            // The reader's result for `--set`, without meshes.
            const Result<Scene> read =
                parse_scene(scene_text(scene), "s.json", {{number.pointer, Json(value).dump()}});
            CHECK(refused.has_value() == (problem_of(read) != nullptr));
            CHECK(set == (refused ? scene : std::get<Scene>(read)));
        }
    }
}

TEST_CASE("exactly the values that a scene file cannot represent are violations", "[fields]") {
    const Scene valid = everything();
    constexpr float inf = std::numeric_limits<float>::infinity();
    int refused = 0;
    for (const SceneNumber& number : numbers_of(valid)) {
        if (number.count) continue;
        for (const float value :
             {inf, -inf, std::nanf(""), -1e8f, -1.0f, 0.0f, 0.5f, 95.0f, 180.0f, 1e7f, 1e8f}) {
            INFO(number.pointer << " = " << value);
            Scene changed = valid;
            *number_at(changed, number.pointer)->place = value;
            const std::optional<Problem> found = violation_since(valid, changed);
            const Result<Scene> read = parse_scene(scene_text(changed), "s.json");
            if (number.is_w && value > 0) {
                CHECK(found.has_value());  // the reader divides by this number and stores the quotient
                continue;
            }
            CHECK(found.has_value() == (problem_of(read) != nullptr));
            if (!found) continue;
            ++refused;
            CHECK(number.pointer.starts_with(found->pointer));
        }
    }
    CHECK(refused > 300);
    CHECK_FALSE(violation_since(valid, valid));
}

TEST_CASE("a number that the scene does not have cannot be set", "[fields]") {
    Scene scene = everything();
    const Scene before = scene;
    for (const char* pointer :
         {"", "/", "/lights/1/intensity", "/lights/0", "/lights/-/intensity", "/lights/0/name",
          "/camera/eye/3", "/camera/projection/height", "/shading/terms/diffuse"}) {
        INFO(pointer);
        const std::optional<Problem> problem = set_number(scene, pointer, 1);
        REQUIRE(problem);
        CHECK(problem->file.empty());  // the window calls set_number() as well
        CHECK(scene == before);
    }
}

TEST_CASE("handles to numbers edit the scene in place", "[fields]") {
    Scene scene = everything();
    const auto handle = number_at(scene, "/lights/0/falloff/quadratic");
    REQUIRE(handle);
    REQUIRE(handle->place == &scene.lights[0].falloff.quadratic);
    CHECK(handle->initial == 0);
    CHECK(number_at(scene, "/objects/0/material/f0/2")->initial == Approx(0.04));
    CHECK(number_at(scene, "/objects/0/mesh/detail")->count.has_value());
    CHECK_FALSE(number_at(scene, "/lights/0/spot/exponent")->applies);  // a point light has no cone
    CHECK_FALSE(number_at(scene, "/objects/0/material/diffuse/0")->moves_faces);
    CHECK(number_at(scene, "/objects/0/transform/scale/0")->moves_faces);
}

TEST_CASE("a number is described by its label in the panel and its channel or axis", "[fields]") {
    const Scene scene = everything();
    CHECK(words_of_pointer(scene, "/lights/0/diffuse/0") == "diffuse red");
    CHECK(words_of_pointer(scene, "/lights/0/position/3") == "position w");
    CHECK(words_of_pointer(scene, "/lights/0/spot/cutoff_deg") == "cone cutoff");
    CHECK(words_of_pointer(scene, "/lights/0/falloff/linear") == "falloff linear");
    CHECK(words_of_pointer(scene, "/objects/0/material/f0/2") == "F0 blue");
    CHECK(words_of_pointer(scene, "/objects/0/transform/rotate_deg/1") == "rotate y");
    CHECK(words_of_pointer(scene, "/camera/projection/fov_y_deg") == "view angle");
    CHECK(words_of_pointer(scene, "/npr/cool/1") == "cool green");
    CHECK(words_of_pointer(scene, "/global_ambient/2") == "ambient blue");
    CHECK(words_of_pointer(scene, "/no/such_thing") == "no such thing");
}

TEST_CASE("each word of a closed set maps back to its enumerator", "[fields]") {
    for (const Reflection r : enumerators<Reflection>) CHECK(from_name<Reflection>(name_of(r)) == r);
    for (const Primitive p : enumerators<Primitive>) CHECK(from_name<Primitive>(name_of(p)) == p);
    CHECK(count_of<Primitive>() == 13);
    CHECK(count_of<Reflection>() == 7);
    CHECK_FALSE(from_name<Reflection>("Phong"));
    CHECK_FALSE(from_name<Reflection>(""));
}
