// glint microfacets: a rough surface as many mirrors, and what becomes of a bundle of rays.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/lesson/run_limits.h"
#include "renderer/inspect/answers/reflectance_answers.h"

namespace glint {
namespace {

struct MicrofacetArguments {
    MicrofacetOptions options;
    std::optional<double> view_deg;
    int threads = 0;  // taken on every line
};

Outcome microfacets(const MicrofacetArguments& arguments) {
    MicrofacetOptions options = arguments.options;
    options.view_deg = arguments.view_deg.value_or(options.light_deg);
    return {json_text(microfacets_json(options)), {}, ExitStatus::Done};
}

Run declare_microfacets(Options& options) {
    auto arguments = std::make_shared<MicrofacetArguments>();
    MicrofacetOptions& o = arguments->options;
    options.add_value("--roughness", "R", "0 to 1, 90 degrees of tilt to 1; 0.25 when not given",
                      [&o](const std::string& text) { o.roughness = read_amount("--roughness", text, 1); });
    options.add_value(
        "--angle", "DEG", "angle of the light to the normal, 0 to 89; 30 when not given",
        [&o](const std::string& text) { o.light_deg = read_amount("--angle", text, max_microfacets_deg); });
    options.add_value("--view", "DEG",
                      "angle of the viewer, 0 to 89 on the other side; the mirror angle when not given",
                      [&view = arguments->view_deg](const std::string& text) {
                          view = read_amount("--view", text, max_microfacets_deg);
                      });
    options.add_value("--rays", "N", "1 to 100000; 200 when not given",
                      [&o](const std::string& text) { o.rays = read_count("--rays", text, 1, 100000); });
    options.add_value("--facets", "N", "4 to 100000; 400 when not given",
                      [&o](const std::string& text) { o.facets = read_count("--facets", text, 4, 100000); });
    options.add_value("--seed", "S", "another seed, another surface; 1 when not given",
                      [&o](const std::string& text) {
                          o.seed = static_cast<std::uint32_t>(read_count("--seed", text, 0, 2147483647));
                      });
    add_threads(options, arguments->threads);
    return [arguments] { return microfacets(*arguments); };
}

}  // namespace

Command microfacets_command() {
    return {"microfacets", "", "bounces rays off a rough surface of mirrors, as JSON",
            "glint microfacets --roughness 0.3 --angle 60 --rays 1000", declare_microfacets};
}

}  // namespace glint
