# -*- coding: utf-8 -*- @title@
# Draws the scene with numpy: places the meshes, finds each pixel's visible face, and lights all pixels of an
# object at once. Writes picture.ppm (8 bit) and picture.pfm (linear light, not clamped).
# build: python3 -c "import numpy"
# run: python3 main.py
# build offscreen: python3 -c "import numpy"
# run offscreen: python3 main.py
# Needs Python 3 with numpy, and in the folder where it is run: @mesh_files@
# Colours are linear red, green, blue. Lighting is computed in camera coordinates: the eye is at the origin
# and looks along -z, x is right, y up.
#@can mode.phong spot.soft wrong.no_clamp_of_cosine flat.centroid exposure exponent.large lights.above_8 lights.above_32 shininess.large shininess.zero
#@can wrong.half_lambert wrong.unnormalized_half wrong.half_angle_with_phong_shininess wrong.reflect_sign wrong.reflect_of_difference
from collections import namedtuple
from types import SimpleNamespace as Named

import numpy as np

# ---- Vectors: the first axis is x, y, z, the second is the points ----
pi, max, sqrt, pow, abs = np.pi, np.maximum, np.sqrt, np.power, np.abs  # for entire arrays

def dot(a, b): return (a * b).sum(axis=0)
def cross(a, b): return np.cross(a, b, axis=0)
# a / b, or 0 for b = 0
def over(a, b): return np.where(b == 0, 0.0, a / np.where(b == 0, 1.0, b))
def unit(a): return over(1.0, sqrt(dot(a, a))) * a
def column(a): return np.array(a, float).reshape(3, -1)
# Transforms by a 4 x 4 matrix: w = 1 moves a point, w = 0 a direction.
def moved(matrix, a, w): return matrix[:3, :3] @ column(a) + w * matrix[:3, 3:]

# ---- The scene ----
width, height = @width@, @height@
@camera@
background = @background@
#@if reflection.lit
global_ambient = @global_ambient@
@lights@
#@end
@objects@

# ---- Camera ----
# Topic: the view matrix. Its rows are the camera's axes u (right), v (up), w (backwards).
axis_w = unit(np.subtract(eye, target))
axis_u = unit(np.cross(up, axis_w))
axes = np.array([axis_u, np.cross(axis_w, axis_u), axis_w])
view = np.eye(4)
view[:3, :3], view[:3, 3] = axes, -axes @ eye
# Topic: projection. The window on the near plane becomes -1 to 1 in x and y.
depth = far - near
#@if projection.frustum
projection = np.array([
    [2 * near / (right - left), 0, (right + left) / (right - left), 0],
    [0, 2 * near / (top - bottom), (top + bottom) / (top - bottom), 0],
    [0, 0, -(far + near) / depth, -2 * far * near / depth], [0, 0, -1, 0]])
#@else
#@if projection.orthographic
projection = np.array([[2 / view_height * height / width, 0, 0, 0], [0, 2 / view_height, 0, 0],
                       [0, 0, -2 / depth, -(far + near) / depth], [0, 0, 0, 1]])
#@else
f = 1 / np.tan(np.radians(fov_y_deg) / 2)
projection = np.array([[f * height / width, 0, 0, 0], [0, f, 0, 0],
                       [0, 0, -(far + near) / depth, -2 * far * near / depth], [0, 0, -1, 0]])
#@end
#@end

#@if reflection.lit
# ---- Lighting ----
#@if uses.power|uses.table_power|light.spot
def power(x, s):  # anything to the power 0 is 1, a negative cosine gives 0
    if s == 0:
        #@if wrong.power_zero_is_nan
        return np.where(x > 0, 1.0, np.nan)
        #@else
        return np.ones_like(x)
        #@end
    return np.where(x > 0, max(x, 1e-300) ** s, 0.0)

#@end
#@if uses.unclamped_power
def unclamped_power(x, s):  # also for negative x: negative only if s is an odd number
    return np.where((x < 0) & (abs(s - 2 * np.rint(s / 2)) >= 1), -1.0, 1.0) * abs(x) ** s

#@end
#@if uses.table_power
def table_power(x, s):  # the power of the nearest of @power_table@ cosines, as in a table
    return power(np.rint(np.clip(x, 0.0, 1.0) * (@power_table@ - 1)) / (@power_table@ - 1), s)

