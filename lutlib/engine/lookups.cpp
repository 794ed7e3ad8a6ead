#include "lutlib/engine/lookups.h"

#include "lutlib/color/encoding.h"
#include "lutlib/interpolation/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::lookup {
namespace {

Rgb mix(Rgb a, Rgb b, float t) {
    return a * (1 - t) + b * t;
}

float fract(float x) {
    return x - std::floor(x);
}

const Rgb& texel_clamped(const Picture& picture, int x, int y) {
    return picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
}

// A linear sampler with clamped addressing; texture coordinates 0..1.
Rgb bilinear(const Picture& picture, float u, float v) {
    const float x = u * static_cast<float>(picture.width) - 0.5F;
    const float y = v * static_cast<float>(picture.height) - 0.5F;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const float fx = fract(x), fy = fract(y);
    return mix(mix(texel_clamped(picture, x0, y0), texel_clamped(picture, x0 + 1, y0), fx),
               mix(texel_clamped(picture, x0, y0 + 1), texel_clamped(picture, x0 + 1, y0 + 1), fx),
               fy);
}

// The lattice of a picture, read node by node where an engine keeps it as a 3D texture or fetches
// texels.
struct Lattice {
    const Picture& picture;
    const Layout& layout;
    int n;

    const Rgb& at(int r, int g, int b) const {
        const Pixel p = layout.pixel(n, picture.width, r, g, b);
        return picture.at(p.x, p.y);
    }
};

struct Axis {
    int low, high;
    float f;
};

// `x` in units of nodes, which may lie half a node outside; clamped addressing.
Axis axis_at(float x, int n) {
    const float floor = std::floor(x);
    const int i = static_cast<int>(floor);
    return {std::clamp(i, 0, n - 1), std::clamp(i + 1, 0, n - 1), x - floor};
}

Rgb trilinear(const Lattice& l, Rgb x) {
    const Axis r = axis_at(x.r, l.n), g = axis_at(x.g, l.n), b = axis_at(x.b, l.n);
    const auto row = [&](int gi, int bi) {
        return mix(l.at(r.low, gi, bi), l.at(r.high, gi, bi), r.f);
    };
    return mix(mix(row(g.low, b.low), row(g.high, b.low), g.f),
               mix(row(g.low, b.high), row(g.high, b.high), g.f), b.f);
}

Rgb tetrahedral(const Lattice& l, Rgb x) {
    std::array<Axis, 3> axes{axis_at(x.r, l.n), axis_at(x.g, l.n), axis_at(x.b, l.n)};
    const Walk& order = axes_by_fraction(std::array{axes[0].f, axes[1].f, axes[2].f});
    std::array<int, 3> node{axes[0].low, axes[1].low, axes[2].low};
    Rgb sum = l.at(node[0], node[1], node[2]) * (1 - axes[order[0]].f);
    for (std::size_t step = 0; step < 3; ++step) {
        const Axis& axis = axes[order[step]];
        node[order[step]] = axis.high;
        const float next = step < 2 ? axes[order[step + 1]].f : 0.0F;
        sum = sum + l.at(node[0], node[1], node[2]) * (axis.f - next);
    }
    return sum;
}

Lattice lattice_of(const Picture& picture, std::string_view layout, int n) {
    return {picture, *layout_named(layout), n};
}

Rgb each_channel(double (Encoding::*f)(double) const, Rgb c) {
    return {static_cast<float>((srgb().*f)(c.r)), static_cast<float>((srgb().*f)(c.g)),
            static_cast<float>((srgb().*f)(c.b))};
}

// One fetch of a 3D texture, at the centres of its outer texels for 0 and 1.
Rgb from_texel_centres(const Lattice& lattice, Rgb in) {
    const float size = static_cast<float>(lattice.n);
    const Rgb uvw = Rgb{0.5F, 0.5F, 0.5F} * (1 / size) + saturate(in) * (1 - 1 / size);
    return trilinear(lattice, uvw * size - Rgb{0.5F, 0.5F, 0.5F});
}

} // namespace

