#include "tests/faults/failing_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "tests/places.h"

namespace glint::faults {
namespace {

const std::string old_bytes = "the old file";

std::string folder_of(const Command& command) {
    return std::filesystem::path(command.out).parent_path().string();
}

void put_old_file(const Command& command) {
    if (command.out.empty()) return;
    const std::filesystem::path out(command.out);
    std::filesystem::create_directories(out.parent_path());
    for (const auto& entry : std::filesystem::directory_iterator(out.parent_path())) remove_all(entry.path());
    const int file = ::open(command.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    (void)!::write(file, old_bytes.data(), old_bytes.size());
    ::close(file);
}

void send_to(int descriptor, const std::string& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, descriptor);
    ::close(file);
}

/// Replaces the child process with the program. Adds variables to the environment.
[[noreturn]] void become(const Command& command, const TemporaryDirectory& notes,
                         const std::vector<std::pair<std::string, std::string>>& told) {
    if (*GLINT_FAILING_CALLS != 0) ::setenv("LD_PRELOAD", GLINT_FAILING_CALLS, 1);
    for (const auto& [name, value] : told) ::setenv(name.c_str(), value.c_str(), 1);
    for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY"}) ::unsetenv(name);
    send_to(STDOUT_FILENO, notes.path("out"));
    send_to(STDERR_FILENO, notes.path("err"));
    std::vector<char*> arguments{const_cast<char*>("glint")};  // NOLINT: as exec takes them
    for (const std::string& argument : command.arguments)
        arguments.push_back(const_cast<char*>(argument.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    ::execv(glint_program, arguments.data());
    ::_exit(127);
}

/// The output without the line that reports the time.
std::string without_times(std::string out) {
    const std::size_t at = out.find("\"load_ms\"");
    return at == std::string::npos ? out : out.erase(at, out.find('\n', at) - at);
}

/// The exit status from wait(), and the output.
Ended ended(int status, const TemporaryDirectory& notes) {
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            without_times(bytes_of(notes.path("out"))), bytes_of(notes.path("err"))};
}

Ended run(const Command& command, const std::string& fault, const TemporaryDirectory& notes) {
    put_old_file(command);
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(longest_run_s);
        become(command, notes, {{"GLINT_FAULT", fault}, {"GLINT_FAULT_LOG", notes.path("calls")}});
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return ended(status, notes);
}

std::string text_of(const Fault& fault) {
    const auto kind = static_cast<std::size_t>(fault.kind);
    return fmt::format("{} {} {} {}", kind_names[kind], fault.first, fault.count, fault.error);
}

/// The problem with the folder of the output file, which must contain no other file; empty if there is none.
std::string wrong_folder(const Command& command) {
    if (command.out.empty()) return {};
    for (const auto& entry : std::filesystem::directory_iterator(folder_of(command)))
        if (entry.path() != command.out) return "left behind: " + entry.path().string();
    return {};
}

std::string wrong_failure(const Command& command, const Ended& ended, const Made& right) {
    const std::string file = command.out.empty() ? "" : bytes_of(command.out);
    const auto lines = std::count(ended.err.begin(), ended.err.end(), '\n');
    if (ended.status != 1) return fmt::format("exit status {}", ended.status);
    if (lines != 1 || !ended.err.starts_with("glint: error: ")) return "not a one-line error";
    if (!right.out.starts_with(ended.out)) return "different output";
    if (!command.out.empty() && file != old_bytes && file != right.file) return "not the old or the new file";
    return {};
}

}  // namespace

Calls calls_of(const Command& command) {
    const TemporaryDirectory notes;
    (void)run(command, "open 9999999999 0 0", notes);
    Calls calls;
    std::istringstream lines(bytes_of(notes.path("calls")));
    for (std::string line; std::getline(lines, line);) {
        calls.lines.push_back(line);
        std::istringstream words(line);
        std::string first, kind;
        long count = 0;
        words >> first >> kind >> count;
        for (std::size_t i = 0; i < kind_names.size(); ++i)
            if (first == "calls" && kind == kind_names[i]) calls.counts[i] = count;
    }
    return calls;
}

Made made_by(const Command& command) {
    const TemporaryDirectory notes;
    const Ended ended = run(command, "open 9999999999 0 0", notes);
    if (ended.status != 0) return {"failed: " + ended.err, {}};
    return {ended.out, command.out.empty() ? "" : bytes_of(command.out)};
}

FailingProgram::FailingProgram(Command command) : command_(std::move(command)) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
    socket_ = ends[0];
    process_ = ::fork();
    if (process_ == 0) {
        const int kept = ::dup(ends[1]);  // stays open across exec
        become(command_, notes_, {{"GLINT_FAULT_SOCKET", std::to_string(kept)}});
    }
    ::close(ends[1]);
}

FailingProgram::~FailingProgram() {
    ::close(socket_);  // the process ends when its socket is closed
    ::waitpid(process_, nullptr, 0);
}

Ended FailingProgram::run(const std::string& fault) {
    put_old_file(command_);
    int status = 0;
    const bool answered = ::send(socket_, fault.data(), fault.size(), MSG_NOSIGNAL) > 0 &&
                          ::recv(socket_, &status, sizeof status, 0) == sizeof status;
    return answered ? ended(status, notes_) : Ended{-1, "", "the program did not start"};
}

std::string FailingProgram::wrong_end(const Fault& fault, const Made& right) {
    const Ended ended = run(text_of(fault));
    const Made made{ended.out, command_.out.empty() ? "" : bytes_of(command_.out)};
    std::string wrong;
    if (ended.status != 0)
        wrong = wrong_failure(command_, ended, right);
    else if (!(made == right))
        wrong = "reports success, but its output is wrong";
    if (wrong.empty() && fault.kind != Kind::Unlink) wrong = wrong_folder(command_);
    if (wrong.empty()) return {};
    return fmt::format("{}, {}: {}\n{}", command_.name, words_of(fault), wrong, ended.err.substr(0, 500));
}

std::string error_of(const Command& command, const Fault& fault) {
    const TemporaryDirectory notes;
    return run(command, text_of(fault), notes).err;
}

std::string words_of(const Fault& fault) { return text_of(fault); }

std::vector<long> numbers(long count, long most) {
    const char* const asked = std::getenv("GLINT_FAULTS");
    if (asked != nullptr && std::strcmp(asked, "all") == 0) most = LONG_MAX;
    std::vector<long> list;
    if (count <= most)
        for (long i = 0; i < count; ++i) list.push_back(i);
    else
        for (long i = 0; i < most; ++i) list.push_back(i * (count - 1) / (most - 1));
    return list;
}

}  // namespace glint::faults