#@end
#@if uses.above_zero
def above_zero(x): return np.where(x > 0, 1.0, 0.0)

#@end
#@if transfer.srgb|wrong.encoded_twice|wrong.lit_in_srgb
def srgb(x): return np.where(x <= 0.0031308, 12.92 * x, 1.055 * abs(x) ** (1 / 2.4) - 0.055)

#@end
def place_lights():
    """Topic: light sources. World lights go through the view matrix; camera lights stay with the viewer."""
    sources = []  # in camera coordinates, colours times intensity; an area light has many
    for light in lights:
        #@if wrong.light_in_wrong_space
        to_camera = view if light.space == "camera" else np.eye(4)
        #@else
        #@if wrong.light_by_inverse_view
        to_camera = np.linalg.inv(view) if light.space == "world" else np.eye(4)
        #@else
        to_camera = view if light.space == "world" else np.eye(4)
        #@end
        #@end
        #@if wrong.light_moved_twice
        to_camera = view @ to_camera
        #@end
        s = Named(**light._asdict())
        #@if wrong.average_of_lights
        s.intensity = s.intensity / len(lights)
        #@end
        s.ambient, s.diffuse, s.specular = (
            s.intensity * column(c) for c in (light.ambient, light.diffuse, light.specular))
        #@if wrong.direction_is_position
        if light.kind == "directional":
            s.kind = "point"
        #@end
        s.position = moved(to_camera, light.position, 0 if s.kind == "directional" else 1)
        #@if light.directional
        if s.kind == "directional":
            #@if wrong.unnormalized_light
            pass
            #@else
            s.position = unit(s.position)
            #@end
            #@if wrong.light_direction_reversed
            s.position = -s.position
            #@end
            #@if wrong.falloff_of_directional
            r = sqrt(np.dot(light.position, light.position))
            s.constant, s.linear, s.quadratic = s.constant + r * (s.linear + r * s.quadratic), 0, 0
            #@end
        #@end
        #@if wrong.falloff_without_constant
        if light.kind in ("point", "spot"):
            s.constant = 0
        #@end
        #@if wrong.falloff_forgotten&light.falloff
        s.constant, s.linear, s.quadratic = 1, 0, 0
        #@end
        #@if light.spot
        #@if wrong.aim_stays_at_origin
        origin = np.zeros(3) if light.space == "world" else view[:3, 3]
        s.direction = unit(moved(to_camera, origin - light.position, 0))
        #@else
        s.direction = unit(moved(to_camera, light.direction, 0))
        #@end
        #@end
        #@if wrong.last_light_only
        sources = []
        #@end
        #@if light.area
        if light.kind == "area":  # Topic: area lights: many points, each a separate light
            s.edge_u, s.edge_v = moved(to_camera, light.edge_u, 0), moved(to_camera, light.edge_v, 0)
            steps = (2 * np.arange(light.cells) + 1) / light.cells - 1
            places = [s.position + a * s.edge_u + b * s.edge_v for a in steps for b in steps]
            sources += [Named(**{**vars(s), "position": place}) for place in places]
            continue
        #@end
        sources.append(s)
    return sources
sources = place_lights()
#@if first_light
first = Named(**vars(sources[0])) if sources else None  # the first light, without its samples
#@if light.area
if first and first.kind == "area":  # its centre
    first.position = np.mean([s.position for s in sources[:sources[0].cells ** 2]], axis=0)
#@end
#@end

