#include "models/mesh_formats/mesh_file_head.h"

#include <algorithm>

namespace glint {
namespace {

constexpr std::size_t stl_header = 84, stl_facet = 50;  // bytes, of binary files

bool begins_with_solid(std::string_view bytes) {
    const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    const std::string_view word = bytes.substr(first, 5);
    return word == "solid" || word == "SOLID" || word == "Solid";
}

/// Of a binary file.
std::size_t stl_facets(std::string_view bytes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        count |= std::size_t{static_cast<unsigned char>(bytes[80 + i])} << (8 * i);
    return count;
}

}  // namespace

bool begins_badly(std::string_view extension, const FileBlock& first) {
    const std::string_view bytes = first.bytes;
    if (extension == ".ply") return !bytes.starts_with("ply");
    if (extension == ".om") return !bytes.starts_with("OM");
    if (extension == ".stl" && bytes.size() >= stl_header && !begins_with_solid(bytes)) {
        const std::size_t facets = stl_facets(bytes);
        return facets == 0 || stl_header + stl_facet * facets > first.size;
    }
    const std::size_t word = bytes.find_first_not_of(" \t\r\n\v\f");
    return word == std::string_view::npos ? false : bytes[word] == '\0';
}

bool is_text_mesh(std::string_view extension, const FileBlock& first) {
    if (extension == ".om") return false;
    if (extension == ".ply") return first.bytes.find("format ascii") != std::string_view::npos;
    if (extension != ".stl") return true;
    const bool binary =
        first.bytes.size() >= stl_header && stl_header + stl_facet * stl_facets(first.bytes) == first.size;
    return begins_with_solid(first.bytes) && !binary;
}

bool is_hole(const FileBlock& block) {
    constexpr std::size_t shortest = 4096;
    return block.bytes.size() >= shortest &&
           std::all_of(block.bytes.begin(), block.bytes.end(), [](char c) { return c == '\0'; });
}

}  // namespace glint
