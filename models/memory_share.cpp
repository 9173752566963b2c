// Who has asked for how much, and what is said when it is too much.
#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <utility>

#include "models/memory_limit.h"

namespace glint {
namespace {

constexpr std::array<const char*, memory_uses> use_words{"the files that are read",
                                                         "the meshes",
                                                         "the vertices and normals of the objects",
                                                         "the triangles in the tiles of the picture",
                                                         "the pixels and samples of the picture",
                                                         "the output"};

/// The sum of all current shares.
struct Ledger {
    std::mutex mutex;
    MemoryNeed taken;
};
Ledger& ledger() {
    static Ledger all;
    return all;
}

std::string size_text(std::uint64_t bytes) {
    const auto size = static_cast<double>(bytes);
    constexpr double mib = 1 << 20, gib = 1 << 30;
    return size < gib ? fmt::format("{:.1f} MiB", size / mib) : fmt::format("{:.1f} GiB", size / gib);
}

MemoryNeed less(MemoryNeed from, const MemoryNeed& part) {
    for (std::size_t i = 0; i < memory_uses; ++i) from.bytes[i] -= std::min(from.bytes[i], part.bytes[i]);
    return from;
}

Refused refusal(const MemoryNeed& all) {
    const auto largest = std::max_element(all.bytes.begin(), all.bytes.end());
    const auto use = static_cast<std::size_t>(largest - all.bytes.begin());
    Problem problem;
    problem.what = fmt::format("this needs {} of memory, {} of it for {}", size_text(all.total()),
                               size_text(*largest), use_words[use]);
    problem.expected =
        fmt::format("at most {} (--memory and GLINT_MEMORY change that)", size_text(memory_limit()));
    return Refused(std::move(problem));
}

/// Throws Refused when `all` exceeds the limit. Precondition: the ledger's mutex is held.
void require(const MemoryNeed& all) {
    if (all.total() > memory_limit()) throw refusal(all);
}

}  // namespace

std::uint64_t MemoryNeed::total() const {
    return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

MemoryNeed& MemoryNeed::operator+=(const MemoryNeed& more) {
    for (std::size_t i = 0; i < memory_uses; ++i) bytes[i] += more.bytes[i];
    return *this;
}

MemoryNeed memory_need(MemoryUse use, std::uint64_t bytes) {
    MemoryNeed need;
    need[use] = bytes;
    return need;
}

Problem memory_problem(const std::bad_alloc& error, const std::string& file) {
    Problem problem{file, "", "there is not enough memory for this", "more of it, or less to do at once"};
    if (const auto* refused = dynamic_cast<const Refused*>(&error)) {
        problem = refused->problem();
        problem.file = file;
    }
    return problem;
}

void require_memory(const MemoryNeed& need, const MemoryNeed& own) {
    Ledger& all = ledger();
    const std::lock_guard lock(all.mutex);
    MemoryNeed then = less(all.taken, own);
    then += need;
    require(then);
}

std::uint64_t memory_left() {
    Ledger& all = ledger();
    const std::lock_guard lock(all.mutex);
    const std::uint64_t taken = all.taken.total(), limit = memory_limit();
    return taken < limit ? limit - taken : 0;
}

MemoryShare::~MemoryShare() {
    Ledger& all = ledger();
    const std::lock_guard lock(all.mutex);
    all.taken = less(all.taken, need_);
}

MemoryShare::MemoryShare(MemoryShare&& other) noexcept : need_(std::exchange(other.need_, {})) {}

MemoryShare& MemoryShare::operator=(MemoryShare&& other) noexcept {
    MemoryShare given_up;
    std::swap(given_up.need_, need_);
    std::swap(need_, other.need_);
    return *this;
}

void MemoryShare::set(const MemoryNeed& need) {
    Ledger& all = ledger();
    const std::lock_guard lock(all.mutex);
    MemoryNeed then = less(all.taken, need_);
    then += need;
    if (need.total() > need_.total()) require(then);
    all.taken = then;
    need_ = need;
}

void MemoryShare::add(const MemoryNeed& more) {
    Ledger& all = ledger();
    const std::lock_guard lock(all.mutex);
    MemoryNeed then = all.taken;
    then += more;
    require(then);
    all.taken = then;
    need_ += more;
}

MemoryNeed MemoryShare::need() const {
    const std::lock_guard lock(ledger().mutex);
    return need_;
}

}  // namespace glint
