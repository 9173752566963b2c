// Tests that docs/lecture_map.md is up to date: every row's scene opens, command runs and tests exist.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;

namespace fs = std::filesystem;

namespace {

const fs::path source_dir = project_folder;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct MapRow {
    int number = 0;
    std::string idea, scene, command, tests, sources, lessons;
};

std::vector<MapRow> rows() {
    std::vector<MapRow> found;
    std::istringstream lines(text_of(source_dir / "docs" / "lecture_map.md"));
    const std::regex form(
        R"(\| (\d+) \| (.+) \| (\S+) \| `(.+)` \| (.+) \| (`\S+`: \w+(?:; `\S+`: \w+)*) \| (.+) \|)");
    std::string line;
    while (std::getline(lines, line)) {
        std::smatch cell;
        if (std::regex_match(line, cell, form))
            found.push_back({std::stoi(cell[1]), cell[2], cell[3], cell[4], cell[5], cell[6], cell[7]});
    }
    return found;
}

std::vector<std::string> in_backticks(const std::string& text) {
    std::vector<std::string> names;
    const std::regex quoted("`([^`]+)`");
    for (std::sregex_iterator i(text.begin(), text.end(), quoted), end; i != end; ++i)
        names.push_back((*i)[1]);
    return names;
}

/// The names of all test cases in tests/**.cpp; a name may span several literals.
std::set<std::string> test_names() {
    std::set<std::string> names;
    const std::regex begin(R"re(TEST_CASE(?:_SIG)?\(\s*((?:"[^"]*"\s*)+))re"), part("\"([^\"]*)\"");
    for (const auto& entry : fs::recursive_directory_iterator(source_dir / "tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = text_of(entry.path());
        for (std::sregex_iterator i(text.begin(), text.end(), begin), end; i != end; ++i) {
            const std::string literals = (*i)[1];
            std::string name;
            for (std::sregex_iterator p(literals.begin(), literals.end(), part); p != end; ++p)
                name += (*p)[1];
            names.insert(name);
        }
    }
    return names;
}

/// The arguments of a row's command, with the scene's actual path, and with `out` as the output path.
std::vector<std::string> words_of(const MapRow& row, const std::string& out) {
    std::istringstream stream(row.command);
    std::string program;
    stream >> program;
    REQUIRE(program == "glint");
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word == row.scene ? (source_dir / row.scene).string() : word);
    const auto output = std::find(words.begin(), words.end(), "-o");
    if (output != words.end() && output + 1 != words.end())
        output[1] = words[0] == "code" ? out + "-program" : out;  // a directory
    if (words[0] == "render") words.insert(words.end(), {"--size", "160x90"});
    return words;
}

}  // namespace

TEST_CASE("the lecture map lists every idea once, with an existing scene and existing tests", "[docs]") {
    const std::vector<MapRow> map = rows();
    REQUIRE(map.size() == 52);
    const std::set<std::string> tests = test_names();
    REQUIRE(tests.size() > 200);
    for (std::size_t i = 0; i < map.size(); ++i) {
        CAPTURE(map[i].number);
        CHECK(map[i].number == static_cast<int>(i) + 1);
        CHECK(fs::is_regular_file(source_dir / map[i].scene));
        const std::vector<std::string> named = in_backticks(map[i].tests);
        CHECK((!named.empty() || map[i].tests.find("to come") != std::string::npos));
        for (const std::string& name : named) {
            CAPTURE(name);
            CHECK(tests.count(name) == 1);
        }
    }
}

TEST_CASE("every command in the lecture map runs", "[docs][program][long][release]") {
    const TemporaryDirectory directory;
    for (const MapRow& row : rows()) {
        CAPTURE(row.number, row.command);
        const Ended ended = run_glint(words_of(row, directory.path("out.png")));
        CHECK(ended.status == 0);
        CHECK(ended.err.empty());
    }
}

TEST_CASE("docs/explain.md names every field of an explanation", "[docs][program]") {
    const std::vector<std::string> words = in_backticks(text_of(source_dir / "docs" / "explain.md"));
    const std::set<std::string> documented(words.begin(), words.end());
    const TemporaryDirectory directory;
    const std::string scene =
        directory.file("scene.json", R"({"glint": 1, "objects": [{"name": "Ball"}], "lights": [
        {"type": "directional", "position": [1, 1, 1]}, {"type": "spot"}, {"type": "area", "area": {"samples": 4}}]})");
    std::set<std::string> given;
    const std::regex key(R"re("([^"]+)":)re");
    for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
             {"--pixel", "0,0"},
             {"--pixel", "640,360", "--sensitivity"},
             {"--pixel", "640,360", "--set", "/shading/mode=gouraud"},
             {"--pixel", "640,360", "--set", "/shading/mode=flat"},
             {"--pixel", "640,360", "--set", "/shading/reflection=none"},
             {"--pixel", "640,360", "--set", R"(/npr={"cool_to_warm": true})"},
             {"--pixel", "640,0", "--size", "1280x9", "--set",
              R"(/npr={"silhouettes": true, "stroke_width_px": 20})"}}) {
        std::vector<std::string> arguments{"explain", scene, "--format", "json"};
        arguments.insert(arguments.end(), how.begin(), how.end());
        const Ended ended = run_glint(arguments);
        REQUIRE(ended.status == 0);
        for (std::sregex_iterator i(ended.out.begin(), ended.out.end(), key), end; i != end; ++i)
            given.insert((*i)[1]);
    }
    for (const char* rare : {"samples", "corners", "cool_to_warm", "stroke", "one_sided"})
        CHECK(given.count(rare) == 1);
    for (const std::string& field : given) {
        CAPTURE(field);
        CHECK(documented.count(field) == 1);
    }
}