Rgb piccolo(const Picture& picture, int n, Rgb in) {
    return trilinear(lattice_of(picture, "strip", n), saturate(in) * static_cast<float>(n - 1));
}

// Two bilinear fetches of neighbouring slices, blended on blue. The half texel keeps each fetch
// inside its slice.
Rgb unreal(const Picture& picture, int n, Rgb in) {
    const float size = static_cast<float>(n);
    const Rgb uvw = saturate(in) * ((size - 1) / size) + Rgb{0.5F, 0.5F, 0.5F} * (1 / size);
    const float z = uvw.b * size - 0.5F;
    const float slice = std::floor(z);
    const float u = (uvw.r + slice) / size;
    return mix(bilinear(picture, u, uvw.g), bilinear(picture, u + 1 / size, uvw.g), z - slice);
}

// As above with v counted from the bottom row, which is the first in Unity's texture memory.
Rgb unity(const Picture& picture, int n, Rgb in) {
    const float width = static_cast<float>(picture.width), height = static_cast<float>(n);
    const Rgb scaled = saturate(in) * (height - 1);
    const float slice = std::floor(scaled.b);
    const float u = scaled.r / width + 0.5F / width + slice / height;
    const float v = 1 - (scaled.g / height + 0.5F / height);
    return mix(bilinear(picture, u, v), bilinear(picture, u + 1 / height, v), scaled.b - slice);
}

Rgb reshade(const Picture& picture, int n, Rgb in) {
    const float size = static_cast<float>(n);
    const Rgb c = saturate(in);
    const float texel_x = 1 / size / size, texel_y = 1 / size;
    const float z = c.b * size - c.b;
    const float blend = fract(z);
    const float u = (c.r * size - c.r + 0.5F) * texel_x + (z - blend) * texel_y;
    const float v = (c.g * size - c.g + 0.5F) * texel_y;
    return mix(bilinear(picture, u, v), bilinear(picture, u + texel_y, v), blend);
}

// An sRGB texture: its sampler filters light.
Rgb playcanvas(const Picture& picture, int n, Rgb in) {
    const float size = static_cast<float>(n), width = size * size;
    const Rgb c = saturate(in);
    const float cell = c.b * (size - 1), low = std::floor(cell), high = std::ceil(cell);
    const auto texel = [&](int x, int y) {
        return each_channel(&Encoding::decode, texel_clamped(picture, x, y));
    };
    const auto slice = [&](float at) {
        const float u = at / size + 0.5F / width + c.r / size * ((size - 1) / size);
        const float v = 0.5F / size + c.g * ((size - 1) / size);
        const float x = u * width - 0.5F, y = v * size - 0.5F;
        const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
        return mix(mix(texel(x0, y0), texel(x0 + 1, y0), fract(x)),
                   mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fract(x)), fract(y));
    };
    return each_channel(&Encoding::encode, mix(slice(low), slice(high), fract(cell)));
}

Rgb obs(const Picture& picture, int n, Rgb in) {
    return trilinear(lattice_of(picture, "tiles", n), saturate(in) * static_cast<float>(n - 1));
}

Rgb threejs(const Picture& picture, int n, Rgb in) {
    return from_texel_centres(lattice_of(picture, "strip", n), in);
}

Rgb o3de(const Picture& picture, int n, Rgb in) {
    return from_texel_centres(lattice_of(picture, "ocio", n), in);
}

Rgb godot(const Picture& picture, int n, Rgb in) {
    const Rgb x = saturate(in) * static_cast<float>(n) - Rgb{0.5F, 0.5F, 0.5F};
    return trilinear(lattice_of(picture, "tiles", n), x);
}

Rgb hald(const Picture& picture, int n, Rgb in) {
    return tetrahedral(lattice_of(picture, "hald", n), saturate(in) * static_cast<float>(n - 1));
}

Rgb ocio(const Picture& picture, int n, Rgb in) {
    return tetrahedral(lattice_of(picture, "ocio", n), saturate(in) * static_cast<float>(n - 1));
}

} // namespace lutlib::lookup
