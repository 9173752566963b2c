// glint explain: every number behind one pixel.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/progress.h"
#include "models/json/json_value.h"
#include "models/memory_limit.h"
#include "renderer/inspect/debug_views/sensitivity.h"
#include "renderer/inspect/explain/explain_format.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

enum class ExplanationFormat { Text, Json, Latex };

struct ExplainArguments {
    SceneArguments scene;
    PictureSize size;
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

/// The explanation's JSON with the sensitivities in it.
std::string with_sensitivities(const Explanation& explanation, const Sensitivities& s) {
    JsonValue json = explanation_json(explanation);
    JsonValue& numbers = json["sensitivity"] = JsonValue::array();
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
    require_inside("--pixel", pixel, arguments.size);
    if (arguments.sensitivity && arguments.format == ExplanationFormat::Latex)
        throw wrong_usage("--sensitivity", "is not available as LaTeX", "--format text or json");
    const SceneDocument document = open_scene(arguments.scene);

    Renderer renderer(arguments.scene.threads);
    (void)renderer.render(document.scene, arguments.size);
    const MemoryShare share(memory_need(MemoryUse::Output, explanation_memory(document.scene)));
    const Explanation explanation = renderer.explain(pixel.x, pixel.y);
    Outcome outcome{formatted(explanation, document.scene, arguments.format), document.warnings,
                    ExitStatus::Done};
    if (arguments.sensitivity) {
        std::optional<Progress> progress;
        const Sensitivities s =
            take(sensitivities(document, arguments.size, pixel.x, pixel.y, arguments.scene.threads,
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
        "--format", "FORMAT", "text, the default, json (docs/explain.md) or latex (needs amsmath)",
        [&format = arguments->format](const std::string& text) {
            format = static_cast<ExplanationFormat>(read_word("--format", text, {"text", "json", "latex"}));
        });
    options.add_flag("--sensitivity", arguments->sensitivity,
                     "also how much the pixel changes with each number of the scene");
    return [arguments] { return explain(*arguments); };
}

}  // namespace

Command explain_command() {
    return {"explain", "FILE --pixel X,Y", "tells every number behind one pixel",
            "glint explain teapot.json --pixel 640,360 --format json", declare_explain};
}

}  // namespace glint
