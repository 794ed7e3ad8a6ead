#include "lutlib/resample/invert.h"

#include "lutlib/color/matrix.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/nodes.h"
#include "lutlib/resample/invert_curve.h"
#include "lutlib/resample/invert_index.h"
#include "lutlib/resample/invert_outside.h"
#include "lutlib/resample/sample_lut.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr int largest_size = 129;

// How the inverse at one node came about.
struct Answer {
    RgbD input;
    bool missing = false;
    double distance = 0; // of a missing colour to the nearest output
    double spread = 0;   // between the inputs of a folded colour
    double moved = -1;   // of a flat colour, from itself to its input
};

enum class Fate { undoable, flat, folded };

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
        Answer out = among(found(wanted, wanted), wanted);
        if (!out.missing) {
            return out;
        }
        const Nearest nearest = index_.nearest(wanted);
        out.input = unshaped(nearest.input);
        const RgbD reachable = evaluate_exact(lut_, out.input);
        out.distance =
            reached(nearest.input) ? nearest.distance : largest_magnitude(reachable - wanted);
        // Rounding may leave a colour on the gamut's surface a hair outside.
        out.missing = out.distance > 1e-6 * std::max(1.0, largest_magnitude(wanted));
        // Of all that give the nearest colour too, the input nearest to the wanted one.
        const Answer flat = among(found(reachable, wanted), wanted);
        if (flat.moved >= 0) {
            out.input = flat.input;
        }
        return out;
    }

    Fate fate(RgbD input) const {
        const RgbD place = shaped(input);
        if (!reached(place) || index_.is_flat(place)) {
            return Fate::flat;
        }
        const RgbD output = evaluate_exact(*lut_.cube, place, Interpolation::tetrahedral);
        const Preimages all = found(output, input);
        const bool elsewhere =
            all.flat || std::any_of(all.points.begin(), all.points.end(), [&](RgbD other) {
                return largest_magnitude(other - place) > same * width_;
            });
        return elsewhere ? Fate::folded : Fate::undoable;
    }

    // Cells to look at for one colour.
    double work() const { return std::max(index_.cells_of_bucket(), 1.0); }

    bool is_flat(RgbD place) const { return index_.is_flat(place); }

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

    RgbD shaped(RgbD input) const {
        return lut_.shaper ? evaluate_exact(*lut_.shaper, input) : input;
    }

  private:
    // Inputs of the cube nearer than this share of its width are one place, found in two tetrahedra
    // that share it.
    static constexpr double same = 1e-5;

    Preimages found(RgbD wanted, RgbD near) const {
        Preimages out = index_.preimages(wanted, shaped(near));
        std::erase_if(out.points, [this](RgbD place) { return !reached(place); });
        if (out.flat && !reached(*out.flat)) {
            out.flat.reset();
        }
        return out;
    }

    // The input nearest to the wanted colour: the sheet that an unfolded look has.
    Answer among(const Preimages& all, RgbD wanted) const {
        Answer out;
        out.missing = all.points.empty() && !all.flat;
        if (out.missing) {
            return out;
        }
        RgbD chosen = all.flat ? *all.flat : all.points.front();
        out.input = unshaped(chosen);
        for (const RgbD& place : all.points) {
            const RgbD input = unshaped(place);
            if (largest_magnitude(input - wanted) < largest_magnitude(out.input - wanted)) {
                chosen = place;
                out.input = input;
            }
        }
        if (all.flat) {
            out.moved = largest_magnitude(out.input - wanted);
            return out;
        }
        for (const RgbD& place : all.points) {
            if (largest_magnitude(place - chosen) > same * width_) {
                out.spread = std::max(out.spread, largest_magnitude(unshaped(place) - out.input));
            }
        }
        return out;
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

// An even colour of every cell of a lattice over the look's inputs, each at a place of its own.
std::vector<Rgb> inputs_of(const Domain& domain, int cells) {
    std::vector<Rgb> out;
    double phase = 0;
    for_each_node(cells, [&](int r, int g, int b) {
        // Steps of the plastic number's powers (M. Roberts, "The unreasonable effectiveness of
        // quasirandom sequences", 2018) spread over the cube.
        phase += 1;
        const RgbD within{std::fmod(phase * 0.8191725133961645, 1),
                          std::fmod(phase * 0.6710436067037893, 1),
                          std::fmod(phase * 0.5497004779019703, 1)};
        const std::array<int, 3> cell{r, g, b};
        Rgb input;
        for (std::size_t c = 0; c < 3; ++c) {
            input[c] = static_cast<float>(std::lerp(static_cast<double>(domain.min[c]),
                                                    static_cast<double>(domain.max[c]),
                                                    (cell[c] + within[c]) / cells));
        }
        out.push_back(input);
    });
    return out;
}

void judge_inputs(const Lut& lut, const Solver& solver, Inversion& out) {
    // Fewer of a wild look, of which each takes long.
    constexpr int usual_cells = 32, least_cells = 4;
    constexpr double most_work = 5e6; // cells of the look
    const int cells = std::clamp(static_cast<int>(std::cbrt(most_work / solver.work())),
                                 least_cells, usual_cells);
    const std::vector<Rgb> inputs = inputs_of(lut.domain(), cells);
    std::vector<Fate> fates(inputs.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, inputs.size(), 256),
                      [&](const auto& range) {
                          for (std::size_t i = range.begin(); i < range.end(); ++i) {
                              fates[i] = solver.fate(to_double(inputs[i]));
                          }
                      });
    const double each = 1 / static_cast<double>(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        out.inputs.undoable += fates[i] == Fate::undoable ? each : 0;
        out.inputs.flat += fates[i] == Fate::flat ? each : 0;
        out.inputs.folded += fates[i] == Fate::folded ? each : 0;
        if (fates[i] == Fate::undoable) {
            out.undoable.push_back(inputs[i]);
        }
    }
}

