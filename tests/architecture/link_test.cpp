// Checks the linked program: it does not need libGL, and the lighting kernels of two instruction sets share
// no code that the linker could merge (an older CPU would then execute instructions that it does not have).
#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places.h"
#include "tests/support/catch.h"

namespace fs = std::filesystem;

namespace {

/// The output lines of a shell command; the test fails if it cannot be run.
std::vector<std::string> lines_of(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> block{};
    for (std::size_t n = 0; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
        text.append(block.data(), n);
    INFO(command);
    REQUIRE(pclose(pipe) == 0);
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Symbols of an object file that the linker may replace with those of any other object.
std::set<std::string> weak_names(const fs::path& object) {
    std::set<std::string> names;
    for (const auto& line : lines_of("nm --defined-only '" + object.string() + "'")) {
        std::istringstream words(line);
        std::string address, kind, name;
        words >> address >> kind >> name;
        // DW.ref.* only point at the runtime's own handler; they contain no code.
        if ((kind == "W" || kind == "V" || kind == "u") && !name.starts_with("DW.ref.")) names.insert(name);
    }
    return names;
}

/// One line per weak symbol that objects of two instruction sets define.
std::vector<std::string> shared_names(const std::map<std::string, std::set<std::string>>& of_set) {
    std::map<std::string, std::string> owner;
    std::vector<std::string> shared;
    for (const auto& [set, names] : of_set) {
        for (const auto& name : names) {
            const auto [at, is_new] = owner.emplace(name, set);
            if (is_new) continue;
            std::ostringstream line;
            line << name << " is in " << at->second << " and " << set;
            shared.push_back(line.str());
        }
    }
    return shared;
}

}  // namespace

TEST_CASE("the program does not link libGL, not even through another library", "[architecture]") {
    const auto libraries = lines_of(std::string("ldd '") + glint::glint_program + "'");
    CHECK(libraries.size() > 3);
    for (const auto& line : libraries) {
        INFO(line);
        for (const char* gl : {"libGL", "libOpenGL", "libEGL", "libOSMesa"})
            CHECK(line.find(gl) == std::string::npos);
    }
}

TEST_CASE("no weak symbol is defined by the lighting kernels of two instruction sets", "[architecture]") {
    std::map<std::string, std::set<std::string>> of_set;
    for (const auto& entry : fs::recursive_directory_iterator(GLINT_BINARY_DIR)) {
        if (entry.path().extension() != ".o") continue;
        for (const auto& folder : entry.path()) {  // .../kernels_avx2.dir/....o
            if (folder.string().starts_with("kernels_"))
                of_set[folder.string()].merge(weak_names(entry.path()));
        }
    }
    for (const auto& line : shared_names(of_set)) FAIL_CHECK(line);
}