def share_of(light, m, p, n, v):
    """What one light adds at points p with normals n, seen from directions v."""
    to_light = light.position if light.kind == "directional" else light.position - p
    #@if needs.l
    l = unit(to_light)
    #@end
    #@if light.falloff|light.area|light.spot
    strength = 1.0
    #@end
    #@if light.falloff
    # Topic: falloff with distance.
    distance = sqrt(dot(to_light, to_light))
    #@if wrong.falloff_inverted
    strength = light.constant + distance * (light.linear + distance * light.quadratic)
    #@else
    strength = over(1.0, light.constant + distance * (light.linear + distance * light.quadratic))
    #@end
    #@end
    #@if light.area
    if light.kind == "area":  # Topic: area lights: by the cosine at the light and the squared distance
        across = cross(light.edge_u, light.edge_v)
        strength = 4 * abs(dot(l, across)) * over(1.0, pi * light.cells ** 2 * dot(to_light, to_light))
    #@end
    #@if light.spot
    if light.kind == "spot":  # Topic: spot lights: a position, a direction, a cutoff
        #@if wrong.cutoff_as_full_angle
        angle = light.cutoff_deg / 2
        #@else
        angle = light.cutoff_deg
        #@end
        #@if wrong.degrees_for_radians
        edge = np.cos(angle)
        #@else
        edge = 0 if angle == 90 else np.cos(np.radians(angle))
        #@end
        along = dot(-l, light.direction)
        #@if wrong.cone_cosines_swapped
        strength = strength * np.where(along >= edge, 0.0, 1.0)
        #@else
        strength = strength * np.where(along >= edge, power(np.minimum(along, 1.0), light.exponent), 0.0)
        #@if spot.soft
        if light.inner_deg < angle:  # the soft edge: from the inner angle to the cutoff
            width = max(np.cos(np.radians(light.inner_deg)) - edge, 0.001)
            strength = strength * np.clip((along - edge) / width, 0.0, 1.0) ** 2
        #@end
        #@end
    #@end
    #@if uses.l_v
    l_v = dot(l, v)
    #@end
    #@if wrong.unnormalized_light&needs.l
    l = to_light
    #@end
    #@if uses.n_l
    n_l = dot(n, l)
    #@end
    #@if uses.n_v
    n_v = dot(n, v)
    #@end
    # Topic: the reflection model @model_name@.
@model@
    #@if wrong.missing_pi&terms.diffuse
    diffuse = diffuse / pi
    #@end
    #@if wrong.specular_behind_surface&uses.S
    # (no test of n.l: the highlight stays)
    #@else
    #@if uses.S&clamped_highlight
    #@if wrong.absolute_cosine
    S = np.where(abs(n_l) > 0, S, 0.0)  # a light behind the surface has no highlight
    #@else
    S = np.where(n_l > 0, S, 0.0)  # a light behind the surface has no highlight
    #@end
    #@end
    #@end
    total = np.zeros_like(n)
    #@if terms.ambient
    total = total + light.ambient * m.ambient
    #@if wrong.ambient_per_light_added_twice
    total = total + light.ambient * m.ambient
    #@end
    #@end
    #@if terms.diffuse
    total = total + diffuse * (light.diffuse * m.diffuse)
    #@end
    #@if uses.S
    total = total + S * (light.specular * m.specular)
    #@end
    #@if light.falloff|light.area|light.spot
    total = strength * total
    #@end
    #@if wrong.clamp_each_light
    total = np.clip(total, 0.0, 1.0)
    #@end
    return total

def lit(m, p, n):
    """Topic: the whole sum. The colours of points: emission, ambient light, and what each light adds."""
    #@if wrong.lit_after_projection
    p = over(moved(projection, p, 1), projection[3, :3] @ p + projection[3, 3])
    #@end
    #@if viewer.infinite
    v = np.zeros_like(p) + column((0, 0, 1))  # as if the eye were far away
    #@else
    #@if wrong.perspective_view_in_ortho
    #@end
    #@if wrong.viewer_at_origin_of_world
    to_eye = view[:3, 3:] - p
    #@else
    to_eye = -p  # the eye is the origin
    #@end
    #@if wrong.unnormalized_view
    v = to_eye
    #@else
    v = unit(to_eye)
    #@end
    #@end
    #@if wrong.view_reversed
    v = -v
    #@end
    #@if wrong.flipped_by_view
    n = np.where(dot(n, v) < 0, -n, n)
    #@end
    total = np.zeros_like(p)
    #@if tone
    # Topic: cool to warm. The side facing the first light is warm, the other cool.
    k_w = 0.5
    if first:
        to_first = first.position if first.kind == "directional" else first.position - p
        k_w = (1 + dot(n, unit(to_first))) / 2
    warm, cool = column(@warm@) + @beta@ * m.diffuse, column(@cool@) + @alpha@ * m.diffuse
    total = k_w * warm + (1 - k_w) * cool
    #@end
    #@if terms.emission
    total = total + m.emission
    #@end
    #@if terms.ambient
    total = total + m.ambient * column(global_ambient)
    #@end
    for light in sources:
        total = total + share_of(light, m, p, n, v)
    #@if corners.clamped
    return np.clip(total, 0.0, 1.0)  # OpenGL clamps the colours of corners before it interpolates them
    #@else
    return total
    #@end

