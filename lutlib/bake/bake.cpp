#include "lutlib/bake/bake.h"

#include "lutlib/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lutlib {
namespace {

// "8 or 16", "16 to 65".
std::string listed(std::span<const int> values) {
    const auto count = static_cast<std::ptrdiff_t>(values.size());
    if (count > 3 && values.back() - values.front() == count - 1) {
        return std::to_string(values.front()) + " to " + std::to_string(values.back());
    }
    std::string out;
    for (const int value : values) {
        out += (out.empty() ? "" : " or ") + std::to_string(value);
    }
    return out;
}

bool contains(std::span<const int> values, int value) {
    return std::find(values.begin(), values.end(), value) != values.end();
}

} // namespace

void check_contract(const Engine& engine, int size, int bits) {
    check_cube_size(size);
    const std::string name(engine.name);
    if (!engine.sizes.empty() && !contains(engine.sizes, size)) {
        throw UsageError(name + " takes a lattice of size " + listed(engine.sizes) + ", not " +
                         std::to_string(size));
    }
    if (!contains(engine.bits, bits)) {
        throw UsageError(name + " takes " + listed(engine.bits) + " bits a sample, not " +
                         std::to_string(bits));
    }
    const Layout& layout = *layout_named(engine.layout);
    if (!layout.picture(size)) {
        throw UsageError(name + " lays a lattice out as " + std::string(layout.name) +
                         ", which has pictures for " + std::string(layout.sizes) + ", not for " +
                         std::to_string(size));
    }
}

Bake lay_out(const std::vector<RgbD>& nodes, const Engine& engine, int size, int bits) {
    check_contract(engine, size, bits);
    const Layout& layout = *layout_named(engine.layout);
    const PictureSize extent = *layout.picture(size);
    Bake out{&engine, size, {}, {}};
    out.picture.width = extent.width;
    out.picture.height = extent.height;
    out.picture.depth = {bits};
    out.picture.samples.resize(static_cast<std::size_t>(extent.width) *
                               static_cast<std::size_t>(extent.height) * 3);
    const CodeDepth depth = out.picture.depth;
    double sum = 0;
    auto node = nodes.begin();
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r, ++node) {
                const Pixel p = layout.pixel(size, extent.width, r, g, b);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double value = (*node)[c];
                    const double held = saturate(value);
                    if (!(held == value)) {
                        ++out.loss.clamped_values;
                        out.loss.most_clamped =
                            std::max(out.loss.most_clamped, std::abs(value - held));
                    }
                    const std::uint16_t code = depth.code(held);
                    const double rounding = std::abs(depth.value(code) - held);
                    out.loss.max_rounding = std::max(out.loss.max_rounding, rounding);
                    sum += rounding;
                    out.picture.at(p, c) = code;
                }
            }
        }
    }
    out.loss.mean_rounding = sum / (3.0 * size * size * size);
    return out;
}

Bake bake(const Transform& look, const Engine& engine, int size, int bits) {
    check_contract(engine, size, bits);
    std::vector<double> input;
    for (int i = 0; i < size; ++i) {
        input.push_back(engine.node_input(i, size));
    }
    std::vector<RgbD> nodes;
    nodes.reserve(input.size() * input.size() * input.size());
    for (const double b : input) {
        for (const double g : input) {
            for (const double r : input) {
                nodes.push_back({r, g, b});
            }
        }
    }
    apply_in_parallel(look, nodes);
    return lay_out(nodes, engine, size, bits);
}

Picture decoded(const CodeImage& codes) {
    Picture out{codes.width, codes.height, std::vector<Rgb>(codes.samples.size() / 3)};
    const CodeDepth depth = codes.depth;
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<float>(depth.value(codes.samples[3 * i + c]));
        }
    }
    return out;
}

Transform read_by(const Engine& engine, Picture picture, int size) {
    return Transform::each([&engine, size, picture = std::move(picture)](RgbD c) {
        return to_double(engine.lookup(picture, size, to_float(c)));
    });
}

Transform held_to_codes(const Transform& look) {
    return in_sequence({look, Transform::each([](RgbD c) { return saturate(c); })});
}

Difference measure_lookup(const CodeImage& codes, const Engine& engine, int size,
                          const Transform& look, const Breaks& breaks, const Viewing& viewing,
                          const SampleLimits& limits) {
    const ErrorSamples samples =
        error_samples({}, united(breaks, breaks_of(reader_of(engine, size))), limits);
    return measure(held_to_codes(look), read_by(engine, decoded(codes), size), samples, viewing);
}

} // namespace lutlib
