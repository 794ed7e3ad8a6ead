#include "lutlib/engine/shader_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace lutlib {
namespace {

constexpr auto languages = std::to_array<ShaderLanguage>({
    {ShaderDialect::glsl, "glsl", "GLSL", "lut.glsl",
     "compiled by glslang and run on a GPU driver in lutconv's tests"},
    {ShaderDialect::hlsl, "hlsl", "HLSL", "lut.hlsl",
     "compiled by glslang's HLSL front end and run on a GPU driver in lutconv's tests"},
    {ShaderDialect::metal, "metal", "Metal", "lut.metal",
     "the same statements as the tested GLSL; no Metal compiler has seen it"},
    {ShaderDialect::godot, "godot", "Godot shader", "lut.gdshaderinc",
     "the same statements as the tested GLSL; Godot's own compiler has not seen it"},
    {ShaderDialect::reshade, "reshade", "ReShade FX", "lut.fx",
     "the same statements as the tested HLSL; ReShade's own compiler has not seen it"},
});

// What differs between the languages. In code, $3 is a vector of three floats, $i2 and $i3 vectors
// of integers, $const begins a constant, $inline a function, $p and $a hand a texture on, and $at
// is where to fetch.
struct Dialect {
    ShaderDialect kind;
    std::string_view vec3, ivec2, ivec3, constant, function, parameter, argument, declares, fetch,
        ends;
};

constexpr auto dialects = std::to_array<Dialect>({
    {.kind = ShaderDialect::glsl,
     .vec3 = "vec3",
     .ivec2 = "ivec2",
     .ivec3 = "ivec3",
     .constant = "const",
     .function = "",
     .parameter = "",
     .argument = "",
     .declares =
         R"(// Define LUT_STRIP as a sampler2D of your own before this file is included, or bind this one.
#ifndef LUT_STRIP
uniform sampler2D lut_strip;
#define LUT_STRIP lut_strip
#endif
)",
     .fetch = "texelFetch(LUT_STRIP, $at, 0).rgb",
     .ends = ""},
    {.kind = ShaderDialect::hlsl,
     .vec3 = "float3",
     .ivec2 = "int2",
     .ivec3 = "int3",
     .constant = "static const",
     .function = "",
     .parameter = "",
     .argument = "",
     .declares =
         R"(// Define LUT_STRIP as a Texture2D<float4> of your own before this file is included, or bind this one.
#ifndef LUT_STRIP
Texture2D<float4> lut_strip;
#define LUT_STRIP lut_strip
#endif
)",
     .fetch = "LUT_STRIP.Load(int3($at, 0)).rgb",
     .ends = ""},
    {.kind = ShaderDialect::metal,
     .vec3 = "float3",
     .ivec2 = "int2",
     .ivec3 = "int3",
     .constant = "constant",
     .function = "inline ",
     .parameter = "metal::texture2d<float> lut_strip, ",
     .argument = "lut_strip, ",
     .declares = "#include <metal_stdlib>\nusing namespace metal;\n",
     .fetch = "lut_strip.read(uint2($at)).rgb",
     .ends = ""},
    {.kind = ShaderDialect::godot,
     .vec3 = "vec3",
     .ivec2 = "ivec2",
     .ivec3 = "ivec3",
     .constant = "const",
     .function = "",
     .parameter = "",
     .argument = "",
     .declares = "// Without source_color, which would decode the codes.\n"
                 "uniform sampler2D lut_strip : filter_nearest, repeat_disable;\n",
     .fetch = "texelFetch(lut_strip, $at, 0).rgb",
     .ends = ""},
    {.kind = ShaderDialect::reshade,
     .vec3 = "float3",
     .ivec2 = "int2",
     .ivec3 = "int3",
     .constant = "static const",
     .function = "",
     .parameter = "",
     .argument = "",
     .declares = R"(#include "ReShade.fxh"
texture LutStrip < source = "strip.png"; > { Width = $width; Height = $height; Format = RGBA8; };
sampler LutStripSampler { Texture = LutStrip; };
)",
     .fetch = "tex2Dfetch(LutStripSampler, $at, 0).rgb",
     .ends = R"(
float4 LutPass(float4 position : SV_Position, float2 texcoord : TEXCOORD) : SV_Target
{
    float4 color = tex2D(ReShade::BackBuffer, texcoord);
    return float4(lut_lookup(color.rgb), color.a);
}

technique LutconvLut
{
    pass
    {
        VertexShader = PostProcessVS;
        PixelShader = LutPass;
    }
}
)"},
});

