#include "lutlib/io/look.h"

#include "lutlib/engine/engine.h"
#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/ocio.h"
#include "lutlib/io/png.h"
#include "tests/lutlib/io/looks.h"
#include "tests/lutlib/io/scratch.h"
#include "tests/lutlib/looks.h"
#include "tests/support/names.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

std::string file(const char* name) {
    return std::string(LUT_TEST_FILES "/") + name;
}

constexpr const char* recipe_text =
    R"({"schema_version": 1, "title": "Mine", "base": "base.cube",
        "operators": [{"op": "exposure", "stops": 0.5}]})";
constexpr const char* curve_text = "LUT_IN_VIDEO_RANGE\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n";

double largest_difference(const Transform& a, const Transform& b, const Domain& domain = {}) {
    const std::vector<Rgb> inputs = identity_cube(12, domain).nodes;
    const std::vector<RgbD> of_a = images_of(a, inputs), of_b = images_of(b, inputs);
    double most = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        most = std::max(most, largest_magnitude(of_a[i] - of_b[i]));
    }
    return most;
}

std::string picture_of(const char* engine, int size) {
    const Bake baked = bake(test_looks()[1].transform(), *engine_named(engine), size, 8);
    return picture_bytes(baked, {"look.cube", "Saturated", "tetrahedral"});
}

TEST(Look, of_a_lut_is_its_table_in_double) {
    for (const auto& [name, lut] : looks_of_every_shape(9)) {
        if (lut.interpolation) {
            continue;
        }
        const Look look = Look::of_bytes(write_cube(lut, best_dialect(lut)), "x.cube");
        EXPECT_TRUE(look.is_table() && look.is_interpolated() && !look.recipe()) << name;
        EXPECT_EQ(look.table().lut->cube, lut.cube) << name;
        EXPECT_TRUE(look.table().losses.empty()) << name;
        EXPECT_EQ(look.domain(), lut.domain()) << name;
        EXPECT_EQ(look.clamps_to(), lut.domain()) << name;
        EXPECT_EQ(largest_difference(look.exact(), Transform::of(lut), lut.domain()), 0) << name;
        EXPECT_EQ(look.exact().precision(), Precision::float64) << name;
    }
}

TEST(Look, of_a_recipe_is_evaluated_exactly_and_measured_as_a_table) {
    const Look look = Look::of_bytes(
        R"({"schema_version": 1, "operators": [{"op": "exposure", "stops": 1}]})", "x.json");
    ASSERT_TRUE(look.recipe());
    EXPECT_EQ(look.kind().format, "recipe");
    EXPECT_FALSE(look.is_table());
    EXPECT_FALSE(look.clamps_to());
    EXPECT_EQ(largest_difference(look.exact(), Transform::of(*look.recipe())), 0);
    double last = 1;
    for (const int size : {5, 17}) {
        const LookTable table = look.table(size);
        EXPECT_EQ(table.lut->cube->size, size);
        ASSERT_EQ(table.losses.size(), 1U);
        EXPECT_GT(table.losses[0].figure, 0);
        EXPECT_LT(table.losses[0].figure, last);
        last = table.losses[0].figure;
    }
}

TEST(Look, of_a_recipe_reads_its_base_beside_it_and_tells_both_files_apart) {
    const ScratchFolder folder;
    write_file(folder.file("base.cube"), curve_text);
    write_file(folder.file("recipe.json"), recipe_text);
    const Look look = Look::open(folder.file("recipe.json"));
    EXPECT_EQ(look.title(), "Mine");
    ASSERT_EQ(look.files().size(), 2U);
    EXPECT_TRUE(look.files()[0].keywords.empty());
    EXPECT_EQ(look.files()[1].name, folder.file("base.cube"));
    EXPECT_EQ(look.files()[1].keywords, std::vector<std::string>{"LUT_IN_VIDEO_RANGE"});
    ASSERT_TRUE(look.recipe()->base_lut);
    EXPECT_EQ(look.clamps_to(), Domain{});
}

TEST(Look, of_operators_is_opencolorios_and_no_table) {
    const Look look = Look::open(file("saturated.cc"));
    EXPECT_FALSE(look.is_table());
    EXPECT_FALSE(look.clamps_to());
    EXPECT_EQ(look.exact().precision(), Precision::float32);
    EXPECT_EQ(largest_difference(look.exact(), open_in_ocio(file("saturated.cc"))), 0);
    const LookTable coarse = look.table(9);
    EXPECT_EQ(coarse.lut->cube->size, 9);
    const double error = largest_difference(look.exact(), Transform::of(coarse.lut));
    EXPECT_GT(error, 0);
    EXPECT_LE(error, 1.3 * coarse.losses.front().figure);
}

