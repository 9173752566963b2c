#include <filesystem>
#include <fstream>

#include "models/io/child_process.h"
#include "models/io/file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
using Change = WatchedFile::Change;

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
    append(watched.path(), "wo");  // it was only half written
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
    std::filesystem::rename(folder.file("new", "six"), watched.path());  // of the same size
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
