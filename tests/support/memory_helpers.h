#pragma once
// For tests with a memory limit, with little address space, and with threads that cannot start.

#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <fstream>

#include "models/memory_limit.h"
#include "models/scene/scene.h"
#include "tests/support/catch.h"

namespace glint::test {

/// Sets the memory limit for as long as the object exists.
class MemoryLimit {
  public:
    explicit MemoryLimit(std::uint64_t bytes) { set_memory_limit(bytes); }
    ~MemoryLimit() { set_memory_limit(0); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
};

/// The smallest memory limit for a scene and its picture.
inline std::uint64_t cost_of(const Scene& scene, PictureSize size) {
    const SceneCost cost = scene_cost(scene, size, 1);
    return cost.meshes + cost.objects + cost.picture;
}

/// The result of `action` in a separate process that may use only `bytes` of additional address space; also
/// false if that process crashes. Not usable under sanitizers, which reserve the address space.
template <class Do> bool in_process_with_room(std::uint64_t bytes, const Do& action) {
    const pid_t child = fork();
    if (child == 0) {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t room = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + bytes;
        const rlimit limit{room, room};
        setrlimit(RLIMIT_AS, &limit);
        bool well = false;
        try {
            well = action();
        } catch (...) {
        }
        _exit(well ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// While an object of this type exists, no thread can start, because thread stacks do not fit in memory.
class NoThreads {
  public:
    NoThreads() {
        REQUIRE(pthread_getattr_default_np(&before_) == 0);
        pthread_attr_t huge;
        REQUIRE(pthread_attr_init(&huge) == 0);
        REQUIRE(pthread_attr_setstacksize(&huge, std::size_t{1} << 47) == 0);
        REQUIRE(pthread_setattr_default_np(&huge) == 0);
    }
    ~NoThreads() { (void)pthread_setattr_default_np(&before_); }
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;

  private:
    pthread_attr_t before_;
};

}  // namespace glint::test
