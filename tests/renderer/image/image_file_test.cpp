// The expected bytes are independent of the code under test: layouts worked out by hand from specifications,
// zlib's crc32 and inflate, and pictures written by libpng.
#include "renderer/image/image_file.h"

#include <fmt/core.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;
using namespace glint::test;

namespace {

/// A file that is removed at the end of the test.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& bytes)
        : path_(std::filesystem::temp_directory_path() /
                ("glint_image_test_" + std::to_string(getpid()) + ".png")) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

Result<Picture> read_bytes(const std::string& bytes) { return read_png(TemporaryFile(bytes).path()); }

Picture noise(PictureSize size, unsigned seed) {
    Picture picture{size, {}, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < size.width * size.height; ++i) {
        for (int c = 0; c < 3; ++c) picture.rgba.push_back(static_cast<std::uint8_t>(random() >> 24));
        picture.rgba.push_back(255);
    }
    return picture;
}

std::string be32(std::size_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
            static_cast<char>(value)};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return be32(data.size()) + body + be32(crc);
}

std::string deflated(const std::string& raw) {
    uLongf size = compressBound(raw.size());
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
             raw.size());
    return out.substr(0, size);
}

/// A PNG assembled by hand. `raw` contains its scanlines, each after a filter byte.
std::string png(std::size_t width, std::size_t height, char depth, char color_type, const std::string& raw,
                const std::string& palette = {}, bool interlaced = false) {
    const std::string header =
        be32(width) + be32(height) + depth + color_type + std::string(2, '\0') + (interlaced ? '\1' : '\0');
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + (palette.empty() ? "" : chunk("PLTE", palette)) +
           chunk("IDAT", deflated(raw)) + chunk("IEND", "");
}

