// Markdown -> a lesson, or a one-line problem.

#include "lessons/lesson.h"

#include <variant>

#include "tests/fuzz/fuzz.h"

using namespace glint;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<Lesson> read = parse_lesson(fuzz::text_of(data, size), "l.md");
    if (const Problem* problem = problem_of(read)) {
        const std::string line = problem->text();
        fuzz::require(!problem->what.empty() && line.find('\n') == std::string::npos,
                      "a problem is reported on one line");
    }
    return 0;
}
