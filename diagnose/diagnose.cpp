#include "diagnose/diagnose.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <utility>

#include "diagnose/judged.h"
#include "models/numbers.h"
#include "models/progress.h"
#include "renderer/lighting/display.h"
#include "renderer/threads.h"

namespace glint {
namespace {

constexpr std::uint64_t fewest_compared = 16;
/// In levels. Stronger noise in linear light is clipped and encoded, which shifts its mean: from 17 levels
/// up, mistakes were reported in correct pictures.
constexpr float most_noise = 12;

/// The sets of mistakes that an experiment must distinguish: the first candidate and those that look like it,
/// or else the second candidate.
std::vector<MistakeSet> to_tell_apart(const std::vector<Candidate>& candidates) {
    constexpr std::size_t most = 4;
    std::vector<MistakeSet> sets;
    if (candidates.empty()) return sets;
    sets.push_back(candidates[0].mistakes);
    sets.insert(sets.end(), candidates[0].also.begin(), candidates[0].also.end());
    for (std::size_t i = 1; i < candidates.size() && sets.size() == 1; ++i)
        if (!candidates[i].mistakes.empty()) sets.push_back(candidates[i].mistakes);
    if (sets.size() > most) sets.resize(most);
    return sets;
}

/// Whether an explanation leaves no more error than rounding causes. One with a soft change is never exact:
/// the range between a pixel's neighbours also hides noise.
bool is_exact(const Judged& best) {
    constexpr double rounding = 0.3;  // levels
    return best.is_believed && !best.change.soft && best.score.residual() < rounding;
}

/// A correct picture clearly has more than one colour if its colours differ by more than this many levels.
constexpr int several_colours = 8;

/// The colour of the picture's surfaces if they all have the same one, although those of the correct picture
/// have several.
std::optional<Rgb> only_colour_of_surfaces(const Exhibit& e, const DisplayChange& change) {
    constexpr float rounding = 1;
    RgbBounds mine, right;
    const PictureSize size = e.right.size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (e.kinds[size.index(x, y)] != PixelKind::Surface) continue;
            mine.add(mine_at(e.wrong, change, x, y));
            right.add(rgb_at(e.right, size.index(x, y)));
        }
    if (static_cast<float>(mine.spread()) > rounding + e.least_change.scatter() ||
        right.spread() <= several_colours)
        return {};
    return mine.high;
}

/// Additional display changes to try for a picture that nothing explains, the smaller one first.
std::array<DisplayChange, 2> larger_changes(const DisplayChange& supposed) {
    DisplayChange turned = supposed;
    turned.before = turned.after = Code::Same;
    turned.gain = 1;
    turned.soft = false;
    return {turned, supposed};
}

double count_wrong(const DescribedDifference& d) {
    double pixels = 0;
    for (const DifferenceRegion& r : d.regions) pixels += static_cast<double>(r.pixels);
    return pixels;
}

/// The difference that remains under the smallest display change that leaves little unexplained: a gain or a
/// curve reduces any difference somewhat, and so does scaling a term of the equation.
DescribedDifference cautious_difference(DisplayChange& change, const Renderer& renderer,
                                        const Exhibit& exhibit, const DisplayChange& supposed,
                                        const Display& display) {
    constexpr double clearly = 4;
    change = exhibit.least_change;
    DescribedDifference best = describe_difference(renderer, exhibit, change, display);
    for (const DisplayChange& tried : larger_changes(supposed)) {
        if (tried == change) continue;
        DescribedDifference found = describe_difference(renderer, exhibit, tried, display);
        const bool is_better = clearly * found.pixels_left < best.pixels_left ||
                               clearly * count_wrong(found) < count_wrong(best);
        if (!is_better) continue;
        best = std::move(found);
        change = tried;
    }
    return best;
}

/// Fills in the diagnosis of a picture that no explanation fits: whether it can be compared at all, and where
/// the difference is. `none`: the judged explanation without a mistake.
void say_what_is_unexplained(Diagnosis& d, Renderer& renderer, const Scene& scene, const Exhibit& exhibit,
                             const Judged& none) {
    if (const auto why = other_outline(exhibit)) {
        d = Diagnosis{};
        d.size = exhibit.wrong.size;
        d.why = *why;
        return;
    }
    d.verdict = Verdict::NotInCatalogue;
    (void)renderer.render(under_mistakes(scene, {}), d.size);
    DisplayChange change;
    DescribedDifference found = cautious_difference(change, renderer, exhibit, none.change, scene.display);
    constexpr double much = 0.5;  // the nearest candidates are kept if they explain this share
    std::erase_if(d.candidates, [&](const Candidate& c) {
        return c.explained < much || !are_of_one_display(c.change, change);
    });
    d.display = display_finding(exhibit, none.drawing, change);
    d.pixels = count_unlike(exhibit, none.drawing, change);
    d.regions = std::move(found.regions);
    d.terms = std::move(found.terms);
}

void conclude(Diagnosis& d, Renderer& renderer, const SceneDocument& document, const Exhibit& exhibit,
              const std::vector<Judged>& all, int threads) {
    const Judged& best = all.front();
    const Judged& none = of_no_mistake(all);
    d.display = display_finding(exhibit, best.drawing, best.change);
    d.display.tone = best.explanation.tone;
    const ExplanationKind kind = best.explanation.kind;
    const bool is_simple =
        best.is_believed && (kind == ExplanationKind::LeftOut || kind == ExplanationKind::Setting);
    if (!is_simple)
        if (const std::optional<Rgb> only = only_colour_of_surfaces(exhibit, best.change)) {
            d.why = *only == Rgb{} ? "its surfaces are black: nothing is lit, which many mistakes would cause"
                                   : "its surfaces have a single colour, which many mistakes would cause";
            return;
        }
    const bool is_believed = best.is_believed;
    d.display.lossy = is_believed && best.is_lossy;
    const Judged& shown = is_believed ? best : none;
    d.pixels = count_unlike(exhibit, shown.drawing, shown.change);
    if (is_believed) d.conventions = best.explanation.conventions;
    if (is_believed && best.is_right) {
        d.verdict = Verdict::NoMistake;
        return;
    }
    d.candidates = candidates_of(exhibit, all, shown.change);
    // The candidates that are not believed are sorted by the share that they explain; below 1 % they are
    // dropped.
    constexpr double hardly_any = 0.01;
    const auto others = d.candidates.begin() + (is_believed ? 1 : 0);
    std::stable_sort(others, d.candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.explained > b.explained; });
    d.candidates.erase(
        std::find_if(others, d.candidates.end(), [](const Candidate& c) { return c.explained < hardly_any; }),
        d.candidates.end());
    if (!is_believed) return say_what_is_unexplained(d, renderer, document.scene, exhibit, none);
    d.verdict = static_cast<Verdict>(best.explanation.kind);  // the two enums are in the same order
    if (d.verdict == Verdict::Mistake)
        d.experiment = find_experiment(document, d.size, to_tell_apart(d.candidates), threads);
}

