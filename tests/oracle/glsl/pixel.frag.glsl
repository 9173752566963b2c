// Lights the pixel.
uniform bool two_sided;
smooth in vec3 place;
INTERPOLATED in vec3 normal;

void main() {
    vec3 n = normalize(normal);
    gl_FragColor = vec4(lit(place, two_sided && !gl_FrontFacing ? -n : n), 1);
}
