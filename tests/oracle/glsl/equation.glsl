// The lighting equation in OpenGL's shading language, written from the published formulas (sources next to each term)
// and not from renderer/lighting, so that the two can be compared. Camera coordinates.

const int directional = 0, point_light = 1, spot = 2, area = 3;
const int lambert = 1, phong = 2, blinn_phong = 3, retro = 4, oren_nayar = 5, cook_torrance = 6;
const float pi = 3.14159265358979;

struct Light {
    int kind;
    vec3 position;  // for a directional light the direction towards it
    vec3 ambient, diffuse, specular;
    vec3 falloff;   // constant, linear, quadratic
    vec3 axis;      // unit: the direction of a spot
    float cos_cutoff, exponent;
    bool has_cone;
    vec3 edge_u, edge_v;  // half-edges of an area light
    int cells;            // its samples per side
};
uniform Light lights[8];
uniform int light_count;

uniform vec3 k_e, k_a, k_d, k_s;
uniform vec3 f0;
uniform float shininess, roughness;
uniform vec3 global_ambient;
uniform int model;
uniform bool local_viewer;
uniform bool cool_to_warm;
uniform vec3 cool, warm;  // the tones of this material

float raised(float x, float s) { return s == 0.0 ? 1.0 : x <= 0.0 ? 0.0 : pow(x, s); }

// Oren and Nayar, "Generalization of Lambert's Reflectance Model", 1994: the qualitative model, by its angles.
float rough_diffuse(vec3 n, vec3 l, vec3 v) {
    float sigma = roughness * 0.5 * pi;
    float s2 = sigma * sigma;
    float A = 1.0 - s2 / (2.0 * (s2 + 0.33));
    float B = 0.45 * s2 / (s2 + 0.09);
    float cos_l = dot(n, l), cos_v = dot(n, v);
    vec3 along_l = l - cos_l * n, along_v = v - cos_v * n;
    float sin_l = length(along_l), sin_v = length(along_v);
    float cos_azimuth = sin_l > 0.0 && sin_v > 0.0 ? dot(along_l / sin_l, along_v / sin_v) : 0.0;
    // alpha is the larger angle, beta the smaller: the larger cosine.
    bool l_is_beta = cos_l >= cos_v;
    float sin_alpha = l_is_beta ? sin_v : sin_l;
    float tan_beta = l_is_beta ? sin_l / cos_l : sin_v / cos_v;
    return max(cos_l, 0.0) * (A + B * max(cos_azimuth, 0.0) * sin_alpha * tan_beta);
}

// Trowbridge-Reitz facets; height-correlated shadowing (Heitz, JCGT 2014); Schlick 1994. In double: with a narrow lobe
// the textbook's 1 - (n.h)^2 (1 - a^2) loses all digits in float.
vec3 facet_highlight(vec3 n_, vec3 l_, vec3 v_) {
    dvec3 n = normalize(dvec3(n_)), l = normalize(dvec3(l_)), v = normalize(dvec3(v_));
    double n_l = dot(n, l), n_v = dot(n, v);
    if (n_l <= 0.0 || n_v <= 0.0) return vec3(0);
    dvec3 h = normalize(l + v);
    double alpha = max(double(roughness) * double(roughness), 0.001), a2 = alpha * alpha;
    double n_h = dot(n, h);
    double below = n_h * n_h * (a2 - 1.0) + 1.0;
    double D = n_h > 0.0 ? a2 / (double(pi) * below * below) : 0.0;
    double lambda_l = (sqrt(1.0 + a2 * (1.0 / (n_l * n_l) - 1.0)) - 1.0) / 2.0;
    double lambda_v = (sqrt(1.0 + a2 * (1.0 / (n_v * n_v) - 1.0)) - 1.0) / 2.0;
    double G = 1.0 / (1.0 + lambda_l + lambda_v);
    double c = 1.0 - max(dot(v, h), 0.0);
    dvec3 F = dvec3(f0) + (1.0 - dvec3(f0)) * (c * c * c * c * c);
    return vec3(double(pi) * D * G * F / (4.0 * n_v));
}