// Where a colour lies among the inverse's nodes.
RgbD place_in(const Lut& inverse, RgbD colour) {
    const RgbD shaped = inverse.shaper ? evaluate_exact(*inverse.shaper, colour) : colour;
    const Domain& domain = inverse.cube->domain;
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = domain.min[c], max = domain.max[c];
        out[c] = (shaped[c] - min) / (max - min) * (inverse.cube->size - 1);
    }
    return out;
}

// Every node of the look, and between them, closely enough that each cell of the inverse has some.
std::vector<InverseSample> samples_of(const Lut& look, const Solver& solver, const Lut& inverse) {
    constexpr int most = 65;
    const int size = std::min(2 * std::max(look.cube->size, inverse.cube->size) - 1, most);
    std::vector<InverseSample> out;
    for (const Rgb& node : identity_cube(size, look.cube->domain).nodes) {
        const RgbD place = to_double(node);
        if (solver.reached(place) && !solver.is_flat(place)) {
            out.push_back(
                {place_in(inverse, evaluate_exact(*look.cube, place, Interpolation::tetrahedral)),
                 solver.unshaped(place)});
        }
    }
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

std::span<const OutsideInfo> outside_choices() {
    static constexpr std::array<OutsideInfo, 3> table{{
        {Outside::nearest, "nearest", "the input whose output lies nearest"},
        {Outside::extrapolate, "extrapolate",
         "the same, and beyond the look's inputs where cells also hold colours that it gives"},
        {Outside::refuse, "refuse", "an error"},
    }};
    return table;
}

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

    Lut look = lut;
    look.cube = cube;
    look.interpolation.reset();
    const Solver solver(look, *look.cube);
    Inversion out;
    if (options.shaper.empty() || options.shaper == "none") {
        out.lut.cube = identity_cube(size, domain);
    } else {
        out.lut.shaper =
            encoding_shaper(options.shaper, options.input, domain, options.shaper_size);
        // The colours that the table maps to the nodes.
        out.lut.cube = sample_cube_behind({}, *out.lut.shaper, size);
    }
    Lut3D& inverse = *out.lut.cube;
    out.nodes = inverse.nodes.size();
    std::vector<Answer> answers(out.nodes);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.nodes, 256), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            answers[i] = solver.solve(to_double(inverse.nodes[i]));
        }
    });
    constexpr double itself = 1e-6; // float nodes
    std::vector<bool> open(out.nodes);
    for (std::size_t i = 0; i < out.nodes; ++i) {
        const Rgb wanted = inverse.nodes[i];
        const Answer& answer = answers[i];
        if (answer.missing) {
            add(out.out_of_gamut, wanted, answer.distance);
            open[i] = true;
        } else if (answer.moved >= 0) {
            add(out.flat, wanted, answer.moved);
            open[i] = answer.moved > itself;
        } else if (answer.spread > 0) {
            add(out.folded, wanted, answer.spread);
        }
        inverse.nodes[i] = to_float(answer.input);
    }
    if (options.outside == Outside::refuse && out.out_of_gamut.count > 0) {
        throw Error(std::to_string(out.out_of_gamut.count) + " of " + std::to_string(out.nodes) +
                    " nodes of the inverse lie outside what the look can give; choose a smaller "
                    "domain, or how they are filled");
    }
    if (options.outside == Outside::extrapolate) {
        out.extrapolated = fit_open_nodes(inverse, open, samples_of(look, solver, out.lut));
    }
    judge_inputs(look, solver, out);
    out.lut.title = inverse_title(lut);
    out.lut.encodings = inverse_encodings(lut);
    return out;
}

} // namespace lutlib
