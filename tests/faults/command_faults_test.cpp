// Runs the commands while their system calls fail: each call on its own, then together with all later ones.
#include <climits>

#include "tests/faults/failing_program.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::faults;

namespace {

const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
const std::string scene = R"({"glint": 1, "lights": [{"name": "Bulb", "position": [-1, 1, 2]}],
                              "objects": [{"mesh": {"file": "mesh.obj"}}]})";

/// Two files in a folder, and the commands that use them.
struct Room {
    TemporaryDirectory folder;
    std::string mesh_file = folder.file("mesh.obj", mesh), scene_file = folder.file("scene.json", scene);
    std::string png = folder.path("out/picture.png"), exr = folder.path("out/picture.exr");
    std::vector<Command> commands{
        {"render", {"render", scene_file, "-o", png, "--size", "48x32", "--threads", "1"}, png},
        {"explain", {"explain", scene_file, "--pixel", "24,16", "--size", "48x32", "--threads", "1"}, ""},
        {"info", {"info", mesh_file, "--memory", "1G"}, ""},
        {"render exr", {"render", scene_file, "-o", exr, "--size", "48x32", "--threads", "2"}, exr},
    };
};

long count_of(const Calls& calls, Kind kind) { return calls.counts[static_cast<std::size_t>(kind)]; }

/// Makes each call of the kind fail: first on its own, then together with all later ones.
void fail_in_turn(const Command& command, Kind kind, long most) {
    const Made right = made_by(command);
    const long count = count_of(calls_of(command), kind);
    FailingProgram program(command);
    for (const long number : numbers(count, most))
        for (const long in_a_row : {1L, LONG_MAX}) {
            const std::string wrong = program.wrong_end({kind, number, in_a_row, 0}, right);
            CHECK(wrong == "");
        }
}

void fail_in_turn(Kind kind, long most) {
    const Room room;
    for (const Command& command : room.commands) fail_in_turn(command, kind, most);
}

}  // namespace

TEST_CASE("failing calls are counted: the program opens, reads, writes and renames", "[faults]") {
    Room room;
    const Calls calls = calls_of(room.commands.front());
    for (const Kind kind : {Kind::Open, Kind::Read, Kind::Write, Kind::Fsync, Kind::Rename, Kind::Close})
        CHECK(count_of(calls, kind) >= 1);
    CHECK(made_by(room.commands.front()).file.starts_with("\x89PNG"));
}

TEST_CASE("after any failing file call, a command prints one line and leaves files intact", "[faults]") {
    const Kind kind = GENERATE(Kind::Open, Kind::Read, Kind::Write, Kind::Fsync, Kind::Close, Kind::Rename,
                               Kind::Stat, Kind::Lock, Kind::Mode, Kind::Unlink, Kind::Thread);
    fail_in_turn(kind, 1000);
}

TEST_CASE("a thread that cannot start is reported in one line", "[faults]") {
    Room room;
    const Command render{"render two",
                         {"render", room.scene_file, "-o", room.png, "--size", "640x480", "--threads", "2"},
                         room.png};
    REQUIRE(count_of(calls_of(render), Kind::Thread) > 0);
    const std::string error = error_of(render, {Kind::Thread, 0, LONG_MAX, 0});
    CHECK(error.starts_with("glint: error: pthread_create has failed"));
    CHECK(error.find('\n') == error.size() - 1);
}

TEST_CASE("a file is synced before it replaces the old one, and its directory after", "[faults]") {
    Room room;
    const Command& render = room.commands.front();
    const std::string folder = room.folder.path("out");
    const Calls calls = calls_of(render);
    std::vector<std::string> order;
    for (const std::string& line : calls.lines)
        if (line.starts_with("rename ") || line.starts_with("fsync ")) order.push_back(line);
    REQUIRE(order.size() == 3);
    CHECK(order[0].starts_with("fsync " + folder + "/"));
    CHECK(order[1].starts_with("rename " + folder + "/.glint-"));
    CHECK(order[1].ends_with(" " + render.out));
    CHECK(order[2] == "fsync " + folder);
}
