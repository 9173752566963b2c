// @title@
//
// Draws the scene without any library: places the meshes, finds each pixel's visible face, and lights it.
// Writes picture.ppm (8 bit) and picture.pfm (linear light, not clamped).
// build: g++ -std=c++17 -O2 -o picture main.cpp
// run: ./picture
// build offscreen: g++ -std=c++17 -O2 -o picture main.cpp
// run offscreen: ./picture
// Needs a C++17 compiler, and in the folder where it is run: @mesh_files@
// Colours are linear red, green, blue. Lighting is computed in camera coordinates: the eye is at the origin
// and looks along -z, x is right, y up.
//@can mode.phong spot.soft wrong.no_clamp_of_cosine flat.centroid exposure exponent.large lights.above_8 lights.above_32
//@can shininess.large shininess.zero
//@can wrong.unnormalized_half wrong.half_angle_with_phong_shininess wrong.reflect_sign wrong.reflect_of_difference
//@can wrong.half_lambert wrong.mirror_turns_inside_out wrong.falloff_forgotten

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

//@include scene.cpp
// ---- Lighting ----
//@if reflection.lit
//@if uses.power|uses.table_power|light.spot
/// x^s; anything to the power 0 is 1, a negative cosine gives 0.
//@if wrong.power_zero_is_nan
double power(double x, double s) { return s == 0 && x <= 0 ? NAN : x <= 0 ? 0 : std::pow(x, s); }
//@else
double power(double x, double s) { return s == 0 ? 1 : x <= 0 ? 0 : std::pow(x, s); }
//@end
//@end
//@if uses.unclamped_power
/// x^s, also for negative x: negative only if s is an odd number.
double unclamped_power(double x, double s) {
    const double value = std::pow(std::abs(x), s);
    return x < 0 && std::abs(s - 2 * std::nearbyint(s / 2)) >= 1 ? -value : value;
}
//@end
//@if uses.table_power
/// The power of the nearest of @power_table@ cosines, as in a table.
double table_power(double x, double s) {
    const double last = @power_table@ - 1;
    return power(std::nearbyint(std::min(std::max(x, 0.0), 1.0) * last) / last, s);
}
//@end
//@if uses.above_zero
double above_zero(double x) { return x > 0 ? 1 : 0; }
//@end
//@end
//@if transfer.srgb|wrong.encoded_twice|wrong.lit_in_srgb
double srgb(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }
//@end
//@if wrong.lit_in_srgb
vec3 srgb(vec3 c) { return {srgb(c.x), srgb(c.y), srgb(c.z)}; }
//@end
//@if reflection.lit
//@if wrong.clamp_each_light|corners.clamped
vec3 clamped(vec3 c) {
    const auto within = [](double x) { return std::min(std::max(x, 0.0), 1.0); };
    return {within(c.x), within(c.y), within(c.z)};
}
//@end

//@include lights.cpp
/// A point to be lit, in camera coordinates: n is its normal, and v the direction to the eye.
struct Point { vec3 p, n, v; };

