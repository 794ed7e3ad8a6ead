#include "lutlib/survey/stiff_survey.h"

#include "lutlib/codes.h"
#include "lutlib/color/transfer.h"
#include "lutlib/fit/fit.h"
#include "lutlib/interpolation/tricubic.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/named.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace lutlib {
namespace {

// Nodes are floats, so smaller errors say nothing of an interpolation.
constexpr double rounding = 2e-6;
constexpr int shaper_entries = 4096;

std::vector<StiffMethod> make_methods() {
    const Lookup& tetrahedral = lookup_of(Interpolation::tetrahedral);
    const auto kept = [](std::string_view name) { return find_named(storages(), name); };
    const Storage* const floats = kept("float");
    return {
        {.name = "nearest",
         .label = "nearest",
         .lookup = &lookup_of(Interpolation::nearest),
         .storage = floats},
        {.name = "trilinear",
         .label = "trilinear",
         .lookup = &lookup_of(Interpolation::trilinear),
         .storage = floats},
        {.name = "tetrahedral", .label = "tetrahedral", .lookup = &tetrahedral, .storage = floats},
        {.name = "tricubic", .label = "tricubic", .storage = floats},
        {.name = "8", .label = "tetrahedral, 8 bits", .lookup = &tetrahedral, .storage = kept("8")},
        {.name = "10",
         .label = "tetrahedral, 10 bits",
         .lookup = &tetrahedral,
         .storage = kept("10")},
        {.name = "16",
         .label = "tetrahedral, 16 bits",
         .lookup = &tetrahedral,
         .storage = kept("16")},
        {.name = "shaper",
         .label = "tetrahedral behind a shaper",
         .lookup = &tetrahedral,
         .storage = floats,
         .shaper = true},
        {.name = "fitted",
         .label = "tetrahedral, fitted",
         .lookup = &tetrahedral,
         .storage = floats,
         .fitted = true},
    };
}

// A lattice over 0..1 with or without a shaper before it.
Lut lattice_of(int size, bool shaper) {
    Lut out;
    out.cube = identity_cube(size);
    if (shaper) {
        out.shaper = Lut1D{{}, {}};
        for (int i = 0; i < shaper_entries; ++i) {
            const auto v =
                static_cast<float>(srgb_encode(static_cast<double>(i) / (shaper_entries - 1)));
            out.shaper->entries.push_back({v, v, v});
        }
    }
    return out;
}

// The inputs at the nodes of an axis, which is the same for each channel.
std::vector<double> node_inputs(const Lut& lattice) {
    const LatticeReader reader = reader_of(lattice, Interpolation::tetrahedral);
    std::vector<double> out;
    for (int i = 0; i < reader.size; ++i) {
        const double even = static_cast<double>(i) / (reader.size - 1);
        const bool end = i == 0 || i == reader.size - 1;
        out.push_back(end || !lattice.shaper ? even : reader.input_at(0, i));
    }
    return out;
}

// The nodes of a whole lattice, in double.
std::vector<RgbD> sampled(const StiffFunction& f, const std::vector<double>& at) {
    std::vector<RgbD> out;
    out.reserve(at.size() * at.size() * at.size());
    for (const double b : at) {
        for (const double g : at) {
            for (const double r : at) {
                out.push_back(f({r, g, b}));
            }
        }
    }
    return out;
}

double kept(double value, const Storage& storage) {
    if (storage.bits == 0) {
        return static_cast<double>(static_cast<float>(value));
    }
    return CodeDepth{storage.bits}.rounded(value);
}

RgbD kept(RgbD c, const Storage& storage) {
    return {kept(c.r, storage), kept(c.g, storage), kept(c.b, storage)};
}

// The cell of one input and what the function is at its corners: all that a lookup reads of a
// lattice, so that large lattices cost no more than small ones.
struct CellRead {
    RgbD place;
    std::array<int, 3> base{};
    std::array<RgbD, 8> corner;
    int size = 0;

