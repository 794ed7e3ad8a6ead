#include "lutlib/io/ocio/read.h"

#include "lutlib/io/describe.h"
#include "lutlib/io/ocio/chain.h"
#include "lutlib/limits.h"
#include "lutlib/metrics/stats.h"
#include "lutlib/resample/curves.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace lutlib::io {
namespace {

constexpr int default_cells = 64;
constexpr int default_curve_size = 4096;
// What a sample that is not finite becomes: the largest half float, far outside any picture.
constexpr float largest_sample = 65504;
// Differences that are rounding of float arithmetic and no loss of the reading, for looks of 0..1.
constexpr double rounding_noise = 5e-7;

// What a file asks a cube to be read by.
std::optional<Interpolation> interpolation_of(const OCIO::ConstTransformRcPtr& op) {
    const auto cube = std::dynamic_pointer_cast<const OCIO::Lut3DTransform>(op);
    switch (cube ? cube->getInterpolation() : OCIO::INTERP_DEFAULT) {
    case OCIO::INTERP_TETRAHEDRAL:
    case OCIO::INTERP_BEST:
        return Interpolation::tetrahedral;
    case OCIO::INTERP_LINEAR:
    case OCIO::INTERP_NEAREST: // OpenColorIO 2 takes the name and interpolates linearly
        return Interpolation::trilinear;
    default:
        return std::nullopt;
    }
}

// Cubes that ask for nothing are read tetrahedrally.
Chain with_interpolations(Chain chain) {
    for (OCIO::ConstTransformRcPtr& op : chain) {
        const bool is_cube = std::dynamic_pointer_cast<const OCIO::Lut3DTransform>(op) != nullptr;
        if (is_cube && !interpolation_of(op)) {
            const auto copy =
                std::dynamic_pointer_cast<OCIO::Lut3DTransform>(op->createEditableCopy());
            copy->setInterpolation(OCIO::INTERP_TETRAHEDRAL);
            op = copy;
        }
    }
    return chain;
}

// The longest front of the chain that is a shaper and a cube, with the affine maps behind them.
struct Front {
    Lut lut;
    std::size_t shaper_end = 0; ///< operators that the shaper stands for
    std::size_t cube_at = 0;    ///< the operator that the cube is
    bool whole = false;         ///< the look stands for the whole chain
};

// Folds the affine maps from `at` on into the last table; returns where it stopped.
std::size_t fold_affine(const Chain& chain, std::size_t at, Lut& lut) {
    for (; at < chain.size(); ++at) {
        const std::optional<Affine> affine = affine_of(chain[at]);
        if (!affine || (!lut.cube && affine->mixes)) {
            break;
        }
        std::vector<Rgb>& values = lut.cube ? lut.cube->nodes : lut.shaper->entries;
        std::transform(values.begin(), values.end(), values.begin(), *affine);
    }
    return at;
}

bool table_follows(const Chain& chain, std::size_t at) {
    return std::any_of(chain.begin() + static_cast<std::ptrdiff_t>(at) + 1, chain.end(),
                       [](const auto& op) { return curve_of(op) || cube_of(op); });
}

Front front_of(const Chain& chain) {
    Front front;
    ChannelMaps maps;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (append(maps, chain[i])) {
            continue;
        }
        const std::optional<Domain> domain = domain_of_unit(maps);
        if (!domain) {
            break;
        }
        std::optional<Lut1D> curve = front.lut.shaper ? std::nullopt : curve_of(chain[i]);
        std::optional<Lut3D> cube = cube_of(chain[i]);
        if (curve && table_follows(chain, i) && append_straight(maps, *curve)) {
            continue;
        }
        if (curve) {
            curve->domain = *domain;
            front.lut.shaper = std::move(curve);
            front.shaper_end = i + 1;
            maps = {};
            continue;
        }
        if (cube) {
            cube->domain = *domain;
            front.lut.cube = std::move(cube);
            front.cube_at = i;
            front.whole = fold_affine(chain, i + 1, front.lut) == chain.size();
        }
        return front;
    }
    // The chain ended without a cube: what follows the shaper may still fold into it.
    front.whole =
        front.lut.shaper && fold_affine(chain, front.shaper_end, front.lut) == chain.size();
    return front;
}