/// Whether the picture has a single colour, to within rounding and `room` levels, although the correct
/// picture has several. A program that draws nothing produces such a picture, and so do many mistakes.
bool is_of_one_colour(const Picture& wrong, const Picture& right, float room) {
    const auto spread_of = [](const Picture& picture) {
        RgbBounds bounds;
        for (std::size_t i = 0; i < picture.size.pixels(); ++i) bounds.add(rgb_at(picture, i));
        return bounds.spread();
    };
    return static_cast<float>(spread_of(wrong)) <= 1 + room && spread_of(right) > several_colours;
}

/// Returns the mean colours of the picture's squares of 8 x 8 pixels. The means contain hardly any of the
/// noise of individual pixels.
Picture means_of_squares(const Picture& picture) {
    constexpr int edge = 8;
    Picture means{{picture.size.width / edge, picture.size.height / edge}, {}, {}};
    means.rgba.resize(4 * means.size.pixels());
    for (int y = 0; y < means.size.height; ++y)
        for (int x = 0; x < means.size.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                int sum = edge * edge / 2;
                for (int i = 0; i < edge * edge; ++i)
                    sum += picture.rgba[4 * picture.pixel(edge * x + i % edge, edge * y + i / edge) + c];
                means.rgba[4 * means.pixel(x, y) + c] = static_cast<std::uint8_t>(sum / (edge * edge));
            }
    return means;
}

