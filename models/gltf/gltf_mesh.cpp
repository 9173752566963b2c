// Converts a primitive of a glTF mesh to one of our meshes.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <initializer_list>

#include "models/gltf/gltf.h"
#include "models/gltf/gltf_document.h"
#include "models/mesh/formats/mesh_reader.h"
#include "models/progress.h"

namespace glint {
namespace {

/// Fails unless the accessor named by `key` in `from` has one of these component types.
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
                    at.fail(fmt::format("entry {} of the indices is {:.0f}", i, indices_.at(i, 0)),
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
                    at.fail(fmt::format("a coordinate of vertex {} is {}", i, all[i][k]),
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
                            fmt::format("{}, one per vertex", vertices.size()));
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
    with_object(primitive, "attributes", [&](const Node& attributes) {
        follow(root, attributes, "POSITION", "accessors", [&](const Node& accessor) {
            const bool is_draco = has_extension(primitive, "KHR_draco_mesh_compression");
            if (is_draco && accessor.value().is_object() && !accessor.has("bufferView"))
                primitive.fail("it uses Draco compression, which is not supported",
                               "a file without compression");
        });
        for (const char* attribute : {"POSITION", "NORMAL"})
            if (is_sparse(root, attributes, attribute))
                attributes.fail(fmt::format("its {} is a sparse accessor", attribute), "a dense accessor");
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

// Reads checked members and the numbers of accessors.

namespace {

/// OpenGL's constants for component types.
enum ComponentType { Byte = 5120, UnsignedByte, Short, UnsignedShort, UnsignedInt = 5125, Float };

std::size_t size_of(std::uint64_t type) {
    switch (type) {
    case Byte:
    case UnsignedByte:
        return 1;
    case Short:
    case UnsignedShort:
        return 2;
    case UnsignedInt:
    case Float:
        return 4;
    default:
        return 0;
    }
}

/// The stride of a buffer view in bytes; 0 if it does not state one.
std::size_t stride_of(const Node& view) {
    std::size_t stride = 0;
    view.with("byteStride", [&](const Node& at) {
        const std::string expected = "a multiple of 4 from 4 to 252";
        if (!at.value().is_number()) at.wrong_type(expected);
        const double x = at.value().get<double>();
        if (!(x >= 4 && x <= 252) || std::fmod(x, 4) != 0)
            at.fail(fmt::format("{} is out of range", x), expected);
        stride = static_cast<std::size_t>(x);
    });
    return stride;
}

/// The start and length of a buffer view, and the stride of its elements.
struct View {
    std::string_view bytes;
    std::size_t stride = 0;  // 0: tightly packed
};
View view_of(const GltfDocument& document, const Node& view) {
    require_object(view);
    const std::uint64_t buffer = whole(view, "buffer", 4294967295.0);
    if (buffer >= document.buffers.size())
        view.fail(fmt::format("its buffer {} does not exist", buffer),
                  fmt::format("one of {}", document.buffers.size()));
    const std::string_view all = document.buffers[buffer];
    const std::uint64_t offset = whole(view, "byteOffset", 9e15, 0), length = whole(view, "byteLength", 9e15);
    if (offset > all.size() || length > all.size() - offset)
        view.fail(fmt::format("its bytes {} to {} are beyond its buffer", offset, offset + length),
                  fmt::format("bytes 0 to {}", all.size()));
    return {all.substr(offset, length), stride_of(view)};
}

}  // namespace

void require_object(const Node& node) {
    if (!node.value().is_object()) node.wrong_type("an object");
}

bool has_extension(const Node& object, std::string_view name) {
    bool found = false;
    object.with("extensions", [&](const Node& all) { found = all.value().is_object() && all.has(name); });
    return found;
}

std::uint64_t whole(const Node& object, std::string_view key, double most, double otherwise) {
    double x = otherwise;
    const std::string expected = fmt::format("a whole number from 0 to {:.0f}", most);
    if (otherwise < 0 && !object.has(key))
        object.fail(fmt::format("the key \"{}\" is missing", key), expected);
    object.with(key, [&](const Node& node) {
        if (!node.value().is_number()) node.wrong_type(expected);
        x = node.value().get<double>();
        if (!(x >= 0 && x <= most) || x != std::floor(x))
            node.fail(fmt::format("{} is out of range", x), expected);
    });
    return static_cast<std::uint64_t>(x);
}

double GltfNumbers::at(std::size_t i, std::size_t component) const {
    const std::size_t size = size_of(static_cast<std::uint64_t>(type));
    const char* at = data + i * stride + component * size;
    const std::uint64_t bits = little_endian(at, size);
    switch (type) {
    case Byte: {
        const double x = static_cast<std::int8_t>(bits);
        return normalized ? std::max(x / 127, -1.0) : x;
    }
    case UnsignedByte:
        return normalized ? static_cast<double>(bits) / 255 : static_cast<double>(bits);
    case Short: {
        const double x = static_cast<std::int16_t>(bits);
        return normalized ? std::max(x / 32767, -1.0) : x;
    }
    case UnsignedShort:
        return normalized ? static_cast<double>(bits) / 65535 : static_cast<double>(bits);
    case Float:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    default:
        return static_cast<double>(bits);
    }
}

glm::vec3 GltfNumbers::vector_at(std::size_t i) const {
    return {static_cast<float>(at(i, 0)), static_cast<float>(at(i, 1)), static_cast<float>(at(i, 2))};
}

std::uint64_t GltfNumbers::bytes() const {
    return count * components * size_of(static_cast<std::uint64_t>(type));
}

GltfNumbers numbers_of(const GltfDocument& document, const Node& root, const Node& from, std::string_view key,
                       std::string_view type) {
    GltfNumbers numbers;
    follow(root, from, key, "accessors", [&](const Node& accessor) {
        require_object(accessor);
        std::string is;
        read(accessor, "type", is);
        if (is != type)
            accessor.fail(fmt::format("its type is {}", in_quotes(is)), fmt::format("\"{}\"", type));
        numbers.components = type == "VEC4" ? 4 : type == "VEC3" ? 3 : 1;
        const std::uint64_t component = whole(accessor, "componentType", 65535);
        const std::size_t size = size_of(component) * numbers.components;
        if (size == 0)
            accessor.fail(fmt::format("its componentType is {}", component),
                          "5120, 5121, 5122, 5123, 5125 or 5126");
        numbers.type = static_cast<int>(component);
        read(accessor, "normalized", numbers.normalized);
        numbers.count = whole(accessor, "count", 2147483647.0);
        if (numbers.count == 0) accessor.fail("its count is 0", "1 or more");
        if (!accessor.has("bufferView")) accessor.fail("it has no numbers: no bufferView", "one");
        follow(root, accessor, "bufferView", "bufferViews", [&](const Node& at) {
            const View view = view_of(document, at);
            const std::uint64_t offset = whole(accessor, "byteOffset", 9e15, 0);
            numbers.stride = view.stride == 0 ? size : view.stride;
            if (numbers.stride < size)
                accessor.fail(
                    fmt::format("its elements have {} bytes and are {} bytes apart", size, numbers.stride),
                    fmt::format("a byteStride of at least {}", size));
            const std::uint64_t needed = offset + (numbers.count - 1) * numbers.stride + size;
            if (needed > view.bytes.size())
                accessor.fail(fmt::format("its {} numbers end at byte {} of its buffer view, which has {}",
                                          numbers.count, needed, view.bytes.size()),
                              "a view that contains them");
            numbers.data = view.bytes.data() + offset;
        });
    });
    return numbers;
}

GltfVertexKey vertex_key_of(const GltfDocument& document, const Node& root, const Node& attributes) {
    GltfVertexKey key{numbers_of(document, root, attributes, "POSITION", "VEC3"), {}};
    if (attributes.has("NORMAL")) key.second = numbers_of(document, root, attributes, "NORMAL", "VEC3");
    return key;
}

bool is_sparse(const Node& root, const Node& from, std::string_view key) {
    bool sparse = false;
    if (from.has(key))
        follow(root, from, key, "accessors", [&](const Node& accessor) {
            sparse = accessor.value().is_object() && accessor.has("sparse");
        });
    return sparse;
}

}  // namespace glint
