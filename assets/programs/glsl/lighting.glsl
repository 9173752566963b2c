// The lighting equation in camera coordinates: the eye is at the origin and looks along -z, x is right, y up.
// The program puts this text before the shader that computes the lighting.

const float pi = 3.14159265358979;
const int directional = 0, point = 1, spot = 2, area = 3;
//@if models.several
const int @model_numbers@;  // of Material::model
//@end

struct Light {
    int kind;
    vec3 position;  // for a directional light, the unit direction towards it
    vec3 ambient, diffuse, specular;
    //@if light.falloff
    float constant, linear, quadratic;  // falloff 1 / (constant + linear r + quadratic r^2)
    //@end
    //@if light.spot
    vec3 direction;              // unit vector: where a spot points
    float cutoff_deg, exponent;  // cutoff: from the axis to the edge of the cone
    //@if spot.soft
    float inner_deg;  // where the soft edge begins
    //@end
    //@end
    //@if light.area
    vec3 edge_u, edge_v;  // half-edges of an area light
    int cells;            // it is sampled at cells x cells points
    //@end
};
//@if lights.any
uniform Light lights[@light_count@];
//@end

struct Material {
    vec3 ambient, diffuse, specular;  // k_a, k_d, k_s
    //@if terms.emission
    vec3 emission;  // k_e
    //@end
    //@if uses.shininess
    float shininess;
    //@end
    //@if uses.roughness
    float roughness;
    //@end
    //@if uses.f0
    vec3 f0;
    //@end
    //@if models.several
    int model;
    //@end
};
uniform Material material;
uniform vec3 global_ambient;

// a / b, or 0 for b = 0.
float over(float a, float b) { return b == 0.0 ? 0.0 : a / b; }
vec3 unit(vec3 a) { return over(1.0, length(a)) * a; }
//@if uses.power|uses.table_power|light.spot
// x^s; anything to the power 0 is 1, a negative cosine gives 0.
//@if cosine.above_1
// (a vector that is not normalized makes the power huge: infinity could not be interpolated)
float power(float x, float s) { return s == 0.0 ? 1.0 : x <= 0.0 ? 0.0 : min(pow(x, s), 1.0e30); }
//@else
float power(float x, float s) { return s == 0.0 ? 1.0 : x <= 0.0 ? 0.0 : pow(x, s); }
//@end
//@end
//@if uses.unclamped_power
// x^s, also for negative x: negative only if s is an odd number.
float unclamped_power(float x, float s) {
    float value = s == 0.0 ? 1.0 : x == 0.0 ? 0.0 : pow(abs(x), s);
    return x < 0.0 && abs(s - 2.0 * roundEven(s / 2.0)) >= 1.0 ? -value : value;
}
//@end
//@if uses.table_power
// The power of the nearest of @power_table@ cosines, as in a table.
float table_power(float x, float s) {
    const float last = @power_table@.0 - 1.0;
    return power(roundEven(clamp(x, 0.0, 1.0) * last) / last, s);
}
//@end
//@if uses.above_zero
float above_zero(float x) { return x > 0.0 ? 1.0 : 0.0; }
//@end

