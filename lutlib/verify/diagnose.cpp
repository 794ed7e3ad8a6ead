#include "lutlib/verify/diagnose.h"

#include "lutlib/color/transfer.h"
#include "lutlib/verify/lossy.h"
#include "lutlib/verify/moved.h"
#include "lutlib/verify/palette.h"
#include "lutlib/verify/sampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace lutlib {
namespace {

// What most texels must agree with before a mistake is named.
constexpr double convincing = 0.98;
// And of those that are wrong without it.
constexpr double telling = 0.9;

bool is_truncated(int code, double value, int maximum, double tolerance) {
    const double exact = value * maximum, slack = tolerance * maximum;
    return code <= exact + slack && code >= exact - 1 - slack;
}

bool is_high_byte(int code, double value, int maximum, double tolerance) {
    return maximum == 255 && is_truncated(code, value * 65535.0 / 65280.0, maximum, tolerance);
}

// 8-bit codes in a 16-bit file, by the two ways to widen them.
bool is_repeated_byte(int code, double value, int maximum, double tolerance) {
    return maximum == 65535 && code % 257 == 0 && is_rounded(code / 257, value, 255, tolerance);
}
bool is_shifted_byte(int code, double value, int maximum, double tolerance) {
    return maximum == 65535 && code % 256 == 0 && is_rounded(code / 256, value, 255, tolerance);
}

Pixel as_is(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, r, g, b);
}
Pixel swap_green_blue(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, r, b, g);
}
Pixel swap_red_blue(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, b, g, r);
}
Pixel swap_red_green(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, g, r, b);
}
Pixel turn_axes(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, g, b, r);
}
Pixel turn_axes_back(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, b, r, g);
}
Pixel flip_red(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, n - 1 - r, g, b);
}
Pixel flip_green(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, r, n - 1 - g, b);
}
Pixel flip_blue(const Layout& layout, int n, int width, int r, int g, int b) {
    return layout.pixel(n, width, r, g, n - 1 - b);
}
Pixel mirrored(const Layout& layout, int n, int width, int r, int g, int b) {
    const Pixel p = layout.pixel(n, width, r, g, b);
    return {width - 1 - p.x, p.y};
}
Pixel turned(const Layout& layout, int n, int width, int r, int g, int b) {
    const Pixel p = mirrored(layout, n, width, r, g, b);
    return {p.x, (n * n * n - 1) / width - p.y};
}

double engine_input(const Engine& engine, int i, int n) {
    return engine.node_input(i, n);
}
double lattice_input(const Engine&, int i, int n) {
    return static_cast<double>(i) / (n - 1);
}
double centre_input(const Engine&, int i, int n) {
    return (i + 0.5) / n;
}
double edge_input(const Engine&, int i, int n) {
    return static_cast<double>(i) / n;
}
double lowest_of_32(const Engine&, int i, int) {
    return i / 31.0;
}
double lowest_of_33(const Engine&, int i, int) {
    return i / 32.0;
}
double lowest_of_64(const Engine&, int i, int) {
    return i / 63.0;
}
double lowest_of_65(const Engine&, int i, int) {
    return i / 64.0;
}

RgbD value_of(RgbD, RgbD out) {
    return out;
}
RgbD input_itself(RgbD in, RgbD) {
    return in;
}
RgbD as_bgr(RgbD, RgbD out) {
    return {out.b, out.g, out.r};
}
RgbD as_grb(RgbD, RgbD out) {
    return {out.g, out.r, out.b};
}
RgbD as_rbg(RgbD, RgbD out) {
    return {out.r, out.b, out.g};
}
RgbD as_gbr(RgbD, RgbD out) {
    return {out.g, out.b, out.r};
}
RgbD as_brg(RgbD, RgbD out) {
    return {out.b, out.r, out.g};
}
RgbD decoded_again(RgbD, RgbD out) {
    return {srgb_decode(out.r), srgb_decode(out.g), srgb_decode(out.b)};
}
RgbD encoded_again(RgbD, RgbD out) {
    return {srgb_encode(out.r), srgb_encode(out.g), srgb_encode(out.b)};
}

// The same done to a picture of 8 bits, which rounds twice.
RgbD in_8_bits(RgbD out) {
    RgbD codes;
    for (std::size_t c = 0; c < 3; ++c) {
        codes[c] = std::round(saturate(out[c]) * 255) / 255;
    }
    return codes;
}
RgbD codes_decoded_again(RgbD in, RgbD out) {
    return decoded_again(in, in_8_bits(out));
}
RgbD codes_encoded_again(RgbD in, RgbD out) {
    return encoded_again(in, in_8_bits(out));
}

// How a picture with one mistake comes about: where a node is put, at which input the look is
// sampled, what is done with the value, and how it becomes a code.
struct Mistake {
    std::string_view words;
    Pixel (*pixel)(const Layout&, int n, int width, int r, int g, int b) = as_is;
    double (*input)(const Engine&, int, int) = engine_input;
    RgbD (*value)(RgbD in, RgbD out) = value_of;
    bool (*agrees)(int code, double value, int maximum, double tolerance) = is_rounded;
};

