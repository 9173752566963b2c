// Draws random scenes and reports errors: a picture that depends on threads, the instruction set or earlier
// pictures; an explanation that differs from its pixel; a pixel that is not a number.
//
//   scene_stress COUNT SEED     COUNT scenes starting at SEED, under each instruction set of the processor
//   scene_stress --scene SEED   prints one of them, as a scene file
//
// Exits with status 1 after the first failing scene and prints its number and text. A build with sanitizers
// finds more.

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "renderer/simd/isa/kernel_set.h"
#include "tests/stress/stress_scene.h"

using namespace glint;

namespace {

constexpr const char* instruction_sets[] = {"scalar", "sse2", "avx2", "avx512"};

struct Wrong {
    std::string what;
};

/// Equal bit for bit: a NaN equals itself.
template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
bool same(const Picture& a, const Picture& b) { return same(a.rgba, b.rgba) && same(a.linear, b.linear); }

MeshPtr mesh_of(const Object& object) {
    static std::map<std::pair<int, int>, MeshPtr> made;
    const auto& source = std::get<PrimitiveMesh>(object.source);
    MeshPtr& mesh = made[{static_cast<int>(source.primitive), source.detail}];
    if (!mesh) mesh = std::make_shared<const Mesh>(make_primitive(source.primitive, source.detail));
    return mesh;
}

/// The scene as read back from its file, with meshes; nothing if the file would be refused.
std::optional<Scene> valid(const Scene& scene) {
    Result<Scene> read = parse_scene(scene_text(scene), "s.json");
    if (problem_of(read)) return std::nullopt;
    Scene valid = std::get<Scene>(std::move(read));
    for (Object& o : valid.objects) o.mesh = mesh_of(o);
    return valid;
}

/// Only the mistake whose picture is not a number may show one.
void check_numbers(const Scene& scene, const Picture& picture) {
    if (scene.shading.mistakes.power_of_negative_is_nan) return;
    for (const float c : picture.linear)
        if (!std::isfinite(c)) throw Wrong{"a pixel is not a finite number"};
}

bool is_pixel(const Explanation& e, const Picture& picture, int x, int y) {
    const glm::vec3 pixel = picture.linear_at(x, y);
    const std::uint8_t* bytes = &picture.rgba[4 * picture.pixel(x, y)];
    for (int i = 0; i < 3; ++i)
        if (std::bit_cast<std::uint32_t>(e.sum[i]) != std::bit_cast<std::uint32_t>(pixel[i]) ||
            e.byte[static_cast<std::size_t>(i)] != bytes[i])
            return false;
    return true;
}

void check_explanations(const Renderer& renderer, const Picture& picture, StressScenes& random) {
    for (int i = 0; i < 5; ++i) {
        const int x = static_cast<int>(random.below(static_cast<std::size_t>(picture.size.width)));
        const int y = static_cast<int>(random.below(static_cast<std::size_t>(picture.size.height)));
        if (!is_pixel(renderer.explain(x, y), picture, x, y))
            throw Wrong{"the explanation of " + std::to_string(x) + "," + std::to_string(y) +
                        " does not match the pixel"};
        if (renderer.seen_at(x, y).has_value() != (renderer.object_at(x, y) >= 0))
            throw Wrong{"a pixel shows both an object and the background"};
    }
}

std::uint64_t hash_of(const Picture& picture) {
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&hash](std::uint32_t word) { hash = (hash ^ word) * 1099511628211u; };
    for (const std::uint8_t byte : picture.rgba) add(byte);
    for (const float c : picture.linear) add(std::bit_cast<std::uint32_t>(c));
    return hash;
}

/// Draws one scene and returns the picture's hash, or 0 if the scene is invalid. `all`: also runs all checks
/// except that of the instruction set.
std::uint64_t try_scene(unsigned seed, bool all) {
    StressScenes random(seed);
    const StressCase c = random.next();
    std::optional<Scene> scene = valid(c.scene);
    if (!scene) return 0;
    Renderer kept(1);
    const std::uint64_t hash = hash_of(kept.render(*scene, c.size, true, c.samples));
    if (!all) return hash;
    for (int edits = 0;; ++edits) {
        const Picture& picture = kept.render(*scene, c.size, true, c.samples);
        check_numbers(*scene, picture);
        if (c.samples == 1) check_explanations(kept, picture, random);
        Renderer fresh(2);
        if (!same(picture, fresh.render(*scene, c.size, true, c.samples)))
            throw Wrong{"edit " + std::to_string(edits) +
                        ": a renderer that has drawn before draws a different picture"};
        if (edits == 3) return hash;
        Scene edited = *scene;
        random.edit(edited);
        if (auto next = valid(edited)) scene = next;
    }
}