//@if lights.any
// What one light, or one sample of an area light, adds at a point: to_light is the vector from the point to the
// light, n the normal and v the direction to the eye. `strength`: the fraction left by falloff, cone or emitter.
vec3 share_of(Light light, Material m, vec3 to_light, float strength, vec3 n, vec3 v) {
    //@if blank
    // Step: l, the unit direction to the light.
    //@if terms.ambient
    // Step: the ambient share, from light.ambient and m.ambient.
    //@end
    //@if terms.diffuse
    // Step: the diffuse share, from light.diffuse, m.diffuse and the cosine between n and l. A light behind
    // the surface gives none.
    //@end
    //@if uses.S
    // Step: the highlight of model @model_name@, from light.specular and m.specular. A light behind the surface
    // gives none.
    //@end
    // Step: return their sum, times strength.
    return vec3(0.0);
    //@else
    vec3 l = unit(to_light);
    //@if uses.l_v
    float l_v = dot(l, v);
    //@end
    //@if wrong.unnormalized_light
    l = to_light;
    //@end
    float n_l = dot(n, l);
    //@if uses.n_v
    float n_v = dot(n, v);
    //@end
    // Topic: the reflection model @model_name@.
@model@
    //@if wrong.missing_pi&terms.diffuse
    diffuse = diffuse / pi;
    //@end
    //@if wrong.specular_behind_surface&uses.S
    // (no test of n.l: the highlight stays)
    //@else
    //@if uses.S&clamped_highlight
    //@if wrong.absolute_cosine
    if (!(abs(n_l) > 0.0)) S = S * 0.0;  // a light behind the surface has no highlight
    //@else
    if (!(n_l > 0.0)) S = S * 0.0;  // a light behind the surface has no highlight
    //@end
    //@end
    //@end
    vec3 sum = vec3(0.0);
    //@if terms.ambient
    sum += light.ambient * m.ambient;
    //@if wrong.ambient_per_light_added_twice
    sum += light.ambient * m.ambient;
    //@end
    //@end
    //@if terms.diffuse
    sum += diffuse * light.diffuse * m.diffuse;
    //@end
    //@if uses.S
    sum += S * light.specular * m.specular;
    //@end
    //@if wrong.clamp_each_light
    return clamp(strength * sum, 0.0, 1.0);
    //@else
    return strength * sum;
    //@end
    //@end
}

//@if light.place
// Topic: bulbs and spots: lights with a position, which fall off with distance.
vec3 from_place(Light light, Material m, vec3 p, vec3 n, vec3 v) {
    //@if blank
    // Step: the vector from p to the light.
    //@if light.falloff
    // Step: the falloff for its length r, 1 / (constant + linear r + quadratic r^2).
    //@end
    //@if light.spot
    // Step: for a spot (light.kind == spot), the cosine between its direction and the direction from the light to p,
    // to the power of light.exponent; 0 outside the cone.
    //@if spot.soft
    // Step: for a spot, the soft edge from inner_deg to cutoff_deg: the fraction between the cosines, squared.
    //@end
    //@end
    // Step: return share_of() with that vector and that strength.
    return vec3(0.0);
    //@else
    vec3 to_light = light.position - p;
    float strength = 1.0;
    //@if light.falloff
    float distance = length(to_light);
    //@if wrong.falloff_inverted
    strength = light.constant + distance * (light.linear + distance * light.quadratic);
    //@else
    strength = over(1.0, light.constant + distance * (light.linear + distance * light.quadratic));
    //@end
    //@end
    //@if light.spot
    if (light.kind == spot) {  // a position, a direction, a cutoff
        float along = dot(-unit(to_light), light.direction);
        //@if wrong.cutoff_as_full_angle
        float angle = light.cutoff_deg / 2.0;
        //@else
        float angle = light.cutoff_deg;
        //@end
        //@if wrong.degrees_for_radians
        float edge = cos(angle);
        //@else
        float edge = angle == 90.0 ? 0.0 : cos(radians(angle));
        //@end
        //@if wrong.cone_cosines_swapped
        strength *= along >= edge ? 0.0 : 1.0;
        //@else
        strength *= along >= edge ? power(min(along, 1.0), light.exponent) : 0.0;
        //@if spot.soft
        // The soft edge: from the inner angle to the cutoff.
        float width = max(cos(radians(light.inner_deg)) - edge, 0.001);
        float soft = light.inner_deg < angle ? clamp((along - edge) / width, 0.0, 1.0) : 1.0;
        strength *= soft * soft;
        //@end
        //@end
    }
    //@end
    return share_of(light, m, to_light, strength, n, v);
    //@end
}
//@end
//@if light.area

// Topic: area lights: many points, each a separate light, weighted by its cosine and the squared distance.
vec3 from_area(Light light, Material m, vec3 p, vec3 n, vec3 v) {
    vec3 across = cross(light.edge_u, light.edge_v), sum = vec3(0.0);
    float cells = float(light.cells);
    for (int i = 0; i < light.cells; ++i)
        for (int j = 0; j < light.cells; ++j) {
            float a = (2.0 * float(i) + 1.0) / cells - 1.0, b = (2.0 * float(j) + 1.0) / cells - 1.0;
            vec3 to_light = light.position + a * light.edge_u + b * light.edge_v - p;
            float seen = 4.0 * abs(dot(unit(to_light), across));
            sum += share_of(light, m, to_light, over(seen, pi * cells * cells * dot(to_light, to_light)), n, v);
        }
    return sum;
}
//@end
//@end

