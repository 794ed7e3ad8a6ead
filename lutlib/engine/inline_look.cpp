#include "lutlib/engine/inline_look.h"

#include "lutlib/interpolation/interpolation.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::uint32_t most_code = (1U << inline_bits) - 1;

RgbD unpacked(const InlineLattice& lattice, std::uint32_t word) {
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t code = word >> (inline_bits * c) & most_code;
        out[c] = double{lattice.low[c]} + code * double{lattice.step[c]};
    }
    return out;
}

// NaN as the minimum.
RgbD held_to(const Domain& domain, RgbD color) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = domain.min[c], high = domain.max[c];
        color[c] = color[c] > low ? std::min(color[c], high) : low;
    }
    return color;
}

RgbD value_at(const InlineLattice& lattice, RgbD color) {
    RgbD place;
    for (std::size_t c = 0; c < 3; ++c) {
        const double low = lattice.domain.min[c], high = lattice.domain.max[c];
        place[c] = (color[c] - low) * ((lattice.size - 1) / (high - low));
    }
    const NodeWeights weights = node_weights(Interpolation::tetrahedral, lattice.size, place);
    RgbD out;
    for (std::size_t k = 0; k < weights.count; ++k) {
        out = out + weights.weight[k] * unpacked(lattice, lattice.nodes[weights.node[k]]);
    }
    return out;
}

double value_at(const InlineCurve& curve, double x) {
    const auto last = static_cast<double>(curve.entries.size() - 1);
    const double share = saturate((x - curve.low) / (double{curve.high} - curve.low));
    const double place = (curve.by_root ? std::sqrt(share) : share) * last;
    const auto i = static_cast<std::size_t>(std::min(std::floor(place), last - 1));
    return std::lerp(double{curve.entries[i]}, double{curve.entries[i + 1]},
                     place - static_cast<double>(i));
}

RgbD value_at(const InlineCurves& curves, RgbD color) {
    RgbD mixed = color;
    if (curves.mixes) {
        RgbD bent;
        for (std::size_t c = 0; c < 3; ++c) {
            bent[c] = value_at(curves.before[c], color[c]);
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const RgbD row = to_double(curves.matrix[c]);
            mixed[c] = row.r * bent.r + row.g * bent.g + row.b * bent.b;
        }
    }
    RgbD out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = value_at(curves.after[c], mixed[c]);
    }
    return out;
}

RgbD value_at(const InlineShaped& look, RgbD color) {
    RgbD shaped;
    for (std::size_t c = 0; c < 3; ++c) {
        shaped[c] = value_at(look.shaper[c], color[c]);
    }
    return value_at(look.lattice, held_to(look.lattice.domain, shaped));
}

} // namespace

InlineLattice inline_lattice(const Transform& look, const Domain& domain, int size) {
    const std::vector<RgbD> values = images_of(look, identity_cube(size, domain).nodes);
    InlineLattice out{domain, size, {}, {}, std::vector<std::uint32_t>(values.size())};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end(),
                                                     [c](RgbD a, RgbD b) { return a[c] < b[c]; });
        out.low[c] = static_cast<float>((*low)[c]);
        out.step[c] = static_cast<float>(((*high)[c] - (*low)[c]) / most_code);
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double code =
                out.step[c] > 0 ? (values[i][c] - out.low[c]) / double{out.step[c]} : 0;
            const double nearest = std::clamp(std::round(code), 0.0, double{most_code});
            out.nodes[i] |= static_cast<std::uint32_t>(nearest) << (inline_bits * c);
        }
    }
    return out;
}

InlineShaped inline_shaped(const Lut& table, Interpolation how, int size, int most_entries) {
    Lut shaper, cube;
    shaper.shaper = table.shaper;
    cube.cube = table.cube;
    cube.interpolation = how;
    const Domain& domain = table.shaper->domain;
    InlineShaped out{domain, {}, inline_lattice(Transform::of(cube), table.cube->domain, size)};
    const int entries = std::min(table.shaper->size(), most_entries);
    for (std::size_t c = 0; c < 3; ++c) {
        out.shaper[c] = {domain.min[c], domain.max[c], {}, false};
    }
    const Transform curve = Transform::of(shaper);
    for (int i = 0; i < entries; ++i) {
        RgbD at;
        for (std::size_t c = 0; c < 3; ++c) {
            at[c] = std::lerp(double{domain.min[c]}, double{domain.max[c]},
                              static_cast<double>(i) / (entries - 1));
        }
        const RgbD value = curve(at);
        for (std::size_t c = 0; c < 3; ++c) {
            out.shaper[c].entries.push_back(static_cast<float>(value[c]));
        }
    }
    return out;
}

Transform transform_of(const InlineLook& look) {
    return std::visit(
        [](const auto& form) {
            return Transform::each(
                [form](RgbD color) { return value_at(form, held_to(form.domain, color)); });
        },
        look);
}

std::string text_of(const InlineLook& look) {
    if (const auto* const lattice = std::get_if<InlineLattice>(&look)) {
        return std::to_string(lattice->size) + " nodes per axis, packed";
    }
    if (const auto* const shaped = std::get_if<InlineShaped>(&look)) {
        return "a shaper of " + std::to_string(shaped->shaper[0].entries.size()) +
               " entries before " + text_of(shaped->lattice);
    }
    const auto& curves = std::get<InlineCurves>(look);
    const std::string entries = std::to_string(curves.after[0].entries.size());
    return curves.mixes ? "curves of " + entries + " entries, a matrix, and curves of as many"
                        : "curves of " + entries + " entries";
}

std::size_t numbers_of(const InlineLook& look) {
    if (const auto* const lattice = std::get_if<InlineLattice>(&look)) {
        return lattice->nodes.size();
    }
    if (const auto* const shaped = std::get_if<InlineShaped>(&look)) {
        return 3 * shaped->shaper[0].entries.size() + shaped->lattice.nodes.size();
    }
    const auto& curves = std::get<InlineCurves>(look);
    const std::size_t entries = 3 * curves.after[0].entries.size();
    return curves.mixes ? 2 * entries + 9 : entries;
}

} // namespace lutlib
