#pragma once
// The few functions and values of OpenGL 1.1 and 3.0 that the window uses, loaded through GLFW: the program
// links none. Source: the Khronos registry, gl.xml.

namespace glint {

namespace gl_value {
inline constexpr unsigned texture_2d = 0x0DE1, rgba = 0x1908, rgba8 = 0x8058, bgra = 0x80E1,
                          unsigned_byte = 0x1401, nearest = 0x2600, mag_filter = 0x2800, min_filter = 0x2801,
                          color_buffer_bit = 0x4000, unpack_row_length = 0x0CF2, unpack_skip_rows = 0x0CF3,
                          unpack_skip_pixels = 0x0CF4, scissor_test = 0x0C11, read_framebuffer = 0x8CA8,
                          draw_framebuffer = 0x8CA9, color_attachment0 = 0x8CE0;
}

/// OpenGL's functions; null where the driver lacks one.
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
};

/// Precondition at the first call: a GL context is current.
[[nodiscard]] const Gl& gl();

}  // namespace glint