/// What one light adds at a point.
vec3 share_of(const Light& light, const Material& m, const Point& at) {
    //@if needs.l|light.falloff
    const vec3 to_light = light.kind == directional ? light.position : light.position - at.p;
    //@else
    (void)at;  // ambient light alone is the same everywhere
    //@end
    //@if needs.l
    //@if wrong.unnormalized_light
    vec3 l = unit(to_light);
    //@else
    const vec3 l = unit(to_light);
    //@end
    //@end
    //@if !terms.ambient&!terms.diffuse&!uses.S
    (void)m;  // no term is added
    //@end
    //@if light.falloff|light.area
    const double distance = length(to_light);
    //@end
    //@if light.falloff|light.area|light.spot
    double strength = 1;
    //@end
    //@if light.falloff
    // Topic: falloff with distance.
    //@if wrong.falloff_inverted
    strength = light.constant + distance * (light.linear + distance * light.quadratic);
    //@else
    strength = over(1, light.constant + distance * (light.linear + distance * light.quadratic));
    //@end
    //@end
    //@if light.area
    // Topic: area lights. A sample is weighted by the cosine at the light and the squared distance.
    if (light.kind == area) {
        const vec3 across = cross(light.edge_u, light.edge_v);  // times the cosine: 1/4 of the visible area
        const double cells = light.cells * light.cells;
        strength = 4 * std::abs(dot(l, across)) * over(1, pi * cells * distance * distance);
    }
    //@end
    //@if light.spot
    if (light.kind == spot) {  // Topic: spot lights: a position, a direction, a cutoff
        const double along = dot(-1 * l, light.direction);
        //@if wrong.cutoff_as_full_angle
        const double angle = light.cutoff_deg / 2;
        //@else
        const double angle = light.cutoff_deg;
        //@end
        //@if wrong.degrees_for_radians
        const double edge = std::cos(angle);
        //@else
        const double edge = angle == 90 ? 0 : std::cos(radians(angle));
        //@end
        //@if wrong.cone_cosines_swapped
        strength *= along >= edge ? 0 : 1;
        //@else
        strength *= along >= edge ? power(std::min(along, 1.0), light.exponent) : 0;
        //@if spot.soft
        // The soft edge: from the inner angle to the cutoff.
        const double width = std::max(std::cos(radians(light.inner_deg)) - edge, 0.001);
        const double soft = light.inner_deg < angle ? std::clamp((along - edge) / width, 0.0, 1.0) : 1;
        strength *= soft * soft;
        //@end
        //@end
    }
    //@end
    //@if uses.l_v
    const double l_v = dot(l, at.v);
    //@end
    //@if wrong.unnormalized_light&needs.l
    l = to_light;
    //@end
    //@if uses.n_l
    const double n_l = dot(at.n, l);
    //@end
    //@if uses.n_v
    const double n_v = dot(at.n, at.v);
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
    if (!(std::abs(n_l) > 0)) S = {};  // a light behind the surface has no highlight
    //@else
    if (!(n_l > 0)) S = {};  // a light behind the surface has no highlight
    //@end
    //@end
    //@end
    vec3 sum;
    //@if terms.ambient
    sum = sum + light.ambient * m.ambient;
    //@if wrong.ambient_per_light_added_twice
    sum = sum + light.ambient * m.ambient;
    //@end
    //@end
    //@if terms.diffuse
    sum = sum + diffuse * (light.diffuse * m.diffuse);
    //@end
    //@if uses.S
    sum = sum + S * (light.specular * m.specular);
    //@end
    //@if light.falloff|light.area|light.spot
    sum = strength * sum;
    //@end
    //@if wrong.clamp_each_light
    sum = clamped(sum);
    //@end
    return sum;
}

/// Topic: the whole sum. The colour of a point: emission, ambient light, and what each light adds.
vec3 lit(const Material& m, vec3 p, vec3 n) {
    //@if wrong.lit_after_projection
    const double w = row(clip_from_view(), 3, p, 1);
    p = over(1, w) * moved(clip_from_view(), p, 1);
    //@end
    //@if viewer.infinite
    @const_v@vec3 v = {0, 0, 1};  // as if the eye were far away
    //@else
    //@if wrong.perspective_view_in_ortho
    //@end
    //@if wrong.viewer_at_origin_of_world
    const vec3 to_eye = moved(view_from_world(), {}, 1) - p;
    //@else
    const vec3 to_eye = vec3{} - p;  // the eye is the origin
    //@end
    //@if wrong.unnormalized_view
    @const_v@vec3 v = to_eye;
    //@else
    @const_v@vec3 v = unit(to_eye);
    //@end
    //@end
    //@if wrong.view_reversed
    v = -1 * v;
    //@end
    //@if wrong.flipped_by_view
    if (dot(n, v) < 0) n = -1 * n;
    //@end
    vec3 sum;
    //@if tone
    // Topic: cool to warm. The side facing the first light is warm, the other cool.
    const vec3 to_first = first_light.kind == directional ? first_light.position : first_light.position - p;
    const double k_w = !sources.empty() ? (1 + dot(n, unit(to_first))) / 2 : 0.5;
    const vec3 warm = @warm@, cool = @cool@;
    sum = k_w * (warm + @beta@ * m.diffuse) + (1 - k_w) * (cool + @alpha@ * m.diffuse);
    //@end
    //@if terms.emission
    sum = sum + m.emission;
    //@end
    //@if terms.ambient
    sum = sum + m.ambient * global_ambient;
    //@end
    for (const Light& light : sources) sum = sum + share_of(light, m, {p, n, v});
    //@if corners.clamped
    return clamped(sum);  // OpenGL clamps the colours of corners before it interpolates them
    //@else
    return sum;
    //@end
}
//@end

