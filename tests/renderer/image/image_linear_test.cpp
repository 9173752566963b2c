// PFM and OpenEXR files are read back; other files are reported in one line.
#include <fmt/core.h>

#include <limits>

#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using namespace glint::test;

namespace {

Picture six_pixels() {
    Picture picture{{3, 2}, {}, {}};
    for (int i = 0; i < 18; ++i) picture.linear.push_back(0.25f * static_cast<float>(i) - 1);
    return picture;
}

void check_problem(const Result<Picture>& read, const std::string& what) {
    const Problem* problem = problem_of(read);
    REQUIRE(problem != nullptr);
    INFO(problem->what);
    CHECK(problem->what.find(what) != std::string::npos);
}

}  // namespace

TEST_CASE("a PFM and an EXR return the numbers that were written", "[image]") {
    const TemporaryDirectory directory;
    const Picture picture = six_pixels();
    const auto pfm = read_pfm(directory.file("a.pfm", pfm_bytes(picture, 1)));
    const auto exr = read_exr(directory.file("a.exr", exr_bytes(picture, 1)));
    REQUIRE(problem_of(pfm) == nullptr);
    REQUIRE(problem_of(exr) == nullptr);
    CHECK(std::get<Picture>(pfm).size == picture.size);
    CHECK(std::get<Picture>(pfm).linear == picture.linear);
    CHECK(std::get<Picture>(exr).size == picture.size);
    CHECK(std::get<Picture>(exr).linear == picture.linear);
}

TEST_CASE("a PFM may be grey and big-endian", "[image]") {
    const TemporaryDirectory directory;
    // 1 and 2 as IEEE 754 singles: 3F800000 and 40000000. The bottom row is first.
    const std::string bytes =
        std::string("Pf\n1 2\n1.0\n") + std::string("\x3f\x80\x00\x00\x40\x00\x00\x00", 8);
    const auto read = read_pfm(directory.file("a.pfm", bytes));
    REQUIRE(problem_of(read) == nullptr);
    CHECK(std::get<Picture>(read).linear == std::vector<float>{2, 2, 2, 1, 1, 1});
}

TEST_CASE("a PFM with Windows line endings is read, and one that is too long is refused", "[image]") {
    const TemporaryDirectory directory;
    const std::string pixels("\x0a\x00\x80\x3f\x00\x00\x00\x40", 8);  // 1.0000012 and 2, a newline first
    const std::vector<float> numbers{1 + 10 * 0x1p-23f, 1 + 10 * 0x1p-23f, 1 + 10 * 0x1p-23f, 2, 2, 2};
    for (const char* const heading : {"Pf\r\n2 1\r\n-1.0\r\n", "Pf\n2 1\n-1.0\n", "Pf 2 1 -1.0\r"}) {
        const auto read = read_pfm(directory.file("a.pfm", heading + pixels));
        INFO(heading);
        REQUIRE(problem_of(read) == nullptr);
        CHECK(std::get<Picture>(read).linear == numbers);
        check_problem(read_pfm(directory.file("a.pfm", heading + pixels + "abc")),
                      " bytes after its last pixel");
    }
}

TEST_CASE("a file that is not a PFM or an EXR is refused", "[image][bad-input]") {
    const TemporaryDirectory directory;
    const std::string pfm = pfm_bytes(six_pixels(), 1), exr = exr_bytes(six_pixels(), 1);
    check_problem(read_pfm(directory.file("a.pfm", "")), "does not begin like a PFM");
    check_problem(read_pfm(directory.file("a.pfm", "P6\n3 2\n255\n")), "does not begin like a PFM");
    for (const char* const scale : {"0", "nan", "-nan", "inf", "-inf", "1e-400"})
        check_problem(read_pfm(directory.file("a.pfm", fmt::format("PF\n3 2\n{}\n", scale) + pfm.substr(12))),
                      "does not begin like a PFM");
    check_problem(read_pfm(directory.file("a.pfm", "PF\n0 2\n-1\n")), "size out of range");
    check_problem(read_pfm(directory.file("a.pfm", "PF\n99999 2\n-1\n")), "size out of range");
    check_problem(read_pfm(directory.file("a.pfm", pfm.substr(0, pfm.size() - 1))), "ends too early");
    check_problem(read_pfm(directory.path("none.pfm")), "cannot read");
    check_problem(read_exr(directory.file("a.exr", "")), "OpenEXR");
    check_problem(read_exr(directory.file("a.exr", "PF\n3 2\n-1\n")), "OpenEXR");
    for (const std::size_t length : {exr.size() / 4, exr.size() / 2, exr.size() - 8})
        check_problem(read_exr(directory.file("a.exr", exr.substr(0, length))), "OpenEXR");
}
