#include "lutlib/engine/shader_parts.h"

#include <array>

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

constexpr auto dialects = std::to_array<ShaderWords>({
    {.kind = ShaderDialect::glsl,
     .vec3 = "vec3",
     .ivec2 = "ivec2",
     .ivec3 = "ivec3",
     .constant = "const",
     .function = "",
     .parameter = "",
     .argument = "",
     .list = "$type[$count](",
     .list_end = ")",
     .begins = "",
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
     .list = "{",
     .list_end = "}",
     .begins = "",
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
     .list = "{",
     .list_end = "}",
     .begins = "#include <metal_stdlib>\nusing namespace metal;\n",
     .declares = "",
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
     .list = "{",
     .list_end = "}",
     .begins = "",
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
     .list = "{",
     .list_end = "}",
     .begins = "#include \"ReShade.fxh\"\n",
     .declares =
         R"(texture LutStrip < source = "strip.png"; > { Width = $width; Height = $height; Format = RGBA8; };
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

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

} // namespace

std::span<const ShaderLanguage> shader_languages() {
    return languages;
}

const ShaderWords& words_of(const ShaderLanguage& language) {
    return row_where(
        dialects, [&](const ShaderWords& row) { return row.kind == language.kind; }, "language");
}

std::string_view interpolation_code(Interpolation kind) {
    return row_where(
               interpolation_codes, [&](const InterpolationCode& row) { return row.kind == kind; },
               "interpolation")
        .code;
}

void replace_words(std::string& code,
                   std::span<const std::pair<std::string_view, std::string>> words) {
    for (const auto& [from, to] : words) {
        replace_all(code, from, to);
    }
}

void replace_common_words(std::string& code, const ShaderWords& words) {
    const std::array<std::pair<std::string_view, std::string>, 5> common{
        {{"$const", std::string(words.constant)},
         {"$inline", std::string(words.function)},
         {"$i2", std::string(words.ivec2)},
         {"$i3", std::string(words.ivec3)},
         {"$3", std::string(words.vec3)}}};
    replace_words(code, common);
}

std::string shader_comment(const std::string& words) {
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

std::string shader_command(const std::string& words) {
    return "//\n//     " + words + "\n//\n";
}

} // namespace lutlib