//@include meshes.cpp
struct Clip { double x, y, z, w; };  // clip coordinates: visible if -w <= x, y, z <= w
/// An object in camera coordinates.
struct Placed {
    Mesh mesh;  // positions and normals in camera coordinates
    //@if facet_normals
    std::vector<vec3> facet_normals;
    //@end
    //@if reflection.lit
    Material material;
    //@end
    //@if sides|wrong.mirror_turns_inside_out
    bool mirrored;  // a transform with a negative determinant reverses the winding
    //@end
};
std::vector<Placed> placed;
void place_objects(const mat4& view) {
    for (const Object& object : objects) {
        Placed o;
        o.mesh = read_mesh(object.mesh);
//@include material.cpp
        const mat4 to_camera = view * transform(object.translate, object.rotate_deg, object.scale);
        //@if sides|wrong.mirror_turns_inside_out
        o.mirrored = object.scale.x * object.scale.y * object.scale.z < 0;
        //@end
        //@if reflection.lit
//@include normals.cpp
//@include side.cpp
        const auto camera_normal = [&](vec3 n) {
            //@if wrong.no_normals_given
            n = {0, 0, 1};
            //@end
            //@if wrong.normals_as_points&!wrong.normals_left_in_object&!wrong.normals_left_in_world
            return moved(for_normals, @side@n, 1);
            //@else
            return moved(for_normals, @side@n, 0);
            //@end
        };
        //@if facet_normals
        for (const auto& face : o.mesh.faces)
            o.facet_normals.push_back(unit(camera_normal(facet_normal(o.mesh, face))));
        //@end
        //@if wrong.cross_reversed
        // (the mesh file's averaged normals come from such facet normals)
        //@end
        //@if wrong.unnormalized_normals
        for (vec3& n : o.mesh.normals) n = camera_normal(n);
        //@else
        for (vec3& n : o.mesh.normals) n = unit(camera_normal(n));
        //@end
        //@end
        for (vec3& p : o.mesh.positions) p = moved(to_camera, p, 1);
        placed.push_back(o);
    }
}

// ---- Which face is visible ----
/// What a pixel shows.
struct Seen {
    int object = -1, triangle = 0;
    //@if sides
    bool back = false;
    //@end
    double depth = 2;       // -1 at the near plane, 1 at the far one
    double weight[3] = {};  // of the triangle's corners, perspective-correct
};
std::vector<Seen> seen(width * height);
// Rounding may separate two faces in one plane by up to this depth; the first one is shown.
constexpr double same_depth = 1e-12;
Clip clip_of(vec3 p) {
    static const mat4 m = clip_from_view();
    return {row(m, 0, p, 1), row(m, 1, p, 1), row(m, 2, p, 1), row(m, 3, p, 1)};
}

/// The weights of a triangle's corners where the ray through a point of the screen (x and y from -1 to 1) meets
/// its plane. Uses only clip coordinates, so nothing needs to be clipped.
bool find_weights(const Clip (&c)[3], double x, double y, Seen& s) {
    double sum = 0, z = 0, w = 0;
    for (int i = 0; i < 3; ++i) {
        const Clip &a = c[(i + 1) % 3], &b = c[(i + 2) % 3];
        s.weight[i] = (a.x - x * a.w) * (b.y - y * b.w) - (a.y - y * a.w) * (b.x - x * b.w);
        sum += s.weight[i];
    }
    //@if sides
    s.back = sum < 0;  // clockwise on the screen
    //@end
    for (int i = 0; i < 3; ++i) {
        s.weight[i] = over(s.weight[i], sum);
        if (sum == 0 || s.weight[i] < 0) return false;
        z += s.weight[i] * c[i].z;
        w += s.weight[i] * c[i].w;
    }
    s.depth = z / w;
    return w > 0 && s.depth >= -1 && s.depth <= 1;
}

