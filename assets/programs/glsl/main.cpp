// @title@
//
// Draws the scene with OpenGL 3.3: this file places lights, objects and camera, scene.vert and scene.frag are
// the shaders, and lighting.glsl is the lighting equation. In the window, drag with the mouse to orbit.
//
// build: g++ -std=c++17 -O2 -o picture main.cpp -lglfw -lGL
// run: ./picture
// build offscreen: g++ -std=c++17 -O2 -DOFFSCREEN -o picture main.cpp -lOSMesa
// run offscreen: ./picture
//
// Needs a C++17 compiler and GLFW (Debian: libglfw3-dev). The offscreen build writes picture.ppm and needs
// OSMesa (libosmesa6-dev) instead of GLFW. The program reads its shaders and @mesh_files@
// Colours are linear red, green, blue. Lighting is computed in camera coordinates: the eye is at the origin
// and looks along -z, x is right, y up.
//@can mode.phong spot.soft mode.facet mode.flat flat.centroid exposure exponent.large lights.above_8 shininess.large shininess.zero
//@can corners.clamped interpolation.screen tone power_table two_sided transfer.srgb wrong.no_clamp_of_cosine wrong.half_lambert
//@can wrong.unnormalized_half wrong.half_angle_with_phong_shininess wrong.reflect_sign wrong.reflect_of_difference

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#ifdef OFFSCREEN
#include <GL/osmesa.h>
#else
#include <GLFW/glfw3.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

//@include scene.cpp
// ---- Lights ----
//@if reflection.lit
//@if wrong.lit_in_srgb
double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }
vec3 srgb(vec3 c) { return {srgb(c.x), srgb(c.y), srgb(c.z)}; }
//@end
//@include lights.cpp
//@end
//@include meshes.cpp
// ---- OpenGL ----
GLuint program;  // the shaders

std::string text_of(const char* name) {
    FILE* file = std::fopen(name, "rb");
    if (!file) std::exit(std::fprintf(stderr, "%s cannot be read: run the program in its folder\n", name));
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;) text += char(c);
    std::fclose(file);
    return text;
}
/// Compiles a shader, preceded by the file `first`.
void add_shader(GLenum kind, const char* first, const char* name) {
    const std::string text = "#version 330 core\n" + (*first ? text_of(first) : "") + text_of(name);
    const char* const begin = text.c_str();
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &begin, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    char log[1000] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    if (!ok) std::exit(std::fprintf(stderr, "%s: %s\n", name, log));
    glAttachShader(program, shader);
}
GLint place_of(const std::string& uniform) { return glGetUniformLocation(program, uniform.c_str()); }
void set(const std::string& uniform, int x) { glUniform1i(place_of(uniform), x); }
void set(const std::string& uniform, double x) { glUniform1f(place_of(uniform), float(x)); }
void set(const std::string& uniform, vec3 v) {
    glUniform3f(place_of(uniform), float(v.x), float(v.y), float(v.z));
}
void set(const std::string& uniform, const mat4& m) {
    float numbers[16];
    for (int i = 0; i < 16; ++i) numbers[i] = float(m.m[i / 4][i % 4]);
    glUniformMatrix4fv(place_of(uniform), 1, GL_TRUE, numbers);  // transposed: OpenGL stores columns
}

/// The graphics card's data for an object.
struct Placed {
    const Object* object;
    GLuint vertices = 0;
    GLsizei count = 0;
    //@if reflection.lit
    Material material;
    //@end
    //@if sides|wrong.mirror_turns_inside_out|mirrored
    bool mirrored;  // a transform with a negative determinant reverses the winding
    //@end
};
std::vector<Placed> placed;

