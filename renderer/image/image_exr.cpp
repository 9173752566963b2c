// Writes OpenEXR files with the OpenEXR library.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include "renderer/image/exr_stream.h"
#include "renderer/image/image_file.h"

namespace glint {

std::string exr_bytes(const Picture& picture, float exposure) {
    std::vector<float> numbers(picture.linear.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = exposed(picture.linear[i], exposure);

    Imf::Header header(picture.size.width, picture.size.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const std::size_t pixel = 3 * sizeof(float), row = pixel * static_cast<std::size_t>(picture.size.width);
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        frame.insert(names[c],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(numbers.data() + c), pixel, row));
    }
    ExrSink out;
    {
        Imf::OutputFile file(out, header, 0);  // the line offset table is written when the file is closed
        file.setFrameBuffer(frame);
        file.writePixels(picture.size.height);
    }
    return std::move(out.bytes);
}

}  // namespace glint
