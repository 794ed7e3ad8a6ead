#include "lutlib/engine/engine.h"

#include "lutlib/color/encoding.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
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
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return axes[a].f > axes[b].f; });
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

double at_lattice(int i, int n) {
    return static_cast<double>(i) / (n - 1);
}

// Godot reads node i at (i + 1/2) / n. The end nodes hold black and white themselves, which the
// clamped sampler reaches, rather than the colours half a node inside.
double at_texel_centre(int i, int n) {
    return i == 0 ? 0.0 : i == n - 1 ? 1.0 : (i + 0.5) / n;
}

double place_at_lattice(double in, int n) {
    return in * (n - 1);
}

double place_at_texel_centre(double in, int n) {
    return std::clamp(in * n - 0.5, 0.0, n - 1.0);
}

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

Rgb each_channel(double (Encoding::*f)(double) const, Rgb c) {
    return {static_cast<float>((srgb().*f)(c.r)), static_cast<float>((srgb().*f)(c.g)),
            static_cast<float>((srgb().*f)(c.b))};
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

// One fetch of a 3D texture, at the centres of its outer texels for 0 and 1.
Rgb from_texel_centres(const Lattice& lattice, Rgb in) {
    const float size = static_cast<float>(lattice.n);
    const Rgb uvw = Rgb{0.5F, 0.5F, 0.5F} * (1 / size) + saturate(in) * (1 - 1 / size);
    return trilinear(lattice, uvw * size - Rgb{0.5F, 0.5F, 0.5F});
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

constexpr std::array<int, 1> only_16{16}, only_32{32}, only_64{64};
constexpr std::array<int, 1> only_8_bits{8};
constexpr std::array<int, 2> any_bits{8, 16};

// What the slider of the URP asset reaches.
constexpr auto urp_sizes = [] {
    std::array<int, 50> out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = 16 + static_cast<int>(i);
    }
    return out;
}();

constexpr std::string_view display_codes = "srgb";
constexpr std::string_view display_encoded = "display-encoded (sRGB curve), after tone mapping";

constexpr auto table = std::to_array<Engine>({
    {
        .name = "piccolo",
        .label = "Piccolo / Pilot",
        .layout = "strip",
        .default_size = 16,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::ignored,
        .encoding = display_codes,
        .input =
            "the codes of an sRGB display, after the Uncharted 2 tone map (which Piccolo encodes "
            "by the power 1/2.2)",
        .import = "loaded as UNORM; no sRGB chunk, or the codes are decoded twice",
        .lookup_help = "eight texel fetches, trilinear",
        .source = "Piccolo, color_grading.frag and its six LUT pictures; stb_image",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = piccolo,
    },
    {
        .name = "unreal",
        .label = "Unreal Engine",
        .layout = "strip",
        .default_size = 16,
        .sizes = only_16,
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::unknown,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "group ColorLookupTable, sRGB off, no mipmaps",
        .lookup_help = "two bilinear fetches blended on blue, x*15/16 + 0.5/16",
        .source = "Unreal, PostProcessCombineLUTs.usf, low-dynamic-range path",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = unreal,
        .shader = "unreal",
    },
    {
        .name = "unity",
        .label = "Unity",
        .layout = "strip-up",
        .default_size = 32,
        .sizes = urp_sizes,
        .usual_sizes = only_32,
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "sRGB off, Ignore PNG Gamma on, no compression, clamp, no mipmaps; URP ignores a "
                  "strip whose height is not the LUT Size of the URP asset (32 unless it was "
                  "changed), HDRP takes a 3D texture of the LUT Size of its asset instead (lutconv "
                  "convert -o look.cube)",
        .lookup_help = "two bilinear fetches blended on blue",
        .source = "Unity, Color.hlsl ApplyLut2D; URP, ColorLookup.ValidateLUT; "
                  "TextureImporter.ignorePngGamma",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = unity,
        .shader = "unity",
    },
    {
        .name = "godot",
        .label = "Godot 4",
        .layout = "tiles",
        .default_size = 64,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "as Texture3D, Slices Horizontal and Vertical the tiles of the picture each way "
                  "(8 and 8 of 64 nodes); Compress Mode Lossless, Mipmaps off (the defaults are "
                  "lossy, with mipmaps)",
        .lookup_help = "one trilinear fetch at the raw colour, without half-texel remap",
        .source = "Godot, tonemap.glsl apply_color_correction; ResourceImporterLayeredTexture; its "
                  "PNG driver is libpng's simplified API, which converts by gAMA",
        .node_input = at_texel_centre,
        .place = place_at_texel_centre,
        .interpolation = Interpolation::trilinear,
        .lookup = godot,
    },
    {
        .name = "reshade",
        .label = "ReShade LUT.fx",
        .layout = "strip",
        .default_size = 32,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::ignored,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "any PNG; the shader's tile size and amount must match",
        .lookup_help = "two bilinear fetches blended on blue",
        .source = "ReShade, LUT.fx; stb_image",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = reshade,
        .shader = "reshade",
    },
    {
        .name = "obs",
        .label = "OBS Studio",
        .layout = "tiles",
        .default_size = 64,
        .sizes = only_64,
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::ignored,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "512x512 PNG of the Apply LUT filter",
        .lookup_help = "one trilinear fetch of a 3D texture",
        .source = "OBS Studio, color-grade-filter.c; FFmpeg's PNG decoder",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = obs,
    },
    {
        .name = "threejs",
        .label = "three.js LUTImageLoader",
        .layout = "strip",
        .default_size = 32,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "LUTImageLoader with flip left false; LUTPass behind OutputPass; a browser "
                  "converts by gAMA, cHRM and iCCP",
        .lookup_help = "one trilinear fetch of a 3D texture at c*(N-1)/N + 0.5/N",
        .source = "three.js, LUTImageLoader.js, LUTPass.js",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = threejs,
    },
    {
        .name = "playcanvas",
        .label = "PlayCanvas CameraFrame",
        .layout = "strip",
        .default_size = 16,
        .sizes = only_16,
        .usual_sizes = {},
        .default_bits = 8,
        .bits = only_8_bits,
        .srgb_tag = SrgbTag::present,
        .colour_chunks = ColourChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import =
            "a texture asset with srgb on, no mipmaps, linear filters, as colorLUT.texture; a "
            "browser converts by gAMA, cHRM and iCCP",
        .lookup_help = "two bilinear fetches of an sRGB texture, so of light, blended on blue",
        .source = "PlayCanvas, ColorLUT of CameraFrame and its compose pass; engine pull requests "
                  "8747 and 8749",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .filtering = Filtering::light,
        .lookup = playcanvas,
        .shader = "playcanvas",
    },
    {
        .name = "hald",
        .label = "HALD (ffmpeg haldclut, RawTherapee)",
        .layout = "hald",
        .default_size = 64,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 8,
        .bits = any_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::unknown,
        .encoding = {},
        .input = "the codes of the picture or film that the program is given",
        .import = "level sqrt(N); 16 bits where the program reads them",
        .lookup_help = "four nodes, tetrahedral",
        .source = "ffmpeg, vf_lut3d.c",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::tetrahedral,
        .lookup = hald,
    },
    {
        .name = "ocio",
        .label = "OpenColorIO lut image",
        .layout = "ocio",
        .default_size = 32,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 16,
        .bits = any_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::ignored,
        .encoding = {},
        .input = "the LUT's own",
        .import = "ociolutimage --extract reads it back",
        .lookup_help = "four nodes, tetrahedral",
        .source = "OpenColorIO, ociolutimage and Lut3DOpCPU; OpenImageIO",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::tetrahedral,
        .lookup = ocio,
    },
    {
        .name = "o3de",
        .label = "O3DE Look Modification",
        .layout = "ocio",
        .default_size = 32,
        .sizes = {},
        .usual_sizes = {},
        .default_bits = 16,
        .bits = any_bits,
        .srgb_tag = SrgbTag::absent,
        .colour_chunks = ColourChunks::unknown,
        .encoding = "o3de-log2",
        .input = "scene light before the tone map, in ACEScg, through the shaper Log2 48 nits",
        .import = "lutconv convert PICTURE -o look.azasset (12-bit codes), or O3DE's "
                  "exr_to_3dl_azasset.py; Shaper Type Log2 48 nits, the default",
        .lookup_help = "one trilinear fetch of a 3D texture at c*(N-1)/N + 0.5/N",
        .source = "O3DE, LookModificationTransform.azsl, AcesDisplayMapperFeatureProcessor.cpp, "
                  "Look Modification component",
        .node_input = at_lattice,
        .place = place_at_lattice,
        .interpolation = Interpolation::trilinear,
        .lookup = o3de,
    },
});

} // namespace

std::span<const Engine> engines() {
    return table;
}

bool is_fed_display_codes(const Engine& engine) {
    return engine.encoding.empty() || engine.encoding == display_codes;
}

const Engine* engine_named(std::string_view name) {
    return find_named(table, name, Letters::any_case);
}

std::string_view encoding_fed_through(const Layout& layout) {
    const Engine* first = nullptr;
    for (const Engine& engine : table) {
        if (engine.layout != layout.name) {
            continue;
        }
        if (first && first->encoding != engine.encoding) {
            return {};
        }
        first = first ? first : &engine;
    }
    return first ? first->encoding : std::string_view{};
}

LatticeReader reader_of(const Engine& engine, int size) {
    return {size, engine.interpolation, {}, [&engine, size](double in, std::size_t) {
                return engine.place(in, size);
            }};
}

} // namespace lutlib
