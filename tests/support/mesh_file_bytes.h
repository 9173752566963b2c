#pragma once
// Mesh files in memory, for tests.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <variant>
#include <vector>

#include "models/gltf/gltf.h"
#include "models/mesh/formats/mesh_file.h"
#include "tests/support/catch.h"

namespace glint::test {

/// The mesh in `bytes`, read as a file of that name; for glTF, the first part.
inline Result<Mesh> parsed(const std::string& name, const std::string& bytes) {
    if (!is_gltf_path(name)) return parse_mesh(bytes, name);
    return result_of(name, [&] { return value_or_throw(GltfFile::parse(bytes, name)).mesh(0); });
}

/// The mesh in `bytes`; fails the test with the one-line problem if they cannot be read.
inline Mesh read_text(const std::string& name, const std::string& bytes) {
    Result<Mesh> result = parsed(name, bytes);
    if (const Problem* problem = problem_of(result)) FAIL(problem->text());
    return std::get<Mesh>(std::move(result));
}

/// The one-line problem with `bytes`; empty if they can be read.
inline std::string error_of(const std::string& name, const std::string& bytes) {
    const Result<Mesh> result = parsed(name, bytes);
    const Problem* problem = problem_of(result);
    return problem == nullptr ? "" : problem->text();
}

struct Malformed {
    std::string name, bytes, error;  // `error` follows the name in the message
};
inline void check_all(const std::vector<Malformed>& table) {
    for (const Malformed& m : table) {
        INFO(m.bytes);
        CHECK(error_of(m.name, m.bytes) == m.name + m.error);
    }
}

/// The bytes of numbers in sequence, little-endian or big-endian.
class Bytes {
  public:
    explicit Bytes(std::string head = {}, bool big = false) : bytes_(std::move(head)), big_(big) {}
    template <class T> Bytes& add(std::initializer_list<T> numbers) {
        for (const T number : numbers) {
            char raw[sizeof(T)];
            std::memcpy(raw, &number, sizeof(T));  // assumes a little-endian machine
            if (big_) std::reverse(raw, raw + sizeof(T));
            bytes_.append(raw, sizeof(T));
        }
        return *this;
    }
    Bytes& f32(std::initializer_list<float> n) { return add(n); }
    Bytes& u8(std::initializer_list<std::uint8_t> n) { return add(n); }
    Bytes& u16(std::initializer_list<std::uint16_t> n) { return add(n); }
    Bytes& u32(std::initializer_list<std::uint32_t> n) { return add(n); }
    [[nodiscard]] const std::string& str() const { return bytes_; }

  private:
    std::string bytes_;
    bool big_;
};

/// A binary STL of two facets of a square in z = 0 that claims to have `count` of them.
inline std::string binary_stl(std::uint32_t count = 2, float first_x = 0) {
    return Bytes(std::string(80, ' '))
        .u32({count})
        .f32({0, 0, 1, first_x, 0, 0, 1, 0, 0, 1, 1, 0})
        .u16({0})
        .f32({0, 0, 1, -0.f, 0, 0, 1, 1, 0, 0, 1, 0})
        .u16({0})
        .str();
}

/// A PLY of a square with normals and colours, in either byte order.
inline std::string binary_ply(bool big) {
    Bytes bytes(
        std::string("ply\nformat binary_") + (big ? "big" : "little") +
            "_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property double x\nproperty float z\nproperty short y\nproperty list uchar int skipped\n"
            "property float nx\nproperty float ny\nproperty float nz\nelement extra 1\n"
            "property list uint double values\nelement face 1\nproperty uchar flag\n"
            "property list ushort uint vertex_index\nend_header\n",
        big);
    for (int i = 0; i < 4; ++i) {
        bytes.u8({255, 0, 51}).add<double>({i == 1 || i == 2 ? 1.0 : 0.0}).f32({0.5f});
        bytes.add<std::int16_t>({static_cast<std::int16_t>(i >= 2 ? 1 : 0)}).u8({1}).u32({7}).f32({0, 0, 2});
    }
    bytes.u32({2}).add<double>({1, 2}).u8({9}).u16({4}).u32({0, 1, 2, 3});
    return bytes.str();
}

}  // namespace glint::test
