// glint bench: measures frame times while something is dragged.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "app/commands/drag.h"
#include "app/options.h"
#include "models/json/json.h"
#include "renderer/renderer.h"

namespace glint {
namespace {

const std::vector<std::string> drag_names{"light", "material", "camera", "object"};
constexpr int warm_up_frames = 3;

struct BenchArguments {
    SceneArguments scene;
    std::optional<PictureSize> size;
    int frames = 100;
    std::optional<Drag> drag;
    bool relight = false, table = false;
};

/// What to drag; by default a light, or the camera in a scene without lights.
Drag drag_of(const BenchArguments& arguments, const Scene& scene) {
    if (!arguments.drag) return scene.lights.empty() ? Drag::Camera : Drag::Light;
    if (*arguments.drag == Drag::Light && scene.lights.empty()) {
        throw wrong_usage("--drag", "the scene has no lights",
                          "material, camera or object, or a scene with a light");
    }
    const bool needs_object = *arguments.drag == Drag::Material || *arguments.drag == Drag::Object;
    if (needs_object && scene.objects.empty()) {
        throw wrong_usage("--drag", "the scene has no objects", "light or camera, or a scene with an object");
    }
    return *arguments.drag;
}

/// Returns a quantile of `values`, which must not be empty; `share` 0.5 gives the median.
double quantile(std::vector<double> values, double share) {
    const auto last = static_cast<double>(values.size() - 1);
    const auto at = static_cast<std::ptrdiff_t>(std::lround(share * last));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

struct Times {
    std::vector<double> frame;
    std::array<std::vector<double>, stage_count> stage;
    std::array<int, stage_count> redone{};  // number of frames in which the stage ran
    std::vector<double> strokes;
    int strokes_redone = 0;
};

Times measure(Renderer& renderer, const Scene& start, const BenchArguments& arguments, PictureSize size,
              Drag drag) {
    using Clock = std::chrono::steady_clock;
    Times times;
    Scene scene = start;
    Progress progress("frame", static_cast<std::size_t>(arguments.frames));
    progress.show_paths(renderer);
    for (int frame = -warm_up_frames; frame < arguments.frames; ++frame) {
        drag_to(scene, start, drag, frame);
        const auto before = Clock::now();
        (void)renderer.render(scene, size);
        const std::chrono::duration<double, std::milli> took = Clock::now() - before;
        if (frame < 0) continue;
        progress.at(static_cast<std::size_t>(frame) + 1);
        times.frame.push_back(took.count());
        for (std::size_t i = 0; i < stage_count; ++i) {
            times.stage[i].push_back(renderer.stats().ms[i]);
            times.redone[i] += renderer.stats().redone[i] ? 1 : 0;
        }
        times.strokes.push_back(renderer.stats().strokes_ms);
        times.strokes_redone += renderer.stats().strokes_redone ? 1 : 0;
    }
    return times;
}

std::uint64_t peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

/// Returns the text output: the numbers of the JSON in rows and columns.
std::string table_text(const Json& json) {
    const auto word = [&json](const char* key) { return json.at(key).get<std::string>(); };
    const auto count = [&json](const char* key) {
        return static_cast<std::uint64_t>(json.at(key).get<double>());
    };
    std::string text = fmt::format(
        "{} drag, {} x {}, {} frames, {} thread{}, {}, {} triangles, {} shaded pixels, peak memory {:.0f} "
        "MB\n\n",
        word("drag"), count("width"), count("height"), count("frames"), count("threads"),
        count("threads") == 1 ? "" : "s", word("instruction_set"), count("triangles"), count("shaded_pixels"),
        json.at("peak_bytes").get<double>() * 1e-6);
    text += fmt::format("{:<11} {:>9}\n", "frame", "ms");
    for (const auto& [name, ms] : json.at("ms").items())
        text += fmt::format("{:<11} {:>9.3f}\n", name, ms.get<double>());
    text += fmt::format("\n{:<11} {:>9}   {}\n", "stage", "median ms", "redone in");
    for (const auto& [name, ms] : json.at("stages").items())
        text += fmt::format("{:<11} {:>9.3f}   {} of {} frames\n", name, ms.get<double>(),
                            json.at("redone").at(name).get<double>(), count("frames"));
    return text;
}

Outcome bench(const BenchArguments& arguments) {
    const SceneDocument document = open_scene(arguments.scene);
    const Drag drag = drag_of(arguments, document.scene);
    const PictureSize size = size_to_draw(arguments.size, document);
    Renderer renderer(arguments.scene.threads);
    renderer.keep_sums(!arguments.relight);
    const Times times = measure(renderer, document.scene, arguments, size, drag);
    const FrameStats& stats = renderer.stats();
    const auto of = [&times](double share) { return quantile(times.frame, share); };
    const auto stage = [&times](Stage s) { return quantile(times.stage[static_cast<std::size_t>(s)], 0.5); };
    const auto redone = [&times](Stage s) { return times.redone[static_cast<std::size_t>(s)]; };
    Json json{
        {"frames", arguments.frames},
        {"ms", {{"min", of(0)}, {"median", of(0.5)}, {"p90", of(0.9)}, {"p99", of(0.99)}, {"max", of(1)}}},
        {"stages",
         {{"geometry", stage(Stage::Geometry)},
          {"visibility", stage(Stage::Visibility)},
          {"surface", stage(Stage::Surface)},
          {"transport", stage(Stage::Transport)},
          {"lighting", stage(Stage::Lighting)}}},
        {"redone",
         {{"geometry", redone(Stage::Geometry)},
          {"visibility", redone(Stage::Visibility)},
          {"surface", redone(Stage::Surface)},
          {"transport", redone(Stage::Transport)},
          {"lighting", redone(Stage::Lighting)}}},
        {"threads", stats.threads},
        {"instruction_set", stats.instruction_set},
        {"triangles", stats.triangles},
        {"shaded_pixels", stats.shaded_pixels},
        {"width", size.width},
        {"height", size.height},
        {"drag", drag_names[static_cast<std::size_t>(drag)]},
        {"peak_bytes", peak_bytes()}};
    const Npr& npr = document.scene.npr;
    if (npr.silhouettes || npr.creases) {
        json["stages"]["strokes"] = quantile(times.strokes, 0.5);
        json["redone"]["strokes"] = times.strokes_redone;
    }
    Outcome outcome{arguments.table ? table_text(json) : json_text(json), document.warnings,
                    ExitStatus::Done};
    outcome.warnings.insert(outcome.warnings.end(), renderer.warnings().begin(), renderer.warnings().end());
    return outcome;
}

Run declare_bench(Options& options) {
    auto arguments = std::make_shared<BenchArguments>();
    add_scene(options, arguments->scene);
    add_size(options, arguments->size);
    options.add_value("--frames", "N", "frames to measure, 1 to 100000; default 100",
                      [&frames = arguments->frames](const std::string& text) {
                          frames = read_count("--frames", text, 1, 100000);
                      });
    options.add_value("--drag", "WHAT", "what moves: light (default), material, camera or object",
                      [&drag = arguments->drag](const std::string& text) {
                          drag = static_cast<Drag>(read_word("--drag", text, drag_names));
                      });
    options.add_flag("--table", arguments->table, "print a table instead of JSON");
    options.add_flag(
        "--relight", arguments->relight,
        "recompute every light in each frame, even if the sum of the unchanged lights could be reused");
    return [arguments] { return bench(*arguments); };
}

}  // namespace

Command bench_command() {
    return {"bench", "FILE", "measure frame times while something is dragged, as JSON or a table",
            "glint bench teapot.json --frames 200 --drag camera", declare_bench};
}

}  // namespace glint
