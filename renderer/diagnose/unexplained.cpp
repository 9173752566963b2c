#include "renderer/diagnose/unexplained.h"

#include "renderer/diagnose/difference.h"
#include "renderer/diagnose/display_finding.h"
#include "renderer/diagnose/other_aspect.h"

namespace glint {
namespace {

/// The display changes to try for a picture that nothing explains, the smallest first.
std::vector<DisplayChange> cautious_changes(const Exhibit& exhibit, const Judged& none) {
    constexpr std::uint64_t clearly = 4;  // a gain or a curve takes away something of any difference
    DisplayChange turned = none.change;
    turned.before = turned.after = Code::Same;
    turned.gain = 1;
    turned.soft = false;
    std::vector<DisplayChange> changes{exhibit.least_change};
    std::uint64_t least = score(exhibit, none.drawing, changes.front()).unlike;
    for (const DisplayChange& change : {turned, none.change}) {
        const std::uint64_t unlike = score(exhibit, none.drawing, change).unlike;
        if (clearly * unlike > least) continue;
        least = unlike;
        changes.push_back(change);
    }
    return changes;
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
    constexpr double much = 0.5;  // the nearest candidates are kept if they explain this share
    std::erase_if(d.candidates, [](const Candidate& c) { return c.explained < much; });
    constexpr double nearly_all = 0.9;
    (void)renderer.render(under_mistakes(scene, {}), d.size);
    for (const DisplayChange& change : cautious_changes(exhibit, none)) {
        d.display = display_finding(exhibit, none.drawing.picture, change);
        describe_difference(d, renderer, exhibit, change, scene.display);
        if (!d.terms.empty() && d.terms.front().explained > nearly_all) break;
    }
}

}  // namespace glint
