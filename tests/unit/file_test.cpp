#include "models/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <thread>

#include "tests/catch.h"
#include "tests/unit/program.h"

using namespace glint;
namespace fs = std::filesystem;

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

TEST_CASE("what is written reads back, and nothing else is left in the directory", "[file]") {
    const Place place;
    const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(200'000, 'x');
    for (const std::string& text : {bytes, std::string("short"), std::string()}) {
        CHECK(problem_of(write_file(place / "a", text)) == nullptr);
        CHECK(read_back(place / "a") == text);
    }
    CHECK(place.count() == 1);
}

TEST_CASE("a file that is too long, missing, a directory, a device or a pipe is a problem", "[file]") {
    const Place place;
    REQUIRE(problem_of(write_file(place / "ten", "0123456789")) == nullptr);
    CHECK(problem_of(read_file(place / "ten", 10)) == nullptr);
    CHECK(problem_text(read_file(place / "ten", 9)) ==
          place / "ten" + ": is too long; expected at most 9 bytes");
    CHECK(problem_text(read_file(place / "no", 9)) ==
          place / "no" +
              ": cannot read: no such file or directory; expected a regular file that can be read");
    CHECK(problem_text(read_file(place.path, 9)) ==
          place.path.string() + ": is a directory; expected a regular file");
    CHECK(problem_text(read_file("/dev/zero", 9)) == "/dev/zero: is a device; expected a regular file");
    REQUIRE(::mkfifo((place / "pipe").c_str(), 0600) == 0);
    CHECK(problem_text(read_file(place / "pipe", 9)) ==
          place / "pipe" + ": is a pipe or a socket; expected a regular file");
    CHECK(problem_of(read_file("", 9)) != nullptr);
    CHECK(problem_of(read_file(place / "ten" + std::string("\0.json", 6), 99)) != nullptr);
}

TEST_CASE("writing keeps the permission bits of the old file and gives a new one those of the umask",
          "[file]") {
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

TEST_CASE("a symbolic link stays and what it names is replaced", "[file]") {
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

TEST_CASE("what cannot be written is a problem and leaves nothing behind", "[file]") {
    const Place place;
    const std::string tail = "; expected a place that can be written";
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

TEST_CASE("a pipe is written straight through, and one without a reader is a problem, not a signal",
          "[file]") {
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

    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    ::close(ends[0]);
    const std::string name = "/dev/fd/" + std::to_string(ends[1]);
    CHECK(problem_text(write_file(name, "x")) ==
          name + ": cannot write: the reader of the pipe has gone; expected a place that can be written");
    ::close(ends[1]);
}
