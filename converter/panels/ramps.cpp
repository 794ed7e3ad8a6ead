#include "converter/panels/ramps.h"

#include "converter/panels/parts.h"

#include <algorithm>

namespace converter {
namespace {

constexpr int ramp_places = 513;

Ramp ramp_of(const std::vector<double>& in, const std::vector<lutlib::RgbD>& images,
             std::size_t channel) {
    Ramp out{channel, in, {}};
    for (const lutlib::RgbD& image : images) {
        out.out.push_back(image[channel]);
    }
    return out;
}

} // namespace

std::vector<lutlib::RgbD> neutral_codes(const lutlib::Domain& domain, int count) {
    const lutlib::Domain& d = domain;
    std::vector<lutlib::RgbD> out;
    for (const double v : evenly(std::min({d.min.r, d.min.g, d.min.b}),
                                 std::max({d.max.r, d.max.g, d.max.b}), count)) {
        out.push_back({v, v, v});
    }
    return out;
}

std::vector<Ramp> neutral_ramps(const ShownLook& look) {
    std::vector<lutlib::RgbD> codes = neutral_codes(look.domain, ramp_places);
    std::vector<double> in;
    for (const lutlib::RgbD& c : codes) {
        in.push_back(c.r);
    }
    codes = images_of(look, std::move(codes));
    return {ramp_of(in, codes, 0), ramp_of(in, codes, 1), ramp_of(in, codes, 2)};
}

std::vector<Ramp> channel_ramps(const ShownLook& look) {
    std::vector<Ramp> out;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<double> in = evenly(look.domain.min[c], look.domain.max[c], ramp_places);
        std::vector<lutlib::RgbD> codes(in.size(), to_double(look.domain.min));
        for (std::size_t i = 0; i < in.size(); ++i) {
            codes[i][c] = in[i];
        }
        out.push_back(ramp_of(in, images_of(look, std::move(codes)), c));
    }
    return out;
}

} // namespace converter
