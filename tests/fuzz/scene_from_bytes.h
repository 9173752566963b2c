#pragma once
// Builds a valid scene from arbitrary bytes, driven by the rows of models/fields/scene_fields.h, so new
// fields are filled automatically.

#include <cstddef>
#include <cstdint>
#include <span>

#include "models/scene/scene.h"

namespace glint::fuzz {

/// The bytes of an input, read from the front; zeros after the end.
class Bytes {
  public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    unsigned byte();
    /// A number from 0 to n - 1, from one byte. Precondition: 1 <= n <= 256.
    std::size_t below(std::size_t n) { return byte() % n; }

  private:
    std::span<const std::uint8_t> bytes_;
};

/// A scene that a scene file can contain, with few lights, shapes with few faces, and loaded meshes. Each
/// field reads a fixed number of bytes, so that changing a byte changes one field.
[[nodiscard]] Scene scene_from(Bytes& bytes);

/// The scene with a new value in one of its fields.
struct EditedScene {
    Scene scene;
    /// False if the field affects only the lighting of pixels, never which face they show (see Row).
    bool moves_faces = true;
};
[[nodiscard]] EditedScene edited(const Scene& scene, Bytes& bytes);

}  // namespace glint::fuzz
