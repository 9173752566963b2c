// Changes the bytes of a PNG and corrects its checksums, for the fuzzers that read one.

#include <zlib.h>

#include "tests/fuzz/fuzz.h"

namespace {

constexpr std::size_t signature = 8, frame = 12;  // bytes: before the first chunk; around a chunk's data

std::uint32_t big_endian(const std::uint8_t* at) {
    return std::uint32_t{at[0]} << 24 | std::uint32_t{at[1]} << 16 | std::uint32_t{at[2]} << 8 | at[3];
}

/// Corrects the checksums; without this a reader stops at every changed chunk.
void repair_checksums(std::uint8_t* data, std::size_t size) {
    for (std::size_t at = signature; at + frame <= size;) {
        const std::size_t length = big_endian(data + at);
        if (length > size - at - frame) return;
        const auto sum = static_cast<std::uint32_t>(crc32_z(0, data + at + 4, length + 4));
        for (int i = 0; i < 4; ++i)
            data[at + 8 + length + static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += frame + length;
    }
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed) {
    const std::size_t changed = LLVMFuzzerMutate(data, size, max_size);
    if (seed % 8 != 0) repair_checksums(data, changed);
    return changed;
}
