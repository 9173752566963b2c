#pragma once
// What the fuzzers share. Each is a program of libFuzzer, which calls LLVMFuzzerTestOneInput with bytes and
// keeps those that reach new code (tests/fuzz/run.sh).

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "models/mesh/mesh.h"

extern "C" {  // NOLINTBEGIN(readability-identifier-naming): libFuzzer's names
// libFuzzer's interface (LLVM 14, "FuzzerInterface.h"): what it calls, and what a mutator of our own may
// call.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
}  // NOLINTEND(readability-identifier-naming)

namespace glint::fuzz {

/// Says what does not hold and aborts, which libFuzzer takes for a finding.
void require(bool holds, const char* what);

/// Requires of a mesh that was read: indices lie in their lists, numbers and normals are finite.
void require_sound(const Mesh& mesh);

/// The input as text. It is the caller's own memory: a reader that looks past its end is caught.
[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Puts `text` in place of an input, cut off at `max_size`; the input's new size.
[[nodiscard]] std::size_t put(std::string_view text, std::uint8_t* data, std::size_t max_size);

/// The path of a file in memory that holds these bytes until the next call.
[[nodiscard]] std::string path_of_bytes(std::string_view bytes);

}  // namespace glint::fuzz
