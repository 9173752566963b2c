// @title@
//
// Draws the scene as OpenGL 1 does: the calls are the lecture's, and the lighting equation is the built-in
// one. Drag with the mouse to orbit.
//
// build: gcc -std=c99 -O2 -o picture main.c -lglfw -lGLU -lGL -lm
// run: ./picture
// build offscreen: gcc -std=c99 -O2 -DOFFSCREEN -o picture main.c -lOSMesa -lGLU -lm
// run offscreen: ./picture
//
// Needs a C compiler, GLU (Debian: libglu1-mesa-dev) and GLFW (libglfw3-dev). The offscreen build writes
// picture.ppm and needs OSMesa (libosmesa6-dev) instead of GLFW. The program reads @mesh_files@
//@can mode.flat reflection.blinn-phong reflection.lambert reflection.none

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glu.h>
#ifdef OFFSCREEN
#include <GL/osmesa.h>
#else
#include <GLFW/glfw3.h>
#endif

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct { float x, y, z; } vec3;

// ---- The scene ----
const int width = @width@, height = @height@;
@camera@
//@if reflection.lit
const vec3 global_ambient = @global_ambient@;
enum Space { world, camera };
enum Kind { directional, point, spot };
typedef struct {
    enum Kind kind;
    enum Space space;
    vec3 position;  // for a directional light, the direction towards it
    vec3 ambient, diffuse, specular;
    float intensity;
    //@if light.falloff
    float constant, linear, quadratic;  // falloff 1 / (constant + linear r + quadratic r^2)
    //@end
    //@if light.spot
    vec3 direction;             // where a spot points
    float cutoff_deg, exponent;  // cutoff: from the axis to the edge of the cone
    //@end
} Light;
@lights@
typedef struct {
    vec3 ambient, diffuse, specular;  // k_a, k_d, k_s
    //@if terms.emission
    vec3 emission;  // k_e
    //@end
    //@if uses.shininess
    float shininess;
    //@end
} Material;
//@end
typedef struct {
    const char* mesh;
    vec3 translate, rotate_deg, scale;
    //@if normals.flip
    float side;  // -1: every normal is reversed
    //@end
    //@if reflection.lit
    Material material;
    //@end
} Object;
@objects@

// ---- Meshes ----
double number(FILE* file) {
    double x = 0;
    if (fscanf(file, "%lf", &x) != 1) exit(1);
    return x;
}
int whole(FILE* file) { return (int)number(file); }
int count(FILE* file) { return fscanf(file, "%*s") == 0 ? whole(file) : 0; }  // the number after a word
void* room(size_t how_many, size_t size) {
    void* memory = calloc(how_many + 1, size);
    if (!memory) exit(1);
    return memory;
}
vec3* vectors(FILE* file, int* how_many) {
    *how_many = count(file);
    vec3* all = room((size_t)*how_many, sizeof *all);
    for (int i = 0; i < *how_many; ++i) {
        all[i].x = (float)number(file);
        all[i].y = (float)number(file);
        all[i].z = (float)number(file);
    }
    return all;
}

/// Sends the triangles of a mesh file, in object coordinates: for each corner its normal, then its position.
void send_mesh(const Object* object) {
    FILE* file = fopen(object->mesh, "r");
    if (!file) exit(fprintf(stderr, "%s cannot be read: run the program in its folder\n", object->mesh));
    int positions_count, normals_count, colors_count;
    vec3* positions = vectors(file, &positions_count);
    vec3* normals = vectors(file, &normals_count);
    vec3* colors = vectors(file, &colors_count);
    const int faces = count(file);
    int** face = room((size_t)faces, sizeof *face);  // position and normal of each corner, in turn
    for (int f = 0; f < faces; ++f) {
        const int corners = whole(file);
        face[f] = room(2 * (size_t)corners, sizeof **face);
        for (int i = 0; i < 2 * corners; ++i) face[f][i] = whole(file);
    }
    const int triangles = count(file);
    glBegin(GL_TRIANGLES);
    for (int t = 0; t < triangles; ++t) {
        const int* corners = face[whole(file)];
        for (int i = 0; i < 3; ++i) {
            const int* corner = corners + 2 * whole(file);
            //@if reflection.lit
            //@if wrong.no_normals_given
            // (no glNormal3f: the normal keeps its initial value, (0, 0, 1))
            //@else
            const vec3 n = normals[corner[1]];
            //@if normals.flip|wrong.normals_flipped
            float side = 1;
            //@if normals.flip
            side = object->side;
            //@end
            //@if wrong.normals_flipped
            side = -side;
            //@end
            glNormal3f(side * n.x, side * n.y, side * n.z);
            //@else
            glNormal3f(n.x, n.y, n.z);
            //@end
            //@end
            //@else
            const vec3 white = {1, 1, 1}, c = colors_count > 0 ? colors[corner[0]] : white;
            glColor3f(c.x, c.y, c.z);
            //@end
            const vec3 p = positions[corner[0]];
            glVertex3f(p.x, p.y, p.z);
        }
    }
    glEnd();
    for (int f = 0; f < faces; ++f) free(face[f]);
    free(face);
    free(positions);
    free(normals);
    free(colors);
    fclose(file);
}

