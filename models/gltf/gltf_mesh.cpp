// Converts a primitive of a glTF mesh to a mesh of ours.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_document.h"
#include "models/mesh/formats/mesh_reader.h"
#include "models/mesh/formats/places.h"
#include "models/progress.h"

namespace glint {
namespace {

/// Fails unless the accessor that `key` of `from` names has one of these component types.
void require_type(const Node& from, std::string_view key, int type, std::initializer_list<int> allowed,
                  const char* expected) {
    if (std::find(allowed.begin(), allowed.end(), type) == allowed.end())
        from.with(key,
                  [&](const Node& at) { at.fail(fmt::format("its componentType is {}", type), expected); });
}

/// The vertex numbers of each triangle, in the order that the mode defines.
class Triangles {
  public:
    Triangles(const GltfDocument& document, const Node& root, const Node& primitive, std::size_t vertices)
        : count_(vertices) {
        if (!primitive.has("indices")) return;
        indices_ = numbers_of(document, root, primitive, "indices", "SCALAR");
        count_ = indices_.count;
        require_type(primitive, "indices", indices_.type,
                     {gltf_unsigned_byte, gltf_unsigned_short, gltf_unsigned_int}, "5121, 5123 or 5125");
        primitive.with("indices", [&](const Node& at) {
            for (std::size_t i = 0; i < count_; ++i)
                if (!(indices_.at(i, 0) < static_cast<double>(vertices)) || indices_.at(i, 0) < 0)
                    at.fail(fmt::format("number {} of the indices is {:.0f}", i, indices_.at(i, 0)),
                            fmt::format("0 to {}", vertices - 1));
        });
    }

    /// Calls f(a, b, c) for each triangle; returns the number of leftover vertices.
    template <class F> std::size_t each(PrimitiveMode mode, const F& f) const {
        if (mode == PrimitiveMode::Triangles) {
            for (std::size_t i = 0; i + 3 <= count_; i += 3) f(at(i), at(i + 1), at(i + 2));
            return count_ % 3;
        }
        for (std::size_t i = 0; i + 3 <= count_; ++i) {
            if (mode == PrimitiveMode::Fan)
                f(at(0), at(i + 1), at(i + 2));
            else if (i % 2 == 0)
                f(at(i), at(i + 1), at(i + 2));
            else
                f(at(i + 1), at(i), at(i + 2));
        }
        return 0;
    }

  private:
    [[nodiscard]] std::uint32_t at(std::size_t i) const {
        return static_cast<std::uint32_t>(indices_.data == nullptr ? static_cast<double>(i)
                                                                   : indices_.at(i, 0));
    }
    std::size_t count_;
    GltfNumbers indices_;
};

/// Reads a vertex attribute: floats, or small integers if the file names KHR_mesh_quantization.
std::vector<glm::vec3> vectors(const GltfDocument& document, const GltfNumbers& numbers,
                               const Node& attributes, const char* what) {
    if (numbers.type == gltf_unsigned_int)
        require_type(attributes, what, numbers.type, {gltf_floats}, "5126 (floats)");
    else if (!document.is_quantized)
        require_type(attributes, what, numbers.type, {gltf_floats},
                     "5126 (floats), or \"KHR_mesh_quantization\" in \"extensionsUsed\"");
    std::vector<glm::vec3> all(numbers.count);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = numbers.vector_at(i);
        if (what == std::string_view("NORMAL")) continue;  // drop_bad_normals() checks them
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(all[i][k]) <= static_cast<float>(max_number)))
                attributes.with(what, [&](const Node& at) {
                    at.fail(fmt::format("a number of vertex {} is {}", i, all[i][k]),
                            std::string(any_number.words));
                });
    }
    return all;
}

GltfVertices read_vertices(const GltfDocument& document, const GltfVertexKey& key, const Node& attributes) {
    GltfVertices read;
    const std::vector<glm::vec3> vertices = vectors(document, key.first, attributes, "POSITION");
    if (attributes.has("NORMAL")) {
        read.normals = vectors(document, key.second, attributes, "NORMAL");
        if (read.normals.size() != vertices.size())
            attributes.fail(fmt::format("it has {} normals", read.normals.size()),
                            fmt::format("{}, one a vertex", vertices.size()));
    }
    Places shared;
    read.place_of.reserve(vertices.size());
    for (const glm::vec3& v : vertices) read.place_of.push_back(shared.index_of(v, read.places));
    return read;
}