TEST(Look, has_the_users_own_file_for_its_reference_not_what_lutlib_read) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.cube");
    write_file(path, "LUT_1D_SIZE 3\n0 0 0\n0.5 0.5 0.5\n1 1 1\n");
    const Look look = Look::open(path);
    write_file(path, "LUT_1D_SIZE 3\n0 0 0\n0.25 0.25 0.25\n1 1 1\n");
    const LookReference reference = look.reference(Interpolation::tetrahedral);
    EXPECT_TRUE(reference.refusal.empty()) << reference.refusal;
    EXPECT_FLOAT_EQ(static_cast<float>(reference.look({0.5, 0.5, 0.5}).g), 0.25F);
}

TEST(Look, tells_what_of_the_file_it_has_not_read_apart_from_what_its_table_loses) {
    const Look look = Look::open(file("grade.ccc"));
    ASSERT_EQ(look.files().size(), 1U);
    ASSERT_EQ(look.files()[0].losses.size(), 1U);
    EXPECT_EQ(look.files()[0].losses[0].figure, 2);
    for (const Loss& loss : look.table().losses) {
        EXPECT_EQ(loss.what.find("only the first"), std::string::npos);
    }
}

TEST(Look, is_read_as_its_file_asks_unless_told_otherwise) {
    const Look asked = Look::open(file("trilinear.clf"));
    EXPECT_TRUE(asked.is_table());
    EXPECT_EQ(asked.interpolation(), Interpolation::trilinear);
    EXPECT_EQ(
        largest_difference(asked.exact(), Transform::of(asked.table().lut, asked.interpolation())),
        0);
    EXPECT_LT(largest_difference(asked.exact(), open_in_ocio(file("trilinear.clf"))), 5e-7);
    const Look told =
        Look::open(file("trilinear.clf"), {.interpolation = Interpolation::tetrahedral});
    EXPECT_EQ(told.interpolation(), Interpolation::tetrahedral);
    EXPECT_GT(largest_difference(asked.exact(), told.exact()), 0.01);
}

TEST(Look, has_a_reference_that_reads_the_users_own_bytes) {
    const Lut lut = looks_of_every_shape(9)[0].lut;
    const Look look = Look::of_bytes(write_cube(lut, CubeDialect::adobe), "x.cube");
    const LookReference reference = look.reference(Interpolation::trilinear);
    EXPECT_EQ(reference.name.rfind("OpenColorIO 2", 0), 0U) << reference.name;
    EXPECT_EQ(reference.refusal, "");
    EXPECT_EQ(reference.look.precision(), Precision::float32);
    EXPECT_LT(largest_difference(reference.look, Transform::of(lut, Interpolation::trilinear)),
              5e-7);
}

TEST(Look, has_a_reference_of_what_lutlib_read_where_opencolorio_cannot_read_so_and_says_why) {
    const Look picture = Look::of_bytes(picture_of("piccolo", 16), "x.png");
    EXPECT_NE(picture.reference(Interpolation::tetrahedral).refusal, "");
    const Look trilinear = Look::open(file("trilinear.clf"));
    EXPECT_EQ(trilinear.reference(Interpolation::trilinear).refusal, "");
    const LookReference other = trilinear.reference(Interpolation::tetrahedral);
    EXPECT_NE(other.refusal.find("asks for trilinear"), std::string::npos) << other.refusal;
    EXPECT_LT(largest_difference(other.look,
                                 Transform::of(trilinear.table().lut, Interpolation::tetrahedral)),
              5e-7);
}

TEST(Look, is_its_own_reference_where_opencolorio_knows_nothing) {
    const Look recipe = Look::of_bytes(R"({"schema_version": 1})", "x.json");
    EXPECT_EQ(recipe.reference(Interpolation::tetrahedral).look.precision(), Precision::float64);
    const Look nearest =
        Look::of_bytes(write_cube(looks_of_every_shape(9)[0].lut, CubeDialect::adobe), "x.cube");
    EXPECT_EQ(nearest.reference(Interpolation::nearest).look.precision(), Precision::float64);
}

TEST(Look, of_a_picture_knows_its_layout_its_engine_and_its_codes) {
    const std::string bytes = picture_of("godot", 16);
    const Look look = Look::of_bytes(bytes, "x.png");
    ASSERT_TRUE(look.kind().layout);
    EXPECT_EQ(look.kind().engine, engine_named("godot"));
    EXPECT_EQ(look.kind().layout->name, engine_named("godot")->layout);
    const auto picture = look.picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->size, 16);
    EXPECT_EQ(picture->codes.samples, code_picture(read_png(bytes, "x.png")).samples);
    EXPECT_FALSE(Look::open(file("trilinear.clf")).picture());
}

TEST(Look, as_a_recipe_is_the_base_of_an_empty_one) {
    const Look look = Look::open(file("trilinear.clf"));
    const Recipe recipe = look.as_recipe();
    EXPECT_TRUE(recipe.operations.empty());
    EXPECT_EQ(recipe.base, file("trilinear.clf"));
    EXPECT_LT(largest_difference(Transform::of(recipe), look.exact()), 1e-7);
}

