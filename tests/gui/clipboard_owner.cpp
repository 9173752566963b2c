// Holds the clipboard, as a program does in which something was copied. Usage: clipboard_owner WAY TEXT,
// where WAY is `whole`: answers at once; `pieces`: sends one letter at a time; `silent`: never answers;
// `half`: promises pieces and sends one. Says "ready" when it holds the clipboard. Source: ICCCM 2.4 (owners)
// and 2.7.2 (pieces).
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <string>
#include <utility>

namespace {

class Owner {
  public:
    Owner(Display* display, std::string way, std::string text)
        : display_(display), way_(std::move(way)), text_(std::move(text)) {
        window_ = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display, XInternAtom(display, "CLIPBOARD", False), window_, CurrentTime);
        XSync(display, False);
    }

    [[noreturn]] void serve() {
        while (true) {
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest && way_ != "silent") answer(event.xselectionrequest);
            if (event.type == PropertyNotify && event.xproperty.state == PropertyDelete)
                next_piece(event.xproperty);
        }
    }

  private:
    void answer(const XSelectionRequestEvent& request) {
        const Atom utf8 = XInternAtom(display_, "UTF8_STRING", False);
        const bool known = request.target == utf8;
        if (known && way_ == "whole") {
            put(request.requestor, request.property, text_);
        } else if (known) {
            XSelectInput(display_, request.requestor, PropertyChangeMask);
            const long size = static_cast<long>(text_.size());
            XChangeProperty(display_, request.requestor, request.property,
                            XInternAtom(display_, "INCR", False), 32, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(&size), 1);
            sent_ = 0;
        }
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = known ? request.property : Atom{None};
        event.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// The last piece is empty.
    void next_piece(const XPropertyEvent& taken) {
        if (way_ == "half" && sent_ > 0) return;
        put(taken.window, taken.atom, text_.substr(sent_, 1));
        if (sent_ < text_.size()) ++sent_;
    }

    void put(Window window, Atom property, const std::string& bytes) {
        XChangeProperty(display_, window, property, XInternAtom(display_, "UTF8_STRING", False), 8,
                        PropModeReplace, reinterpret_cast<const unsigned char*>(bytes.data()),
                        static_cast<int>(bytes.size()));
        XFlush(display_);
    }

    Display* display_;
    std::string way_, text_;
    std::size_t sent_ = 0;
    Window window_ = None;
};

int ignore_errors(Display*, XErrorEvent*) { return 0; }  // who asked may be gone

}  // namespace

int main(int argc, char** argv) {
    Display* display = XOpenDisplay(nullptr);
    if (argc != 3 || display == nullptr) return 2;
    XSetErrorHandler(ignore_errors);
    Owner owner(display, argv[1], argv[2]);
    std::puts("ready");
    std::fflush(stdout);
    owner.serve();
}
