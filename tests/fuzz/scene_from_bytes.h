#pragma once
// A valid scene from any bytes, by the rows of models/fields/scene_fields.h: a field that is added there is
// filled here.

#include <cstddef>
#include <cstdint>
#include <span>

#include "models/scene/scene.h"

namespace glint::fuzz {

/// The bytes of an input, taken from the front; zeros when there are no more.
class Bytes {
  public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    unsigned byte();
    /// From 0 to n - 1, by one byte. Precondition: 1 <= n <= 256.
    std::size_t below(std::size_t n) { return byte() % n; }

  private:
    std::span<const std::uint8_t> bytes_;
};

/// A scene that its file could hold, of few lights and of shapes with few faces, its meshes loaded. Each
/// field takes the same number of bytes whatever is in them, so that changing a byte changes one field.
[[nodiscard]] Scene scene_from(Bytes& bytes);

/// The scene with one of its fields filled anew.
struct EditedScene {
    Scene scene;
    bool moves_faces = true;  // false: the field decides how a pixel is lit, never which face it shows (Row)
};
[[nodiscard]] EditedScene edited(const Scene& scene, Bytes& bytes);

}  // namespace glint::fuzz
