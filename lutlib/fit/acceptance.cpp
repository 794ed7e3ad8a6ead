#include "lutlib/fit/acceptance.h"

#include "lutlib/fit/samples.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

// A fit must be better by more than the noise of the colours it is checked on.
constexpr double least_gain = 0.01;

constexpr int finest_lattice = 33;

// Thirty in each cell of a small lattice; of more than 16 nodes, fewer.
int validation_colours(int size) {
    const int cells = (size - 1) * (size - 1) * (size - 1);
    return std::clamp(30 * cells, 2000, 100000);
}

std::vector<RgbD> colours_over(const Domain& domain, int lattice_size, const SampleCounts& counts) {
    std::vector<RgbD> out;
    for (const Rgb& c : sample_colors(lattice_size, counts)) {
        RgbD in;
        for (std::size_t i = 0; i < 3; ++i) {
            in[i] = std::lerp(static_cast<double>(domain.min[i]),
                              static_cast<double>(domain.max[i]), static_cast<double>(c[i]));
        }
        out.push_back(in);
    }
    return out;
}

} // namespace

bool within_unit(const std::vector<RgbD>& colours) {
    return std::all_of(colours.begin(), colours.end(), [](RgbD c) { return saturate(c) == c; });
}

ValidationSet::ValidationSet(const Transform& look, const LatticeReader& reader,
                             const SampleCounts& counts) {
    std::vector<RgbD> inputs =
        colours_over(reader.domain, std::min(reader.size, finest_lattice), counts);
    weights_.resize(inputs.size());
    std::transform(inputs.begin(), inputs.end(), weights_.begin(),
                   [&](RgbD in) { return reader.weights(in); });
    targets_ = mapped(look, std::move(inputs));
}

std::vector<double> ValidationSet::errors(const std::vector<RgbD>& nodes, bool held) const {
    std::vector<double> out(targets_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.size(), 1024), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const NodeWeights& w = weights_[i];
            RgbD sum;
            for (std::size_t k = 0; k < w.count; ++k) {
                sum = sum + w.weight[k] * nodes[w.node[k]];
            }
            out[i] =
                largest_magnitude(held ? saturate(sum) - saturate(targets_[i]) : sum - targets_[i]);
        }
    });
    return out;
}

Acceptance::Acceptance(const Transform& look, const LatticeReader& reader)
    : repair_set_(look, reader, {.random = validation_colours(reader.size)}),
      validation_set_(look, reader,
                      {.neutral = 997,
                       .random = validation_colours(reader.size),
                       .lattice = true,
                       .skipped = validation_colours(reader.size)}) {}

bool Acceptance::within_unit() const {
    return lutlib::within_unit(validation_set_.targets());
}

// Gives nodes back their plain values wherever a colour of the repair set is beyond the cap.
void Acceptance::repair(std::vector<RgbD>& nodes, const std::vector<RgbD>& plain, bool held,
                        double cap) const {
    for (bool changed = true; changed;) {
        changed = false;
        const std::vector<double> now = repair_set_.errors(nodes, held);
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (now[i] <= cap) {
                continue;
            }
            const NodeWeights& w = repair_set_.weights(i);
            for (std::size_t k = 0; k < w.count; ++k) {
                changed = changed || !(nodes[w.node[k]] == plain[w.node[k]]);
                nodes[w.node[k]] = plain[w.node[k]];
            }
        }
    }
}

FittedLattice Acceptance::accepted(std::vector<RgbD> candidate, const std::vector<RgbD>& plain,
                                   bool held) const {
    FittedLattice out;
    out.point_sampled = out.result = error_stats(validation_set_.errors(plain, held));
    const std::vector<double> before = repair_set_.errors(plain, held);
    const double worst = *std::max_element(before.begin(), before.end());
    for (const double tightness : {1.0, 0.95, 0.9, 0.8}) {
        repair(candidate, plain, held, tightness * worst);
        const ErrorStats stats = error_stats(validation_set_.errors(candidate, held));
        if (stats.max <= out.point_sampled.max) {
            out.fitted = stats.mean < (1 - least_gain) * out.point_sampled.mean;
            out.result = out.fitted ? stats : out.point_sampled;
            break;
        }
    }
    out.nodes = out.fitted ? std::move(candidate) : plain;
    return out;
}

} // namespace lutlib
