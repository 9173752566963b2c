#include "app/options.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <new>
#include <sstream>
#include <utility>

#include "app/arguments.h"
#include "app/commands/command.h"
#include "models/memory_limit.h"

namespace glint {
namespace {

/// CLI11's help, with our own usage line.
class HelpFormatter : public CLI::Formatter {
  public:
    explicit HelpFormatter(std::string usage) : usage_(std::move(usage)) { column_width(24); }
    std::string make_usage(const CLI::App* /*app*/, std::string name) const override {
        return "\nUsage: " + name + (usage_.empty() ? "" : " " + usage_) + " [OPTIONS]\n";
    }

  private:
    std::string usage_;
};

/// The long and short names of all of a command's options.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// Put before a bracketed word, because CLI11 would read "[a,b]" as a list of two values.
constexpr char one_word = '\1';
std::string as_typed(const std::string& word) { return word.starts_with(one_word) ? word.substr(1) : word; }

/// Reports a word that CLI11 could not parse: an unknown option, or an extra word.
void refuse_extras(const CLI::App& app, const std::string& command) {
    bool only_words = false;  // words after "--" are never options
    for (const std::string& extra : app.remaining()) {
        if (extra == "--") {
            only_words = true;
            continue;
        }
        if (!only_words && extra.size() > 1 && extra[0] == '-') {
            const std::string name = extra.substr(0, extra.find('='));
            throw wrong_usage(name, "unknown option of " + command,
                              fmt::format("{} or another one listed by {} --help",
                                          nearest(name, option_names(app)), command));
        }
        throw wrong_usage(as_typed(extra), "unexpected argument for " + command,
                          "the arguments shown by " + command + " --help");
    }
}

/// Throws if a value is empty, for example because a shell variable is not set.
void require_text(const std::string& option, const std::string& text, const std::string& expected) {
    if (text.empty()) throw wrong_usage(option, "is empty", expected);
}

/// Throws if the value of a short option begins with "=": CLI11 reads -o=a.png as the file "=a.png", which
/// is hardly ever intended.
void require_no_equals(const std::string& option, const std::string& value_name, const std::string& text) {
    if (text.starts_with('='))
        throw wrong_usage(option, text + " begins with \"=\"",
                          fmt::format("a value after a space, as in {} {}", option, value_name));
}

/// CLI11's exceptions name the option somewhere in their text: "--size: 1 required WxH missing".
Failure of_parse_error(const CLI::ParseError& error) {
    std::istringstream words(error.what());
    std::string option;
    while (words >> option && option[0] != '-') {
    }
    option = option.substr(0, option.find(':'));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return wrong_usage(option, "has no value", "a value after it");
    }
    return wrong_usage(option, "does not take this value", "a value as shown by --help");
}

}  // namespace

struct Options::Parts {
    explicit Parts(const OptionsHelp& help) : name(help.name), app(help.summary, help.name) {}

    CLI::Option* add(const std::string& names, const std::string& value_name, const std::string& help,
                     const CLI::callback_t& on_given) {
        // Keeps every value; otherwise CLI11 would report a second one with its own message.
        return app.add_option(names, on_given, help)
            ->type_name(value_name)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }

    std::string name;
    CLI::App app;
};

Options::Options(const OptionsHelp& help) : parts_(std::make_unique<Parts>(help)) {
    CLI::App& app = parts_->app;
    app.allow_extras();
    app.set_help_flag("-h,--help", "print this help");
    app.formatter(std::make_shared<HelpFormatter>(help.usage));
    app.footer("Example: " + help.example);
}
Options::~Options() = default;

void Options::add_version() { parts_->app.set_version_flag("--version", "glint"); }

Options::Asked Options::parse(std::vector<std::string> arguments) {
    for (std::string& word : arguments)
        if (word.starts_with('[') && word.ends_with(']')) word.insert(0, 1, one_word);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
    try {
        parts_->app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        return Asked::Help;
    } catch (const CLI::CallForVersion&) {
        return Asked::Version;
    } catch (const CLI::ParseError& error) {
        throw of_parse_error(error);
    }
    refuse_extras(parts_->app, parts_->name);
    return Asked::Work;
}

std::string Options::help_text() const { return parts_->app.help(); }

void Options::add_value(const std::string& names, const std::string& value_name, const std::string& help,
                        ReadValue read) {
    const std::string option = names.substr(names.rfind(',') + 1);
    const std::string expected = value_name.empty() ? help : value_name;
    const bool is_short = option.starts_with('-') && !option.starts_with("--");
    const auto read_one = [option, expected, value_name, is_short,
                           read = std::move(read)](const CLI::results_t& given) {
        if (given.size() > 1) throw wrong_usage(option, "is given twice", "it only once");
        require_text(option, given.front(), expected);
        if (is_short) require_no_equals(option, value_name, given.front());
        read(as_typed(given.front()));
        return true;
    };
    parts_->add(names, value_name, help, read_one);
}

void Options::add_values(const std::string& names, const std::string& value_name, const std::string& help,
                         ReadValue read) {
    parts_->add(names, value_name, help, [read = std::move(read)](const CLI::results_t& given) {
        for (const std::string& text : given) read(as_typed(text));
        return true;
    });
}

void Options::add_words(const std::string& name, const std::string& help, ReadValue read) {
    const auto read_all = [name, help, read = std::move(read)](const CLI::results_t& given) {
        for (const std::string& text : given) {
            require_text(name, text, help);
            read(as_typed(text));
        }
        return true;
    };
    parts_->add(name, "", help, read_all)->expected(-1);
}

void Options::add_flag(const std::string& name, bool& value, const std::string& help) {
    parts_->app.add_flag(name, value, help);
}

// Finds the command in argv and runs it.

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
        "  --memory SIZE                   memory limit for the scene, such as 8G\n"
        "  --version                       print the version\n"
        "\nFILE is a scene (.json, .glb, .gltf), a PNG from Glint that contains its scene, a mesh (.obj, "
        ".ply, .off,\n"
        ".stl), or - for a scene on standard input. `glint COMMAND --help` describes a command.\n"
        "\nExit status: 0 success; 1 failure due to the input, a file or the machine, or a failed check; "
        "2 wrong\nusage. Environment: GLINT_MEMORY sets the default for --memory, GLINT_ISA selects an "
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
                      nearest(word, names) + " or another one listed by glint --help");
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