//@if reflection.lit
// ---- Lights ----
/// A colour as OpenGL expects it: four numbers, valid until the next call to rgb().
const float* rgb(float factor, vec3 c) {
    static float color[4];
    color[0] = factor * c.x;
    color[1] = factor * c.y;
    color[2] = factor * c.z;
    color[3] = 1;
    return color;
}

/// Topic: light sources. OpenGL transforms a light's position and direction by the current model-view matrix.
void place_lights(enum Space space) {
    //@if wrong.light_in_wrong_space
    space = space == world ? camera : world;
    //@end
    for (int i = 0; lights[i]; ++i) {
        const Light* l = lights[i];
        if (l->space != space) continue;
        const GLenum light = GL_LIGHT0 + (GLenum)i;
        //@calls light_place
        const float position[] = {l->position.x, l->position.y, l->position.z, l->kind == directional ? 0 : 1};
        glLightfv(light, GL_POSITION, position);  // w = 0: a direction
        //@if light.spot
        const float direction[] = {l->direction.x, l->direction.y, l->direction.z};
        glLightfv(light, GL_SPOT_DIRECTION, direction);
        //@end
        //@calls light
        glLightfv(light, GL_AMBIENT, rgb(l->intensity, l->ambient));
        glLightfv(light, GL_DIFFUSE, rgb(l->intensity, l->diffuse));
        glLightfv(light, GL_SPECULAR, rgb(l->intensity, l->specular));
        //@if light.falloff
        // Topic: falloff with distance.
        glLightf(light, GL_CONSTANT_ATTENUATION, l->constant);
        glLightf(light, GL_LINEAR_ATTENUATION, l->linear);
        glLightf(light, GL_QUADRATIC_ATTENUATION, l->quadratic);
        //@end
        //@if light.spot
        // Topic: spot lights. A cutoff of 180 degrees means no cone.
        glLightf(light, GL_SPOT_CUTOFF, l->kind == spot ? l->cutoff_deg : 180);
        glLightf(light, GL_SPOT_EXPONENT, l->kind == spot ? l->exponent : 0);
        //@end
        glEnable(light);
        //@calls
    }
}

const vec3 black = {0, 0, 0};
/// Topic: materials. How much of each colour the surface reflects.
void use_material(const Material* m) {
    //@calls material
    //@if terms.emission
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, rgb(1, m->emission));
    //@else
    glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, rgb(1, black));
    //@end
    //@if terms.ambient
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, rgb(1, m->ambient));
    //@else
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, rgb(1, black));
    //@end
    //@if terms.diffuse
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, rgb(1, m->diffuse));
    //@else
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, rgb(1, black));
    //@end
    //@if uses.shininess
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, rgb(1, m->specular));
    //@if shininess.capped
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, fminf(m->shininess, 128));  // OpenGL's maximum
    //@else
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, m->shininess);
    //@end
    //@else
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, rgb(1, black));
    //@end
    //@calls
}

//@end
// ---- The picture ----
GLuint first_list;  // the first of the display lists, one per object

void prepare(void) {
    //@calls shading
    glEnable(GL_DEPTH_TEST);  // at equal depth, the first face drawn stays
    //@if mode.flat
    glShadeModel(GL_FLAT);  // Topic: flat shading. A triangle has the colour of its last corner
    //@else
    glShadeModel(GL_SMOOTH);  // Topic: Gouraud shading. The corners' colours are interpolated
    //@end
    //@if reflection.lit
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);  // glScalef changes the length of normals
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, rgb(1, global_ambient));
    //@if viewer.infinite
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_FALSE);  // v = (0, 0, 1) everywhere
    //@else
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);  // v points to the eye
    //@end
    //@if two_sided
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);  // seen from behind, the normal is reversed
    //@end
    //@if !corners.clamped
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);  // OpenGL 3; OpenGL 1 clamps the corners' colours to 1
    //@end
    //@end
    //@if cull.back
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    //@end
    //@if cull.front
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    //@end
    //@calls
    first_list = glGenLists(sizeof objects / sizeof *objects);
    for (int i = 0; objects[i]; ++i) {
        glNewList(first_list + (GLuint)i, GL_COMPILE);
        send_mesh(objects[i]);
        glEndList();
    }
}

