// A command that a patch adds to one file is in the palette, can be run and taken back, and says when it
// cannot.
#include "tests/support/headless_window.h"

using namespace glint;
using namespace glint::test;

TEST_CASE("a command is one row") {
    HeadlessWindow window;
    const WindowCommand& added = command_named("Twice as bright");
    CHECK(added.menu == Menu::View);
    window.frames(2);
    const float before = window.scene().display.exposure;
    run_command(window.state, added);
    window.frames(2);
    CHECK(window.scene().display.exposure == 2 * before);
    window.key(Key::Z, true);
    window.frames(2);
    CHECK(window.scene().display.exposure == before);
    window.scene().objects.clear();
    CHECK(why_disabled(window.state, added) == "The scene has no object");
}