/// Sends a mesh's triangles to the card: for each corner its position, normal, the point to be lit, and colour.
void upload(Placed& o, const Mesh& mesh) {
    std::vector<float> numbers;
    const auto add = [&numbers](vec3 v) { numbers.insert(numbers.end(), {float(v.x), float(v.y), float(v.z)}); };
    //@if normals.flip
    const Object& object = *o.object;
    //@end
//@include side.cpp
    for (const Triangle& t : mesh.triangles) {
        const std::vector<Corner>& face = mesh.faces[t.face];
        //@if flat_centroid
        vec3 centroid, color;
        for (const Corner& c : face) {
            centroid = centroid + (1.0 / face.size()) * mesh.positions[c.position];
            color = color + (1.0 / face.size()) * (mesh.colors.empty() ? vec3{1, 1, 1} : mesh.colors[c.position]);
        }
        //@end
        for (int corner : t.corner) {
            const Corner& c = face[corner];
            add(mesh.positions[c.position]);
            //@if facet_normals_alone
            @const_n@vec3 n = facet_normal(mesh, face);
            //@else
            //@if wrong.cross_reversed
            // (the mesh file's averaged normals come from reversed facet normals)
            //@end
            @const_n@vec3 n = mesh.normals[c.normal];
            //@end
            //@if wrong.no_normals_given
            n = {0, 0, 1};
            //@end
            //@if wrong.some_faces_flipped
            if (t.face % 3 == 0) n = -1 * n;
            //@end
            add(@side@n);
            //@if flat_centroid
            add(centroid);
            add(color);
            //@else
            add(mesh.positions[c.position]);
            add(mesh.colors.empty() ? vec3{1, 1, 1} : mesh.colors[c.position]);
            //@end
        }
    }
    GLuint buffer = 0;
    glGenVertexArrays(1, &o.vertices);
    glBindVertexArray(o.vertices);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(numbers.size() * sizeof(float)), numbers.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 4; ++i) {
        const auto offset = static_cast<std::size_t>(i) * 3 * sizeof(float);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 12 * sizeof(float), reinterpret_cast<void*>(offset));
        glEnableVertexAttribArray(i);
    }
    o.count = GLsizei(numbers.size() / 12);
}

void prepare() {
    program = glCreateProgram();
    //@if lights_pixels
    add_shader(GL_VERTEX_SHADER, "", "scene.vert");
    add_shader(GL_FRAGMENT_SHADER, "lighting.glsl", "scene.frag");
    //@else
    //@if reflection.lit
    add_shader(GL_VERTEX_SHADER, "lighting.glsl", "scene.vert");
    //@else
    add_shader(GL_VERTEX_SHADER, "", "scene.vert");
    //@end
    add_shader(GL_FRAGMENT_SHADER, "", "scene.frag");
    //@end
    glLinkProgram(program);
    glUseProgram(program);
    for (const Object& object : objects) {
        Placed o;
        o.object = &object;
        //@if sides|wrong.mirror_turns_inside_out|mirrored
        o.mirrored = object.scale.x * object.scale.y * object.scale.z < 0;
        //@end
        upload(o, read_mesh(object.mesh));
//@include material.cpp
        placed.push_back(o);
    }
    glEnable(GL_DEPTH_TEST);  // at equal depth, the first face drawn stays
    //@if cull.back
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    //@end
    //@if cull.front
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    //@end
}

