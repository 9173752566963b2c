// Sends random input to the window as fast as possible: resizes, keys, clicks, scrolling, drops from programs
// that vanish, files that change, two windows on one state folder, displays of every resolution. The input
// depends only on the seed and the number of the life. A life is one start of the program and 400 actions. An
// event is one part of an action: a key, a mouse position, a button, a step of the wheel, a window size.
//
// Usage: monkey_hand EVENTS SEED FIRST_LIFE FOLDER PROGRAM XDND_SOURCE. The program is started in FOLDER/work
// and opens the files there. Exits with 1 and prints the last events if a program dies, prints errors or
// does not answer.
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int deeds_a_life = 400, deeds_between_pings = 25, events_kept = 80;
constexpr double longest_start = 120, longest_answer = 90;  // seconds: sanitizers on a busy machine are slow

double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}
void rest(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

struct Options {
    long events = 0;
    unsigned seed = 1;
    int life = 0;
    fs::path folder;
    std::string program, source;
};

/// A started program, and its window.
struct Started {
    pid_t pid = 0;
    Window window = None;
    fs::path errors;
};

/// Text in `path` that a program should never have written there.
std::string complaints(const fs::path& path) {
    std::ifstream file(path);
    std::string line, found;
    while (std::getline(file, line))
        if (!line.starts_with("glint: warning: ")) found += "    " + line + "\n";
    return found;
}

class Hand {
  public:
    Hand(Options options, Display* display)
        : options_(std::move(options)), display_(display), root_(DefaultRootWindow(display)) {
        XSelectInput(display, root_, SubstructureNotifyMask);  // answers to pings arrive there
    }

    /// Returns 0 if nothing was found.
    int run() {
        int life = options_.life;
        for (; sent_ < options_.events && !found_; ++life) live(life);
        if (!found_)
            fmt::print("passed: {} events in {} lives, seed {}\n", sent_, life - options_.life,
                       options_.seed);
        return found_ ? 1 : 0;
    }

  private:
    int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    bool one_in(int count) { return below(count) == 0; }

    void live(int life) {
        life_ = life;
        std::seed_seq both{options_.seed, static_cast<unsigned>(life)};
        random_.seed(both);
        events_.clear();
        if (one_in(4)) fs::remove_all(options_.folder / "state");
        constexpr std::array dpi{72, 75, 80, 90, 96, 110, 144, 192, 300};
        const std::string resources = fmt::format("Xft.dpi:\t{}\n", dpi[std::size_t(below(dpi.size()))]);
        note("display: " + resources.substr(0, resources.size() - 1));
        XChangeProperty(display_, root_, XA_RESOURCE_MANAGER, XA_STRING, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(resources.data()), int(resources.size()));
        XSync(display_, False);
        const int count = one_in(3) ? 2 : 1;
        for (int i = 0; i < count && !found_; ++i) start(i);
        for (int i = 0; i < deeds_a_life && !found_ && !started_.empty(); ++i) {
            act(started_[std::size_t(below(int(started_.size())))]);
            if (one_in(3)) rest(below(40));
            if (i % deeds_between_pings == deeds_between_pings - 1) look_after_all();
        }
        if (!found_) look_after_all();
        for (const Started& one : started_) end(one);
        started_.clear();
    }

    void note(const std::string& event) {
        ++sent_;
        events_.push_back(event);
        if (events_.size() > events_kept) events_.pop_front();
    }

    void find(const std::string& what, const Started& one) {
        if (std::exchange(found_, true)) return;
        fmt::print("failed: {}; seed {}, life {}. The last events:\n", what, options_.seed, life_);
        for (const std::string& event : events_) fmt::print("    {}\n", event);
        fmt::print("Standard error:\n{}", complaints(one.errors));
        fmt::print("To repeat: tests/gui/monkey.sh {} {} {}\n", options_.events, options_.seed, life_);
    }

    // --- the programs

    void start(int number) {
        std::vector<std::string> files;
        for (const auto& entry : fs::directory_iterator(options_.folder / "work"))
            files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        const std::string file =
            one_in(4) || files.empty() ? "" : files[std::size_t(below(int(files.size())))];
        Started one{0, None, options_.folder / fmt::format("errors.{}", number)};
        note(fmt::format("start {}", file));
        one.pid = fork();
        if (one.pid == 0) {
            const int out = open(one.errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(out, STDERR_FILENO);
            if (chdir((options_.folder / "work").c_str()) != 0) _exit(3);
            execl(options_.program.c_str(), "glint", file.empty() ? nullptr : file.c_str(), nullptr);
            _exit(3);
        }
        const auto since = Clock::now();
        int status = 0;
        while ((one.window = window_of(one.pid)) == None) {
            if (waitpid(one.pid, &status, WNOHANG) == one.pid) return ended(one, status);
            if (seconds_since(since) > longest_start) {
                find("no window appeared", one);
                return end(one);
            }
            rest(20);
        }
        started_.push_back(one);
    }

    /// The mapped window of a process, found by its EWMH properties.
    Window window_of(pid_t pid) {
        Window root = None, parent = None, *children = nullptr;
        unsigned count = 0;
        XQueryTree(display_, root_, &root, &parent, &children, &count);
        Window found = None;
        for (unsigned i = 0; i < count; ++i) {
            Atom type = None;
            int format = 0;
            unsigned long items = 0, left = 0;
            unsigned char* data = nullptr;
            XGetWindowProperty(display_, children[i], atom("_NET_WM_PID"), 0, 1, False, XA_CARDINAL, &type,
                               &format, &items, &left, &data);
            XWindowAttributes look{};
            if (items == 1 && *reinterpret_cast<unsigned long*>(data) == static_cast<unsigned long>(pid) &&
                XGetWindowAttributes(display_, children[i], &look) != 0 && look.map_state == IsViewable)
                found = children[i];
            if (data != nullptr) XFree(data);
        }
        if (children != nullptr) XFree(children);
        return found;
    }

    void ended(const Started& one, int status) {
        const std::string said = complaints(one.errors);
        const bool well =
            WIFEXITED(status) && (WEXITSTATUS(status) == 0 || is_refusal(WEXITSTATUS(status), said));
        if (!well)
            find(WIFSIGNALED(status) ? fmt::format("ended by signal {}", WTERMSIG(status))
                                     : fmt::format("exit status {}", WEXITSTATUS(status)),
                 one);
    }

    /// Whether the program refused an unreadable file, in one line at startup.
    static bool is_refusal(int status, const std::string& said) {
        return status == 1 && said.starts_with("    glint: error: ") &&
               std::count(said.begin(), said.end(), '\n') == 1;
    }

    void end(const Started& one) {
        kill(one.pid, SIGKILL);
        waitpid(one.pid, nullptr, 0);
    }

    /// Checks that all programs are running, have printed no errors, and answer.
    void look_after_all() {
        for (std::size_t i = started_.size(); i-- > 0 && !found_;) {
            const Started one = started_[i];
            int status = 0;
            const bool gone = waitpid(one.pid, &status, WNOHANG) == one.pid;
            if (gone) started_.erase(started_.begin() + std::ptrdiff_t(i));
            if (gone)
                ended(one, status);
            else if (!complaints(one.errors).empty()) {
                rest(5000);  // a sanitizer keeps writing while it resolves symbols
                find("it printed errors", one);
            } else if (!answers(one) && waitpid(one.pid, &status, WNOHANG | WNOWAIT) == 0)
                hangs(one);
        }
    }

    void hangs(const Started& one) {
        kill(one.pid, SIGABRT);  // makes a sanitizer report where it hangs
        rest(3000);
        find(fmt::format("no answer for {} seconds", longest_answer), one);
    }

    bool answers(const Started& one) {
        send(one.window, atom("WM_PROTOCOLS"),
             {long(atom("_NET_WM_PING")), CurrentTime, long(one.window), 0, 0});
        const auto since = Clock::now();
        while (seconds_since(since) < longest_answer) {
            while (XPending(display_) > 0) {
                XEvent event;
                XNextEvent(display_, &event);
                if (event.type == ClientMessage && event.xclient.message_type == atom("WM_PROTOCOLS") &&
                    Window(event.xclient.data.l[2]) == one.window)
                    return true;
            }
            if (waitpid(one.pid, nullptr, WNOHANG | WNOWAIT) != 0) return false;
            rest(5);
        }
        return false;
    }

    // --- input

    void act(const Started& one) {
        XSetInputFocus(display_, one.window, RevertToParent, CurrentTime);
        switch (below(20)) {
        case 0:
        case 1:
            return resize(one);
        case 2:
        case 3:
        case 4:
        case 5:
        case 6:
        case 7:
            return press_keys();
        case 8:
            return type();
        case 9:
        case 10:
        case 11:
        case 12:
            return click(one);
        case 13:
            return drag(one);
        case 14:
            return wheel(one);
        case 15:
            return vanish(one);
        case 16:
            return one_in(4) ? drop(one) : move(one);
        case 17:
            return change_file();
        default:
            return move(one);
        }
    }

    void resize(const Started& one) {
        for (int i = one_in(4) ? 10 : 1; i > 0; --i) {
            const int most = one_in(4) ? 30 : one_in(2) ? 700 : 2000;
            const int width = 1 + below(most), height = 1 + below(most);
            note(fmt::format("resize {} {}", width, height));
            XMoveResizeWindow(display_, one.window, 0, 0, unsigned(width), unsigned(height));
            XFlush(display_);
            if (one_in(2)) rest(below(20));
        }
    }

    void key(KeySym symbol, bool down) {
        XTestFakeKeyEvent(display_, XKeysymToKeycode(display_, symbol), down ? True : False, 0);
        XFlush(display_);
    }

    void press(KeySym symbol, bool ctrl, bool shift, bool alt) {
        note(fmt::format("key {}{}{}{}", ctrl ? "Ctrl+" : "", shift ? "Shift+" : "", alt ? "Alt+" : "",
                         XKeysymToString(symbol)));
        if (ctrl) key(XK_Control_L, true);
        if (shift) key(XK_Shift_L, true);
        if (alt) key(XK_Alt_L, true);
        key(symbol, true), key(symbol, false);
        if (alt) key(XK_Alt_L, false);
        if (shift) key(XK_Shift_L, false);
        if (ctrl) key(XK_Control_L, false);
    }

    /// Presses a few keys, at most 20 ms apart, so that several reach one frame.
    void press_keys() {
        constexpr std::array others{XK_Delete, XK_Escape,  XK_Return, XK_Tab,       XK_Up,
                                    XK_Down,   XK_Page_Up, XK_F1,     XK_F8,        XK_F9,
                                    XK_F10,    XK_F11,     XK_F12,    XK_Page_Down, XK_KP_0,
                                    XK_KP_1,   XK_KP_3,    XK_KP_5,   XK_KP_7,      XK_BackSpace};
        for (int i = 1 + below(5); i > 0; --i) {
            const int which = below(26 + 4 + int(others.size()) + 1);
            // Presses the slash only with Shift, as a question mark, so a typed path stays in the folder.
            if (which == 0)
                press(XK_slash, false, true, false);
            else if (which <= 26)
                press(KeySym(XK_a + which - 1), one_in(3), one_in(5), one_in(12));
            else if (which <= 30)
                press(KeySym(XK_1 + which - 27), false, false, false);
            else
                press(KeySym(others[std::size_t(which - 31)]), one_in(8), one_in(8), false);
            rest(below(21));
        }
    }

    void type() {
        constexpr std::string_view letters = "0123456789-ea ";
        for (int i = 1 + below(5); i > 0; --i) {
            const char letter = letters[std::size_t(below(int(letters.size())))];
            press(letter == '-' ? XK_minus : KeySym(letter), false, false, false);
        }
    }

    void point(const Started& one) {
        XWindowAttributes look{};
        if (XGetWindowAttributes(display_, one.window, &look) == 0) return;
        // Thousandths of the window, because another program may have just changed its size.
        const int x = below(1000), y = below(1000);
        note(fmt::format("point at {} {} thousandths", x, y));
        XTestFakeMotionEvent(display_, -1, look.x + x * look.width / 1000, look.y + y * look.height / 1000,
                             0);
        XFlush(display_);
    }

    void button(unsigned which, bool down) {
        XTestFakeButtonEvent(display_, which, down ? True : False, 0);
        XFlush(display_);
    }

    void move(const Started& one) {
        point(one);
        rest(below(10));
    }

    void click(const Started& one) {
        XRaiseWindow(display_, one.window);
        point(one);
        const unsigned which = one_in(6) ? 3 : 1;
        const bool ctrl = one_in(8), alt = one_in(16);
        for (int i = one_in(4) ? 2 : 1; i > 0; --i) {
            note(fmt::format("click {}{}", which, ctrl ? " with Ctrl" : alt ? " with Alt" : ""));
            if (ctrl) key(XK_Control_L, true);
            if (alt) key(XK_Alt_L, true);
            button(which, true), rest(below(20)), button(which, false);
            if (alt) key(XK_Alt_L, false);
            if (ctrl) key(XK_Control_L, false);
        }
    }

    void drag(const Started& one) {
        XRaiseWindow(display_, one.window);
        point(one);
        const unsigned which = 1 + unsigned(below(3));
        note(fmt::format("drag with {}", which));
        button(which, true);
        for (int i = 1 + below(8); i > 0; --i) {
            point(one), rest(below(15));
            if (one_in(10)) press_keys();
            if (one_in(20)) resize(one);
        }
        button(which, false);
    }

    void wheel(const Started& one) {
        point(one);
        const unsigned which = 4 + unsigned(below(4));
        for (int i = 1 + below(6); i > 0; --i) button(which, true), button(which, false);
        note(fmt::format("wheel {}", which));
    }

    // --- other programs

    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    void send(Window to, Atom type, std::array<long, 5> data) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = to;
        event.xclient.message_type = type;
        event.xclient.format = 32;
        std::copy(data.begin(), data.end(), event.xclient.data.l);
        XSendEvent(display_, to, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// A drop source that ends before the window can answer.
    void vanish(const Started& one) {
        const bool drops = one_in(2);
        note(drops ? "a source drops and vanishes" : "a source drags and vanishes");
        const Window source = XCreateSimpleWindow(display_, root_, 0, 0, 1, 1, 0, 0, 0);
        constexpr long version = 5L << 24;
        send(one.window, atom("XdndEnter"), {long(source), version, long(atom("text/uri-list")), 0, 0});
        send(one.window, atom("XdndPosition"),
             {long(source), 0, (100L << 16) | 100, CurrentTime, long(atom("XdndActionCopy"))});
        if (drops) XSetSelectionOwner(display_, atom("XdndSelection"), source, CurrentTime);
        if (drops) send(one.window, atom("XdndDrop"), {long(source), 0, CurrentTime, 0, 0});
        XDestroyWindow(display_, source);
        XSync(display_, False);
    }

    std::string any_file() {
        std::vector<std::string> files;
        for (const auto& entry : fs::directory_iterator(options_.folder / "given"))
            files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        return files[std::size_t(below(int(files.size())))];
    }

    void drop(const Started& one) {
        XRaiseWindow(display_, one.window);
        point(one);
        const std::string file = any_file();
        note("drop " + file);
        const pid_t pid = fork();
        if (pid == 0) {
            const int nowhere = open("/dev/null", O_WRONLY);  // a rejected drop is not a failure
            dup2(nowhere, STDERR_FILENO);
            execl(options_.source.c_str(), "xdnd_source", file.c_str(), nullptr);
            _exit(3);
        }
        rest(below(300));
        if (one_in(2)) kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
    }

    /// Another program writes a file that a window may have open.
    void change_file() {
        const fs::path from = any_file();
        if (from.extension() != ".json") return;
        note("change work/scene.json to " + from.filename().string());
        std::error_code failed;
        const fs::path target = options_.folder / "work" / "scene.json", beside = options_.folder / "beside";
        fs::copy_file(from, beside, fs::copy_options::overwrite_existing, failed);
        fs::rename(beside, target, failed);
    }

    Options options_;
    Display* display_;
    Window root_;
    std::mt19937 random_;
    std::vector<Started> started_;
    std::deque<std::string> events_;
    long sent_ = 0;
    int life_ = 0;
    bool found_ = false;
};

/// Ignores X errors: a window may vanish between two requests, which is not a failure.
int pass_over(Display*, XErrorEvent*) { return 0; }

}  // namespace

int main(int argc, char** argv) {
    if (argc != 7) return 2;
    Display* display = XOpenDisplay(nullptr);
    if (display == nullptr) return 1;
    XSetErrorHandler(pass_over);
    setvbuf(stdout, nullptr, _IOLBF, 0);
    const Options options{
        std::atol(argv[1]), unsigned(std::atoi(argv[2])), std::atoi(argv[3]), argv[4], argv[5], argv[6]};
    return Hand(options, display).run();
}
