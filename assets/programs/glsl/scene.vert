// Topic: geometry. Takes a corner from object to camera to clip coordinates.
layout(location = 0) in vec3 position;  // object coordinates
//@if reflection.lit
layout(location = 1) in vec3 normal;
//@if !lights_pixels
layout(location = 2) in vec3 lit_at;  // where the corner is lit: with flat shading, the polygon's centroid
//@end
//@else
layout(location = 3) in vec3 color;  // the mesh's own colour
//@end

uniform mat4 camera_from_object, clip_from_camera;
//@if reflection.lit
uniform mat4 for_normals;  // Topic: normals use the inverse transpose
//@end

//@if lights_pixels
smooth out vec3 p;
smooth out vec3 n;
//@else
@blending@ out vec3 front;  // the colour seen from the front
//@if two_sided
@blending@ out vec3 back;  // and from the back, where the normal is reversed
//@end
//@if measured
smooth out float stopped;  // above 0: a loop ran too many times
//@end
//@end

void main() {
    vec4 place = camera_from_object * vec4(position, 1.0);
    gl_Position = clip_from_camera * place;
    //@if reflection.lit
    //@if wrong.normals_as_points&!wrong.normals_left_in_object&!wrong.normals_left_in_world
    vec3 turned = (for_normals * vec4(normal, 1.0)).xyz;
    //@else
    vec3 turned = mat3(for_normals) * normal;
    //@end
    //@if !wrong.unnormalized_normals|facet_normals_alone
    turned = dot(turned, turned) > 0.0 ? normalize(turned) : turned;
    //@end
    //@if lights_pixels
    // Topic: Phong shading. Normals are interpolated, and each pixel is lit.
    p = place.xyz;
    n = turned;
    //@else
    // Topic: Gouraud and flat shading. Corners are lit, and pixels use their colours.
    vec3 at = (camera_from_object * vec4(lit_at, 1.0)).xyz;
    front = lit(at, turned);
    //@if two_sided
    back = lit(at, -turned);
    //@end
    //@if measured
    stopped = loop_runs_so_far > @max_loop_runs@ ? 1.0 : 0.0;
    //@end
    //@end
    //@else
    front = color;  // without lighting
    //@end
    //@if interpolation.screen
    // Linear on the screen: times w here, divided by w at the pixel. noperspective should do the same, but Mesa
    // clips it wrongly where a face extends beyond the picture.
    //@if lights_pixels
    n *= gl_Position.w;
    //@else
    front *= gl_Position.w;
    //@if two_sided
    back *= gl_Position.w;
    //@end
    //@end
    //@end
}
