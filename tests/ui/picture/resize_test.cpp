// Pixels that were picked in a picture of a different size.
#include "tests/support/catch.h"
#include "tests/support/headless_window.h"
#include "ui/features/views/views.h"
#include "ui/picture/screen.h"

using namespace glint;
using test::HeadlessWindow;

namespace {

/// Picks the pixel at these fractions of the picture; a smaller picture does not have it.
void ask_at(HeadlessWindow& window, glm::dvec2 share) {
    window.frames(2);
    const PictureSize size = window.state.rendered->size;
    const glm::ivec2 pixel = nearest_pixel(size, share * glm::dvec2(size.width, size.height));
    window.click(window.at_pixel(glm::dvec2(pixel) + 0.5));
    window.move({1, 1});
    window.frames(2);
    REQUIRE(window.state.on_screen.explanation);
    REQUIRE(window.state.on_screen.explanation->x == pixel.x);
}

void make_small(HeadlessWindow& window) {
    ImGui::GetIO().DisplaySize = {900, 420};
    window.frames(3);
}

bool shows_explained_bytes(const UiState& state) {
    const Explanation& e = *state.on_screen.explanation;
    const std::size_t at = 4 * state.displayed->pixel(e.x, e.y);
    for (std::size_t i = 0; i < 3; ++i)
        if (e.byte[i] != state.displayed->rgba[at + i]) return false;
    return true;
}

}  // namespace

TEST_CASE("a frozen comparison explains a pixel that exists after the window shrinks",
          "[ui][window][compare]") {
    HeadlessWindow window;
    window.frames(2);
    run_command(window.state, command(CommandId::Compare));
    window.state.get<CompareState>().choice.wipes = {0.6, 0.8};
    ask_at(window, {0.5, 0.6});  // another renderer drew this pixel
    REQUIRE(window.state.on_screen.explanation->hit);
    REQUIRE(window.state.on_screen.explanation->mode == ShadingMode::Flat);
    run_command(window.state, command(CommandId::Freeze));
    window.frames(2);
    make_small(window);
    REQUIRE(window.state.on_screen.explanation);
    REQUIRE(is_inside(window.state.displayed->size,
                      {window.state.on_screen.explanation->x, window.state.on_screen.explanation->y}));
    CHECK(shows_explained_bytes(window.state));
}
