#include "app/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <utility>

namespace glint {
namespace {

using Arguments = std::vector<std::string>;

/// Where the first word stands that is no option and no option's value, so may name a command.
std::size_t first_word(const Arguments& arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& a = arguments[i];
        if (a == "--") break;  // from here on all are files
        if (a == "-j" || a == "--threads" || a == "--set" || a == "--memory") {
            ++i;
        } else if (a.size() < 2 || a[0] != '-') {
            return i;
        }
    }
    return arguments.size();
}

std::string general_help() {
    std::string text =
        "Glint: light a scene, see the picture, ask for every number behind a pixel.\n\n"
        "  glint [FILE]                    opens the window\n";
    for (const Command& command : named_commands()) {
        const std::string line = command.name + " " + command.usage;
        text += fmt::format("  glint {:<26}{}{}\n", line, line.size() < 26 ? "" : "\n" + std::string(34, ' '),
                            command.summary);
    }
    text +=
        "\n  --set POINTER=JSON              changes the scene; may be repeated\n"
        "  -j, --threads N                 threads to draw with; 0, the default, is all cores\n"
        "  --memory SIZE                   how much memory a scene may need, as in 8G\n"
        "  --version                       prints the version\n"
        "\nFILE is a scene (.json, or a .png that Glint wrote), a mesh (.obj .ply .off .stl .om), or - for a "
        "scene on\n"
        "standard input. `glint COMMAND --help` says more of a command.\n";
    return text;
}

/// All long and short option names of a command's line.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// What CLI11 could not place: an option that it does not know, or one word too many.
void refuse_extras(const CLI::App& app, const std::string& command) {
    bool only_words = false;  // behind a "--" nothing is an option
    for (const std::string& extra : app.remaining()) {
        if (extra == "--") {
            only_words = true;
            continue;
        }
        if (!only_words && extra.size() > 1 && extra[0] == '-') {
            const std::string name = extra.substr(0, extra.find('='));
            throw wrong_usage(
                name, "unknown option of " + command,
                fmt::format("{} or another that {} --help lists", nearest(name, option_names(app)), command));
        }
        throw wrong_usage(extra, "one word too many for " + command, "what " + command + " --help shows");
    }
}

/// A file that could not be opened anyway and reads like a command is a command mistyped.
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

/// CLI11's exceptions name the option somewhere in their words: "--size: 1 required WxH missing".
Failure of_parse_error(const CLI::ParseError& error) {
    std::istringstream words(error.what());
    std::string option;
    while (words >> option && option[0] != '-') {
    }
    option = option.substr(0, option.find(':'));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return wrong_usage(option, "has no value", "one after it");
    }
    return wrong_usage(option, "takes no such value", "what --help shows");
}

/// CLI11's help, with the usage line that we would write by hand.
class HelpFormatter : public CLI::Formatter {
  public:
    explicit HelpFormatter(std::string usage) : usage_(std::move(usage)) { column_width(24); }
    std::string make_usage(const CLI::App* /*app*/, std::string name) const override {
        return "\nUsage: " + name + (usage_.empty() ? "" : " " + usage_) + " [OPTIONS]\n";
    }

  private:
    std::string usage_;
};

Outcome run(const Command& command, Arguments arguments) {
    const std::string name = command.name.empty() ? "glint" : "glint " + command.name;
    CLI::App app(command.summary, name);
    app.allow_extras();
    app.set_help_flag("-h,--help", "prints this");
    if (command.name.empty()) app.set_version_flag("--version", "glint " GLINT_VERSION "\n");
    app.formatter(std::make_shared<HelpFormatter>(command.usage));
    app.footer("Example: " + command.example);
    const Run work = command.declare(app);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        return {command.name.empty() ? general_help() : app.help(), {}, ExitStatus::Done};
    } catch (const CLI::CallForVersion& version) {
        return {version.what(), {}, ExitStatus::Done};
    } catch (const CLI::ParseError& error) {
        throw of_parse_error(error);
    }
    refuse_extras(app, name);
    return work();
}

}  // namespace

std::vector<Command> named_commands() {
    return {render_command(),      explain_command(), profile_command(), sheet_command(),   lobe_command(),
            microfacets_command(), info_command(),    schema_command(),  compare_command(), bench_command()};
}

Outcome run_command_line(const Arguments& arguments) {
    const std::size_t at = first_word(arguments);
    if (at < arguments.size()) {
        for (const Command& command : named_commands()) {
            if (command.name != arguments[at]) continue;
            Arguments rest = arguments;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at));
            return run(command, rest);
        }
        refuse_unknown_command(arguments[at]);
    }
    return run(window_command(), arguments);
}

}  // namespace glint
