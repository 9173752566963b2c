#pragma once
// Parses the options of one command. CLI11 splits the line and writes --help; only options.cpp includes it,
// because every file that does takes seconds to compile. Error messages are our own (docs/command_line.md).

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// The text of --help around the list of options.
struct OptionsHelp {
    std::string name;     // the command as typed: "glint render"
    std::string usage;    // follows the name: "FILE -o OUT"
    std::string summary;  // one line
    std::string example;  // a complete line to copy
};

using ReadValue = std::function<void(const std::string& text)>;

/// Declares and parses the options of a command. Objects referenced by readers and flags must outlive
/// parse().
class Options {
  public:
    explicit Options(const OptionsHelp& help);
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    /// Adds an option that takes one value, at most once; names without a dash make it a positional. `names`
    /// are separated by commas, and errors use the last: "-j,--threads".
    void add_value(const std::string& names, const std::string& value_name, const std::string& help,
                   ReadValue read);
    /// Adds an option that may be repeated: `read` gets each value in turn.
    void add_values(const std::string& names, const std::string& value_name, const std::string& help,
                    ReadValue read);
    /// Adds a positional, named without a dash, for all remaining words: `read` gets each in turn.
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
    /// missing or empty value, and an extra word; readers may throw others.
    [[nodiscard]] Asked parse(std::vector<std::string> arguments);
    [[nodiscard]] std::string help_text() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    const std::string* file_ = nullptr;
};

}  // namespace glint
