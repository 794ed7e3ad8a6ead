#include "lutlib/resample/invert.h"

#include "lutlib/color/matrix.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/resample/invert_index.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr int largest_size = 129;

// A curve that rises or falls strictly, read backwards, per channel.
double inverse_of_curve(const Lut1D& curve, double y, std::size_t c) {
    const auto entry = [&](int i) {
        return static_cast<double>(curve.entries[static_cast<std::size_t>(i)][c]);
    };
    const int n = curve.size();
    const double sign = entry(n - 1) > entry(0) ? 1 : -1;
    int low = 0, high = n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        (sign * entry(middle) <= sign * y ? low : high) = middle;
    }
    const double t = std::clamp((y - entry(low)) / (entry(low + 1) - entry(low)), 0.0, 1.0);
    return entry_position(curve, low)[c] * (1 - t) + entry_position(curve, low + 1)[c] * t;
}

void check_invertible(const Lut1D& curve) {
    for (std::size_t c = 0; c < 3; ++c) {
        const bool rises = curve.entries.front()[c] < curve.entries.back()[c];
        for (std::size_t i = 0; i + 1 < curve.entries.size(); ++i) {
            const float a = curve.entries[i][c], b = curve.entries[i + 1][c];
            if (!(rises ? a < b : a > b)) {
                throw Error(std::string("the 1D table of channel ") + "rgb"[c] +
                            " is flat or not monotonic at entry " + std::to_string(i + 1) +
                            ", so it has no inverse");
            }
        }
    }
}

// How the inverse at one node came about.
struct Answer {
    RgbD input;
    bool missing = false;
    double distance = 0; // of a missing colour to the nearest output
    double spread = 0;   // between the inputs of a folded colour
};

class Solver {
  public:
    Solver(const Lut& lut, const Lut3D& cube) : lut_(lut), index_(cube) {
        for (std::size_t c = 0; c < 3; ++c) {
            width_ = std::max(width_, static_cast<double>(cube.domain.max[c]) -
                                          static_cast<double>(cube.domain.min[c]));
        }
        if (lut.shaper) {
            Lut curve;
            curve.shaper = lut.shaper;
            shaped_ = output_range(curve);
        }
    }

    Answer solve(RgbD wanted) const {
        Answer out;
        std::vector<RgbD> places;
        index_.preimages(wanted, places);
        std::erase_if(places, [this](RgbD place) { return !reached(place); });
        if (places.empty()) {
            const Nearest nearest = index_.nearest(wanted);
            out.input = unshaped(nearest.input);
            out.distance = reached(nearest.input)
                               ? nearest.distance
                               : largest_magnitude(evaluate_exact(lut_, out.input) - wanted);
            // Rounding may leave a colour on the gamut's surface a hair outside.
            out.missing = out.distance > 1e-6 * std::max(1.0, largest_magnitude(wanted));
            return out;
        }
        // Of several, the input nearest to the wanted colour: the sheet that an unfolded look has.
        RgbD chosen = places.front();
        out.input = unshaped(chosen);
        for (const RgbD& place : places) {
            const RgbD input = unshaped(place);
            if (largest_magnitude(input - wanted) < largest_magnitude(out.input - wanted)) {
                chosen = place;
                out.input = input;
            }
        }
        for (const RgbD& place : places) {
            if (largest_magnitude(place - chosen) > same * width_) {
                out.spread = std::max(out.spread, largest_magnitude(unshaped(place) - out.input));
            }
        }
        return out;
    }

  private:
    // Inputs of the cube nearer than this share of its width are one place, found in two tetrahedra
    // that share it.
    static constexpr double same = 1e-5;

    // Whether the 1D table gives this input of the cube.
    bool reached(RgbD place) const {
        for (std::size_t c = 0; shaped_ && c < 3; ++c) {
            if (place[c] < static_cast<double>(shaped_->min[c]) - same * width_ ||
                place[c] > static_cast<double>(shaped_->max[c]) + same * width_) {
                return false;
            }
        }
        return true;
    }