void find_explanation(Diagnosis& d, Renderer& renderer, const SceneDocument& document, const Picture& wrong,
                      const Picture& right, const std::vector<PixelKind>& kinds,
                      const DiagnosisOptions& options) {
    const Exhibit clean(wrong, right, kinds);
    std::vector<Judged> all = judge_all(renderer, document.scene, clean, options);
    const float noise = is_exact(all.front()) ? 0 : noise_of(wrong, right);
    if (noise == 0) return conclude(d, renderer, document, clean, all, options.threads);
    if (noise > most_noise) {
        d.why = fmt::format(
            "noise of about {:.0f} levels hides what mistakes would change; at most {:.0f} can be judged",
            noise, most_noise);
        return;
    }
    if (is_of_one_colour(means_of_squares(wrong), right, 1.5f * noise)) {
        d.why = fmt::format("it has a single colour except for noise of about {:.0f} levels", noise);
        return;
    }
    all.clear();  // its drawings are large
    const Exhibit noisy(wrong, right, kinds, noise);
    conclude(d, renderer, document, noisy, judge_all(renderer, document.scene, noisy, options),
             options.threads);
}

/// Adds the camera difference that was undone to a diagnosis. If that difference is large, it is the
/// diagnosis.
void report_camera(Diagnosis& d, const CameraDifference& camera, const Scene& scene) {
    d.display.camera = camera;
    d.display.camera_words = camera_text(camera, scene.camera, d.size);
    const SceneEdit edit = [to = camera.camera](Scene& s) { s.camera = to; };
    if (camera.is_small) {
        for (Candidate& c : d.candidates) c.convention_edits.push_back(edit);
        return;
    }
    d.experiment.reset();
    d.candidates.clear();
    if (d.verdict == Verdict::NoMistake && camera.is_field_of_view()) {
        const float fov = std::get<Perspective>(camera.camera.projection).fov_y_deg;
        Candidate c;
        c.kind = ExplanationKind::Number;
        c.name = "/camera/projection/fov_y_deg";
        c.words = "In your picture, " + d.display.camera_words + ".";
        c.set = {fmt::format("{}={}", c.name, fov)};
        c.edits = {edit};
        c.explained = 1;
        d.verdict = Verdict::AnotherNumber;
        d.candidates = {c};
        d.display.camera_words.clear();
        return;
    }
    d.verdict = Verdict::NotComparable;
    d.why = d.display.camera_words + ". Set the scene's camera to that of your program, and diagnose again";
}

Diagnosis diagnosis_of(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    Diagnosis d;
    d.size = wrong.size;
    d.of_pairs = options.pairs;
    Renderer renderer(options.threads);
    Scene scene = under_mistakes(document.scene, {});
    Picture right = renderer.render(scene, d.size);
    std::vector<PixelKind> kinds = pixel_kinds(renderer, d.size);
    const auto compared = std::count(kinds.begin(), kinds.end(), PixelKind::Surface);
    if (static_cast<std::uint64_t>(compared) < fewest_compared) {
        d.why = "the scene's surfaces cover too few pixels in a picture of this size";
        return d;
    }
    if (is_of_one_colour(wrong, right, 0)) {
        const Rgb only = rgb_at(wrong, 0);
        d.why = fmt::format("it has a single colour, ({}, {}, {}), {}", only[0], only[1], only[2],
                            only == Rgb{} ? "which is black: nothing was drawn, or nothing is lit yet"
                                          : "so no surface is visible");
        return d;
    }
    const auto camera = camera_difference(renderer, scene, wrong, kinds);
    if (!camera) {
        find_explanation(d, renderer, document, wrong, right, kinds, options);
        return d;
    }
    SceneDocument seen = document;
    scene.camera = seen.scene.camera = camera->camera;
    right = renderer.render(scene, d.size);
    kinds = pixel_kinds(renderer, d.size);
    find_explanation(d, renderer, seen, wrong, right, kinds, options);
    report_camera(d, *camera, document.scene);
    return d;
}

}  // namespace

Diagnosis diagnose(const SceneDocument& document, const Picture& wrong, const DiagnosisOptions& options) {
    tbb::task_arena arena(arena_threads(options.threads));
    Diagnosis found;
    arena.execute([&] { found = diagnosis_of(document, wrong, options); });
    return found;
}

Scene scene_under(const Scene& scene, const Candidate& candidate) {
    Scene edited = candidate.applied(under_mistakes(scene, {}));
    edited.shading.mistakes.only = candidate.only;
    return edited;
}

