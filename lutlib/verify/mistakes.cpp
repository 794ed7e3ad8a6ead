#include "lutlib/verify/mistakes.h"

#include "lutlib/codes.h"
#include "lutlib/color/transfer.h"

#include <array>
#include <cmath>

namespace lutlib {
namespace {

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

// Along a slice, down it and from slice to slice run the inputs of these channels.
template <std::size_t Across, std::size_t Down, std::size_t Slices>
Pixel axes(const Layout& layout, int n, int width, int r, int g, int b) {
    const std::array at{r, g, b};
    return layout.pixel(n, width, at[Across], at[Down], at[Slices]);
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

double lattice_input(const Engine&, int i, int n) {
    return static_cast<double>(i) / (n - 1);
}
double centre_input(const Engine&, int i, int n) {
    return (i + 0.5) / n;
}
double edge_input(const Engine&, int i, int n) {
    return static_cast<double>(i) / n;
}
template <int Size>
double lowest_of(const Engine&, int i, int) {
    return i / (Size - 1.0);
}

template <std::size_t Red, std::size_t Green, std::size_t Blue>
RgbD channels(RgbD, RgbD out) {
    return {out[Red], out[Green], out[Blue]};
}
RgbD input_itself(RgbD in, RgbD) {
    return in;
}
RgbD decoded_again(RgbD, RgbD out) {
    return {srgb_decode(out.r), srgb_decode(out.g), srgb_decode(out.b)};
}
RgbD encoded_again(RgbD, RgbD out) {
    return {srgb_encode(out.r), srgb_encode(out.g), srgb_encode(out.b)};
}

// The same done to a picture of 8 bits, which rounds twice.
RgbD in_8_bits(RgbD out) {
    constexpr CodeDepth depth{8};
    return {depth.rounded(out.r), depth.rounded(out.g), depth.rounded(out.b)};
}
RgbD codes_decoded_again(RgbD in, RgbD out) {
    return decoded_again(in, in_8_bits(out));
}
RgbD codes_encoded_again(RgbD in, RgbD out) {
    return encoded_again(in, in_8_bits(out));
}

// A rule that more codes satisfy stands behind a stricter one that explains as much.
constexpr auto mistake_rows = std::to_array<Mistake>({
    {
        .words = "green and blue are swapped: this is another tool's slice order",
        .pixel = axes<0, 2, 1>,
    },
    {
        .words = "red and blue are swapped: the slices run along red",
        .pixel = axes<2, 1, 0>,
    },
    {
        .words = "red and green are swapped: red runs down a slice and green across it",
        .pixel = axes<1, 0, 2>,
    },
    {
        .words = "the axes are exchanged in turn: green runs across a slice, blue down it, and the "
                 "slices run along red",
        .pixel = axes<1, 2, 0>,
    },
    {
        .words = "the axes are exchanged in turn: blue runs across a slice, red down it, and the "
                 "slices run along green",
        .pixel = axes<2, 0, 1>,
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
        .value = channels<2, 1, 0>,
    },
    {
        .words = "red and green channels are swapped (GRB codes)",
        .value = channels<1, 0, 2>,
    },
    {
        .words = "green and blue channels are swapped (RBG codes)",
        .value = channels<0, 2, 1>,
    },
    {
        .words = "the channels are exchanged in turn (GBR codes)",
        .value = channels<1, 2, 0>,
    },
    {
        .words = "the channels are exchanged in turn (BRG codes)",
        .value = channels<2, 0, 1>,
    },
    {
        .words = "half texel: all nodes were sampled at texel centres, (i + 0.5) / N; this engine "
                 "reads its first node at 0 and its last at 1",
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
        .pixel = axes<0, 2, 1>,
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
        .input = lowest_of<32>,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 33",
        .input = lowest_of<33>,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 64",
        .input = lowest_of<64>,
    },
    {
        .words = "wrong size: these are the lowest nodes of a lattice of 65",
        .input = lowest_of<65>,
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

} // namespace

std::span<const Mistake> mistakes() {
    return mistake_rows;
}

} // namespace lutlib
