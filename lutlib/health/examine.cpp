#include "lutlib/health/axis.h"
#include "lutlib/health/parts.h"
#include "lutlib/metrics/viewing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace lutlib {
namespace health {
namespace {

// Every stored colour that is an output of the look.
std::span<const Rgb> outputs(const Lut& lut) {
    if (lut.cube) {
        return lut.cube->nodes;
    }
    return lut.shaper ? std::span<const Rgb>(lut.shaper->entries) : std::span<const Rgb>();
}

// The input of the look that gives output k.
class Places {
  public:
    explicit Places(const Lut& lut) : lut_(lut) {
        if (lut.cube) {
            nodes_ = inputs_of_nodes(lut, *lut.cube);
        }
    }

    Rgb operator()(std::size_t k) const {
        if (!lut_.cube) {
            return to_float(entry_position(*lut_.shaper, static_cast<int>(k)));
        }
        const auto n = static_cast<std::size_t>(lut_.cube->size);
        return to_float({nodes_[0][k % n], nodes_[1][k / n % n], nodes_[2][k / (n * n)]});
    }

  private:
    const Lut& lut_;
    std::array<std::vector<double>, 3> nodes_;
};

bool all_codes(const Lut& lut, double maximum) {
    bool all = true;
    double highest = 0;
    for (const Rgb& value : outputs(lut)) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double code = static_cast<double>(value[c]) * maximum;
            // A code divided by its maximum in float, and read back from six decimals.
            all = all && std::abs(code - std::round(code)) < maximum * 6e-7 && code >= 0 &&
                  code <= maximum;
            highest = std::max(highest, code);
        }
    }
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
    for (const Rgb& value : outputs(lut)) {
        if (finite(value)) {
            size = std::max(size, largest_magnitude(to_double(value)));
        }
    }
    return std::max(5e-7 * std::min(size, 1.0),
                    static_cast<double>(std::numeric_limits<float>::denorm_min()));
}

StoredValues examine_values(const Lut& lut) {
    StoredValues out;
    out.lowest.value = std::numeric_limits<double>::infinity();
    out.highest.value = -out.lowest.value;
    const Places place(lut);
    const std::span<const Rgb> values = outputs(lut);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Rgb& value = values[k];
        for (std::size_t c = 0; c < 3; ++c) {
            ++out.values;
            if (!std::isfinite(value[c])) {
                ++out.non_finite;
                out.first_non_finite = out.first_non_finite.value_or(place(k));
                continue;
            }
            out.outside += value[c] < 0 || value[c] > 1;
            if (value[c] < out.lowest.value) {
                out.lowest = {value[c], place(k)};
            }
            if (value[c] > out.highest.value) {
                out.highest = {value[c], place(k)};
            }
        }
    }
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
    return out;
}

namespace {

Results results_of(const Encoding& output) {
    constexpr double above_white = 1.5;
    return is_hdr(output)                                                     ? Results::hdr
           : output.curve->name == "linear" || output.decode(1) > above_white ? Results::scene
                                                                              : Results::display;
}

} // namespace

Codes codes_of(const Lut& lut, const LookEncodings& stated) {
    const LookEncodings said = encodings_of(lut.encodings);
    Codes out;
    out.input = stated.input ? *stated.input : said.input.value_or(srgb());
    out.output = stated.output ? *stated.output : said.output.value_or(srgb());
    out.results = results_of(out.output);
    out.display_input = results_of(out.input) == Results::display;
    return out;
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

// Of a curve and the cube behind it: a plateau of either is one of the look.
TableHealth joined(TableHealth cube, const TableHealth& curve) {
    if (curve.plateau.value > cube.plateau.value) {
        cube.plateau = curve.plateau;
    }
    return cube;
}

} // namespace
} // namespace health

Health examine(const Lut& lut, const ExamineOptions& options) {
    Health out;
    if (!lut.shaper && !lut.cube) {
        Lut identity = lut;
        identity.cube = identity_cube(2);
        return examine(identity, options);
    }
    const health::Codes codes = health::codes_of(lut, options.encodings);
    out.results = codes.results;
    const double rounding = health::rounding_of(lut);
    const Lut3D after = lut.cube ? Lut3D{} : health::cube_after(*lut.shaper);
    const Lut3D& cube = lut.cube ? *lut.cube : after;
    static_cast<StoredValues&>(out) = health::examine_values(lut);
    static_cast<SpikesExamined&>(out) = health::examine_spikes(lut);
    const health::CellsExamined cells = health::examine_cells(lut, cube, rounding);
    static_cast<CellHealth&>(out) = cells.cells;
    static_cast<TableHealth&>(out) = cells.table;
    // Steps of a channel's ramp cannot exceed what the look's outputs span.
    const double range = std::max(0.0, out.highest.value - out.lowest.value);
    out.banding_channel.value = std::min(out.banding_channel.value, 255 * range);
    if (lut.shaper) {
        const health::CurveExamined curve =
            health::examine_curve(*lut.shaper, lut.cube ? &cube : nullptr, rounding);
        static_cast<ShaperHealth&>(out) = curve.shaper;
        static_cast<TableHealth&>(out) =
            lut.cube ? health::joined(cells.table, curve.table) : curve.table;
    }
    static_cast<NeutralHealth&>(out) = health::examine_neutrals(lut, codes, rounding);
    out.noise_gain = health::examine_black(lut);
    if (options.lattices) {
        out.lattices =
            health::measure_lattices(lut, options.exact.value_or(Transform::of(lut)), codes);
    }
    return out;
}

} // namespace lutlib