// Where a layout has node n, as layout.pixel() says.
struct LayoutCode {
    std::string_view layout, at;
};
constexpr auto layout_codes = std::to_array<LayoutCode>({
    {"strip", "$i2(n.b * LUT_SIZE + n.r, n.g)"},
    {"strip-up", "$i2(n.b * LUT_SIZE + n.r, LUT_SIZE - 1 - n.g)"},
    {"strip-vertical", "$i2(n.r, n.b * LUT_SIZE + n.g)"},
    {"tiles", "$i2((n.b % LUT_ACROSS) * LUT_SIZE + n.r, (n.b / LUT_ACROSS) * LUT_SIZE + n.g)"},
    {"hald", "$i2((n.g % LUT_ACROSS) * LUT_SIZE + n.r, n.b * LUT_ACROSS + n.g / LUT_ACROSS)"},
    {"ocio", "$i2((n.r + LUT_SIZE * (n.g + LUT_SIZE * n.b)) % LUT_WIDTH, "
             "(n.r + LUT_SIZE * (n.g + LUT_SIZE * n.b)) / LUT_WIDTH)"},
});

// Engine::place.
struct PlaceCode {
    double (*place)(double in, int n);
    std::string_view code;
};
constexpr auto place_codes = std::to_array<PlaceCode>({
    {place_at_lattice, "c * float(LUT_SIZE - 1)"},
    {[](double in, int n) { return std::clamp(in * n - 0.5, 0.0, n - 1.0); },
     "clamp(c * float(LUT_SIZE) - $3(0.5, 0.5, 0.5), $3(0.0, 0.0, 0.0),\n"
     "                    $3(1.0, 1.0, 1.0) * float(LUT_SIZE - 1))"},
});

// Whose textures begin with the bottom row.
constexpr std::array<std::string_view, 1> from_the_bottom{"unity"};

bool begins_at_bottom(const Engine& engine) {
    return std::find(from_the_bottom.begin(), from_the_bottom.end(), engine.name) !=
           from_the_bottom.end();
}

constexpr std::string_view light_code = R"(
// The sampler of this engine filters light: sRGB's curve and back.
$inline$3 lut_light($3 code)
{
    $3 low = code / 12.92;
    $3 high = pow(max((code + $3(0.055, 0.055, 0.055)) / 1.055, $3(0.0, 0.0, 0.0)),
                  $3(2.4, 2.4, 2.4));
    return $3(code.r <= 0.04045 ? low.r : high.r, code.g <= 0.04045 ? low.g : high.g,
              code.b <= 0.04045 ? low.b : high.b);
}

$inline$3 lut_code($3 light)
{
    $3 low = light * 12.92;
    $3 high = pow(max(light, $3(0.0, 0.0, 0.0)), $3(1.0, 1.0, 1.0) / 2.4) * 1.055 -
              $3(0.055, 0.055, 0.055);
    return $3(light.r <= 0.0031308 ? low.r : high.r, light.g <= 0.0031308 ? low.g : high.g,
              light.b <= 0.0031308 ? low.b : high.b);
}
)";

constexpr std::string_view nearest_code = R"(    $i3 n = $i3(floor(place + $3(0.5, 0.5, 0.5)));
    $3 found = lut_node($an);
)";

constexpr std::string_view trilinear_code =
    R"(    $3 low = min(floor(place), $3(1.0, 1.0, 1.0) * float(LUT_SIZE - 2));
    $3 f = place - low;
    $i3 n = $i3(low);
    $3 r00 = lut_node($an) * (1.0 - f.r) + lut_node($an + $i3(1, 0, 0)) * f.r;
    $3 r10 = lut_node($an + $i3(0, 1, 0)) * (1.0 - f.r) + lut_node($an + $i3(1, 1, 0)) * f.r;
    $3 r01 = lut_node($an + $i3(0, 0, 1)) * (1.0 - f.r) + lut_node($an + $i3(1, 0, 1)) * f.r;
    $3 r11 = lut_node($an + $i3(0, 1, 1)) * (1.0 - f.r) + lut_node($an + $i3(1, 1, 1)) * f.r;
    $3 found = (r00 * (1.0 - f.g) + r10 * f.g) * (1.0 - f.b) + (r01 * (1.0 - f.g) + r11 * f.g) * f.b;
)";