/// A pass over a picture: the first pixel and the steps to the next ones (PNG specification, 8.2).
struct Pass {
    std::size_t x, y, dx, dy;
};
const std::vector<Pass> row_by_row{{0, 0, 1, 1}};
const std::vector<Pass> adam7{{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};

/// Random samples of `depth` bits, `channels` per pixel.
struct Samples {
    std::size_t width, height, channels;
    int depth;
    std::vector<unsigned> values;

    Samples(std::size_t w, std::size_t h, std::size_t c, int d) : width(w), height(h), channels(c), depth(d) {
        std::mt19937 random(7);
        for (std::size_t i = 0; i < w * h * c; ++i)
            values.push_back(static_cast<unsigned>(random() >> (32 - d)));
    }
    [[nodiscard]] unsigned at(std::size_t x, std::size_t y, std::size_t c) const {
        return values[(y * width + x) * channels + c];
    }
    /// Scanlines without a filter; a pass without pixels has none.
    [[nodiscard]] std::string scanlines(const std::vector<Pass>& passes) const {
        std::string raw;
        for (const Pass& p : passes)
            for (std::size_t y = p.y; y < height && p.x < width; y += p.dy) {
                std::vector<bool> bits;
                for (std::size_t x = p.x; x < width; x += p.dx)
                    for (std::size_t c = 0; c < channels; ++c)
                        for (int b = depth - 1; b >= 0; --b) bits.push_back((at(x, y, c) >> b & 1) != 0);
                raw += '\0';
                for (std::size_t i = 0; i < bits.size(); i += 8) {
                    unsigned byte = 0;
                    for (std::size_t b = 0; b < 8; ++b)
                        byte = byte << 1 | (i + b < bits.size() && bits[i + b] ? 1 : 0);
                    raw += static_cast<char>(byte);
                }
            }
        return raw;
    }
    /// The nearest level from 0 to 255.
    [[nodiscard]] int level(std::size_t x, std::size_t y, std::size_t c) const {
        return static_cast<int>(std::lround(at(x, y, c) * 255.0 / ((1u << depth) - 1)));
    }
};

std::vector<int> rgba_of(const Result<Picture>& result) {
    REQUIRE(std::holds_alternative<Picture>(result));
    const auto& rgba = std::get<Picture>(result).rgba;
    return {rgba.begin(), rgba.end()};
}

void check_refused(const std::string& bytes) {
    const auto result = read_bytes(bytes);
    REQUIRE(problem_of(result) != nullptr);
    const std::string text = problem_of(result)->text();
    INFO(text);
    CHECK(text.find("glint_image_test_") != std::string::npos);

    CHECK(text.find("; expected a PNG picture of 1x1 to 16384x16384") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("the extension determines the format of a picture, regardless of case", "[image]") {
    for (const auto format : {PictureFormat::Png, PictureFormat::Pfm, PictureFormat::Exr}) {
        const std::string path = "a.b/picture" + std::string(extension_of(format));
        CHECK(std::get<PictureFormat>(picture_format(path)) == format);
        CHECK(is_linear(format) == (format != PictureFormat::Png));
    }
    CHECK(std::get<PictureFormat>(picture_format("PICTURE.EXR")) == PictureFormat::Exr);
    for (const char* path : {"", "picture", "a.png/picture", "picture.jpg", "exr"}) {
        const auto refused = picture_format(path);
        REQUIRE(problem_of(refused) != nullptr);
        CHECK(problem_of(refused)->expected == "a name that ends in .png, .pfm or .exr");
    }
}

TEST_CASE("a PFM is written bottom row first, little-endian, multiplied by the exposure", "[image]") {
    Picture picture{{2, 2}, {}, {0, 0.25f, 0.5f, 1, 2, 3, -1, 4, 5, 6, 7, 8}};
    const std::string bytes = pfm_bytes(picture, 2);
    // 2 x 2 pixels of 12 bytes after a header of 3 + 4 + 5 bytes.
    REQUIRE(bytes.size() == 12 + 48);
    CHECK(bytes.substr(0, 12) == "PF\n2 2\n-1.0\n");
    // -2 is 0xC0000000; 8 is 0x41000000; 10 is 0x41200000: the first pixel of the lower row.
    CHECK(bytes.substr(12, 12) == std::string("\0\0\0\xC0\0\0\0\x41\0\0\x20\x41", 12));
    // 0, 0.5 = 0x3F000000, 1 = 0x3F800000: the first pixel of the upper row.
    CHECK(bytes.substr(36, 12) == std::string("\0\0\0\0\0\0\0\x3F\0\0\x80\x3F", 12));
}

TEST_CASE("a picture survives writing and reading a PNG byte for byte", "[image]") {
    for (const PictureSize size : {PictureSize{1, 1}, {7, 3}, {64, 65}}) {
        const Picture picture = noise(size, 5);
        const auto back = read_bytes(png_bytes(picture, "{\"glint\": 1}"));
        REQUIRE(std::holds_alternative<Picture>(back));
        CHECK(std::get<Picture>(back).size == size);
        CHECK(std::get<Picture>(back).rgba == picture.rgba);
    }
}

TEST_CASE("a PNG contains its scene in an iTXt chunk right after the header", "[image]") {
    const std::string scene = "{\"glint\": 1, \"name\": \"K\xC3\xB6rper\"}\n";
    const std::string bytes = png_bytes(noise({3, 2}, 1), scene);
    // Signature 8, IHDR 25; then the keyword, its terminator, flag, method, and the terminators of language
    // and translation.
    const std::string expected = chunk("iTXt", std::string("glint-scene\0\0\0\0\0", 16) + scene);
    CHECK(bytes.substr(33, expected.size()) == expected);
    CHECK(png_bytes(noise({3, 2}, 1), scene) == bytes);
    CHECK(png_bytes(noise({3, 2}, 1), "").find("iTXt") == std::string::npos);
}

TEST_CASE("grey, palette, 16-bit and translucent PNGs are read as 8-bit RGBA", "[image]") {
    CHECK(rgba_of(read_bytes(png(2, 1, 8, 0, std::string("\0\x40\xC0", 3)))) ==
          std::vector<int>{64, 64, 64, 255, 192, 192, 192, 255});
    CHECK(rgba_of(read_bytes(
              png(2, 1, 1, 3, std::string("\0\x40", 2), std::string("\x01\x02\x03\x0A\x0B\x0C")))) ==
          std::vector<int>{1, 2, 3, 255, 10, 11, 12, 255});
    // 16 bits: 0x8080 / 257 = 128, 0xFFFF / 257 = 255, 0.
    CHECK(rgba_of(read_bytes(png(1, 1, 16, 2, std::string("\0\x80\x80\xFF\xFF\0\0", 7)))) ==
          std::vector<int>{128, 255, 0, 255});
    CHECK(rgba_of(read_bytes(png(1, 1, 8, 6, std::string("\0\x0A\x14\x1E\x28", 5)))) ==
          std::vector<int>{10, 20, 30, 40});
}

TEST_CASE("every kind of PNG, interlaced or not, is read as 8-bit RGBA", "[image]") {
    constexpr int grey = 0, rgb = 2, indexed = 3, grey_alpha = 4, rgb_alpha = 6;
    struct Kind {
        int color_type;
        std::size_t channels;
        std::vector<int> depths;
    };
    std::string palette;
    for (int i = 0; i < 3 * 256; ++i) palette += static_cast<char>(i * 31 % 251);
    for (const Kind& kind :
         {Kind{grey, 1, {1, 2, 4, 8, 16}}, Kind{rgb, 3, {8, 16}}, Kind{indexed, 1, {1, 2, 4, 8}},
          Kind{grey_alpha, 2, {8, 16}}, Kind{rgb_alpha, 4, {8, 16}}})
        for (const int depth : kind.depths)
            for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{1, 1}, {5, 3}, {9, 17}})
                for (const bool interlaced : {false, true}) {
                    const Samples samples(width, height, kind.channels, depth);
                    const std::size_t entries = kind.color_type == indexed ? std::size_t{3} << depth : 0;
                    const Result<Picture> read = read_bytes(
                        png(width, height, static_cast<char>(depth), static_cast<char>(kind.color_type),
                            samples.scanlines(interlaced ? adam7 : row_by_row), palette.substr(0, entries),
                            interlaced));
                    std::vector<int> expected;
                    for (std::size_t y = 0; y < height; ++y)
                        for (std::size_t x = 0; x < width; ++x) {
                            for (std::size_t c = 0; c < 3; ++c)
                                expected.push_back(
                                    kind.color_type == indexed
                                        ? static_cast<std::uint8_t>(palette[3 * samples.at(x, y, 0) + c])
                                        : samples.level(x, y, kind.channels < 3 ? 0 : c));
                            expected.push_back(kind.channels % 2 == 0 ? samples.level(x, y, kind.channels - 1)
                                                                      : 255);
                        }
                    INFO("color type " << kind.color_type << ", " << depth << " bits, " << width << "x"
                                       << height << (interlaced ? ", interlaced" : ""));
                    CHECK(rgba_of(read) == expected);
                }
}

TEST_CASE("a broken PNG or a file of another kind is refused in one line", "[image][bad-input]") {
    const std::string good = png_bytes(noise({16, 16}, 3), "{}");
    check_refused("");
    check_refused("PF\n1 1\n-1.0\n");
    check_refused(good.substr(0, 8));
    check_refused(good.substr(0, 40));
    check_refused(good.substr(0, good.size() / 2));
    std::string flipped = good;
    flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 1);  // its CRC is wrong now
    check_refused(flipped);
    check_refused(png(0, 1, 8, 0, std::string(1, '\0')));
    check_refused(png(16385, 1, 8, 0, std::string(16386, '\0')));
    check_refused(png(1, 1, 7, 0, std::string(2, '\0')));
    check_refused(png(4, 4, 8, 2, std::string(5, '\0')));  // fewer scanlines than stated
}

// PFM and OpenEXR files are read back; other files are reported in one line.
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