#@else
#@if transfer.srgb|wrong.encoded_twice
def srgb(x): return np.where(x <= 0.0031308, 12.92 * x, 1.055 * abs(x) ** (1 / 2.4) - 0.055)

#@end
#@end
# ---- Meshes and their transforms ----
def read_mesh(name):
    words = iter(open(name).read().split())
    def count(): return int((next(words), next(words))[1])  # after its word
    def vectors():
        return np.array([[float(next(words)) for _ in range(3)] for _ in range(count())]).reshape(-1, 3).T
    positions, normals, colors = vectors(), vectors(), vectors()
    faces = [[(int(next(words)), int(next(words))) for _ in range(int(next(words)))] for _ in range(count())]
    triangles = np.array([[int(next(words)) for _ in range(4)] for _ in range(count())]).reshape(-1, 4)
    sizes = np.array([len(face) for face in faces])
    first = np.cumsum(sizes) - sizes  # the first corner of each polygon
    corners = np.array([corner for face in faces for corner in face]).T
    return Named(positions=positions, normals=normals, colors=colors, sizes=sizes, first=first, corners=corners,
                 face=triangles[:, 0], triangles=first[triangles[:, 0]][:, None] + triangles[:, 1:])

def rotation(a, b, degrees):  # from axis a towards axis b
    m = np.eye(4)
    m[a, a] = m[b, b] = np.cos(np.radians(degrees))
    m[b, a] = np.sin(np.radians(degrees))
    m[a, b] = -m[b, a]
    return m

def transform(translate, rotate, scale):  # M = T Rz Ry Rx S
    move = np.eye(4)
    move[:3, 3] = translate
    x, y, z = rotate
    return move @ rotation(0, 1, z) @ rotation(2, 0, y) @ rotation(1, 2, x) @ np.diag([*scale, 1.0])

#@if facet_normals
def facet_normals(o):
    """Topic: facet normals. Newell's sum of cross products around each polygon, outward if counter-clockwise."""
    p = o.positions[:, o.corners[0]]
    edge = p - np.repeat(p[:, o.first], o.sizes, axis=1)
    after = np.arange(p.shape[1]) + 1
    after[o.first + o.sizes - 1] = o.first
    #@if wrong.cross_reversed
    return -unit(np.add.reduceat(cross(edge, edge[:, after]), o.first, axis=1))  # (also in the mesh file)
    #@else
    return unit(np.add.reduceat(cross(edge, edge[:, after]), o.first, axis=1))
    #@end

#@end
def placed(thing):
    """An object in camera coordinates."""
    o = read_mesh(thing.mesh)
    to_camera = view @ transform(thing.translate, thing.rotate_deg, thing.scale)
    #@if sides|wrong.mirror_turns_inside_out
    o.mirrored = np.prod(thing.scale) < 0  # reverses the winding
    #@end
    #@if reflection.lit
    o.material = Named(**{k: column(x) if np.ndim(x) else x for k, x in thing.material._asdict().items()})
    #@if wrong.lit_in_srgb
    for name in set(vars(o.material)) & {"ambient", "diffuse", "specular", "emission"}:
        setattr(o.material, name, srgb(getattr(o.material, name)))
    #@end
    #@if wrong.coefficients_swapped
    o.material.diffuse, o.material.specular = o.material.specular, o.material.diffuse
    #@end
    #@if wrong.shininess_as_fraction&uses.shininess
    o.material.shininess = o.material.shininess / 128
    #@end
    #@if wrong.shininess_inverted&uses.shininess
    o.material.shininess = 1 / o.material.shininess if o.material.shininess > 0 else 0
    #@end
    #@if shininess.capped
    o.material.shininess = np.minimum(o.material.shininess, 128)  # OpenGL's maximum
    #@end
    #@if wrong.normals_left_in_object
    for_normals = np.eye(4)
    #@else
    #@if wrong.normals_left_in_world
    for_normals = transform((0, 0, 0), thing.rotate_deg, np.divide(1, thing.scale))
    #@else
    #@if wrong.normals_by_model_matrix|wrong.normals_as_points
    for_normals = to_camera
    #@else
    # Topic: normals use the inverse transpose of M: rotated like points, but scaled the other way.
    for_normals = view @ transform((0, 0, 0), thing.rotate_deg, np.divide(1, thing.scale))
    #@end
    #@end
    #@end
    #@if turned_normals
    side = 1
    #@end
    #@if normals.flip
    side = thing.side
    #@end
    #@if wrong.normals_flipped
    side = -side
    #@end
    #@if wrong.mirror_turns_inside_out
    side = -side if o.mirrored else side
    #@end

    def camera_normals(n):
        #@if wrong.no_normals_given
        n = np.zeros_like(n) + column((0, 0, 1))
        #@end
        #@if wrong.normals_as_points&!wrong.normals_left_in_object&!wrong.normals_left_in_world
        return moved(for_normals, @side@n, 1)
        #@else
        return moved(for_normals, @side@n, 0)
        #@end
    #@if facet_normals
    o.facet_normals = unit(camera_normals(facet_normals(o)))
    #@end
    #@if wrong.cross_reversed
    # (the mesh file's averaged normals come from such facet normals)
    #@end
    #@if wrong.unnormalized_normals
    o.normals = camera_normals(o.normals)
    #@else
    o.normals = unit(camera_normals(o.normals))
    #@end
    #@end
    o.positions = moved(to_camera, o.positions, 1)
    o.clip = projection @ np.vstack([o.positions, np.ones(o.positions.shape[1])])
    return o

