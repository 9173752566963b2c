// Whenever a window or a command is killed, every file is the complete old or new one. GLINT_KILLS sets the
// number of kills.
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>

#include "models/io/file.h"
#include "models/json/json.h"
#include "tests/places.h"
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "tests/support/program.h"
#include "tests/support/scenes.h"
#include "ui/preferences/autosave.h"
#include "ui/preferences/persistence.h"

using namespace glint;
using test::HeadlessWindow;
namespace fs = std::filesystem;

namespace {

constexpr const char* worker = "a window that works until it is killed";
constexpr ExportOptions small_picture{{32, 24}, 1};

int kills() {
    const char* const asked = std::getenv("GLINT_KILLS");
    return asked != nullptr ? std::atoi(asked) : 40;
}

/// Runs the program `arguments` and kills it after `killed_after_us` microseconds unless it has ended; 0
/// waits for it to end.
int status_of(const std::vector<std::string>& arguments, int killed_after_us) {
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDOUT_FILENO);
        ::execv(words[0], words.data());
        ::_exit(127);
    }
    if (killed_after_us > 0) {
        std::this_thread::sleep_for(std::chrono::microseconds(killed_after_us));
        ::kill(child, SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

bool is_temporary(const fs::path& path) {
    return path.filename().string().starts_with(".glint-") && path.extension() == ".tmp";
}

/// The number of files below the folder for which `is` returns true.
template <class Is> long count_below(const std::string& folder, const Is& is) {
    long count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) count += is(entry.path()) ? 1 : 0;
    return count;
}

/// Checks that the window wrote this scene: it differs from the first one only in an intensity.
void check_scene(Scene scene) {
    Scene expected = test::busy_scene();
    REQUIRE_FALSE(scene.lights.empty());
    expected.lights[0].intensity = scene.lights[0].intensity;
    CHECK(scene_text(scene) == scene_text(expected));
}

void check_document(const std::string& path) {
    const auto opened = open_document(path);
    const Problem* const problem = problem_of(opened);
    INFO((problem != nullptr ? problem->text() : ""));
    REQUIRE(problem == nullptr);
    check_scene(std::get<SceneDocument>(opened).scene);
}

/// Checks that the picture is that of its embedded scene.
void check_picture(const std::string& path) {
    check_document(path);
    const auto opened = std::get<SceneDocument>(open_document(path));
    CHECK(std::get<std::string>(picture_file(opened, small_picture, path, 1)) == bytes_of(path));
}

/// Checks that the window's own files are intact; removes copies afterwards.
void check_state(const std::string& folder, const std::string& scene) {
    const std::string settings = folder + "/window.json";
    if (fs::exists(settings))
        CHECK(read_preferences(bytes_of(settings)).recent == std::vector<std::string>{scene});
    for (const OrphanedAutosave& left : orphaned_autosaves(folder)) {
        const auto copy = open_autosave(left.lock.path);
        REQUIRE(problem_of(copy) == nullptr);
        check_scene(std::get<SceneDocument>(copy).scene);
        fs::remove(left.lock.path);
    }
    CHECK(count_below(folder, [](const fs::path& path) { return path.extension() == ".autosave"; }) == 0);
}

}  // namespace

TEST_CASE(worker, "[.]") {
    const char* const named = std::getenv("GLINT_KILLED_FOLDER");
    REQUIRE(named != nullptr);
    const std::string folder = named;
    const std::string scene = folder + "/scene.json";
    const bool only_once = std::getenv("GLINT_KILLED_ONCE") != nullptr;
    HeadlessWindow bench({320, 200});
    begin_persistence(bench.state, folder + "/state");
    take_document(bench.state.editor, std::get<SceneDocument>(open_document(scene)));
    bench.frames(2);
    Persistence& memory = bench.state.persistence;
    int step = int(::getpid()) % 1000 * 1000;
    while (true) {
        bench.scene().lights[0].intensity = float(++step);
        (void)bench.key(Key::S, true);
        bench.scene().lights[0].intensity = float(++step);
        memory.autosaved_at = -1e9;
        bench.frames(2);
        begin_export(bench.state, small_picture, folder + "/picture.png");
        memory.preferences.width = 700 + step % 500;
        memory.opened.clear();
        while (bench.state.get<ExportState>().job || memory.autosave_writing) (void)bench.frame();
        if (only_once) break;
    }
    end_persistence(bench.state);
}

TEST_CASE("a window may be killed at any moment: every file is intact", "[faults][ui]") {
    const TemporaryDirectory folder;
    const std::string scene = folder.file("scene.json", scene_text(test::busy_scene()));
    ::setenv("GLINT_KILLED_FOLDER", folder.path().c_str(), 1);
    const std::string self = fs::read_symlink("/proc/self/exe").string();
    std::mt19937 random(4);
    long with_temporary = 0;
    for (int i = 0; i < kills(); ++i) {
        CAPTURE(i);
        const int status = status_of({self, worker}, 10'000 + int(random() % 150'000));
        REQUIRE(WIFSIGNALED(status));
        with_temporary += count_below(folder.path(), is_temporary) > 0 ? 1 : 0;
        check_document(scene);
        if (fs::exists(folder.path("picture.png"))) check_picture(folder.path("picture.png"));
        if (fs::exists(folder.path("state"))) check_state(folder.path("state"), scene);
    }
    fmt::print("{} windows were killed, {} of them while a temporary file existed\n", kills(),
               with_temporary);
    ::setenv("GLINT_KILLED_ONCE", "1", 1);
    CHECK(status_of({self, worker}, 0) == 0);
    ::unsetenv("GLINT_KILLED_ONCE");
    std::vector<std::string> names = folder.names();
    std::erase_if(names, [](const std::string& name) { return is_temporary(name); });
    CHECK(names == std::vector<std::string>{"picture.png", "scene.json", "state"});
    CHECK(count_below(folder.path("state"), [](const fs::path& path) { return !is_temporary(path); }) == 2);
}

TEST_CASE("a command may be killed at any moment: its file is intact", "[faults]") {
    const TemporaryDirectory folder;
    const std::string scene = folder.file("scene.json", scene_text(test::busy_scene()));
    const std::string out = folder.path("picture.png");
    const std::vector<std::string> command{
        glint_program, "render", scene, "-o", out, "--size", "320x200", "--set", "/lights/0/intensity=1"};
    REQUIRE(status_of(command, 0) == 0);
    const std::string one = bytes_of(out);
    std::vector<std::string> other_command = command;
    other_command.back() = "/lights/0/intensity=2";
    REQUIRE(status_of(other_command, 0) == 0);
    const std::string other = bytes_of(out);
    REQUIRE(one != other);
    std::mt19937 random(5);
    long killed = 0;
    for (int i = 0; i < kills(); ++i) {
        const int status = status_of(i % 2 == 0 ? command : other_command, 2'000 + int(random() % 50'000));
        killed += WIFSIGNALED(status) ? 1 : 0;
        const std::string bytes = bytes_of(out);
        CAPTURE(i, bytes.size());
        CHECK((bytes == one || bytes == other));
    }
    fmt::print("{} of {} commands were killed before they ended\n", killed, kills());
    CHECK(killed > 0);
    REQUIRE(status_of(command, 0) == 0);
    CHECK(folder.names() == std::vector<std::string>{"picture.png", "scene.json"});
}