void draw() {
    const mat4 view = view_from_world();
    glViewport(0, 0, width, height);
    @clear_color@
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set("clip_from_camera", clip_from_view());
    //@if wrong.viewer_at_origin_of_world
    set("origin_of_world", moved(view, {}, 1));
    //@end
    //@if wrong.lit_after_projection
    set("projection", clip_from_view());
    //@end
    //@if reflection.lit
    set("global_ambient", global_ambient);
    sources.clear();
    place_lights(view);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string light = "lights[" + std::to_string(i) + "].";
        set(light + "kind", sources[i].kind);
        set(light + "position", sources[i].position);
        set(light + "ambient", sources[i].ambient);
        set(light + "diffuse", sources[i].diffuse);
        set(light + "specular", sources[i].specular);
        //@if light.falloff
        set(light + "constant", sources[i].constant);
        set(light + "linear", sources[i].linear);
        set(light + "quadratic", sources[i].quadratic);
        //@end
        //@if light.spot
        set(light + "direction", sources[i].direction);
        set(light + "cutoff_deg", sources[i].cutoff_deg);
        set(light + "exponent", sources[i].exponent);
        //@if spot.soft
        set(light + "inner_deg", sources[i].inner_deg);
        //@end
        //@end
        //@if light.area
        set(light + "edge_u", sources[i].edge_u);
        set(light + "edge_v", sources[i].edge_v);
        set(light + "cells", sources[i].cells);
        //@end
    }
    //@end
    for (Placed& o : placed) {
        const Object& object = *o.object;
        const mat4 to_camera = view * transform(object.translate, object.rotate_deg, object.scale);
        set("camera_from_object", to_camera);
        //@if reflection.lit
//@include normals.cpp
        set("for_normals", for_normals);
        set("material.ambient", o.material.ambient);
        set("material.diffuse", o.material.diffuse);
        set("material.specular", o.material.specular);
        //@if terms.emission
        set("material.emission", o.material.emission);
        //@end
        //@if uses.shininess
        set("material.shininess", o.material.shininess);
        //@end
        //@if uses.roughness
        set("material.roughness", o.material.roughness);
        //@end
        //@if uses.f0
        set("material.f0", o.material.f0);
        //@end
        //@if models.several
        set("material.model", o.material.model);
        //@end
        //@end
        //@if mirrored
        glFrontFace(o.mirrored ? GL_CW : GL_CCW);
        //@end
        glBindVertexArray(o.vertices);
        glDrawArrays(GL_TRIANGLES, 0, o.count);
    }
}

#ifdef OFFSCREEN
int main() {
    const int wanted[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
    std::vector<unsigned char> rgba(4 * std::size_t(width) * height);
    const OSMesaContext context = OSMesaCreateContextAttribs(wanted, nullptr);
    if (!OSMesaMakeCurrent(context, rgba.data(), GL_UNSIGNED_BYTE, width, height)) return 1;
    prepare();
    draw();
    glFinish();
    FILE* file = std::fopen("picture.ppm", "wb");
    if (!file) return 1;
    std::fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height - 1; y >= 0; --y)  // OpenGL's first row is the bottom one
        for (int x = 0; x < width; ++x) std::fwrite(&rgba[4 * (std::size_t(y) * width + x)], 1, 3, file);
    return std::fclose(file);
}
#else
/// Orbits the eye around the target: sideways about `up`, and up or down.
void orbit(double to_side, double upwards) {
    const vec3 w = eye - target, u = unit(cross(up, w)), v = unit(up);
    const vec3 turned = std::cos(to_side) * w + std::sin(to_side) * cross(v, w) +
                        ((1 - std::cos(to_side)) * dot(v, w)) * v;
    const vec3 side = std::cos(to_side) * u + std::sin(to_side) * cross(v, u);
    const vec3 tilted = std::cos(upwards) * turned + std::sin(upwards) * cross(side, turned);
    if (length(cross(unit(tilted), v)) > 0.05) eye = target + tilted;  // stays short of the pole
}

int main() {
    if (!glfwInit()) return 1;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(width, height, "@window_title@", nullptr, nullptr);
    if (!window) return 1;
    glfwMakeContextCurrent(window);
    prepare();
    double x = 0, y = 0, last_x = 0, last_y = 0;
    bool dragging = false;  // whether the button was down in the previous frame
    while (!glfwWindowShouldClose(window)) {
        glfwGetCursorPos(window, &x, &y);
        if (dragging) orbit((last_x - x) / 200, (last_y - y) / 200);
        dragging = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
        last_x = x;
        last_y = y;
        draw();
        glfwSwapBuffers(window);
        glfwWaitEventsTimeout(0.1);
    }
    glfwTerminate();
}
#endif
