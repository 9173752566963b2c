const double pi = 3.14159265358979323846;

// ---- Vectors and matrices ----
struct vec3 { double x = 0, y = 0, z = 0; };
vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }  // colours: channel by channel
vec3 operator*(double s, vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
//@if uses.f0
vec3 operator-(double s, vec3 a) { return {s - a.x, s - a.y, s - a.z}; }
//@end
double dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec3 cross(vec3 a, vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// a / b, or 0 for b = 0.
double over(double a, double b) { return b == 0 ? 0 : a / b; }
double length(vec3 a) { return std::sqrt(dot(a, a)); }
vec3 unit(vec3 a) { return over(1, length(a)) * a; }

struct mat4 { double m[4][4]; };  // m[row][column]
mat4 operator*(const mat4& a, const mat4& b) {
    mat4 c = {};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) c.m[i][j] += a.m[i][k] * b.m[k][j];
    return c;
}
const mat4 identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
double row(const mat4& m, int i, vec3 a, double w) {
    return m.m[i][0] * a.x + m.m[i][1] * a.y + m.m[i][2] * a.z + m.m[i][3] * w;
}
/// w = 1 moves a point, w = 0 a direction.
vec3 moved(const mat4& m, vec3 a, double w) { return {row(m, 0, a, w), row(m, 1, a, w), row(m, 2, a, w)}; }
double radians(double degrees) { return degrees * pi / 180; }

// ---- The scene ----
const int width = @width@, height = @height@;
@camera@
const vec3 background = @background@;
//@if reflection.lit
const vec3 global_ambient = @global_ambient@;
enum Space { world, camera };
enum Kind { directional, point, spot, area };
struct Light {
    Kind kind;
    Space space;
    vec3 position;  // for a directional light, the direction towards it
    vec3 ambient, diffuse, specular;
    double intensity;
    //@if light.falloff
    double constant, linear, quadratic;  // falloff 1 / (constant + linear r + quadratic r^2)
    //@end
    //@if light.spot
    vec3 direction;             // where a spot points
    double cutoff_deg, exponent;  // cutoff: from the axis to the edge of the cone
    //@if spot.soft
    double inner_deg;  // where the soft edge begins
    //@end
    //@end
    //@if light.area
    vec3 edge_u, edge_v;  // half-edges of an area light
    int cells;            // its samples are cells x cells points
    //@end
};
@lights@
//@if models.several
const int @model_numbers@;
//@end
struct Material {
    vec3 ambient, diffuse, specular;  // k_a, k_d, k_s
    //@if terms.emission
    vec3 emission;  // k_e
    //@end
    //@if uses.shininess
    double shininess;
    //@end
    //@if uses.roughness
    double roughness;
    //@end
    //@if uses.f0
    vec3 f0;
    //@end
    //@if models.several
    int model;
    //@end
};
//@end
struct Object {
    const char* mesh;
    vec3 translate, rotate_deg, scale;
    //@if normals.flip
    double side;  // -1: every normal is reversed
    //@end
    //@if reflection.lit
    Material material;
    //@end
};
@objects@

// ---- Camera ----
/// Topic: the view matrix. Its rows are the camera's axes u (right), v (up), w (backwards).
mat4 view_from_world() {
    const vec3 w = unit(eye - target), u = unit(cross(up, w)), v = cross(w, u);
    return {{{u.x, u.y, u.z, -dot(u, eye)}, {v.x, v.y, v.z, -dot(v, eye)},
             {w.x, w.y, w.z, -dot(w, eye)}, {0, 0, 0, 1}}};
}
//@if wrong.light_by_inverse_view
mat4 world_from_view() {
    const vec3 w = unit(eye - target), u = unit(cross(up, w)), v = cross(w, u);
    return {{{u.x, v.x, w.x, eye.x}, {u.y, v.y, w.y, eye.y}, {u.z, v.z, w.z, eye.z}, {0, 0, 0, 1}}};
}
//@end

/// Topic: projection. The window on the near plane becomes -1 to 1 in x and y.
mat4 clip_from_view() {
    //@if projection.frustum
    const double w = right - left, h = top - bottom, depth = far - near;
    return {{{2 * near / w, 0, (right + left) / w, 0},
             {0, 2 * near / h, (top + bottom) / h, 0},
             {0, 0, -(far + near) / depth, -2 * far * near / depth}, {0, 0, -1, 0}}};
    //@else
    const double aspect = double(width) / height, depth = far - near;
    //@if projection.orthographic
    const double top = view_height / 2;
    return {{{1 / (top * aspect), 0, 0, 0}, {0, 1 / top, 0, 0},
             {0, 0, -2 / depth, -(far + near) / depth}, {0, 0, 0, 1}}};
    //@else
    const double f = 1 / std::tan(radians(fov_y_deg) / 2);
    return {{{f / aspect, 0, 0, 0}, {0, f, 0, 0},
             {0, 0, -(far + near) / depth, -2 * far * near / depth}, {0, 0, -1, 0}}};
    //@end
    //@end
}

