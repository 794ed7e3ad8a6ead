#include "lutlib/engine/shader_code.h"

#include "lutlib/engine/shader_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace lutlib {
namespace {

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

std::string heading(const ShaderRequest& request, PictureSize picture) {
    const Engine& engine = request.engine;
    const std::string size = std::to_string(request.size), name(engine.name);
    const std::string how(name_of(request.interpolation));
    const bool own = request.interpolation == engine.interpolation;
    std::string out =
        shader_comment("A colour look as " + std::string(engine.label) + " looks it up, in " +
                       std::string(request.language.label) + ". Made by:");
    out += shader_command("lutconv shader --engine " + name + " --language " +
                          std::string(request.language.name) + " --size " + size +
                          " --interpolation " + how);
    out +=
        shader_comment("Reads a picture of " + std::to_string(picture.width) + "x" +
                       std::to_string(picture.height) + " pixels, " + size +
                       " nodes per axis, layout " + std::string(engine.layout) + ", as made by:");
    out += shader_command("lutconv bake LOOK -o strip.png --engine " + name + " --size " + size);
    out += shader_comment(
        "Load its codes as they are: no sRGB decoding, no mipmaps, no compression. The "
        "first texel is the picture's " +
        std::string(begins_at_bottom(engine)
                        ? "bottom left one, as this engine loads pictures"
                        : "top left one; where a loader puts the bottom row first, load "
                          "it flipped") +
        ". The engine itself imports it so: " + std::string(engine.import) + ".");
    out += shader_comment(
        "lut_lookup takes what the engine feeds its own: " + std::string(engine.input) +
        ". Each channel is held to 0..1; what it gives are codes of the same kind." +
        (engine.filtering == Filtering::light
             ? " Nodes are decoded to light and the result is encoded here, as the "
               "engine's sRGB texture does it."
             : ""));
    out += shader_comment(
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
    return out + shader_comment("This code: " + std::string(request.language.trial) + ".");
}

} // namespace

std::string shader_code(const ShaderRequest& request) {
    const Engine& engine = request.engine;
    const PictureSize picture = layout_named(engine.layout)->picture(request.size).value();
    const ShaderWords& dialect = words_of(request.language);
    const std::string at(row_where(
                             layout_codes,
                             [&](const LayoutCode& row) { return row.layout == engine.layout; },
                             "layout")
                             .at);
    const bool light = engine.filtering == Filtering::light;
    std::string code = std::string(dialect.begins) + std::string(dialect.declares);
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
    code += interpolation_code(request.interpolation);
    code += light ? "    return lut_code(found);\n}\n" : "    return found;\n}\n";
    code += dialect.ends;
    const std::array<std::pair<std::string_view, std::string>, 7> words{
        {{"$at", "at"},
         {"$an", std::string(dialect.argument) + "n"},
         {"$const", std::string(dialect.constant)},
         {"$inline", std::string(dialect.function)},
         {"$p", std::string(dialect.parameter)},
         {"$width", std::to_string(picture.width)},
         {"$height", std::to_string(picture.height)}}};
    replace_words(code, words);
    replace_common_words(code, dialect);
    return heading(request, picture) + "\n" + code;
}

} // namespace lutlib
