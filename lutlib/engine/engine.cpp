#include "lutlib/engine/engine.h"

#include "lutlib/engine/lookups.h"
#include "lutlib/named.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

// Godot reads node i at (i + 1/2) / n. The end nodes hold black and white themselves, which the
// clamped sampler reaches, rather than the colours half a node inside.
double at_texel_centre(int i, int n) {
    return i == 0 ? 0.0 : i == n - 1 ? 1.0 : (i + 0.5) / n;
}

double place_at_texel_centre(double in, int n) {
    return std::clamp(in * n - 0.5, 0.0, n - 1.0);
}

constexpr std::array<int, 1> only_16{16}, only_32{32}, only_64{64};
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

constexpr auto engine_rows = std::to_array<Engine>({
    {
        .name = "piccolo",
        .label = "Piccolo / Pilot",
        .layout = "strip",
        .default_size = 16,
        .color_chunks = ColorChunks::ignored,
        .encoding = display_codes,
        .input =
            "the codes of an sRGB display, after the Uncharted 2 tone map (which Piccolo encodes "
            "by the power 1/2.2)",
        .import = "loaded as UNORM; no sRGB chunk, or the codes are decoded twice",
        .lookup_help = "eight texel fetches, trilinear",
        .source = "Piccolo, color_grading.frag and its six LUT pictures; stb_image",
        .lookup = lookup::piccolo,
    },
    {
        .name = "unreal",
        .label = "Unreal Engine",
        .layout = "strip",
        .default_size = 16,
        .sizes = only_16,
        .color_chunks = ColorChunks::unknown,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "group ColorLookupTable, sRGB off, no mipmaps",
        .lookup_help = "two bilinear fetches blended on blue, x*15/16 + 0.5/16",
        .source = "Unreal, PostProcessCombineLUTs.usf, low-dynamic-range path",
        .lookup = lookup::unreal,
        .shader = "unreal",
    },
    {
        .name = "unity",
        .label = "Unity",
        .layout = "strip-up",
        .default_size = 32,
        .sizes = urp_sizes,
        .usual_sizes = only_32,
        .color_chunks = ColorChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "sRGB off, Ignore PNG Gamma on, no compression, clamp, no mipmaps; URP ignores a "
                  "strip whose height is not the LUT Size of the URP asset (32 unless it was "
                  "changed), HDRP takes a 3D texture of the LUT Size of its asset instead (lutconv "
                  "convert -o look.cube)",
        .lookup_help = "two bilinear fetches blended on blue",
        .source = "Unity, Color.hlsl ApplyLut2D; URP, ColorLookup.ValidateLUT; "
                  "TextureImporter.ignorePngGamma",
        .lookup = lookup::unity,
        .shader = "unity",
    },
    {
        .name = "godot",
        .label = "Godot 4",
        .layout = "tiles",
        .default_size = 64,
        .color_chunks = ColorChunks::converted,
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
        .lookup = lookup::godot,
    },
    {
        .name = "reshade",
        .label = "ReShade LUT.fx",
        .layout = "strip",
        .default_size = 32,
        .color_chunks = ColorChunks::ignored,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "any PNG; the shader's tile size and amount must match",
        .lookup_help = "two bilinear fetches blended on blue",
        .source = "ReShade, LUT.fx; stb_image",
        .lookup = lookup::reshade,
        .shader = "reshade",
    },
    {
        .name = "obs",
        .label = "OBS Studio",
        .layout = "tiles",
        .default_size = 64,
        .sizes = only_64,
        .color_chunks = ColorChunks::ignored,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "512x512 PNG of the Apply LUT filter",
        .lookup_help = "one trilinear fetch of a 3D texture",
        .source = "OBS Studio, color-grade-filter.c; FFmpeg's PNG decoder",
        .lookup = lookup::obs,
    },
    {
        .name = "threejs",
        .label = "three.js LUTImageLoader",
        .layout = "strip",
        .default_size = 32,
        .color_chunks = ColorChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import = "LUTImageLoader with flip left false; LUTPass behind OutputPass; a browser "
                  "converts by gAMA, cHRM and iCCP",
        .lookup_help = "one trilinear fetch of a 3D texture at c*(N-1)/N + 0.5/N",
        .source = "three.js, LUTImageLoader.js, LUTPass.js",
        .lookup = lookup::threejs,
    },
    {
        .name = "playcanvas",
        .label = "PlayCanvas CameraFrame",
        .layout = "strip",
        .default_size = 16,
        .sizes = only_16,
        .srgb_tag = SrgbTag::present,
        .color_chunks = ColorChunks::converted,
        .encoding = display_codes,
        .input = display_encoded,
        .import =
            "a texture asset with srgb on, no mipmaps, linear filters, as colorLUT.texture; a "
            "browser converts by gAMA, cHRM and iCCP",
        .lookup_help = "two bilinear fetches of an sRGB texture, so of light, blended on blue",
        .source = "PlayCanvas, ColorLUT of CameraFrame and its compose pass; engine pull requests "
                  "8747 and 8749",
        .filtering = Filtering::light,
        .lookup = lookup::playcanvas,
        .shader = "playcanvas",
    },
    {
        .name = "hald",
        .label = "HALD (ffmpeg haldclut, RawTherapee)",
        .layout = "hald",
        .default_size = 64,
        .bits = any_bits,
        .color_chunks = ColorChunks::unknown,
        .input = "the codes of the picture or film that the program is given",
        .import = "level sqrt(N); 16 bits where the program reads them",
        .lookup_help = "four nodes, tetrahedral",
        .source = "ffmpeg, vf_lut3d.c",
        .interpolation = Interpolation::tetrahedral,
        .lookup = lookup::hald,
    },
    {
        .name = "ocio",
        .label = "OpenColorIO lut image",
        .layout = "ocio",
        .default_size = 32,
        .default_bits = 16,
        .bits = any_bits,
        .color_chunks = ColorChunks::ignored,
        .input = "the LUT's own",
        .import = "ociolutimage --extract reads it back",
        .lookup_help = "four nodes, tetrahedral",
        .source = "OpenColorIO, ociolutimage and Lut3DOpCPU; OpenImageIO",
        .interpolation = Interpolation::tetrahedral,
        .lookup = lookup::ocio,
    },
    {
        .name = "o3de",
        .label = "O3DE Look Modification",
        .layout = "ocio",
        .default_size = 32,
        .default_bits = 16,
        .bits = any_bits,
        .color_chunks = ColorChunks::unknown,
        .encoding = "o3de-log2",
        .input = "scene light before the tone map, in ACEScg, through the shaper Log2 48 nits",
        .import = "lutconv convert PICTURE -o look.azasset (12-bit codes), or O3DE's "
                  "exr_to_3dl_azasset.py; Shaper Type Log2 48 nits, the default",
        .lookup_help = "one trilinear fetch of a 3D texture at c*(N-1)/N + 0.5/N",
        .source = "O3DE, LookModificationTransform.azsl, AcesDisplayMapperFeatureProcessor.cpp, "
                  "Look Modification component",
        .lookup = lookup::o3de,
    },
});

} // namespace

double at_lattice(int i, int n) {
    return static_cast<double>(i) / (n - 1);
}

double place_at_lattice(double in, int n) {
    return in * (n - 1);
}

std::span<const Engine> engines() {
    return engine_rows;
}

bool is_fed_display_codes(const Engine& engine) {
    return engine.encoding.empty() || engine.encoding == display_codes;
}

const Engine* engine_named(std::string_view name) {
    return find_named(engine_rows, name, Letters::any_case);
}

std::string_view encoding_fed_through(const Layout& layout) {
    const Engine* first = nullptr;
    for (const Engine& engine : engine_rows) {
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
