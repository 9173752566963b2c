// Prints a line for each golden and oracle picture: its name, and a digest of its bytes and of the data
// behind them. The output must be the same for all instruction sets.
#include <fmt/core.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "models/scene_file/scene_file.h"
#include "renderer/explain/equation_text.h"
#include "renderer/renderer.h"
#include "tests/golden/sheet.h"
#include "tests/oracle/random_scene.h"
#include "tests/support/asset_scenes.h"

using namespace glint;

namespace {

/// Source: Fowler, Noll, Vo: FNV-1a, 64 bits.
class Digest {
  public:
    void add(std::string_view bytes) {
        for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    }
    void add(const Picture& picture) {
        add(std::string_view(reinterpret_cast<const char*>(picture.rgba.data()), picture.rgba.size()));
        add(std::string_view(reinterpret_cast<const char*>(picture.linear.data()),
                             picture.linear.size() * sizeof(float)));
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037u;
};

void print(const std::string& name, const Digest& digest) {
    fmt::print("{:016x} {}\n", digest.value(), name);
}

/// The picture, the object at each pixel, and the explanation of every 16th pixel in each direction.
void print(const std::string& name, Renderer& renderer, const Scene& scene, PictureSize size) {
    Digest digest;
    digest.add(renderer.render(scene, size, true));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) digest.add(std::to_string(renderer.object_at(x, y)));
    for (int y = 8; y < size.height; y += 16)
        for (int x = 8; x < size.width; x += 16) digest.add(explain_json(renderer.explain(x, y)));
    print(name, digest);
}

}  // namespace

int main() {
    Renderer renderer;
    for (unsigned i = 0; i < 168; ++i)
        print(fmt::format("random scene {}", i), renderer, oracle::random_scene(i), {160, 120});
    for (unsigned i = 0; i < 72; ++i)
        print(fmt::format("fixed-function scene {}", i), renderer, oracle::random_fixed_function_scene(i),
              {160, 120});
    for (const std::string& path : test::asset_scenes()) {
        const Result<SceneDocument> opened = open_document(path);
        if (const Problem* problem = problem_of(opened)) {
            fmt::print("{}\n", problem->text());
            return 1;
        }
        const std::string name = std::filesystem::path(path).stem().string();
        Scene scene = std::get<SceneDocument>(opened).scene;
        print(name, renderer, scene, {320, 240});
        if (!scene.npr.silhouettes && !scene.npr.creases) continue;
        scene.npr.silhouettes = scene.npr.creases = false;  // as in the oracle
        print(name + " without strokes", renderer, scene, {320, 240});
    }
    for (const golden::Subject& subject : golden::subjects()) {
        Digest digest;
        digest.add(golden::make_sheet(subject));
        print(subject.name, digest);
    }
    Digest drawn;
    drawn.add(golden::make_drawn_sheet());
    print("drawn", drawn);
}