// The inputs over which the chain from `first` on is sampled: those its first table spans, or that
// an inverse table takes, or what a clamp leaves, or what the shaper before it gives, or 0..1.
Domain sampling_domain(const Chain& chain, std::size_t first, const std::optional<Lut1D>& shaper) {
    ChannelMaps maps;
    std::size_t i = first;
    while (i < chain.size() && append(maps, chain[i])) {
        ++i;
    }
    if (i < chain.size() && (curve_of(chain[i]) || cube_of(chain[i]))) {
        if (const std::optional<Domain> domain = domain_of_unit(maps)) {
            return *domain;
        }
    }
    if (const auto values = i < chain.size() ? values_of_inverse(chain[i]) : std::nullopt) {
        if (const std::optional<Domain> domain = domain_onto(maps, *values)) {
            return *domain;
        }
    }
    Domain out;
    for (std::size_t c = 0; c < 3; ++c) {
        if (std::isfinite(maps[c].low) && std::isfinite(maps[c].high)) {
            out.min[c] = static_cast<float>(maps[c].low);
            out.max[c] = static_cast<float>(maps[c].high);
        } else if (shaper) {
            const auto [low, high] =
                std::minmax_element(shaper->entries.begin(), shaper->entries.end(),
                                    [c](const Rgb& a, const Rgb& b) { return a[c] < b[c]; });
            out.min[c] = (*low)[c];
            out.max[c] = (*high)[c];
        }
        if (!(out.max[c] > out.min[c])) {
            out.max[c] = out.min[c] + 1;
        }
    }
    return out;
}

int sampling_size(const Chain& chain, std::size_t first, const ReadOptions& options) {
    if (options.size != 0) {
        check_cube_size(options.size);
        return options.size;
    }
    for (std::size_t i = first; i < chain.size(); ++i) {
        if (const std::optional<Lut3D> cube = cube_of(chain[i])) {
            const int cells = cube->size - 1;
            return std::min((default_cells + cells - 1) / cells * cells + 1, limits::max_cube_size);
        }
    }
    return default_cells + 1;
}

std::size_t replace_non_finite(std::vector<Rgb>& values) {
    std::size_t count = 0;
    for (Rgb& value : values) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (!std::isfinite(value[c])) {
                value[c] = std::isnan(value[c]) ? 0 : std::copysign(largest_sample, value[c]);
                ++count;
            }
        }
    }
    return count;
}

OCIO::ConstCPUProcessorRcPtr lossless(const Chain& chain, std::size_t first) {
    return cpu_processor(processor_of_chain(chain, first), Optimization::lossless);
}

// How many operators at the front do not mix channels, where they bend them: an affine front is a
// domain.
std::size_t bending_front(const Chain& chain) {
    ChannelMaps maps;
    std::size_t end = 0;
    bool bends = false;
    while (end < chain.size()) {
        const Chain longer(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(end) + 1);
        if (lossless(longer, 0)->hasChannelCrosstalk()) {
            break;
        }
        bends = bends || !append(maps, chain[end]);
        ++end;
    }
    return bends ? end : 0;
}

// The operators before `end`, which do not mix channels, as a table over the inputs they take.
Lut1D table_of_front(const Chain& chain, std::size_t end) {
    const Chain front(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(end));
    return sample_curve_closely(transform_of(lossless(front, 0)), sampling_domain(chain, 0, {}),
                                default_curve_size, curve_tolerance);
}

