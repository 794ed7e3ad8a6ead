#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/recipe_file.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

// As O3DE's script writes it: a node for each corner, the middle of red only at (1, 0, 0).
constexpr const char* by_o3de = R"({
    "Type": "JsonSerialization",
    "Version": 1,
    "ClassName": "LookupTableAsset",
    "ClassData": {
        "Name": "LookupTable",
        "Intervals": [0, 1023],
        "Values": [0, 0, 0,
0, 0, 4095,
0, 4095, 0,
0, 4095, 4095,
2048, 0, 0,
4095, 0, 4095,
4095, 4095, 0,
4095, 4095, 4095]
    }
})";

std::string with(const std::string& before, const std::string& after) {
    std::string out = by_o3de;
    out.replace(out.find(before), before.size(), after);
    return out;
}

TEST(Azasset, holds_nodes_of_12_bits_with_blue_fastest) {
    const Lut lut = decode_lut(by_o3de, "x.azasset").lut;
    ASSERT_TRUE(lut.cube);
    EXPECT_EQ(lut.cube->size, 2);
    EXPECT_EQ(lut.cube->at(0, 0, 1), (Rgb{0, 0, 1}));
    EXPECT_FLOAT_EQ(lut.cube->at(1, 0, 0).r, 2048.0F / 4095);
    EXPECT_TRUE(lut.notes.empty());
}

TEST(Azasset, is_written_as_o3des_own_script_writes_it) {
    const Lut lut = decode_lut(by_o3de, "x.azasset").lut;
    const std::string bytes = encode_lut(lut, formats::azasset).bytes;
    EXPECT_EQ(bytes, std::string(by_o3de) + '\n');
}

TEST(Azasset, is_no_recipe_though_it_is_json) {
    EXPECT_FALSE(is_recipe(by_o3de));
    EXPECT_EQ(recognise_format(by_o3de, "x.json").name, "azasset");
}

TEST(Azasset, refuses_what_is_no_lut_of_o3des_and_says_why) {
    const auto refused = [](const std::string& bytes) {
        try {
            decode_lut(bytes, "x.azasset", {}, "azasset");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    EXPECT_NE(refused(with("2048, 0, 0,\n", "")).find("need 24 values, it has 21"),
              std::string::npos);
    EXPECT_NE(refused(with("2048", "4096")).find("4096 is no code"), std::string::npos);
    EXPECT_NE(refused(with("2048", "\"a\"")).find("is no code"), std::string::npos);
    EXPECT_NE(refused(with("LookupTableAsset", "Material")).find("ClassName"), std::string::npos);
    EXPECT_NE(refused(with("Intervals", "Interval")).find("Intervals"), std::string::npos);
    EXPECT_NE(refused(with("2048,", "2048")).find("x.azasset:12"), std::string::npos)
        << refused(with("2048,", "2048"));
}

TEST(Azasset, with_uneven_intervals_says_that_they_are_taken_for_even) {
    const Lut lut = decode_lut(with("[0, 1023]", "[0, 512]"), "x.azasset").lut;
    ASSERT_EQ(lut.notes.size(), 1U);
    EXPECT_NE(lut.notes[0].find("not even"), std::string::npos);
}

} // namespace
} // namespace lutlib::io
