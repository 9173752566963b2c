// The G-buffer: unit normal and z, 16 bytes a pixel; x and y come back from the pixel.
in vec3 place, n;
layout(location = 0) out vec4 kept;

void main() { kept = vec4(normalize(n), place.z); }