// A rule that more codes satisfy stands behind a stricter one that explains as much.
constexpr auto mistakes = std::to_array<Mistake>({
    {
        .words = "green and blue are swapped: this is another tool's slice order",
        .pixel = swap_green_blue,
    },
    {
        .words = "red and blue are swapped: the slices run along red",
        .pixel = swap_red_blue,
    },
    {
        .words = "red and green are swapped: red runs down a slice and green across it",
        .pixel = swap_red_green,
    },
    {
        .words = "the axes are exchanged in turn: green runs across a slice, blue down it, and the "
                 "slices run along red",
        .pixel = turn_axes,
    },
    {
        .words = "the axes are exchanged in turn: blue runs across a slice, red down it, and the "
                 "slices run along green",
        .pixel = turn_axes_back,
    },
    {
        .words = "it is flipped: green runs the other way",
        .pixel = flip_green,
    },
    {
        .words = "it is flipped: red runs the other way",
        .pixel = flip_red,
    },
    {
        .words = "it is flipped: blue runs the other way",
        .pixel = flip_blue,
    },
    {
        .words = "the picture is mirrored: left and right are exchanged",
        .pixel = mirrored,
    },
    {
        .words = "the picture is turned by 180 degrees",
        .pixel = turned,
    },
    {
        .words = "red and blue channels are swapped (BGR codes)",
        .value = as_bgr,
    },
    {
        .words = "red and green channels are swapped (GRB codes)",
        .value = as_grb,
    },
    {
        .words = "green and blue channels are swapped (RBG codes)",
        .value = as_rbg,
    },
    {
        .words = "the channels are exchanged in turn (GBR codes)",
        .value = as_gbr,
    },
    {
        .words = "the channels are exchanged in turn (BRG codes)",
        .value = as_brg,
    },
    {
        .words = "half texel: all nodes were sampled at texel centres, (i + 0.5) / N; this engine "
                 "reads its "
                 "first node at 0 and its last at 1",
        .input = centre_input,
    },
    {
        .words = "half texel: nodes were sampled at i / (N - 1), this engine reads them at texel "
                 "centres",
        .input = lattice_input,
    },
    {
        .words = "one node short: nodes were sampled at i / N, so that the last is not at 1",
        .input = edge_input,
    },
    {
        .words = "the picture is the identity: no look was applied",
        .value = input_itself,
    },
    {
        .words = "the picture is the identity, with green and blue swapped",
        .pixel = swap_green_blue,
        .value = input_itself,
    },
    {
        .words = "sRGB was decoded twice: the codes are darker by one sRGB curve",
        .value = decoded_again,
    },
    {
        .words = "sRGB was encoded twice: the codes are brighter by one sRGB curve",
        .value = encoded_again,
    },
    {
        .words = "sRGB was decoded twice: the codes of 8 bits are darker by one sRGB curve",
        .value = codes_decoded_again,
    },
    {
        .words = "sRGB was encoded twice: the codes of 8 bits are brighter by one sRGB curve",
        .value = codes_encoded_again,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 32",
        .input = lowest_of_32,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 33",
        .input = lowest_of_33,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 64",
        .input = lowest_of_64,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 65",
        .input = lowest_of_65,
    },
    {
        .words = "8-bit codes were widened to 16 bits (times 257); the look was rounded to 8 bits "
                 "before",
        .agrees = is_repeated_byte,
    },
    {
        .words = "8-bit codes were shifted to 16 bits (times 256), so that white is not white",
        .agrees = is_shifted_byte,
    },
    {
        .words = "codes were truncated instead of rounded",
        .agrees = is_truncated,
    },
    {
        .words = "codes are the high bytes of 16-bit codes, truncated instead of rounded",
        .agrees = is_high_byte,
    },
});

constexpr Mistake none{.words = "nothing"};

// The look over the lattice that one set of inputs an axis makes, evaluated once for every mistake
// that has the same.
class Values {
  public:
    explicit Values(const Transform& look) : look_(look) {}

    /// Red fastest.
    const std::vector<RgbD>& over(const std::vector<double>& axis) {
        const auto [at, is_new] = known_.try_emplace(axis);
        std::vector<RgbD>& out = at->second;
        if (is_new) {
            out.reserve(axis.size() * axis.size() * axis.size());
            for (const double b : axis) {
                for (const double g : axis) {
                    for (const double r : axis) {
                        out.push_back({r, g, b});
                    }
                }
            }
            apply_in_parallel(look_, out);
        }
        return out;
    }

    double tolerance() const { return tolerance_of(look_.precision()); }

  private:
    const Transform& look_;
    std::map<std::vector<double>, std::vector<RgbD>> known_;
};

// Which texels agree with the look under a mistake.
struct Agreement {
    std::vector<bool> texels; ///< pixel by pixel
    double share = 0;
};