    RgbD unshaped(RgbD place) const {
        for (std::size_t c = 0; lut_.shaper && c < 3; ++c) {
            place[c] = inverse_of_curve(*lut_.shaper, place[c], c);
        }
        return place;
    }

    const Lut& lut_;
    OutputIndex index_;
    double width_ = 0;
    std::optional<Domain> shaped_; // what the 1D table gives
};

void add(InverseRegion& region, Rgb wanted, double extent) {
    if (region.count++ == 0) {
        region.low = region.high = wanted;
    }
    for (std::size_t c = 0; c < 3; ++c) {
        region.low[c] = std::min(region.low[c], wanted[c]);
        region.high[c] = std::max(region.high[c], wanted[c]);
    }
    if (extent > region.extent) {
        region.extent = extent;
        region.worst = wanted;
    }
}

std::string inverse_title(const Lut& lut) {
    return lut.title.empty() ? "" : "Inverse of " + lut.title;
}

EncodingNames inverse_encodings(const Lut& lut) {
    return {lut.encodings.output, lut.encodings.input};
}

Inversion inverse_table(const Lut& lut, const InvertOptions& options) {
    CurveInversion inverse = invert_curve(*lut.shaper, {options.size, options.domain});
    Inversion out;
    out.lut.shaper = std::move(inverse.curve);
    out.lut.title = inverse_title(lut);
    out.lut.encodings = inverse_encodings(lut);
    out.curve = inverse.channels;
    return out;
}

Domain inverse_domain(const Lut& lut) {
    Domain out;
    const Domain range = output_range(lut);
    for (std::size_t c = 0; c < 3; ++c) {
        out.min[c] = std::min(out.min[c], range.min[c]);
        out.max[c] = std::max(out.max[c], range.max[c]);
    }
    return out;
}

} // namespace

Domain output_range(const Lut& lut) {
    Domain out{lut.domain()};
    const std::vector<Rgb>* values = lut.cube     ? &lut.cube->nodes
                                     : lut.shaper ? &lut.shaper->entries
                                                  : nullptr;
    if (values) {
        out.min = out.max = values->front();
        for (const Rgb& value : *values) {
            for (std::size_t c = 0; c < 3; ++c) {
                out.min[c] = std::min(out.min[c], value[c]);
                out.max[c] = std::max(out.max[c], value[c]);
            }
        }
    }
    return out;
}

Inversion invert(const Lut& lut, const InvertOptions& options) {
    if (lut.shaper && !lut.cube) {
        return inverse_table(lut, options);
    }
    if (lut.shaper) {
        check_invertible(*lut.shaper);
    }
    const Lut3D cube = lut.cube ? *lut.cube : identity_cube(2, output_range(lut));
    if (cube.size > largest_size) {
        throw Error("a cube of " + std::to_string(cube.size) +
                    " nodes per axis is too large to "
                    "invert; resample it to at most " +
                    std::to_string(largest_size));
    }
    const int size = options.size.value_or(lut.cube ? cube.size : usual_cube_size);
    check_cube_size(size);
    const Domain domain = options.domain.value_or(inverse_domain(lut));
    check_domain(domain);

    const Solver solver(lut, cube);
    Inversion out;
    Lut3D inverse = identity_cube(size, domain);
    out.nodes = inverse.nodes.size();
    std::vector<Answer> answers(out.nodes);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.nodes, 256), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            answers[i] = solver.solve(to_double(inverse.nodes[i]));
        }
    });
    for (std::size_t i = 0; i < out.nodes; ++i) {
        const Rgb wanted = inverse.nodes[i];
        const Answer& answer = answers[i];
        if (answer.missing) {
            add(out.out_of_gamut, wanted, answer.distance);
        } else if (answer.spread > 0) {
            add(out.folded, wanted, answer.spread);
        }
        inverse.nodes[i] = to_float(answer.input);
    }
    out.lut.cube = std::move(inverse);
    out.lut.title = inverse_title(lut);
    out.lut.encodings = inverse_encodings(lut);
    return out;
}

} // namespace lutlib
