#include "app/window/texture.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace glint {
namespace {

// The few functions and values of OpenGL 1.1 and 3.0 that are used. Source: the Khronos registry, gl.xml.
constexpr unsigned texture_2d = 0x0DE1, rgba = 0x1908, rgba8 = 0x8058, unsigned_byte = 0x1401,
                   nearest = 0x2600;
constexpr unsigned mag_filter = 0x2800, min_filter = 0x2801, color_buffer_bit = 0x4000,
                   unpack_row_length = 0x0CF2, scissor_test = 0x0C11, read_framebuffer = 0x8CA8,
                   color_attachment0 = 0x8CE0;

struct Gl {
    void (*gen_textures)(int, unsigned*) = nullptr;
    void (*delete_textures)(int, const unsigned*) = nullptr;
    void (*bind_texture)(unsigned, unsigned) = nullptr;
    void (*tex_parameter)(unsigned, unsigned, int) = nullptr;
    void (*tex_image)(unsigned, int, int, int, int, int, unsigned, unsigned, const void*) = nullptr;
    void (*tex_sub_image)(unsigned, int, int, int, int, int, unsigned, unsigned, const void*) = nullptr;
    void (*pixel_store)(unsigned, int) = nullptr;
    void (*viewport)(int, int, int, int) = nullptr;
    void (*clear_color)(float, float, float, float) = nullptr;
    void (*clear)(unsigned) = nullptr;
    void (*enable)(unsigned) = nullptr;
    void (*disable)(unsigned) = nullptr;
    void (*scissor)(int, int, int, int) = nullptr;
    // OpenGL 3.0:
    void (*gen_framebuffers)(int, unsigned*) = nullptr;
    void (*delete_framebuffers)(int, const unsigned*) = nullptr;
    void (*bind_framebuffer)(unsigned, unsigned) = nullptr;
    void (*framebuffer_texture_2d)(unsigned, unsigned, unsigned, unsigned, int) = nullptr;
    void (*blit_framebuffer)(int, int, int, int, int, int, int, int, unsigned, unsigned) = nullptr;
    bool complete = true;

    Gl() {
        load(gen_textures, "glGenTextures");
        load(delete_textures, "glDeleteTextures");
        load(bind_texture, "glBindTexture");
        load(tex_parameter, "glTexParameteri");
        load(tex_image, "glTexImage2D");
        load(tex_sub_image, "glTexSubImage2D");
        load(pixel_store, "glPixelStorei");
        load(viewport, "glViewport");
        load(clear_color, "glClearColor");
        load(clear, "glClear");
        load(enable, "glEnable");
        load(disable, "glDisable");
        load(scissor, "glScissor");
        load(gen_framebuffers, "glGenFramebuffers");
        load(delete_framebuffers, "glDeleteFramebuffers");
        load(bind_framebuffer, "glBindFramebuffer");
        load(framebuffer_texture_2d, "glFramebufferTexture2D");
        load(blit_framebuffer, "glBlitFramebuffer");
    }

  private:
    template <class Function> void load(Function& function, const char* name) {
        function = reinterpret_cast<Function>(glfwGetProcAddress(name));
        complete = complete && function != nullptr;
    }
};

const Gl& gl() {
    static const Gl loaded;
    return loaded;
}

}  // namespace

Texture::Texture() {
    if (!gl().complete) return;
    gl().gen_textures(1, &name_);
    gl().bind_texture(texture_2d, name_);
    gl().tex_parameter(texture_2d, min_filter, nearest);
    gl().tex_parameter(texture_2d, mag_filter, nearest);
}

Texture::~Texture() {
    if (frame_ != 0) gl().delete_framebuffers(1, &frame_);
    if (name_ != 0) gl().delete_textures(1, &name_);
}

void Texture::upload(const Picture& picture) {
    gl().bind_texture(texture_2d, name_);
    gl().pixel_store(unpack_row_length, 0);
    const int width = picture.size.width, height = picture.size.height;
    if (size_ == picture.size)
        gl().tex_sub_image(texture_2d, 0, 0, 0, width, height, rgba, unsigned_byte, picture.rgba.data());
    else
        gl().tex_image(texture_2d, 0, int(rgba8), width, height, 0, rgba, unsigned_byte, picture.rgba.data());
    size_ = picture.size;
}

void Texture::copy_to_window(const PixelRect& to, const PixelRect& clip, int height) {
    if (size_.width <= 0 || to.right <= to.left || to.bottom <= to.top) return;
    if (frame_ == 0) gl().gen_framebuffers(1, &frame_);
    gl().bind_framebuffer(read_framebuffer, frame_);
    gl().framebuffer_texture_2d(read_framebuffer, color_attachment0, texture_2d, name_, 0);
    gl().enable(scissor_test);
    gl().scissor(clip.left, height - clip.bottom, std::max(clip.right - clip.left, 0),
                 std::max(clip.bottom - clip.top, 0));
    // The picture's first row is its top, a framebuffer's its bottom.
    gl().blit_framebuffer(0, 0, size_.width, size_.height, to.left, height - to.top, to.right,
                          height - to.bottom, color_buffer_bit, nearest);
    gl().disable(scissor_test);
    gl().bind_framebuffer(read_framebuffer, 0);
}

void clear_framebuffer(int width, int height, float red, float green, float blue) {
    gl().viewport(0, 0, width, height);
    gl().clear_color(red, green, blue, 1);
    gl().clear(color_buffer_bit);
}

}  // namespace glint
