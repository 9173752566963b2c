// The table of options in docs/interface.md gives each command what its --help lists.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

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

/// Returns the --help of each command by its name.
std::map<std::string, std::string> helps() {
    std::map<std::string, std::string> found;
    for (const std::string& name : words_of(run_glint({"--help"}).out, R"(\n  glint ([a-z]+))"))
        found[name] = run_glint({name, "--help"}).out;
    return found;
}

/// Returns what a --help lists, as errors name it: "-o", "--size".
Words options_of(const std::string& help) {
    Words options = words_of(help.substr(help.find("Options:")), R"(\n  (?:-\w,)?(--?[a-z-]+))");
    options.erase("--help");
    return options;
}

bool takes_file(const std::string& help) { return help.find("\n  FILE ") != std::string::npos; }

/// Reads a cell of the second column: "render, sheet", "all but schema", or "all that take a FILE, but sheet,
/// and compare", where each part but the first may be missing.
Words commands_in(const std::string& cell, const std::map<std::string, std::string>& help_of) {
    std::smatch part;
    const std::regex form("all( that take a FILE)?(?:,? but (.*?))?(?:, and (.*))?");
    if (!std::regex_match(cell, part, form)) return words_of(cell, R"((\w+))");
    Words commands = words_of(part[3], R"((\w+))");
    const Words left_out = words_of(part[2], R"((\w+))");
    for (const auto& [name, help] : help_of)
        if (!left_out.contains(name) && (!part[1].matched || takes_file(help))) commands.insert(name);
    return commands;
}

/// Returns the options of each command as the table has them.
std::map<std::string, Words> options_in_table(const std::map<std::string, std::string>& help_of) {
    const std::string text = bytes_of(project_file("docs/interface.md"));
    const std::size_t begin = text.find("| option | of |");
    REQUIRE(begin != std::string::npos);
    std::istringstream lines(text.substr(begin, text.find("\n\n", begin) - begin));
    std::map<std::string, Words> options;
    for (std::string line; std::getline(lines, line);) {
        std::smatch cell;
        if (!std::regex_search(line, cell, std::regex(R"(^\| (.*?) \| (.*?) \|)"))) continue;
        for (const std::string& command : commands_in(cell[2], help_of))
            options[command].merge(words_of(cell[1], "`(--?[a-z-]+)"));
    }
    return options;
}

}  // namespace

TEST_CASE("the table of options gives each command what its --help lists", "[interface_doc][cli]") {
    const auto help_of = helps();
    auto table = options_in_table(help_of);
    CHECK(help_of.size() > 15);
    for (const auto& [name, help] : help_of) {
        INFO(name);
        table[name].erase("-j");  // --threads, which the same row names
        CHECK(table[name] == options_of(help));
    }
}
