#include "lutlib/resample/resample.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/interpolation/tricubic.h"
#include "lutlib/named.h"
#include "lutlib/resample/combine.h"
#include "lutlib/resample/curves.h"
#include "lutlib/resample/sample_lut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr std::array<ResamplingMethod, 3> method_rows{{
    {"trilinear", "eight nodes",
     [](const Lut& lut) { return Transform::of(lut, Interpolation::trilinear); }},
    {"tetrahedral", "four nodes, exact on the neutral axis",
     [](const Lut& lut) { return Transform::of(lut, Interpolation::tetrahedral); }},
    {"tricubic", "64 nodes, smooth, may overshoot at bends",
     [](const Lut& lut) {
         return Transform::each([&lut](RgbD c) {
             const RgbD shaped = lut.shaper ? evaluate_exact(*lut.shaper, c) : c;
             return lut.cube ? tricubic(*lut.cube, shaped) : shaped;
         });
     }},
}};

// What a 1D table can give, widened where it is constant.
Domain values_of(const Lut1D& curve) {
    Domain out{curve.entries.front(), curve.entries.front()};
    for (const Rgb& entry : curve.entries) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.min[c] = std::min(out.min[c], entry[c]);
            out.max[c] = std::max(out.max[c], entry[c]);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(out.min[c] < out.max[c])) {
            out.max[c] = out.min[c] + std::max(1.0F, std::abs(out.min[c]));
        }
    }
    return out;
}

} // namespace

std::span<const ResamplingMethod> resampling_methods() {
    return method_rows;
}

const ResamplingMethod* resampling_method_named(std::string_view name) {
    return find_named(method_rows, name);
}

const ResamplingMethod& usual_resampling() {
    static constexpr ResamplingMethod usual{"", "as the look asks for",
                                            [](const Lut& lut) { return Transform::of(lut); }};
    return usual;
}

std::vector<std::string_view> shaper_names() {
    std::vector<std::string_view> names = name_list(transfer_curves());
    names.insert(names.begin(), {"none", "base"});
    return names;
}

Lut sample_like(const Lut& like, const Sampling& sampling, const Transform& whole,
                const Transform& after_table) {
    const int size = sampling.size.value_or(like.cube ? like.cube->size : usual_cube_size);
    const Domain domain = sampling.domain.value_or(like.domain());
    const std::string shaper = !sampling.shaper.empty()          ? sampling.shaper
                               : like.shaper && !sampling.domain ? "base"
                                                                 : "none";
    Lut out;
    out.title = like.title;
    out.encodings = like.encodings;
    if (shaper == "none") {
        out.cube = sample_cube(whole, domain, size);
    } else if (shaper == "base") {
        if (!like.shaper) {
            throw Error("the look has no 1D table to keep; choose another one");
        }
        if (sampling.domain) {
            throw Error("the look's own 1D table comes with its own domain; choose another table "
                        "or no domain");
        }
        out.shaper = like.shaper;
        out.cube =
            sample_cube(after_table, like.cube ? like.cube->domain : values_of(*like.shaper), size);
    } else {
        out.shaper = encoding_shaper(shaper, sampling.input, domain, sampling.shaper_size);
        out.cube = sample_cube_behind(whole, *out.shaper, size);
    }
    return out;
}

Lut resample(const Lut& lut, const Sampling& sampling, const ResamplingMethod& method) {
    if (make_curve({&lut}, sampling)) {
        Lut out;
        out.title = lut.title;
        out.encodings = lut.encodings;
        const Domain domain = sampling.domain.value_or(lut.domain());
        const int size = sampling.size.value_or(lut.shaper->size());
        const bool same = domain == lut.domain() && size == lut.shaper->size();
        out.shaper = same ? *lut.shaper : sample_curve(method.transform_of(lut), domain, size);
        return out;
    }
    Lut cube_only;
    cube_only.cube = lut.cube;
    cube_only.interpolation = lut.interpolation;
    return sample_like(lut, sampling, method.transform_of(lut), method.transform_of(cube_only));
}

} // namespace lutlib
