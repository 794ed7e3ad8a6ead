// The CDL operator against OpenColorIO's CDLTransform, in both of its styles.
#include "lutlib/io/ocio.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace lutlib::io {
namespace {

struct Cdl {
    RgbD slope, offset, power;
    double saturation;
};

std::string three(RgbD c) {
    return std::to_string(c.r) + " " + std::to_string(c.g) + " " + std::to_string(c.b);
}

std::string clf(const Cdl& cdl, bool clamp) {
    return "<?xml version=\"1.0\"?>\n<ProcessList id=\"t\" compCLFversion=\"3\">\n"
           "<ASC_CDL id=\"c\" inBitDepth=\"32f\" outBitDepth=\"32f\" style=\"" +
           std::string(clamp ? "Fwd" : "FwdNoClamp") + "\">\n<SOPNode><Slope>" + three(cdl.slope) +
           "</Slope><Offset>" + three(cdl.offset) + "</Offset><Power>" + three(cdl.power) +
           "</Power></SOPNode>\n<SatNode><Saturation>" + std::to_string(cdl.saturation) +
           "</Saturation></SatNode>\n</ASC_CDL>\n</ProcessList>\n";
}

Transform ours(const Cdl& cdl, bool clamp) {
    Recipe recipe;
    recipe.operations = {{op_named("cdl"),
                          {cdl.slope, cdl.offset, cdl.power, cdl.saturation, clamp ? 1.0 : 0.0},
                          true}};
    return Transform::of(recipe);
}

// The first is the example of OpenColorIO's and the ASC's documentation; values have six decimals,
// which the file keeps.
constexpr Cdl published[] = {
    {{1, 1, .9}, {-.03, -.02, 0}, {1.25, 1, 1}, 1.7},
    {{1.35, 1.1, .71}, {.05, -.23, .11}, {.93, .81, 1.27}, 1.239},
    {{1, 1, 1}, {0, 0, 0}, {1, 1, 1}, 1},
    {{.5, 2, 1}, {.1, -.5, 0}, {2, .5, 1}, 0},
};

TEST(Cdl, agrees_with_opencolorio_clamped_and_not) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-0.2F, 1.3F);
    for (const Cdl& cdl : published) {
        for (const bool clamp : {true, false}) {
            std::vector<Rgb> in(20000);
            for (Rgb& c : in) {
                c = {value(random), value(random), value(random)};
            }
            const std::vector<RgbD> theirs =
                images_of(ocio().parse(clf(cdl, clamp), "clf", "cdl.clf", {}), in);
            const std::vector<RgbD> edited = images_of(ours(cdl, clamp), in);
            double worst = 0;
            for (std::size_t i = 0; i < in.size(); ++i) {
                const RgbD difference = edited[i] - theirs[i];
                worst = std::max(worst, largest_magnitude(difference));
            }
            // OpenColorIO takes powers in float by a polynomial, of about 2e-6 relative.
            EXPECT_LT(worst, 2e-5) << cdl.saturation << ' ' << clamp;
        }
    }
}

TEST(Cdl, gives_the_formulas_values) {
    const RgbD out = ours({{1.2, 1, .8}, {.05, 0, -.1}, {1.5, 1, .5}, 1}, true)({.5, .25, .25});
    EXPECT_NEAR(out.r, std::pow(.65, 1.5), 1e-15);
    EXPECT_NEAR(out.g, .25, 1e-15);
    EXPECT_NEAR(out.b, std::sqrt(.1), 1e-15);
    // Below zero no power is taken without the clamp.
    EXPECT_NEAR(ours({{1, 1, 1}, {-.5, 0, 0}, {3, 3, 3}, 1}, false)({.25, 0, 0}).r, -.25, 1e-15);
}

} // namespace
} // namespace lutlib::io
