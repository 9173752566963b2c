#include "models/io/file.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "models/io/child_process.h"
#include "models/utf8.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
using Change = WatchedFile::Change;

namespace fs = std::filesystem;

namespace {

/// Records the library's file operations; the functions below replace the system's.
struct Watch {
    std::optional<mode_t> mode_while_writing;  // of the regular file written last
    std::function<void()> directory_synced;
};
Watch* watch = nullptr;

struct stat status_of(int descriptor) {
    struct stat status {};
    ::fstat(descriptor, &status);
    return status;
}

}  // namespace

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
    if (watch != nullptr && S_ISREG(status_of(descriptor).st_mode))
        watch->mode_while_writing = status_of(descriptor).st_mode & 07777;
    return ::syscall(SYS_write, descriptor, bytes, count);
}

extern "C" int fsync(int descriptor) {
    if (watch != nullptr && watch->directory_synced && S_ISDIR(status_of(descriptor).st_mode))
        watch->directory_synced();
    return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace {

struct Place {
    TemporaryDirectory directory;
    fs::path path = directory.path();
    [[nodiscard]] std::string operator/(const char* name) const { return directory.path(name); }
    [[nodiscard]] std::size_t count() const { return directory.names().size(); }
};

std::string read_back(const std::string& path) { return std::get<std::string>(read_file(path, 1 << 20)); }

template <class T> std::string problem_text(const Result<T>& result) {
    REQUIRE(problem_of(result) != nullptr);
    return problem_of(result)->text();
}

mode_t mode_of(const std::string& path) {
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    return status.st_mode & 07777;
}

}  // namespace

TEST_CASE("the extension determines the format, in any case and even as the entire name", "[file]") {
    CHECK(lower_extension("a.b/c.PnG") == ".png");
    CHECK(lower_extension("a.b/.png") == ".png");
    CHECK(lower_extension("a.b/.c.obj") == ".obj");
    CHECK(lower_extension("a.b/c").empty());
    CHECK(lower_extension("a.b/").empty());
}

TEST_CASE("a written file can be read back, and no other file is left in the directory", "[file]") {
    const Place place;
    const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(200'000, 'x');
    for (const std::string& text : {bytes, std::string("short"), std::string()}) {
        CHECK(problem_of(write_file(place / "a", text)) == nullptr);
        CHECK(read_back(place / "a") == text);
    }
    CHECK(place.count() == 1);
}

TEST_CASE("a file that is too long, missing, a directory, a device or a pipe is refused", "[file]") {
    const Place place;
    REQUIRE(problem_of(write_file(place / "ten", "0123456789")) == nullptr);
    CHECK(problem_of(read_file(place / "ten", 10)) == nullptr);
    CHECK(problem_text(read_file(place / "ten", 9)) ==
          place / "ten" + ": is too long; expected at most 9 bytes");
    CHECK(problem_text(read_file(place / "no", 9)) ==
          place / "no" + ": cannot read: no such file or directory; expected a readable regular file");
    CHECK(problem_text(read_file(place.path, 9)) ==
          place.path.string() + ": is a directory; expected a regular file");
    CHECK(problem_text(read_file("/dev/zero", 9)) == "/dev/zero: is a device; expected a regular file");
    REQUIRE(::mkfifo((place / "pipe").c_str(), 0600) == 0);
    CHECK(problem_text(read_file(place / "pipe", 9)) ==
          place / "pipe" + ": is a pipe or a socket; expected a regular file");
    CHECK(problem_of(read_file("", 9)) != nullptr);
    CHECK(problem_of(read_file(place / "ten" + std::string("\0.json", 6), 99)) != nullptr);
}

TEST_CASE("writing keeps an old file's permission bits and applies the umask to a new one", "[file]") {
    const Place place;
    const mode_t umask_before = ::umask(027);
    REQUIRE(problem_of(write_file(place / "a", "1")) == nullptr);
    ::umask(umask_before);
    CHECK(mode_of(place / "a") == 0640);
    REQUIRE(::chmod((place / "a").c_str(), 0604) == 0);
    REQUIRE(problem_of(write_file(place / "a", "2")) == nullptr);
    CHECK(mode_of(place / "a") == 0604);
    CHECK(read_back(place / "a") == "2");
}

TEST_CASE("writing through a symbolic link keeps the link and replaces its target", "[file]") {
    const Place place;
    fs::create_directory(place.path / "deep");
    REQUIRE(problem_of(write_file(place / "deep/target", "old")) == nullptr);
    fs::create_symlink("deep/target", place.path / "link");
    fs::create_symlink("link", place.path / "second");
    fs::create_symlink("deep/none", place.path / "dangling");
    CHECK(problem_of(write_file(place / "second", "new")) == nullptr);
    CHECK(problem_of(write_file(place / "dangling", "made")) == nullptr);
    CHECK(fs::is_symlink(place.path / "link"));
    CHECK(fs::is_symlink(place.path / "second"));
    CHECK(fs::is_symlink(place.path / "dangling"));
    CHECK(read_back(place / "deep/target") == "new");
    CHECK(read_back(place / "deep/none") == "made");
    fs::create_symlink("loop", place.path / "loop");
    CHECK(problem_of(write_file(place / "loop", "x")) != nullptr);
}

TEST_CASE("a failed write is reported and leaves no file behind", "[file]") {
    const Place place;
    const std::string tail = "; expected a writable file";
    CHECK(problem_text(write_file("/dev/full", "x")) ==
          "/dev/full: cannot write: no space left on the device" + tail);
    CHECK(problem_text(write_file(place / "no/a", "x")) ==
          place / "no/a" + ": cannot write: no such file or directory" + tail);
    CHECK(problem_text(write_file(place.path, "x")) ==
          place.path.string() + ": cannot write: is a directory" + tail);
    CHECK(problem_of(write_file("", "x")) != nullptr);
    CHECK(problem_of(write_file(place / "new/", "x")) != nullptr);
    CHECK(place.count() == 0);
    CHECK(problem_of(write_file("/dev/null", "x")) == nullptr);
}

TEST_CASE("a pipe is written in place, a missing reader is reported and raises no signal", "[file]") {
    const Place place;
    const std::string pipe = place / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    std::string got;
    std::thread reader([&] {
        const int descriptor = ::open(pipe.c_str(), O_RDONLY);
        std::array<char, 64> bytes{};
        const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
        got.assign(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
        ::close(descriptor);
    });
    CHECK(problem_of(write_file(pipe, "through")) == nullptr);
    reader.join();
    CHECK(got == "through");
    CHECK(fs::is_fifo(pipe));
    CHECK(problem_text(write_file_at_once(pipe, "x")) == pipe + ": cannot write: is a pipe; expected a file");

    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    ::close(ends[0]);
    const std::string name = "/dev/fd/" + std::to_string(ends[1]);
    CHECK(problem_text(write_file(name, "x")) ==
          name + ": cannot write: the pipe no longer has a reader; expected a writable file");
    ::close(ends[1]);
}

TEST_CASE("a replacement is never readable by users who could not read the old file", "[file]") {
    const Place place;
    REQUIRE(problem_of(write_file(place / "a", "old")) == nullptr);
    REQUIRE(::chmod((place / "a").c_str(), 0600) == 0);
    const mode_t umask_before = ::umask(0);
    Watch seen;
    watch = &seen;
    const auto written = write_file(place / "a", "new");
    watch = nullptr;
    ::umask(umask_before);
    CHECK(problem_of(written) == nullptr);
    CHECK(seen.mode_while_writing == mode_t{0600});
    CHECK(read_back(place / "a") == "new");
}

TEST_CASE("why_not_writable() reports the same problem as a failed write", "[file]") {
    const Place place;
    for (const std::string& path : {place / "no/a", place.path.string(), std::string(), place / "new/"}) {
        INFO(path);
        const std::optional<Problem> known = why_not_writable(path);
        REQUIRE(known.has_value());
        CHECK(known->text() == problem_text(write_file(path, "x")));
    }
    for (const std::string& path : {place / "a", std::string("-"), std::string("/dev/null")})
        CHECK_FALSE(why_not_writable(path).has_value());
    CHECK(place.count() == 0);
    if (::geteuid() == 0) return;  // root may write anywhere
    REQUIRE(::chmod(place.path.c_str(), 0500) == 0);
    CHECK(why_not_writable(place / "a").has_value());
    REQUIRE(::chmod(place.path.c_str(), 0700) == 0);
}

namespace {

/// A time in milliseconds.
WatchedFile::Time at(int ms) { return WatchedFile::Time(std::chrono::milliseconds(ms)); }

void append(const std::string& path, const char* text) { std::ofstream(path, std::ios::app) << text; }

}  // namespace

TEST_CASE("a watched file is reported when its size has been the same for 100 ms", "[io]") {
    const TemporaryDirectory folder;
    WatchedFile watched(folder.file("a.glsl", "one"));
    CHECK(watched.update(at(0)) == Change::None);
    append(watched.path(), "t");
    CHECK(watched.update(at(1000)) == Change::None);
    append(watched.path(), "wo");  // the file was only half written before
    CHECK(watched.update(at(1099)) == Change::None);
    CHECK(watched.update(at(1198)) == Change::None);
    CHECK(watched.update(at(1199)) == Change::Written);
    CHECK(watched.update(at(1200)) == Change::None);
}

TEST_CASE("a watched file that is replaced by renaming is reported once", "[io]") {
    const TemporaryDirectory folder;
    WatchedFile watched(folder.file("a.glsl", "one"));
    std::filesystem::remove(watched.path());
    CHECK(watched.update(at(1000)) == Change::None);
    std::filesystem::rename(folder.file("new", "two"), watched.path());
    CHECK(watched.update(at(1050)) == Change::None);
    CHECK(watched.update(at(1150)) == Change::Written);
    std::filesystem::rename(folder.file("new", "six"), watched.path());  // a file of the same size
    CHECK(watched.update(at(2000)) == Change::None);
    CHECK(watched.update(at(2100)) == Change::Written);
}

TEST_CASE("a watched file that vanishes is reported, and again when it returns", "[io]") {
    const TemporaryDirectory folder;
    WatchedFile watched(folder.file("a.glsl", "one"));
    std::filesystem::remove(watched.path());
    CHECK(watched.update(at(1000)) == Change::None);
    CHECK(watched.update(at(1100)) == Change::Vanished);
    CHECK(watched.update(at(5000)) == Change::None);
    append(watched.path(), "two");
    CHECK(watched.update(at(6000)) == Change::None);
    CHECK(watched.update(at(6100)) == Change::Written);
}

TEST_CASE("a child process gets its input, and is killed at its limits", "[io]") {
    ChildLimits limits{10, 0, {}, "/bin/sh"};
    const std::string input(300'000, 'x');
    const ChildEnd copied = run_child("sh", {"-c", "cat; echo why >&2; exit 3"}, input, limits);
    CHECK(copied.how == ChildEnd::How::Exited);
    CHECK(copied.status == 3);
    CHECK(copied.output == input);
    CHECK(copied.errors == "why\n");
    CHECK(run_child("sh", {"-c", "kill -9 $$"}, "", limits).how == ChildEnd::How::Killed);
    limits.seconds = 0.05;
    CHECK(run_child("sh", {"-c", "exec sleep 60"}, "", limits).how == ChildEnd::How::TimedOut);
    limits.is_cancelled = [] { return true; };
    CHECK(run_child("sh", {"-c", "exec sleep 60"}, "", limits).how == ChildEnd::How::Cancelled);
    limits.program = "/no/such/program";
    CHECK(run_child("sh", {}, "", limits).how == ChildEnd::How::NotStarted);
}

// Checks UTF-8 against RFC 3629's own definition: a character's bytes contain its number, as few as possible.
namespace {

/// Encodes a character's number; its bits are distributed as in the table in RFC 3629, section 3.
std::string encoded(unsigned number) {
    const auto later = [number](int shift) { return static_cast<char>(0x80 | ((number >> shift) & 0x3F)); };
    if (number < 0x80) return {static_cast<char>(number)};
    if (number < 0x800) return {static_cast<char>(0xC0 | (number >> 6)), later(0)};
    if (number < 0x10000) return {static_cast<char>(0xE0 | (number >> 12)), later(6), later(0)};
    return {static_cast<char>(0xF0 | (number >> 18)), later(12), later(6), later(0)};
}

}  // namespace

TEST_CASE("numbers up to 10FFFF, except surrogates, are characters of UTF-8", "[utf8]") {
    int wrong = 0;
    for (unsigned number = 0; number < 0x200000; ++number) {
        const std::string bytes = encoded(number);
        const bool is_character = number <= 0x10FFFF && (number < 0xD800 || number > 0xDFFF);
        wrong += utf8_length(bytes + "x") != (is_character ? bytes.size() : 0);
    }
    CHECK(wrong == 0);
}

TEST_CASE("overlong and stray bytes are not characters of UTF-8", "[utf8]") {
    for (const std::string bytes :
         {"\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xE0\x9F\xBF", "\xF0\x80\x80\x80", "\xF0\x8F\xBF\xBF",
          "\x80", "\xBF", "\xF8\x88\x80\x80\x80", "\xFE", "\xFF", "\xC3", "\xE2\x82", "\xF0\x9F\x98", "\xC3(",
          "\xE2(\xAC", "\xE2\x82("}) {
        CAPTURE(bytes);
        CHECK(utf8_length(bytes) == 0);
    }
    CHECK(utf8_length("") == 0);
    for (const std::string_view whole : {"\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
        CHECK(utf8_length(whole.substr(0, whole.size() - 1)) == 0);  // bytes beyond the text are not read
}
