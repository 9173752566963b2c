// OpenEXR files, read back by the library's own reader.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include <cstdint>
#include <cstring>

#include "renderer/image/image_file.h"
#include "tests/support/catch.h"
#include "tests/support/memory_helpers.h"
#include "tests/support/program.h"
#include "tests/support/sanitized.h"

using namespace glint;

namespace {

class Source : public Imf::IStream {
  public:
    explicit Source(std::string bytes) : IStream("picture"), bytes_(std::move(bytes)) {}
    bool read(char c[], int n) override {
        std::memcpy(c, bytes_.data() + at_, static_cast<std::size_t>(n));
        at_ += static_cast<std::size_t>(n);
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

/// An EXR of 4 x 4 zeros with these channels, each with one number per `step` pixels in x and y.
std::string file_with(const TemporaryDirectory& directory,
                      const std::vector<std::pair<const char*, int>>& channels) {
    Imf::Header header(4, 4);
    for (const auto& [name, step] : channels)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT, step, step));
    std::vector<float> zeros(16);
    Imf::FrameBuffer frame;
    for (const auto& [name, step] : channels)
        frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(zeros.data()), 4, 16, step, step));
    std::string path = directory.path("channels.exr");
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(4);
    return path;
}

/// The file with one block's offset pointing to nothing. The table of offsets ends at the first block.
std::string without_block(std::string exr, std::size_t block, std::size_t blocks) {
    const auto place_at = [&exr](std::size_t at) {
        std::uint64_t place = 0;
        std::memcpy(&place, exr.data() + at, sizeof place);
        return place;
    };
    std::size_t table = 0;
    while (table < 1000 && place_at(table) != table + blocks * sizeof(std::uint64_t)) ++table;
    REQUIRE(table < 1000);
    exr.replace(table + block * sizeof(std::uint64_t), 4, "\xff\xff\xff\x7f");
    return exr;
}

}  // namespace

TEST_CASE("an EXR without full red, green and blue channels is refused", "[image][bad-input]") {
    const TemporaryDirectory directory;
    const auto what = [&](const std::vector<std::pair<const char*, int>>& channels) {
        const auto read = read_exr(file_with(directory, channels));
        const Problem* problem = problem_of(read);
        return problem == nullptr ? "" : problem->what;
    };
    CHECK(what({{"R", 1}, {"G", 1}, {"B", 1}}).empty());
    CHECK(what({{"Y", 1}}).empty());
    CHECK(what({{"R", 1}, {"Z", 1}}).empty());  // a depth channel in addition to colours
    CHECK(what({{"Y", 1}, {"RY", 2}, {"BY", 2}}) == "has the channel RY next to Y but no R, G, B");
    CHECK(what({{"X", 1}, {"Y", 1}, {"Z", 1}}) == "has the channel X next to Y but no R, G, B");
    CHECK(what({{"R", 1}, {"G", 2}, {"B", 2}}) == "has a subsampled channel G");
}

TEST_CASE("an EXR has every number of a picture multiplied by the exposure, top row first", "[image]") {
    Picture picture;
    picture.size = {3, 2};
    for (int i = 0; i < 18; ++i) picture.linear.push_back(static_cast<float>(i) * 0.7f - 2);
    const std::string bytes = exr_bytes(picture, 2);
    CHECK(bytes == exr_bytes(picture, 2));

    Source source(bytes);
    Imf::InputFile file(source);
    const Imath::Box2i window = file.header().dataWindow();
    REQUIRE(window.max.x - window.min.x == 2);
    REQUIRE(window.max.y - window.min.y == 1);
    std::vector<float> read(18);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < 3; ++c)
        frame.insert(std::string(1, "RGB"[c]),
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read.data() + c), 12, 36));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    for (std::size_t i = 0; i < 18; ++i) CHECK(read[i] == picture.linear[i] * 2);
}

TEST_CASE("an EXR is read as its display window, regardless of its data window", "[image]") {
    const TemporaryDirectory directory;
    const std::string path = directory.path("windows.exr");
    const Imath::Box2i display({-2, 1}, {5, 6});
    const auto number = [](int x, int y) { return static_cast<float>(100 * y + x); };
    for (const Imath::Box2i& data : {display, Imath::Box2i({0, 2}, {3, 4}), Imath::Box2i({-5, -2}, {9, 8}),
                                     Imath::Box2i({3, 0}, {8, 3}), Imath::Box2i({20, 20}, {21, 21})}) {
        Imf::Header header(display, data);
        for (const char* const name : {"R", "G", "B"})
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        const int width = data.max.x - data.min.x + 1;
        std::vector<float> stored;
        for (int y = data.min.y; y <= data.max.y; ++y)
            for (int x = data.min.x; x <= data.max.x; ++x)
                for (int c = 0; c < 3; ++c) stored.push_back(number(x, y) + static_cast<float>(c) / 4);
        {
            Imf::FrameBuffer frame;
            for (std::size_t c = 0; c < 3; ++c)
                frame.insert(std::string(1, "RGB"[c]),
                             Imf::Slice::Make(Imf::FLOAT, stored.data() + c, data, 12,
                                              12 * static_cast<std::size_t>(width)));
            Imf::OutputFile file(path.c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(data.max.y - data.min.y + 1);
        }
        const auto read = read_exr(path);
        REQUIRE(problem_of(read) == nullptr);
        const Picture& picture = std::get<Picture>(read);
        INFO("data from " << data.min.x << ", " << data.min.y);
        REQUIRE(picture.size == PictureSize{8, 6});
        bool all = true;
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 8; ++x) {
                const Imath::V2i place(x - 2, y + 1);
                const float expected = data.intersects(place) ? number(place.x, place.y) : 0;
                all = all && picture.linear[3 * picture.pixel(x, y)] == expected;
                all =
                    all && (expected == 0 || picture.linear[3 * picture.pixel(x, y) + 2] == expected + 0.5f);
            }
        CHECK(all);
    }
}

TEST_CASE("an EXR may be tiled, but every tile must exist", "[image][bad-input]") {
    const TemporaryDirectory directory;
    const std::string path = directory.path("tiles.exr");
    std::vector<float> stored;
    for (int i = 0; i < 3 * 5 * 3; ++i) stored.push_back(static_cast<float>(i) / 4);
    // 3 x 2 tiles of 2 x 2, and one each of 2 x 1 and of 1 x 1.
    for (const auto& [levels, tiles] :
         {std::pair{Imf::ONE_LEVEL, std::size_t{6}}, std::pair{Imf::MIPMAP_LEVELS, std::size_t{8}}}) {
        Imf::Header header(5, 3);
        for (const char* const name : {"R", "G", "B"})
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        header.setTileDescription(Imf::TileDescription(2, 2, levels));
        {
            Imf::FrameBuffer frame;
            for (std::size_t c = 0; c < 3; ++c)
                frame.insert(std::string(1, "RGB"[c]),
                             Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(stored.data() + c), 12, 60));
            Imf::TiledOutputFile file(path.c_str(), header);
            file.setFrameBuffer(frame);
            for (int level = 0; level < file.numLevels(); ++level)
                file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
        }
        const auto read = read_exr(path);
        REQUIRE(problem_of(read) == nullptr);
        CHECK(std::get<Picture>(read).linear == stored);
        const std::string whole = bytes_of(path);
        for (std::size_t tile = 0; tile < 6; ++tile) {
            CAPTURE(tiles, tile);
            CHECK(problem_of(read_exr(directory.file("a.exr", without_block(whole, tile, tiles)))) !=
                  nullptr);
        }
    }
}
