#pragma once
// Reads the options of one command's line. CLI11 splits the line and writes --help; only options.cpp includes
// it, because every file that does takes seconds to compile. Error messages are ours (docs/command_line.md).

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glint {

/// What --help says around the list of options.
struct OptionsHelp {
    std::string name;     // of the command as it is typed: "glint render"
    std::string usage;    // what follows the name: "FILE -o OUT"
    std::string summary;  // one line
    std::string example;  // a whole line to copy
};

using ReadValue = std::function<void(const std::string& text)>;

/// Declares and parses the options of a command. What its readers and flags refer to must outlive parse().
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
    /// A positional, named without a dash, that takes all words that are left: `read` gets each in turn.
    void add_words(const std::string& name, const std::string& help, ReadValue read);
    /// An option without a value: `value` becomes true.
    void add_flag(const std::string& name, bool& value, const std::string& help);
    /// `file` will hold the file that the command works on: if memory does not suffice, the error names it.
    void works_on(const std::string& file) { file_ = &file; }
    [[nodiscard]] std::string file() const { return file_ ? *file_ : std::string(); }
    /// Adds --version, which the line of a command without a name has.
    void add_version();

    enum class Asked { Work, Help, Version };
    /// Splits the line and hands each value to the one who declared its option. Throws Failure for an option
    /// that is not known, a value that is missing or empty, a word too many, and whatever the readers throw.
    [[nodiscard]] Asked parse(std::vector<std::string> arguments);
    [[nodiscard]] std::string help_text() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    const std::string* file_ = nullptr;
};

}  // namespace glint
