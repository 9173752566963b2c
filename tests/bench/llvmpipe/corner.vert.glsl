// Gouraud and flat: every vertex is lit once, and the colour is interpolated or that of the last corner.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view_from_object, clip_from_view;
uniform mat3 normal_matrix;
VARYING out vec3 color;

void main() {
    vec4 p = view_from_object * vec4(position, 1);
    gl_Position = clip_from_view * p;
    color = lit(p.xyz, normalize(normal_matrix * normal));
}
