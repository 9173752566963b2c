#pragma once
// Caches values of the most recent faces. Computing a value visits all corners of a face, which is too
// expensive for every pixel, and neighbouring pixels show the same few faces.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace glint {

/// The minimum number of corners for which caching a face pays off.
inline constexpr std::size_t many_corners = 64;

/// Identifies a face of an object of a Geometry.
struct GeometryFace {
    std::uint64_t geometry = 0;  // Geometry::state
    std::uint32_t object = 0, face = 0;
    bool operator==(const GeometryFace&) const = default;
};

/// The values of the most recent faces, for one thread.
template <class Face, class Value> class RecentFaces {
  public:
    /// Returns the value of a face, computed by make() if it is not cached.
    template <class Make> Value& of(const Face& face, const Make& make) {
        for (std::optional<Known>& known : known_)
            if (known && known->face == face) return known->value;
        std::optional<Known>& oldest = known_[next_];
        next_ = (next_ + 1) % known_.size();
        oldest.reset();  // releases its memory before more is allocated
        return oldest.emplace(face, make).value;
    }

  private:
    struct Known {
        template <class Make> Known(const Face& of_face, const Make& make) : face(of_face), value(make()) {}
        Face face;
        Value value;
    };
    std::array<std::optional<Known>, 8> known_;
    std::size_t next_ = 0;
};

}  // namespace glint