/// The vertices of a primitive. Vertices shared with other primitives are kept in the document; all others
/// are stored in `own`.
const GltfVertices& vertices_of(const GltfDocument& document, const Node& root, const Node& attributes,
                                GltfVertices& own) {
    const GltfVertexKey key = vertex_key_of(document, root, attributes);
    const auto kept = document.kept_vertices.find(key);
    if (kept != document.kept_vertices.end()) return kept->second;
    own = read_vertices(document, key, attributes);
    if (!document.shared_vertices.contains(key)) return own;
    return document.kept_vertices.emplace(key, std::move(own)).first->second;
}

void read_primitive(const GltfDocument& document, const Node& root, const Node& primitive, Mesh& mesh) {
    const PrimitiveMode mode = mode_of(primitive);
    if (mode == PrimitiveMode::None) primitive.fail("it is made of points or lines", "one with triangles");
    primitive.with("attributes", [&](const Node& attributes) {
        require_object(attributes);
        follow(root, attributes, "POSITION", "accessors", [&](const Node& accessor) {
            const bool is_draco = has_extension(primitive, "KHR_draco_mesh_compression");
            if (is_draco && accessor.value().is_object() && !accessor.has("bufferView"))
                primitive.fail("it is compressed (Draco), which is not read", "a file without compression");
        });
        for (const char* attribute : {"POSITION", "NORMAL"})
            if (is_sparse(root, attributes, attribute))
                attributes.fail(fmt::format("its {} is a sparse accessor", attribute),
                                "one with all numbers");
        GltfVertices own;
        const GltfVertices& vertices = vertices_of(document, root, attributes, own);
        if (&vertices == &own) {
            mesh.positions = std::move(own.places);
            mesh.normals = std::move(own.normals);
        } else {
            mesh.positions = vertices.places;
            mesh.normals = vertices.normals;
        }
        if (attributes.has("NORMAL")) mesh.given_normals = GivenNormals::File;
        mesh.first_corner.push_back(0);
        const Triangles triangles(document, root, primitive, vertices.place_of.size());
        const std::size_t left = triangles.each(mode, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            for (const std::uint32_t v : {a, b, c}) {
                mesh.corner_position.push_back(vertices.place_of[v]);
                if (!mesh.normals.empty()) mesh.corner_normal.push_back(v);
            }
            close_face(mesh, document.path);
        });
        warn(mesh.warnings, left, "vertex is left over after the last triangle",
             "vertices are left over after the last triangle");
        if (mesh.face_count() == 0) primitive.fail("it has no triangle", "at least one");
    });
    if (mesh.first_corner.empty()) primitive.fail("the key \"attributes\" is missing", "{\"POSITION\": ...}");
}

}  // namespace

PrimitiveMode mode_of(const Node& primitive) {
    switch (whole(primitive, "mode", 6, 4)) {
    case 4:
        return PrimitiveMode::Triangles;
    case 5:
        return PrimitiveMode::Strip;
    case 6:
        return PrimitiveMode::Fan;
    default:
        return PrimitiveMode::None;
    }
}

Result<Mesh> GltfFile::mesh(int part) const {
    const auto start = std::chrono::steady_clock::now();
    Mesh mesh;
    return result_of(document_->path, [&]() -> Result<Mesh> {
        const Node root(document_->root);
        const std::vector<std::size_t>& first = document_->first_parts;
        if (part < 0 || static_cast<std::size_t>(part) >= first.back())
            return Problem{
                "", "/part", fmt::format("the file has no part {}", part),
                first.back() == 0 ? "a file with a mesh" : fmt::format("0 to {}", first.back() - 1)};
        const auto number = static_cast<std::size_t>(part);
        // Find the last mesh that begins at or before the part: an empty mesh begins where the next one does.
        const auto in_mesh = static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), number) -
                                                      first.begin() - 1);
        root.with("meshes", [&](const Node& meshes) {
            const Node one(meshes.value()[in_mesh], meshes, in_mesh);
            one.with("primitives", [&](const Node& primitives) {
                const std::size_t index = number - first[in_mesh];
                const Node primitive(primitives.value()[index], primitives, index);
                require_object(primitive);
                read_primitive(*document_, root, primitive, mesh);
            });
        });
        drop_bad_normals(mesh);
        finish_mesh(mesh);
        if (auto warning = rounding_warning(mesh.bounds)) mesh.warnings.push_back(std::move(*warning));
        const auto time = std::chrono::steady_clock::now() - start;
        mesh.load_ms = std::chrono::duration<double, std::milli>(time).count();
        return mesh;
    });
}

}  // namespace glint