std::vector<std::string> Candidate::options() const {
    std::vector<std::string> all = convention_set;
    all.insert(all.end(), set.begin(), set.end());
    return all;
}

Picture as_shown(Picture picture, const Display& display) {
    if (!picture.rgba.empty()) return picture;
    const DisplayJob job{1, display.transfer == Transfer::Srgb};
    picture.rgba.assign(4 * picture.size.pixels(), 255);
    for (std::size_t i = 0; i < picture.linear.size(); ++i)
        picture.rgba[i / 3 * 4 + i % 3] =
            static_cast<std::uint8_t>(byte_of(displayed(job, picture.linear[i])));
    picture.linear.clear();
    return picture;
}

namespace {

constexpr std::size_t most_lights = 8, most_objects = 4;

/// Rounds to three decimal places, so that the line is easy to type.
float short_number(float x) { return std::round(x * 1000) / 1000; }

std::string vector_text(glm::vec3 v) {
    return fmt::format("[{},{},{}]", number_text(short_number(v.x)), number_text(short_number(v.y)),
                       number_text(short_number(v.z)));
}

glm::vec3 turned(glm::vec3 v, float degrees, glm::vec3 axis) {
    return glm::vec3(glm::rotate(glm::mat4(1), glm::radians(degrees), axis) * glm::vec4(v, 0));
}

using Changes = std::vector<Assignment>;

void add_camera(Changes& changes, const Camera& camera) {
    const glm::vec3 arm = camera.eye - camera.target, up = glm::normalize(camera.up);
    const glm::vec3 side = glm::normalize(glm::cross(up, arm));
    for (const float degrees : {-60.0f, -30.0f, 30.0f, 60.0f})
        changes.push_back({"/camera/eye", vector_text(camera.target + turned(arm, degrees, up))});
    for (const float degrees : {-30.0f, 30.0f})
        changes.push_back({"/camera/eye", vector_text(camera.target + turned(arm, degrees, side))});
}

void add_light(Changes& changes, const Light& light, std::size_t index) {
    const auto at = [&](const char* key) { return fmt::format("/lights/{}/{}", index, key); };
    const glm::vec3 position(light.position);
    for (const float degrees : {-90.0f, -45.0f, 45.0f, 90.0f})
        changes.push_back({at("position"), vector_text(turned(position, degrees, {0, 1, 0}))});
    for (const float degrees : {-60.0f, 60.0f})
        changes.push_back({at("position"), vector_text(turned(position, degrees, {1, 0, 0}))});
    for (const float share : {0.5f, 2.0f}) {
        changes.push_back({at("position"), vector_text(share * position)});
        changes.push_back({at("intensity"), number_text(short_number(share * light.intensity))});
    }
    changes.push_back({at("space"), light.space == LightSpace::World ? "camera" : "world"});
    if (light.kind == LightKind::Directional || light.kind == LightKind::Area) return;
    for (const char* quadratic : {"0.1", "0.5"}) changes.push_back({at("falloff/quadratic"), quadratic});
    changes.push_back({at("falloff/constant"), "0.5"});
    if (light.kind != LightKind::Spot) return;
    for (const float share : {0.5f, 1.5f})
        changes.push_back({at("spot/cutoff_deg"),
                           number_text(short_number(std::min(90.0f, share * light.spot.cutoff_deg)))});
}

void add_material(Changes& changes, const Material& material, std::size_t index) {
    const auto at = [&](const char* key) { return fmt::format("/objects/{}/material/{}", index, key); };
    for (const float share : {0.25f, 4.0f})
        changes.push_back(
            {at("shininess"), number_text(short_number(std::max(1.0f, share * material.shininess)))});
    changes.push_back({at("specular"), "[1,1,1]"});
    changes.push_back({at("specular"), "[0,0,0]"});
    changes.push_back({at("ambient"), "[0.5,0.5,0.5]"});
    changes.push_back({at("diffuse"), "[0.5,0.5,0.5]"});
}

Changes changes_of(const Scene& scene) {
    Changes changes;
    add_camera(changes, scene.camera);
    for (std::size_t i = 0; i < std::min(scene.lights.size(), most_lights); ++i)
        if (scene.lights[i].enabled) add_light(changes, scene.lights[i], i);
    for (std::size_t i = 0; i < std::min(scene.objects.size(), most_objects); ++i)
        add_material(changes, scene.objects[i].material, i);
    return changes;
}

int channels_apart(const Picture& a, const Picture& b, std::size_t pixel) {
    int sum = 0;
    for (std::size_t c = 4 * pixel; c < 4 * pixel + 3; ++c) sum += std::abs(int{a.rgba[c]} - int{b.rgba[c]});
    return sum;
}

/// The difference between the two most similar pictures, where far(a, b) measures the difference between a
/// and b.
template <class Far> auto least_apart(const std::vector<Picture>& pictures, const Far& far) {
    auto least = far(pictures[0], pictures[1]);
    for (std::size_t i = 2; i < pictures.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) least = std::min(least, far(pictures[k], pictures[i]));
    return least;
}

/// The pixel at which the two most similar pictures differ most. Its neighbours must differ as well, because
/// a pixel on an outline or on a highlight's rim might look different in a program that rounds differently.
glm::ivec2 telling_pixel(const std::vector<Picture>& pictures) {
    const PictureSize size = pictures[0].size;
    std::vector<int> least(size.pixels());
    for (std::size_t i = 0; i < least.size(); ++i)
        least[i] = least_apart(pictures,
                               [i](const Picture& a, const Picture& b) { return channels_apart(a, b, i); });
    const auto least_around = [&](int x, int y) {
        int around = least[size.index(x, y)];
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.width - 1); ++u)
                around = std::min(around, least[size.index(u, v)]);
        return around;
    };
    glm::ivec2 best{0};
    std::pair<int, int> most{-1, -1};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::pair here{least_around(x, y), least[size.index(x, y)]};
            if (here <= most) continue;
            most = here;
            best = {x, y};
        }
    return best;
}

