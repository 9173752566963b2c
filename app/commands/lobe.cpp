// glint lobe: measures how a surface of the scene reflects light from one direction.
#include <memory>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "lessons/lesson.h"
#include "renderer/answers/answers.h"

namespace glint {
namespace {

struct LobeArguments {
    SceneArguments scene;
    int object = 0, steps = 180;
    double light_deg = 45;
    bool as_json = false;
};

const Object& object_of(const Scene& scene, int number) {
    const std::size_t count = scene.objects.size();
    if (count == 0) throw wrong_usage("--object", "the scene has no objects", "at least one");
    if (static_cast<std::size_t>(number) >= count)
        throw wrong_usage("--object", std::to_string(number) + " is out of range",
                          "0 to " + std::to_string(count - 1));
    return scene.objects[static_cast<std::size_t>(number)];
}

Outcome lobe(const LobeArguments& arguments) {
    const SceneDocument document = open_scene(arguments.scene);
    const Object& object = object_of(document.scene, arguments.object);
    const Reflector reflector = reflector_of(object.material, document.scene.shading);
    const auto slice = lobe_slice(reflector, arguments.light_deg, arguments.steps);
    return {arguments.as_json ? json_text(lobe_json(reflector, object.name, arguments.light_deg, slice))
                              : lobe_csv(slice),
            document.warnings, ExitStatus::Done};
}

Run declare_lobe(Options& options) {
    auto arguments = std::make_shared<LobeArguments>();
    add_scene(options, arguments->scene);
    options.add_value("--object", "N", "index of the object whose material is used; default 0",
                      [&object = arguments->object](const std::string& text) {
                          object = read_count("--object", text, 0, 9999);
                      });
    options.add_value("--angle", "DEG", "angle between the light and the normal, 0 to 89.9; default 45",
                      [&deg = arguments->light_deg](const std::string& text) {
                          deg = read_amount("--angle", text, max_lobe_deg);
                      });
    options.add_value("--steps", "N", "number of steps from -90 to 90 degrees; default 180",
                      [&steps = arguments->steps](const std::string& text) {
                          steps = read_count("--steps", text, 1, 100000);
                      });
    options.add_value("--format", "FORMAT",
                      "csv (default) or json, which adds the energy and the albedo of the lobe",
                      [&as_json = arguments->as_json](const std::string& text) {
                          as_json = read_word("--format", text, {"csv", "json"}) == 1;
                      });
    return [arguments] { return lobe(*arguments); };
}

}  // namespace

Command lobe_command() {
    return {"lobe", "FILE", "print how a surface reflects light, as CSV or JSON",
            "glint lobe still-life.json --object 1 --angle 60 --format json", declare_lobe};
}

}  // namespace glint
