#include "tests/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace glint::fuzz {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

std::size_t put(std::string_view text, std::uint8_t* data, std::size_t max_size) {
    const std::size_t size = std::min(text.size(), max_size);
    std::copy_n(text.data(), size, data);
    return size;
}

std::string path_of_bytes(std::string_view bytes) {
    static const int file = ::memfd_create("fuzz", MFD_CLOEXEC);
    require(file >= 0 && ::ftruncate(file, 0) == 0 &&
                ::pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
            "no file in memory could be made");
    return "/proc/self/fd/" + std::to_string(file);
}

}  // namespace glint::fuzz
