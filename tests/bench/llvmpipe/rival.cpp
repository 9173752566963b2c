#include "tests/bench/llvmpipe/rival.h"

#include <GL/gl.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "tests/bench/llvmpipe/gl_program.h"
#include "tests/bench/llvmpipe/rival_lights.h"

namespace glint::bench {
namespace {

struct Vertex {
    glm::vec3 position, normal;
};
struct IndexedMesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Vertices numbered by first use, so that neighbours in the index list are neighbours in memory.
IndexedMesh indexed(const Mesh& mesh, const NormalOptions& options) {
    const CornerNormals normals = corner_normals(mesh, options);
    const bool shared = normals.corner.empty();
    std::vector<std::uint32_t> number(shared ? mesh.positions.size() : mesh.corner_position.size(), no_index);
    IndexedMesh out;
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t c : t.corner) {
            const std::uint32_t position = mesh.corner_position[c];
            std::uint32_t& n = number[shared ? position : c];
            if (n == no_index) {
                n = static_cast<std::uint32_t>(out.vertices.size());
                out.vertices.push_back(
                    {mesh.positions[position], normals.normals[shared ? position : normals.corner[c]]});
            }
            out.indices.push_back(n);
        }
    }
    return out;
}

GLuint texture(GLint format, GLenum layout, GLenum type, PictureSize size) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, format, size.width, size.height, 0, layout, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

GLuint target(GLuint color, GLuint depth) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL rejects the framebuffer");
    return name;
}

}  // namespace

struct Rival::Gl {
    PictureSize size;
    OSMesaContext context = nullptr;
    std::vector<std::uint8_t> window;  // OSMesa requires one; nothing is drawn there
    GLuint flat = 0, gouraud = 0, phong = 0, keep = 0, whole = 0;
    GLuint lights = 0, picture = 0, gbuffer = 0, shown = 0, kept = 0;
    GLsizei index_count = 0;
    std::vector<glm::vec4> block;

    explicit Gl(PictureSize s) : size(s) {}
    ~Gl() {
        if (context) OSMesaDestroyContext(context);
    }
    void open(int threads);
    void upload(const IndexedMesh& mesh);
    void set_lights(const Scene& scene);
    void set_view(GLuint program, const Scene& scene) const;
    void draw_mesh(GLuint program, const Scene& scene, GLuint into, const glm::vec3& background) const;
    void light_kept(const Scene& scene, bool same_view) const;
};

void Rival::Gl::open(int threads) {
    setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
    const std::array<int, 11> wanted{OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    context = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    window.resize(4 * 16 * 16);
    if (!context || !OSMesaMakeCurrent(context, window.data(), GL_UNSIGNED_BYTE, 16, 16))
        throw std::runtime_error("OSMesa provides no OpenGL 3.3 core context");
    shown = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, size);
    kept = texture(GL_RGBA32F, GL_RGBA, GL_FLOAT, size);
    const GLuint depth = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, size);
    picture = target(shown, depth);
    gbuffer = target(kept, depth);
    glBindTexture(GL_TEXTURE_2D, kept);
    glGenBuffers(1, &lights);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, lights);
    glViewport(0, 0, size.width, size.height);
    glEnable(GL_DEPTH_TEST);
}

void Rival::Gl::upload(const IndexedMesh& mesh) {
    std::array<GLuint, 2> buffer{};
    GLuint vertex_array = 0;
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glGenBuffers(2, buffer.data());
    const auto bytes = [](const auto& v) { return static_cast<GLsizeiptr>(v.size() * sizeof(v[0])); };
    glBindBuffer(GL_ARRAY_BUFFER, buffer[0]);
    glBufferData(GL_ARRAY_BUFFER, bytes(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.indices), mesh.indices.data(), GL_STATIC_DRAW);
    const char* const start = nullptr;
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), start);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), start + sizeof(glm::vec3));
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    index_count = static_cast<GLsizei>(mesh.indices.size());
}

void Rival::Gl::set_lights(const Scene& scene) {
    fill_lights(block, scene, glm::mat4(view_from_world(scene.camera)));
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(block.size() * sizeof(block[0])), block.data(),
                 GL_STREAM_DRAW);
}

