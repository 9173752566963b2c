#include "shader/shader_canvas.h"

#define EGL_NO_X11  // excludes Xlib's macros
#define MESA_EGL_NO_X11_HEADERS
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace glint {
namespace {

/// A part of a shader with the number of its first line.
std::string numbered(int first_line, std::string_view text) {
    return fmt::format("#line {}\n{}\n", first_line, text);
}

/// is_ok() returns whether a shader or program has this status, and log_of() returns its log. Each takes
/// OpenGL's functions for shaders or for programs.
template <class GetNumber> bool is_ok(GLuint name, GLenum status, GetNumber get_number) {
    GLint ok = GL_FALSE;
    get_number(name, status, &ok);
    return ok == GL_TRUE;
}
template <class GetNumber, class GetLog>
std::string log_of(GLuint name, GetNumber get_number, GetLog get_log) {
    GLint length = 0;
    get_number(name, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(name, static_cast<GLsizei>(text.size()), nullptr, text.data());
    return text.c_str();
}

/// An OpenGL shader or program, deleted on destruction.
class Shader {
  public:
    Shader(GLenum kind, const std::string& text) : name_(glCreateShader(kind)) {
        const std::string all = "#version 330 core\n" + text;
        const char* const begin = all.c_str();
        const auto length = static_cast<GLint>(all.size());
        glShaderSource(name_, 1, &begin, &length);
        glCompileShader(name_);
    }
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] bool is_compiled() const { return is_ok(name_, GL_COMPILE_STATUS, glGetShaderiv); }
    [[nodiscard]] std::string log() const { return log_of(name_, glGetShaderiv, glGetShaderInfoLog); }

  private:
    GLuint name_;
};

enum Attachment : GLuint { Shown, Raw, RawP, RawN, Attachments };

/// The number of attachments that an output needs, starting with the first. Every output includes Raw, from
/// which faulty pixels are found.
GLuint attachments_of(ShaderOutput output) { return output == ShaderOutput::All ? Attachments : RawP; }

class GlProgram {
  public:
    GlProgram(const Shader& vertex, const Shader& fragment) : name_(glCreateProgram()) {
        glAttachShader(name_, vertex.name());
        glAttachShader(name_, fragment.name());
        glBindFragDataLocation(name_, Shown, "shown");
        glBindFragDataLocation(name_, Raw, "raw");
        glBindFragDataLocation(name_, RawP, "raw_p");
        glBindFragDataLocation(name_, RawN, "raw_n");
        glLinkProgram(name_);
    }
    ~GlProgram() { glDeleteProgram(name_); }
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] bool is_linked() const { return is_ok(name_, GL_LINK_STATUS, glGetProgramiv); }
    [[nodiscard]] std::string log() const { return log_of(name_, glGetProgramiv, glGetProgramInfoLog); }

  private:
    GLuint name_;
};

GLenum type_of(const Uniform& uniform) {
    constexpr std::array<GLenum, 4> types{GL_INT, GL_FLOAT, GL_FLOAT_VEC3, GL_FLOAT_MAT4};
    return types[uniform.value.index()];
}
const char* text_of(GLenum type) {
    switch (type) {
    case GL_INT:
        return "int";
    case GL_FLOAT:
        return "float";
    case GL_FLOAT_VEC3:
        return "vec3";
    case GL_FLOAT_MAT4:
        return "mat4";
    default:
        return "of a different type";
    }
}

void set(GLuint program, const std::vector<Uniform>& uniforms) {
    for (const Uniform& uniform : uniforms) {
        const GLint place = glGetUniformLocation(program, uniform.name.c_str());  // -1 is ignored
        if (const auto* i = std::get_if<int>(&uniform.value)) glUniform1i(place, *i);
        if (const auto* f = std::get_if<float>(&uniform.value)) glUniform1f(place, *f);
        if (const auto* v = std::get_if<glm::vec3>(&uniform.value)) glUniform3fv(place, 1, &v->x);
        if (const auto* m = std::get_if<glm::mat4>(&uniform.value))
            glUniformMatrix4fv(place, 1, GL_FALSE, &(*m)[0].x);
    }
}

/// Reports uniforms of the program that the scene does not set, or sets with a different type.
void check_uniforms(GLuint program, const ShaderScene& scene, std::vector<ShaderMessage>& messages) {
    std::map<std::string, GLenum> types;
    for (const Uniform& uniform : scene.uniforms) types[uniform.name] = type_of(uniform);
    if (!scene.objects.empty())
        for (const Uniform& uniform : scene.objects[0].uniforms) types[uniform.name] = type_of(uniform);
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()), nullptr, &size,
                           &type, name.data());
        const auto known = types.find(name.data());
        if (known == types.end())
            messages.push_back({false, 0, fmt::format("the uniform {} is not set", name.data())});
        else if (known->second != type)
            messages.push_back({true, 0,
                                fmt::format("the uniform {} is {}; expected {}", name.data(), text_of(type),
                                            text_of(known->second))});
    }
}

