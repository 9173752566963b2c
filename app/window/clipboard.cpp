#include "app/window/clipboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <imgui.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <utility>

#include "app/window/xlib.h"

namespace glint {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds longest_answer{1000};    // for each piece of a text
constexpr std::chrono::milliseconds longest_transfer{3000};  // for all pieces
constexpr std::size_t longest_text = std::size_t{1} << 20;   // bytes

struct Xlib {
    decltype(XOpenDisplay)* open = from_xlib<decltype(XOpenDisplay)>("XOpenDisplay");
    decltype(XCloseDisplay)* close = from_xlib<decltype(XCloseDisplay)>("XCloseDisplay");
    decltype(XConnectionNumber)* number = from_xlib<decltype(XConnectionNumber)>("XConnectionNumber");
    decltype(XDefaultRootWindow)* root = from_xlib<decltype(XDefaultRootWindow)>("XDefaultRootWindow");
    decltype(XCreateSimpleWindow)* create = from_xlib<decltype(XCreateSimpleWindow)>("XCreateSimpleWindow");
    decltype(XDestroyWindow)* destroy = from_xlib<decltype(XDestroyWindow)>("XDestroyWindow");
    decltype(XSelectInput)* select = from_xlib<decltype(XSelectInput)>("XSelectInput");
    decltype(XInternAtom)* atom = from_xlib<decltype(XInternAtom)>("XInternAtom");
    decltype(XGetSelectionOwner)* owner = from_xlib<decltype(XGetSelectionOwner)>("XGetSelectionOwner");
    decltype(XConvertSelection)* convert = from_xlib<decltype(XConvertSelection)>("XConvertSelection");
    decltype(XPending)* pending = from_xlib<decltype(XPending)>("XPending");
    decltype(XNextEvent)* next = from_xlib<decltype(XNextEvent)>("XNextEvent");
    decltype(XGetWindowProperty)* property = from_xlib<decltype(XGetWindowProperty)>("XGetWindowProperty");
    decltype(XFree)* free = from_xlib<decltype(XFree)>("XFree");

    [[nodiscard]] bool complete() const {
        return open && close && number && root && create && destroy && select && atom && owner && convert &&
               pending && next && property && free;
    }
};

std::string utf8_of_latin1(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code >= 0x80) out += static_cast<char>(0xC0 | code >> 6);
        out += static_cast<char>(code < 0x80 ? code : 0x80 | (code & 0x3F));
    }
    return out;
}

}  // namespace

