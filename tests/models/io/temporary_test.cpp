// Files that are being written when a process ends.
#include "models/io/temporary.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

#include "models/io/file.h"
#include "tests/support/catch.h"
#include "tests/support/program.h"

using namespace glint;
namespace fs = std::filesystem;

namespace {

/// What wait() says of a child process that does this and then ends with status 7.
int status_of_child(const std::function<void()>& does) {
    const pid_t child = ::fork();
    if (child == 0) {
        does();
        ::_exit(7);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return status;
}

/// The number of a process that has ended.
pid_t gone_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

std::string temporary_name(pid_t maker, const std::string& number) {
    return ".glint-" + std::to_string(maker) + "-" + number + ".tmp";
}

}  // namespace

TEST_CASE("a temporary is there while it is written, and then is the target or gone", "[file][temporary]") {
    const TemporaryDirectory directory;
    const std::string target = directory.path("a");
    {
        const Temporary left(target, 0600);
        REQUIRE(left.error() == 0);
        CHECK(directory.names().size() == 1);
    }
    CHECK(directory.names().empty());
    Temporary kept(target, 0600);
    CHECK(kept.close() == 0);
    CHECK(kept.put_in_place(target) == 0);
    CHECK(directory.names() == std::vector<std::string>{"a"});
    CHECK(Temporary(directory.path("no/a"), 0600).error() == ENOENT);
}

TEST_CASE("a signal that ends the process removes what it was writing, and the shell is told the signal",
          "[file][temporary]") {
    for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) {
        const TemporaryDirectory directory;
        const std::string target = directory.path("a");
        const int status = status_of_child([&] {
            ::signal(number, SIG_DFL);  // whoever runs the tests may ignore it
            remove_temporaries_on_signals();
            const Temporary first(target, 0600), second(target, 0600);
            if (directory.names().size() == 2) ::raise(number);
        });
        INFO(number);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == number);
        CHECK(directory.names().empty());
    }
}