/// The buffers that a picture is drawn into.
class Framebuffer {
  public:
    Framebuffer(PictureSize size, GLuint attachments) : size_(size), attachments_(attachments) {
        glGenFramebuffers(1, &name_);
        glBindFramebuffer(GL_FRAMEBUFFER, name_);
        glGenRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        for (GLuint i = 0; i < attachments; ++i)
            attach(i, GL_COLOR_ATTACHMENT0 + i, i == Shown ? GL_RGBA8 : GL_RGBA32F);
        attach(Attachments, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
        constexpr std::array<GLenum, Attachments> drawn{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                        GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};
        glDrawBuffers(static_cast<GLsizei>(attachments), drawn.data());
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("OpenGL has no memory for the picture");
    }
    ~Framebuffer() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &name_);
        glDeleteRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    void clear(const ShaderScene& scene) const {
        const auto fill = [](GLint attachment, const glm::vec3& c, float alpha) {
            const std::array<float, 4> value{c.r, c.g, c.b, alpha};
            glClearBufferfv(GL_COLOR, attachment, value.data());
        };
        fill(Shown, scene.shown_background, 1);
        fill(Raw, scene.background, 0);
        for (GLuint i = RawP; i < attachments_; ++i) fill(static_cast<GLint>(i), glm::vec3(0), 0);
        constexpr float far = 1;
        glClearBufferfv(GL_DEPTH, 0, &far);
    }
    /// Four numbers per pixel, top row first.
    template <class Number>
    [[nodiscard]] std::vector<Number> read(GLuint attachment, GLenum type, PictureSize size) const {
        const std::size_t row = 4 * static_cast<std::size_t>(size.width);
        std::vector<Number> numbers(4 * size.pixels());
        glReadBuffer(GL_COLOR_ATTACHMENT0 + attachment);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, size.width, size.height, GL_RGBA, type, numbers.data());
        auto top = numbers.begin();
        for (auto bottom = numbers.end(); top < bottom - static_cast<std::ptrdiff_t>(row);
             top += static_cast<std::ptrdiff_t>(row)) {
            bottom -= static_cast<std::ptrdiff_t>(row);
            if (top < bottom) std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
        }
        return numbers;
    }

  private:
    void attach(GLuint index, GLenum attachment, GLenum format) const {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers_[index]);
        glRenderbufferStorage(GL_RENDERBUFFER, format, size_.width, size_.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffers_[index]);
    }

    PictureSize size_;
    GLuint attachments_;
    GLuint name_ = 0;
    std::array<GLuint, Attachments + 1> buffers_{};
};

/// The pixels whose fourth number `is` accepts.
template <class Is> PixelFinding pixels_where(const std::vector<float>& raw, PictureSize size, const Is& is) {
    PixelFinding found;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (is(&raw[4 * size.index(x, y)])) found.add({x, y});
    return found;
}

/// The first three of every four numbers.
std::vector<float> without_fourth(const std::vector<float>& numbers) {
    std::vector<float> three;
    three.reserve(numbers.size() / 4 * 3);
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        three.insert(three.end(), {numbers[i], numbers[i + 1], numbers[i + 2]});
    return three;
}

bool is_finite(const float* color) {
    return std::all_of(color, color + 3, [](float c) { return std::isfinite(c); });
}

}  // namespace

