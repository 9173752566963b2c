// Outputs the corners' colour.
uniform bool two_sided;
INTERPOLATED in vec3 front, back;

void main() { gl_FragColor = vec4(two_sided && !gl_FrontFacing ? back : front, 1); }
