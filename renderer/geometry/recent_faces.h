#pragma once
// Keeps what was found of the faces that were asked about last. Of a face of many corners it costs them all,
// which a pixel must not pay: neighbours show the same few faces.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace glint {

/// A face of so many corners is worth keeping.
inline constexpr std::size_t many_corners = 64;

/// A face of an object of a Geometry.
struct GeometryFace {
    std::uint64_t geometry = 0;  // Geometry::state
    std::uint32_t object = 0, face = 0;
    bool operator==(const GeometryFace&) const = default;
};

/// The values of the last few faces, for one thread.
template <class Face, class Value> class RecentFaces {
  public:
    /// Returns the value of a face: make() where it is not among the last few.
    template <class Make> Value& of(const Face& face, const Make& make) {
        for (std::optional<Known>& known : known_)
            if (known && known->face == face) return known->value;
        std::optional<Known>& oldest = known_[next_];
        next_ = (next_ + 1) % known_.size();
        oldest.reset();  // gives back what it holds before more is taken
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
