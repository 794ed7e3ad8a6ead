#include "lutlib/engine/inline_look.h"

#include "lutlib/engine/shader_parts.h"
#include "lutlib/number_text.h"

#include <algorithm>

namespace lutlib {
namespace {

constexpr std::array<char, 3> channel_letters{'r', 'g', 'b'};

// As every language takes a float, with its point.
std::string literal(float value) {
    std::string out = shortest(value);
    const std::size_t exponent = out.find('e');
    if (out.find('.') == std::string::npos) {
        out.insert(std::min(exponent, out.size()), ".0");
    }
    return out;
}

std::string literal(std::uint32_t value) {
    return std::to_string(value) + "u";
}

std::string vector_code(Rgb value) {
    return "$3(" + literal(value.r) + ", " + literal(value.g) + ", " + literal(value.b) + ")";
}

template <class T>
std::string array_code(const ShaderWords& words, const std::string& name, const std::string& type,
                       const std::vector<T>& values) {
    constexpr std::size_t width = 96;
    const std::string count = std::to_string(values.size());
    std::string list(words.list);
    const std::array<std::pair<std::string_view, std::string>, 2> in_list{
        {{"$type", type}, {"$count", count}}};
    replace_words(list, in_list);
    std::string out = "$const " + type + " " + name + "[" + count + "] = " + list + "\n", line;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string value = literal(values[i]) + (i + 1 < values.size() ? "," : "");
        if (line.size() + 1 + value.size() > width) {
            out += "   " + line + "\n";
            line.clear();
        }
        line += " " + value;
    }
    return out + "   " + line + std::string(words.list_end) + ";\n";
}

std::string domain_code(const Domain& domain, const std::string& name = "LUT") {
    return "$const $3 " + name + "_MIN = " + vector_code(domain.min) + ";\n$const $3 " + name +
           "_MAX = " + vector_code(domain.max) + ";\n";
}

// What is no number reads as the minimum.
constexpr std::string_view held_code = R"(
// Codes to codes.
$inline$3 lut_lookup($3 color)
{
    $3 c = $3(color.r > LUT_MIN.r ? min(color.r, LUT_MAX.r) : LUT_MIN.r,
              color.g > LUT_MIN.g ? min(color.g, LUT_MAX.g) : LUT_MIN.g,
              color.b > LUT_MIN.b ? min(color.b, LUT_MAX.b) : LUT_MIN.b);
)";

constexpr std::string_view node_code = R"(
// The node (red, green, blue), each from 0 to LUT_SIZE - 1: ten bits a channel.
$inline$3 lut_node($i3 n)
{
    uint word = LUT_NODES[n.r + LUT_SIZE * (n.g + LUT_SIZE * n.b)];
    return LUT_LOW + LUT_STEP * $3(float(word & 1023u), float((word >> 10u) & 1023u),
                                   float(word >> 20u));
}
)";
static_assert(inline_bits == 10);

std::string nodes_code(const InlineLattice& lattice, const ShaderWords& words) {
    Rgb scale;
    for (std::size_t c = 0; c < 3; ++c) {
        scale[c] = static_cast<float>(
            (lattice.size - 1) / (double{lattice.domain.max[c]} - double{lattice.domain.min[c]}));
    }
    std::string out = "$const int LUT_SIZE = " + std::to_string(lattice.size) +
                      ";\n$const $3 LUT_SCALE = " + vector_code(scale) +
                      ";\n$const $3 LUT_LOW = " + vector_code(lattice.low) +
                      ";\n$const $3 LUT_STEP = " + vector_code(lattice.step) + ";\n";
    out += array_code(words, "LUT_NODES", "uint", lattice.nodes);
    return out + std::string(node_code);
}

// From `place` to the end of the function.
std::string between_nodes_code() {
    std::string out(interpolation_code(Interpolation::tetrahedral));
    const std::array<std::pair<std::string_view, std::string>, 1> no_texture{{{"$an", "n"}}};
    replace_words(out, no_texture);
    return out + "    return found;\n}\n";
}

std::string code_of(const InlineLattice& lattice, const ShaderWords& words) {
    return domain_code(lattice.domain) + nodes_code(lattice, words) + std::string(held_code) +
           "    $3 place = (c - LUT_MIN) * LUT_SCALE;\n" + between_nodes_code();
}

std::string curve_code(const ShaderWords& words, const std::string& name,
                       const InlineCurve& curve) {
    std::string table = "LUT_" + name;
    std::transform(table.begin(), table.end(), table.begin(), [](char c) {
        return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    });
    const auto last = static_cast<float>(curve.entries.size() - 1);
    const auto scale = static_cast<float>(1 / (double{curve.high} - double{curve.low}));
    const std::string share =
        "clamp((x - (" + literal(curve.low) + ")) * " + literal(scale) + ", 0.0, 1.0)";
    return array_code(words, table, "float", curve.entries) + "\n$inlinefloat lut_" + name +
           "(float x)\n{\n    float at = " + (curve.by_root ? "sqrt(" + share + ")" : share) +
           " * " + literal(last) + ";\n    int i = int(min(floor(at), " + literal(last - 1) +
           "));\n    return " + table + "[i] + (" + table + "[i + 1] - " + table +
           "[i]) * (at - float(i));\n}\n\n";
}

std::string calls_code(const std::string& name, const std::string& of) {
    std::string out = "$3(";
    for (const char letter : channel_letters) {
        out += std::string(letter == 'r' ? "" : ", ") + "lut_" + name + "_" + letter + "(" + of +
               "." + letter + ")";
    }
    return out + ")";
}

std::string code_of(const InlineCurves& curves, const ShaderWords& words) {
    std::string out = domain_code(curves.domain);
    for (std::size_t c = 0; c < 3 && curves.mixes; ++c) {
        out += curve_code(words, std::string("before_") + channel_letters[c], curves.before[c]);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        out += curve_code(words, std::string("after_") + channel_letters[c], curves.after[c]);
    }
    out += held_code.substr(1);
    if (!curves.mixes) {
        return out + "    return " + calls_code("after", "c") + ";\n}\n";
    }
    out += "    $3 t = " + calls_code("before", "c") + ";\n    $3 m = $3(";
    for (std::size_t c = 0; c < 3; ++c) {
        out += (c ? ",\n              " : "") + ("dot(" + vector_code(curves.matrix[c])) + ", t)";
    }
    return out + ");\n    return " + calls_code("after", "m") + ";\n}\n";
}

std::string code_of(const InlineShaped& look, const ShaderWords& words) {
    std::string out = domain_code(look.domain) + domain_code(look.lattice.domain, "LUT_SHAPED");
    for (std::size_t c = 0; c < 3; ++c) {
        out += curve_code(words, std::string("shaper_") + channel_letters[c], look.shaper[c]);
    }
    return out + nodes_code(look.lattice, words) + std::string(held_code) +
           "    $3 shaped = clamp(" + calls_code("shaper", "c") +
           ", LUT_SHAPED_MIN, LUT_SHAPED_MAX);\n"
           "    $3 place = (shaped - LUT_SHAPED_MIN) * LUT_SCALE;\n" +
           between_nodes_code();
}

} // namespace

std::string inline_code(const InlineLook& look, const ShaderLanguage& language,
                        const std::string& heading) {
    const ShaderWords& words = words_of(language);
    std::string code(words.begins);
    code += code.empty() ? "" : "\n";
    code += std::visit([&](const auto& form) { return code_of(form, words); }, look);
    code += words.ends;
    replace_common_words(code, words);
    return heading + "\n" + code;
}

} // namespace lutlib
