// The look made ready for a file: what is said to be lost is what is lost.
#include "lutlib/error.h"
#include "preview/editor/commands.h"
#include "preview/editor/look_export.h"
#include "tests/preview/editor/look_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace preview::editor {
namespace {

using lutlib::ScratchFolder;

/// On a look of 65 nodes a side that bends at every other one.
State bent_state() {
    auto lut = std::make_shared<lutlib::Lut>();
    lut->cube = lutlib::identity_cube(65);
    std::size_t i = 0;
    for (lutlib::Rgb& node : lut->cube->nodes) {
        const double bend = i++ % 65 % 2 == 1 ? 0.01 : 0;
        node.r = static_cast<float>(static_cast<double>(node.r) * 0.9 + bend);
    }
    State state = initial_state();
    state.recipe.base_lut = std::move(lut);
    return state;
}

TEST(LookExport, says_what_fewer_nodes_lose_and_how_far_the_file_is_from_the_look) {
    const ScratchFolder folder;
    const State state = bent_state();
    const PreparedExport own = prepare_lut(state, {}, folder.file("own.cube"));
    EXPECT_FALSE(own.loses) << own.report;
    EXPECT_NE(own.report.find("nothing is lost"), std::string::npos);
    const PreparedExport half = prepare_lut(state, {.size = 33}, folder.file("half.cube"));
    EXPECT_TRUE(half.loses);
    EXPECT_EQ(half.report.find("nothing is lost"), std::string::npos) << half.report;
    // At a node that is left out the neighbours' mean stands in place of 0.01 more.
    EXPECT_NE(half.report.find("largest seen 0.01 "), std::string::npos) << half.report;
    EXPECT_FALSE(std::filesystem::exists(half.path)) << "nobody has said that it is to be written";
    write(half);
    const lutlib::io::Look read = lutlib::io::Look::open(half.path);
    EXPECT_EQ(read.table().lut->cube->size, 33);
    const lutlib::RgbD in{1.0 / 64, 0, 0};
    EXPECT_NEAR(std::abs(read.exact()(in).r - lutlib::Transform::of(state.recipe)(in).r), 0.01,
                1e-5);
}

TEST(LookExport, between_other_encodings_is_the_look_with_its_conversions) {
    const ScratchFolder folder;
    State state = initial_state();
    add_operation(state.recipe, *lutlib::op_named("exposure"));
    state.recipe.operations[0].values[0] = 0.5;
    const auto log = lutlib::encoding_named("logc3/rec709");
    const PreparedExport made =
        prepare_lut(state, {.size = 65, .encodings = {log, {}}}, folder.file("log.cube"));
    EXPECT_NE(made.report.find("is converted to srgb before the look"), std::string::npos)
        << made.report;
    EXPECT_TRUE(made.loses) << "a lattice is between its nodes not the look";
    write(made);
    const lutlib::io::Look read = lutlib::io::Look::open(made.path);
    EXPECT_EQ(read.encodings().input, log);
    // A node: the code of LogC3 as light, as sRGB's code, through the look.
    const double code = 26.0 / 64;
    const double light = log->decode(code);
    const double srgb = lutlib::srgb().encode(light);
    const lutlib::RgbD expected = lutlib::Transform::of(state.recipe)({srgb, srgb, srgb});
    EXPECT_NEAR(read.exact()({code, code, code}).g, expected.g, 1e-5);
}

TEST(LookExport, of_a_strip_has_the_engines_sizes_and_bits_or_those_that_are_chosen) {
    const ScratchFolder folder;
    const State state = bent_state();
    const lutlib::Engine& unity = *lutlib::engine_named("unity");
    const PreparedExport usual = prepare_strip(state, unity, {}, folder.file("usual.png"));
    EXPECT_TRUE(usual.loses) << "8 bits";
    EXPECT_NE(usual.report.find("max"), std::string::npos);
    Side side;
    side.engine = gpu_lookup_named("unity");
    EXPECT_EQ(usual.report, export_strip(state, side, usual.path));
    for (const lutlib::Engine& engine : lutlib::engines()) {
        if (engine.bits.size() > 1) {
            const auto made = [&](int bits) {
                return prepare_strip(state, engine, {.bits = bits}, folder.file("x.png")).bytes;
            };
            EXPECT_LT(made(8).size(), made(16).size()) << engine.name;
        }
    }
    EXPECT_THROW(prepare_strip(state, unity, {.bits = 16}, "x.png"), lutlib::UsageError);
    EXPECT_THROW(prepare_strip(state, unity, {.size = 1000}, "x.png"), lutlib::Error);
}

} // namespace
} // namespace preview::editor