    CellRead(const StiffFunction& f, const LatticeReader& reader, const std::vector<double>& at,
             Rgb in)
        : size(reader.size) {
        for (std::size_t c = 0; c < 3; ++c) {
            place[c] = reader.place(static_cast<double>(in[c]), c);
            base[c] = std::min(static_cast<int>(place[c]), size - 2);
        }
        const auto node = [&](std::size_t c, std::size_t bit) {
            return at[static_cast<std::size_t>(base[c]) + bit];
        };
        for (std::size_t i = 0; i < 8; ++i) {
            corner[i] = f({node(0, i & 1), node(1, i >> 1 & 1), node(2, i >> 2)});
        }
    }

    RgbD by(Interpolation how, const Storage& storage) const {
        const NodeWeights w = node_weights(how, size, place);
        RgbD sum;
        for (std::size_t k = 0; k < w.count; ++k) {
            const auto n = static_cast<std::size_t>(size);
            const std::size_t i = w.node[k];
            const auto bit = [&](std::size_t at, std::size_t c) {
                return at - static_cast<std::size_t>(base[c]);
            };
            const std::size_t index =
                bit(i % n, 0) | bit(i / n % n, 1) << 1 | bit(i / n / n, 2) << 2;
            sum = sum + w.weight[k] * kept(corner[index], storage);
        }
        return sum;
    }
};

// The colours of one phase and one size, and what the function makes of them.
struct Probe {
    std::vector<Rgb> inputs;
    std::vector<RgbD> expected;
    std::size_t even; // the first so many are spread evenly

    Probe(const StiffFunction& f, const std::vector<Rgb>& colors, double cell)
        : inputs(colors), even(colors.size()) {
        for (std::size_t i = 0; i < even; ++i) {
            // Within a cell on either side of the feature.
            const double aside = 2 * static_cast<double>(i) / static_cast<double>(even) - 1;
            const RgbD c = to_double(colors[i]);
            const double near = f.place + aside * cell;
            inputs.push_back(to_float(f.profile->of_color
                                          ? saturate(RgbD{f.place, f.place, f.place} +
                                                     2 * cell * (c - RgbD{0.5, 0.5, 0.5}))
                                          : f.with_argument(c, near)));
        }
        for (const Rgb in : inputs) {
            expected.push_back(f(to_double(in)));
        }
    }

