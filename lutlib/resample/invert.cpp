#include "lutlib/resample/invert.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/nodes.h"
#include "lutlib/resample/invert_curve.h"
#include "lutlib/resample/invert_outside.h"
#include "lutlib/resample/invert_shaper.h"
#include "lutlib/resample/invert_solver.h"
#include "lutlib/resample/sample_lut.h"
#include "lutlib/transform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace lutlib {
namespace {

constexpr int largest_inverse = 129;

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

// Of more of them than are judged.
std::vector<RgbD> outputs_of(const Lut& lut) {
    constexpr int cells = 48;
    return images_of(Transform::of(lut, Interpolation::tetrahedral),
                     inputs_of(lut.domain(), cells));
}

struct Judged {
    InputShares shares;
    std::vector<Rgb> undoable;
};

Judged judged_inputs(const Lut& lut, const InverseSolver& solver) {
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
    Judged out;
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        ++count[static_cast<std::size_t>(fates[i])];
        if (fates[i] == Fate::undoable) {
            out.undoable.push_back(inputs[i]);
        }
    }
    const auto share = [&](Fate fate) {
        return static_cast<double>(count[static_cast<std::size_t>(fate)]) /
               static_cast<double>(inputs.size());
    };
    out.shares = {share(Fate::undoable), share(Fate::flat), share(Fate::folded)};
    return out;
}

// Where a colour lies among the inverse's nodes.
RgbD place_in(const Lut& inverse, RgbD color) {
    const RgbD shaped = inverse.shaper ? evaluate_exact(*inverse.shaper, color) : color;
    const Domain& domain = inverse.cube->domain;
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const double min = domain.min[c], max = domain.max[c];
        out[c] = (shaped[c] - min) / (max - min) * (inverse.cube->size - 1);
    }
    return out;
}

// Of the look's inputs, closely enough that each cell of the inverse has some, those that can be
// undone and that read an open node of the inverse. Of others the inverse gives another input.
std::vector<InverseSample> samples_of(const Lut& look, const InverseSolver& solver,
                                      const Lut& inverse, const std::vector<bool>& open,
                                      double folded) {
    // Whether an input is folded takes a search each, which is long where many are.
    const bool folds = folded > 0;
    const int most = folded > 0.1 ? 97 : 129;
    const int size = std::min(2 * std::max(look.cube->size, inverse.cube->size) - 1, most);
    const std::vector<Rgb> places = identity_cube(size, look.cube->domain).nodes;
    const auto reads_open_node = [&](RgbD among_nodes) {
        const NodeWeights read =
            node_weights(Interpolation::tetrahedral, inverse.cube->size, among_nodes);
        return std::any_of(read.node.begin(),
                           read.node.begin() + static_cast<std::ptrdiff_t>(read.count),
                           [&](std::size_t node) { return open[node]; });
    };
    const auto sample_at = [&](RgbD place) -> std::optional<InverseSample> {
        const RgbD at =
            place_in(inverse, evaluate_exact(*look.cube, place, Interpolation::tetrahedral));
        const RgbD input = solver.unshaped(place);
        const bool is_wanted = solver.reached(place) && !solver.is_flat(place) &&
                               reads_open_node(at) &&
                               (!folds || solver.fate(input) == Fate::undoable);
        return is_wanted ? std::optional(InverseSample{at, input}) : std::nullopt;
    };
    // Planes at once, and in their order.
    const auto plane = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    std::vector<std::vector<InverseSample>> found(static_cast<std::size_t>(size));
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
        for (std::size_t i = 0; i < plane; ++i) {
            if (const auto sample = sample_at(to_double(places[k * plane + i]))) {
                found[k].push_back(*sample);
            }
        }
    });
    std::vector<InverseSample> out;
    for (const std::vector<InverseSample>& part : found) {
        out.insert(out.end(), part.begin(), part.end());
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

// A look made ready: it always has a cube.
struct Inverter::Parts {
    Lut look;
    InvertOptions options;
    Domain domain;
    InverseSolver solver;
    Judged judged;

    Parts(Lut of, const InvertOptions& how)
        : look(std::move(of)), options(how), domain(options.domain.value_or(inverse_domain(look))),
          solver(look), judged(judged_inputs(look, solver)) {
        check_domain(domain);
    }
};

namespace {

Lut with_cube(const Lut& lut) {
    if (lut.shaper) {
        check_invertible(*lut.shaper);
    }
    Lut out = lut;
    if (!out.cube) {
        out.cube = identity_cube(2, output_range(lut));
    }
    if (out.cube->size > largest_inverse) {
        throw Error("a cube of " + std::to_string(out.cube->size) +
                    " nodes per axis is too large to "
                    "invert; resample it to at most " +
                    std::to_string(largest_inverse));
    }
    out.interpolation.reset();
    return out;
}

} // namespace

Inverter::Inverter(const Lut& lut, const InvertOptions& options)
    : parts_(std::make_unique<Parts>(with_cube(lut), options)) {}

Inverter::~Inverter() = default;

double Inverter::work() const {
    return parts_->solver.work();
}

const std::vector<Rgb>& Inverter::undoable() const {
    return parts_->judged.undoable;
}

Inversion Inverter::of(int size) const {
    return of(size, parts_->options.shaper);
}

Inversion Inverter::of(int size, std::string_view shaper) const {
    check_cube_size(size);
    const Lut& look = parts_->look;
    const InvertOptions& options = parts_->options;
    const Domain& domain = parts_->domain;
    const InverseSolver& solver = parts_->solver;
    Inversion out;
    if (shaper.empty() || shaper == "none") {
        out.lut.cube = identity_cube(size, domain);
    } else {
        out.lut.shaper = shaper == outputs_shaper
                             ? output_shaper(outputs_of(look), domain, options.shaper_size)
                             : encoding_shaper(shaper, options.input, domain, options.shaper_size);
        // The colours that the table maps to the nodes.
        out.lut.cube = sample_cube_behind({}, *out.lut.shaper, size);
    }
    Lut3D& inverse = *out.lut.cube;
    out.nodes = inverse.nodes.size();
    std::vector<InverseAnswer> answers(out.nodes);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.nodes, 256), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            answers[i] = solver.solve(to_double(inverse.nodes[i]));
        }
    });
    constexpr double itself = 1e-6; // float nodes
    std::vector<bool> open(out.nodes);
    for (std::size_t i = 0; i < out.nodes; ++i) {
        const Rgb wanted = inverse.nodes[i];
        const InverseAnswer& answer = answers[i];
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
        out.extrapolated = fit_open_nodes(
            inverse, open, samples_of(look, solver, out.lut, open, parts_->judged.shares.folded));
    }
    out.inputs = parts_->judged.shares;
    out.undoable = parts_->judged.undoable;
    out.lut.title = inverse_title(look);
    out.lut.encodings = inverse_encodings(look);
    return out;
}

int own_inverse_size(const Lut& lut) {
    return lut.cube ? lut.cube->size : usual_cube_size;
}

Inversion invert(const Lut& lut, const InvertOptions& options) {
    if (lut.shaper && !lut.cube) {
        return inverse_table(lut, options);
    }
    return Inverter(lut, options).of(options.size.value_or(own_inverse_size(lut)));
}

} // namespace lutlib
