#include "lutlib/health/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lutlib {
namespace health {
namespace {

// Calls visit(value, place) for every stored colour that is an output of the look.
template <class F>
void each_output(const Lut& lut, F visit) {
    if (lut.cube) {
        const int n = lut.cube->size;
        for (int b = 0; b < n; ++b) {
            for (int g = 0; g < n; ++g) {
                for (int r = 0; r < n; ++r) {
                    visit(lut.cube->at(r, g, b), to_float(node_position(*lut.cube, r, g, b)));
                }
            }
        }
    } else if (lut.shaper) {
        for (int i = 0; i < lut.shaper->size(); ++i) {
            visit(lut.shaper->entries[static_cast<std::size_t>(i)],
                  to_float(entry_position(*lut.shaper, i)));
        }
    }
}

bool all_codes(const Lut& lut, double maximum) {
    bool all = true;
    double highest = 0;
    each_output(lut, [&](const Rgb& value, const Rgb&) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double code = static_cast<double>(value[c]) * maximum;
            // A code divided by its maximum in float, and read back from six decimals.
            all = all && std::abs(code - std::round(code)) < maximum * 6e-7 && code >= 0 &&
                  code <= maximum;
            highest = std::max(highest, code);
        }
    });
    return all && highest >= 1;
}

} // namespace

bool finite(const Rgb& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

double rounding_of(const Lut& lut) {
    for (const double maximum : {255.0, 1023.0, 4095.0}) {
        if (all_codes(lut, maximum)) {
            return 0.5 / maximum;
        }
    }
    double size = 0;
    each_output(lut, [&](const Rgb& value, const Rgb&) {
        if (finite(value)) {
            size = std::max({size, static_cast<double>(std::abs(value.r)),
                             static_cast<double>(std::abs(value.g)),
                             static_cast<double>(std::abs(value.b))});
        }
    });
    return std::max(5e-7 * std::min(size, 1.0),
                    static_cast<double>(std::numeric_limits<float>::denorm_min()));
}

void examine_values(const Lut& lut, Health& out) {
    out.lowest.value = std::numeric_limits<double>::infinity();
    out.highest.value = -out.lowest.value;
    each_output(lut, [&out](const Rgb& value, const Rgb& in) {
        for (std::size_t c = 0; c < 3; ++c) {
            ++out.values;
            if (!std::isfinite(value[c])) {
                ++out.non_finite;
                out.first_non_finite = out.first_non_finite.value_or(in);
                continue;
            }
            out.outside += value[c] < 0 || value[c] > 1;
            if (value[c] < out.lowest.value) {
                out.lowest = {value[c], in};
            }
            if (value[c] > out.highest.value) {
                out.highest = {value[c], in};
            }
        }
    });
    if (lut.shaper && lut.cube) {
        for (int i = 0; i < lut.shaper->size(); ++i) {
            const Rgb& entry = lut.shaper->entries[static_cast<std::size_t>(i)];
            for (std::size_t c = 0; c < 3; ++c) {
                ++out.values;
                if (!std::isfinite(entry[c])) {
                    ++out.non_finite;
                    out.first_non_finite =
                        out.first_non_finite.value_or(to_float(entry_position(*lut.shaper, i)));
                }
            }
        }
    }
}

namespace {

// A curve alone is a shaper before a cube that changes nothing: the coarsest that spans its values.
Lut3D cube_after(const Lut1D& curve) {
    Domain range;
    for (std::size_t c = 0; c < 3; ++c) {
        float low = 0, high = 0;
        bool first = true;
        for (const Rgb& entry : curve.entries) {
            if (std::isfinite(entry[c])) {
                low = first ? entry[c] : std::min(low, entry[c]);
                high = first ? entry[c] : std::max(high, entry[c]);
                first = false;
            }
        }
        range.min[c] = low;
        range.max[c] = low < high ? high : low + std::max(1.0F, std::abs(low));
    }
    return identity_cube(2, range);
}

} // namespace
} // namespace health

Health examine(const Lut& lut) {
    Health out;
    if (!lut.shaper && !lut.cube) {
        Lut identity;
        identity.cube = identity_cube(2);
        return examine(identity);
    }
    const double rounding = health::rounding_of(lut);
    const Lut3D after = lut.cube ? Lut3D{} : health::cube_after(*lut.shaper);
    const Lut3D& cube = lut.cube ? *lut.cube : after;
    health::examine_values(lut, out);
    health::examine_cells(lut, cube, rounding, out);
    // Steps of a channel's ramp cannot exceed what the look's outputs span.
    const double range = std::max(0.0, out.highest.value - out.lowest.value);
    out.banding_channel.value = std::min(out.banding_channel.value, 255 * range);
    if (lut.shaper) {
        health::examine_curve(*lut.shaper, lut.cube ? &cube : nullptr, rounding, out);
    }
    health::examine_neutrals(lut, rounding, out);
    health::examine_black(lut, out);
    health::predict_errors(lut, rounding, out);
    return out;
}

} // namespace lutlib
