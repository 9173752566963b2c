#include "tests/oracle/gl_canvas.h"

#include <GL/gl.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace glint::oracle {
namespace {

template <class Channel>
GlPicture<Channel> draw_into(void* context, GLenum type, PictureSize size,
                             const std::function<void()>& draw) {
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    GlPicture<Channel> picture{size, std::vector<Channel>(4 * width * height)};
    auto* osmesa = static_cast<OSMesaContext>(context);
    if (!OSMesaMakeCurrent(osmesa, picture.rgba.data(), type, size.width, size.height))
        throw std::runtime_error("OSMesa cannot draw into this buffer");
    glViewport(0, 0, size.width, size.height);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    draw();
    glFinish();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL reports error " + std::to_string(error));
    // OpenGL's first row is the bottom one.
    const auto row = static_cast<std::ptrdiff_t>(4 * width);
    for (std::size_t y = 0; y < height / 2; ++y) {
        const auto upper = picture.rgba.begin() + static_cast<std::ptrdiff_t>(y) * row;
        const auto lower = picture.rgba.begin() + static_cast<std::ptrdiff_t>(height - 1 - y) * row;
        std::swap_ranges(upper, upper + row, lower);
    }
    return picture;
}

}  // namespace

GlCanvas::GlCanvas() {
    const std::array<int, 7> wanted{
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    context_.reset(OSMesaCreateContextAttribs(wanted.data(), nullptr));
    if (!context_) throw std::runtime_error("OSMesa provides no OpenGL context");
}

void GlCanvas::Destroy::operator()(void* context) const {
    OSMesaDestroyContext(static_cast<OSMesaContext>(context));
}

GlCanvas::~GlCanvas() = default;

GlPicture<float> GlCanvas::floats(PictureSize size, const std::function<void()>& draw) {
    return draw_into<float>(context_.get(), GL_FLOAT, size, draw);
}

GlPicture<std::uint8_t> GlCanvas::bytes(PictureSize size, const std::function<void()>& draw) {
    return draw_into<std::uint8_t>(context_.get(), GL_UNSIGNED_BYTE, size, draw);
}

std::string GlCanvas::description() {
    std::string text;
    (void)bytes({1, 1}, [&text] {
        for (const GLenum name : {GL_VERSION, GL_RENDERER}) {
            if (!text.empty()) text += ", ";
            text += reinterpret_cast<const char*>(glGetString(name));
        }
    });
    return text;
}

}  // namespace glint::oracle
