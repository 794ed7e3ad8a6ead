#include "lutlib/fit/fit_round.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

constexpr int most_sweeps = 12;
// Of the error beyond the largest that plain rounding makes.
constexpr float price_of_excess = 50;
// The mean is of the largest channel; the others keep a small say, or nothing would hold them.
constexpr float say_of_all_channels = 0.2F;
// Black and white, a code error of 1, are 100 apart to the eye.
constexpr float seen_of_one = 100;
// What codes count beside the eye, so that their error does not grow.
constexpr float share_of_codes = 0.3F;

// For each node the samples that read it: the transpose of FitSamples.
struct Readers {
    std::vector<int> first, sample;
    std::vector<float> weight;

    // The entries of a node end where the next one's begin.
    std::size_t begin(std::size_t node) const { return static_cast<std::size_t>(first[node]); }

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
    float cap = 0, eye_cap = 0;

    float operator()(const Rgb& error, const EyeForm& form) const {
        const float seen = form.length(error);
        return (seen + price_of_excess * std::max(0.0F, seen - eye_cap)) / seen_of_one +
               share_of_codes * in_codes(error);
    }

  private:
    float in_codes(const Rgb& error) const {
        const float r = std::abs(error.r), g = std::abs(error.g), b = std::abs(error.b);
        const float e = std::max(std::max(r, g), b);
        return e + say_of_all_channels * (r + g + b) + price_of_excess * std::max(0.0F, e - cap);
    }
};

// Descends along one coordinate at a time: one channel of one node, by one code.
class CoordinateDescent {
  public:
    CoordinateDescent(const FitSamples& samples, std::vector<RgbD> nodes,
                      const std::vector<RgbD>& plain, const std::vector<bool>& fixed, int size,
                      CodeDepth depth)
        : samples_(samples), fixed_(fixed), readers_(samples, nodes.size()),
          size_(static_cast<std::size_t>(size)), depth_(depth), nodes_(std::move(nodes)),
          error_(samples.target.size()), paid_(samples.target.size()), settled_(nodes_.size()) {
        for (std::size_t k = 0; k < nodes_.size(); ++k) {
            nodes_[k] = fixed[k] ? plain[k] : nodes_[k];
        }
        double cap = 0;
        float eye_cap = 0;
        for (std::size_t s = 0; s < error_.size(); ++s) {
            const RgbD target = saturate(samples.target[s]);
            const RgbD off = samples.read(plain, s) - target;
            cap = std::max(cap, largest_magnitude(off));
            eye_cap = std::max(eye_cap, samples.form[s].length(to_float(off)));
            error_[s] = to_float(samples.read(nodes_, s) - target);
        }
        price_.cap = static_cast<float>(cap);
        price_.eye_cap = eye_cap;
        std::transform(error_.begin(), error_.end(), samples.form.begin(), paid_.begin(), price_);
    }

    // Until no node finds anything to gain, or for `most` sweeps.
    std::vector<RgbD> run(int most) {
        for (int i = 0; i < most && sweep(); ++i) {
        }
        return std::move(nodes_);
    }

  private:
    // One try at every node that may have something to gain; false when none moved. Nodes two apart
    // on an axis share no sample, so each of the eight parities goes in parallel.
    bool sweep() {
        std::atomic<bool> any = false;
        for (std::size_t parity = 0; parity < 8; ++parity) {
            const std::size_t r0 = parity & 1, g0 = parity >> 1 & 1, b0 = parity >> 2;
            tbb::parallel_for(std::size_t{0}, (size_ - b0 + 1) / 2, [&](std::size_t slice) {
                for (std::size_t g = g0; g < size_; g += 2) {
                    for (std::size_t r = r0; r < size_; r += 2) {
                        if (visit(r, g, b0 + 2 * slice)) {
                            any = true;
                        }
                    }
                }
            });
        }
        return any;
    }

    // A node that found nothing to gain need not look again until a neighbour has moved.
    bool visit(std::size_t r, std::size_t g, std::size_t b) {
        const std::size_t node = r + size_ * (g + size_ * b);
        if (fixed_[node] || settled_[node].load(std::memory_order_relaxed)) {
            return false;
        }
        bool moved = false;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            moved = step(node, channel, depth_.value(1)) || step(node, channel, -depth_.value(1)) ||
                    moved;
        }
        if (moved) {
            unsettle_around(r, g, b);
        } else {
            settled_[node].store(true, std::memory_order_relaxed);
        }
        return moved;
    }

    // Moves the node's channel if that lowers what its samples cost; true when it did.
    bool step(std::size_t node, std::size_t channel, double by) {
        const double value = nodes_[node][channel] + by, half_code = depth_.value(1) / 2;
        if (value < -half_code || value > 1 + half_code ||
            !(gain(node, channel, static_cast<float>(by)) > 0)) {
            return false;
        }
        nodes_[node][channel] = depth_.value(depth_.code(value));
        for (std::size_t k = readers_.begin(node); k < readers_.begin(node + 1); ++k) {
            const auto s = static_cast<std::size_t>(readers_.sample[k]);
            error_[s][channel] += static_cast<float>(by) * readers_.weight[k];
            paid_[s] = price_(error_[s], samples_.form[s]);
        }
        return true;
    }

    float gain(std::size_t node, std::size_t channel, float by) const {
        float out = 0;
        for (std::size_t k = readers_.begin(node); k < readers_.begin(node + 1); ++k) {
            const auto s = static_cast<std::size_t>(readers_.sample[k]);
            Rgb after = error_[s];
            after[channel] += by * readers_.weight[k];
            out += samples_.share[s] * (paid_[s] - price_(after, samples_.form[s]));
        }
        return out;
    }

    void unsettle_around(std::size_t r, std::size_t g, std::size_t b) {
        const auto first = [](std::size_t i) { return i > 0 ? i - 1 : 0; };
        const auto last = [this](std::size_t i) { return std::min(i + 1, size_ - 1); };
        for (std::size_t k = first(b); k <= last(b); ++k) {
            for (std::size_t j = first(g); j <= last(g); ++j) {
                for (std::size_t i = first(r); i <= last(r); ++i) {
                    settled_[i + size_ * (j + size_ * k)].store(false, std::memory_order_relaxed);
                }
            }
        }
    }

    const FitSamples& samples_;
    const std::vector<bool>& fixed_;
    const Readers readers_;
    const std::size_t size_;
    const CodeDepth depth_;
    Price price_{};
    std::vector<RgbD> nodes_;
    std::vector<Rgb> error_;  // of each sample, as the nodes stand
    std::vector<float> paid_; // its price
    std::vector<std::atomic<bool>> settled_;
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
    return CoordinateDescent(samples, std::move(nodes), plain, fixed, size, depth).run(most_sweeps);
}

} // namespace lutlib
