// Parses the runs of a block: commands in command-line syntax.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lessons/lesson_source.h"
#include "models/problem.h"

namespace glint {
namespace {

struct RunWord {
    std::string_view word;
    RunKind kind;
    std::vector<std::string> options;  // allowed in addition to --set and --size
};

const std::array<RunWord, 7>& kinds() {
    static const std::array<RunWord, 7> all{
        {{"explain", RunKind::Explain, {"--pixel"}},
         {"render", RunKind::Render, {}},
         {"profile", RunKind::Profile, {"--from", "--to"}},
         {"info", RunKind::Info, {}},
         {"lobe", RunKind::Lobe, {"--object", "--angle"}},
         {"microfacets", RunKind::Microfacets, {"--roughness", "--angle", "--view", "--rays", "--facets"}},
         {"compare", RunKind::Compare, {}}}};
    return all;
}

const RunWord& kind_of(const std::string& word, int line) {
    std::vector<std::string> names;
    for (const RunWord& kind : kinds()) {
        if (kind.word == word) return kind;
        names.emplace_back(kind.word);
    }
    fail_at(line, in_quotes(word) + " is not a run", in_quotes(nearest(word, names)));
}

double within(std::string_view text, int line, double least, double most) {
    const double value = read_decimal(text, line);
    if (value < least || value > most)
        fail_at(line, in_quotes(text) + " is out of range", fmt::format("{} to {}", least, most));
    return value;
}

void read_option(LessonRun& run, const std::string& option, const std::string& value) {
    const int line = run.line;
    if (option == "--set") return run.set.push_back(read_set({"", value, line}));
    if (option == "--size")
        run.size = read_lesson_size(value, line);
    else if (option == "--pixel" || option == "--from")
        run.from = read_place(value, line);
    else if (option == "--to")
        run.to = read_place(value, line);
    else if (option == "--object")
        run.object = read_whole(value, line, 0, 9999);
    else if (option == "--angle")
        run.angle_deg =
            within(value, line, 0, run.kind == RunKind::Lobe ? max_lobe_deg : max_microfacets_deg);
    else if (option == "--view")
        run.view_deg = within(value, line, 0, max_microfacets_deg);
    else if (option == "--roughness")
        run.roughness = within(value, line, 0, 1);
    else if (option == "--facets")
        run.facets = read_whole(value, line, 4, 100000);
    else
        run.rays = read_whole(value, line, 1, 100000);
}

void read_compare(LessonRun& run, const std::vector<std::string>& words,
                  const std::vector<LessonRun>& above) {
    if (words.size() != 3)
        fail_at(run.line, "compare is given " + std::to_string(words.size() - 1) + " names",
                "two runs of render above it");
    run.first = words[1];
    run.second = words[2];
    for (const std::string& name : {run.first, run.second})
        if (std::none_of(above.begin(), above.end(),
                         [&](const LessonRun& r) { return r.name == name && r.kind == RunKind::Render; }))
            fail_at(run.line, in_quotes(name) + " is not a picture", "a run of render above it");
}

LessonRun read_run(const BlockLine& line, const std::vector<LessonRun>& above) {
    const std::vector<std::string> words = words_of(line.value);
    if (words.empty()) fail_at(line.line, "nothing is run", "a command as in explain --pixel 640,360");
    const RunWord& kind = kind_of(words[0], line.line);
    LessonRun run;
    run.name = line.key;
    run.kind = kind.kind;
    run.line = line.line;
    if (kind.kind == RunKind::Compare) {
        read_compare(run, words, above);
        return run;
    }
    std::vector<std::string> known = kind.options;
    if (kind.kind != RunKind::Microfacets) known.insert(known.end(), {"--set", "--size"});
    std::vector<std::string> given;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        if (std::find(known.begin(), known.end(), words[i]) == known.end())
            fail_at(line.line, in_quotes(words[i]) + " is not an option of " + words[0],
                    in_quotes(nearest(words[i], known)));
        if (words[i] != "--set" && std::find(given.begin(), given.end(), words[i]) != given.end())
            fail_at(line.line, words[i] + " is given twice", "it once");
        if (i + 1 == words.size()) fail_at(line.line, words[i] + " has no value", "one after it");
        read_option(run, words[i], words[i + 1]);
        given.push_back(words[i]);
    }
    for (const char* const needed : {"--pixel", "--from", "--to"})
        if (std::find(kind.options.begin(), kind.options.end(), needed) != kind.options.end() &&
            std::find(given.begin(), given.end(), needed) == given.end())
            fail_at(line.line, words[0] + " has no " + needed, std::string(needed) + " X,Y");
    return run;
}

}  // namespace

std::vector<LessonRun> read_runs(const std::vector<BlockLine>& lines) {
    constexpr std::size_t max_runs = 32;
    std::vector<LessonRun> runs;
    for (const BlockLine& line : lines) {
        if (!line.is_run) continue;
        if (std::any_of(runs.begin(), runs.end(), [&](const LessonRun& r) { return r.name == line.key; }))
            fail_at(line.line, in_quotes(line.key) + " is run twice", "a name of its own");
        if (runs.size() == max_runs) fail_at(line.line, "a block runs too much", "at most 32 runs");
        runs.push_back(read_run(line, runs));
    }
    return runs;
}

}  // namespace glint
