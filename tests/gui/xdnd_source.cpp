// Drops a file on the window under the mouse, as a file manager does: the source side of XDND, which xdotool
// lacks. Usage: xdnd_source FILE. The exit status is 0 if the target accepted the file. With `--vanish` as
// FILE, the source exits in the middle of a drag, before the target can answer. Source:
// freedesktop.org, "Drag-and-Drop Protocol for the X Window System" (XDND, version 5).
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace {

struct Atoms {
    Atom aware, enter, position, status, leave, drop, finished, selection, copy, uri_list;
    explicit Atoms(Display* display) {
        const auto atom = [display](const char* name) { return XInternAtom(display, name, False); };
        aware = atom("XdndAware"), enter = atom("XdndEnter"), position = atom("XdndPosition");
        status = atom("XdndStatus"), leave = atom("XdndLeave"), drop = atom("XdndDrop");
        finished = atom("XdndFinished"), selection = atom("XdndSelection");
        copy = atom("XdndActionCopy"), uri_list = atom("text/uri-list");
    }
};

/// The window under the mouse that accepts drops, and the mouse position.
struct Target {
    Window window = None;
    int x = 0, y = 0;
};

bool takes_drops(Display* display, Window window, Atom aware) {
    Atom type = None;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(display, window, aware, 0, 1, False, AnyPropertyType, &type, &format, &count, &left,
                       &data);
    if (data != nullptr) XFree(data);
    return type != None;
}

Target target_under_mouse(Display* display, const Atoms& atoms) {
    Target target;
    Window window = DefaultRootWindow(display);
    while (window != None) {
        Window root = None, child = None;
        int x = 0, y = 0;
        unsigned mask = 0;
        if (!XQueryPointer(display, window, &root, &child, &target.x, &target.y, &x, &y, &mask)) break;
        if (takes_drops(display, window, atoms.aware)) target.window = window;
        window = child;
    }
    return target;
}

class Source {
  public:
    Source(Display* display, const std::string& file)
        : display_(display),
          atoms_(display),
          uris_("file://" + file + "\r\n"),
          vanishes_(file == "--vanish") {
        window_ = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display, atoms_.selection, window_, CurrentTime);
    }

    bool run() {
        const Target target = target_under_mouse(display_, atoms_);
        if (target.window == None) return said("no window under the mouse accepts drops");
        constexpr long version = 5;
        send(target.window, atoms_.enter, version << 24, static_cast<long>(atoms_.uri_list), 0, 0);
        send(target.window, atoms_.position, 0, (long(target.x) << 16) | target.y, CurrentTime,
             static_cast<long>(atoms_.copy));
        if (vanishes_) return true;
        if (!wait_for(atoms_.status)) return said("the target does not answer");
        send(target.window, atoms_.drop, 0, CurrentTime, 0, 0);
        return wait_for(atoms_.finished) || said("the target did not finish");
    }

  private:
    static bool said(const char* what) {
        std::fprintf(stderr, "xdnd_source: %s\n", what);
        return false;
    }

    void send(Window to, Atom type, long l1, long l2, long l3, long l4) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.display = display_;
        event.xclient.window = to;
        event.xclient.message_type = type;
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(window_);
        event.xclient.data.l[1] = l1, event.xclient.data.l[2] = l2;
        event.xclient.data.l[3] = l3, event.xclient.data.l[4] = l4;
        XSendEvent(display_, to, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Answers the target's requests for the data until a message of this type arrives; false after 5
    /// seconds.
    bool wait_for(Atom message) {
        for (int tries = 0; tries < 50; ++tries) {
            while (XPending(display_) > 0) {
                XEvent event;
                XNextEvent(display_, &event);
                if (event.type == SelectionRequest) hand_over(event.xselectionrequest);
                if (event.type == ClientMessage && event.xclient.message_type == message) return true;
            }
            pollfd wait{ConnectionNumber(display_), POLLIN, 0};
            poll(&wait, 1, 100);
        }
        return false;
    }

    void hand_over(const XSelectionRequestEvent& request) {
        XChangeProperty(display_, request.requestor, request.property, atoms_.uri_list, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.display = display_;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Atoms atoms_;
    std::string uris_;
    bool vanishes_ = false;
    Window window_ = None;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) return 1;
    const bool taken = Source(display, argv[1]).run();
    XCloseDisplay(display);
    return taken ? 0 : 1;
}
