// Reference stills as files have them.
#include "preview/look/still.h"

#include "lutlib/error.h"
#include "lutlib/io/image.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace preview {
namespace {

namespace io = lutlib::io;

class StillOf : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::vector<float>& rgba, io::Depth depth) {
        io::FloatImage image;
        image.width = static_cast<int>(rgba.size() / 4);
        image.height = 1;
        image.rgba = rgba;
        io::ImageWriteOptions options;
        options.depth = depth;
        static_cast<void>(io::write_image(folder_.file(name), image, options));
        return folder_.file(name);
    }
    lutlib::ScratchFolder folder_;
};

TEST_F(StillOf, codes_shows_them_as_they_are_and_says_that_it_guesses) {
    const std::vector<float> codes{0, 17 / 255.0F, 1, 1, 0.2F, 128 / 255.0F, 0.4F, 1};
    const auto still = load_still(write("a.png", codes, io::Depth::uint8));
    EXPECT_EQ(still->size, (Size{2, 1}));
    EXPECT_EQ(still->rgba, codes);
    EXPECT_EQ(still->shown_as,
              "its codes are shown as they are, a guess: its file does not say what they are");
    EXPECT_EQ(title_of(*still), "a");
}

TEST_F(StillOf, light_encodes_it_by_srgbs_curve_within_what_a_display_has) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto still = load_still(write(
        "a.exr", {0.18F, 0.5F, 2, 1, -1, nan, inf, 1, 0.18F, inf, nan, 1}, io::Depth::float32));
    const auto code = [](double light) { return lutlib::srgb().encode(light); };
    EXPECT_NEAR(still->rgba[0], code(0.18F), 1e-6);
    EXPECT_NEAR(still->rgba[1], code(0.5), 1e-6);
    EXPECT_EQ(still->rgba[2], 1);
    EXPECT_EQ(still->rgba[4], 0);
    EXPECT_EQ(still->rgba[5], 0);
    EXPECT_EQ(still->rgba[6], 1);
    EXPECT_NEAR(still->rgba[8], code(0.18F), 1e-6) << "of a channel beside infinity and NaN";
    ASSERT_EQ(still->told.size(), 3U);
    EXPECT_EQ(still->told[0], "2 pixels hold NaN, which is taken for 0");
    EXPECT_NE(still->shown_as.find("encoded by sRGB's curve without a tone map"),
              std::string::npos);
}

TEST_F(StillOf, another_encoding_that_is_named_is_converted_to_srgb) {
    const std::string path = write("a.png", {0.2F, 0.4F, 0.6F, 1}, io::Depth::uint16);
    const lutlib::Encoding logc3 = *lutlib::encoding_named("logc3");
    const auto still = load_still(path, logc3);
    const std::vector<float> plain = load_still(path)->rgba;
    lutlib::RgbD light{logc3.decode(static_cast<double>(plain[0])),
                       logc3.decode(static_cast<double>(plain[1])),
                       logc3.decode(static_cast<double>(plain[2]))};
    light = lutlib::light_to_light(logc3, lutlib::srgb()) * light;
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(still->rgba[c], std::clamp(lutlib::srgb().encode(light[c]), 0.0, 1.0), 1e-6);
    }
    EXPECT_NE(still->rgba, plain);
    EXPECT_NE(still->shown_as.find("as asked for"), std::string::npos);
    EXPECT_EQ(load_still(path, lutlib::srgb())->rgba, plain);
}

TEST_F(StillOf, what_is_no_picture_is_an_error_that_names_it) {
    const std::string path = folder_.file("absent.png");
    try {
        static_cast<void>(load_still(path));
        FAIL() << "there is none";
    } catch (const lutlib::Error& error) {
        EXPECT_NE(std::string(error.what()).find("absent.png"), std::string::npos);
    }
}

} // namespace
} // namespace preview
