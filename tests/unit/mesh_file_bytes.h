#pragma once
// Mesh files in memory, for tests.

#include <string>
#include <variant>

#include "models/mesh_file.h"
#include "tests/catch.h"

namespace glint::test {

/// The mesh in `bytes`; fails the test with its one line when there is none.
inline Mesh read_text(const std::string& name, const std::string& bytes) {
    Result<Mesh> result = parse_mesh(bytes, name);
    if (const Problem* problem = problem_of(result)) FAIL(problem->text());
    return std::get<Mesh>(std::move(result));
}

/// The one line about `bytes`; empty when they are read.
inline std::string error_of(const std::string& name, const std::string& bytes) {
    const Result<Mesh> result = parse_mesh(bytes, name);
    const Problem* problem = problem_of(result);
    return problem == nullptr ? "" : problem->text();
}

}  // namespace glint::test
