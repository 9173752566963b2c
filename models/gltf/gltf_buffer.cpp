#include "models/gltf/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <map>

#include "models/mesh/normals.h"

namespace glint {
namespace {

// OpenGL's constants.
constexpr int vertex_data = 34962, index_data = 34963, of_floats = 5126, of_unsigned_ints = 5125;

void append(std::string& bytes, std::uint32_t bits) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFF);
}

}  // namespace

Json numbers_json(const glm::vec3& v) {
    return Json::array({number_json(v.x), number_json(v.y), number_json(v.z)});
}

std::string glb_container(std::string_view json, std::string_view bin) {
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    const std::size_t length = 12 + 8 + padded(json.size()) + (bin.empty() ? 0 : 8 + padded(bin.size()));
    std::string out;
    out.reserve(length);
    const auto number = [&out](std::size_t n) { append(out, static_cast<std::uint32_t>(n)); };
    const auto chunk = [&](std::string_view type, std::string_view content, char filler) {
        number(padded(content.size()));
        out += type;
        out += content;
        out.append(padded(content.size()) - content.size(), filler);
    };
    out += "glTF";
    number(2);
    number(length);
    chunk("JSON", json, ' ');
    if (!bin.empty()) chunk({"BIN\0", 4}, bin, '\0');
    return out;
}

GltfMeshKey mesh_key(const Object& object) { return {normals_key(object), object.normals.flip}; }

int GltfBuffer::add_view(std::size_t begin, int target) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}, {"target", target}});
    return static_cast<int>(views_.size()) - 1;
}

int GltfBuffer::add_vectors(const std::vector<glm::vec3>& vectors, bool with_bounds) {
    const std::size_t begin = bytes_.size();
    glm::vec3 low(vectors.front()), high(low);
    for (const glm::vec3& v : vectors) {
        for (int i = 0; i < 3; ++i) append(bytes_, std::bit_cast<std::uint32_t>(v[i]));
        low = glm::min(low, v);
        high = glm::max(high, v);
    }
    Json accessor{{"bufferView", add_view(begin, vertex_data)},
                  {"componentType", of_floats},
                  {"count", vectors.size()},
                  {"type", "VEC3"}};
    if (with_bounds) {
        accessor["min"] = numbers_json(low);
        accessor["max"] = numbers_json(high);
    }
    accessors_.push_back(accessor);
    return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::add_indices(const std::vector<std::uint32_t>& indices) {
    const std::size_t begin = bytes_.size();
    for (const std::uint32_t i : indices) append(bytes_, i);
    accessors_.push_back({{"bufferView", add_view(begin, index_data)},
                          {"componentType", of_unsigned_ints},
                          {"count", indices.size()},
                          {"type", "SCALAR"}});
    return static_cast<int>(accessors_.size()) - 1;
}

Json GltfBuffer::add(const Object& object) {
    const Mesh& mesh = *object.mesh;
    const CornerNormals normals = corner_normals(mesh, object.normals);
    // A vertex is a position with a normal.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
    std::vector<glm::vec3> places, directions;
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle.corner) {
            const std::uint32_t position = mesh.corner_position[corner];
            const std::uint32_t normal = normals.corner.empty() ? position : normals.corner[corner];
            const auto [at, is_new] = known.emplace(std::pair(position, normal), places.size());
            if (is_new) {
                places.push_back(mesh.positions[position]);
                directions.push_back((object.normals.flip ? -1.0f : 1.0f) * normals.normals[normal]);
            }
            indices.push_back(at->second);
        }
    const int place = add_vectors(places, true), direction = add_vectors(directions, false);
    return {{"attributes", {{"POSITION", place}, {"NORMAL", direction}}}, {"indices", add_indices(indices)}};
}

}  // namespace glint
