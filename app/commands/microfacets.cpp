// glint microfacets: simulates a rough surface as many mirrors that reflect a bundle of rays.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "lessons/lesson.h"
#include "renderer/answers/answers.h"

namespace glint {
namespace {

struct MicrofacetArguments {
    MicrofacetOptions options;
    std::optional<double> view_deg;
    int threads = 0;  // accepted by every command; unused here
};

Outcome microfacets(const MicrofacetArguments& arguments) {
    MicrofacetOptions options = arguments.options;
    options.view_deg = arguments.view_deg.value_or(options.light_deg);
    return {json_text(microfacets_json(options)), {}, ExitStatus::Done};
}

Run declare_microfacets(Options& options) {
    auto arguments = std::make_shared<MicrofacetArguments>();
    MicrofacetOptions& o = arguments->options;
    options.add_value("--roughness", "R",
                      "0 to 1; the tilts' standard deviation is R x 90 degrees; default 0.25",
                      [&o](const std::string& text) { o.roughness = read_amount("--roughness", text, 1); });
    options.add_value(
        "--angle", "DEG", "angle between the light and the normal, 0 to 89; default 30",
        [&o](const std::string& text) { o.light_deg = read_amount("--angle", text, max_microfacets_deg); });
    options.add_value(
        "--view", "DEG",
        "angle of the viewer on the other side of the normal, 0 to 89; default: the light's angle",
        [&view = arguments->view_deg](const std::string& text) {
            view = read_amount("--view", text, max_microfacets_deg);
        });
    options.add_value("--rays", "N", "number of rays, 1 to 100000; default 200",
                      [&o](const std::string& text) { o.rays = read_count("--rays", text, 1, 100000); });
    options.add_value("--facets", "N", "number of facets, 4 to 100000; default 400",
                      [&o](const std::string& text) { o.facets = read_count("--facets", text, 4, 100000); });
    options.add_value("--seed", "S", "a different seed gives a different surface; default 1",
                      [&o](const std::string& text) {
                          o.seed = static_cast<std::uint32_t>(read_count("--seed", text, 0, 2147483647));
                      });
    add_threads(options, arguments->threads);
    return [arguments] { return microfacets(*arguments); };
}

}  // namespace

Command microfacets_command() {
    return {"microfacets", "", "simulate rays on a rough surface of mirrors, as JSON",
            "glint microfacets --roughness 0.3 --angle 60 --rays 1000", declare_microfacets};
}

}  // namespace glint
