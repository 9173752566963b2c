// Topic: shading. The colour of a pixel.
//@if lights_pixels
smooth in vec3 p;
smooth in vec3 n;
//@else
@blending@ in vec3 front;
//@if two_sided
@blending@ in vec3 back;
//@end
//@end
out vec4 shown;
//@if measured
out vec4 raw;  // the colour before exposure; 2 if a loop was stopped, else 1
//@if lights_pixels
out vec4 raw_p, raw_n;
//@else
smooth in float stopped;
//@end
//@end

//@if transfer.srgb|wrong.encoded_twice
float srgb(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }
vec3 srgb(vec3 c) { return vec3(srgb(c.r), srgb(c.g), srgb(c.b)); }

//@end
void main() {
    //@if lights_pixels
    //@if wrong.interpolated_normals_not_normalized|wrong.unnormalized_normals
    vec3 turned = n@over_w@;
    //@else
    vec3 turned = n@over_w@;
    if (dot(turned, turned) > 0.0) turned = normalize(turned);  // interpolated normals are shorter than 1
    //@end
    //@if two_sided
    if (!gl_FrontFacing) turned = -turned;  // seen from behind, the normal is reversed
    //@end
    //@if two_sided&wrong.flipped_twice
    if (!gl_FrontFacing) turned = -turned;
    //@end
    vec3 color = lit(p, turned);
    //@else
    //@if two_sided&!wrong.flipped_twice
    vec3 color = (gl_FrontFacing ? front : back)@over_w@;
    //@else
    vec3 color = front@over_w@;
    //@if wrong.flipped_twice
    //@end
    //@end
    //@end
    //@if measured
    //@if lights_pixels
    raw = vec4(color, loop_runs_so_far > @max_loop_runs@ ? 2.0 : 1.0);
    raw_p = vec4(p, 1.0);
    raw_n = vec4(turned, 1.0);
    //@else
    raw = vec4(color, stopped > 0.0 ? 2.0 : 1.0);
    //@end
    //@end
    //@if exposure
    color *= @exposure@;
    //@end
    //@if wrong.bytes_wrap
    //@if transfer.srgb|wrong.encoded_twice
    color = srgb(color);
    //@end
    shown = vec4(mod(floor(255.0 * color + 0.5), 256.0) / 255.0, 1.0);
    //@else
    color = clamp(color, 0.0, 1.0);
    //@if transfer.srgb
    color = srgb(color);  // linear light encoded for the display
    //@end
    //@if wrong.encoded_twice
    color = srgb(color);
    //@end
    shown = vec4(color, 1.0);
    //@end
}
