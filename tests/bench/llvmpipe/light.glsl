// The lighting equation for the lights of one scene, camera coordinates. The program prepends the number of lights of
// each kind (POINTS, SUNS, SPOTS) and sorts the lights by kind, so that no fragment branches on it. Colours are
// premultiplied with the material's, because they are constant during a draw.
struct Light {
    vec4 place;      // for a sun the unit direction towards it
    vec4 falloff;    // constant, linear, quadratic
    vec4 axis;       // unit; w: cosine of the cutoff
    vec4 diffuse;    // k_d times the light's diffuse colour; w: the spot's exponent
    vec4 specular;   // k_s times the light's specular colour; w: shininess
};
layout(std140) uniform Lights {
    Light lights[POINTS + SUNS + SPOTS];
    vec4 unlit;      // emission + k_a I_a + the ambient terms of the suns themselves
};

vec3 reflected(Light light, vec3 l, float strength, vec3 n, vec3 v) {
    float n_dot_l = dot(n, l);
    if (n_dot_l <= 0.0) return vec3(0);
    vec3 h = normalize(l + v);
    float s = pow(max(dot(n, h), 0.0), light.specular.w);
    return strength * (n_dot_l * light.diffuse.rgb + s * light.specular.rgb);
}

vec3 from_place(Light light, vec3 p, vec3 n, vec3 v, bool cone) {
    vec3 to_light = light.place.xyz - p;
    float r2 = dot(to_light, to_light), inverse = inversesqrt(r2), r = r2 * inverse;
    vec3 l = to_light * inverse;
    float strength = 1.0 / (light.falloff.x + light.falloff.y * r + light.falloff.z * r2);
    if (cone) {
        float c = -dot(l, light.axis.xyz);
        if (c < light.axis.w) return vec3(0);
        strength *= pow(c, light.diffuse.w);
    }
    return reflected(light, l, strength, n, v);
}

vec3 lit(vec3 p, vec3 n) {
    vec3 v = normalize(-p), sum = unlit.rgb;
    for (int i = 0; i < POINTS; ++i) sum += from_place(lights[i], p, n, v, false);
    for (int i = POINTS; i < POINTS + SUNS; ++i) sum += reflected(lights[i], lights[i].place.xyz, 1.0, n, v);
    for (int i = POINTS + SUNS; i < POINTS + SUNS + SPOTS; ++i) sum += from_place(lights[i], p, n, v, true);
    return sum;
}
