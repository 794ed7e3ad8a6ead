// The ways of reading a look, by the names that rows of preview/look/gpu_lookups.cpp and of
// lutlib/engine/engine.cpp call them; the build writes the choice among the rows from those
// (rows/lookups.glsl). The engines' own are those of lutlib/engine/lookups.cpp and the float .cube
// that of lutlib/interpolation, operation for operation and without contraction where a rounding of
// a coordinate would show, so that they agree to float rounding; only the rows that say so leave
// the filtering to the texture unit and its few bits of fraction.
//
// A lookup of a picture takes (picture, n nodes a side, colour within 0..1), one of a table
// (volume, shaper, look, any colour).
#include "common/sanitise.glsl"
#include "common/srgb.glsl"

struct Look {
    vec4 shaper_min, shaper_max;
    vec4 cube_min, cube_max;
    int size;        // of the lattice; 0: no lattice
    int shaper_size; // 0: no shaper
    int shaper_row;  // entries in a row of the shaper's image
    int unused;
};

const int layout_strip = 0;
const int layout_tiles = 1;
const int layout_hald = 2;
const int layout_ocio = 3;

// Two products: t = 1 gives b exactly.
vec3 blend(vec3 a, vec3 b, float t) {
    return a * (1.0 - t) + b * t;
}

// The lower node of the cell and the fraction in it, from one clamped value. `x` may lie half a
// node outside of 0..n-1.
struct Axis {
    int low, high;
    float f;
};

Axis axis_at(float x, int n) {
    float whole = floor(x);
    int i = int(whole);
    return Axis(clamp(i, 0, n - 1), clamp(i + 1, 0, n - 1), x - whole);
}

// The same of a value that lies within 0..n-1; the last node belongs to the last cell.
Axis axis_within(float x, int n) {
    int i = min(int(x), n - 2);
    return Axis(i, i + 1, x - float(i));
}

ivec2 texel_of(int arrangement, int n, int width, ivec3 node) {
    if (arrangement == layout_strip) {
        return ivec2(node.b * n + node.r, node.g);
    }
    if (arrangement == layout_ocio) {
        int i = node.r + n * (node.g + n * node.b);
        return ivec2(i % width, i / width);
    }
    int per_row = width / n;
    if (arrangement == layout_tiles) {
        return ivec2(node.b % per_row * n + node.r, node.b / per_row * n + node.g);
    }
    return ivec2(node.g % per_row * n + node.r, node.b * per_row + node.g / per_row);
}

vec3 node_at(sampler2D picture, int arrangement, int n, int r, int g, int b) {
    return texelFetch(picture, texel_of(arrangement, n, textureSize(picture, 0).x, ivec3(r, g, b)),
                      0)
        .rgb;
}

vec3 trilinear_picture(sampler2D picture, int arrangement, int n, vec3 x) {
    Axis r = axis_at(x.r, n), g = axis_at(x.g, n), b = axis_at(x.b, n);
    vec3 row[4];
    for (int i = 0; i < 4; ++i) {
        int gi = (i & 1) == 0 ? g.low : g.high, bi = i < 2 ? b.low : b.high;
        row[i] = blend(node_at(picture, arrangement, n, r.low, gi, bi),
                       node_at(picture, arrangement, n, r.high, gi, bi), r.f);
    }
    return blend(blend(row[0], row[1], g.f), blend(row[2], row[3], g.f), b.f);
}

// The corners of the cell that a tetrahedral walk visits between its dark and its bright one, and
// the fractions in falling order.
struct Walk {
    ivec3 first, second;
    vec3 f;
};

Walk walk_of(vec3 f) {
    bool rg = f.r > f.g, gb = f.g > f.b, rb = f.r > f.b;
    ivec3 first, last;
    if (rg) {
        first = rb ? ivec3(1, 0, 0) : ivec3(0, 0, 1);
    } else {
        first = f.b > f.g ? ivec3(0, 0, 1) : ivec3(0, 1, 0);
    }
    if (rg) {
        last = gb ? ivec3(0, 0, 1) : ivec3(0, 1, 0);
    } else {
        last = f.b > f.r ? ivec3(1, 0, 0) : ivec3(0, 0, 1);
    }
    float high = max(f.r, max(f.g, f.b)), low = min(f.r, min(f.g, f.b));
    float middle = max(min(f.r, f.g), min(max(f.r, f.g), f.b));
    return Walk(first, ivec3(1) - last, vec3(high, middle, low));
}