std::size_t sample_cube_of_rest(const Chain& chain, const ReadOptions& options, Front& front) {
    Lut& lut = front.lut;
    std::size_t first = front.shaper_end;
    if (first > 0) {
        // Without what fold_affine may have put into it.
        lut.shaper->entries = curve_of(chain[first - 1])->entries;
    } else if (first = bending_front(chain); first > 0) {
        lut.shaper = table_of_front(chain, first);
    } else {
        lut.shaper.reset();
    }
    const std::size_t replaced = lut.shaper ? replace_non_finite(lut.shaper->entries) : 0;
    lut.cube = identity_cube(sampling_size(chain, first, options),
                             sampling_domain(chain, first, lut.shaper));
    transform_in_place(lossless(chain, first), lut.cube->nodes);
    return replaced + replace_non_finite(lut.cube->nodes);
}

// Replaces what the front could not say by samples of the chain behind the shaper.
void sample_rest(const Chain& chain, const ReadOptions& options, Front& front,
                 std::vector<Loss>& losses) {
    Lut& lut = front.lut;
    lut.cube.reset();
    std::size_t replaced = 0;
    if (lossless(chain, 0)->hasChannelCrosstalk()) {
        replaced = sample_cube_of_rest(chain, options, front);
    } else {
        lut.shaper = table_of_front(chain, chain.size());
        replaced = replace_non_finite(lut.shaper->entries);
    }
    if (replaced > 0) {
        losses.push_back({"samples that are not finite, replaced by 0 or +-65504",
                          static_cast<double>(replaced), "values"});
    }
}

// Largest difference between the look and the chain over `inputs`.
double largest_error(const Lut& lut, const OCIO::ConstCPUProcessorRcPtr& chain,
                     std::vector<Rgb> inputs) {
    std::vector<Rgb> expected = inputs;
    transform_in_place(chain, expected);
    std::vector<double> errors;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Rgb difference = evaluate(lut, inputs[i]) - expected[i];
        for (std::size_t c = 0; c < 3; ++c) {
            errors.push_back(difference[c]);
        }
    }
    return error_stats(std::move(errors)).max;
}

// Colours of the domain stretched about it: 0..1 is inside.
std::vector<Rgb> colors_between(const Domain& d, float low, float high, int count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> position(low, high);
    std::vector<Rgb> out;
    for (int i = 0; i < count; ++i) {
        Rgb t{position(random), position(random), position(random)};
        if (i % 4 == 0) {
            t.g = t.b = t.r;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            t[c] = d.min[c] + t[c] * (d.max[c] - d.min[c]);
        }
        out.push_back(t);
    }
    return out;
}

} // namespace

Reading look_of_processor(const OCIO::ConstProcessorRcPtr& processor, const ReadOptions& options) {
    const Chain asked = chain_of(processor);
    const Chain chain = with_interpolations(asked);
    Front front = front_of(chain);
    Reading out;
    const auto exact = cpu_processor(processor_of_chain(chain, 0), Optimization::lossless);
    std::string what = "not kept by the table, largest error";
    if (front.whole && front.lut.cube) {
        front.lut.interpolation = interpolation_of(asked[front.cube_at]);
    }
    if (!front.whole) {
        sample_rest(chain, options, front, out.table_losses);
        what = "sampled onto " + shape_of(front.lut) + " over the input " +
               text_of(front.lut.domain()) + ", largest error";
    }
    const Domain& domain = front.lut.domain();
    const double inside = largest_error(front.lut, exact, colors_between(domain, 0, 1, 40000));
    if (inside > rounding_noise) {
        out.table_losses.push_back({what, inside, ""});
    }
    // A table ends where its domain does, other operators go on.
    const double outside =
        std::max(largest_error(front.lut, exact, colors_between(domain, 1, 2, 1000)),
                 largest_error(front.lut, exact, colors_between(domain, -1, 0, 1000)));
    if (outside > 1e-5) {
        out.table_losses.push_back({"inputs outside " + text_of(domain) +
                                        " are clamped, largest error up to one width beyond",
                                    outside, ""});
    }
    out.lut = std::move(front.lut);
    validate(out.lut);
    return out;
}

} // namespace lutlib::io