# ---- Which face is visible ----
def weights_at(c, x, y):
    """The weights of triangles' corners where the rays through points of the screen (-1 to 1) meet their planes,
    and the points' depths. Uses only clip coordinates (4 x 3 x points), so nothing needs to be clipped."""
    dx, dy = c[0] - x * c[3], c[1] - y * c[3]
    e = dx[[1, 2, 0]] * dy[[2, 0, 1]] - dy[[1, 2, 0]] * dx[[2, 0, 1]]  # of the other two corners
    weights = over(e, e.sum(0))
    z, w = (weights * c[2]).sum(0), (weights * c[3]).sum(0)
    return weights, np.where(w > 0, over(z, w), 2.0), e.sum(0) < 0

placed_objects = [placed(o) for o in objects]
depths = np.ones((height, width))  # -1 at the near plane, 1 at the far one; 1e-12 covers rounding within a plane
seen_object, seen_triangle = np.full((height, width), -1), np.zeros((height, width), int)
ndc_x, ndc_y = 2 * (np.arange(width) + 0.5) / width - 1, 1 - 2 * (np.arange(height) + 0.5) / height

def rasterise(number, o):
    """Topic: rasterising. Each pixel keeps the nearest triangle at its centre."""
    c = o.clip[:, o.corners[0][o.triangles]]  # 4 x triangles x 3
    before_eye = (c[3] > 0).all(axis=1)
    px, py = (over(c[0], c[3]) + 1) / 2 * width, (1 - over(c[1], c[3])) / 2 * height
    # The pixels whose centres may be inside: none for most small triangles.
    def low(p): return np.where(before_eye, np.ceil(p.min(1) - 0.501), 0).clip(0, 99999).astype(int)
    def high(p, n): return np.where(before_eye, np.floor(p.max(1) - 0.499), n - 1).clip(-1, n - 1).astype(int)
    x0, x1, y0, y1 = low(px), high(px, width), low(py), high(py, height)
    #@if wrong.culled_by_light
    if first:
        centres = np.add.reduceat(o.positions[:, o.corners[0]], o.first, axis=1) / o.sizes
        to_light = first.position if first.kind == "directional" else first.position - centres
        x1[~(dot(o.facet_normals, to_light) > 0)[o.face]] = -1
    #@end
    for t in np.flatnonzero((x0 <= x1) & (y0 <= y1) & ~((c[:3] < -c[3]).all(2) | (c[:3] > c[3]).all(2)).any(0)):
        box = slice(y0[t], y1[t] + 1), slice(x0[t], x1[t] + 1)
        weights, depth, back = weights_at(c[:, t, :, None, None], ndc_x[box[1]], ndc_y[box[0]][:, None])
        inside = (weights >= 0).all(0) & (weights.sum(0) > 0.5) & (depth >= -1) & (depth < depths[box] - 1e-12)
        #@if cull.back
        inside &= back == o.mirrored
        #@end
        #@if cull.front
        inside &= back != o.mirrored
        #@end
        depths[box][inside] = depth[inside]
        seen_object[box][inside], seen_triangle[box][inside] = number, t