    StiffFigures figures(const std::vector<RgbD>& got) const {
        std::vector<double> errors(got.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            errors[i] = largest_magnitude(got[i] - expected[i]);
        }
        const double largest = *std::max_element(errors.begin(), errors.end());
        errors.resize(even);
        const ErrorStats stats = error_stats(std::move(errors));
        return {stats.p99, stats.mean, largest};
    }
};

void add(StiffPoint& point, const StiffFigures& f, int phases) {
    const auto each = [&](double StiffFigures::*figure) {
        point.average.*figure += f.*figure / phases;
        point.worst.*figure = std::max(point.worst.*figure, f.*figure);
    };
    each(&StiffFigures::p99);
    each(&StiffFigures::mean);
    each(&StiffFigures::max);
}

// One function on the lattices of one size, by every method.
std::vector<StiffPoint> points_of(const StiffProfile& profile, StiffAxis axis, int size,
                                  const StiffSettings& settings, const std::vector<Rgb>& colors) {
    const double cell = 1.0 / (size - 1);
    const Lut plain = lattice_of(size, false), shaped = lattice_of(size, true);
    const std::vector<double> plain_at = node_inputs(plain), shaped_at = node_inputs(shaped);
    std::vector<StiffPoint> out(stiff_methods().size());
    const int every = std::max(1, settings.phases / settings.whole_phases);
    const LatticeReader plain_reader = reader_of(plain, Interpolation::tetrahedral),
                        shaped_reader = reader_of(shaped, Interpolation::tetrahedral);
    for (int phase = 0; phase < settings.phases; ++phase) {
        const StiffFunction f{&profile, axis, profile.place + cell * phase / settings.phases};
        const Probe probe(f, colors, cell);
        std::vector<CellRead> even, behind;
        for (const Rgb in : probe.inputs) {
            even.emplace_back(f, plain_reader, plain_at, in);
            behind.emplace_back(f, shaped_reader, shaped_at, in);
        }
        for (std::size_t i = 0; i < out.size(); ++i) {
            const StiffMethod& method = stiff_methods()[i];
            const bool whole = method.fitted || !method.lookup;
            const int largest = method.fitted ? settings.largest_fitted : settings.largest_tricubic;
            if (whole && (size > largest || phase % every != 0)) {
                continue;
            }
            std::vector<RgbD> got(probe.inputs.size());
            if (whole) {
                Lut3D cube = *plain.cube;
                std::vector<RgbD> nodes = sampled(f, plain_at);
                if (method.fitted) {
                    nodes = LatticeFit(Transform::each(f), plain_reader, nodes).exact().nodes;
                }
                std::transform(nodes.begin(), nodes.end(), cube.nodes.begin(), to_float);
                std::transform(probe.inputs.begin(), probe.inputs.end(), got.begin(), [&](Rgb in) {
                    return method.fitted
                               ? evaluate_exact(cube, to_double(in), Interpolation::tetrahedral)
                               : tricubic(cube, to_double(in));
                });
            } else {
                std::transform((method.shaper ? behind : even).begin(),
                               (method.shaper ? behind : even).end(), got.begin(),
                               [&](const CellRead& cell_read) {
                                   return cell_read.by(method.lookup->weights, *method.storage);
                               });
            }
            out[i].size = size;
            add(out[i], probe.figures(got),
                whole ? (settings.phases + every - 1) / every : settings.phases);
        }
        if (!profile.of_color && phase == 0) {
            const StiffBound bound(f);
            for (std::size_t i = 0; i < out.size(); ++i) {
                const StiffMethod& method = stiff_methods()[i];
                if (method.lookup && !method.shaper && !method.fitted) {
                    out[i].bound = method.lookup->weights == Interpolation::nearest
                                       ? bound.of_nearest(cell)
                                       : bound.of_means(cell);
                }
            }
        }
    }
    return out;
}

struct Job {
    const StiffProfile* profile;
    StiffAxis axis;
    int size;
};

} // namespace

std::span<const StiffMethod> stiff_methods() {
    static const std::vector<StiffMethod> table = make_methods();
    return table;
}

StiffSurvey survey_stiff_suite(const StiffSettings& settings, const Progress& progress) {
    std::vector<Job> jobs;
    for (const StiffProfile& profile : stiff_profiles()) {
        for (const StiffAxis axis : {StiffAxis::channel, StiffAxis::mixed}) {
            for (const int size : settings.sizes) {
                if (!profile.of_color || axis == StiffAxis::channel) {
                    jobs.push_back({&profile, axis, size});
                }
            }
        }
    }
    const std::vector<Rgb> colors =
        sample_colors(2, {.neutral = 2, .random = settings.colors, .lattice = false});
    std::vector<std::vector<StiffPoint>> points(jobs.size());
    std::mutex one_at_a_time;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        points[i] = points_of(*jobs[i].profile, jobs[i].axis, jobs[i].size, settings, colors);
        const std::lock_guard lock(one_at_a_time);
        progress(static_cast<double>(++done) / static_cast<double>(jobs.size()),
                 std::string(jobs[i].profile->name));
    });
    StiffSurvey out{settings, {}};
    for (std::size_t first = 0; first < jobs.size(); first += settings.sizes.size()) {
        for (std::size_t m = 0; m < stiff_methods().size(); ++m) {
            StiffCurve curve{
                jobs[first].profile, jobs[first].axis, &stiff_methods()[m], {}, {}, {}};
            std::vector<std::pair<double, double>> largest, mean;
            for (std::size_t k = first; k < first + settings.sizes.size(); ++k) {
                const StiffPoint& point = points[k][m];
                if (point.size) {
                    curve.points.push_back(point);
                    const double cell = 1.0 / (point.size - 1);
                    largest.emplace_back(cell, point.worst.max);
                    mean.emplace_back(cell, point.average.mean);
                }
            }
            curve.largest = slope_of(largest, rounding);
            curve.mean = slope_of(mean, rounding);
            out.curves.push_back(std::move(curve));
        }
    }
    return out;
}

} // namespace lutlib
