// Animations as files, read back by giflib and libwebp.
#include <gif_lib.h>
#include <webp/demux.h>

#include <cstdlib>

#include "models/scene_file/scene_file.h"
#include "renderer/image/image_file.h"
#include "renderer/renderer.h"
#include "tests/places.h"
#include "tests/support/catch.h"

using namespace glint;

namespace {

std::string file_of(AnimationFormat format, const std::vector<Picture>& pictures, int frames_a_second) {
    auto made = animation_writer(format, pictures.front().size, frames_a_second);
    REQUIRE(problem_of(made) == nullptr);
    AnimationWriter& writer = *std::get<std::unique_ptr<AnimationWriter>>(made);
    for (const Picture& picture : pictures) REQUIRE_FALSE(writer.add(picture));
    auto bytes = writer.finish();
    REQUIRE(problem_of(bytes) == nullptr);
    return std::get<std::string>(std::move(bytes));
}

/// A GIF as decoded by the library.
struct GifRead {
    explicit GifRead(std::string bytes) : rest(std::move(bytes)) {
        int error = 0;
        file = DGifOpen(this, read, &error);
        REQUIRE(file != nullptr);
        REQUIRE(DGifSlurp(file) == GIF_OK);
    }
    GifRead(const GifRead&) = delete;
    GifRead& operator=(const GifRead&) = delete;
    ~GifRead() {
        int error = 0;
        DGifCloseFile(file, &error);
    }
    [[nodiscard]] Picture frame(int number) const {
        const SavedImage& image = file->SavedImages[number];
        Picture picture;
        picture.size = {image.ImageDesc.Width, image.ImageDesc.Height};
        for (std::size_t i = 0; i < picture.size.pixels(); ++i) {
            const GifColorType& colour = image.ImageDesc.ColorMap->Colors[image.RasterBits[i]];
            picture.rgba.insert(picture.rgba.end(), {colour.Red, colour.Green, colour.Blue, 255});
        }
        return picture;
    }
    /// In hundredths of a second.
    [[nodiscard]] int delay(int number) const {
        GraphicsControlBlock control;
        REQUIRE(DGifSavedExtensionToGCB(file, number, &control) == GIF_OK);
        return control.DelayTime;
    }
    static int read(GifFileType* from, GifByteType* to, int count) {
        auto& self = *static_cast<GifRead*>(from->UserData);
        const auto taken =
            self.rest.copy(reinterpret_cast<char*>(to), static_cast<std::size_t>(count), self.at);
        self.at += taken;
        return static_cast<int>(taken);
    }
    std::string rest;
    std::size_t at = 0;
    GifFileType* file = nullptr;
};

/// A picture whose colours are given by a function of x and y.
template <class Colour> Picture painted(int width, int height, Colour colour) {
    Picture picture;
    picture.size = {width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [red, green, blue] = colour(x, y);
            picture.rgba.insert(picture.rgba.end(),
                                {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                 static_cast<std::uint8_t>(blue), 255});
        }
    return picture;
}

Picture still_life(float candle) {
    auto opened = open_document(project_file("assets/scenes/still-life.json"));
    REQUIRE(problem_of(opened) == nullptr);
    Scene scene = std::get<SceneDocument>(std::move(opened)).scene;
    scene.lights[1].intensity = candle;
    return Renderer().render(scene, {400, 300}, false, 4);
}

/// The signed differences between the bytes of two pictures.
std::vector<int> errors(const Picture& a, const Picture& b) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    std::vector<int> out(a.rgba.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = int(a.rgba[i]) - int(b.rgba[i]);
    return out;
}

/// The mean of the absolute values, over red, green and blue; alpha is 0.
double mean_size(const std::vector<int>& errors) {
    double sum = 0;
    for (const int error : errors) sum += std::abs(error);
    return sum / (0.75 * double(errors.size()));
}

/// The same for the means of all 8x8 windows, which excludes noise that the eye averages out.
double mean_size_of_windows(const std::vector<int>& errors, PictureSize size, int margin) {
    constexpr int side = 8;
    double sum = 0;
    int count = 0;
    for (int y = margin; y + side + margin <= size.height; ++y)
        for (int x = margin; x + side + margin <= size.width; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                int window = 0;
                for (int row = 0; row < side; ++row)
                    for (int column = 0; column < side; ++column)
                        window += errors[4 * size.index(x + column, y + row) + channel];
                sum += std::abs(window) / double(side * side);
                ++count;
            }
    return sum / count;
}

}  // namespace