constexpr std::string_view tetrahedral_code =
    R"(    $3 low = min(floor(place), $3(1.0, 1.0, 1.0) * float(LUT_SIZE - 2));
    $3 f = place - low;
    $i3 n = $i3(low);
    // From the lower node along the channel that is furthest, then the next, then the last.
    $i3 first = $i3(1, 0, 0);
    $i3 second = $i3(1, 1, 0);
    $3 w = f;
    if (f.r >= f.g && f.g >= f.b) {
        w = $3(f.r, f.g, f.b);
    } else if (f.r >= f.b && f.b >= f.g) {
        second = $i3(1, 0, 1);
        w = $3(f.r, f.b, f.g);
    } else if (f.b >= f.r && f.r >= f.g) {
        first = $i3(0, 0, 1);
        second = $i3(1, 0, 1);
        w = $3(f.b, f.r, f.g);
    } else if (f.b >= f.g && f.g >= f.r) {
        first = $i3(0, 0, 1);
        second = $i3(0, 1, 1);
        w = $3(f.b, f.g, f.r);
    } else if (f.g >= f.b && f.b >= f.r) {
        first = $i3(0, 1, 0);
        second = $i3(0, 1, 1);
        w = $3(f.g, f.b, f.r);
    } else {
        first = $i3(0, 1, 0);
        w = $3(f.g, f.r, f.b);
    }
    $3 found = lut_node($an) * (1.0 - w.r) + lut_node($an + first) * (w.r - w.g) +
               lut_node($an + second) * (w.g - w.b) + lut_node($an + $i3(1, 1, 1)) * w.b;
)";

struct InterpolationCode {
    Interpolation kind;
    std::string_view code;
};
constexpr auto interpolation_codes = std::to_array<InterpolationCode>({
    {Interpolation::nearest, nearest_code},
    {Interpolation::trilinear, trilinear_code},
    {Interpolation::tetrahedral, tetrahedral_code},
});

template <class Rows, class Condition>
const auto& row_where(const Rows& rows, Condition condition, const char* what) {
    const auto* const row = std::find_if(rows.begin(), rows.end(), condition);
    if (row == rows.end()) {
        throw std::logic_error(std::string("no shader code for this ") + what);
    }
    return *row;
}

std::string_view place_code(const Engine& engine, int n) {
    return row_where(
               place_codes,
               [&](const PlaceCode& row) {
                   constexpr int steps = 64;
                   for (int i = 0; i <= steps; ++i) {
                       const double in = static_cast<double>(i) / steps;
                       if (std::abs(row.place(in, n) - engine.place(in, n)) > 1e-9) {
                           return false;
                       }
                   }
                   return true;
               },
               "way to place nodes")
        .code;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

// Lines of a comment, no longer than a page is wide.
std::string comment(const std::string& words) {
    constexpr std::size_t width = 96;
    std::string out, line = "//";
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (line.size() + 1 + end - at > width) {
            out += line + '\n';
            line = "//";
        }
        line += ' ' + words.substr(at, end - at);
        at = end + 1;
    }
    return out + line + '\n';
}

std::string command(const std::string& words) {
    return "//\n//     " + words + "\n//\n";
}

