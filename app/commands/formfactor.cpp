// glint formfactor: prints the fraction of the light from one object that arrives at another.
#include <fmt/format.h>

#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/json/json.h"
#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "renderer/transport/form_factor.h"

namespace glint {
namespace {

struct FormFactorArguments {
    SceneArguments scene;
    std::string from, to;
    int rays = 1'000'000, seed = 1;
    bool as_json = false;
};

/// Returns the index of the only object with that name, or of the object with that number, counted from 0.
std::size_t object_of(const std::string& option, const std::string& word, const Scene& scene) {
    std::vector<std::string> names;
    std::size_t found = scene.objects.size(), count = 0;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        names.push_back(scene.objects[i].name);
        if (names.back() != word && std::to_string(i) != word) continue;
        found = i;
        ++count;
    }
    if (count == 0)
        throw wrong_usage(option, "no object is named " + in_quotes(word),
                          names.empty() ? "a scene with objects" : "a name such as " + nearest(word, names));
    if (count > 1)
        throw wrong_usage(option, fmt::format("{} objects are named {}", count, in_quotes(word)),
                          "the object's number, counted from 0");
    if (!scene.objects[found].visible)
        throw wrong_usage(option, in_quotes(word) + " is not visible", "a visible object");
    return found;
}

Outcome formfactor(const FormFactorArguments& arguments) {
    require_file(arguments.scene);
    require_given(arguments.from, "--from", "the name of an object");
    require_given(arguments.to, "--to", "the name of an object");
    const SceneDocument document = open_scene(arguments.scene);
    const std::size_t from = object_of("--from", arguments.from, document.scene),
                      to = object_of("--to", arguments.to, document.scene);
    if (const auto problem = too_large(document.scene)) throw LimitExceeded(*problem);
    const FormFactor f =
        form_factor(document.scene, from, to, arguments.rays, arguments.seed, arguments.scene.threads);
    const std::string &a = document.scene.objects[from].name, &b = document.scene.objects[to].name;
    std::string output = fmt::format("{} to {}: {:.6f} ± {:.6f} (one standard error, {} rays)\n",
                                     on_one_line(a), on_one_line(b), f.estimate, f.standard_error, f.rays);
    if (arguments.as_json)
        output = json_text({{"from", a},
                            {"to", b},
                            {"form_factor", f.estimate},
                            {"standard_error", f.standard_error},
                            {"rays", f.rays},
                            {"arrived", f.arrived},
                            {"area", f.area}});
    return {output, document.warnings, ExitStatus::Done};
}

Run declare_formfactor(Options& options) {
    auto arguments = std::make_shared<FormFactorArguments>();
    add_scene(options, arguments->scene);
    add_text(options, "--from", "OBJECT",
             "the object that emits from its front, by name or by number, counted from 0", arguments->from);
    add_text(options, "--to", "OBJECT", "the object that receives, in the same form", arguments->to);
    options.add_value("--rays", "N", "number of random rays, 1 to 1000000000; default 1000000",
                      [&rays = arguments->rays](const std::string& text) {
                          rays = read_count("--rays", text, 1, max_form_factor_rays);
                      });
    options.add_value("--seed", "S", "a different seed gives different rays; default 1",
                      [&seed = arguments->seed](const std::string& text) {
                          seed = read_count("--seed", text, 0, 1'000'000);
                      });
    add_json_format(options, arguments->as_json);
    return [arguments] { return formfactor(*arguments); };
}

}  // namespace

Command formfactor_command() {
    return {"formfactor", "FILE --from A --to B",
            "estimate the fraction of one object's light that arrives at another",
            "glint formfactor two-plates.json --from Lower --to Upper --rays 4000000", declare_formfactor};
}

}  // namespace glint
