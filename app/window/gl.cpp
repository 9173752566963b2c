#include "app/window/gl.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace glint {
namespace {

Gl loaded() {
    Gl all;
    const auto load = [&all]<class Function>(Function& function, const char* name) {
        function = reinterpret_cast<Function>(glfwGetProcAddress(name));
        all.complete = all.complete && function != nullptr;
    };
    load(all.gen_textures, "glGenTextures");
    load(all.delete_textures, "glDeleteTextures");
    load(all.bind_texture, "glBindTexture");
    load(all.tex_parameter, "glTexParameteri");
    load(all.tex_image, "glTexImage2D");
    load(all.tex_sub_image, "glTexSubImage2D");
    load(all.pixel_store, "glPixelStorei");
    load(all.viewport, "glViewport");
    load(all.clear_color, "glClearColor");
    load(all.clear, "glClear");
    load(all.enable, "glEnable");
    load(all.disable, "glDisable");
    load(all.scissor, "glScissor");
    load(all.gen_framebuffers, "glGenFramebuffers");
    load(all.delete_framebuffers, "glDeleteFramebuffers");
    load(all.bind_framebuffer, "glBindFramebuffer");
    load(all.framebuffer_texture_2d, "glFramebufferTexture2D");
    load(all.blit_framebuffer, "glBlitFramebuffer");
    return all;
}

}  // namespace

const Gl& gl() {
    static const Gl all = loaded();
    return all;
}

}  // namespace glint
