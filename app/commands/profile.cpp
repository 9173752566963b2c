// glint profile: intensity along a line.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "renderer/inspect/answers/answers.h"

namespace glint {
namespace {

struct ProfileArguments {
    SceneArguments scene;
    PictureSize size;
    std::optional<Pixel> from, to;
    bool as_json = false;
};

glm::ivec2 end_of(const std::string& option, const std::optional<Pixel>& pixel, PictureSize size) {
    if (!pixel) throw wrong_usage(option, "is missing", "X,Y as in " + option + " 0,360");
    require_inside(option, *pixel, size);
    return {pixel->x, pixel->y};
}

Outcome profile(const ProfileArguments& arguments) {
    require_file(arguments.scene);
    const glm::ivec2 from = end_of("--from", arguments.from, arguments.size);
    const glm::ivec2 to = end_of("--to", arguments.to, arguments.size);
    const SceneDocument document = open_scene(arguments.scene);

    Renderer renderer(arguments.scene.threads);
    const Picture& picture = renderer.render(document.scene, arguments.size, true);
    const std::vector<ProfileSample> samples = glint::profile(renderer, picture, from, to);
    Outcome outcome{arguments.as_json ? json_text(profile_json(samples)) : profile_csv(samples),
                    document.warnings, ExitStatus::Done};
    outcome.warnings.insert(outcome.warnings.end(), renderer.warnings().begin(), renderer.warnings().end());
    return outcome;
}

Run declare_profile(Options& options) {
    auto arguments = std::make_shared<ProfileArguments>();
    add_scene(options, arguments->scene);
    options.add_value(
        "--from", "X,Y", "the pixel where the line begins; 0,0 is the top left",
        [&from = arguments->from](const std::string& text) { from = read_pixel("--from", text); });
    options.add_value("--to", "X,Y", "the pixel where it ends",
                      [&to = arguments->to](const std::string& text) { to = read_pixel("--to", text); });
    add_size(options, arguments->size);
    options.add_value("--format", "FORMAT", "csv, the default, or json, a list for each column",
                      [&as_json = arguments->as_json](const std::string& text) {
                          as_json = read_word("--format", text, {"csv", "json"}) == 1;
                      });
    return [arguments] { return profile(*arguments); };
}

}  // namespace

Command profile_command() {
    return {"profile", "FILE --from X,Y --to X,Y", "lists intensity along a line, as CSV or JSON",
            "glint profile mach-bands.json --from 0,360 --to 1279,360 > bands.csv", declare_profile};
}

}  // namespace glint
