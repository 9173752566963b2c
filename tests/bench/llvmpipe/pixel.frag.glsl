in vec3 place, n;
layout(location = 0) out vec4 shown;

void main() { shown = vec4(lit(place, normalize(n)), 1); }
