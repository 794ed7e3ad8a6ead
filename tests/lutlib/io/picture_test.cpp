#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/formats/all.h"
#include "lutlib/io/image.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/png.h"
#include "lutlib/metrics/samples.h"
#include "tests/lutlib/engine/rude_looks.h"
#include "tests/lutlib/io/looks.h"
#include "tests/lutlib/io/scratch.h"

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
        const Reading reading = decode_lut(bytes, "x.png", {}, formats::png.name);
        const Lut& read = reading.lut;
        EXPECT_EQ(read.title, "Title");
        const Picture picture = decoded(bake.picture);
        double worst = 0;
        for (const Rgb& in : sample_colors(size, {.neutral = 512, .random = 4000})) {
            const Rgb theirs = engine.lookup(picture, size, in);
            const Rgb ours = evaluate(read, in, engine.interpolation);
            worst = std::max(worst, largest_magnitude(to_double(ours) - to_double(theirs)));
        }
        if (engine.filtering == Filtering::light) {
            ASSERT_EQ(reading.losses.size(), 1U);
            EXPECT_LT(worst, 2 * reading.losses[0].figure) << "beside what it says that it loses";
            continue;
        }
        EXPECT_TRUE(reading.losses.empty());
        EXPECT_LT(worst, 2e-5) << "a rounding of the texture coordinate times the steepest cell";
    }
}

// Looks whose content speaks for another layout, or for none.
TEST_P(EveryEngine, reads_back_every_look_that_is_baked_for_it) {
    const Engine& engine = GetParam();
    for (const RudeLook& look : rude_looks()) {
        const int size = engine.sizes.empty() ? 16 : engine.sizes.front();
        const Bake bake = lutlib::bake(Transform::each(look.f), engine, size, engine.default_bits);
        const std::string bytes = picture_bytes(bake, {"source", "Title", "tetrahedral"});
        const Reading read = decode_lut(bytes, "x.png", {}, formats::png.name);
        EXPECT_TRUE(read.remarks.empty()) << look.name << ": " << read.remarks.front();
        EXPECT_EQ(*read.lut.cube,
                  from_picture(decoded(bake.picture), *layout_named(engine.layout), size))
            << look.name;
    }
}

TEST(OwnPicture, is_known_by_its_text_and_nothing_else_is_one) {
    const ScratchFolder folder;
    const std::string path = folder.file("strip.png");
    EXPECT_FALSE(is_own_picture(path)) << "there is none";
    const std::string bytes = picture_bytes(baked(*engine_named("unity"), graded()), {});
    write_file(path, bytes);
    EXPECT_TRUE(is_own_picture(path));
    PngImage theirs = read_png(bytes, path);
    theirs.text = {{"Software", "GIMP"}, {"Comment", "lutconv"}};
    write_file(path, write_png(theirs));
    EXPECT_FALSE(is_own_picture(path));
    for (const std::string& other : {bytes.substr(0, bytes.size() / 2), std::string("lutconv")}) {
        write_file(path, other);
        EXPECT_FALSE(is_own_picture(path));
    }
}

TEST(PictureFormat, goes_by_content_where_a_picture_was_flipped_and_kept_its_text) {
    Bake bake = baked(*engine_named("unity"), graded());
    const CodeImage upright = bake.picture;
    for (int y = 0; y < upright.height; ++y) {
        for (int x = 0; x < upright.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                bake.picture.at({x, y}, c) = upright.at({x, upright.height - 1 - y}, c);
            }
        }
    }
    const std::string bytes = picture_bytes(bake, {"source", "Title", "tetrahedral"});
    const Reading read = decode_lut(bytes, "x.png", {}, formats::png.name);
    EXPECT_EQ(*read.lut.cube, from_picture(decoded(upright), *layout_named("strip-up"), bake.size));
    ASSERT_EQ(read.remarks.size(), 1U);
    EXPECT_NE(read.remarks[0].find("its text names the engine unity"), std::string::npos);
    // A layout that is asked for is taken.
    const Reading asked = decode_lut(bytes, "x.png", {.layout = layout_named("strip-up")});
    EXPECT_NE(*asked.lut.cube, *read.lut.cube);
}

