#include "app/window/texture.h"

#include <algorithm>

#include "app/window/gl.h"

namespace glint {

using namespace gl_value;

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

Texture::Texture(Use use) : use_(use) {
    if (!gl().complete) return;
    gl().gen_textures(1, &name_);
    gl().bind_texture(texture_2d, name_);
    gl().tex_parameter(texture_2d, min_filter, int(gl_value::nearest));
    gl().tex_parameter(texture_2d, mag_filter, int(gl_value::nearest));
}

Texture::~Texture() {
    if (framebuffer_ != 0) gl().delete_framebuffers(1, &framebuffer_);
    if (name_ != 0) gl().delete_textures(1, &name_);
}

void Texture::allocate(PictureSize size) {
    if (size_ == size) return;
    gl().bind_texture(texture_2d, name_);
    // GL chooses how it keeps the channels of unsized RGBA, and follows the order of what is uploaded.
    const bool for_copies = use_ == Use::Copied;
    gl().tex_image(texture_2d, 0, int(for_copies ? rgba : rgba8), size.width, size.height, 0,
                   for_copies ? bgra : rgba, unsigned_byte, nullptr);
    size_ = size;
}

void Texture::upload(const Picture& picture) {
    allocate(picture.size);
    upload(picture, {0, 0, size_.width, size_.height}, 0, 0);
}

void Texture::upload(const Picture& picture, const PixelRect& part, int left, int top) {
    gl().bind_texture(texture_2d, name_);
    gl().pixel_store(unpack_row_length, picture.size.width);
    gl().pixel_store(unpack_skip_pixels, part.left);
    gl().pixel_store(unpack_skip_rows, part.top);
    gl().tex_sub_image(texture_2d, 0, left + part.left, top + part.top, part.width(), part.height(), rgba,
                       unsigned_byte, picture.rgba.data());
    for (const unsigned name : {unpack_row_length, unpack_skip_pixels, unpack_skip_rows})
        gl().pixel_store(name, 0);  // as ImGui's backend takes it to be
}

unsigned Texture::framebuffer() {
    if (framebuffer_ == 0) {
        gl().gen_framebuffers(1, &framebuffer_);
        gl().bind_framebuffer(read_framebuffer, framebuffer_);
        gl().framebuffer_texture_2d(read_framebuffer, color_attachment0, texture_2d, name_, 0);
    }
    return framebuffer_;
}

}  // namespace glint
