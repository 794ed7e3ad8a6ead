// The CDL operator against OpenColorIO's CDLTransform, in both of its styles.
#include "lutlib/error.h"
#include "lutlib/io/correction_files.h"
#include "lutlib/io/file.h"
#include "lutlib/io/ocio.h"
#include "lutlib/recipe/correction_file.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
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

TEST(CorrectionFiles, are_read_by_opencolorio_as_they_were_meant_and_by_us_to_the_bit) {
    const ScratchFolder folder;
    std::mt19937 random(2);
    std::uniform_real_distribution<float> value(-0.2F, 1.3F);
    std::vector<Rgb> in(5000);
    for (Rgb& c : in) {
        c = {value(random), value(random), value(random)};
    }
    for (const CorrectionFormat& format : correction_formats()) {
        const std::string path = folder.file("a." + std::string(format.extension));
        for (const Cdl& cdl : published) {
            const ColorCorrection meant{"shot & <1>", "day",     cdl.slope,
                                        cdl.offset,   cdl.power, cdl.saturation};
            std::filesystem::remove(path);
            write_file(path, correction_bytes(path, meant));
            if (format.holds_many()) { // the first is the one that OpenColorIO is asked for
                write_file(path, correction_bytes(path, {.id = "other", .saturation = 3}));
            }
            const std::vector<RgbD> theirs = images_of(
                ocio().parse(read_file(path), std::string(format.extension), path, {}), in);
            const auto read = read_corrections(path);
            ASSERT_EQ(read.size(), format.holds_many() ? 2U : 1U);
            EXPECT_EQ(read[0], meant);
            Recipe recipe;
            std::vector<Loss> losses;
            recipe.operations = {operation_of(read[0], losses)};
            EXPECT_TRUE(losses.empty());
            const std::vector<RgbD> own = images_of(Transform::of(recipe), in);
            double worst = 0;
            for (std::size_t i = 0; i < in.size(); ++i) {
                worst = std::max(worst, largest_magnitude(own[i] - theirs[i]));
            }
            EXPECT_LT(worst, 2e-5) << format.extension << ' ' << cdl.saturation;
        }
    }
    EXPECT_THROW(correction_bytes(folder.file("a.xml"), {}), UsageError);
    const std::string other = folder.file("other.ccc");
    write_file(other, "no collection");
    EXPECT_THROW(correction_bytes(other, {}), Error);
    EXPECT_EQ(correction_bytes(other, {}, Unreadable::is_replaced),
              correction_text({}, correction_formats()[1]));
    write_file(other, "");
    EXPECT_EQ(correction_bytes(other, {}), correction_text({}, correction_formats()[1]));
    EXPECT_THROW(correction_bytes(folder.file("a.cc"), {.id = "\xe9"}), UsageError);
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
