// Tests that docs/command_line.md lists the options of each command's --help.
#include <regex>
#include <set>

#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace {

using Words = std::set<std::string>;

/// Returns the first group of every match.
Words words_of(const std::string& text, const std::string& pattern) {
    const std::regex form(pattern);
    Words words;
    for (std::sregex_iterator i(text.begin(), text.end(), form), end; i != end; ++i) words.insert((*i)[1]);
    return words;
}

/// Returns the options in a --help text, by their long names if they have one: "-o", "--size".
Words options_of(const std::string& help) {
    Words options = words_of(help.substr(help.find("Options:")), R"(\n  (?:-\w,)?(--?[a-z-]+))");
    options.erase("--help");
    return options;
}

/// Returns the document's section about this command; empty if there is none.
std::string section_of(const std::string& document, const std::string& command) {
    const std::size_t begin = document.find("\n### " + command + "\n");
    if (begin == std::string::npos) return "";
    return document.substr(begin, document.find("\n### ", begin + 1) - begin);
}

/// Returns the options in the first column of a section's tables and in its line of common options.
Words options_in(const std::string& section) {
    Words options;
    for (const std::string& row : words_of(section, R"(\n\| (`-[^|]*) \|)"))
        options.merge(words_of(row, "`(--?[a-z-]+)"));
    for (const std::string& line : words_of(section, R"(\nCommon options: ([^\n]*)\n)"))
        options.merge(words_of(line, "`(--[a-z-]+)`"));
    return options;
}

}  // namespace

TEST_CASE("the documentation lists the same options for each command as its --help", "[docs][cli]") {
    const std::string document = bytes_of(project_file("docs/command_line.md"));
    const Words commands = words_of(run_glint({"--help"}).out, R"(\n  glint ([a-z]+))");
    CHECK(commands.size() > 15);
    for (const std::string& command : commands) {
        INFO(command);
        CHECK(options_in(section_of(document, command)) == options_of(run_glint({command, "--help"}).out));
    }
}