Agreement agreement(const CodeImage& picture, const Engine& engine, int n, const Mistake& mistake,
                    Values& values) {
    std::vector<double> axis;
    for (int i = 0; i < n; ++i) {
        axis.push_back(mistake.input(engine, i, n));
    }
    const std::vector<RgbD>& looked_up = values.over(axis);
    const auto input = [&axis](int i) { return axis[static_cast<std::size_t>(i)]; };
    const Layout& layout = *layout_named(engine.layout);
    Agreement out;
    out.texels.resize(picture.samples.size() / 3);
    std::size_t agreeing = 0, i = 0;
    for (int b = 0; b < n; ++b) {
        for (int g = 0; g < n; ++g) {
            for (int r = 0; r < n; ++r, ++i) {
                const Pixel p = mistake.pixel(layout, n, picture.width, r, g, b);
                const RgbD value = mistake.value({input(r), input(g), input(b)}, looked_up[i]);
                bool all = true;
                for (std::size_t c = 0; c < 3; ++c) {
                    all = all && mistake.agrees(picture.at(p, c), saturate(value[c]),
                                                picture.depth.maximum(), values.tolerance());
                }
                out.texels[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(p.x)] = all;
                agreeing += all;
            }
        }
    }
    out.share = static_cast<double>(agreeing) / static_cast<double>(looked_up.size());
    return out;
}

// The lattice size of a picture of these dimensions in the engine's layout; 0: none.
int size_for(const Engine& engine, const CodeImage& picture) {
    return layout_named(engine.layout)->lattice({picture.width, picture.height}).value_or(0);
}

} // namespace

RightTexels right_texels(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look) {
    const Layout& layout = *layout_named(engine.layout);
    RightTexels out;
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                out.pixels.push_back(layout.pixel(size, picture.width, r, g, b));
                out.values.push_back({engine.node_input(r, size), engine.node_input(g, size),
                                      engine.node_input(b, size)});
            }
        }
    }
    apply_in_parallel(look, out.values);
    return out;
}

double tolerance_of(Precision precision) {
    // A single-precision evaluation is off by a few units in the last place of 1. A double one is
    // not, but pictures are made from values that were kept in floats on the way, which are off by
    // half a unit.
    return precision == Precision::float32 ? 1e-6 : 1e-7;
}

bool is_rounded(int code, double value, int maximum, double tolerance) {
    return std::abs(code - value * maximum) <= 0.5 + tolerance * maximum;
}

Findings diagnose(const CodeImage& picture, const Engine& engine, int size, const Transform& look,
                  const Breaks& breaks, const Alternatives& alternatives) {
    Values values(look);
    const Agreement plain = agreement(picture, engine, size, none, values);
    Findings out;
    out.nearest = {"the look as it is", plain.share};
    if (plain.share >= convincing) {
        out.nearest = {"single texels differ; the rest is right: the picture was edited or damaged "
                       "in places",
                       plain.share};
        out.diagnosis = out.nearest;
        return out;
    }
    double told = 0; // of the texels that are wrong as they are
    const auto offer = [&](std::string words, const Agreement& found) {
        if (!(found.share > out.nearest.explained)) {
            return;
        }
        std::size_t wrong = 0, explained = 0;
        for (std::size_t i = 0; i < plain.texels.size(); ++i) {
            wrong += !plain.texels[i];
            explained += !plain.texels[i] && found.texels[i];
        }
        out.nearest = {std::move(words), found.share};
        told = static_cast<double>(explained) / static_cast<double>(wrong);
    };
    for (const Mistake& mistake : mistakes) {
        offer(std::string(mistake.words), agreement(picture, engine, size, mistake, values));
    }
    // Dimensions alone do not tell a layout: another one of the same may be what this is.
    for (const Engine& other : engines()) {
        const int n = size_for(other, picture);
        const bool same = other.layout == engine.layout && other.node_input == engine.node_input;
        if (n > 0 && !same) {
            offer("it is a picture for " + std::string(other.label) + ", of layout " +
                      std::string(other.layout),
                  agreement(picture, other, n, none, values));
        }
    }
    for (const Alternative& alternative :
         alternatives ? alternatives() : std::vector<Alternative>{}) {
        Values others(alternative.look);
        offer(alternative.words, agreement(picture, engine, size, none, others));
    }
    if (out.nearest.explained >= convincing && told >= telling) {
        out.diagnosis = out.nearest;
    } else if (const auto shift = shifted(picture, engine, size, look)) {
        out.diagnosis = *shift;
    } else if (const auto slices = slices_exchanged(picture, engine, size, look)) {
        out.diagnosis = *slices;
    } else if (const auto colours = few_colours(picture, engine, size, look)) {
        out.diagnosis = Diagnosis{*colours, 0};
    } else if (const auto sampled = sampling_between_nodes(picture, engine, size, look, breaks)) {
        out.diagnosis = Diagnosis{*sampled, 0};
    } else if (const auto noise = lossy_noise(picture, engine, size, look)) {
        out.diagnosis = Diagnosis{*noise, 0};
    }
    return out;
}

} // namespace lutlib
