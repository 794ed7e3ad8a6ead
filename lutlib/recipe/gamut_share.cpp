#include "lutlib/recipe/gamut_share.h"

#include "lutlib/resample/sample_lut.h"

#include <algorithm>

namespace lutlib {

GamutShare gamut_share(const Recipe& recipe, const Domain& domain) {
    constexpr int lattice = 33;
    constexpr float rounding = 1e-6F; // of a matrix in double, stored as float
    Recipe light = recipe;
    light.output = Encoding{transfer_curve_named("linear"), recipe.output_encoding().gamut};
    const auto brightest = static_cast<float>(recipe.output_encoding().decode(1));
    const Lut3D cube = sample_cube(Transform::of(light), domain, lattice);
    std::size_t outside = 0, above = 0;
    for (const Rgb& c : cube.nodes) {
        const float least = std::min({c.r, c.g, c.b}), most = std::max({c.r, c.g, c.b});
        outside += least < -rounding * (1 + most);
        above += most > brightest * (1 + rounding);
    }
    const auto count = static_cast<double>(cube.nodes.size());
    return {static_cast<double>(outside) / count, static_cast<double>(above) / count};
}

} // namespace lutlib
