// A scope's counts as a table.
#include "preview/finish/scope_csv.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace preview {
namespace {

TEST(ScopeCsv, of_columns_has_a_row_for_each_place_that_has_any) {
    const Scope& parade = scopes[1];
    std::vector<std::uint32_t> counts(scope_counts(parade, 2));
    counts[255] = 7;                    // red, first column
    counts[(2 * 2 + 1) * 256 + 51] = 3; // blue, second
    EXPECT_EQ(scope_csv(parade, counts, {}), "channel,column,level,value (%),count\n"
                                             "red,0,255,100,7\n"
                                             "blue,1,51,20,3\n");
    const ScopeLevels pq{*lutlib::encoding_named("pq")};
    EXPECT_EQ(scope_csv(parade, counts, pq), "channel,column,level,value (cd/m2),count\n"
                                             "red,0,255,10000,7\n"
                                             "blue,1,51,2.42926,3\n");
}

TEST(ScopeCsv, of_luma_says_so) {
    std::vector<std::uint32_t> counts(scope_counts(scopes[0], 1));
    counts[0] = 1;
    EXPECT_EQ(scope_csv(scopes[0], counts, {}),
              "channel,column,level,value (%),count\nluma,0,0,0,1\n");
}

TEST(ScopeCsv, of_a_vectorscope_has_cb_and_cr_about_128) {
    std::vector<std::uint32_t> counts(scope_counts(scopes[3], 0));
    counts[200 * 256 + 128] = 5;
    EXPECT_EQ(scope_csv(scopes[3], counts, {}), "cb,cr,count\n128,200,5\n");
}

TEST(ScopeCsv, of_a_histogram_has_every_level) {
    std::vector<std::uint32_t> counts(scope_counts(scopes[4], 0));
    counts[3 * 256 + 255] = 9;
    const ScopeLevels linear{*lutlib::encoding_named("linear")};
    const std::string text = scope_csv(scopes[4], counts, linear);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 257);
    EXPECT_TRUE(
        text.starts_with("level,value (of diffuse white),red,green,blue,luma\n0,0,0,0,0,0\n"))
        << text.substr(0, 100);
    EXPECT_TRUE(text.ends_with("\n255,1,0,0,0,9\n"));
}

} // namespace
} // namespace preview
