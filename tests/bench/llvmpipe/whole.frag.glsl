uniform sampler2D kept;
uniform vec4 ray;  // x, y of a pixel's ray at z = -1: (pixel * ray.xy + ray.zw)
layout(location = 0) out vec4 shown;

void main() {
    vec4 g = texelFetch(kept, ivec2(gl_FragCoord.xy), 0);
    vec3 p = vec3(gl_FragCoord.xy * ray.xy + ray.zw, -1) * -g.w;
    shown = vec4(lit(p, g.xyz), 1);
}