TEST(PictureFormat, says_what_may_be_turned_round_but_not_of_a_negative_that_was_baked) {
    Lut negative = graded();
    for (Rgb& node : negative.cube->nodes) {
        node = Rgb{1, 1, 1} - node;
    }
    for (const Lut& look : {graded(), negative}) {
        for (const bool turned : {false, true}) {
            Bake bake = baked(*engine_named("unreal"), look);
            const std::string bytes = picture_bytes(bake, {"source", "Title", "tetrahedral"});
            PngImage image = read_png(bytes, "x.png");
            if (turned) { // with its text, as image editors keep it
                const CodeImage upright = bake.picture;
                for (int y = 0; y < upright.height; ++y) {
                    for (int x = 0; x < upright.width; ++x) {
                        for (std::size_t c = 0; c < 3; ++c) {
                            image.at({x, y}, c) =
                                upright.at({upright.width - 1 - x, upright.height - 1 - y}, c);
                        }
                    }
                }
            }
            const Reading read = decode_lut(write_png(image), "x.png", {}, formats::png.name);
            EXPECT_EQ(read.remarks.size(), turned ? 1U : 0U);
        }
    }
}

TEST(PictureFormat, takes_the_engine_that_is_named_where_the_content_does_not_tell) {
    Bake bake = baked(*engine_named("unity"), monochrome());
    PngImage plain = read_png(picture_bytes(bake, {}), "x.png");
    plain.text.clear();
    const std::string bytes = write_png(plain);
    EXPECT_THROW(decode_lut(bytes, "x.png"), Error);
    const Reading read = decode_lut(bytes, "x.png", {.engine = engine_named("unity")});
    EXPECT_EQ(*read.lut.cube,
              from_picture(decoded(bake.picture), *layout_named("strip-up"), bake.size));
}

TEST(PictureFormat, reads_pictures_of_other_types_and_depths_and_with_alpha) {
    const ScratchFolder folder;
    const Bake bake = baked(*engine_named("piccolo"), graded());
    const Picture picture = decoded(bake.picture);
    FloatImage image;
    image.width = picture.width;
    image.height = picture.height;
    for (const Rgb& pixel : picture.pixels) {
        image.rgba.insert(image.rgba.end(), {pixel.r, pixel.g, pixel.b, 1});
    }
    struct Kind {
        const char* extension;
        Depth depth;
        bool alpha;
        float tolerance;
    };
    for (const Kind& kind :
         {Kind{"tga", Depth::uint8, false, 0},
          {"tga", Depth::uint8, true, 0},
          {"tif", Depth::uint8, false, 0},
          {"tif", Depth::uint16, true, 0},
          {"bmp", Depth::uint8, false, 0},
          {"exr", Depth::half, false, 3e-4F},
          {"exr", Depth::float32, true, 0},
          {"png", Depth::uint16, true, 0},
          {"jpg", Depth::uint8, false, 0.25F}}) { // colour at half resolution blurs slices together
        const std::string path = folder.file(std::string("strip.") + kind.extension);
        write_image(path, image, {.depth = kind.depth, .alpha = kind.alpha, .text = {}});
        const Lut read = read_lut(path).lut;
        ASSERT_EQ(read.cube->size, 16) << path;
        float worst = 0;
        const Lut3D right = from_picture(picture, *layout_named("strip"), 16);
        for (std::size_t i = 0; i < right.nodes.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(read.cube->nodes[i][c] - right.nodes[i][c]));
            }
        }
        EXPECT_LE(worst, kind.tolerance + 1e-6F) << path;
    }
}

TEST(PictureFormat, says_that_jpeg_is_lossy_and_divides_colors_by_the_alpha_in_them) {
    const ScratchFolder folder;
    const Picture picture = decoded(baked(*engine_named("piccolo"), graded()).picture);
    FloatImage image;
    image.width = picture.width;
    image.height = picture.height;
    image.premultiplied = true;
    for (const Rgb& pixel : picture.pixels) {
        image.rgba.insert(image.rgba.end(), {pixel.r / 2, pixel.g / 2, pixel.b / 2, 0.5F});
    }
    const std::string exr = folder.file("half.exr"), jpg = folder.file("a.jpg");
    write_image(exr, image, {.depth = Depth::float32, .alpha = true, .text = {}});
    const Reading read = read_lut(exr);
    EXPECT_EQ(*read.lut.cube, from_picture(picture, *layout_named("strip"), 16));
    ASSERT_EQ(read.remarks.size(), 1U);
    EXPECT_NE(read.remarks[0].find("not 1 in 4096 texels"), std::string::npos) << read.remarks[0];
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] *= 2;
    }
    write_image(jpg, image, {.depth = Depth::uint8, .alpha = false, .text = {}});
    ASSERT_EQ(read_lut(jpg).remarks.size(), 1U);
    EXPECT_NE(read_lut(jpg).remarks[0].find("JPEG"), std::string::npos);
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