/// One of several processes, each under its own instruction set. They take turns running all checks on a
/// scene.
struct Turn {
    unsigned which = 0, of = 1;
};

/// Prints one line per scene, drawn under the instruction set of this process.
int work(unsigned first, unsigned count, Turn turn) {
    for (unsigned seed = first; seed - first < count; ++seed) try {
            std::printf("%llx\n",
                        static_cast<unsigned long long>(try_scene(seed, seed % turn.of == turn.which)));
            std::fflush(stdout);
        } catch (const Wrong& wrong) {
            std::fprintf(stderr, "scene_stress: scene %u: %s\n%s\n", seed, wrong.what.c_str(),
                         scene_text(StressScenes(seed).next().scene).c_str());
            return 1;
        }
    return 0;
}

/// The lines that this program prints under another instruction set; nothing if it fails.
std::optional<std::vector<std::string>> lines_under(const char* set, const std::string& self, unsigned first,
                                                    unsigned count, Turn turn) {
    const std::string command = "GLINT_ISA=" + std::string(set) + " '" + self + "' --work " +
                                std::to_string(first) + " " + std::to_string(count) + " " +
                                std::to_string(turn.which) + " " + std::to_string(turn.of);
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return std::nullopt;
    std::vector<std::string> lines;
    char line[64];
    while (std::fgets(line, sizeof(line), pipe)) lines.emplace_back(line);
    if (pclose(pipe) != 0) {
        std::fprintf(stderr, "scene_stress: scene %zu under %s\n", first + lines.size(), set);
        return std::nullopt;
    }
    return lines;
}

std::vector<const char*> usable_sets() {
    std::vector<const char*> usable;
    for (const char* set : instruction_sets) {
        setenv("GLINT_ISA", set, 1);
        if (!instruction_set_problem()) usable.push_back(set);
    }
    return usable;
}

/// Compares the scenes first .. first + count - 1 under all instruction sets. Returns the number of valid
/// scenes, or nothing if a check fails.
std::optional<std::size_t> compare_sets(const std::string& self, unsigned first, unsigned count) {
    std::vector<std::string> before;
    const std::vector<const char*> sets = usable_sets();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const Turn turn{static_cast<unsigned>(i), static_cast<unsigned>(sets.size())};
        const auto here = lines_under(sets[i], self, first, count, turn);
        if (!here) return std::nullopt;
        for (std::size_t n = 0; n < before.size(); ++n)
            if (before[n] != (*here)[n]) {
                std::fprintf(stderr, "scene_stress: scene %zu differs between %s and %s\n", first + n,
                             sets[i - 1], sets[i]);
                return std::nullopt;
            }
        before = *here;
    }
    std::size_t scenes = 0;
    for (const std::string& line : before) scenes += line != "0\n";
    return scenes;
}

}  // namespace

int main(int count, char** words) {
    const std::vector<std::string> w(words, words + count);
    const auto number = [&w](std::size_t i) {
        return static_cast<unsigned>(std::strtoul(w[i].c_str(), nullptr, 10));
    };
    if (w.size() == 3 && w[1] == "--scene") {
        std::puts(scene_text(StressScenes(number(2)).next().scene).c_str());
        return 0;
    }
    if (w.size() == 6 && w[1] == "--work") return work(number(2), number(3), {number(4), number(5)});
    if (w.size() != 3) {
        std::fputs("scene_stress: expected COUNT SEED, or --scene SEED\n", stderr);
        return 2;
    }
    constexpr unsigned batch = 200;
    std::size_t scenes = 0;
    for (unsigned done = 0; done < number(1); done += batch) {
        const auto found = compare_sets(w[0], number(2) + done, std::min(batch, number(1) - done));
        if (!found) return 1;
        scenes += *found;
        std::printf("%u tried, %zu of them valid scenes\n", std::min(done + batch, number(1)), scenes);
        std::fflush(stdout);
    }
    return 0;
}
