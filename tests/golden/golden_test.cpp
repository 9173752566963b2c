// Every sheet equals the committed picture, which was inspected by eye, byte for byte: the engine is
// deterministic across thread counts and instruction sets. GLINT_UPDATE_GOLDENS=1 rewrites the pictures.
#include <fmt/format.h>

#include <cstdlib>
#include <set>
#include <string>

#include "models/io/file.h"
#include "renderer/image/compare.h"
#include "renderer/image/image_file.h"
#include "tests/golden/sheet.h"
#include "tests/support/catch.h"

using namespace glint;
using namespace glint::golden;

namespace {

std::string golden_path(const std::string& name) { return fmt::format("{}/{}.png", GLINT_GOLDEN_DIR, name); }

void write_picture(const std::string& path, const Picture& picture) {
    const auto written = write_file(path, png_bytes(picture, ""));
    if (const Problem* problem = problem_of(written)) FAIL(problem->text());
}

/// Empty if the two are equal; otherwise the differences and the paths of the new picture and of the
/// difference picture.
std::string difference(const std::string& name, const Picture& golden, const Picture& now) {
    const auto compared = compare(golden, now);
    if (const Problem* problem = problem_of(compared)) return problem->text();
    const auto& c = std::get<Comparison>(compared);
    if (c.differing_pixels == 0) return {};
    const std::string new_path = fmt::format("{}/{}.png", GLINT_DIFFERENCES_DIR, name);
    const std::string difference_path = fmt::format("{}/{}-difference.png", GLINT_DIFFERENCES_DIR, name);
    write_picture(new_path, now);
    write_picture(difference_path, difference_picture(golden, now, difference_gain(c)));
    return fmt::format("{} pixels differ by up to {} of 255; new picture: {}; difference: {}",
                       c.differing_pixels, c.max_error, new_path, difference_path);
}

void check_golden(const std::string& name, const Picture& now) {
    CAPTURE(name);
    const char* update = std::getenv("GLINT_UPDATE_GOLDENS");
    if (update != nullptr && *update != '\0') write_picture(golden_path(name), now);
    const auto golden = read_png(golden_path(name));
    if (const Problem* problem = problem_of(golden)) {
        FAIL_CHECK(problem->text());
        return;
    }
    CHECK(difference(name, std::get<Picture>(golden), now) == "");
}

}  // namespace

TEST_CASE("every shading mode and reflection model gives the golden picture", "[golden]") {
    for (const Subject& subject : subjects()) check_golden(subject.name, make_sheet(subject));
}

TEST_CASE("cool-to-warm shading and strokes give the golden picture", "[golden]") {
    check_golden("drawn", make_drawn_sheet());
}

TEST_CASE("every cell of a golden sheet shows a surface, and no two lit cells are equal", "[golden]") {
    const Picture sheet = make_sheet(subjects()[0]);
    std::set<std::string> cells;
    for (int row = 0; row < 4; ++row)
        for (int column = 1; column < 7; ++column) {  // column 0 is unlit: one white silhouette in every mode
            std::string bytes;
            for (int y = 0; y < cell.height; ++y) {
                const auto* first = &sheet.rgba[4 * sheet.pixel(column * cell.width, row * cell.height + y)];
                bytes.append(first, first + std::size_t{4} * cell.width);
            }
            cells.insert(bytes);
        }
    CHECK(cells.size() == 24);
}
