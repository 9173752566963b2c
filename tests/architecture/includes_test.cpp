#include "tests/architecture/includes.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/places.h"
#include "tests/support/catch.h"

namespace fs = std::filesystem;

TEST_CASE("includes only point down, and GL, GLFW, ImGui and OpenMesh stay in their folders",
          "[architecture]") {
    const fs::path root = glint::project_folder;
    std::vector<std::string> found;
    int files = 0;
    for (const char* folder :
         {"app", "ui", "lessons", "diagnose", "shader", "programs", "renderer", "models"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const auto extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            std::ostringstream text;
            text << std::ifstream(entry.path()).rdbuf();
            const auto more =
                forbidden_includes(fs::relative(entry.path(), root).generic_string(), text.str());
            found.insert(found.end(), more.begin(), more.end());
            ++files;
        }
    }
    CHECK(files > 10);
    for (const auto& line : found) FAIL_CHECK(line);
}

TEST_CASE("fields and handles do not include the window's state, not even indirectly", "[architecture]") {
    std::map<std::string, std::string> files;
    const fs::path root = glint::project_folder;
    for (const auto& entry : fs::recursive_directory_iterator(root / "ui")) {
        if (!entry.is_regular_file()) continue;
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        files[fs::relative(entry.path(), root).generic_string()] = text.str();
    }
    int asked = 0;
    for (const auto& [path, text] : files) {
        if (!path.starts_with("ui/fields/") && !path.starts_with("ui/picture/handles/")) continue;
        ++asked;
        std::string way;
        for (const std::string& file : way_of_includes(files, path, "ui/ui.h")) way += " > " + file;
        INFO("includes ui/ui.h:" << way);
        CHECK(way.empty());
    }
    CHECK(asked >= 15);
    CHECK(way_of_includes({{"a.h", "#include \"b.h\""}, {"b.h", "// why\n#include \"c.h\"\n"}}, "a.h",
                          "c.h") == std::vector<std::string>{"a.h", "b.h", "c.h"});
    CHECK(way_of_includes({{"a.h", "#include \"b.h\""}}, "b.h", "a.h").empty());
}

TEST_CASE("no two headers define classes of the same name, which the linker could confuse",
          "[architecture]") {
    // Ignores specializations and classes in nested namespaces, which are indented or in a .cpp.
    const std::regex definition(R"(^(?:struct|class|enum class|enum)(?: alignas\(\d+\))? (\w+)[^;<]*\{.*)");
    std::map<std::string, std::string> header_of;
    for (const char* folder :
         {"app", "ui", "lessons", "diagnose", "shader", "programs", "renderer", "models"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(glint::project_folder) / folder)) {
            if (entry.path().extension() != ".h") continue;
            std::ifstream file(entry.path());
            for (std::string line; std::getline(file, line);) {
                std::smatch match;
                if (!std::regex_match(line, match, definition)) continue;
                const auto [at, is_new] = header_of.emplace(match[1], entry.path().string());
                INFO(match[1] << " is defined in " << at->second << " and in " << entry.path().string());
                CHECK(is_new);
            }
        }
    CHECK(header_of.size() > 100);
}
