#include "lutlib/resample/combine.h"

#include "lutlib/error.h"
#include "lutlib/metrics/error_samples.h"
#include "lutlib/resample/curves.h"
#include "lutlib/resample/sample_lut.h"

#include <algorithm>
#include <array>
#include <utility>

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

Lut curve_of(const std::vector<const Lut*>& looks, const Transform& transform, const Domain& domain,
             const Sampling& sampling) {
    int longest = 0;
    for (const Lut* look : looks) {
        longest = std::max(longest, look->shaper ? look->shaper->size() : 0);
    }
    const Domain over = sampling.domain.value_or(domain);
    Lut out;
    out.title = looks.front()->title;
    out.shaper = sampling.size ? sample_curve(transform, over, *sampling.size)
                               : sample_curve_closely(transform, over, longest, curve_tolerance);
    return out;
}

Domain united(Domain a, const Domain& b) {
    for (std::size_t c = 0; c < 3; ++c) {
        a.min[c] = std::min(a.min[c], b.min[c]);
        a.max[c] = std::max(a.max[c], b.max[c]);
    }
    return a;
}

/// A curve onto 0..1, to stand before a cube; nullopt where it does not rise strictly.
std::optional<Lut1D> rising_shaper(const Lut1D& curve) {
    Lut1D out = curve;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = curve.entries.front()[c], high = curve.entries.back()[c];
        for (Rgb& entry : out.entries) {
            entry[c] = static_cast<float>((static_cast<double>(entry[c]) - low) / (high - low));
        }
        const auto falls = [c](const Rgb& a, const Rgb& b) { return !(a[c] < b[c]); };
        if (std::adjacent_find(out.entries.begin(), out.entries.end(), falls) !=
            out.entries.end()) {
            return std::nullopt;
        }
    }
    return out;
}

/// The 1D table that the cube of a blend should stand behind: of the look that is nothing but one,
/// where it spans both.
std::optional<Lut1D> shaper_of_mixture(const Lut& a, const Lut& b, const Domain& domain) {
    for (const auto& [curve, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        if (curve->shaper && is_curves(*curve) && other->cube && curve->shaper->domain == domain) {
            return rising_shaper(*curve->shaper);
        }
    }
    return std::nullopt;
}

bool inside(const Domain& domain, RgbD color) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (color[c] < static_cast<double>(domain.min[c]) ||
            color[c] > static_cast<double>(domain.max[c])) {
            return false;
        }
    }
    return true;
}

} // namespace

bool make_curve(const std::vector<const Lut*>& looks, const Sampling& sampling) {
    return sampling.shaper.empty() &&
           std::all_of(looks.begin(), looks.end(),
                       [](const Lut* look) { return is_curves(*look); }) &&
           std::any_of(looks.begin(), looks.end(),
                       [](const Lut* look) { return look->shaper.has_value(); });
}

Transform composition(const std::vector<const Lut*>& looks, const ResamplingMethod& method) {
    return in_sequence(steps_of(looks, method));
}

namespace {

Lut composed(const std::vector<const Lut*>& looks, const Sampling& sampling,
             const ResamplingMethod& method) {
    if (make_curve(looks, sampling)) {
        return curve_of(looks, composition(looks, method), looks.front()->domain(), sampling);
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

} // namespace

Lut compose(const std::vector<const Lut*>& looks, const Sampling& sampling,
            const ResamplingMethod& method) {
    if (looks.empty()) {
        throw Error("there is nothing to compose");
    }
    Lut out = composed(looks, sampling, method);
    out.encodings = {looks.front()->encodings.input, looks.back()->encodings.output};
    return out;
}

double clamped_share(const std::vector<const Lut*>& looks, const ResamplingMethod& method) {
    const std::vector<Rgb> inputs = even_samples(looks.front()->domain());
    const std::vector<Transform> steps = steps_of(looks, method);
    std::size_t clamped = 0;
    for (const Rgb& input : inputs) {
        RgbD color = to_double(input);
        for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
            color = steps[i](color);
            if (!inside(looks[i + 1]->domain(), color)) {
                ++clamped;
                break;
            }
        }
    }
    return static_cast<double>(clamped) / static_cast<double>(inputs.size());
}

Transform mixture(const Lut& a, const Lut& b, double amount, const ResamplingMethod& method) {
    return Transform::batch([first = method.transform_of(a), second = method.transform_of(b),
                             amount](std::span<RgbD> colors) {
        std::array<RgbD, 256> other;
        for (std::size_t i = 0; i < colors.size(); i += other.size()) {
            const auto part = colors.subspan(i, std::min(other.size(), colors.size() - i));
            std::copy(part.begin(), part.end(), other.begin());
            first(part);
            second(std::span(other).first(part.size()));
            for (std::size_t k = 0; k < part.size(); ++k) {
                part[k] = part[k] * (1 - amount) + other[k] * amount;
            }
        }
    });
}

namespace {

Lut blended(const Lut& a, const Lut& b, double amount, const Sampling& sampling,
            const ResamplingMethod& method) {
    const Domain both = united(a.domain(), b.domain());
    if (make_curve({&a, &b}, sampling)) {
        return curve_of({&a, &b}, mixture(a, b, amount, method), both, sampling);
    }
    Sampling chosen = sampling;
    chosen.size = sampling.size ? sampling.size : largest_size({&a, &b});
    const bool same_table =
        a.shaper == b.shaper && (!a.cube || !b.cube || a.cube->domain == b.cube->domain);
    Lut like;
    like.title = a.title;
    if (same_table) {
        // The identity has neither size nor domain of its own.
        like = a.cube ? a : b;
        like.title = a.title;
    }
    if (!same_table && !chosen.domain) {
        const std::optional<Lut1D> shaper =
            chosen.shaper.empty() ? shaper_of_mixture(a, b, both) : std::nullopt;
        if (shaper) {
            Lut out;
            out.title = a.title;
            out.shaper = *shaper;
            out.cube = sample_cube_behind(mixture(a, b, amount, method), *shaper,
                                          chosen.size.value_or(usual_cube_size));
            return out;
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

} // namespace

Lut blend(const Lut& a, const Lut& b, double amount, const Sampling& sampling,
          const ResamplingMethod& method) {
    Lut out = blended(a, b, amount, sampling, method);
    const auto shared = [](const std::string& x, const std::string& y) {
        return x == y ? x : std::string();
    };
    out.encodings = {shared(a.encodings.input, b.encodings.input),
                     shared(a.encodings.output, b.encodings.output)};
    return out;
}

} // namespace lutlib
