VARYING in vec3 color;
layout(location = 0) out vec4 shown;

void main() { shown = vec4(color, 1); }
