#pragma once
// The normals of the objects for shading: in camera coordinates, normalized. Lecture: "Vertex Normals"; a
// normal is transformed by the inverse transpose of the points' matrix.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "models/mesh/normals.h"
#include "renderer/geometry/geometry.h"

namespace glint {

/// The mistakes that affect normals (models/scene/mistakes.h).
struct NormalMistakes {
    bool unnormalized = false, by_model_matrix = false, flipped = false, none_given = false;
    bool left_in_object = false, left_in_world = false, as_points = false;
    bool facets_reversed = false, mirror_turns = false;
    bool unnormalized_at_pixel = false, some_faces_flipped = false;
    bool without_model = false, by_inverse = false, by_projection = false, of_screen_points = false;
    bool cross_component_wrong = false, first_corners = false, last_facet_wins = false;
    bool axes_exchanged = false, positions = false, by_position_index = false, lengths = false;
    bool zero_is_nan = false;
    int form = 0;  // Mistakes::form
    bool operator==(const NormalMistakes&) const = default;
};
[[nodiscard]] NormalMistakes normal_mistakes(const Mistakes& mistakes);

/// Normals of one object.
struct ObjectNormals {
    MeshPtr mesh;
    NormalOptions options;
    bool mistaken = false;  // of_mesh contains mistaken normals, not those of mesh and options
    // Object coordinates; the same for all objects of that mesh with those options.
    std::shared_ptr<const CornerNormals> of_mesh;
    std::vector<CameraNormal> normals;  // of_mesh->normals in camera coordinates

    /// For each corner of the mesh, the index into `normals`.
    [[nodiscard]] const std::vector<std::uint32_t>& normal_of_corner() const {
        return of_mesh->corner.empty() ? mesh->corner_position : of_mesh->corner;
    }
    [[nodiscard]] glm::vec3 at_corner(std::uint32_t corner) const {
        return normal(normal_of_corner()[corner]);
    }
    /// The number of a lit vertex within its object: its position's index if each position has one normal,
    /// else its corner's. normal_of_slot(slot) is its normal.
    [[nodiscard]] std::uint32_t slot_of(std::uint32_t corner) const {
        return of_mesh->corner.empty() ? mesh->corner_position[corner] : corner;
    }
    [[nodiscard]] glm::vec3 normal_of_slot(std::uint32_t slot) const {
        return normal(of_mesh->corner.empty() ? slot : of_mesh->corner[slot]);
    }
    [[nodiscard]] std::uint32_t position_of_slot(std::uint32_t slot) const {
        return of_mesh->corner.empty() ? slot : mesh->corner_position[slot];
    }
    [[nodiscard]] std::size_t slot_count() const {
        return of_mesh->corner.empty() ? mesh->positions.size() : mesh->corner_position.size();
    }
    [[nodiscard]] glm::vec3 normal(std::uint32_t which) const {
        const CameraNormal& n = normals[which];
        return {n.x, n.y, n.z};
    }
};

/// Updates the normals of all objects. An object keeps its normals while its mesh and options stay the same.
void update_normals(std::vector<ObjectNormals>& kept, const Scene& scene, const Geometry& geometry,
                    const NormalMistakes& mistakes);

/// True if `kept` was computed from the same meshes and options.
[[nodiscard]] bool same_normals(const std::vector<ObjectNormals>& kept, const Scene& scene);

/// The facet normal of a polygon in camera coordinates, normalized; (0, 0, 0) if it has no area. `flip`: from
/// the object's NormalOptions.
[[nodiscard]] glm::vec3 camera_facet_normal(const ObjectGeometry& object, bool flip, std::uint32_t face,
                                            const NormalMistakes& mistakes);

// Caches values of the most recent faces. Computing a value visits all corners of a face, which is too
// expensive for every pixel, and neighbouring pixels show the same few faces.

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