void Rival::Gl::set_view(GLuint program, const Scene& scene) const {
    const glm::dmat4 view =
        view_from_world(scene.camera) * world_from_object(scene.objects.front().transform);
    const glm::mat4 view_from_object(view), projection(clip_from_view(scene.camera.projection, size));
    const glm::mat3 normal_matrix(glm::transpose(glm::inverse(glm::dmat3(view))));
    const auto at = [program](const char* name) { return glGetUniformLocation(program, name); };
    glUniformMatrix4fv(at("view_from_object"), 1, GL_FALSE, glm::value_ptr(view_from_object));
    glUniformMatrix4fv(at("clip_from_view"), 1, GL_FALSE, glm::value_ptr(projection));
    glUniformMatrix3fv(at("normal_matrix"), 1, GL_FALSE, glm::value_ptr(normal_matrix));
}

void Rival::Gl::draw_mesh(GLuint program, const Scene& scene, GLuint into,
                          const glm::vec3& background) const {
    glBindFramebuffer(GL_FRAMEBUFFER, into);
    glUseProgram(program);
    set_view(program, scene);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (scene.shading.cull == Cull::None) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
        glCullFace(scene.shading.cull == Cull::Back ? GL_BACK : GL_FRONT);
    }
    glDrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
}

void Rival::Gl::light_kept(const Scene& scene, bool same_view) const {
    const glm::vec3& background = scene.display.background;
    if (!same_view) draw_mesh(keep, scene, gbuffer, background);
    glBindFramebuffer(GL_FRAMEBUFFER, picture);
    glUseProgram(whole);
    const glm::mat4 m(clip_from_view(scene.camera.projection, size));
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    glUniform4f(glGetUniformLocation(whole, "ray"), 2 / (width * m[0][0]), 2 / (height * m[1][1]),
                (m[2][0] - 1) / m[0][0], (m[2][1] - 1) / m[1][1]);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    if (!same_view) {
        glClearColor(background.x, background.y, background.z, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Rival::Rival(const Scene& scene, PictureSize size, int threads) : gl_(std::make_unique<Gl>(size)) {
    if (scene.objects.size() != 1 || scene.shading.reflection != Reflection::BlinnPhong)
        throw std::runtime_error("the rival draws only a single object, with blinn-phong");
    Gl& gl = *gl_;
    gl.open(threads);
    gl.upload(indexed(*scene.objects.front().mesh, scene.objects.front().normals));
    const std::string counts = light_counts(scene);
    gl.flat = make_program(
        {"corner.vert.glsl", "corner.frag.glsl", counts + "#define VARYING flat\n", true, false});
    gl.gouraud = make_program(
        {"corner.vert.glsl", "corner.frag.glsl", counts + "#define VARYING smooth\n", true, false});
    gl.phong = make_program({"pixel.vert.glsl", "pixel.frag.glsl", counts, false, true});
    gl.keep = make_program({"pixel.vert.glsl", "keep.frag.glsl", "", false, false});
    gl.whole = make_program({"whole.vert.glsl", "whole.frag.glsl", counts, false, true});
}

Rival::~Rival() = default;

void Rival::draw(const Scene& scene, Way way, bool same_view) {
    Gl& gl = *gl_;
    gl.set_lights(scene);
    const ShadingMode mode = scene.shading.mode;
    if (way == Way::Deferred)
        gl.light_kept(scene, same_view);
    else
        gl.draw_mesh(mode == ShadingMode::Flat      ? gl.flat
                     : mode == ShadingMode::Gouraud ? gl.gouraud
                                                    : gl.phong,
                     scene, gl.picture, scene.display.background);
    glFinish();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL reports error " + std::to_string(error));
}

std::vector<std::uint8_t> Rival::picture() const {
    const auto row = 4 * static_cast<std::size_t>(gl_->size.width);
    const auto height = static_cast<std::size_t>(gl_->size.height);
    std::vector<std::uint8_t> rgba(row * height), flipped(row * height);
    glBindFramebuffer(GL_FRAMEBUFFER, gl_->picture);
    glReadPixels(0, 0, gl_->size.width, gl_->size.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::size_t y = 0; y < height; ++y)  // OpenGL's first row is the bottom one
        std::copy_n(rgba.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                    flipped.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * row));
    return flipped;
}

}  // namespace glint::bench