void draw(void) {
    glViewport(0, 0, width, height);
    @clear_color@
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    //@calls camera
    // Topic: projection.
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    //@if projection.frustum
    glFrustum(left, right, bottom, top, near, far);
    //@else
    const double aspect = (double)width / height;
    //@if projection.orthographic
    glOrtho(-view_height * aspect / 2, view_height * aspect / 2, -view_height / 2.0, view_height / 2.0, near, far);
    //@else
    gluPerspective(fov_y_deg, aspect, near, far);
    //@end
    //@end

    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    //@if light.camera&reflection.lit|wrong.light_in_wrong_space
    place_lights(camera);  // before gluLookAt: these lights stay with the viewer
    //@end
    // Topic: the view matrix.
    gluLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, up.x, up.y, up.z);
    //@if light.world&reflection.lit|wrong.light_in_wrong_space
    place_lights(world);  // after gluLookAt: these lights stay with the scene
    //@end
    //@calls

    for (int i = 0; objects[i]; ++i) {
        const Object* o = objects[i];
        //@calls object
        //@if reflection.lit
        use_material(&o->material);
        //@end
        glPushMatrix();
        // Topic: modelling transforms. The last one written is the first one applied.
        glTranslatef(o->translate.x, o->translate.y, o->translate.z);
        glRotatef(o->rotate_deg.z, 0, 0, 1);
        glRotatef(o->rotate_deg.y, 0, 1, 0);
        glRotatef(o->rotate_deg.x, 1, 0, 0);
        glScalef(o->scale.x, o->scale.y, o->scale.z);
        //@if mirrored
        glFrontFace(o->scale.x * o->scale.y * o->scale.z < 0 ? GL_CW : GL_CCW);
        //@end
        glCallList(first_list + (GLuint)i);
        glPopMatrix();
        //@calls
    }
}

#ifdef OFFSCREEN
int main(void) {
    const size_t bytes = 4 * (size_t)width * (size_t)height;
    unsigned char* rgba = room(bytes, 1);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
    if (!OSMesaMakeCurrent(context, rgba, GL_UNSIGNED_BYTE, width, height)) return 1;
    prepare();
    draw();
    glFinish();
    FILE* file = fopen("picture.ppm", "wb");
    if (!file) return 1;
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height - 1; y >= 0; --y)  // OpenGL's first row is the bottom one
        for (int x = 0; x < width; ++x) fwrite(&rgba[4 * ((size_t)y * (size_t)width + (size_t)x)], 1, 3, file);
    return fclose(file);
}
#else
/// Turns v about the unit axis a (Rodrigues).
vec3 turned(vec3 v, vec3 a, double angle) {
    const float c = (float)cos(angle), s = (float)sin(angle), d = (1 - c) * (a.x * v.x + a.y * v.y + a.z * v.z);
    const vec3 w = {c * v.x + s * (a.y * v.z - a.z * v.y) + d * a.x, c * v.y + s * (a.z * v.x - a.x * v.z) + d * a.y,
                    c * v.z + s * (a.x * v.y - a.y * v.x) + d * a.z};
    return w;
}
vec3 unit(vec3 v) {
    const float r = sqrtf(v.x * v.x + v.y * v.y + v.z * v.z);
    const vec3 u = {v.x / r, v.y / r, v.z / r};
    return u;
}
/// Orbits the eye around the target: sideways about `up`, and up or down.
void orbit(double to_side, double upwards) {
    const vec3 from_target = {eye.x - target.x, eye.y - target.y, eye.z - target.z}, v = unit(up);
    vec3 w = turned(from_target, v, to_side);
    const vec3 across = {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
    w = turned(w, unit(across), upwards);
    const vec3 u = unit(w);
    if (fabsf(u.x * v.x + u.y * v.y + u.z * v.z) > 0.998f) return;  // stays short of the pole
    eye.x = target.x + w.x;
    eye.y = target.y + w.y;
    eye.z = target.z + w.z;
}

int main(void) {
    if (!glfwInit()) return 1;
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(width, height, "@window_title@", NULL, NULL);
    if (!window) return 1;
    glfwMakeContextCurrent(window);
    prepare();
    double x = 0, y = 0, last_x = 0, last_y = 0;
    int dragging = 0;  // whether the button was down in the previous frame
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
    return 0;
}
#endif
