// Finds the command in argv and runs it.
#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "app/commands/command.h"
#include "app/options.h"
#include "models/memory_limit.h"

namespace glint {
namespace {

using Arguments = std::vector<std::string>;

/// The index of the first word that is not an option or an option's value; it may name a command.
std::size_t first_word(const Arguments& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& a = arguments[i];
        if (a == "--") break;  // the rest are files
        if (a == "-j" || a == "--threads" || a == "--set" || a == "--memory" || a == "--lesson") {
            ++i;
        } else if (a.size() < 2 || a[0] != '-') {
            return i;
        }
    }
    return arguments.size();
}

std::string general_help() {
    std::string text =
        "Glint: light a scene, see the picture, inspect every number behind a pixel.\n\n"
        "  glint [FILE...]                 open the window\n";
    for (const Command& command : named_commands()) {
        const std::string line = command.name + " " + command.usage;
        text += fmt::format("  glint {:<26}{}{}\n", line, line.size() < 26 ? "" : "\n" + std::string(34, ' '),
                            command.summary);
    }
    text +=
        "\n  --lesson NAME                   open a lesson in the window: its name, number or file\n"
        "  --set POINTER=JSON              change the scene; may be repeated\n"
        "  -j, --threads N                 threads to use; default 0: all cores\n"
        "  --memory SIZE                   memory that the scene may need, such as 8G\n"
        "  --version                       print the version\n"
        "\nFILE is a scene (.json, .glb, .gltf), a picture by Glint with its scene (.png), a mesh (.obj, "
        ".ply, .off,\n"
        ".stl), or - for a scene on standard input. `glint COMMAND --help` describes a command.\n"
        "\nExit status: 0 success; 1 the input, a file or the machine made it impossible, or a check failed; "
        "2 wrong\nusage. Environment: GLINT_MEMORY is the default of --memory, GLINT_ISA selects an "
        "instruction set.\n";
    return text;
}

/// Rejects a word that is not a file and resembles a command.
void refuse_unknown_command(const std::string& word) {
    if (word.empty())
        throw wrong_usage("FILE", "is empty", "a scene, a mesh, or - for a scene on standard input");
    if (word == "-" || word.find_first_of("./") != std::string::npos) return;
    std::error_code ignored;
    if (std::filesystem::exists(word, ignored)) return;
    std::vector<std::string> names;
    for (const Command& command : named_commands()) names.push_back(command.name);
    throw wrong_usage(word, "neither a command nor a file",
                      nearest(word, names) + " or another that glint --help lists");
}

Outcome run(const Command& command, const Arguments& arguments) {
    const bool is_window = command.name.empty();
    Options options(
        {is_window ? "glint" : "glint " + command.name, command.usage, command.summary, command.example});
    if (is_window) options.add_version();
    const Run work = command.declare(options);
    switch (options.parse(arguments)) {
    case Options::Asked::Help:
        return {is_window ? general_help() : options.help_text(), {}, ExitStatus::Done};
    case Options::Asked::Version:
        return {"glint " GLINT_VERSION "\n", {}, ExitStatus::Done};
    case Options::Asked::Work:
        break;
    }
    try {
        return work();
    } catch (const LimitExceeded& exceeded) {
        throw Failure{ExitStatus::Impossible, problem_from(exceeded, options.file())};
    }
}

}  // namespace

std::vector<Command> named_commands() {
    return {render_command(),   explain_command(),     profile_command(),    sheet_command(),
            lobe_command(),     microfacets_command(), formfactor_command(), info_command(),
            mistakes_command(), schema_command(),      code_command(),       shade_command(),
            export_command(),   compare_command(),     diagnose_command(),   grade_command(),
            check_command(),    bench_command(),       lessons_command(),    exercise_command(),
            quiz_command()};
}

Outcome run_command_line(const Arguments& arguments) {
    const std::size_t at = first_word(arguments);
    // The word after an unknown option may be that option's value or a separate argument; both are equally
    // likely. So the unknown option is reported, not the word.
    const bool may_be_value =
        at > 0 && arguments[at - 1].starts_with('-') && arguments[at - 1].find('=') == std::string::npos;
    if (at < arguments.size()) {
        for (const Command& command : named_commands()) {
            if (command.name != arguments[at]) continue;
            Arguments rest = arguments;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
            return run(command, rest);
        }
        if (!may_be_value) refuse_unknown_command(arguments[at]);
    }
    return run(window_command(), arguments);
}

}  // namespace glint