//@if wrong.viewer_at_origin_of_world
uniform vec3 origin_of_world;
//@end
//@if wrong.lit_after_projection
uniform mat4 projection;
//@end
// Topic: the whole sum. The colour of a point: emission, ambient light, and what each light adds.
vec3 lit(vec3 p, vec3 n) {
    //@if blank
    //@if viewer.infinite
    // Step: v, the direction to an infinitely distant eye: (0, 0, 1).
    //@else
    // Step: v, the unit direction from p to the eye, which is the origin.
    //@end
    //@if tone
    // Step: the tone from cool to warm.
    //@end
    //@if terms.emission
    // Step: start with material.emission.
    //@end
    //@if terms.ambient
    // Step: add material.ambient times global_ambient.
    //@end
    //@if lights.any
    // Step: add the light of each of the @light_count@ lights:
    //@if light.directional
    // for a directional light, share_of(); light.position is the direction to it, and its strength is 1;
    //@end
    //@if light.place
    // for a point light or a spot, from_place();
    //@end
    //@if light.area
    // for an area light, from_area().
    //@end
    //@end
    // Step: return the sum.
    return vec3(0.0);
    //@else
    //@if wrong.lit_after_projection
    vec4 clip = projection * vec4(p, 1.0);
    p = over(1.0, clip.w) * clip.xyz;
    //@end
    //@if viewer.infinite
    vec3 v = vec3(0.0, 0.0, 1.0);  // as if the eye were far away
    //@else
    //@if wrong.perspective_view_in_ortho
    //@end
    //@if wrong.viewer_at_origin_of_world
    vec3 to_eye = origin_of_world - p;
    //@else
    vec3 to_eye = -p;  // the eye is the origin
    //@end
    //@if wrong.unnormalized_view
    vec3 v = to_eye;
    //@else
    vec3 v = unit(to_eye);
    //@end
    //@end
    //@if wrong.view_reversed
    v = -v;
    //@end
    //@if wrong.flipped_by_view
    if (dot(n, v) < 0.0) n = -n;
    //@end
    Material m = material;
    vec3 sum = vec3(0.0);
    //@if tone
    // Topic: cool to warm. The side facing the first light is warm, the other cool.
    //@if lights.any
    vec3 to_first = lights[0].kind == directional ? lights[0].position : lights[0].position - p;
    float k_w = (1.0 + dot(n, unit(to_first))) / 2.0;
    //@else
    float k_w = 0.5;
    //@end
    sum = k_w * (vec3@warm@ + @beta@ * m.diffuse) + (1.0 - k_w) * (vec3@cool@ + @alpha@ * m.diffuse);
    //@end
    //@if terms.emission
    sum += m.emission;
    //@end
    //@if terms.ambient
    sum += m.ambient * global_ambient;
    //@end
    //@if lights.any
    for (int i = 0; i < @light_count@; ++i) {
        Light light = lights[i];
        //@if light.directional
        if (light.kind == directional) {
            //@if light.falloff
            //@if wrong.falloff_inverted
            sum += share_of(light, m, light.position, light.constant, n, v);
            //@else
            sum += share_of(light, m, light.position, over(1.0, light.constant), n, v);
            //@end
            //@else
            sum += share_of(light, m, light.position, 1.0, n, v);
            //@end
        }
        //@end
        //@if light.area
        if (light.kind == area) sum += from_area(light, m, p, n, v);
        //@end
        //@if light.place
        if (light.kind == point || light.kind == spot) sum += from_place(light, m, p, n, v);
        //@end
    }
    //@end
    //@if corners.clamped
    return clamp(sum, 0.0, 1.0);  // OpenGL clamps the colours of corners before it interpolates them
    //@else
    return sum;
    //@end
    //@end
}
