#include <gif_lib.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "renderer/image/image_file.h"

namespace glint {
namespace {

constexpr int colours = 256;

int append(GifFileType* file, const GifByteType* bytes, int count) {
    static_cast<std::string*>(file->UserData)
        ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
}

/// A picture as numbers of its colours.
struct Indexed {
    std::unordered_map<std::uint32_t, GifByteType> number_of;
    std::vector<GifByteType> index;  // of each pixel
};

/// A picture of no more colours than a GIF can hold, each of them as it is; of more, nothing.
std::optional<Indexed> exactly(const Picture& picture, std::size_t pixels) {
    Indexed out;
    out.index.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* const rgb = &picture.rgba[4 * i];
        const std::uint32_t colour = rgb[0] << 16 | rgb[1] << 8 | rgb[2];
        if (out.number_of.size() == colours && !out.number_of.contains(colour)) return {};
        out.index[i] =
            out.number_of.try_emplace(colour, static_cast<GifByteType>(out.number_of.size())).first->second;
    }
    return out;
}

struct FreeMap {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, FreeMap>;

}  // namespace

struct GifWriter::Encoder {
    PictureSize size;
    std::string bytes;
    GifFileType* file = nullptr;
    bool failed = false;

    void check(int result) { failed |= result != GIF_OK; }

    /// "Repeat for ever", as Netscape's extension says it.
    void loop_extension() {
        static constexpr GifByteType forever[] = {1, 0, 0};
        check(EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file, sizeof forever, forever));
        check(EGifPutExtensionTrailer(file));
    }

    void begin() {
        int error = 0;
        file = EGifOpen(&bytes, append, &error);
        if (file == nullptr) {
            failed = true;
            return;
        }
        EGifSetGifVersion(file, true);
        check(EGifPutScreenDesc(file, size.width, size.height, 8, 0, nullptr));
        loop_extension();
    }

    void delay(int hundredths) {
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
        GifByteType block[4];
        EGifGCBToExtension(&control, block);
        check(EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, sizeof block, block));
    }

    /// The nearest of 256 colours that are chosen for the picture.
    std::vector<GifByteType> quantised(const Picture& picture, ColorMapObject& map) {
        const std::size_t count = size.pixels();
        std::vector<GifByteType> red(count), green(count), blue(count), index(count);
        for (std::size_t i = 0; i < count; ++i) {
            red[i] = picture.rgba[4 * i];
            green[i] = picture.rgba[4 * i + 1];
            blue[i] = picture.rgba[4 * i + 2];
        }
        int used = colours;
        check(GifQuantizeBuffer(static_cast<unsigned>(size.width), static_cast<unsigned>(size.height), &used,
                                red.data(), green.data(), blue.data(), index.data(), map.Colors));
        return index;
    }

    void frame(const Picture& picture, int hundredths) {
        const ColorMap map(GifMakeMapObject(colours, nullptr));
        failed |= !map;
        if (failed) return;
        std::vector<GifByteType> index;
        // The library's choice tells 32 steps of a channel apart, which greys need not suffer.
        if (auto exact = exactly(picture, size.pixels())) {
            for (const auto& [colour, number] : exact->number_of)
                map->Colors[number] = {static_cast<GifByteType>(colour >> 16),
                                       static_cast<GifByteType>(colour >> 8),
                                       static_cast<GifByteType>(colour)};
            index = std::move(exact->index);
        } else {
            index = quantised(picture, *map);
        }
        delay(hundredths);
        check(EGifPutImageDesc(file, 0, 0, size.width, size.height, false, map.get()));
        for (int y = 0; y < size.height && !failed; ++y)
            check(EGifPutLine(file, &index[size.index(0, y)], size.width));
    }
};

GifWriter::GifWriter(PictureSize size)
    : encoder_(std::make_unique<Encoder>(Encoder{size, {}, nullptr, false})) {
    encoder_->begin();
}

GifWriter::~GifWriter() {
    int error = 0;
    if (encoder_->file != nullptr) EGifCloseFile(encoder_->file, &error);
}

bool GifWriter::add(const Picture& picture, int hundredths) {
    if (!encoder_->failed) encoder_->frame(picture, hundredths);
    return !encoder_->failed;
}

Result<std::string> GifWriter::finish() {
    int error = 0;
    if (encoder_->file != nullptr && EGifCloseFile(std::exchange(encoder_->file, nullptr), &error) != GIF_OK)
        encoder_->failed = true;
    if (encoder_->failed) return Problem{"", "", "the GIF does not fit in memory", "fewer or smaller frames"};
    return std::move(encoder_->bytes);
}

}  // namespace glint
