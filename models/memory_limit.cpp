#include "models/memory_limit.h"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>

namespace glint {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t least_limit = std::uint64_t{1} << 20;
constexpr const char* size_words =
    "a size such as 8G: a whole number, then K, M, G, T or nothing; at least 1M";

std::atomic<std::uint64_t> limit_set{0};  // 0: not set

std::uint64_t resource_limit(__rlimit_resource which) {
    rlimit limit{};
    if (getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    return limit.rlim_cur;
}

std::uint64_t machine_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0) return unlimited;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

/// Reads the number in a file; the largest possible number if the file is missing or contains a word such as
/// "max".
std::uint64_t number_in(const std::string& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    return file >> number ? number : unlimited;
}

/// Returns the smallest of the limits of a control group and its parents.
std::uint64_t least_up(const std::string& mount, std::string group, const char* name) {
    std::uint64_t least = unlimited;
    for (;;) {
        least = std::min(least, number_in(mount + group + "/" + name));
        const std::size_t cut = group.rfind('/');
        if (cut == std::string::npos) return least;
        group.erase(cut);
    }
}

std::optional<Result<std::uint64_t>> from_environment() {
    const char* text = std::getenv("GLINT_MEMORY");
    if (text == nullptr || *text == '\0') return {};
    return parse_memory_size("GLINT_MEMORY", text);
}

/// Returns the limit that applies if set_memory_limit() was not called. It is computed once, because the
/// environment and the machine do not change while the program runs.
std::uint64_t limit_of_surroundings() {
    static const std::uint64_t limit = [] {
        const auto named = from_environment();
        const auto* bytes = named ? std::get_if<std::uint64_t>(&*named) : nullptr;
        return bytes != nullptr ? *bytes : default_memory_limit();
    }();
    return limit;
}

}  // namespace

Problem problem_from(const std::exception& error, const std::string& file) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
        return {file, "", "there is not enough memory", "more memory or a smaller scene"};
    const auto* limit = dynamic_cast<const LimitExceeded*>(&error);
    Problem problem = limit != nullptr ? limit->problem() : Problem{"", "", error.what(), ""};
    if (problem.file.empty()) problem.file = file;
    return problem;
}

std::uint64_t memory_limit() {
    const std::uint64_t set = limit_set;
    return set != 0 ? set : limit_of_surroundings();
}

void set_memory_limit(std::uint64_t bytes) { limit_set = bytes; }

std::uint64_t control_group_memory(const std::string& root) {
    std::uint64_t least = unlimited;
    std::ifstream groups(root + "/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {  // NUMBER:CONTROLLERS:PATH; none in version 2
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        std::string group = line.substr(second + 1);
        if (group == "/") group.clear();
        if (controllers.empty())
            least = std::min(least, least_up(root + "/sys/fs/cgroup", group, "memory.max"));
        if (controllers == "memory")
            least = std::min(least, least_up(root + "/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
    }
    return least;
}

std::uint64_t default_memory_limit() {
    return std::min({machine_memory(), control_group_memory(""), resource_limit(RLIMIT_AS),
                     resource_limit(RLIMIT_DATA)}) /
           4 * 3;
}

Result<std::uint64_t> parse_memory_size(const std::string& option, std::string_view text) {
    constexpr std::string_view units = "KMGT";
    const auto wrong = [&] {
        return Problem{option, "", fmt::format("{} is not a memory size", text), size_words};
    };
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || end - rest > 1) return wrong();
    unsigned shift = 0;
    if (rest != end) {
        const std::size_t unit =
            units.find(*rest >= 'a' && *rest <= 'z' ? static_cast<char>(*rest - 'a' + 'A') : *rest);
        if (unit == std::string_view::npos) return wrong();
        shift = 10 * (static_cast<unsigned>(unit) + 1);
    }
    if (number > unlimited >> shift || number << shift < least_limit) return wrong();
    return number << shift;
}

std::optional<Problem> memory_limit_problem() {
    const auto named = from_environment();
    const Problem* problem = named ? problem_of(*named) : nullptr;
    return problem != nullptr ? std::optional(*problem) : std::nullopt;
}

}  // namespace glint
