#pragma once
// Compiles a user's lighting.glsl and draws scenes with it, using OpenGL 3.3 in the current context, which
// belongs to an OffscreenContext or a window.

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "programs/shader_scene.h"
#include "renderer/picture.h"
#include "shader/shader_text.h"

namespace glint {

struct ShaderLog {
    bool is_compiled = false;  // compiled and linked
    std::vector<ShaderMessage> messages;
};

/// The number of pixels with a property, and the first of them.
struct PixelFinding {
    std::uint64_t count = 0;
    glm::ivec2 first{0};

    void add(glm::ivec2 pixel) {
        if (count++ == 0) first = pixel;
    }
};

/// All: also the linear colours and the arguments of lit(), which take ten times as many bytes.
enum class ShaderOutput : std::uint8_t { Displayed, All };

struct ShaderPicture {
    Picture picture;  // displayed colours, NaN as black; linear ones as well if requested
    // The arguments of lit(), three numbers per pixel, if requested and if pixels are lit; 0 in the
    // background.
    std::vector<float> positions, normals;
    bool is_black = false;    // lit() returned nothing above 0
    PixelFinding not_finite;  // lit() returned NaN or an infinity
    PixelFinding discarded;
    PixelFinding stopped;  // a loop was ended after max_loop_runs; no picture in that case
};

/// All calls need the same current context. They change its state: afterwards, framebuffer, viewport,
/// program, vertex array, depth test and culling are 0 or off.
class ShaderCanvas {
  public:
    ShaderCanvas();
    ~ShaderCanvas();
    ShaderCanvas(const ShaderCanvas&) = delete;
    ShaderCanvas& operator=(const ShaderCanvas&) = delete;

    /// Compiles the text from read_shader() for a scene. After an error, the previous program remains.
    [[nodiscard]] ShaderLog compile(const ShaderScene& scene, std::string_view text);
    /// Draws with the program compiled last. Precondition: it was compiled for a scene with equal stages.
    /// Throws std::runtime_error if OpenGL fails.
    [[nodiscard]] ShaderPicture draw(const ShaderScene& scene, ShaderOutput output);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// An OpenGL 3.3 context without a window, current on this thread while it exists.
class OffscreenContext {
  public:
    /// Throws std::runtime_error if OpenGL is missing. If EGL is missing, libepoxy ends the program.
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

  private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace glint