# ---- The colour of a pixel ----
#@if near_cut|interpolation.scanline
#@if interpolation.screen|interpolation.scanline
def on_screen(o, corners):
    """Corners on the screen in pixels; where the near plane cuts an edge, its ends and how far."""
    cut = []
    for a, b in zip(corners, [*corners[1:], corners[0]]):
        p, q = o.clip[:, o.corners[0][a]], o.clip[:, o.corners[0][b]]
        here, after = p[2] + p[3], q[2] + q[3]  # negative where it is cut off
        t = here / (here - after) if (here >= 0) != (after >= 0) else 0
        for at, share in [(p, 0)] * int(here >= 0) + [(p + t * (q - p), t)] * int(t != 0):
            cut.append(((at[0] / at[3] + 1) / 2 * width, (1 - at[1] / at[3]) / 2 * height, a, b, share))
    return cut

#@end
#@end
#@if interpolation.screen&near_cut
def screen_weights(o, corners, x, y):
    """Topic: interpolation on the screen. Linear over the triangle's image."""
    best, cut = (-1e9, []), on_screen(o, corners)
    for (ax, ay, *a), (bx, by, *b), (cx, cy, *c) in zip(cut[:1] * len(cut), cut[1:], cut[2:]):
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        wb = over((x - ax) * (cy - ay) - (y - ay) * (cx - ax), area)
        wc = over((bx - ax) * (y - ay) - (by - ay) * (x - ax), area)
        inside = np.min([1 - wb - wc, wb, wc]) if area else -1e9
        if inside > best[0]:
            best = inside, [(a, 1 - wb - wc), (b, wb), (c, wc)]
    return [part for (i, j, t), w in best[1] for part in ((i, w * (1 - t)), (j, w * t))]

#@end
#@if interpolation.scanline
def scanline_weights(o, corners, x, y):
    """Topic: Gouraud's interpolation: along the polygon's edges, then along the scanline."""
    polygon, crossings = on_screen(o, corners), []
    heights = [corner[1] for corner in polygon]
    y = np.clip(y, np.min(heights), np.nextafter(np.max(heights), -np.inf))
    for (ax, ay, *a), (bx, by, *b) in zip(polygon, [*polygon[1:], *polygon[:1]]):
        if (ay <= y) != (by <= y):
            share = (y - ay) / (by - ay)
            crossings.append((ax + share * (bx - ax), [(a, 1 - share), (b, share)]))
    crossings.sort(key=lambda crossing: crossing[0])
    pairs = list(zip(crossings[::2], crossings[1::2]))
    (left, from_left), (right, from_right) = pairs[np.argmin([np.max([l[0] - x, x - r[0], 0]) for l, r in pairs])]
    u = np.clip(over(x - left, right - left), 0, 1)
    return [part for ends, w in ((from_left, 1 - u), (from_right, u)) for (i, j, t), share in ends
            for part in ((i, w * share * (1 - t)), (j, w * share * t))]

