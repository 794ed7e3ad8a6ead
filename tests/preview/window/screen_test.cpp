// What the window does when the GPU is lost, short of losing one.
#include "lutlib/error.h"
#include "preview/window/screen.h"

#include <gtest/gtest.h>

namespace preview {
namespace {

TEST(Recovery, tries_again_once_and_tells_what_was_wrong) {
    Recovery recovery;
    const vk::DeviceLostError lost("vkQueueSubmit2");
    EXPECT_NE(recovery.lost(lost).find("vkQueueSubmit2"), std::string::npos);
    for (int frame = 1; frame < Recovery::frames_of_proof; ++frame) {
        recovery.drew();
    }
    EXPECT_THROW(recovery.lost(lost), lutlib::Error);
}

TEST(Recovery, trusts_a_screen_that_has_drawn_enough) {
    Recovery recovery;
    const vk::DeviceLostError lost("vkQueueSubmit2");
    for (int times = 0; times < 3; ++times) {
        EXPECT_NO_THROW(recovery.lost(lost));
        for (int frame = 0; frame < Recovery::frames_of_proof; ++frame) {
            recovery.drew();
        }
    }
}

TEST(Recovery, is_for_lost_devices_and_surfaces_only) {
    EXPECT_TRUE(is_lost(vk::DeviceLostError("")));
    EXPECT_TRUE(is_lost(vk::SurfaceLostKHRError("")));
    EXPECT_FALSE(is_lost(vk::OutOfDeviceMemoryError("")));
    EXPECT_FALSE(is_lost(vk::OutOfHostMemoryError("")));
}

} // namespace
} // namespace preview
