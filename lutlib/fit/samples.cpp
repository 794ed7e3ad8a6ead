#include "lutlib/fit/samples.h"

#include <array>
#include <cmath>

namespace lutlib {
namespace {

// More samples a cell where cells are few: 227,000 colours at 16 nodes, 275,000 at 33.
int samples_per_step(int size) {
    return size <= 17 ? 4 : size <= 25 ? 3 : 2;
}

// The samples of one channel: inputs, their places, and the share of the domain around each.
struct AxisSamples {
    std::vector<double> input, place, share;
};

// The input whose place is i / steps; the ends are the domain's own, which bisection only nears.
double input_of_step(const LatticeReader& reader, std::size_t channel, int i, int steps) {
    const int last = steps * (reader.size - 1);
    return i == 0      ? static_cast<double>(reader.domain.min[channel])
           : i == last ? static_cast<double>(reader.domain.max[channel])
                       : reader.input_at(channel, static_cast<double>(i) / steps);
}

AxisSamples axis_samples(const LatticeReader& reader, std::size_t channel) {
    const int steps = samples_per_step(reader.size);
    const double min = reader.domain.min[channel], max = reader.domain.max[channel];
    AxisSamples out;
    const int last = steps * (reader.size - 1);
    for (int i = 0; i <= last; ++i) {
        out.input.push_back(input_of_step(reader, channel, i, steps));
        out.place.push_back(reader.place(out.input.back(), channel));
    }
    for (int i = 0; i <= last; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double before = i > 0 ? out.input[k - 1] : min;
        const double after = i < last ? out.input[k + 1] : max;
        out.share.push_back((after - before) / (2 * (max - min)));
    }
    return out;
}

} // namespace

std::vector<RgbD> mapped(const Transform& look, std::vector<RgbD> colors) {
    apply_in_parallel(look, colors);
    for (RgbD& c : colors) {
        for (std::size_t i = 0; i < 3; ++i) {
            c[i] = std::isnan(c[i]) ? 0 : c[i];
        }
    }
    return colors;
}

FitSamples fit_samples(const Transform& look, const LatticeReader& reader, const Viewing& viewing) {
    const std::array<AxisSamples, 3> axis{axis_samples(reader, 0), axis_samples(reader, 1),
                                          axis_samples(reader, 2)};
    const std::size_t m = axis[0].input.size();
    FitSamples out;
    std::vector<RgbD> inputs;
    inputs.reserve(m * m * m);
    out.first.push_back(0);
    for (std::size_t b = 0; b < m; ++b) {
        for (std::size_t g = 0; g < m; ++g) {
            for (std::size_t r = 0; r < m; ++r) {
                inputs.push_back({axis[0].input[r], axis[1].input[g], axis[2].input[b]});
                const NodeWeights w =
                    node_weights(reader.how, reader.size,
                                 {axis[0].place[r], axis[1].place[g], axis[2].place[b]});
                for (std::size_t k = 0; k < w.count; ++k) {
                    out.node.push_back(static_cast<int>(w.node[k]));
                    out.weight.push_back(static_cast<float>(w.weight[k]));
                }
                out.first.push_back(static_cast<int>(out.node.size()));
                out.share.push_back(
                    static_cast<float>(axis[0].share[r] * axis[1].share[g] * axis[2].share[b]));
            }
        }
    }
    out.target = mapped(look, std::move(inputs));
    out.form = eye_forms(out.target, viewing);
    return out;
}

std::vector<RgbD> point_samples(const Transform& look, const LatticeReader& reader) {
    std::array<std::vector<double>, 3> axis;
    for (std::size_t c = 0; c < 3; ++c) {
        for (int i = 0; i < reader.size; ++i) {
            axis[c].push_back(input_of_step(reader, c, i, 1));
        }
    }
    std::vector<RgbD> nodes;
    for (const double b : axis[2]) {
        for (const double g : axis[1]) {
            for (const double r : axis[0]) {
                nodes.push_back({r, g, b});
            }
        }
    }
    return mapped(look, std::move(nodes));
}

} // namespace lutlib