std::string heading(const ShaderRequest& request, PictureSize picture) {
    const Engine& engine = request.engine;
    const std::string size = std::to_string(request.size), name(engine.name);
    const std::string how(name_of(request.interpolation));
    const bool own = request.interpolation == engine.interpolation;
    std::string out =
        comment("A colour look as " + std::string(engine.label) + " looks it up, in " +
                std::string(request.language.label) + ". Made by:");
    out +=
        command("lutconv shader --engine " + name + " --language " +
                std::string(request.language.name) + " --size " + size + " --interpolation " + how);
    out += comment("Reads a picture of " + std::to_string(picture.width) + "x" +
                   std::to_string(picture.height) + " pixels, " + size +
                   " nodes per axis, layout " + std::string(engine.layout) + ", as made by:");
    out += command("lutconv bake LOOK -o strip.png --engine " + name + " --size " + size);
    out += comment("Load its codes as they are: no sRGB decoding, no mipmaps, no compression. The "
                   "first texel is the picture's " +
                   std::string(begins_at_bottom(engine)
                                   ? "bottom left one, as this engine loads pictures"
                                   : "top left one; where a loader puts the bottom row first, load "
                                     "it flipped") +
                   ". The engine itself imports it so: " + std::string(engine.import) + ".");
    out += comment("lut_lookup takes what the engine feeds its own: " + std::string(engine.input) +
                   ". Each channel is held to 0..1; what it gives are codes of the same kind." +
                   (engine.filtering == Filtering::light
                        ? " Nodes are decoded to light and the result is encoded here, as the "
                          "engine's sRGB texture does it."
                        : ""));
    out += comment(
        (own ? "Between the nodes " + how + ", as the engine (" + std::string(engine.lookup_help) +
                   ")"
             : "Between the nodes " + how + ", where the engine has " +
                   std::string(name_of(engine.interpolation)) + " (" +
                   std::string(engine.lookup_help) + ")") +
        ". Texels are fetched, so that no sampler's half texel, clamping or rounding of fractions "
        "to 8 bits has a part in it." +
        (own && request.interpolation == Interpolation::trilinear
             ? " With --interpolation tetrahedral four fetches do instead of eight, and greys stay "
               "between greys."
             : ""));
    return out + comment("This code: " + std::string(request.language.trial) + ".");
}

} // namespace

std::span<const ShaderLanguage> shader_languages() {
    return languages;
}

std::string shader_code(const ShaderRequest& request) {
    const Engine& engine = request.engine;
    const PictureSize picture = layout_named(engine.layout)->picture(request.size).value();
    const Dialect& dialect = row_where(
        dialects, [&](const Dialect& row) { return row.kind == request.language.kind; },
        "language");
    const std::string at(row_where(
                             layout_codes,
                             [&](const LayoutCode& row) { return row.layout == engine.layout; },
                             "layout")
                             .at);
    const bool light = engine.filtering == Filtering::light;
    std::string code(dialect.declares);
    code += "\n$const int LUT_SIZE = " + std::to_string(request.size) + ";\n";
    if (at.find("LUT_WIDTH") != std::string::npos) {
        code += "$const int LUT_WIDTH = $width;\n";
    }
    if (at.find("LUT_ACROSS") != std::string::npos) {
        code += "$const int LUT_ACROSS = " + std::to_string(picture.width / request.size) + ";\n";
    }
    code += light ? light_code : "";
    const std::string texel(dialect.fetch);
    code += "\n// The node (red, green, blue), each from 0 to LUT_SIZE - 1.\n"
            "$inline$3 lut_node($p$i3 n)\n{\n    $i2 at = " +
            at + ";\n";
    if (begins_at_bottom(engine)) {
        code += "    at.y = $height - 1 - at.y; // counted from the bottom row\n";
    }
    code += "    return " + (light ? "lut_light(" + texel + ")" : texel) + ";\n}\n";
    code += "\n// Codes to codes.\n$inline$3 lut_lookup($p$3 color)\n{\n"
            "    $3 c = $3(color.r > 0.0 ? min(color.r, 1.0) : 0.0, color.g > 0.0 ? min(color.g, "
            "1.0) : 0.0,\n             color.b > 0.0 ? min(color.b, 1.0) : 0.0);\n"
            "    $3 place = " +
            std::string(place_code(engine, request.size)) + ";\n";
    code += row_where(
                interpolation_codes,
                [&](const InterpolationCode& row) { return row.kind == request.interpolation; },
                "interpolation")
                .code;
    code += light ? "    return lut_code(found);\n}\n" : "    return found;\n}\n";
    code += dialect.ends;
    const std::array<std::pair<std::string_view, std::string>, 10> words{
        {{"$at", "at"},
         {"$an", std::string(dialect.argument) + "n"},
         {"$const", std::string(dialect.constant)},
         {"$inline", std::string(dialect.function)},
         {"$p", std::string(dialect.parameter)},
         {"$width", std::to_string(picture.width)},
         {"$height", std::to_string(picture.height)},
         {"$i2", std::string(dialect.ivec2)},
         {"$i3", std::string(dialect.ivec3)},
         {"$3", std::string(dialect.vec3)}}};
    for (const auto& [from, to] : words) {
        replace_all(code, from, to);
    }
    return heading(request, picture) + "\n" + code;
}

} // namespace lutlib
