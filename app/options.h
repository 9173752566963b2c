#pragma once
// Parses the options of one command. CLI11 splits the line and writes --help; only options.cpp includes it,
// because each file that includes it takes seconds to compile. Error messages are our own
// (docs/command_line.md).

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/renderer.h"

namespace glint {

/// The text of --help around the list of options.
struct OptionsHelp {
    std::string name;     // the command as typed: "glint render"
    std::string usage;    // follows the name: "FILE -o OUT"
    std::string summary;  // one line
    std::string example;  // a complete line to copy
};

using ReadValue = std::function<void(const std::string& text)>;

/// Declares and parses the options of a command. Objects that readers and flags refer to must outlive
/// parse().
class Options {
  public:
    explicit Options(const OptionsHelp& help);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// Adds an option that takes one value, at most once; names without a dash make it a positional argument.
    /// `names` are separated by commas, and errors use the last: "-j,--threads".
    void add_value(const std::string& names, const std::string& value_name, const std::string& help,
                   ReadValue read);
    /// Adds an option that may be repeated: `read` gets each value in turn.
    void add_values(const std::string& names, const std::string& value_name, const std::string& help,
                    ReadValue read);
    /// Adds a positional argument, named without a dash, for all remaining words: `read` gets each in turn.
    void add_words(const std::string& name, const std::string& help, ReadValue read);
    /// Adds an option without a value, which sets `value` to true.
    void add_flag(const std::string& name, bool& value, const std::string& help);
    /// `file` will contain the command's input file, which is named in the error if memory runs out.
    void works_on(const std::string& file) { file_ = &file; }
    [[nodiscard]] std::string file() const { return file_ ? *file_ : std::string(); }
    /// Adds --version, for `glint` without a command.
    void add_version();

    enum class Asked { Work, Help, Version };
    /// Splits the line and passes each value to its option's reader. Throws Failure for an unknown option, a
    /// missing or empty value, and an extra word; readers may throw Failure for other reasons.
    [[nodiscard]] Asked parse(std::vector<std::string> arguments);
    [[nodiscard]] std::string help_text() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    const std::string* file_ = nullptr;
};

// Shows the progress of long work once a second, and only on a terminal.

/// One line on standard error that is overwritten, "frame 12 of 400", and erased at the end.
class Progress {
  public:
    /// Counts from 1 to `all`; `what` is the name of the things counted.
    Progress(std::string what, std::size_t all)
        : what_(std::move(what)), all_(all), watched_(isatty(STDERR_FILENO) == 1) {}
    ~Progress() {
        if (shown_) fmt::print(stderr, "\r\x1b[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Reports that item number `count` is being processed; `part` describes the progress within that item.
    void at(std::size_t count, const std::string& part = {}) {
        const auto now = Clock::now();
        count_ = count;
        if (!watched_ || now - last_ < std::chrono::seconds(1)) return;
        fmt::print(stderr, "\r\x1b[K{} {} of {}{}", what_, count, all_, part);
        last_ = now;
        shown_ = true;
    }
    /// Until this object is destroyed, shows the number of paths traced per point while the renderer draws.
    void show_paths(Renderer& renderer) {
        renderer.on_paths(
            [this](int done, int all) { at(count_, fmt::format(", path {} of {}", done, all)); });
    }

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::size_t all_, count_ = 1;
    bool watched_, shown_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace glint