/// Topic: rasterising. Each pixel keeps the nearest triangle at its centre.
void rasterise(int object, int triangle) {
    const Placed& o = placed[object];
    const Triangle& t = o.mesh.triangles[triangle];
    Clip c[3];
    double px[3], py[3];  // in pixels
    for (int i = 0; i < 3; ++i) {
        c[i] = clip_of(o.mesh.positions[o.mesh.faces[t.face][t.corner[i]].position]);
        px[i] = (c[i].x / c[i].w + 1) / 2 * width;
        py[i] = (1 - c[i].y / c[i].w) / 2 * height;
    }
    for (const auto axis : {&Clip::x, &Clip::y, &Clip::z})
        for (const int side : {-1, 1})  // outside one plane of the view volume
            if (side * c[0].*axis > c[0].w && side * c[1].*axis > c[1].w && side * c[2].*axis > c[2].w) return;
    auto [left, right] = std::minmax({px[0], px[1], px[2]});
    auto [top, bottom] = std::minmax({py[0], py[1], py[2]});
    if (std::min({c[0].w, c[1].w, c[2].w}) <= 0) left = top = 0, right = width, bottom = height;
    //@if wrong.culled_by_light
    if (!sources.empty()) {
        vec3 centre;
        for (const Corner& corner : o.mesh.faces[t.face])
            centre = centre + (1.0 / o.mesh.faces[t.face].size()) * o.mesh.positions[corner.position];
        vec3 to_light = first_light.position;
        if (first_light.kind != directional) to_light = to_light - centre;
        if (!(dot(o.facet_normals[t.face], to_light) > 0)) return;
    }
    //@end
    const int x0 = std::max(left - 1, 0.0), x1 = std::min(right + 1, width - 1.0);
    const int y0 = std::max(top - 1, 0.0), y1 = std::min(bottom + 1, height - 1.0);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            Seen s{object, triangle};
            if (!find_weights(c, 2 * (x + 0.5) / width - 1, 1 - 2 * (y + 0.5) / height, s)) continue;
            //@if sides
            s.back = s.back != o.mirrored;
            //@end
            //@if cull.back
            if (s.back) continue;
            //@end
            //@if cull.front
            if (!s.back) continue;
            //@end
            if (s.depth < seen[y * width + x].depth - same_depth) seen[y * width + x] = s;
        }
}

