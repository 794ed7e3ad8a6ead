#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/io/looks.h"

#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

class EveryEngine : public testing::TestWithParam<Engine> {};
INSTANTIATE_TEST_SUITE_P(Engines, EveryEngine,
                         testing::ValuesIn(engines().begin(), engines().end()),
                         [](const auto& row) { return std::string(row.param.name); });

Bake baked(const Engine& engine, const Lut& lut) {
    const int size = engine.sizes.empty() ? 16 : engine.sizes.front();
    return bake(Transform::of(lut, Interpolation::tetrahedral), engine, size, engine.default_bits);
}

Lut graded() {
    Lut lut;
    lut.cube = graded_cube(17, {});
    return lut;
}

// A monochrome look: its content does not tell its layout.
Lut monochrome() {
    Lut lut;
    lut.cube = identity_cube(9);
    for (Rgb& node : lut.cube->nodes) {
        const float grey = (node.r + node.g + node.b) / 3;
        node = {grey, grey, grey};
    }
    return lut;
}

TEST_P(EveryEngine, reads_its_baked_picture_as_the_engine_does) {
    const Engine& engine = GetParam();
    for (const Lut& look : {graded(), monochrome()}) {
        const Bake bake = baked(engine, look);
        const int size = bake.size;
        const std::string bytes = picture_bytes(bake, {"source", "Title", "tetrahedral"});
        const Lut read = decode_lut(bytes, "x.png", {}, formats::png.name).lut;
        EXPECT_EQ(read.title, "Title");
        const Picture picture = decoded(bake.picture);
        double worst = 0;
        for (const Rgb& in : sample_colors(size, {.neutral = 512, .random = 4000})) {
            const Rgb theirs = engine.lookup(picture, size, in);
            const Rgb ours = evaluate(read, in, engine.interpolation);
            worst = std::max(worst, largest_magnitude(to_double(ours) - to_double(theirs)));
        }
        EXPECT_LT(worst, 2e-5) << "a rounding of the texture coordinate times the steepest cell";
    }
}

TEST(PictureFormat, goes_by_content_where_the_text_names_an_engine_of_another_size) {
    Bake bake = baked(*engine_named("piccolo"), graded());
    bake.engine = engine_named("obs");
    const std::string bytes = picture_bytes(bake, {"source", {}, {}});
    const Lut read = decode_lut(bytes, "x.png", {}, formats::png.name).lut;
    EXPECT_EQ(read.cube->size, 16);
    EXPECT_FALSE(read.shaper);
}

TEST(PictureFormat, reads_the_row_of_stacked_lattices_that_is_asked_for) {
    Lut identity;
    identity.cube = identity_cube(16);
    Bake bake = baked(*engine_named("reshade"), identity);
    CodeImage& stacked = bake.picture;
    const std::vector<std::uint16_t> first = stacked.samples;
    // Below the identity the same with red at full.
    stacked.samples.insert(stacked.samples.end(), first.begin(), first.end());
    for (std::size_t i = first.size(); i < stacked.samples.size(); i += 3) {
        stacked.samples[i] = 255;
    }
    stacked.height *= 2;
    const std::string bytes = picture_bytes(bake, {"source", {}, {}});
    for (const int row : {0, 1}) {
        const Reading reading = decode_lut(bytes, "x.png", {.row = row});
        EXPECT_EQ(reading.lut.cube->at(3, 15, 0), (Rgb{row == 0 ? 0.2F : 1.0F, 1, 0}));
        ASSERT_EQ(reading.losses.size(), 1U);
        EXPECT_EQ(reading.losses[0].figure, 2);
    }
    EXPECT_THROW(decode_lut(bytes, "x.png", {.row = 2}), UsageError);
}

TEST(PictureFormat, refuses_dimensions_that_the_layout_does_not_have) {
    const Bake bake = baked(*engine_named("piccolo"), graded());
    const std::string bytes = picture_bytes(bake, {"source", {}, {}});
    EXPECT_THROW(decode_lut(bytes, "x.png", {}, "tiles"), Error);
}

} // namespace
} // namespace lutlib::io
