// Bytes -> a valid scene -> its picture. Explained pixels equal the picture's exactly; after edits the
// picture equals that of a new renderer; the effect of a lighting change on a pixel is predicted without
// drawing.

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "models/scene_file/scene_file.h"
#include "renderer/renderer.h"
#include "renderer/shade/light_sources.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/scene_from_bytes.h"

using namespace glint;
using fuzz::Bytes;
using fuzz::require;

namespace {

constexpr std::size_t most_side = 24;  // pixels
constexpr int pixels_explained = 3, most_edits = 3;

/// Returns whether two numbers count as unchanged, as in a comparison of scenes: a NaN equals itself, 0
/// equals -0.
bool same(float a, float b) {
    return a == b || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
bool same(const glm::vec3& a, const glm::vec3& b) {
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}
bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) { return same(x, y); });
}

struct Pixel {
    int x, y;
};
Pixel pixel_of(PictureSize size, Bytes& bytes) {
    return {static_cast<int>(bytes.below(static_cast<std::size_t>(size.width))),
            static_cast<int>(bytes.below(static_cast<std::size_t>(size.height)))};
}

bool is_pixel(const Explanation& e, const Picture& picture, Pixel at) {
    const std::uint8_t* bytes = &picture.rgba[4 * picture.pixel(at.x, at.y)];
    return same(e.sum, picture.linear_at(at.x, at.y)) && e.byte[0] == bytes[0] && e.byte[1] == bytes[1] &&
           e.byte[2] == bytes[2];
}

/// Whether rounding may decide if a shadow ray hits a surface: Embree rounds single rays, which explain a
/// pixel, differently from the packets that draw it. It was seen with an object of ten million units.
bool rounds_shadows(const Scene& scene) {
    const auto is_large = [](const glm::vec3& v) {
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > 100'000;
    };
    return scene.transport.model != TransportModel::Local &&
           std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& o) {
               return is_large(o.transform.scale) || is_large(o.transform.translate);
           });
}

void check_pixels(const Renderer& renderer, const Picture& picture, Bytes& bytes) {
    for (int i = 0; i < pixels_explained; ++i) {
        const Pixel at = pixel_of(picture.size, bytes);
        require(is_pixel(renderer.explain(at.x, at.y), picture, at), "an explanation equals its pixel");
        require(renderer.seen_at(at.x, at.y).has_value() == (renderer.object_at(at.x, at.y) >= 0),
                "a pixel shows an object or nothing");
    }
}

/// With a mistake, infinities may occur, for example from an unnormalised half vector between far corners.
void check_numbers(const Scene& scene, const Picture& picture) {
    if (scene.shading.mistakes != Mistakes{}) return;
    for (const float c : picture.linear) require(!std::isnan(c), "a pixel is a number");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes({data, size});
    const PictureSize picture_size{1 + static_cast<int>(bytes.below(most_side)),
                                   1 + static_cast<int>(bytes.below(most_side))};
    const int samples = 1 << (bytes.byte() % 8 < 5 ? 0 : bytes.below(4));
    const std::size_t edits = bytes.below(most_edits + 1);
    Scene scene = fuzz::scene_from(bytes);

    Renderer kept(1);
    for (std::size_t edit = 0;; ++edit) {
        const Picture& picture = kept.render(scene, picture_size, true, samples);
        check_numbers(scene, picture);
        if (samples == 1 && !rounds_shadows(scene)) check_pixels(kept, picture, bytes);
        if (edit > 0) {
            Renderer fresh(1);
            require(same(picture.linear, fresh.render(scene, picture_size, true, samples).linear),
                    "a reused renderer produces the same values");
            require(picture.rgba == fresh.render(scene, picture_size, true, samples).rgba,
                    "a renderer that has drawn before draws the same bytes");
        }
        if (edit == edits) return 0;

        fuzz::EditedScene next = fuzz::edited(scene, bytes);
        const Pixel at = pixel_of(picture_size, bytes);
        std::optional<glm::vec3> told;
        const bool shows_other_faces = next.moves_faces || lights_cull(scene) || lights_cull(next.scene);
        if (samples == 1 && !shows_other_faces && !rounds_shadows(next.scene))
            told = kept.explain_as(next.scene, at.x, at.y).sum;
        scene = std::move(next.scene);
        if (told)
            require(same(*told, kept.render(scene, picture_size, true).linear_at(at.x, at.y)),
                    "a lighting change's effect on a pixel is predicted without drawing");
    }
}
