#include "lutlib/bake/fitted.h"

#include "lutlib/bake/budget.h"
#include "lutlib/nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace lutlib {
namespace {

constexpr double step_of_8_bits = 1.0 / 255;

// Around a texel that differs from the new fit, the lookup may be worse than that fit's by a share
// of the error that is there anyway and one step of 8 bits.
constexpr double allowed_share_of_error = 0.25;
constexpr double allowed_excess = step_of_8_bits;
// Fits that differ by rounding alone exceed that in a few texels of a large lattice (10 of 262,144,
// by 1.4 steps), so there it takes more of them, or more steps.
constexpr double share_of_few_texels = 1e-4;
constexpr double excess_of_few_texels = 4 * step_of_8_bits;
// The same fit from an oracle in float and from one in double differs in up to a quarter of the
// texels of 16 bits, by 8 codes, and of 8 bits in one of 150, mostly by one.
constexpr int same_code_in_8_bits = 1, same_code_in_16_bits = 16;
// The mean error of the picture may be this much of the new fit's.
constexpr double allowed_mean = 1.05;

std::string figure(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

// Inputs at the nodes and between them.
std::vector<float> axis_inputs(const Engine& engine, int size) {
    const int steps = size <= 33 ? 3 : 2;
    std::vector<float> out;
    for (int i = 0; i + 1 < size; ++i) {
        const double here = engine.node_input(i, size), next = engine.node_input(i + 1, size);
        for (int s = 0; s < steps; ++s) {
            out.push_back(static_cast<float>(here + (next - here) * s / steps));
        }
    }
    out.push_back(static_cast<float>(engine.node_input(size - 1, size)));
    return out;
}

// The largest error of the engine's lookup of a picture around each node.
std::vector<double> local_errors(const CodeImage& codes, const Engine& engine, int size,
                                 const Transform& look) {
    const Picture picture = decoded(codes);
    const std::vector<float> axis = axis_inputs(engine, size);
    const auto n = static_cast<std::size_t>(size);
    std::vector<double> out(n * n * n);
    const auto place = [&](float in) { return engine.place(static_cast<double>(in), size); };
    for (const float blue : axis) {
        std::vector<Rgb> inputs;
        for (const float green : axis) {
            for (const float red : axis) {
                inputs.push_back({red, green, blue});
            }
        }
        const std::vector<RgbD> expected = images_of(look, inputs);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const Rgb in = inputs[i];
            const double error = largest_magnitude(to_double(engine.lookup(picture, size, in)) -
                                                   saturate(expected[i]));
            const NodeWeights w =
                node_weights(engine.interpolation, size, {place(in.r), place(in.g), place(in.b)});
            for (std::size_t k = 0; k < w.count; ++k) {
                out[w.node[k]] = std::max(out[w.node[k]], error);
            }
        }
    }
    return out;
}

// A picture beside a fit made anew: how far apart the two are at each node, and how large the
// lookup's errors are around it.
struct Measured {
    std::vector<Pixel> pixel;
    std::vector<int> distance;         ///< in codes, of the channel furthest apart
    int same = 0;                      ///< the distance that rounding explains
    std::vector<double> found, fitted; ///< errors; empty where no texel has moved

    bool is_moved(std::size_t node) const { return distance[node] > same; }
    double excess(std::size_t node) const {
        return found[node] - (1 + allowed_share_of_error) * fitted[node];
    }
};

Measured measured(const CodeImage& picture, const CodeImage& refit, const Engine& engine, int size,
                  const Transform& look) {
    const Layout& layout = *layout_named(engine.layout);
    Measured out;
    out.same = picture.depth.bits == 8 ? same_code_in_8_bits : same_code_in_16_bits;
    bool any_moved = false;
    for_each_node(size, [&](int r, int g, int b) {
        const Pixel p = layout.pixel(size, picture.width, r, g, b);
        int furthest = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            furthest = std::max(furthest, std::abs(picture.at(p, c) - int{refit.at(p, c)}));
        }
        out.pixel.push_back(p);
        out.distance.push_back(furthest);
        any_moved = any_moved || furthest > out.same;
    });
    if (any_moved) {
        out.found = local_errors(picture, engine, size, look);
        out.fitted = local_errors(refit, engine, size, look);
    }
    return out;
}

// Texels that are not the new fit's and make the lookup worse.
struct Harm {
    std::size_t texels = 0;
    double most_excess = 0;
    std::size_t worst = 0; ///< the damaged texel itself, before its neighbours: the furthest off
};

// None where rounding explains what there is.
std::optional<Harm> judged(const Measured& m) {
    Harm out;
    int furthest = 0;
    for (std::size_t i = 0; i < m.found.size(); ++i) {
        if (!m.is_moved(i) || m.excess(i) <= allowed_excess) {
            continue;
        }
        ++out.texels;
        out.most_excess = std::max(out.most_excess, m.excess(i));
        if (m.distance[i] > furthest) {
            furthest = m.distance[i];
            out.worst = i;
        }
    }
    const bool is_few = static_cast<double>(out.texels) <=
                        share_of_few_texels * static_cast<double>(m.pixel.size());
    const bool is_rounding = is_few && out.most_excess <= excess_of_few_texels;
    return out.texels == 0 || is_rounding ? std::nullopt : std::optional(out);
}

std::string sentence(const Harm& harm, const Measured& m) {
    const Pixel p = m.pixel[harm.worst];
    return std::to_string(harm.texels) + " of " + std::to_string(m.pixel.size()) +
           " texels are not what the fit gives, and the lookup is worse for it; the furthest at " +
           std::to_string(p.x) + "," + std::to_string(p.y) + " is off by " +
           std::to_string(m.distance[harm.worst]) + " codes, with errors of up to " +
           figure(m.found[harm.worst]) + " around it where the fit has " +
           figure(m.fitted[harm.worst]);
}

} // namespace

FittedCheck check_fitted(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look, const FitView& view) {
    const FilledBake anew = bake_fitted(look, engine, size, picture.depth.bits, view);
    const CodeImage& refit = anew.bake.picture;
    const auto measured_of = [&](const CodeImage& codes) {
        return measure_lookup(codes, engine, size, look, view.breaks, view.viewing);
    };
    FittedCheck out;
    out.refit = anew.result ? *anew.result : measured_of(refit);
    out.point_sampled = anew.point_sampled ? *anew.point_sampled : out.refit;
    out.result = picture.samples == refit.samples ? out.refit : measured_of(picture);

    const Measured m = measured(picture, refit, engine, size, look);
    out.texels = m.pixel.size();
    for (std::size_t i = 0; i < out.texels; ++i) {
        out.moved += m.is_moved(i);
    }
    if (const std::optional<Harm> harm = judged(m)) {
        out.faults.push_back(sentence(*harm, m));
    }
    const double mean = out.result.absolute.mean, right = out.refit.absolute.mean;
    if (mean > allowed_mean * right) {
        out.faults.push_back("the lookup's mean error is " + figure(mean) +
                             ", that of a fit made anew " + figure(right));
    }
    return out;
}

} // namespace lutlib
