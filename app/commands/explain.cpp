// glint explain: prints every number behind one pixel.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "models/json/json.h"
#include "renderer/debug_views/sensitivity.h"
#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

enum class ExplanationFormat { Text, Json, Latex };

struct ExplainArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    std::optional<Pixel> pixel;
    ExplanationFormat format = ExplanationFormat::Text;
    bool sensitivity = false;
};

std::string formatted(const Explanation& explanation, const Scene& scene, ExplanationFormat format) {
    switch (format) {
    case ExplanationFormat::Text:
        return explain_text(explanation, scene);
    case ExplanationFormat::Json:
        return explain_json(explanation);
    case ExplanationFormat::Latex:
        return explain_latex(explanation, scene);
    }
    return {};  // not reached
}

/// Returns the explanation as JSON, including the sensitivities.
std::string with_sensitivities(const Explanation& explanation, const Sensitivities& s) {
    Json json = explanation_json(explanation);
    Json& numbers = json["sensitivity"] = Json::array();
    for (const Sensitivity& n : s.numbers)
        numbers.push_back({{"pointer", n.pointer},
                           {"value", n.value},
                           {"change", {n.change.x, n.change.y, n.change.z}},
                           {"one_sided", n.one_sided}});
    json["no_effect"] = s.no_effect;
    json["fixed"] = s.fixed;
    return json_text(json);
}

Outcome explain(const ExplainArguments& arguments) {
    require_file(arguments.scene);
    if (!arguments.pixel) throw wrong_usage("--pixel", "is missing", "X,Y as in --pixel 640,360");
    const Pixel pixel = *arguments.pixel;
    if (arguments.sensitivity && arguments.format == ExplanationFormat::Latex)
        throw wrong_usage("--sensitivity", "is not available as LaTeX", "--format text or json");
    const SceneDocument document = open_scene(arguments.scene);
    const PictureSize size = size_to_draw(arguments.size, document);
    require_inside("--pixel", pixel, size);

    Renderer renderer(arguments.scene.threads);
    Progress drawing("picture", 1);
    drawing.show_paths(renderer);
    (void)renderer.render(document.scene, size);
    const Explanation explanation = renderer.explain(pixel.x, pixel.y);
    Outcome outcome{formatted(explanation, document.scene, arguments.format), document.warnings,
                    ExitStatus::Done};
    warn_of_samples(document, outcome.warnings);
    if (arguments.sensitivity) {
        std::optional<Progress> progress;
        const Sensitivities s = take(sensitivities(document, size, pixel.x, pixel.y, arguments.scene.threads,
                                                   [&progress](std::size_t done, std::size_t all) {
                                                       if (!progress) progress.emplace("number", all);
                                                       progress->at(done);
                                                   }));
        progress.reset();
        outcome.output = arguments.format == ExplanationFormat::Json
                             ? with_sensitivities(explanation, s)
                             : outcome.output + "\n" + sensitivity_text(s);
    }
    outcome.warnings.insert(outcome.warnings.end(), renderer.warnings().begin(), renderer.warnings().end());
    return outcome;
}

Run declare_explain(Options& options) {
    auto arguments = std::make_shared<ExplainArguments>();
    add_scene(options, arguments->scene);
    options.add_value(
        "--pixel", "X,Y", "the pixel; 0,0 is the top left",
        [&pixel = arguments->pixel](const std::string& text) { pixel = read_pixel("--pixel", text); });
    add_size(options, arguments->size);
    options.add_value(
        "--format", "FORMAT", "text (default), json (fields: docs/explain.md) or latex (needs amsmath)",
        [&format = arguments->format](const std::string& text) {
            format = static_cast<ExplanationFormat>(read_word("--format", text, {"text", "json", "latex"}));
        });
    options.add_flag("--sensitivity", arguments->sensitivity,
                     "also print how the pixel changes with each number in the scene");
    return [arguments] { return explain(*arguments); };
}

}  // namespace

Command explain_command() {
    return {"explain", "FILE --pixel X,Y", "show the lighting equation of a pixel with its numbers",
            "glint explain teapot.json --pixel 640,360 --format json", declare_explain};
}

}  // namespace glint
