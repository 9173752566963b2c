// Phong, and the G-buffer's first pass.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view_from_object, clip_from_view;
uniform mat3 normal_matrix;
out vec3 place, n;

void main() {
    vec4 p = view_from_object * vec4(position, 1);
    gl_Position = clip_from_view * p;
    place = p.xyz;
    n = normalize(normal_matrix * normal);
}
