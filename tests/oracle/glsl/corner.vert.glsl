// Lights the corner: INTERPOLATED is flat, smooth or noperspective. Lights both sides, because the visible side is not
// known yet.
uniform bool clamped;
INTERPOLATED out vec3 front, back;

void main() {
    gl_Position = ftransform();
    vec3 p = (gl_ModelViewMatrix * vec4(gl_MultiTexCoord0.xyz, 1)).xyz;  // for `flat`: the polygon's centre
    vec3 n = normalize(gl_NormalMatrix * gl_Normal);
    front = model == 0 ? gl_Color.rgb : lit(p, n);
    back = model == 0 ? gl_Color.rgb : lit(p, -n);
    if (clamped) {
        front = clamp(front, 0.0, 1.0);
        back = clamp(back, 0.0, 1.0);
    }
}