TEST(OpenIfLook, takes_what_is_a_look_by_content_or_says_so_by_its_name) {
    const ScratchFolder folder;
    write_file(folder.file("base.cube"), curve_text);
    write_file(folder.file("recipe.txt"), recipe_text);
    write_file(folder.file("bad.cube"), "LUT_3D_SIZE 2\n0 0 zero\n");
    write_file(folder.file("bad.json"), R"({"schema_version": 99})");
    write_file(folder.file("notes.txt"), "Bring milk.\n");
    write_file(folder.file("settings.json"), R"({"window": {"width": 640}})");
    write_file(folder.file("strip.png"), picture_of("piccolo", 16));
    PngImage photo;
    photo.width = photo.height = 3;
    photo.samples.assign(27, 100);
    write_file(folder.file("photo.png"), write_png(photo));
    EXPECT_TRUE(Look::open_if_look(folder.file("base.cube")));
    EXPECT_TRUE(Look::open_if_look(folder.file("recipe.txt")));
    EXPECT_TRUE(Look::open_if_look(folder.file("strip.png")));
    EXPECT_FALSE(Look::open_if_look(folder.file("notes.txt")));
    EXPECT_FALSE(Look::open_if_look(folder.file("photo.png")));
    EXPECT_FALSE(Look::open_if_look(folder.file("settings.json")));
    EXPECT_THROW(Look::open_if_look(folder.file("bad.cube")), Error);
    EXPECT_THROW(Look::open_if_look(folder.file("bad.json")), Error);
    EXPECT_THROW(Look::open_if_look(folder.file("missing.cube")), Error);
}

constexpr const char* log_text = "# Input encoding: logc3\n# Output encoding: srgb\n"
                                 "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n";

TEST(LookEncodings, come_from_the_file_and_the_options_override_them) {
    const Look plain = Look::of_bytes(log_text, "x.cube");
    EXPECT_EQ(plain.encodings(), (LookEncodings{encoding_named("logc3"), srgb()}));
    const Look said =
        Look::of_bytes(log_text, "x.cube", {.encodings = {encoding_named("slog3"), std::nullopt}});
    EXPECT_EQ(said.encodings(), (LookEncodings{encoding_named("slog3"), srgb()}));
    EXPECT_EQ(said.table().lut->encodings, (EncodingNames{"slog3", "srgb"}));
    EXPECT_EQ(Look::of_bytes(curve_text, "x.cube").encodings(), (LookEncodings{}));
}

TEST(LookEncodings, that_nobody_knows_are_said_and_kept) {
    const Look look =
        Look::of_bytes("# Input encoding: klog9\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n", "x.cube");
    EXPECT_FALSE(look.encodings().input);
    ASSERT_EQ(look.files().front().remarks.size(), 1U);
    EXPECT_NE(look.files().front().remarks[0].find("klog9"), std::string::npos);
    EXPECT_EQ(look.table().lut->encodings.input, "klog9");
}

class EncodingsInFormat : public testing::TestWithParam<const FileFormat*> {};
INSTANTIATE_TEST_SUITE_P(Formats, EncodingsInFormat,
                         testing::ValuesIn(file_formats().begin(), file_formats().end()),
                         [](const auto& row) { return support::test_name(row.param->name); });

TEST_P(EncodingsInFormat, are_read_back_or_reported_lost) {
    const FileFormat& format = *GetParam();
    if (!format.write || !format.read) {
        GTEST_SKIP() << "read or written only";
    }
    Lut lut;
    lut.cube = identity_cube(format.holds.cube ? 16 : 2);
    if (!format.holds.cube) {
        lut = read_cube(curve_text, "x.cube");
        lut.keywords.clear();
    }
    lut.encodings = {"logc3", "gamma24/rec709"};
    const Encoded written = encode_lut(lut, format);
    const bool lost =
        std::any_of(written.losses.begin(), written.losses.end(),
                    [](const Loss& loss) { return loss.what.find("logc3") != std::string::npos; });
    const EncodingNames read =
        decode_lut(written.bytes, "x." + format.extensions.first(), {}, format.name).lut.encodings;
    EXPECT_EQ(read, format.holds.encodings ? lut.encodings : EncodingNames{});
    EXPECT_EQ(lost, !format.holds.encodings);
}

TEST(LookEncodings, of_a_baked_picture_are_its_own_and_the_looks) {
    const Bake baked = bake(test_looks()[1].transform(), *engine_named("unity"), 32, 8);
    const std::string png = picture_bytes(baked, {.source = "x.cube",
                                                  .title = "",
                                                  .interpolation = "tetrahedral",
                                                  .encodings = {"srgb", "srgb"},
                                                  .look = {"logc3", "srgb"}});
    EXPECT_EQ(Look::of_bytes(png, "x.png").encodings(), (LookEncodings{srgb(), srgb()}));
    EXPECT_EQ(look_encodings_of(read_png(png, "x.png")), (EncodingNames{"logc3", "srgb"}));
}

} // namespace
} // namespace lutlib::io