/// Asks on a connection of its own, so that no event of the window is taken or waited for. Source: ICCCM 2.4
/// and 2.7.2.
class Clipboard::Connection {
  public:
    /// Null where there is no Xlib or no display.
    static std::unique_ptr<Connection> open() {
        const Xlib x;
        Display* display = x.complete() ? x.open(nullptr) : nullptr;
        return display != nullptr ? std::make_unique<Connection>(x, display) : nullptr;
    }
    Connection(const Xlib& x, Display* display)
        : x_(x),
          display_(display),
          clipboard_(x.atom(display, "CLIPBOARD", False)),
          utf8_(x.atom(display, "UTF8_STRING", False)),
          incremental_(x.atom(display, "INCR", False)),
          place_(x.atom(display, "GLINT_CLIPBOARD", False)) {}
    ~Connection() { x_.close(display_); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    [[nodiscard]] Window owner() { return x_.owner(display_, clipboard_); }

    struct Answer {
        std::string text;
        const char* problem = nullptr;
    };

    Answer ask() {
        // A window for each question: what an earlier one still sends goes nowhere.
        window_ = x_.create(display_, x_.root(display_), 0, 0, 1, 1, 0, 0, 0);
        x_.select(display_, window_, PropertyChangeMask);
        end_ = Clock::now() + longest_transfer;
        Answer answer = asked_for(utf8_);
        if (answer.text.empty() && answer.problem == nullptr) {
            answer = asked_for(XA_STRING);
            answer.text = utf8_of_latin1(answer.text);
        }
        x_.destroy(display_, window_);
        return answer;
    }

  private:
    static constexpr const char* silent =
        "The program that holds what was copied does not answer; nothing was pasted";
    static constexpr const char* too_long = "What was copied is longer than 1 MiB; nothing was pasted";

    struct Piece {
        std::string bytes;
        Atom type = None;  // None: there is none
    };

    /// Takes what lies in the property of our window, which tells its sender to go on.
    Piece take_piece() {
        Piece piece;
        int format = 0;
        unsigned long count = 0, left = 0;
        unsigned char* data = nullptr;
        constexpr long quads = longest_text / 4 + 1;
        x_.property(display_, window_, place_, 0, quads, True, AnyPropertyType, &piece.type, &format, &count,
                    &left, &data);
        if (data != nullptr && format == 8) piece.bytes.assign(reinterpret_cast<const char*>(data), count);
        if (data != nullptr) x_.free(data);
        // The display removes only what was read to its end.
        if (left > 0) piece.bytes.resize(longest_text + 1);
        return piece;
    }

    Answer asked_for(Atom kind) {
        x_.convert(display_, clipboard_, kind, place_, window_, CurrentTime);
        const auto given = event([](const XEvent& e) { return e.type == SelectionNotify; });
        if (!given) return {"", silent};
        if (given->xselection.property == None) return {};
        Piece piece = take_piece();
        if (piece.type == incremental_) return in_pieces();
        if (piece.bytes.size() > longest_text) return {"", too_long};
        return {std::move(piece.bytes), nullptr};
    }

    Answer in_pieces() {
        std::string text;
        while (event([](const XEvent& e) {
            return e.type == PropertyNotify && e.xproperty.state == PropertyNewValue;
        })) {
            const Piece piece = take_piece();
            if (piece.type == None) continue;  // told twice
            if (piece.bytes.empty()) return {text, nullptr};
            text += piece.bytes;
            if (text.size() > longest_text) return {"", too_long};
        }
        return {"", silent};
    }

    /// Waits for an event of our window; nothing where none comes in time.
    template <class Wanted> std::optional<XEvent> event(const Wanted& wanted) {
        const auto until = std::min(Clock::now() + longest_answer, end_);
        while (true) {
            while (x_.pending(display_) > 0) {
                XEvent event;
                x_.next(display_, &event);
                if (event.xany.window == window_ && wanted(event)) return event;
            }
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
            pollfd socket{x_.number(display_), POLLIN, 0};
            if (left.count() <= 0) return {};
            (void)poll(&socket, 1, static_cast<int>(left.count()));
        }
    }

    Xlib x_;
    Display* display_;
    Atom clipboard_, utf8_, incremental_, place_;
    Window window_ = None;
    Clock::time_point end_;
};

Clipboard::Clipboard(GLFWwindow* window) : window_(window), connection_(Connection::open()) {}
Clipboard::~Clipboard() = default;

void Clipboard::serve_imgui() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* self, const char* text) { static_cast<Clipboard*>(self)->set(text); };
    io.GetClipboardTextFn = [](void* self) { return static_cast<Clipboard*>(self)->text(); };
}

void Clipboard::set(const char* text) {
    glfwSetClipboardString(window_, text);
    if (connection_) own_ = connection_->owner();
}

const char* Clipboard::text() {
    problem_.reset();
    const Window owner = connection_ ? connection_->owner() : None;
    if (!connection_ || (owner != None && owner == own_)) {
        // Our own text, or Wayland's: GLFW answers at once.
        const char* text = glfwGetClipboardString(window_);
        return text != nullptr ? text : "";
    }
    Connection::Answer answer;
    if (owner != None) answer = connection_->ask();
    if (answer.problem != nullptr) {
        problem_ = answer.problem;
        return nullptr;
    }
    text_ = std::move(answer.text);
    return text_.c_str();
}

std::optional<std::string> Clipboard::take_problem() { return std::exchange(problem_, {}); }

void end_within(unsigned seconds) {
    std::signal(SIGALRM, [](int) { _exit(0); });
    alarm(seconds);
}

}  // namespace glint