TEST_CASE("a GIF repeats forever, and a second of its frames takes exactly one second", "[image]") {
    const int speed = GENERATE(1, 7, 24, 35, 49, 50);
    CAPTURE(speed);
    std::vector<Picture> pictures;
    for (int frame = 0; frame < speed; ++frame)
        pictures.push_back(painted(5, 3, [&](int x, int y) {
            return std::array{5 * frame, 10 * x, 20 * y};
        }));
    const std::string bytes = file_of(AnimationFormat::Gif, pictures, speed);
    CHECK(bytes.substr(0, 6) == "GIF89a");
    CHECK(bytes.find("NETSCAPE2.0") != std::string::npos);
    const GifRead read(bytes);
    REQUIRE(read.file->ImageCount == speed);
    CHECK(read.file->SWidth == 5);
    CHECK(read.file->SHeight == 3);
    int sum = 0;
    for (int frame = 0; frame < speed; ++frame) {
        CHECK(read.frame(frame).rgba == pictures[static_cast<std::size_t>(frame)].rgba);
        CHECK(std::abs(read.delay(frame) - 100.0 / speed) < 1);
        sum += read.delay(frame);
    }
    CHECK(sum == 100);
}

TEST_CASE("a GIF frame with 256 colours keeps each of them exactly", "[image]") {
    const Picture greys = painted(256, 2, [](int x, int) { return std::array{x, x, x}; });
    const Picture scattered = painted(256, 1, [](int x, int) {
        return std::array{x, 37 * x % 256, 255 - x / 2};
    });
    CHECK(GifRead(file_of(AnimationFormat::Gif, {greys}, 25)).frame(0).rgba == greys.rgba);
    CHECK(GifRead(file_of(AnimationFormat::Gif, {scattered}, 25)).frame(0).rgba == scattered.rgba);
    // With one more colour, the others are off by at most one step.
    Picture more = greys;
    more.rgba[0] = 255;
    const auto lost = errors(GifRead(file_of(AnimationFormat::Gif, {more}, 25)).frame(0), more);
    CHECK(*std::max_element(lost.begin(), lost.end()) <= 1);
    CHECK(*std::min_element(lost.begin(), lost.end()) >= -1);
}

TEST_CASE("a GIF dithers a gradient without visible steps", "[image]") {
    // 65536 colours for 256 entries: without dithering, a window is off by about 4 levels.
    const Picture gradient = painted(256, 256, [](int x, int y) { return std::array{x, y, 128}; });
    const auto lost = errors(GifRead(file_of(AnimationFormat::Gif, {gradient}, 25)).frame(0), gradient);
    CHECK(mean_size_of_windows(lost, gradient.size, 16) < 0.4);  // the margin cannot be dithered fully
}

TEST_CASE("a GIF of still-life is within a level of the picture and does not flicker", "[image]") {
    const std::vector<Picture> pictures{still_life(0.8f), still_life(0.78f)};
    const GifRead read(file_of(AnimationFormat::Gif, pictures, 25));
    const auto first = errors(read.frame(0), pictures[0]), second = errors(read.frame(1), pictures[1]);
    CHECK(mean_size(first) < 1);
    CHECK(mean_size_of_windows(first, pictures[0].size, 0) < 0.3);
    std::vector<int> change(first.size());
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = second[i] - first[i];
    CHECK(mean_size(change) < 0.6);
}

TEST_CASE("a WebP has exactly the colours of its pictures and repeats forever", "[image]") {
    std::vector<Picture> pictures{still_life(0.8f), still_life(0.78f)};
    pictures.push_back(painted(400, 300, [](int x, int y) {
        return std::array{x % 256, y % 256, x * y % 256};
    }));
    const std::string bytes = file_of(AnimationFormat::WebP, pictures, 7);
    const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
    const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
        WebPAnimDecoderNew(&data, nullptr), WebPAnimDecoderDelete);
    REQUIRE(decoder);
    WebPAnimInfo info;
    REQUIRE(WebPAnimDecoderGetInfo(decoder.get(), &info));
    CHECK(info.loop_count == 0);
    CHECK(info.frame_count == 3);
    const int ends[] = {142, 285, 428};  // in milliseconds
    for (std::size_t frame = 0; frame < 3; ++frame) {
        std::uint8_t* rgba = nullptr;
        int end = 0;
        REQUIRE(WebPAnimDecoderGetNext(decoder.get(), &rgba, &end));
        CHECK(end == ends[frame]);
        CHECK(std::equal(pictures[frame].rgba.begin(), pictures[frame].rgba.end(),
                         rgba));  // a failure prints no numbers
    }
}

TEST_CASE("an animation that is too large for WebP is refused before it is drawn", "[image]") {
    const auto refused = animation_writer(AnimationFormat::WebP, {16384, 2}, 25);
    REQUIRE(problem_of(refused) != nullptr);
    CHECK(problem_of(refused)->text() ==
          "16384x2 is too large for WebP; expected at most 16383 pixels per side, or a GIF");
    CHECK(problem_of(animation_writer(AnimationFormat::WebP, {16383, 2}, 25)) == nullptr);
    CHECK(problem_of(animation_writer(AnimationFormat::Gif, {16384, 2}, 25)) == nullptr);
}

TEST_CASE("the extension determines the format of an animation", "[image]") {
    CHECK(animation_format("turn.GIF") == AnimationFormat::Gif);
    CHECK(animation_format("a.gif/turn.WebP") == AnimationFormat::WebP);
    CHECK_FALSE(animation_format("turn.png"));
    CHECK_FALSE(animation_format("webp"));
}
