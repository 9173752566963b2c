#pragma once
// A person at the window, who works only with mouse and keys, and sees text and pixels.

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/support/headless_window.h"
#include "tests/support/program.h"

namespace glint::test {

class Person : public HeadlessWindow {
  public:
    explicit Person(ImVec2 size = {1280, 1000}) : HeadlessWindow(size) { frames(2); }

    /// Whether this text is in the window: drawn as text, in a notification, or the name of a visible
    /// control.
    [[nodiscard]] bool sees(std::string_view wanted) const {
        std::string letters(wanted);
        std::erase(letters, ' ');
        return text().find(letters) != std::string::npos || notes_with(std::string(wanted)) > 0 ||
               std::any_of(controls().begin(), controls().end(), [&](const NamedControl& control) {
                   return control.in_sight && control.name.find(wanted) != std::string::npos;
               });
    }
    /// The picture in the window.
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return state.displayed->rgba; }
    /// The window position at the fractions (x, y) of the picture.
    [[nodiscard]] ImVec2 at(double x, double y) const {
        return at_pixel({std::floor(x * state.rendered->size.width) + 0.5,
                         std::floor(y * state.rendered->size.height) + 0.5});
    }

    /// The sum of red, green and blue at a position in the window.
    [[nodiscard]] int brightness(ImVec2 place) const {
        const ImVec2 low = at_pixel({0, 0});
        const std::uint8_t* const c =
            &pixels()[4 * state.displayed->size.index(int(place.x - low.x), int(place.y - low.y))];
        return c[0] + c[1] + c[2];
    }

    void press(Key key, bool ctrl = false, bool shift = false) {
        (void)HeadlessWindow::key(key, ctrl, shift);
        frames(3);
    }
    void clicks(std::string_view control_name) {
        click(control(control_name));
        frames(3);
    }
    /// Finds a command by a few letters and runs it.
    void finds(const char* letters) {
        press(Key::K, true);
        type(letters);
        press(Key::Enter);
    }
    void drops(const std::string& path) {
        open(path);
        frames(3);
    }
    /// Answers the open file dialog. Sets the folder directly, because its rows depend on the machine.
    void names_file(const std::string& path) {
        REQUIRE(state.files.open);
        state.files.folder = std::filesystem::path(path).parent_path().string();
        frames(2);
        type(std::filesystem::path(path).filename().string().c_str());
        press(Key::Enter);
    }
    /// Runs frames until the condition holds; fails after two minutes.
    void waits_until(const std::function<bool()>& is_so) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (!is_so()) {
            frames(1);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            REQUIRE(std::chrono::steady_clock::now() < end);
        }
        frames(3);
    }
    /// Hovers over bright pixels until one can be dragged as a highlight; returns its position.
    [[nodiscard]] ImVec2 finds_highlight() {
        const PictureSize size = state.rendered->size;
        std::vector<std::pair<int, glm::ivec2>> brightest;
        for (int y = 4; y < size.height; y += 6)
            for (int x = 4; x < size.width; x += 6) {
                const ImVec2 place = at_pixel(glm::dvec2(x, y) + 0.5);
                brightest.push_back({brightness(place), {x, y}});
            }
        std::sort(brightest.begin(), brightest.end(), [](auto& a, auto& b) { return a.first > b.first; });
        for (std::size_t i = 0; i < 200; ++i) {
            const ImVec2 place = at_pixel(glm::dvec2(brightest.at(i).second) + 0.5);
            move(place);
            if (state.viewport.hovered_grip.kind == GripKind::Highlight) return place;
        }
        FAIL("no highlight can be grabbed");
        return {};
    }
};

}  // namespace glint::test
