// Reads checked members and the numbers of accessors.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>

#include "models/gltf/gltf_document.h"
#include "models/mesh/formats/mesh_reader.h"

namespace glint {
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
        view.fail(fmt::format("its buffer {} is not there", buffer),
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
                              "a view that holds them");
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
