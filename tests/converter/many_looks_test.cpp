// Several looks, and several engines, through bake, convert, verify and check.
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace converter_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class ManyLooks : public testing::Test {
  protected:
    ManyLooks() {
        fs::create_directory(folder_.path("looks"));
        folder_.write("looks/a.cube", saturated_cube(9));
        folder_.write("looks/b.cube", saturated_cube(5));
        folder_.write("looks/notes.txt", "x");
    }

    Folder folder_;
    std::string looks_ = folder_.path("looks");
    std::string a_ = folder_.path("looks/a.cube");
};

TEST_F(ManyLooks, are_baked_for_each_engine_as_one_by_one) {
    const std::string out = folder_.path("out/{name}.{engine}.png");
    const Result all = lutconv({"bake", looks_, "--engine", "unity,Unreal", "-o", out});
    ASSERT_EQ(all.exit_code, 0) << all.err;
    EXPECT_NE(all.err.find("left out 1 file of types"), std::string::npos) << all.err;
    EXPECT_EQ(names_in(folder_.path("out")),
              (Names{"a.unity.png", "a.unreal.png", "b.unity.png", "b.unreal.png"}));
    const std::string one = folder_.path("one.png");
    ASSERT_EQ(lutconv({"bake", a_, "--engine", "unreal", "-o", one}).exit_code, 0);
    EXPECT_EQ(contents(one), contents(folder_.path("out/a.unreal.png")));
    EXPECT_EQ(lutconv({"bake", a_, "--engine", "unity,nobody", "-o", out}).exit_code, 3);
}

TEST_F(ManyLooks, to_one_name_are_refused_before_any_is_written) {
    for (const char* const name : {"one.png", "{name}.png"}) {
        const Result result =
            lutconv({"bake", a_, "--engine", "unity,unreal", "-o", folder_.path(name)});
        EXPECT_EQ(result.exit_code, 3);
        EXPECT_NE(result.err.find(" be written to "), std::string::npos) << result.err;
    }
    EXPECT_EQ(lutconv({"convert", looks_, "-o", "-"}).exit_code, 3);
    EXPECT_EQ(folder_.names(), (Names{"looks"}));
}

TEST_F(ManyLooks, are_converted_but_for_bad_ones) {
    folder_.write("looks/aa.cube", "LUT_3D_SIZE 2\n0 0 0\n");
    const Result result = lutconv({"convert", looks_, "-o", folder_.path("out/{name}.spi3d")});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("aa.cube"), std::string::npos) << result.err;
    EXPECT_EQ(names_in(folder_.path("out")), (Names{"a.spi3d", "b.spi3d"}));
}

TEST_F(ManyLooks, are_checked_and_repaired) {
    const Result checked = lutconv({"check", looks_});
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_NE(checked.out.find("a.cube: "), std::string::npos);
    EXPECT_NE(checked.out.find("b.cube: "), std::string::npos);
    const Result repaired =
        lutconv({"check", looks_, "--repair", "-o", folder_.path("out/{name}.cube")});
    EXPECT_EQ(repaired.exit_code, 0) << repaired.err;
    EXPECT_EQ(names_in(folder_.path("out")), (Names{"a.cube", "b.cube"}));
}

TEST_F(ManyLooks, are_verified_and_the_worst_counts) {
    const std::string out = folder_.path("out/{name}.png");
    ASSERT_EQ(lutconv({"bake", looks_, "-o", out}).exit_code, 0);
    const Result both = lutconv({"verify", folder_.path("out"), "--against", a_});
    EXPECT_EQ(both.exit_code, 1) << "b was not baked from a";
    EXPECT_EQ(lutconv({"verify", folder_.path("out/a.png"), "--against", a_}).exit_code, 0);
    folder_.write("out/c.png", "no picture");
    EXPECT_EQ(lutconv({"verify", folder_.path("out"), "--against", a_}).exit_code, 2);
}

} // namespace
} // namespace converter_test