vec3 tetrahedral_picture(sampler2D picture, int arrangement, int n, vec3 x) {
    Axis r = axis_at(x.r, n), g = axis_at(x.g, n), b = axis_at(x.b, n);
    ivec3 low = ivec3(r.low, g.low, b.low), high = ivec3(r.high, g.high, b.high);
    Walk walk = walk_of(vec3(r.f, g.f, b.f));
    ivec3 first = low + (high - low) * walk.first, second = low + (high - low) * walk.second;
    return node_at(picture, arrangement, n, low.r, low.g, low.b) * (1.0 - walk.f.x) +
           node_at(picture, arrangement, n, first.r, first.g, first.b) * (walk.f.x - walk.f.y) +
           node_at(picture, arrangement, n, second.r, second.g, second.b) * (walk.f.y - walk.f.z) +
           node_at(picture, arrangement, n, high.r, high.g, high.b) * walk.f.z;
}

// A linear sampler with clamped addressing, by hand.
vec3 bilinear_picture(sampler2D picture, float u, float v) {
    ivec2 size = textureSize(picture, 0);
    precise float x = u * float(size.x) - 0.5, y = v * float(size.y) - 0.5;
    Axis h = axis_at(x, size.x), w = axis_at(y, size.y);
    return blend(blend(texelFetch(picture, ivec2(h.low, w.low), 0).rgb,
                       texelFetch(picture, ivec2(h.high, w.low), 0).rgb, h.f),
                 blend(texelFetch(picture, ivec2(h.low, w.high), 0).rgb,
                       texelFetch(picture, ivec2(h.high, w.high), 0).rgb, h.f),
                 w.f);
}

vec3 unreal(sampler2D picture, int n, vec3 c) {
    float size = float(n);
    precise vec3 uvw = c * ((size - 1.0) / size) + 0.5 * (1.0 / size);
    precise float z = uvw.b * size - 0.5;
    float slice = floor(z);
    precise float u = (uvw.r + slice) / size;
    return blend(bilinear_picture(picture, u, uvw.g),
                 bilinear_picture(picture, u + 1.0 / size, uvw.g), z - slice);
}

vec3 unity(sampler2D picture, int n, vec3 c) {
    float width = float(textureSize(picture, 0).x), height = float(n);
    vec3 scaled = c * (height - 1.0);
    float slice = floor(scaled.b);
    precise float u = scaled.r / width + 0.5 / width + slice / height;
    precise float v = 1.0 - (scaled.g / height + 0.5 / height);
    return blend(bilinear_picture(picture, u, v), bilinear_picture(picture, u + 1.0 / height, v),
                 scaled.b - slice);
}

vec3 reshade(sampler2D picture, int n, vec3 c) {
    float size = float(n);
    float texel_x = 1.0 / size / size, texel_y = 1.0 / size;
    precise float z = c.b * size - c.b;
    float share = z - floor(z);
    precise float u = (c.r * size - c.r + 0.5) * texel_x + (z - share) * texel_y;
    precise float v = (c.g * size - c.g + 0.5) * texel_y;
    return blend(bilinear_picture(picture, u, v), bilinear_picture(picture, u + texel_y, v), share);
}

// As an sRGB texture is filtered: texels in light.
vec3 light_at(sampler2D picture, int x, int y) {
    ivec2 last = textureSize(picture, 0) - 1;
    return srgb_decode(texelFetch(picture, clamp(ivec2(x, y), ivec2(0), last), 0).rgb);
}

vec3 slice_in_light(sampler2D picture, float size, vec2 c, float slice) {
    float width = size * size;
    precise float u = slice / size + 0.5 / width + c.r / size * ((size - 1.0) / size);
    precise float v = 0.5 / size + c.g * ((size - 1.0) / size);
    precise float x = u * width - 0.5, y = v * size - 0.5;
    int x0 = int(floor(x)), y0 = int(floor(y));
    float fx = x - floor(x), fy = y - floor(y);
    return blend(blend(light_at(picture, x0, y0), light_at(picture, x0 + 1, y0), fx),
                 blend(light_at(picture, x0, y0 + 1), light_at(picture, x0 + 1, y0 + 1), fx), fy);
}

vec3 playcanvas(sampler2D picture, int n, vec3 c) {
    float size = float(n);
    precise float cell = c.b * (size - 1.0);
    return srgb_encode(blend(slice_in_light(picture, size, c.rg, floor(cell)),
                             slice_in_light(picture, size, c.rg, ceil(cell)),
                             cell - floor(cell)));
}

