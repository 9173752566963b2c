#include "app/window/x_errors.h"

#include <X11/Xlib.h>
#include <fmt/core.h>

#include <utility>

#include "app/window/xlib.h"

namespace glint {
namespace {

int last_error = Success;
void (*display_gone)() = nullptr;

int on_error(Display*, XErrorEvent* error) {
    last_error = error->error_code;
    return 0;  // not used by Xlib
}

int on_broken_connection(Display*) {
    display_gone();
    return 0;  // not reached: then Xlib would end the program
}

}  // namespace

void handle_x_errors(void (*gone)()) {
    static const auto set_error = from_xlib<decltype(XSetErrorHandler)>("XSetErrorHandler");
    static const auto set_io_error = from_xlib<decltype(XSetIOErrorHandler)>("XSetIOErrorHandler");
    display_gone = gone;
    if (set_error != nullptr) set_error(on_error);
    if (set_io_error != nullptr) set_io_error(on_broken_connection);
}

std::optional<std::string> take_x_error() {
    switch (const int error = std::exchange(last_error, Success)) {
    case Success:
        return {};
    case BadWindow:
        return "A program that dragged something here, or waited for the clipboard, has gone away; nothing "
               "else "
               "happened";
    default:
        return fmt::format("The display refused a request (X error {}); the window goes on", error);
    }
}

}  // namespace glint
