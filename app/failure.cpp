#include "app/failure.h"

#include <fmt/format.h>

#include <cstdio>

namespace glint {

void say(const char* kind, Problem problem) {
    const std::string head = fmt::format("glint: {}: ", kind);
    // The length limit applies to the entire line, so that truncation keeps its beginning.
    problem.file.empty() ? problem.what.insert(0, head) : problem.file.insert(0, head);
    std::fputs((problem.text() + "\n").c_str(), stderr);
}

void say_warning(const std::string& warning) {
    say("warning", {.file = {}, .pointer = {}, .what = warning, .expected = {}});
}

}  // namespace glint
