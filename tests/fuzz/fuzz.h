#pragma once
// Common parts of the fuzzers. Each is a libFuzzer program, which calls LLVMFuzzerTestOneInput with bytes and
// keeps those that reach new code (tests/fuzz/run.sh).

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "models/mesh/mesh.h"

extern "C" {  // NOLINTBEGIN(readability-identifier-naming): libFuzzer's names
// libFuzzer's interface (LLVM 14, "FuzzerInterface.h"): its entry points, and the function that a custom
// mutator may call.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                    unsigned seed);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
}  // NOLINTEND(readability-identifier-naming)

namespace glint::fuzz {

/// Prints a violated condition and aborts, which libFuzzer reports as a finding.
void require(bool holds, const char* what);

/// Checks a mesh that was read: indices are in range, numbers and normals are finite.
void require_sound(const Mesh& mesh);

/// The input as text, in the caller's memory: reading past its end is detected.
[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Replaces an input with `text`, truncated to `max_size`; returns the input's new size.
[[nodiscard]] std::size_t put(std::string_view text, std::uint8_t* data, std::size_t max_size);

/// The path of a file in memory that contains these bytes until the next call.
[[nodiscard]] std::string path_of_bytes(std::string_view bytes);

}  // namespace glint::fuzz
