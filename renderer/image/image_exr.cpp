// OpenEXR, by its own library.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <new>

#include "renderer/image/exr_stream.h"
#include "renderer/image/image_file.h"

namespace glint {
namespace {

/// Whether no block of lines is missing. The library reports no error where memory runs out in its tasks or
/// while it closes a file.
bool is_whole(const std::string& bytes) {
    ExrSource source(bytes);
    return Imf::InputFile(source, 0).isComplete();
}

}  // namespace

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
        Imf::OutputFile file(out, header, 0);  // the table of lines is written when the file is closed
        file.setFrameBuffer(frame);
        file.writePixels(picture.size.height);
    }
    if (!is_whole(out.bytes)) throw std::bad_alloc();
    return std::move(out.bytes);
}

}  // namespace glint
