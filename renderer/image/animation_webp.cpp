// Writes animations as lossless WebP with libwebp and libwebpmux.
#include <webp/encode.h>
#include <webp/mux.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "renderer/image/animation_file.h"

namespace glint {
namespace {

/// 0 to 9. The next higher level reduces file size by a tenth and takes one and a half times as long.
constexpr int effort = 2;

struct DeleteEncoder {
    void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};
using Encoder = std::unique_ptr<WebPAnimEncoder, DeleteEncoder>;

/// An empty libwebp picture.
struct Frame {
    WebPPicture picture;
    Frame() { WebPPictureInit(&picture); }
    ~Frame() { WebPPictureFree(&picture); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
};

Encoder encoder_for(PictureSize size) {
    WebPAnimEncoderOptions options;  // loops endlessly by default
    WebPAnimEncoderOptionsInit(&options);
    return Encoder(WebPAnimEncoderNew(size.width, size.height, &options));
}

class WebPWriter final : public AnimationWriter {
  public:
    WebPWriter(PictureSize size, int frames_a_second)
        : frames_a_second_(frames_a_second), encoder_(encoder_for(size)) {
        WebPConfigInit(&config_);
        WebPConfigLosslessPreset(&config_, effort);
    }

    std::optional<Problem> add(const Picture& picture) override {
        Frame frame;
        frame.picture.use_argb = 1;
        frame.picture.width = picture.size.width;
        frame.picture.height = picture.size.height;
        if (!encoder_ ||
            !WebPPictureImportRGBX(&frame.picture, picture.rgba.data(), 4 * picture.size.width) ||
            !WebPAnimEncoderAdd(encoder_.get(), &frame.picture, begin_of(frame_++), &config_))
            return no_memory();
        return {};
    }

    Result<std::string> finish() override {
        WebPData data;
        WebPDataInit(&data);
        const bool whole = encoder_ &&
                           WebPAnimEncoderAdd(encoder_.get(), nullptr, begin_of(frame_), nullptr) &&
                           WebPAnimEncoderAssemble(encoder_.get(), &data);
        const std::unique_ptr<WebPData, decltype(&WebPDataClear)> freed(&data, WebPDataClear);
        if (!whole) return no_memory();
        return std::string(reinterpret_cast<const char*>(data.bytes), data.size);
    }

  private:
    static Problem no_memory() {
        return {"", "", "the WebP does not fit in memory", "fewer or smaller frames"};
    }
    /// The frame's start time in milliseconds.
    [[nodiscard]] int begin_of(int frame) const { return 1000 * frame / frames_a_second_; }

    int frames_a_second_, frame_ = 0;
    WebPConfig config_;
    Encoder encoder_;
};

}  // namespace

std::unique_ptr<AnimationWriter> webp_writer(PictureSize size, int frames_a_second) {
    return std::make_unique<WebPWriter>(size, frames_a_second);
}

}  // namespace glint