// ---- The colour of a pixel ----
//@if near_cut|interpolation.scanline
//@if interpolation.screen|interpolation.scanline
/// A corner of a polygon on the screen, in pixels. Where the near plane cuts an edge, it is between two
/// corners of the polygon, the fraction t of the way from a to b.
struct ScreenCorner {
    double x, y;
    int a, b;
    double t;
};
std::vector<ScreenCorner> on_screen(const Placed& o, int face, const std::vector<int>& corners) {
    std::vector<ScreenCorner> cut;
    const auto add = [&cut](const Clip& c, int a, int b, double t) {
        cut.push_back({(c.x / c.w + 1) / 2 * width, (1 - c.y / c.w) / 2 * height, a, b, t});
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const int a = corners[i];
        const Clip p = clip_of(o.mesh.positions[o.mesh.faces[face][a].position]);
        //@if near_cut
        const int b = corners[(i + 1) % corners.size()];
        const Clip q = clip_of(o.mesh.positions[o.mesh.faces[face][b].position]);
        const double here = p.z + p.w, next = q.z + q.w;  // negative where it is cut off
        if (here >= 0) add(p, a, a, 0);
        if ((here >= 0) == (next >= 0)) continue;
        const double t = here / (here - next);
        const auto mid = [t](double from, double to) { return from + t * (to - from); };
        add({mid(p.x, q.x), mid(p.y, q.y), mid(p.z, q.z), mid(p.w, q.w)}, a, b, t);
        //@else
        add(p, a, a, 0);
        //@end
    }
    return cut;
}
//@end
//@end
//@if interpolation.screen|interpolation.scanline
struct Weight {
    int corner;  // index in the polygon
    double weight;
};
/// The weight of each corner of the polygon in a pixel.
//@if needs.xy
std::vector<Weight> weights_of(const Placed& o, const Seen& s, double x, double y) {
//@else
std::vector<Weight> weights_of(const Placed& o, const Seen& s) {
//@end
    const Triangle& t = o.mesh.triangles[s.triangle];
    //@if interpolation.screen
    // Topic: interpolation on the screen. Linear over the triangle's image.
    //@if !near_cut
    double weight[3], sum = 0;
    for (int i = 0; i < 3; ++i) {
        weight[i] = s.weight[i] * clip_of(o.mesh.positions[o.mesh.faces[t.face][t.corner[i]].position]).w;
        sum += weight[i];
    }
    return {{t.corner[0], weight[0] / sum}, {t.corner[1], weight[1] / sum}, {t.corner[2], weight[2] / sum}};
    //@else
    const auto cross2 = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const std::vector<ScreenCorner> cut = on_screen(o, t.face, {t.corner[0], t.corner[1], t.corner[2]});
    std::vector<Weight> best;
    double best_inside = -1e9;
    for (std::size_t i = 2; i < cut.size(); ++i) {
        const ScreenCorner &a = cut[0], &b = cut[i - 1], &c = cut[i];
        const double area = cross2(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
        const double wb = over(cross2(x - a.x, y - a.y, c.x - a.x, c.y - a.y), area);
        const double wc = over(cross2(b.x - a.x, b.y - a.y, x - a.x, y - a.y), area), wa = 1 - wb - wc;
        if (area == 0 || std::min({wa, wb, wc}) <= best_inside) continue;
        best_inside = std::min({wa, wb, wc});
        best = {{a.a, wa * (1 - a.t)}, {a.b, wa * a.t}, {b.a, wb * (1 - b.t)},
                {b.b, wb * b.t},       {c.a, wc * (1 - c.t)}, {c.b, wc * c.t}};
    }
    return best;
    //@end
    //@else
    //@if interpolation.scanline
    // Topic: Gouraud's interpolation: along the polygon's edges, then along the scanline.
    std::vector<int> all;
    for (std::size_t i = 0; i < o.mesh.faces[t.face].size(); ++i) all.push_back(int(i));
    const std::vector<ScreenCorner> polygon = on_screen(o, t.face, all);
    struct Crossing {
        double x, t;
        const ScreenCorner *from, *to;
    };
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        const double share = (y - a.y) / (b.y - a.y);
        crossings.push_back({a.x + share * (b.x - a.x), share, &a, &b});
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    std::size_t best = 0;
    double best_outside = 1e9;
    for (std::size_t i = 1; i < crossings.size(); i += 2) {  // the pair around the pixel
        const double outside = std::max({crossings[i - 1].x - x, x - crossings[i].x, 0.0});
        if (outside < best_outside) best_outside = outside, best = i;
    }
    if (best > 0) {
        const Crossing &a = crossings[best - 1], &b = crossings[best];
        const double u = std::min(std::max(over(x - a.x, b.x - a.x), 0.0), 1.0);
        std::vector<Weight> found;
        const auto add = [&found](const ScreenCorner& c, double weight) {
            found.push_back({c.a, weight * (1 - c.t)});
            found.push_back({c.b, weight * c.t});
        };
        add(*a.from, (1 - u) * (1 - a.t));
        add(*a.to, (1 - u) * a.t);
        add(*b.from, u * (1 - b.t));
        add(*b.to, u * b.t);
        return found;
    }
    //@end
    return {{t.corner[0], s.weight[0]}, {t.corner[1], s.weight[1]}, {t.corner[2], s.weight[2]}};
    //@end
}
//@end

//@if needs.xy
vec3 color_of(const Seen& s, double x, double y) {
//@else
vec3 color_of(const Seen& s) {
//@end
    const Placed& o = placed[s.object];
    const Triangle& t = o.mesh.triangles[s.triangle];
    const std::vector<Corner>& face = o.mesh.faces[t.face];
    //@if turned
    double turn = 1;
    //@end
    //@if two_sided
    if (s.back) turn = -turn;  // seen from behind, the normal is reversed
    //@end
    //@if two_sided&wrong.flipped_twice
    if (s.back) turn = -turn;
    //@end
    //@if wrong.some_faces_flipped
    if (t.face % 3 == 0) turn = -turn;
    //@end
    //@if mode.flat
    // Topic: flat shading. One point of the polygon is lit, and the entire polygon has that colour.
    //@if flat.provoking
    const Corner& last = face[t.corner[2]];
    //@if reflection.lit
    return lit(o.material, o.mesh.positions[last.position], @turn@o.mesh.normals[last.normal]);
    //@else
    return o.mesh.colors.empty() ? vec3{1, 1, 1} : o.mesh.colors[last.position];
    //@end
    //@else
    vec3 sum;
    for (const Corner& c : face)
        //@if reflection.lit
        sum = sum + o.mesh.positions[c.position];
    return lit(o.material, (1.0 / face.size()) * sum, @turn@o.facet_normals[t.face]);
        //@else
        sum = sum + (o.mesh.colors.empty() ? vec3{1, 1, 1} : o.mesh.colors[c.position]);
    return (1.0 / face.size()) * sum;
        //@end
    //@end
    //@else
    //@if corners
    //@if reflection.lit
    // Topic: Gouraud shading. The corners are lit, and their colours are interpolated.
    //@else
    // The corners' own colours are interpolated, without lighting.
    //@end
    vec3 sum;
    //@if interpolation.screen|interpolation.scanline
    for (const Weight& w : weights_of(o, s@xy@)) {
        const Corner& c = face[w.corner];
        const double weight = w.weight;
    //@else
    for (int i = 0; i < 3; ++i) {
        const Corner& c = face[t.corner[i]];
        const double weight = s.weight[i];
    //@end
        //@if reflection.lit
        sum = sum + weight * lit(o.material, o.mesh.positions[c.position], @turn@o.mesh.normals[c.normal]);
        //@else
        sum = sum + weight * (o.mesh.colors.empty() ? vec3{1, 1, 1} : o.mesh.colors[c.position]);
        //@end
    }
    return sum;
    //@else
    vec3 p;
    for (int i = 0; i < 3; ++i) p = p + s.weight[i] * o.mesh.positions[face[t.corner[i]].position];
    //@if mode.facet
    // The facet's normal, lit at each pixel.
    return lit(o.material, p, @turn@o.facet_normals[t.face]);
    //@else
    // Topic: Phong shading. Normals are interpolated and normalized again, and each pixel is lit.
    vec3 n;
    //@if interpolation.screen|interpolation.scanline
    for (const Weight& w : weights_of(o, s@xy@)) n = n + w.weight * o.mesh.normals[face[w.corner].normal];
    //@else
    for (int i = 0; i < 3; ++i) n = n + s.weight[i] * o.mesh.normals[face[t.corner[i]].normal];
    //@end
    //@if facet_normals
    if (length(n) < 1e-6) n = o.facet_normals[t.face];  // opposite normals cancel
    //@end
    //@if wrong.interpolated_normals_not_normalized|wrong.unnormalized_normals
    return lit(o.material, p, @turn@n);
    //@else
    return lit(o.material, p, @turn@unit(n));
    //@end
    //@end
    //@end
    //@end
}

// ---- The picture ----
unsigned char byte_of(double linear) {
    //@if exposure
    double shown = @exposure@ * linear;
    //@else
    double shown = linear;
    //@end
    //@if wrong.bytes_wrap
    //@if transfer.srgb|wrong.encoded_twice
    shown = srgb(shown);
    //@end
    const double rest = std::fmod(std::floor(255 * shown + 0.5), 256);
    return (unsigned char)(rest < 0 ? rest + 256 : rest);
    //@else
    shown = shown > 0 ? std::min(shown, 1.0) : 0;  // NaN is black
    //@if transfer.srgb
    shown = srgb(shown);  // linear light encoded for the display
    //@end
    //@if wrong.encoded_twice
    shown = srgb(shown);
    //@end
    return (unsigned char)(255 * shown + 0.5);
    //@end
}

int main() {
    //@if reflection.lit
    place_lights(view_from_world());
    //@end
    place_objects(view_from_world());
    for (std::size_t o = 0; o < placed.size(); ++o)
        for (std::size_t t = 0; t < placed[o].mesh.triangles.size(); ++t) rasterise(int(o), int(t));
    std::vector<vec3> picture(width * height, background);
    for (int i = 0; i < width * height; ++i)
        //@if needs.xy
        if (seen[i].object >= 0) picture[i] = color_of(seen[i], i % width + 0.5, i / width + 0.5);
        //@else
        if (seen[i].object >= 0) picture[i] = color_of(seen[i]);
        //@end
    FILE *ppm = std::fopen("picture.ppm", "wb"), *pfm = std::fopen("picture.pfm", "wb");
    if (!ppm || !pfm) return 1;
    std::fprintf(ppm, "P6\n%d %d\n255\n", width, height);
    for (const vec3& c : picture)
        for (double channel : {c.x, c.y, c.z}) std::fputc(byte_of(channel), ppm);
    std::fprintf(pfm, "PF\n%d %d\n-1.0\n", width, height);
    for (int y = height - 1; y >= 0; --y)  // bottom row first
        for (int x = 0; x < width; ++x) {
            //@if exposure
            const vec3 c = @exposure@ * picture[y * width + x];
            //@else
            const vec3& c = picture[y * width + x];
            //@end
            const float channels[3] = {float(c.x), float(c.y), float(c.z)};
            std::fwrite(channels, sizeof(float), 3, pfm);
        }
    return std::fclose(ppm) || std::fclose(pfm);
}