struct ShaderCanvas::Parts {
    /// A mesh in OpenGL's memory.
    struct Uploaded {
        CornerNumbers numbers;  // keeps the key valid
        GLuint vertices = 0, buffer = 0;
    };
    std::unique_ptr<GlProgram> program;
    std::unique_ptr<GlProgram> covering;  // without the user's code; only if that can discard pixels
    std::map<const std::vector<float>*, Uploaded> meshes;

    [[nodiscard]] GLuint vertices_of(const CornerNumbers& numbers);
    void forget_meshes_except(const ShaderScene& scene);
    void draw(GLuint name, const ShaderScene& scene);
};

GLuint ShaderCanvas::Parts::vertices_of(const CornerNumbers& numbers) {
    Uploaded& mesh = meshes[numbers.get()];
    if (mesh.vertices != 0) return mesh.vertices;
    mesh.numbers = numbers;
    glGenVertexArrays(1, &mesh.vertices);
    glBindVertexArray(mesh.vertices);
    glGenBuffers(1, &mesh.buffer);
    glBindBuffer(GL_ARRAY_BUFFER, mesh.buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers->size() * sizeof(float)), numbers->data(),
                 GL_STATIC_DRAW);
    for (GLuint i = 0; i < 4; ++i) {
        const auto offset = std::size_t{i} * 3 * sizeof(float);
        glVertexAttribPointer(
            i, 3, GL_FLOAT, GL_FALSE, numbers_per_corner * sizeof(float),
            reinterpret_cast<const void*>(offset));  // NOLINT: an offset, for historical reasons
        glEnableVertexAttribArray(i);
    }
    return mesh.vertices;
}

void ShaderCanvas::Parts::forget_meshes_except(const ShaderScene& scene) {
    std::set<const std::vector<float>*> used;
    for (const ShaderObject& object : scene.objects) used.insert(object.corners.get());
    std::erase_if(meshes, [&used](const auto& mesh) {
        if (used.contains(mesh.first)) return false;
        glDeleteVertexArrays(1, &mesh.second.vertices);
        glDeleteBuffers(1, &mesh.second.buffer);
        return true;
    });
}

void ShaderCanvas::Parts::draw(GLuint name, const ShaderScene& scene) {
    glUseProgram(name);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);  // at equal depth, the first one drawn stays
    if (scene.cull != Cull::None) {
        glEnable(GL_CULL_FACE);
        glCullFace(scene.cull == Cull::Back ? GL_BACK : GL_FRONT);
    }
    set(name, scene.uniforms);
    for (const ShaderObject& object : scene.objects) {
        set(name, object.uniforms);
        glFrontFace(object.is_mirrored ? GL_CW : GL_CCW);
        glBindVertexArray(vertices_of(object.corners));
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(object.corners->size() / numbers_per_corner));
    }
    glBindVertexArray(0);
    glUseProgram(0);
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

ShaderCanvas::ShaderCanvas() : parts_(std::make_unique<Parts>()) {}

ShaderCanvas::~ShaderCanvas() { parts_->forget_meshes_except({}); }

ShaderLog ShaderCanvas::compile(const ShaderScene& scene, std::string_view text) {
    const ShaderStages& stages = scene.stages;
    const std::string lighting =
        numbered(first_line_before, stages.before) + numbered(1, prepared_shader(text));
    const auto stage = [&](const std::string& own, bool lights) {
        return (lights ? lighting : "") + numbered(first_line_after, own);
    };
    const Shader vertex(GL_VERTEX_SHADER, stage(stages.vertex, !stages.lights_pixels));
    const Shader fragment(GL_FRAGMENT_SHADER, stage(stages.fragment, stages.lights_pixels));
    const Shader& lit = stages.lights_pixels ? fragment : vertex;
    const int lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) + !text.ends_with('\n');
    ShaderLog log;
    log.messages = shader_messages(lit.log(), lines);
    if (!vertex.is_compiled() || !fragment.is_compiled()) {
        if (log.messages.empty())
            log.messages.push_back({true, 0, "the shader does not compile: " + lit.log()});
        return log;
    }
    auto program = std::make_unique<GlProgram>(vertex, fragment);
    if (!program->is_linked()) {
        for (ShaderMessage& message : shader_messages(program->log(), lines))
            log.messages.push_back(std::move(message));
        if (log.messages.empty())
            log.messages.push_back({true, 0, "the shader does not link: " + program->log()});
        return log;
    }
    check_uniforms(program->name(), scene, log.messages);
    log.is_compiled = std::none_of(log.messages.begin(), log.messages.end(),
                                   [](const ShaderMessage& message) { return message.is_error; });
    if (!log.is_compiled) return log;
    parts_->program = std::move(program);
    parts_->covering.reset();
    if (stages.lights_pixels && text.find("discard") != text.npos) {
        const Shader covering(GL_FRAGMENT_SHADER, "out vec4 raw;\nvoid main() { raw = vec4(1.0); }\n");
        parts_->covering = std::make_unique<GlProgram>(vertex, covering);
    }
    return log;
}

