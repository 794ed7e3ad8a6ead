#include "lutlib/io/icc.h"

#include <gtest/gtest.h>

namespace lutlib::io {
namespace {

std::string number(std::size_t value) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) {
        out += static_cast<char>(value >> shift & 0xFF);
    }
    return out;
}

// A profile of one tag.
std::string profile(const std::string& tag) {
    constexpr std::size_t tag_at = 128 + 4 + 12;
    return std::string(128, '\0') + number(1) + "desc" + number(tag_at) + number(tag.size()) + tag;
}

std::string version_2(const std::string& text) {
    return profile("desc" + number(0) + number(text.size() + 1) + text + '\0');
}

std::string version_4(const std::string& text) {
    std::string wide;
    for (const char c : text) {
        wide += {'\0', c};
    }
    return profile("mluc" + number(0) + number(1) + number(12) + "enUS" + number(wide.size()) +
                   number(28) + wide);
}

TEST(IccProfile, says_its_name_in_both_versions) {
    for (const std::string name : {"sRGB IEC61966-2.1", "Display P3", "someone's monitor"}) {
        EXPECT_EQ(icc_description(version_2(name)), name);
        EXPECT_EQ(icc_description(version_4(name)), name);
    }
}

TEST(IccProfile, of_a_name_that_everybody_writes_is_an_encoding) {
    const auto name = [](const std::string& description) {
        const auto found = encoding_of_profile(version_4(description));
        return found ? found->name() : "none";
    };
    EXPECT_EQ(name("sRGB IEC61966-2.1"), "srgb");
    EXPECT_EQ(name("Display P3"), "srgb/display-p3");
    EXPECT_EQ(name("Adobe RGB (1998)"), "gamma22/adobe-rgb");
    EXPECT_EQ(name("Rec. 709 Gamma 2.4"), "gamma24");
    EXPECT_EQ(name("someone's monitor"), "none");
}

TEST(IccProfile, that_is_cut_anywhere_names_nothing_and_is_read_within_its_bytes) {
    for (const std::string& whole : {version_2("sRGB"), version_4("sRGB")}) {
        for (std::size_t size = 0; size < 140; ++size) {
            EXPECT_EQ(icc_description(whole.substr(0, size)), "");
        }
        for (std::size_t size = 140; size < whole.size(); ++size) {
            EXPECT_LE(icc_description(whole.substr(0, size)).size(), 4U);
        }
    }
}

} // namespace
} // namespace lutlib::io
