// The `--set` options of each explanation, against the scene that the search draws for it.

#include <string>
#include <vector>

#include "diagnose/search/supposition.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

namespace glint::test {
namespace {

/// The scene as a user draws it with the options.
Scene set_by_options(const Scene& scene, const std::vector<std::string>& options) {
    std::vector<Assignment> assignments;
    for (const std::string& option : options) {
        const Result<Assignment> read = parse_assignment(option);
        REQUIRE(problem_of(read) == nullptr);
        assignments.push_back(std::get<Assignment>(read));
    }
    Result<Scene> read = parse_scene(scene_text(scene), "scene.json", assignments);
    INFO((problem_of(read) != nullptr ? problem_of(read)->text() : ""));
    REQUIRE(problem_of(read) == nullptr);
    Scene set = std::get<Scene>(std::move(read));
    for (std::size_t i = 0; i < set.objects.size(); ++i) set.objects[i].mesh = scene.objects[i].mesh;
    return set;
}

std::vector<Supposition> all_edits(const Scene& scene) {
    std::vector<Supposition> all = left_out_edits(scene);
    for (const auto& list : {setting_edits(scene), mistake_edits()})
        all.insert(all.end(), list.begin(), list.end());
    for (const Supposition& mistake : mistake_edits())
        for (const Supposition& e : restricted(mistake, scene)) all.push_back(e);
    for (const FreeNumber& number : free_numbers(scene)) all.push_back(number_edit(number, 0.5f, scene));
    for (const Convention& c : conventions_of(scene)) {
        Supposition e = with_convention({}, c);
        e.set = e.convention_set;
        all.push_back(e);
    }
    return all;
}

}  // namespace

TEST_CASE("the options of every explanation set the scene that was drawn for it", "[diagnose][release]") {
    for (const char* name : {"every-term.json", "lost-highlight.json"}) {
        const Scene scene = under_mistakes(shipped(name).scene, {});
        for (const Supposition& e : all_edits(scene)) {
            INFO(name << ": " << e.name << ": " << e.words);
            REQUIRE_FALSE(e.set.empty());
            Scene drawn = e.applied(scene);
            drawn.shading.mistakes.only = e.only;
            CHECK(set_by_options(scene, e.set) == drawn);
        }
    }
}

TEST_CASE("a mistake limited to one light does not change pixels lit only by other lights", "[diagnose]") {
    const Scene right = under_mistakes(shipped("every-term.json").scene, {});
    Scene wrong = right;
    wrong.shading.mistakes.half_lambert = true;
    Renderer renderer(1);
    const PictureSize size{80, 60};
    const Picture everywhere = renderer.render(wrong, size);
    const Picture correct = renderer.render(right, size);
    wrong.shading.mistakes.only.light = 0;
    const Picture first = renderer.render(wrong, size);
    CHECK(first.rgba != everywhere.rgba);
    CHECK(first.rgba != correct.rgba);
    // With the other lights off, the scope makes no difference.
    for (std::size_t i = 1; i < wrong.lights.size(); ++i) wrong.lights[i].enabled = false;
    const Picture scoped = renderer.render(wrong, size);
    wrong.shading.mistakes.only = {};
    CHECK(renderer.render(wrong, size).rgba == scoped.rgba);
}

}  // namespace glint::test
