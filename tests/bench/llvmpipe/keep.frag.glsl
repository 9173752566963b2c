// The G-buffer: unit normal and z, 16 bytes per pixel; x and y are recomputed from the pixel.
in vec3 place, n;
layout(location = 0) out vec4 kept;

void main() { kept = vec4(normalize(n), place.z); }
