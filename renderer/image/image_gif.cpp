#include <gif_lib.h>

#include <cstddef>
#include <memory>
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

struct FreeMap {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMap = std::unique_ptr<ColorMapObject, FreeMap>;

}  // namespace

struct GifWriter::Encoder {
    PictureSize size;
    int hundredths;
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

    void delay() {
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
        GifByteType block[4];
        EGifGCBToExtension(&control, block);
        check(EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, sizeof block, block));
    }

    void frame(const Picture& picture) {
        const std::size_t count = size.pixels();
        std::vector<GifByteType> red(count), green(count), blue(count), index(count);
        for (std::size_t i = 0; i < count; ++i) {
            red[i] = picture.rgba[4 * i];
            green[i] = picture.rgba[4 * i + 1];
            blue[i] = picture.rgba[4 * i + 2];
        }
        const ColorMap map(GifMakeMapObject(colours, nullptr));
        int used = colours;
        failed |= !map;
        if (failed) return;
        check(GifQuantizeBuffer(static_cast<unsigned>(size.width), static_cast<unsigned>(size.height), &used,
                                red.data(), green.data(), blue.data(), index.data(), map->Colors));
        delay();
        check(EGifPutImageDesc(file, 0, 0, size.width, size.height, false, map.get()));
        for (int y = 0; y < size.height && !failed; ++y)
            check(EGifPutLine(file, &index[size.index(0, y)], size.width));
    }
};

GifWriter::GifWriter(PictureSize size, int hundredths)
    : encoder_(std::make_unique<Encoder>(Encoder{size, hundredths, {}, nullptr, false})) {
    encoder_->begin();
}

GifWriter::~GifWriter() {
    int error = 0;
    if (encoder_->file != nullptr) EGifCloseFile(encoder_->file, &error);
}

bool GifWriter::add(const Picture& picture) {
    if (!encoder_->failed) encoder_->frame(picture);
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
