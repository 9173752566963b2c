// How much memory may be asked for, and what is said when it is not enough.
#include "models/memory_limit.h"

#include <filesystem>
#include <new>

#include "models/io/file.h"
#include "models/scene_file/scene_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using test::MemoryLimit;

namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20, gib = std::uint64_t{1} << 30;

std::uint64_t size_of(std::string_view text) {
    const auto size = parse_memory_size("--memory", text);
    return problem_of(size) == nullptr ? std::get<std::uint64_t>(size) : 0;
}

std::string refusal_of(const MemoryNeed& need) {
    try {
        require_memory(need);
    } catch (const Refused& refused) {
        return refused.what();
    }
    return {};
}

}  // namespace

TEST_CASE("a size of memory is a whole number of bytes, K, M, G or T", "[memory]") {
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
          "--memory: 8GB is not a memory size; expected bytes as in 8G, with K, M, G or T behind a whole "
          "number; "
          "1M at least");
}

TEST_CASE("a share that does not fit beside the others is refused, and says what is largest", "[memory]") {
    const MemoryLimit limit(100 * mib);
    MemoryShare meshes(memory_need(MemoryUse::Meshes, 60 * mib));
    CHECK(memory_left() <= 40 * mib);
    MemoryShare pixels;
    CHECK_THROWS_AS(pixels.set(memory_need(MemoryUse::Pixels, 50 * mib)), Refused);
    CHECK(pixels.need().total() == 0);
    pixels.set(memory_need(MemoryUse::Pixels, 30 * mib));
    CHECK_THROWS_AS(pixels.add(memory_need(MemoryUse::Pixels, 20 * mib)), Refused);
    CHECK(pixels.need().total() == 30 * mib);
    CHECK(refusal_of(memory_need(MemoryUse::Tiles, 80 * mib)) ==
          "this needs 170.0 MiB of memory, 80.0 MiB of it for the triangles in the tiles of the picture; "
          "expected "
          "at most 100.0 MiB (--memory and GLINT_MEMORY change that)");
    meshes = {};  // given back
    CHECK(refusal_of(memory_need(MemoryUse::Tiles, 60 * mib)).empty());
}

TEST_CASE("a share goes with what holds it", "[memory]") {
    const MemoryLimit limit(100 * mib);
    const std::uint64_t before = memory_left();
    {
        MemoryShare first(memory_need(MemoryUse::Files, 10 * mib));
        MemoryShare second = std::move(first);
        CHECK(memory_left() == before - 10 * mib);
        second = MemoryShare(memory_need(MemoryUse::Files, 5 * mib));
        CHECK(memory_left() == before - 5 * mib);
    }
    CHECK(memory_left() == before);
}

TEST_CASE("less may always be asked for, whatever the limit has become", "[memory]") {
    MemoryShare share(memory_need(MemoryUse::Files, 10 * mib));
    const MemoryLimit limit(2 * mib);
    CHECK_NOTHROW(share.set(memory_need(MemoryUse::Files, 9 * mib)));
}

TEST_CASE("what is built of JSON text is reckoned while it is built", "[memory]") {
    const auto problem_with = [](const std::string& text, std::uint64_t limit = 16 * mib) {
        const MemoryLimit room(limit);
        const std::uint64_t left = memory_left();
        const Result<Scene> scene = parse_scene(text, "large.json");
        CHECK(memory_left() == left);
        return problem_of(scene) == nullptr ? "" : problem_of(scene)->text();
    };
    std::string objects = R"({"glint": 1, "objects": [{})";
    for (int i = 0; i < 300'000; ++i) objects += ",{}";  // 0.9 MB, of which are made 26
    CHECK(problem_with(objects + "]}").find("large.json: this needs ") == 0);
    const std::string name(12 * mib, 'x');
    CHECK(problem_with(R"({"glint": 1, "about": ")" + name + "\"}").find("large.json: this needs ") == 0);
    // The text, what is made of it, and the scene's own: 1.0 MB, 1.4 MB and 1.0 MB.
    std::string named = R"({"glint": 1, "objects": [{})";
    for (int i = 0; i < 4000; ++i) named += ",{\"name\": \"" + std::string(240, 'x') + "\"}";
    CHECK(problem_with(named + "]}", 3 * mib).find("large.json: this needs ") == 0);
    CHECK(problem_with(named + "]}", 4 * mib).empty());
    CHECK(problem_with(R"({"glint": 1, "about": "small"})").empty());
}

TEST_CASE("a string of JSON text is counted as reading it takes, before it is read", "[memory]") {
    const auto is_refused = [](const std::string& text) {
        const MemoryLimit room(16 * mib);
        const Result<Scene> scene = parse_scene(text, "large.json");
        return problem_of(scene) != nullptr &&
               problem_of(scene)->text().find("this needs ") != std::string::npos;
    };
    const std::string name(5 * mib, 'x');
    CHECK(is_refused(R"({"about": ")" + name));  // which ends early: nobody comes to see
    CHECK(is_refused(R"({"\\": "\"", "about": ")" + name));
    CHECK_FALSE(is_refused(R"({"about": [)" + std::string(5 * mib, ' ')));
}

TEST_CASE("a file that does not fit into memory is refused after its first block, and its share goes",
          "[memory]") {
    const TemporaryDirectory folder;
    const std::string large = folder.file("large", "x");
    std::filesystem::resize_file(large, 64 * mib);  // a hole takes no disk
    const MemoryLimit room(32 * mib);
    const std::uint64_t left = memory_left();
    std::size_t blocks = 0;
    const auto read = read_file(large, gib, [&blocks](const FileBlock&) {
        ++blocks;
        return std::optional<Problem>();
    });
    REQUIRE(problem_of(read) != nullptr);
    CHECK(problem_of(read)->text().starts_with(large + ": this needs 64.0 MiB of memory"));
    CHECK(blocks == 1);
    CHECK(memory_left() == left);
    // One that fits is the caller's while it holds the share.
    std::filesystem::resize_file(large, 16 * mib);
    {
        MemoryShare share;
        CHECK(problem_of(read_file(large, gib, {}, &share)) == nullptr);
        CHECK(memory_left() == left - 16 * mib);
    }
    CHECK(memory_left() == left);
    CHECK(problem_of(read_file(large, gib)) == nullptr);
    CHECK(memory_left() == left);
}

TEST_CASE("the memory of a control group is the least of it and those around it", "[memory]") {
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

TEST_CASE("the limit on the address space limits what may be asked for", "[memory]") {
    if (test::sanitized) return;
    const std::uint64_t here = default_memory_limit();
    CHECK(test::in_process_with_room(256 * mib, [here] { return default_memory_limit() < here; }));
}

TEST_CASE("where memory has run out it is said what would help", "[memory]") {
    CHECK(memory_problem(std::bad_alloc(), "a.json").text() ==
          "a.json: there is not enough memory for this; expected more of it, or less to do at once");
}
