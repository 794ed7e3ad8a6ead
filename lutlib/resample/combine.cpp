#include "lutlib/resample/combine.h"

#include "lutlib/error.h"
#include "lutlib/metrics/compare.h"

#include <algorithm>
#include <array>

namespace lutlib {
namespace {

std::vector<Transform> steps_of(const std::vector<const Lut*>& looks,
                                const ResamplingMethod& method) {
    std::vector<Transform> steps;
    for (const Lut* look : looks) {
        steps.push_back(method.transform_of(*look));
    }
    return steps;
}

std::optional<int> largest_size(const std::vector<const Lut*>& looks) {
    std::optional<int> largest;
    for (const Lut* look : looks) {
        if (look->cube) {
            largest = std::max(largest.value_or(0), look->cube->size);
        }
    }
    return largest;
}

bool inside(const Domain& domain, RgbD colour) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (colour[c] < static_cast<double>(domain.min[c]) ||
            colour[c] > static_cast<double>(domain.max[c])) {
            return false;
        }
    }
    return true;
}

} // namespace

Transform composition(const std::vector<const Lut*>& looks, const ResamplingMethod& method) {
    return in_sequence(steps_of(looks, method));
}

Lut compose(const std::vector<const Lut*>& looks, const Sampling& sampling,
            const ResamplingMethod& method) {
    if (looks.empty()) {
        throw Error("there is nothing to compose");
    }
    Sampling chosen = sampling;
    chosen.size = sampling.size ? sampling.size : largest_size(looks);
    // What follows the first look's 1D table: its cube, then the other looks.
    Lut first_cube;
    first_cube.cube = looks.front()->cube;
    first_cube.interpolation = looks.front()->interpolation;
    std::vector<const Lut*> after = looks;
    after.front() = &first_cube;
    return sample_like(*looks.front(), chosen, composition(looks, method),
                       composition(after, method));
}

double clamped_share(const std::vector<const Lut*>& looks, const ResamplingMethod& method) {
    constexpr int lattice = 17, random = 20000;
    const std::vector<Rgb> inputs = samples_over(looks.front()->domain(), lattice, random);
    const std::vector<Transform> steps = steps_of(looks, method);
    std::size_t clamped = 0;
    for (const Rgb& input : inputs) {
        RgbD colour = to_double(input);
        for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
            colour = steps[i](colour);
            if (!inside(looks[i + 1]->domain(), colour)) {
                ++clamped;
                break;
            }
        }
    }
    return static_cast<double>(clamped) / static_cast<double>(inputs.size());
}

Transform mixture(const Lut& a, const Lut& b, double amount, const ResamplingMethod& method) {
    return Transform::batch([first = method.transform_of(a), second = method.transform_of(b),
                             amount](std::span<RgbD> colours) {
        std::array<RgbD, 256> other;
        for (std::size_t i = 0; i < colours.size(); i += other.size()) {
            const auto part = colours.subspan(i, std::min(other.size(), colours.size() - i));
            std::copy(part.begin(), part.end(), other.begin());
            first(part);
            second(std::span(other).first(part.size()));
            for (std::size_t k = 0; k < part.size(); ++k) {
                part[k] = part[k] * (1 - amount) + other[k] * amount;
            }
        }
    });
}

Lut blend(const Lut& a, const Lut& b, double amount, const Sampling& sampling,
          const ResamplingMethod& method) {
    Sampling chosen = sampling;
    chosen.size = sampling.size ? sampling.size : largest_size({&a, &b});
    const bool same_table =
        a.shaper == b.shaper && (!a.cube || !b.cube || a.cube->domain == b.cube->domain);
    Lut like;
    like.title = a.title;
    if (same_table) {
        like = a;
    }
    if (!same_table && !chosen.domain) {
        Domain both = a.domain();
        for (std::size_t c = 0; c < 3; ++c) {
            both.min[c] = std::min(both.min[c], b.domain().min[c]);
            both.max[c] = std::max(both.max[c], b.domain().max[c]);
        }
        chosen.domain = both;
    }
    Lut cube_a, cube_b;
    cube_a.cube = a.cube;
    cube_b.cube = b.cube;
    cube_a.interpolation = a.interpolation;
    cube_b.interpolation = b.interpolation;
    return sample_like(like, chosen, mixture(a, b, amount, method),
                       mixture(cube_a, cube_b, amount, method));
}

} // namespace lutlib
