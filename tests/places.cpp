#include "tests/places.h"

namespace glint {

const char* const project_folder = GLINT_SOURCE_DIR;
const char* const glint_program = GLINT_PROGRAM;

std::string project_file(const std::string& path) { return std::string(project_folder) + "/" + path; }

}  // namespace glint
