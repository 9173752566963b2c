#include "app/options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>

#include "app/failure.h"

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

/// All long and short option names of a command's line.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// Prefixes a word in brackets for CLI11, which takes "[a,b]" for a list of two.
constexpr char one_word = '\1';
std::string as_typed(const std::string& word) { return word.starts_with(one_word) ? word.substr(1) : word; }

/// The words that CLI11 could not parse: an unknown option, or an extra word.
void refuse_extras(const CLI::App& app, const std::string& command) {
    bool only_words = false;  // after a "--" nothing is an option
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
        throw wrong_usage(as_typed(extra), "one word too many for " + command,
                          "what " + command + " --help shows");
    }
}

/// Throws if a value is empty, such as an unset shell variable.
void require_text(const std::string& option, const std::string& text, const std::string& expected) {
    if (text.empty()) throw wrong_usage(option, "is empty", expected);
}

/// Throws if the value of a short option begins with "=": CLI11 takes -o=a.png for the file "=a.png", which
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
        return wrong_usage(option, "has no value", "one after it");
    }
    return wrong_usage(option, "does not take this value", "what --help shows");
}

}  // namespace

struct Options::Parts {
    explicit Parts(const OptionsHelp& help) : name(help.name), app(help.summary, help.name) {}

    CLI::Option* add(const std::string& names, const std::string& value_name, const std::string& help,
                     const CLI::callback_t& on_given) {
        // Keep every value, because CLI11 has its own message for a second one.
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
        if (given.size() > 1) throw wrong_usage(option, "is given twice", "it once");
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

}  // namespace glint
