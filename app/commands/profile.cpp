// glint profile: measures intensity along a line.
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/options.h"
#include "renderer/answers/answers.h"

namespace glint {
namespace {

struct ProfileArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    std::optional<Pixel> from, to;
    bool as_json = false;
};

Pixel given_end(const std::string& option, const std::optional<Pixel>& pixel) {
    if (!pixel) throw wrong_usage(option, "is missing", "X,Y as in " + option + " 0,360");
    return *pixel;
}

Outcome profile(const ProfileArguments& arguments) {
    require_file(arguments.scene);
    const Pixel first = given_end("--from", arguments.from), last = given_end("--to", arguments.to);
    const SceneDocument document = open_scene(arguments.scene);
    const PictureSize size = size_to_draw(arguments.size, document);
    require_inside("--from", first, size);
    require_inside("--to", last, size);

    Renderer renderer(arguments.scene.threads);
    Progress progress("picture", 1);
    progress.show_paths(renderer);
    const Picture& picture = renderer.render(document.scene, size, true);
    const std::vector<ProfileSample> samples =
        glint::profile(renderer, picture, {first.x, first.y}, {last.x, last.y});
    Outcome outcome{arguments.as_json ? json_text(profile_json(samples)) : profile_csv(samples),
                    document.warnings, ExitStatus::Done};
    warn_of_samples(document, outcome.warnings);
    outcome.warnings.insert(outcome.warnings.end(), renderer.warnings().begin(), renderer.warnings().end());
    return outcome;
}

Run declare_profile(Options& options) {
    auto arguments = std::make_shared<ProfileArguments>();
    add_scene(options, arguments->scene);
    options.add_value(
        "--from", "X,Y", "first pixel of the line; 0,0 is the top left",
        [&from = arguments->from](const std::string& text) { from = read_pixel("--from", text); });
    options.add_value("--to", "X,Y", "last pixel of the line",
                      [&to = arguments->to](const std::string& text) { to = read_pixel("--to", text); });
    add_size(options, arguments->size);
    options.add_value("--format", "FORMAT", "csv (default) or json (one list per column)",
                      [&as_json = arguments->as_json](const std::string& text) {
                          as_json = read_word("--format", text, {"csv", "json"}) == 1;
                      });
    return [arguments] { return profile(*arguments); };
}

}  // namespace

Command profile_command() {
    return {"profile", "FILE --from X,Y --to X,Y",
            "print colours along a line of the picture, as CSV or JSON",
            "glint profile mach-bands.json --from 0,360 --to 1279,360 > bands.csv", declare_profile};
}

}  // namespace glint