TEST_CASE("a new directory goes again while it is empty, by a signal too, unless it is kept",
          "[file][temporary]") {
    const TemporaryDirectory directory;
    const std::string made = directory.path("made");
    {
        const NewDirectory empty(made);
        CHECK(empty.error() == 0);
        CHECK(directory.names() == std::vector<std::string>{"made"});
        CHECK(NewDirectory(made).error() == EEXIST);
    }
    CHECK(directory.names().empty());
    const int status = status_of_child([&] {
        ::signal(SIGTERM, SIG_DFL);
        remove_temporaries_on_signals();
        const NewDirectory empty(made);
        const Temporary inside(made + "/a", 0600);
        ::raise(SIGTERM);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(directory.names().empty());
    {
        const NewDirectory full(made);
        REQUIRE(problem_of(write_file(made + "/a", "x")) == nullptr);
    }
    CHECK(bytes_of(made + "/a") == "x");
    const std::string kept = directory.path("kept");
    {
        NewDirectory empty(kept);
        empty.keep();
    }
    CHECK(fs::is_directory(kept));
}

TEST_CASE("a signal that comes to another thread removes it too, and nothing is begun any more",
          "[file][temporary]") {
    const TemporaryDirectory directory;
    const int status = status_of_child([&] {
        ::signal(SIGTERM, SIG_DFL);
        remove_temporaries_on_signals();
        std::thread writer([&] {
            for (;;) (void)write_file(directory.path("a"), "whole");
        });
        while (!fs::exists(directory.path("a"))) std::this_thread::yield();
        ::raise(SIGTERM);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGTERM);
    CHECK(directory.names() == std::vector<std::string>{"a"});
    CHECK(bytes_of(directory.path("a")) == "whole");
}

TEST_CASE("whoever begins to write in a process that ends waits for the end", "[file][temporary]") {
    const TemporaryDirectory directory;
    const int status = status_of_child([&] {
        ::signal(SIGALRM, SIG_DFL);
        remove_temporaries();
        const itimerval soon{{}, {0, 50'000}};
        ::setitimer(ITIMER_REAL, &soon, nullptr);
        (void)write_file(directory.path("a"), "x");
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGALRM);
    CHECK(directory.names().empty());
}

TEST_CASE("a signal that is ignored stays ignored", "[file][temporary]") {
    const int status = status_of_child([&] {
        ::signal(SIGHUP, SIG_IGN);  // as nohup does
        remove_temporaries_on_signals();
        ::raise(SIGHUP);
    });
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 7);
}

TEST_CASE("what a killed process left is removed by the next that writes there, and nothing else is",
          "[file][temporary]") {
    const TemporaryDirectory directory;
    const pid_t gone = gone_process();
    const std::string victim = directory.file("victim", "kept");
    std::vector<std::string> kept{"a", "victim"};
    // Left: by a process that is gone, or by an earlier one of our own number.
    (void)directory.file(temporary_name(gone, "0"), "half");
    (void)directory.file(temporary_name(::getpid(), "4000000000"), "half");
    // And by a process whose number another one has by now: nothing was written for more than a minute.
    const std::string old = directory.file(temporary_name(::getppid(), "1"), "half");
    timespec long_ago[2] = {{::time(nullptr) - 120, 0}, {::time(nullptr) - 120, 0}};
    REQUIRE(::utimensat(AT_FDCWD, old.c_str(), long_ago, 0) == 0);
    // Not left: held by a process that we cannot see, of a process that lives, of another name or kind.
    const std::string held = directory.file(temporary_name(gone, "1"), "being written elsewhere");
    const int holder = ::open(held.c_str(), O_RDONLY | O_CLOEXEC);
    REQUIRE(::flock(holder, LOCK_EX | LOCK_NB) == 0);
    REQUIRE(::utimensat(AT_FDCWD, held.c_str(), long_ago, 0) == 0);
    kept.push_back(temporary_name(gone, "1"));
    for (const std::string& name :
         {temporary_name(::getppid(), "0"), temporary_name(gone, ""), temporary_name(gone, "x"),
          temporary_name(gone, "0") + "x", temporary_name(gone, "0 "), temporary_name(gone, "0").substr(1),
          std::string(".glint--5-0.tmp"), std::string(".glint-0-0.tmp"),
          std::string(".glint-99999999999-0.tmp"), std::string(".glint-.tmp"), std::string(".glint-tmp")}) {
        (void)directory.file(name, "kept");
        kept.push_back(name);
    }
    fs::create_directory(directory.path(temporary_name(gone, "2")));
    fs::create_symlink(victim, directory.path(temporary_name(gone, "3")));
    REQUIRE(::mkfifo(directory.path(temporary_name(gone, "4")).c_str(), 0600) == 0);
    for (const char* number : {"2", "3", "4"}) kept.push_back(temporary_name(gone, number));
    if (::geteuid() == 0) {
        const std::string others = directory.file(temporary_name(gone, "5"), "another's");
        REQUIRE(::chown(others.c_str(), 4242, 4343) == 0);
        kept.push_back(temporary_name(gone, "5"));
    }

    REQUIRE(problem_of(write_file(directory.path("a"), "x")) == nullptr);
    std::sort(kept.begin(), kept.end());
    CHECK(directory.names() == kept);
    CHECK(bytes_of(victim) == "kept");
    ::close(holder);
}

TEST_CASE("a file that is being written is locked until it is in its place", "[file][temporary]") {
    const TemporaryDirectory directory;
    const std::string target = directory.path("a");
    const auto can_lock = [](const std::string& path) {
        const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
        const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
        ::close(file);
        return locked;
    };
    Temporary file(target, 0600);
    CHECK_FALSE(can_lock(file.path()));
    REQUIRE(file.close() == 0);
    CHECK_FALSE(can_lock(file.path()));
}
