// A look on its way from a file to what a lookup reads, without a GPU.
#include "lutlib/bake/bake.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/png.h"
#include "preview/look/look_file.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace preview {
namespace {

const std::string looks_folder = LUT_LOOKS_FOLDER;

constexpr const char* swapping_cube = "TITLE \"red and blue change places\"\n"
                                      "LUT_3D_SIZE 2\n"
                                      "0 0 0\n0 0 1\n0 1 0\n0 1 1\n"
                                      "1 0 0\n1 0 1\n1 1 0\n1 1 1\n";

/// What the call throws, as text; empty when it throws nothing.
template <class Error>
std::string thrown(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

class LookFileTest : public testing::Test {
  protected:
    std::string file(const std::string& name, std::string_view bytes) const {
        lutlib::io::write_file(scratch_.file(name), bytes);
        return scratch_.file(name);
    }

  private:
    lutlib::ScratchFolder scratch_;
};

TEST_F(LookFileTest, none_and_nothing_are_no_look) {
    for (const char* path : {"none", ""}) {
        const LoadedLook look = load_look(path, {});
        EXPECT_EQ(look.skip_reason, "there is none") << path;
        EXPECT_EQ(look.table, nullptr) << path;
    }
}

TEST_F(LookFileTest, a_cube_is_read_as_it_asks_for_from_its_own_float_table) {
    const LoadedLook look = load_look(file("swap.cube", swapping_cube), {});
    EXPECT_EQ(look.skip_reason, "");
    ASSERT_NE(look.table, nullptr);
    EXPECT_EQ(look.table->cube->size, 2);
    EXPECT_EQ(look.data.lookup->source, GpuLookup::Source::table);
    EXPECT_EQ(look.data.lookup, &table_lookup(*look.table));
    EXPECT_EQ(look.data.volume.desc.width, 2U);
    EXPECT_EQ(look.data.picture.bytes.size(), 0U);
}

TEST_F(LookFileTest, the_lookup_that_is_asked_for_reads_it) {
    const GpuLookup& nearest = *gpu_lookup_named("nearest");
    EXPECT_EQ(load_look(file("swap.cube", swapping_cube), {.lookup = &nearest}).data.lookup,
              &nearest);
}

TEST_F(LookFileTest, a_look_that_does_nothing_is_left_out_and_says_why) {
    const LoadedLook look = load_look(
        file("identity.cube", "LUT_3D_SIZE 2\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n"
                              "1 1 1\n"),
        {});
    EXPECT_NE(look.skip_reason, "");
    EXPECT_NE(look.table, nullptr);
}

TEST_F(LookFileTest, a_strip_is_read_through_its_own_texels) {
    const LoadedLook look = load_look(looks_folder + "/warm_teal.png", {});
    EXPECT_EQ(look.data.lookup->name, "strip");
    const auto picture = lutlib::io::Look::open(looks_folder + "/warm_teal.png").picture();
    ASSERT_TRUE(picture);
    EXPECT_EQ(look.data.block.size, picture->size);
    EXPECT_EQ(look.data.picture.desc.width, static_cast<std::uint32_t>(picture->codes.width));
    EXPECT_EQ(look.data.picture.desc.height, static_cast<std::uint32_t>(picture->codes.height));
}

TEST_F(LookFileTest, an_engine_gets_a_pictures_codes_as_they_are) {
    const std::string path = looks_folder + "/warm_teal.png";
    const auto picture = lutlib::io::Look::open(path).picture();
    ASSERT_TRUE(picture);
    const GpuLookup& unreal = *gpu_lookup_named("unreal");
    const LookData expected = look_data(picture->codes, picture->size, unreal);
    EXPECT_EQ(load_look(path, {.lookup = &unreal}).data.picture.bytes, expected.picture.bytes);
}

TEST_F(LookFileTest, an_engine_gets_of_a_table_what_lutconv_bakes) {
    const std::string path = file("swap.cube", swapping_cube);
    const GpuLookup& unity = *gpu_lookup_named("unity");
    const lutlib::Engine& engine = *unity.engine;
    const lutlib::Bake baked = lutlib::bake(lutlib::io::Look::open(path).exact(), engine,
                                            engine.default_size, engine.default_bits);
    EXPECT_EQ(load_look(path, {.lookup = &unity}).data.picture.bytes,
              look_data(baked.picture, baked.size, unity).picture.bytes);
}

TEST_F(LookFileTest, a_picture_in_a_layout_that_the_lookup_does_not_read_says_what_to_do) {
    const GpuLookup& hald =
        *std::find_if(gpu_lookups().begin(), gpu_lookups().end(), [](const GpuLookup& row) {
            return row.source == GpuLookup::Source::picture && row.layout != "strip";
        });
    const std::string message = thrown<lutlib::UsageError>(
        [&] { load_look(looks_folder + "/warm_teal.png", {.lookup = &hald}); });
    for (const std::string& part : {std::string(hald.name), std::string(hald.layout),
                                    std::string("'strip'"), std::string("lutconv")}) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
}

TEST_F(LookFileTest, a_recipe_becomes_a_table_whose_error_was_measured) {
    const LoadedLook look = load_look(looks_folder + "/warm_teal.json", {});
    EXPECT_EQ(look.data.lookup->source, GpuLookup::Source::table);
    ASSERT_NE(look.table, nullptr);
    EXPECT_NE(look.note, "");
}

TEST_F(LookFileTest, what_a_file_says_and_nobody_acts_on_is_told) {
    const LoadedLook look =
        load_look(file("odd.cube", "LUT_IN_VIDEO_RANGE\n" + std::string(swapping_cube)), {});
    ASSERT_FALSE(look.told.empty());
    EXPECT_NE(look.told.front().find("LUT_IN_VIDEO_RANGE"), std::string::npos) << look.told.front();
    const LookUse known{.encodings = {lutlib::srgb(), lutlib::srgb()}};
    EXPECT_TRUE(load_look(file("plain.cube", swapping_cube), known).told.empty());
}

TEST_F(LookFileTest, a_file_that_is_missing_or_damaged_is_named_with_its_line) {
    const std::string missing = thrown<lutlib::Error>([] { load_look("/no/such/look.cube", {}); });
    EXPECT_NE(missing.find("/no/such/look.cube"), std::string::npos) << missing;
    const std::string path =
        file("damaged.cube", "LUT_3D_SIZE 2\n0 0 0\nzero 0 1\n0 1 0\n0 1 1\n1 0 0\n"
                             "1 0 1\n1 1 0\n1 1 1\n");
    const std::string damaged = thrown<lutlib::Error>([&] { load_look(path, {}); });
    EXPECT_NE(damaged.find(path + ":3"), std::string::npos) << damaged;
}

} // namespace
} // namespace preview
