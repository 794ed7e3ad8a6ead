// Pictures in boxes of other sizes.
#include "preview/finish/fit.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

TEST(Fit, keeps_proportions_within_the_box_and_is_never_nothing) {
    EXPECT_EQ(fitted({400, 200}, {100, 100}), (Size{100, 50}));
    EXPECT_EQ(fitted({200, 400}, {100, 100}), (Size{50, 100}));
    EXPECT_EQ(fitted({3, 3}, {300, 400}), (Size{300, 300}));
    EXPECT_EQ(fitted({10000, 1}, {10, 10}), (Size{10, 1}));
}

TEST(Fit, says_what_becomes_of_a_picture) {
    EXPECT_EQ(fit_text({7, 5}, {7, 5}), "");
    EXPECT_EQ(fit_text({400, 200}, {100, 50}),
              "its 400x200 pixels are shown as 100x50, to fit into 100x50");
    EXPECT_EQ(fit_text({400, 200}, {100, 80}),
              "its 400x200 pixels are shown as 100x50, to fit into "
              "100x80, with bars above and below, which figures of a difference count as equal");
    EXPECT_EQ(fit_text({2, 4}, {80, 100}),
              "its 2x4 pixels are shown as 50x100, to fit into 80x100, "
              "with bars left and right, which figures of a difference count as equal");
}

} // namespace
} // namespace preview