#@end
def colors_of(number, o):
    """The colours of all pixels that show the object."""
    at_y, at_x = np.nonzero(seen_object == number)
    t = seen_triangle[at_y, at_x]
    corners = o.triangles[t].T  # 3 x pixels
    #@if needs.weights|turned
    weights, _, back = weights_at(o.clip[:, o.corners[0][corners]], ndc_x[at_x], ndc_y[at_y])
    #@end
    #@if interpolation.screen&!near_cut
    # Topic: interpolation on the screen. Linear over the triangle's image.
    on_screen = weights * o.clip[3, o.corners[0][corners]]
    blend = list(zip(corners, on_screen / on_screen.sum(0)))
    #@else
    #@if needs.xy
    # The corners of each pixel and their weights, one by one; padded to the same number for all pixels.
    #@if interpolation.scanline
    each = [scanline_weights(o, range(o.first[o.face[i]], o.first[o.face[i]] + o.sizes[o.face[i]]), x + 0.5, y + 0.5)
    #@else
    each = [screen_weights(o, list(o.triangles[i]), x + 0.5, y + 0.5)
    #@end
            for i, x, y in zip(t, at_x, at_y)]
    each = np.array([parts + [(0, 0)] * (8 - len(parts)) for parts in each]).reshape(-1, 8, 2)
    blend = [(each[:, k, 0].astype(int), each[:, k, 1]) for k in range(8)]
    #@else
    #@if needs.blend
    blend = list(zip(corners, weights))
    #@end
    #@end
    #@end
    #@if turned
    turn = np.ones(len(t))
    #@end
    #@if two_sided
    turn = np.where(back != o.mirrored, -turn, turn)  # seen from behind, the normal is reversed
    #@end
    #@if two_sided&wrong.flipped_twice
    turn = np.where(back != o.mirrored, -turn, turn)
    #@end
    #@if wrong.some_faces_flipped
    turn = np.where(o.face[t] % 3 == 0, -turn, turn)
    #@end
    #@if mode.flat
    # Topic: flat shading. One point of the polygon is lit, and the entire polygon has that colour.
    #@if flat.provoking
    position, normal = o.corners[:, corners[2]]
    #@if reflection.lit
    return lit(o.material, o.positions[:, position], @turn@o.normals[:, normal])
    #@else
    return o.colors[:, position] if o.colors.size else np.ones((3, len(t)))
    #@end
    #@else
    #@if reflection.lit
    centres = np.add.reduceat(o.positions[:, o.corners[0]], o.first, axis=1) / o.sizes
    return lit(o.material, centres[:, o.face[t]], @turn@o.facet_normals[:, o.face[t]])
    #@else
    colors = o.colors if o.colors.size else np.ones_like(o.positions)
    return (np.add.reduceat(colors[:, o.corners[0]], o.first, axis=1) / o.sizes)[:, o.face[t]]
    #@end
    #@end
    #@else
    #@if corners
    #@if reflection.lit
    # Topic: Gouraud shading. The corners are lit, and their colours are interpolated.
    lit_corners = lambda c: lit(o.material, o.positions[:, o.corners[0][c]], @turn@o.normals[:, o.corners[1][c]])
    return sum(w * lit_corners(c) for c, w in blend)
    #@else
    # The corners' own colours are interpolated, without lighting.
    colors = o.colors if o.colors.size else np.ones_like(o.positions)
    return sum(w * colors[:, o.corners[0][c]] for c, w in blend)
    #@end
    #@else
    p = sum(w * o.positions[:, o.corners[0][c]] for c, w in zip(corners, weights))
    #@if mode.facet
    # The facet's normal, lit at each pixel.
    return lit(o.material, p, @turn@o.facet_normals[:, o.face[t]])
    #@else
    # Topic: Phong shading. Normals are interpolated and normalized again, and each pixel is lit.
    n = sum(w * o.normals[:, o.corners[1][c]] for c, w in blend)
    #@if facet_normals
    n = np.where(sqrt(dot(n, n)) < 1e-6, o.facet_normals[:, o.face[t]], n)  # opposite normals cancel
    #@end
    #@if wrong.interpolated_normals_not_normalized|wrong.unnormalized_normals
    return lit(o.material, p, @turn@n)
    #@else
    return lit(o.material, p, @turn@unit(n))
    #@end
    #@end
    #@end
    #@end

# ---- The picture ----
picture = np.tile(np.array(background, float), (height, width, 1))
for number, o in enumerate(placed_objects):
    rasterise(number, o)
for number, o in enumerate(placed_objects):
    if (seen_object == number).any():
        picture[seen_object == number] = colors_of(number, o).T
#@if exposure
picture = @exposure@ * picture
#@end
with open("picture.pfm", "wb") as file:  # bottom row first
    file.write(b"PF\n%d %d\n-1.0\n" % (width, height) + picture[::-1].astype("<f4").tobytes())
#@if wrong.bytes_wrap
shown = picture
#@else
shown = np.nan_to_num(picture, nan=0.0).clip(0, 1)  # NaN is black
#@end
#@if transfer.srgb
shown = srgb(shown)  # linear light encoded for the display
#@end
#@if wrong.encoded_twice
shown = srgb(shown)
#@end
with open("picture.ppm", "wb") as file:
    #@if wrong.bytes_wrap
    file.write(b"P6\n%d %d\n255\n" % (width, height) + np.floor(255 * shown + 0.5).astype(int).astype("u1").tobytes())
    #@else
    file.write(b"P6\n%d %d\n255\n" % (width, height) + (255 * shown + 0.5).astype("u1").tobytes())
    #@end
