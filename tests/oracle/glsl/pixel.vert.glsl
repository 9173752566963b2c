// Passes on position and normal. The position is always perspective-correct, because it is the surface's own.
smooth out vec3 place;
INTERPOLATED out vec3 normal;

void main() {
    gl_Position = ftransform();
    place = (gl_ModelViewMatrix * gl_Vertex).xyz;
    normal = normalize(gl_NormalMatrix * gl_Normal);
}
