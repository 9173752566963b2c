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

//@if transfer.srgb|wrong.encoded_twice
float srgb(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }
vec3 srgb(vec3 c) { return vec3(srgb(c.r), srgb(c.g), srgb(c.b)); }

//@end
void main() {
    //@if lights_pixels
    //@if wrong.interpolated_normals_not_normalized|wrong.unnormalized_normals
    vec3 turned = n@over_w@;
    //@else
    vec3 turned = unit(n@over_w@);  // interpolated normals are shorter than 1
    //@end
    //@if two_sided
    if (!gl_FrontFacing) turned = -turned;  // seen from behind, the normal is turned round
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
