#include "lutlib/bake/fitted.h"

#include "lutlib/bake/budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lutlib {
namespace {

// Around a texel that differs from the new fit, the lookup may be worse than that fit's by a share
// of the error that is there anyway and one step of 8 bits. Fits that differ by rounding alone
// exceed that in a few texels of a large lattice (10 of 262,144, by 1.4 steps), so there it takes
// more of them, or more steps.
constexpr double one_code = 1.0 / 255;
constexpr double share_of_error = 0.25;
constexpr double few = 1e-4, many_codes = 4 * one_code;
// The same fit from an oracle in float and from one in double differs in up to a quarter of the
// texels of 16 bits, by 8 codes, and of 8 bits in one of 150, mostly by one.
constexpr int same_in_8_bits = 1, same_in_16_bits = 16;
constexpr double same_mean = 1.05;

struct Node {
    int r, g, b;
};

std::vector<Node> nodes_of(int size) {
    std::vector<Node> out;
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                out.push_back({r, g, b});
            }
        }
    }
    return out;
}

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
    std::vector<double> out(nodes_of(size).size());
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

} // namespace

FittedCheck check_fitted(const CodeImage& picture, const Engine& engine, int size,
                         const Transform& look, const std::vector<Rgb>& inputs) {
    const CodeImage refit = bake_fitted(look, engine, size, picture.depth.bits).bake.picture;
    const std::vector<RgbD> expected = images_of(look, inputs);
    const auto error_of = [&](const CodeImage& codes) {
        return lookup_error(engine, decoded(codes), size, inputs, expected);
    };
    FittedCheck out;
    out.result = error_of(picture);
    out.refit = error_of(refit);
    out.point_sampled = error_of(bake(look, engine, size, picture.depth.bits).picture);

    const Layout& layout = *layout_named(engine.layout);
    const int same = picture.depth.bits == 8 ? same_in_8_bits : same_in_16_bits;
    const std::vector<Node> nodes = nodes_of(size);
    std::vector<int> distance(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Pixel p = layout.pixel(size, nodes[i].r, nodes[i].g, nodes[i].b);
        for (std::size_t c = 0; c < 3; ++c) {
            distance[i] =
                std::max(distance[i], std::abs(picture.at(p, c) - int{refit.at(p, c)}));
        }
        out.moved += distance[i] > same;
    }
    out.texels = nodes.size();
    if (out.moved > 0) {
        const auto local = [&](const CodeImage& codes) {
            return local_errors(codes, engine, size, look);
        };
        const std::vector<double> found = local(picture), fitted = local(refit);
        std::size_t harmful = 0, worst = 0;
        double most_excess = 0;
        int most = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double excess = found[i] - (1 + share_of_error) * fitted[i];
            if (distance[i] > same && excess > one_code) {
                ++harmful;
                most_excess = std::max(most_excess, excess);
                // The damaged texel itself, before its neighbours.
                if (distance[i] > most) {
                    most = distance[i];
                    worst = i;
                }
            }
        }
        const bool is_few = static_cast<double>(harmful) <= few * static_cast<double>(out.texels);
        if (harmful > 0 && !(is_few && most_excess <= many_codes)) {
            const Pixel p = layout.pixel(size, nodes[worst].r, nodes[worst].g, nodes[worst].b);
            out.faults.push_back(
                std::to_string(harmful) + " of " + std::to_string(out.texels) +
                " texels are not what the fit gives, and the lookup is worse for it; the furthest "
                "at " +
                std::to_string(p.x) + "," + std::to_string(p.y) + " is off by " +
                std::to_string(distance[worst]) + " codes, with errors of up to " +
                figure(found[worst]) + " around it where the fit has " + figure(fitted[worst]));
        }
    }
    const double mean = out.result.absolute.mean, right = out.refit.absolute.mean;
    if (mean > same_mean * right) {
        out.faults.push_back("the lookup's mean error is " + figure(mean) +
                             ", that of a fit made anew " + figure(right));
    }
    return out;
}

} // namespace lutlib
