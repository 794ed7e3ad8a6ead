#include "lutlib/color/oklab.h"
#include "lutlib/ops/all.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lutlib::op {
namespace {

constexpr Parameter hue(std::string_view name, std::string_view flag, std::string_view label,
                        double fallback) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .unit = "degrees, red at 0",
            .min = 0,
            .max = 360,
            .fallback = fallback};
}

constexpr Parameter amount(std::string_view name, std::string_view flag, std::string_view label) {
    return {.name = name,
            .flag = flag,
            .label = label,
            .unit = "Oklab chroma / .1",
            .min = 0,
            .max = 1,
            .fallback = 0};
}

constexpr Parameter split_toning_parameters[] = {
    hue("shadow_hue", "split-shadow-hue", "Shadow hue", 210),
    amount("shadow_amount", "split-shadow-amount", "Shadow amount"),
    hue("highlight_hue", "split-highlight-hue", "Highlight hue", 35),
    amount("highlight_amount", "split-highlight-amount", "Highlight amount"),
    {.name = "balance",
     .flag = "split-balance",
     .label = "Balance",
     .unit = "Oklab L",
     .min = 0.1,
     .max = 0.9,
     .fallback = 0.5},
};

struct Tint {
    double a, b;
};

Tint tint(const Value& hue_value, const Value& amount_value) {
    const double chroma = 0.1 * std::get<double>(amount_value);
    const double h = oklab_hue(std::get<double>(hue_value)) * std::numbers::pi / 180;
    return {chroma * std::cos(h), chroma * std::sin(h)};
}

double smoothstep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Black and white stay: the shadows' weight rises from 0 at L = 0, the highlights' falls to 0 at
// L = 1; both are 0 outside.
Transform compile_split_toning(const Values& values, const OpContext&) {
    const Tint shadow = tint(values[0], values[1]), highlight = tint(values[2], values[3]);
    const double balance = std::get<double>(values[4]);
    const double dark_end = std::min(1.0, 2 * balance),
                 light_start = std::max(0.0, 2 * balance - 1);
    return Transform::each([=](RgbD c) {
        const double L = c.r;
        const double dark = smoothstep(0, dark_end / 4, L) * (1 - smoothstep(0, dark_end, L));
        const double light =
            smoothstep(light_start, 1, L) * (1 - smoothstep(1 - (1 - light_start) / 4, 1, L));
        return RgbD{L, c.g + dark * shadow.a + light * highlight.a,
                    c.b + dark * shadow.b + light * highlight.b};
    });
}

} // namespace

const Op split_toning{.name = "split-toning",
                      .label = "Split toning",
                      .help = "Tints shadows and highlights; black and white stay neutral",
                      .reference = "added to Oklab's a and b, weighted by smooth steps of L",
                      .space = Space::oklab,
                      .parameters = split_toning_parameters,
                      .compile = compile_split_toning};

} // namespace lutlib::op