/// RMS of the differences over all pixels, in levels.
double apart(const Picture& a, const Picture& b) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int d = int{a.rgba[i]} - int{b.rgba[i]};
        sum += static_cast<std::uint32_t>(d * d);
    }
    return std::sqrt(static_cast<double>(sum) / static_cast<double>(3 * a.size.pixels()));
}

std::vector<Picture> drawn_under(Renderer& renderer, const Scene& scene, PictureSize size,
                                 const std::vector<MistakeSet>& mistakes) {
    std::vector<Picture> pictures;
    pictures.reserve(mistakes.size());
    for (const MistakeSet& set : mistakes)
        pictures.push_back(renderer.render(under_mistakes(scene, set), size));
    return pictures;
}

PictureSize small_size(PictureSize size) {
    constexpr int height = 72;
    const int h = std::min(height, size.height);
    return {std::clamp(size.width * h / size.height, 1, 4 * height), h};
}

Experiment shown_at_full_size(Renderer& renderer, const Scene& scene, PictureSize size,
                              const std::vector<MistakeSet>& mistakes, const Assignment& set) {
    const std::vector<Picture> pictures = drawn_under(renderer, scene, size, mistakes);
    Experiment experiment{{set}, telling_pixel(pictures), mistakes, {}};
    const std::size_t pixel = size.index(experiment.pixel.x, experiment.pixel.y);
    for (const Picture& picture : pictures) experiment.shows.push_back(rgb_at(picture, pixel));
    return experiment;
}

}  // namespace

std::optional<Experiment> find_experiment(const SceneDocument& document, PictureSize size,
                                          const std::vector<MistakeSet>& mistakes, int threads) {
    constexpr double least_levels = 1;
    if (mistakes.size() < 2) return std::nullopt;
    Renderer renderer(threads);
    const SceneVariants variants(document);
    std::optional<Assignment> best;
    Scene best_scene;
    double most = least_levels;
    for (const Assignment& change : changes_of(document.scene)) {
        if (load_cancelled()) throw LoadCancelled();
        Result<Scene> varied = variants.with({change});
        if (problem_of(varied) != nullptr) continue;
        const Scene& scene = std::get<Scene>(varied);
        const double far = least_apart(drawn_under(renderer, scene, small_size(size), mistakes), apart);
        if (far <= most) continue;
        most = far;
        best = change;
        best_scene = scene;
    }
    if (!best) return std::nullopt;
    return shown_at_full_size(renderer, best_scene, size, mistakes, *best);
}

}  // namespace glint
