#include "lutlib/fit/fit_round.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace lutlib {
namespace {

constexpr int most_sweeps = 12;
// Of the error beyond the largest that plain rounding makes.
constexpr float price_of_excess = 50;
// The mean is of the largest channel; the others keep a small say, or nothing would hold them.
constexpr float say_of_all_channels = 0.2F;

// For each node the samples that read it: the transpose of FitSamples.
struct Readers {
    std::vector<int> first, sample;
    std::vector<float> weight;

    Readers(const FitSamples& s, std::size_t nodes)
        : first(nodes + 1), sample(s.node.size()), weight(s.node.size()) {
        for (const int node : s.node) {
            ++first[static_cast<std::size_t>(node) + 1];
        }
        for (std::size_t k = 0; k < nodes; ++k) {
            first[k + 1] += first[k];
        }
        std::vector<int> next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i + 1 < s.first.size(); ++i) {
            for (auto k = static_cast<std::size_t>(s.first[i]);
                 k < static_cast<std::size_t>(s.first[i + 1]); ++k) {
                const auto at =
                    static_cast<std::size_t>(next[static_cast<std::size_t>(s.node[k])]++);
                sample[at] = static_cast<int>(i);
                weight[at] = s.weight[k];
            }
        }
    }
};

struct Price {
    float cap;

    float operator()(const Rgb& error) const {
        const float r = std::abs(error.r), g = std::abs(error.g), b = std::abs(error.b);
        const float e = std::max(std::max(r, g), b);
        return e + say_of_all_channels * (r + g + b) + price_of_excess * std::max(0.0F, e - cap);
    }
};

} // namespace

std::vector<RgbD> rounded_to_codes(std::vector<RgbD> nodes, CodeDepth depth) {
    for (RgbD& node : nodes) {
        for (std::size_t c = 0; c < 3; ++c) {
            node[c] = depth.value(depth.code(node[c]));
        }
    }
    return nodes;
}

std::vector<RgbD> descended(const FitSamples& samples, std::vector<RgbD> nodes,
                            const std::vector<RgbD>& plain, const std::vector<bool>& fixed,
                            int size, CodeDepth depth) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        nodes[k] = fixed[k] ? plain[k] : nodes[k];
    }
    const std::size_t count = samples.target.size();
    std::vector<Rgb> error(count);
    double cap = 0;
    for (std::size_t s = 0; s < count; ++s) {
        const RgbD target = saturate(samples.target[s]);
        const RgbD d = samples.read(plain, s) - target;
        cap = std::max(cap, largest_magnitude(d));
        error[s] = to_float(samples.read(nodes, s) - target);
    }
    const Price price{static_cast<float>(cap)};
    std::vector<float> paid(count); // each sample's price as it stands
    std::transform(error.begin(), error.end(), paid.begin(), price);
    const Readers readers(samples, nodes.size());
    const double step = depth.value(1);
    const auto n = static_cast<std::size_t>(size);

    // Lowers what the node costs; true when it moved.
    const auto improve = [&](std::size_t node) {
        bool moved = false;
        const auto begin = static_cast<std::size_t>(readers.first[node]);
        const auto end = static_cast<std::size_t>(readers.first[node + 1]);
        for (std::size_t c = 0; c < 3; ++c) {
            for (const double direction : {step, -step}) {
                const double value = nodes[node][c] + direction;
                if (value < -step / 2 || value > 1 + step / 2) {
                    continue;
                }
                const auto by = static_cast<float>(direction);
                float gain = 0;
                for (std::size_t k = begin; k < end; ++k) {
                    const auto s = static_cast<std::size_t>(readers.sample[k]);
                    Rgb after = error[s];
                    after[c] += by * readers.weight[k];
                    gain += samples.share[s] * (paid[s] - price(after));
                }
                if (gain > 0) {
                    nodes[node][c] = depth.value(depth.code(value));
                    for (std::size_t k = begin; k < end; ++k) {
                        const auto s = static_cast<std::size_t>(readers.sample[k]);
                        error[s][c] += by * readers.weight[k];
                        paid[s] = price(error[s]);
                    }
                    moved = true;
                    break;
                }
            }
        }
        return moved;
    };

    // A node that found nothing to gain need not look again until a neighbour has moved.
    std::vector<std::atomic<bool>> settled(nodes.size());
    const auto unsettle_around = [&](std::size_t r, std::size_t g, std::size_t b) {
        for (std::size_t k = b > 0 ? b - 1 : 0; k <= std::min(b + 1, n - 1); ++k) {
            for (std::size_t j = g > 0 ? g - 1 : 0; j <= std::min(g + 1, n - 1); ++j) {
                for (std::size_t i = r > 0 ? r - 1 : 0; i <= std::min(r + 1, n - 1); ++i) {
                    settled[i + n * (j + n * k)].store(false, std::memory_order_relaxed);
                }
            }
        }
    };
    // Nodes two apart on an axis share no sample, so each of the eight parities goes in parallel.
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        std::atomic<bool> any = false;
        for (std::size_t parity = 0; parity < 8; ++parity) {
            const std::size_t r0 = parity & 1, g0 = parity >> 1 & 1, b0 = parity >> 2;
            tbb::parallel_for(std::size_t{0}, (n - b0 + 1) / 2, [&](std::size_t slice) {
                const std::size_t b = b0 + 2 * slice;
                for (std::size_t g = g0; g < n; g += 2) {
                    for (std::size_t r = r0; r < n; r += 2) {
                        const std::size_t node = r + n * (g + n * b);
                        if (fixed[node] || settled[node].load(std::memory_order_relaxed)) {
                            continue;
                        }
                        if (improve(node)) {
                            unsettle_around(r, g, b);
                            any = true;
                        } else {
                            settled[node].store(true, std::memory_order_relaxed);
                        }
                    }
                }
            });
        }
        if (!any) {
            break;
        }
    }
    return nodes;
}

} // namespace lutlib
