// The memory limit, and how an exception is reported.
#include "models/memory_limit.h"

#include <filesystem>
#include <new>

#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;

namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20, gib = std::uint64_t{1} << 30;

std::uint64_t size_of(std::string_view text) {
    const auto size = parse_memory_size("--memory", text);
    return problem_of(size) == nullptr ? std::get<std::uint64_t>(size) : 0;
}

}  // namespace

TEST_CASE("a memory size is a whole number of bytes, K, M, G or T", "[memory]") {
    CHECK(size_of("1048576") == mib);
    CHECK(size_of("1024K") == mib);
    CHECK(size_of("3M") == 3 * mib);
    CHECK(size_of("3m") == 3 * mib);
    CHECK(size_of("8G") == 8 * gib);
    CHECK(size_of("2T") == 2048 * gib);
    for (const char* wrong :
         {"", "G", "8GB", "8 G", "-1G", "1.5G", "1048575", "0", "16777216T", "99999999999999999999"}) {
        CAPTURE(wrong);
        CHECK(size_of(wrong) == 0);
    }
    CHECK(std::get<Problem>(parse_memory_size("--memory", "8GB")).text() ==
          "--memory: 8GB is not a memory size; expected a size such as 8G: a whole number, then K, M, G, T "
          "or nothing; at least 1M");
}

TEST_CASE("a control group's memory limit is the minimum of its own and its parents' limits", "[memory]") {
    const TemporaryDirectory root;
    namespace fs = std::filesystem;
    const auto write = [&root](const std::string& path, const std::string& text) {
        fs::create_directories(fs::path(root.path(path)).parent_path());
        (void)root.file(path, text);
    };
    CHECK(control_group_memory(root.path()) == UINT64_MAX);
    SECTION("version 2") {
        write("proc/self/cgroup", "0::/user.slice/a\n");
        write("sys/fs/cgroup/user.slice/a/memory.max", "max\n");
        CHECK(control_group_memory(root.path()) == UINT64_MAX);
        write("sys/fs/cgroup/user.slice/memory.max", "4096\n");
        CHECK(control_group_memory(root.path()) == 4096);
        write("sys/fs/cgroup/user.slice/a/memory.max", "1024\n");
        CHECK(control_group_memory(root.path()) == 1024);
    }
    SECTION("version 2, in a container that sees its own group as the root") {
        write("proc/self/cgroup", "0::/\n");
        write("sys/fs/cgroup/memory.max", "2048\n");
        CHECK(control_group_memory(root.path()) == 2048);
    }
    SECTION("version 1") {
        write("proc/self/cgroup", "11:cpu,cpuacct:/c\n4:memory:/c\n");
        write("sys/fs/cgroup/memory/c/memory.limit_in_bytes", "8192\n");
        CHECK(control_group_memory(root.path()) == 8192);
    }
}