// S of the equation, before the test of n.l.
vec3 highlight(vec3 n, vec3 l, vec3 v) {
    if (model == phong) return vec3(raised(dot(reflect(-l, n), v), shininess));
    if (model == blinn_phong) {
        vec3 h = l + v;
        float size = length(h);
        return vec3(raised(size > 0.0 ? dot(n, h) / size : 0.0, shininess));
    }
    if (model == retro) return vec3(raised(dot(l, v), shininess));
    if (model == cook_torrance) return facet_highlight(n, l, v);
    return vec3(0);
}

// The light that one source, or one sample of an area light, reflects to the eye.
vec3 share_of(Light light, vec3 l, float strength, vec3 n, vec3 v) {
    float n_l = dot(n, l);
    float diffuse = model == oren_nayar ? rough_diffuse(n, l, v) : max(n_l, 0.0);
    vec3 S = n_l > 0.0 ? highlight(n, l, v) : vec3(0);
    vec3 shine = light.specular * k_s * S;
    if (cool_to_warm) return strength * shine;
    return strength * (light.ambient * k_a + diffuse * light.diffuse * k_d + shine);
}

// OpenGL 2.1, section 2.14.1: attenuation and the spot's cone.
vec3 from_place(Light light, vec3 p, vec3 n, vec3 v) {
    vec3 to_light = light.position - p;
    float r = length(to_light);
    vec3 l = to_light / r;
    float strength = 1.0 / (light.falloff.x + light.falloff.y * r + light.falloff.z * r * r);
    if (light.has_cone) {
        float c = dot(-l, light.axis);
        strength *= c >= light.cos_cutoff ? raised(c, light.exponent) : 0.0;
    }
    return share_of(light, l, strength, n, v);
}

// A diffuse emitter divided into cells x cells equal parts, each a small light at its centre: A |cos| / (pi n^2 r^2).
vec3 from_area(Light light, vec3 p, vec3 n, vec3 v) {
    vec3 across = cross(2.0 * light.edge_u, 2.0 * light.edge_v);
    float whole = length(across);
    vec3 facing = across / whole;
    float count = float(light.cells * light.cells);
    vec3 sum = vec3(0);
    for (int i = 0; i < light.cells; ++i)
        for (int j = 0; j < light.cells; ++j) {
            float s = (2.0 * float(i) + 1.0) / float(light.cells) - 1.0;
            float t = (2.0 * float(j) + 1.0) / float(light.cells) - 1.0;
            vec3 to_light = light.position + s * light.edge_u + t * light.edge_v - p;
            float r2 = dot(to_light, to_light);
            vec3 l = to_light / sqrt(r2);
            sum += share_of(light, l, whole * abs(dot(facing, l)) / (pi * count * r2), n, v);
        }
    return sum;
}

// The colour before any light is added. Cool to warm as in the lecture: warm toward the first light.
vec3 begun(vec3 p, vec3 n) {
    if (!cool_to_warm) return k_e + k_a * global_ambient;
    if (light_count == 0) return 0.5 * (cool + warm);
    vec3 l = normalize(lights[0].kind == directional ? lights[0].position : lights[0].position - p);
    return mix(cool, warm, (1.0 + dot(n, l)) / 2.0);
}

vec3 lit(vec3 p, vec3 n) {
    vec3 v = local_viewer ? normalize(-p) : vec3(0, 0, 1);
    vec3 sum = begun(p, n);
    for (int i = 0; i < light_count; ++i) {
        Light light = lights[i];
        if (light.kind == directional)
            sum += share_of(light, normalize(light.position), 1.0, n, v);
        else if (light.kind == area)
            sum += from_area(light, p, n, v);
        else
            sum += from_place(light, p, n, v);
    }
    return sum;
}
