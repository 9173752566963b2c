// Two mistakes at once, and the report if no pair explains the picture.
#include "diagnose/diagnose.h"
#include "diagnose/diagnosis_format.h"
#include "tests/diagnose/wrong_pictures.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::test;

namespace {

DiagnosisOptions of_pairs() {
    DiagnosisOptions options;
    options.pairs = true;
    return options;
}

Picture drawn(const Scene& scene, PictureSize size) {
    Renderer renderer(1);
    return renderer.render(scene, size);
}

}  // namespace

TEST_CASE("a mistake with no effect alone is found with one that makes it visible", "[diagnose]") {
    SceneDocument document = diagnosed_scene(2);
    for (Object& object : document.scene.objects) object.material.specular = glm::vec3(0);
    Scene wrong = document.scene;
    wrong.shading.mistakes.unnormalized_view = true;
    REQUIRE(drawn(wrong, diagnosed_size).rgba == drawn(document.scene, diagnosed_size).rgba);
    wrong.shading.mistakes.coefficients_swapped = true;
    const Diagnosis d = diagnose(document, drawn(wrong, diagnosed_size), of_pairs());
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "unnormalized_view + coefficients_swapped");
    CHECK(d.candidates[0].residual == 0);
}

TEST_CASE("two mistakes that make a pattern of faces are found at unusual picture sizes", "[diagnose]") {
    const SceneDocument document = shipped("lost-highlight.json");
    Scene wrong = document.scene;
    wrong.shading.mistakes.some_faces_flipped = wrong.shading.mistakes.normals_as_points = true;
    for (const PictureSize size : {PictureSize{200, 300}, {320, 185}}) {
        const Diagnosis d = diagnose(document, drawn(wrong, size), of_pairs());
        REQUIRE(d.verdict == Verdict::Mistake);
        CHECK(name_of(d.candidates[0].mistakes) == "normals_as_points + some_faces_flipped");
        CHECK(d.candidates[0].residual == 0);
        CHECK(display_text(d.display).empty());
    }
}

TEST_CASE("the report on an unexplained picture says whether pairs were tried", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Picture picture = drawn(document.scene, diagnosed_size);
    for (std::size_t i = 0; i < picture.rgba.size() / 2; ++i)
        if (i % 4 != 3) picture.rgba[i] = static_cast<std::uint8_t>(255 - picture.rgba[i]);
    const auto says = [&](const DiagnosisOptions& options) {
        const std::string text = diagnosis_text(diagnose(document, picture, options), document.scene);
        return text.substr(0, text.find('\n'));
    };
    CHECK(says({}).ends_with("of the pixels are wrong, and no single mistake explains them."));
    CHECK(says(of_pairs())
              .ends_with("of the pixels are wrong, and no mistake explains them, alone or paired; pairs "
                         "were tried on a small picture."));
}

TEST_CASE("a mistake that explains no wrong pixel is not a candidate", "[diagnose]") {
    const SceneDocument document = shipped("still-life.json");
    Scene wrong = document.scene;
    wrong.shading.mistakes.missing_pi = true;
    const Diagnosis d = diagnosed(document, drawn(wrong, {320, 180}));
    REQUIRE(d.verdict == Verdict::Mistake);
    CHECK(name_of(d.candidates[0].mistakes) == "missing_pi");
    for (const Candidate& candidate : d.candidates) CHECK(explained_percent(candidate) > 0);
}