ShaderPicture ShaderCanvas::draw(const ShaderScene& scene, ShaderOutput output) {
    const PictureSize size = scene.size;
    parts_->forget_meshes_except(scene);
    const Framebuffer framebuffer(size, attachments_of(output));
    ShaderPicture out;
    const auto is_stopped = [](const float* raw) { return raw[3] > 1; };
    const auto draw_at = [&](PictureSize drawn, const GlProgram& program) {
        glViewport(0, 0, drawn.width, drawn.height);
        framebuffer.clear(scene);
        parts_->draw(program.name(), scene);
        return framebuffer.read<float>(Raw, GL_FLOAT, drawn);
    };
    // Draws a small picture first, because an endless loop takes a long time in each pixel.
    constexpr int times_smaller = 8;
    const PictureSize trial{std::max(1, size.width / times_smaller),
                            std::max(1, size.height / times_smaller)};
    out.stopped = pixels_where(draw_at(trial, *parts_->program), trial, is_stopped);
    out.stopped.first *= times_smaller;
    if (out.stopped.count > 0) return out;

    const std::vector<float> raw = draw_at(size, *parts_->program);
    out.stopped = pixels_where(raw, size, is_stopped);
    if (out.stopped.count > 0) return out;
    out.not_finite = pixels_where(raw, size, [](const float* color) { return !is_finite(color); });
    const auto is_drawn = [](const float* color) { return color[3] > 0; };
    const auto is_bright = [&](const float* color) {
        return is_drawn(color) && !(color[0] <= 0 && color[1] <= 0 && color[2] <= 0);
    };
    out.is_black =
        pixels_where(raw, size, is_drawn).count > 0 && pixels_where(raw, size, is_bright).count == 0;
    out.picture.size = size;
    out.picture.rgba = framebuffer.read<std::uint8_t>(Shown, GL_UNSIGNED_BYTE, size);
    for (std::size_t i = 0; i < raw.size(); i += 4) {
        const bool is_nan = std::any_of(&raw[i], &raw[i] + 3, [](float c) { return std::isnan(c); });
        if (is_nan) std::fill_n(&out.picture.rgba[i], 3, std::uint8_t{0});
        out.picture.rgba[i + 3] = 255;
    }
    if (output == ShaderOutput::All) out.picture.linear = without_fourth(raw);
    if (output == ShaderOutput::All && scene.stages.lights_pixels) {
        out.positions = without_fourth(framebuffer.read<float>(RawP, GL_FLOAT, size));
        out.normals = without_fourth(framebuffer.read<float>(RawN, GL_FLOAT, size));
    }
    if (parts_->covering) {
        std::vector<float> covered = draw_at(size, *parts_->covering);
        for (std::size_t i = 3; i < covered.size(); i += 4) covered[i] -= raw[i];
        out.discarded = pixels_where(covered, size, [](const float* c) { return c[3] > 0; });
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("OpenGL reports the error {:#x}", error));
    return out;
}

// Source: EGL 1.5; EGL_MESA_platform_surfaceless, EGL_KHR_surfaceless_context, EGL_KHR_no_config_context.
OffscreenContext::OffscreenContext() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        throw std::runtime_error("EGL cannot draw without a window; expected Mesa's EGL");
    display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
        throw std::runtime_error("EGL cannot be initialized; expected a driver such as Mesa's");
    constexpr std::array<EGLint, 7> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context_ == EGL_NO_CONTEXT ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
        eglTerminate(display_);
        throw std::runtime_error("the driver does not support OpenGL 3.3 without a window");
    }
}

OffscreenContext::~OffscreenContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

}  // namespace glint