TEST_CASE("the documents show all pictures in docs and no missing ones", "[docs]") {
    std::set<std::string> shown, made;
    const std::regex link(R"(\]\((?:docs/)?pictures/([^)]+)\))");
    for (const char* document : {"docs/gallery.md", "docs/performance.md", "docs/diagnose.md", "README.md"}) {
        const std::string text = text_of(source_dir / document);
        for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i)
            shown.insert((*i)[1]);
    }
    const fs::path pictures = source_dir / "docs" / "pictures";
    for (const auto& entry : fs::recursive_directory_iterator(pictures))
        if (entry.is_regular_file()) made.insert(entry.path().lexically_relative(pictures).generic_string());
    CHECK(shown == made);
    CHECK(made.size() > 20);
}

TEST_CASE("every file and folder that a document names exists", "[docs]") {
    std::vector<fs::path> documents{"README.md", "SECURITY.md", "renderer/README.md"};
    for (const auto& entry : fs::directory_iterator(source_dir / "docs"))
        if (entry.path().extension() == ".md")
            documents.push_back(fs::path("docs") / entry.path().filename());
    const std::regex link(R"(\]\(([^)#:]+)\))");
    // Skips paths with a word in upper case, such as `assets/scenes/NAME.json`, or with an asterisk.
    const std::regex path(
        R"((?:^| |\./)((?:app|ui|diagnose|lessons|programs|renderer|models|tests|cmake|assets|docs)/[a-z0-9_./-]+)(?![\w*]))");
    int named = 0;
    const auto check = [&named](const fs::path& folder, const std::string& text, const std::regex& name) {
        for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i, ++named) {
            CAPTURE(text);
            CHECK(fs::exists(folder / (*i)[1].str()));
        }
    };
    for (const fs::path& document : documents) {
        CAPTURE(document);
        std::istringstream lines(text_of(source_dir / document));
        for (std::string line; std::getline(lines, line);) {
            check(source_dir / document.parent_path(), line, link);
            for (const std::string& quoted : in_backticks(line)) check(source_dir, quoted, path);
        }
    }
    CHECK(named > 300);
}

namespace {

/// The names of the lessons that list this number as one of their rows or as a question that they answer.
std::vector<std::string> lessons_with(int number, std::vector<int> Lesson::*numbers) {
    std::vector<std::string> names;
    const auto files = lesson_files({(source_dir / "assets" / "lessons").string()});
    for (const std::string& file : std::get<std::vector<std::string>>(files)) {
        const auto lesson = std::get<Lesson>(read_lesson(file));
        const std::vector<int>& list = lesson.*numbers;
        if (std::find(list.begin(), list.end(), number) != list.end()) names.push_back(lesson.name);
    }
    return names;
}

}  // namespace

TEST_CASE("the lessons named in the lecture map cover its ideas", "[docs][lesson]") {
    REQUIRE(rows().size() == 52);
    for (const MapRow& row : rows()) {
        CAPTURE(row.number);
        CHECK(!in_backticks(row.lessons).empty());
        CHECK(in_backticks(row.lessons) == lessons_with(row.number, &Lesson::rows));
    }
}

TEST_CASE("the lessons named in the map answer the lecture's eleven questions", "[docs][lesson]") {
    std::istringstream lines(text_of(source_dir / "docs" / "lecture_map.md"));
    const std::regex form(R"(\| (\d+) \| ([^|]+\?) \| (`[^|]+`) \|)");
    int questions = 0;
    for (std::string line; std::getline(lines, line);) {
        std::smatch cell;
        if (!std::regex_match(line, cell, form)) continue;
        CAPTURE(line);
        CHECK(std::stoi(cell[1]) == ++questions);
        CHECK(in_backticks(cell[3]) == lessons_with(questions, &Lesson::questions));
    }
    CHECK(questions == 11);
}

// Tests that docs/command_line.md lists the options of each command's --help.
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
