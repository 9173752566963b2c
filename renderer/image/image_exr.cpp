// OpenEXR, by its own library.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include "renderer/image/image_file.h"

namespace glint {
namespace {

/// A file in memory.
class Bytes : public Imf::OStream {
  public:
    Bytes() : OStream("picture") {}
    void write(const char c[], int n) override {
        const auto size = static_cast<std::size_t>(n);
        if (at_ + size > bytes.size()) bytes.resize(at_ + size);
        bytes.replace(at_, size, c, size);
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = position; }

    std::string bytes;

  private:
    std::size_t at_ = 0;
};

}  // namespace

std::string exr_bytes(const Picture& picture, float exposure) {
    std::vector<float> exposed(picture.linear.size());
    for (std::size_t i = 0; i < exposed.size(); ++i) exposed[i] = picture.linear[i] * exposure;

    Imf::Header header(picture.size.width, picture.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const std::size_t pixel = 3 * sizeof(float), row = pixel * static_cast<std::size_t>(picture.size.width);
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        frame.insert(names[c],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(exposed.data() + c), pixel, row));
    }
    Bytes out;
    {
        Imf::OutputFile file(out, header, 0);  // the table of lines is written when the file is closed
        file.setFrameBuffer(frame);
        file.writePixels(picture.size.height);
    }
    return std::move(out.bytes);
}

}  // namespace glint
