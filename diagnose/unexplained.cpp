#include "diagnose/unexplained.h"

#include <array>
#include <utility>

#include "diagnose/difference.h"
#include "diagnose/display_finding.h"
#include "diagnose/other_aspect.h"

namespace glint {
namespace {

/// Further display changes to try for a picture that nothing explains, the smaller first.
std::array<DisplayChange, 2> larger_changes(const DisplayChange& supposed) {
    DisplayChange turned = supposed;
    turned.before = turned.after = Code::Same;
    turned.gain = 1;
    turned.soft = false;
    return {turned, supposed};
}

/// What differs under the smallest change that leaves little unexplained: a gain or a curve takes away
/// something of any difference, and so does a term of the equation.
DescribedDifference cautious_difference(DisplayChange& change, const Renderer& renderer,
                                        const Exhibit& exhibit, const DisplayChange& supposed,
                                        const Display& display) {
    constexpr double clearly = 4;
    change = exhibit.least_change;
    DescribedDifference best = describe_difference(renderer, exhibit, change, display);
    for (const DisplayChange& tried : larger_changes(supposed)) {
        if (tried == change) continue;
        DescribedDifference found = describe_difference(renderer, exhibit, tried, display);
        if (clearly * found.pixels_left >= best.pixels_left) continue;
        best = std::move(found);
        change = tried;
    }
    return best;
}

/// Why the picture cannot be of this scene, if it cannot.
std::optional<std::string> why_not_comparable(Renderer& renderer, const Scene& scene,
                                              const Exhibit& exhibit) {
    if (const auto aspect = other_aspect(renderer, scene, exhibit.wrong))
        return "the picture shows the scene as it is at the aspect " + *aspect + ", stretched";
    return other_outline(exhibit);
}

}  // namespace

void say_what_is_unexplained(Diagnosis& d, Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                             const Judged& none) {
    if (const auto why = why_not_comparable(renderer, scene, exhibit)) {
        d = Diagnosis{};
        d.size = exhibit.wrong.size;
        d.why = *why;
        return;
    }
    d.verdict = Verdict::NotInCatalogue;
    (void)renderer.render(under_mistakes(scene, {}), d.size);
    DisplayChange change;
    DescribedDifference found = cautious_difference(change, renderer, exhibit, none.change, scene.display);
    constexpr double much = 0.5;  // the nearest candidates are kept if they explain this share
    std::erase_if(d.candidates, [&](const Candidate& c) {
        return c.explained < much || !are_of_one_display(c.change, change);
    });
    d.display = display_finding(exhibit, none.drawing, change);
    d.pixels = count_unlike(exhibit, none.drawing, change);
    d.regions = std::move(found.regions);
    d.terms = std::move(found.terms);
}

}  // namespace glint
