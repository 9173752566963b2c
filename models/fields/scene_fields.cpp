#include "models/fields/scene_fields.h"

#include <fmt/core.h>

namespace glint {

std::string source_name(const MeshSource& source) {
    if (const auto* file = std::get_if<MeshFile>(&source)) return file->path;
    return std::string(name_of(std::get<PrimitiveMesh>(source).primitive));
}

std::string words_of(const Count& count) {
    if (!count.words.empty()) return std::string(count.words);
    return count.low == count.high ? fmt::format("{}", count.low)
                                   : fmt::format("a whole number from {} to {}", count.low, count.high);
}

}  // namespace glint
