#include "lutlib/engine/fitted.h"

#include "lutlib/engine/budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace lutlib {
namespace {

// One step of 8 bits; a lookup may be worse than the new fit's by so much.
constexpr double one_code = 1.0 / 255;
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

// The largest error of the engine's lookup around each node.
struct LocalErrors {
    std::vector<double> picture, refit;

    LocalErrors(const CodePicture& codes, const CodePicture& fit, const Engine& engine, int size,
                const Oracle& oracle)
        : picture(nodes_of(size).size()), refit(picture.size()) {
        const Picture a = decoded(codes), b = decoded(fit);
        const std::vector<float> axis = axis_inputs(engine, size);
        for (const float blue : axis) {
            std::vector<Rgb> inputs;
            for (const float green : axis) {
                for (const float red : axis) {
                    inputs.push_back({red, green, blue});
                }
            }
            std::vector<Rgb> expected = inputs;
            oracle(expected);
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const RgbD right = saturate(to_double(expected[i]));
                const auto error = [&](const Picture& p) {
                    return largest_magnitude(to_double(engine.lookup(p, size, inputs[i])) - right);
                };
                const auto place = [&](float in) {
                    return engine.place(static_cast<double>(in), size);
                };
                const NodeWeights w =
                    node_weights(engine.interpolation, size,
                                 {place(inputs[i].r), place(inputs[i].g), place(inputs[i].b)});
                const double of_picture = error(a), of_refit = error(b);
                for (std::size_t k = 0; k < w.count; ++k) {
                    picture[w.node[k]] = std::max(picture[w.node[k]], of_picture);
                    refit[w.node[k]] = std::max(refit[w.node[k]], of_refit);
                }
            }
        }
    }
};

} // namespace

FittedCheck check_fitted(const CodePicture& picture, const Engine& engine, int size,
                         const Oracle& oracle, const std::vector<Rgb>& inputs) {
    const ExactLook look = [&oracle](RgbD in) {
        std::vector<Rgb> one{to_float(in)};
        oracle(one);
        return to_double(one.front());
    };
    const CodePicture refit = bake_fitted(look, engine, size, picture.bits).bake.picture;
    std::vector<Rgb> expected = inputs;
    oracle(expected);
    const auto error_of = [&](const CodePicture& codes) {
        return lookup_error(engine, decoded(codes), size, inputs, expected);
    };
    FittedCheck out;
    out.result = error_of(picture);
    out.refit = error_of(refit);
    out.point_sampled = error_of(bake(look, engine, size, picture.bits).picture);

    const Layout& layout = *layout_named(engine.layout);
    const int same = picture.bits == 8 ? same_in_8_bits : same_in_16_bits;
    const std::vector<Node> nodes = nodes_of(size);
    std::vector<int> distance(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Pixel p = layout.pixel(size, nodes[i].r, nodes[i].g, nodes[i].b);
        for (std::size_t c = 0; c < 3; ++c) {
            distance[i] =
                std::max(distance[i], std::abs(picture.code(p, c) - int{refit.code(p, c)}));
        }
        out.moved += distance[i] > same;
    }
    out.texels = nodes.size();
    if (out.moved > 0) {
        const LocalErrors local(picture, refit, engine, size, oracle);
        std::size_t harmful = 0, worst = 0;
        int most = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double excess = local.picture[i] - local.refit[i];
            if (distance[i] > same && excess > one_code) {
                ++harmful;
                // The damaged texel itself, before its neighbours.
                if (distance[i] > most) {
                    most = distance[i];
                    worst = i;
                }
            }
        }
        if (harmful > 0) {
            const Pixel p = layout.pixel(size, nodes[worst].r, nodes[worst].g, nodes[worst].b);
            out.faults.push_back(
                std::to_string(harmful) + " of " + std::to_string(out.texels) +
                " texels are not what the fit gives, and the lookup is worse for it; the furthest "
                "at " +
                std::to_string(p.x) + "," + std::to_string(p.y) + " is off by " +
                std::to_string(distance[worst]) + " codes, with errors of up to " +
                figure(local.picture[worst]) + " around it where the fit has " +
                figure(local.refit[worst]));
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