// The texture unit filters two slices; half a texel in keeps each fetch inside its own.
vec3 strip_bilinear(sampler2D picture, int n, vec3 c) {
    float size = float(n);
    vec3 x = c * (size - 1.0);
    float slice = min(floor(x.b), size - 2.0);
    vec2 uv = vec2((slice * size + x.r + 0.5) / (size * size), (x.g + 0.5) / size);
    return mix(textureLod(picture, uv, 0.0).rgb,
               textureLod(picture, uv + vec2(1.0 / size, 0.0), 0.0).rgb, x.b - slice);
}

vec3 volume_filtered(sampler3D volume, sampler2D shaper, Look look, vec3 c) {
    float size = float(look.size);
    return textureLod(volume, (saturate(c) * (size - 1.0) + 0.5) / size, 0.0).rgb;
}

// Where a value stands among n nodes over lowest..highest; outside it is clamped, NaN is lowest.
float lattice_coordinate(float value, float lowest, float highest, int n) {
    return saturate((value - lowest) / (highest - lowest)) * float(n - 1);
}

vec3 lattice_coordinates(vec3 c, vec3 lowest, vec3 highest, int n) {
    return vec3(lattice_coordinate(c.r, lowest.r, highest.r, n),
                lattice_coordinate(c.g, lowest.g, highest.g, n),
                lattice_coordinate(c.b, lowest.b, highest.b, n));
}

vec3 shape(sampler2D shaper, Look look, vec3 c) {
    vec3 x = lattice_coordinates(c, look.shaper_min.rgb, look.shaper_max.rgb, look.shaper_size);
    vec3 shaped;
    for (int channel = 0; channel < 3; ++channel) {
        Axis axis = axis_within(x[channel], look.shaper_size);
        ivec2 low = ivec2(axis.low % look.shaper_row, axis.low / look.shaper_row);
        ivec2 high = ivec2(axis.high % look.shaper_row, axis.high / look.shaper_row);
        shaped[channel] = texelFetch(shaper, low, 0)[channel] * (1.0 - axis.f) +
                          texelFetch(shaper, high, 0)[channel] * axis.f;
    }
    return shaped;
}

// A colour's place among the nodes of a lattice, after the shaper; false where the look has no
// lattice, and `x` is the result.
bool place_in_cube(sampler2D shaper, Look look, vec3 c, out vec3 x) {
    x = look.shaper_size > 0 ? shape(shaper, look, c) : c;
    if (look.size > 0) {
        x = lattice_coordinates(x, look.cube_min.rgb, look.cube_max.rgb, look.size);
    }
    return look.size > 0;
}

vec3 table_nearest(sampler3D cube, sampler2D shaper, Look look, vec3 c) {
    vec3 x;
    return place_in_cube(shaper, look, c, x) ? texelFetch(cube, ivec3(x + 0.5), 0).rgb : x;
}

vec3 table_trilinear(sampler3D cube, sampler2D shaper, Look look, vec3 c) {
    vec3 x;
    if (!place_in_cube(shaper, look, c, x)) {
        return x;
    }
    Axis r = axis_within(x.r, look.size), g = axis_within(x.g, look.size),
         b = axis_within(x.b, look.size);
    vec3 line[4];
    for (int i = 0; i < 4; ++i) {
        ivec3 start = ivec3(r.low, g.low, b.low) + ivec3(0, i & 1, i >> 1);
        line[i] = blend(texelFetch(cube, start, 0).rgb,
                        texelFetch(cube, start + ivec3(1, 0, 0), 0).rgb, r.f);
    }
    return blend(blend(line[0], line[1], g.f), blend(line[2], line[3], g.f), b.f);
}

vec3 table_tetrahedral(sampler3D cube, sampler2D shaper, Look look, vec3 c) {
    vec3 x;
    if (!place_in_cube(shaper, look, c, x)) {
        return x;
    }
    Axis r = axis_within(x.r, look.size), g = axis_within(x.g, look.size),
         b = axis_within(x.b, look.size);
    ivec3 low = ivec3(r.low, g.low, b.low);
    Walk walk = walk_of(vec3(r.f, g.f, b.f));
    return texelFetch(cube, low, 0).rgb * (1.0 - walk.f.x) +
           texelFetch(cube, low + walk.first, 0).rgb * (walk.f.x - walk.f.y) +
           texelFetch(cube, low + walk.second, 0).rgb * (walk.f.y - walk.f.z) +
           texelFetch(cube, low + ivec3(1), 0).rgb * walk.f.z;
}
