// Gamut compression: what the result's gamut cannot hold is drawn into it along Oklab's chroma, so
// that hue and lightness stay.
//
// Chroma is measured as a distance: 0 is neutral, 1 the edge of the gamut at the colour's own hue
// and lightness. As in the ACES 1.3 Reference Gamut Compression (Academy S-2020-001), distances
// below a threshold stay and a limit says which distance comes to lie on the edge. That method's
// curve passes the edge beyond its limit; this one reaches it there with slope 0 and stays, so that
// nothing is left outside and the slope has no step:
//   threshold + (1 - threshold) (1 - (1 - t)^k),  t = (distance - threshold) / (limit - threshold),
//   k = (limit - threshold) / (1 - threshold)
#include "lutlib/color/oklab.h"
#include "lutlib/ops/all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib::op {
namespace {

constexpr Parameter gamut_compression_parameters[] = {
    {.name = "amount",
     .flag = "gamut-compression",
     .label = "Amount",
     .unit = "1: nothing stays outside",
     .min = 0,
     .max = 1,
     .fallback = 0},
    {.name = "threshold",
     .flag = "gamut-threshold",
     .label = "Threshold",
     .unit = "share of the gamut's chroma that stays as it is",
     .min = 0.2,
     .max = 0.95,
     .fallback = 0.8},
    {.name = "limit",
     .flag = "gamut-limit",
     .label = "Limit",
     .unit = "the chroma that comes to lie on the gamut's edge",
     .min = 1.05,
     .max = 4,
     .fallback = 1.4},
    {.name = "peak",
     .flag = "gamut-peak",
     .label = "Peak",
     .unit = "the most light that a channel holds",
     .min = 1,
     .max = 100,
     .fallback = 1},
};

// The edge, drawn in by so much that rounding does not carry a colour back over it.
constexpr double inside = 1 - 1e-9;

struct Cubic {
    double a = 0, b = 0, c = 0, d = 0; ///< a + b x + c x^2 + d x^3

    double operator()(double x) const { return a + x * (b + x * (c + x * d)); }
    double slope(double x) const { return b + x * (2 * c + 3 * x * d); }

    /// Where it first falls to 0 within 0..end; end where it does not.
    double first_fall(double end) const {
        if (!(a > 0)) {
            return 0;
        }
        // It is monotone between its extremes.
        std::array<double, 3> stops{end, end, end};
        const double root = c * c - 3 * b * d;
        if (root > 0) {
            // The two roots of the slope, without cancellation.
            const double q = -(c + std::copysign(std::sqrt(root), c));
            stops = {d != 0 ? q / (3 * d) : end, q != 0 ? b / q : end, end};
            std::sort(stops.begin(), stops.end());
        }
        double low = 0;
        for (const double stop : stops) {
            if (!(stop > low) || stop > end) {
                continue;
            }
            if ((*this)(stop) <= 0) {
                return crossing(low, stop);
            }
            low = stop;
        }
        return end;
    }

    /// Newton's steps, held between a place above 0 and one that is not.
    double crossing(double above, double below) const {
        double x = (above + below) / 2;
        for (int i = 0; i < 60 && above < x && x < below; ++i) {
            const double y = (*this)(x);
            (y > 0 ? above : below) = x;
            const double next = x - y / slope(x);
            const double kept = above < next && next < below ? next : (above + below) / 2;
            if (std::abs(kept - x) <= 1e-15 * x) {
                return kept;
            }
            x = kept;
        }
        return x;
    }
};

class Gamut {
  public:
    explicit Gamut(const OpContext& context, double peak) : peak_(peak) {
        // A camera's gamut has colours that no light has, among which Oklab folds; the widest of a
        // display stands for it.
        const Primaries bound = context.output.blue.y < 0 ? rec2020 : context.output;
        to_light_ = rgb_to_rgb(context.primaries, bound, *context.adaptation) *
                    inverse(oklab_cones(context.primaries));
    }

    double highest_lightness() const { return std::cbrt(peak_); }

    /// The chroma of the edge at L > 0 and this hue, or `most` where that lies inside.
    double edge(double L, double cos_hue, double sin_hue, double most) const {
        std::array<double, 3> l{}, k{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& row = oklab_lab_to_lms.m[i];
            l[i] = row[0] * L;
            k[i] = row[1] * cos_hue + row[2] * sin_hue;
        }
        double found = most;
        for (const auto& row : to_light_.m) {
            Cubic light;
            for (std::size_t i = 0; i < 3; ++i) {
                light.a += row[i] * l[i] * l[i] * l[i];
                light.b += 3 * row[i] * l[i] * l[i] * k[i];
                light.c += 3 * row[i] * l[i] * k[i] * k[i];
                light.d += row[i] * k[i] * k[i] * k[i];
            }
            found = light.first_fall(found);
            found = Cubic{peak_ - light.a, -light.b, -light.c, -light.d}.first_fall(found);
        }
        return found;
    }

  private:
    Matrix3 to_light_;
    double peak_;
};

Transform compile_gamut_compression(const Values& values, const OpContext& context) {
    const auto value = [&values](std::size_t i) { return std::get<double>(values[i]); };
    const double amount = value(0), threshold = value(1), limit = value(2);
    if (amount == 0) {
        return {};
    }
    const double room = 1 - threshold, power = (limit - threshold) / room;
    return Transform::each([=, gamut = Gamut(context, value(3))](RgbD c) {
        const double L = std::clamp(c.r, 0.0, gamut.highest_lightness());
        const double chroma = std::hypot(c.g, c.b);
        const double kept_L = c.r + amount * (L - c.r);
        if (!(chroma > 0)) {
            return RgbD{kept_L, c.g, c.b};
        }
        const double most = chroma / threshold;
        const double edge = L > 0 ? gamut.edge(L, c.g / chroma, c.b / chroma, most) : 0;
        if (edge >= most) {
            return RgbD{kept_L, c.g, c.b};
        }
        const double t =
            edge > 0 ? std::min((chroma / edge - threshold) / (limit - threshold), 1.0) : 1;
        const double distance = threshold + room * (1 - std::pow(1 - t, power));
        const double factor = 1 + amount * (inside * distance * edge / chroma - 1);
        return RgbD{kept_L, c.g * factor, c.b * factor};
    });
}

} // namespace

const Op gamut_compression{
    .name = "gamut-compression",
    .label = "Gamut compression",
    .help =
        "Draws what the result's gamut cannot hold into it, softly, and keeps hue and lightness; "
        "the last operator of a look that shall stay within 0..1",
    .reference = "threshold and limit of the ACES 1.3 Reference Gamut Compression, on Oklab chroma "
                 "over that of the gamut's edge",
    .space = Space::oklab,
    .parameters = gamut_compression_parameters,
    .monotone_on_neutrals = true,
    .compile = compile_gamut_compression};

} // namespace lutlib::op
