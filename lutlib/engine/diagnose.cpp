#include "lutlib/engine/diagnose.h"

#include "lutlib/color/transfer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

// An oracle in float is off by a few units in the last place of 1.
constexpr double oracle_precision = 1e-6;

// What most texels must agree with before a mistake is named.
constexpr double convincing = 0.98;

bool is_truncated(int code, double value, int maximum) {
    const double exact = value * maximum, slack = oracle_precision * maximum;
    return code <= exact + slack && code >= exact - 1 - slack;
}

bool is_high_byte(int code, double value, int maximum) {
    return is_truncated(code, value * 65535.0 / 65280.0 * (maximum == 255 ? 1 : 0), maximum);
}

Pixel as_is(const Layout& layout, int n, int r, int g, int b) {
    return layout.pixel(n, r, g, b);
}
Pixel swap_green_blue(const Layout& layout, int n, int r, int g, int b) {
    return layout.pixel(n, r, b, g);
}
Pixel swap_red_blue(const Layout& layout, int n, int r, int g, int b) {
    return layout.pixel(n, b, g, r);
}
Pixel flip(const Layout& layout, int n, int r, int g, int b) {
    return layout.pixel(n, r, n - 1 - g, b);
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

Rgb value_of(Rgb, Rgb out) {
    return out;
}
Rgb input_itself(Rgb in, Rgb) {
    return in;
}
Rgb channels_swapped(Rgb, Rgb out) {
    return {out.b, out.g, out.r};
}
Rgb decoded_again(Rgb, Rgb out) {
    return to_float({srgb_decode(out.r), srgb_decode(out.g), srgb_decode(out.b)});
}
Rgb encoded_again(Rgb, Rgb out) {
    return to_float({srgb_encode(out.r), srgb_encode(out.g), srgb_encode(out.b)});
}

// How a picture with one mistake comes about: where a node is put, at which input the look is
// sampled, what is done with the value, and how it becomes a code.
struct Mistake {
    std::string_view words;
    Pixel (*pixel)(const Layout&, int, int, int, int) = as_is;
    double (*input)(const Engine&, int, int) = engine_input;
    Rgb (*value)(Rgb in, Rgb out) = value_of;
    bool (*agrees)(int code, double value, int maximum) = is_rounded;
};

constexpr std::array<Mistake, 17> mistakes{{
    {"single texels differ; the rest is right: the picture was edited or damaged in places"},
    {"green and blue are swapped: this is another tool's slice order", swap_green_blue},
    {"red and blue are swapped: the slices run along red", swap_red_blue},
    {"it is flipped: green runs the other way", flip},
    {"red and blue channels are swapped (BGR codes)", as_is, engine_input, channels_swapped},
    {"half texel: nodes were sampled at texel centres (i + 0.5) / N, this engine reads them at "
     "i / (N - 1)",
     as_is, centre_input},
    {"half texel: nodes were sampled at i / (N - 1), this engine reads them at texel centres",
     as_is, lattice_input},
    {"sRGB was decoded twice: the codes are darker by one sRGB curve", as_is, engine_input,
     decoded_again},
    {"sRGB was encoded twice: the codes are brighter by one sRGB curve", as_is, engine_input,
     encoded_again},
    {"codes were truncated instead of rounded", as_is, engine_input, value_of, is_truncated},
    {"codes are the high bytes of 16-bit codes, truncated instead of rounded", as_is, engine_input,
     value_of, is_high_byte},
    {"wrong size: these are the lowest nodes of a lattice of 32", as_is, lowest_of_32},
    {"wrong size: these are the lowest nodes of a lattice of 33", as_is, lowest_of_33},
    {"wrong size: these are the lowest nodes of a lattice of 64", as_is, lowest_of_64},
    {"wrong size: these are the lowest nodes of a lattice of 65", as_is, lowest_of_65},
    {"the picture is the identity: no look was applied", as_is, engine_input, input_itself},
    {"the picture is the identity, with green and blue swapped", swap_green_blue, engine_input,
     input_itself},
}};

class Trial {
  public:
    Trial(const CodePicture& picture, const Engine& engine, int size)
        : picture_(picture), engine_(engine), layout_(*layout_named(engine.layout)), size_(size) {}

    double share(const Mistake& mistake, const Oracle& oracle) const {
        std::vector<Rgb> inputs = inputs_of(mistake);
        std::vector<Rgb> values = inputs;
        oracle(values);
        std::size_t agreeing = 0, i = 0;
        for_each_node([&](int r, int g, int b) {
            const Pixel p = mistake.pixel(layout_, size_, r, g, b);
            const Rgb value = mistake.value(inputs[i], values[i]);
            ++i;
            bool all = true;
            for (std::size_t c = 0; c < 3; ++c) {
                all = all &&
                      mistake.agrees(picture_.code(p, c), saturate(static_cast<double>(value[c])),
                                     picture_.maximum());
            }
            agreeing += all;
        });
        return static_cast<double>(agreeing) / static_cast<double>(inputs.size());
    }

    // Small differences of both signs everywhere.
    std::optional<Diagnosis> lossy(const Oracle& oracle) const {
        const Mistake& none = mistakes[0];
        std::vector<Rgb> values = inputs_of(none);
        oracle(values);
        std::vector<double> distance;
        double bias = 0;
        std::size_t i = 0;
        for_each_node([&](int r, int g, int b) {
            const Pixel p = layout_.pixel(size_, r, g, b);
            for (std::size_t c = 0; c < 3; ++c) {
                const double d = picture_.code(p, c) -
                                 saturate(static_cast<double>(values[i][c])) * picture_.maximum();
                distance.push_back(d);
                bias += d;
            }
            ++i;
        });
        bias /= static_cast<double>(distance.size());
        const ErrorStats size = error_stats(std::move(distance));
        const double widest = picture_.maximum() / 16.0;
        if (size.p95 > widest || std::abs(bias) > 0.25 * size.mean) {
            return std::nullopt;
        }
        return Diagnosis{"lossy compression or resampling: noise of " +
                             std::to_string(static_cast<int>(std::ceil(size.p95))) +
                             " codes (95 %) without a bias",
                         0};
    }

  private:
    template <class F>
    void for_each_node(F&& f) const {
        for (int b = 0; b < size_; ++b) {
            for (int g = 0; g < size_; ++g) {
                for (int r = 0; r < size_; ++r) {
                    f(r, g, b);
                }
            }
        }
    }

    std::vector<Rgb> inputs_of(const Mistake& mistake) const {
        std::vector<Rgb> out;
        const auto at = [&](int i) { return mistake.input(engine_, i, size_); };
        for_each_node([&](int r, int g, int b) { out.push_back(to_float({at(r), at(g), at(b)})); });
        return out;
    }

    const CodePicture& picture_;
    const Engine& engine_;
    const Layout& layout_;
    int size_;
};

} // namespace

bool is_rounded(int code, double value, int maximum) {
    return std::abs(code - value * maximum) <= 0.5 + oracle_precision * maximum;
}

std::optional<Diagnosis> diagnose(const CodePicture& picture, const Engine& engine, int size,
                                  const Oracle& oracle, const Alternatives& alternatives) {
    const Trial trial(picture, engine, size);
    Diagnosis best;
    const auto offer = [&best](std::string_view words, double share) {
        if (share > best.explained) {
            best = {std::string(words), share};
        }
    };
    for (const Mistake& mistake : mistakes) {
        offer(mistake.words, trial.share(mistake, oracle));
    }
    for (const Alternative& alternative :
         alternatives ? alternatives() : std::vector<Alternative>{}) {
        offer(alternative.words, trial.share(mistakes[0], alternative.oracle));
    }
    return best.explained >= convincing ? std::optional(best) : trial.lossy(oracle);
}

} // namespace lutlib
