#pragma once
// Runs the real program as a user's shell would.

#include <string>
#include <vector>

namespace glint {

struct Ended {
    int status = -1;  // the exit status, or 128 plus the signal that terminated the program
    std::string out, err;
};

/// Runs the program with these arguments, without a display and with `input` on standard input. `redirect` is
/// shell text after the command, such as ">/dev/full" or "| head -c 1"; standard output is captured unless
/// redirected. `runner`: a command that runs the program, such as `timeout 1`.
[[nodiscard]] Ended run_glint(const std::vector<std::string>& arguments, const std::string& input = {},
                              const std::string& redirect = {}, std::vector<std::string> runner = {});

/// A directory that is removed at the end of the test.
class TemporaryDirectory {
  public:
    TemporaryDirectory();
    ~TemporaryDirectory();
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    /// The path of a file in the directory; the second form writes `bytes` to the file.
    [[nodiscard]] std::string path(const std::string& name) const { return path_ + "/" + name; }
    [[nodiscard]] std::string file(const std::string& name, const std::string& bytes) const;
    /// The names of the directory's entries, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::string path_;
};

/// All bytes of a file; empty if there is none.
[[nodiscard]] std::string bytes_of(const std::string& path);

}  // namespace glint
