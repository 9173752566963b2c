// Times frames of Glint and the rival (llvmpipe/rival.h) in turn; prints the table of docs/performance.md.
//
//   glint_compare [--frames N] [--rounds N] [--threads N] [--only WORD] [SCENE]

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "app/commands/drag.h"
#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "tests/bench/llvmpipe/rival.h"
#include "tests/places.h"

namespace glint::bench {
namespace {

constexpr PictureSize size{1920, 1080};
constexpr std::array<int, 3> details{90, 572, 2000};  // detail of the knot: 2, 82 and 1000 thousand triangles

struct Arguments {
    int frames = 10, rounds = 7, threads = 2;
    std::string only, scene = project_file("tests/bench/knot.json");
};

struct Row {
    const char* name;
    Drag drag;
    ShadingMode mode;
    bool relight;
    Cull cull = Cull::Back;
};
constexpr std::array<Row, 6> rows{
    Row{"light drag, Phong, all lights recomputed", Drag::Light, ShadingMode::Phong, true},
    {"light drag, Phong, sum of the others kept", Drag::Light, ShadingMode::Phong, false},
    {"light drag, Gouraud", Drag::Light, ShadingMode::Gouraud, false},
    {"light drag, flat", Drag::Light, ShadingMode::Flat, false},
    {"camera drag, Phong", Drag::Camera, ShadingMode::Phong, false},
    // The default for scenes: back faces are drawn.
    {"camera drag, Phong, nothing culled", Drag::Camera, ShadingMode::Phong, false, Cull::None}};

/// The quantile at the given fraction: 0.5 gives the median.
double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

double ms_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The fraction of pixels in which two pictures differ by more than 2 of 255 in some channel. A pixel on an
/// edge may show a different face in each.
double share_that_differs(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        int worst = 0;
        for (std::size_t k = i; k < i + 3; ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
        count += worst > 2 ? 1 : 0;
    }
    return 4.0 * static_cast<double>(count) / static_cast<double>(a.size());
}

/// One drawing method, measured batch by batch.
struct Contender {
    std::function<void(const Scene&, bool same_view)> draw;
    int frame = 0;
    std::vector<double> all;

    /// The median frame time of a batch, after one uncounted frame.
    double batch(const Scene& start, Drag drag, int frames) {
        Scene scene = start;
        std::vector<double> times;
        for (int i = 0; i <= frames; ++i) {
            drag_to(scene, start, drag, ++frame);
            const bool same_view = i > 0 && drag != Drag::Camera;
            const double ms = ms_of([&] { draw(scene, same_view); });
            if (i == 0) continue;
            times.push_back(ms);
            all.push_back(ms);
        }
        return quantile(times, 0.5);
    }
};

struct Cell {
    double ours = 0, p99 = 0, forward = 0, deferred = 0, ratio = 0, differs = 0;
};

Cell measure(Scene scene, const Row& row, const Arguments& arguments) {
    scene.shading.mode = row.mode;
    scene.shading.cull = row.cull;
    Renderer renderer(arguments.threads);
    renderer.keep_sums(!row.relight);
    Rival rival(scene, size, arguments.threads);
    Cell cell;
    rival.draw(scene, Way::Forward, false);
    cell.differs = share_that_differs(renderer.render(scene, size).rgba, rival.picture());
    Contender ours{[&](const Scene& s, bool) { (void)renderer.render(s, size); }, 0, {}};
    Contender forward{[&](const Scene& s, bool) { rival.draw(s, Way::Forward, false); }, 0, {}};
    Contender deferred{[&](const Scene& s, bool same) { rival.draw(s, Way::Deferred, same); }, 0, {}};
    std::vector<double> ratios;
    for (int round = 0; round < arguments.rounds; ++round) {
        const double a = ours.batch(scene, row.drag, 3 * arguments.frames);
        double b = forward.batch(scene, row.drag, arguments.frames);
        if (row.mode == ShadingMode::Phong)
            b = std::min(b, deferred.batch(scene, row.drag, arguments.frames));
        ratios.push_back(b / a);
    }
    cell.ours = quantile(ours.all, 0.5);
    cell.p99 = quantile(ours.all, 0.99);
    cell.forward = quantile(forward.all, 0.5);
    cell.deferred = deferred.all.empty() ? 0 : quantile(deferred.all, 0.5);
    cell.ratio = quantile(ratios, 0.5);
    return cell;
}

Scene knot(const Arguments& arguments, int detail) {
    const Assignment set{"/objects/0/mesh/detail", std::to_string(detail)};
    const Result<SceneDocument> opened = open_document(arguments.scene, {set});
    if (const Problem* problem = problem_of(opened)) {
        fmt::print(stderr, "{}\n", problem->text());
        std::exit(1);
    }
    return std::get<SceneDocument>(opened).scene;
}

int compare(const Arguments& arguments) {
    fmt::print(
        "| frame | triangles | ours ms | p99 | forward ms | deferred ms | times faster | pixels off |\n");
    fmt::print("|---|---|---|---|---|---|---|---|\n");
    bool agrees = true;
    for (const int detail : details) {
        const Scene scene = knot(arguments, detail);
        for (const Row& row : rows) {
            if (std::string(row.name).find(arguments.only) == std::string::npos) continue;
            const Cell c = measure(scene, row, arguments);
            fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.1f} | {} | {:.1f} | {:.3f} % |\n", row.name,
                       scene.objects.front().mesh->triangles.size(), c.ours, c.p99, c.forward,
                       c.deferred > 0 ? fmt::format("{:.1f}", c.deferred) : "", c.ratio, 100 * c.differs);
            std::fflush(stdout);
            agrees &= c.differs < 0.002;
        }
    }
    if (!agrees) fmt::print(stderr, "the pictures differ: the two programs did not do the same work\n");
    return agrees ? 0 : 1;
}

}  // namespace
}  // namespace glint::bench

int main(int count, char** words) {
    glint::bench::Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const bool more = i + 1 < count;
        if (word == "--frames" && more) {
            arguments.frames = std::max(1, std::atoi(words[++i]));
        } else if (word == "--rounds" && more) {
            arguments.rounds = std::max(1, std::atoi(words[++i]));
        } else if (word == "--threads" && more) {
            arguments.threads = std::max(1, std::atoi(words[++i]));
        } else if (word == "--only" && more) {
            arguments.only = words[++i];
        } else {
            arguments.scene = word;
        }
    }
    return glint::bench::compare(arguments);
}
