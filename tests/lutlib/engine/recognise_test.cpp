#include "lutlib/engine/recognise.h"

#include "lutlib/error.h"
#include "lutlib/recipe/recipe.h"
#include "lutlib/transform.h"
#include "tests/lutlib/engine/rude_looks.h"
#include "tests/lutlib/looks.h"
#include "tests/support/names.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

namespace lutlib {
namespace {

/// The look at the nodes, in codes of 8 bits.
Lut3D coded(const std::function<RgbD(RgbD)>& look, int size) {
    Lut3D cube = identity_cube(size);
    for (Rgb& node : cube.nodes) {
        const RgbD value = saturate(look(to_double(node))) * 255.0;
        node = to_float(RgbD{std::round(value.r), std::round(value.g), std::round(value.b)} *
                        (1.0 / 255));
    }
    return cube;
}

struct Tally {
    int right = 0, refused = 0;
    double share_refused() const { return refused / static_cast<double>(right + refused); }
};

// Counts a picture of a known layout; whatever is read must be the lattice that was laid out.
void count(const Picture& picture, const Layout& layout, int size, const std::string& what,
           Tally& tally) {
    const std::vector<Recognition> readings = recognise(picture);
    const Recognition* const shown = shown_by_content(readings);
    if (!shown) {
        ++tally.refused;
        return;
    }
    ++tally.right;
    EXPECT_TRUE(shown->layout == &layout || from_picture(picture, *shown->layout, shown->size) ==
                                                from_picture(picture, layout, size))
        << what << " of " << size << " in " << layout.name << " is read as " << shown->layout->name
        << " of " << shown->size;
}

class RecogniseSize : public testing::TestWithParam<int> {};
const std::vector<int> sizes =
    support::is_sanitized ? std::vector{8, 16, 25} : std::vector{8, 16, 25, 32, 33, 64};
INSTANTIATE_TEST_SUITE_P(Sizes, RecogniseSize, testing::ValuesIn(sizes),
                         testing::PrintToStringParamName());

// Every rude look in every layout, as it is and through JPEG of two qualities (of one at
// sizes beyond 16): none is misread, and of those that have hues few are refused.
TEST_P(RecogniseSize, misreads_no_look_in_any_layout) {
    if (support::is_too_long_here()) {
        GTEST_SKIP() << "takes minutes under sanitizers";
    }
    const int n = GetParam();
    const std::vector<int> qualities = n <= 16 ? std::vector<int>{90, 60} : std::vector<int>{75};
    Tally with_hues, without;
    // Large pictures take longest, and tell their layout best.
    const std::size_t step = support::is_thorough() || n <= 16 ? 1 : n < 64 ? 3 : 6;
    const std::vector<RudeLook> looks = rude_looks();
    for (std::size_t i = 0; i < looks.size(); i += step) {
        const RudeLook& look = looks[i];
        const Lut3D cube = coded(look.f, n);
        Tally& tally = look.has_hues ? with_hues : without;
        for (const Layout& layout : layouts()) {
            if (!layout.picture(n)) {
                continue;
            }
            const Picture picture = to_picture(cube, layout);
            count(picture, layout, n, look.name, tally);
            // The largest pictures take longest, and JPEG leaves most of them as they are.
            const bool compressed = n < 64 || look.name == "identity" || look.name == "crushed";
            for (const int quality : compressed ? qualities : std::vector<int>{}) {
                count(jpeg_compressed(picture, quality), layout, n,
                      look.name + " in JPEG of " + std::to_string(quality), tally);
            }
        }
    }
    std::cout << n << " nodes: of looks with hues " << with_hues.right << " read, "
              << with_hues.refused << " refused; without, " << without.right << " and "
              << without.refused << '\n';
    EXPECT_LE(with_hues.share_refused(), 0.12);
    EXPECT_GT(without.right, 0);
}

TEST_P(RecogniseSize, tells_every_usual_look_in_every_layout) {
    const int n = GetParam();
    for (const Layout& layout : layouts()) {
        for (const TestLook& look : test_looks()) {
            if (layout.picture(n)) {
                const Recognition found =
                    recognise_one(to_picture(sampled(look.f, n), layout), "look.png").reading;
                EXPECT_EQ(found.layout->name, layout.name) << look.name;
                EXPECT_EQ(found.size, n) << look.name;
                EXPECT_EQ(found.rows, 1);
            }
        }
    }
}

TEST(Recognise, tells_the_sample_looks_in_every_layout) {
    for (const char* const name :
         {"bleach_bypass", "hdr_domain4", "log_to_display", "soft_print", "warm_teal"}) {
        std::ostringstream text;
        text << std::ifstream(SAMPLE_LOOKS "/" + std::string(name) + ".json").rdbuf();
        const Transform edit = Transform::of(parse_recipe(text.str(), name));
        for (const int n : {16, 32}) {
            const Lut3D cube = coded([&](RgbD in) { return edit(in); }, n);
            for (const Layout& layout : layouts()) {
                if (layout.picture(n)) {
                    EXPECT_EQ(recognise_one(to_picture(cube, layout), name).reading.layout->name,
                              layout.name)
                        << name << " " << n;
                }
            }
        }
    }
}

std::string refusal_of(const Picture& picture) {
    try {
        const Recognition found = recognise_one(picture, "x.png").reading;
        return "read as " + std::string(found.layout->name) + " of " + std::to_string(found.size);
    } catch (const Error& error) {
        EXPECT_EQ(error.where().file, "x.png");
        return error.message();
    }
}

TEST(Recognise, names_candidates_and_what_decides_when_the_content_does_not_tell) {
    const Lut3D grey = coded(rude_looks()[2].f, 16);
    const std::string words = refusal_of(to_picture(grey, *layout_named("strip")));
    EXPECT_NE(words.find("--layout"), std::string::npos) << words;
    EXPECT_NE(words.find("--engine"), std::string::npos) << words;
    EXPECT_NE(words.find("strip-up of 16 nodes"), std::string::npos) << words;
    EXPECT_NE(words.find("ocio of 16 nodes"), std::string::npos) << words;
}

TEST(Recognise, follows_a_hint_where_the_content_does_not_tell) {
    const LayoutHint hint{layout_named("strip-up"), "its text names the engine unity"};
    for (const char* const name : {"black and white", "sepia", "constant", "noise"}) {
        const auto looks = rude_looks();
        const auto look = std::find_if(looks.begin(), looks.end(),
                                       [&](const RudeLook& row) { return row.name == name; });
        const Picture picture = to_picture(coded(look->f, 16), *layout_named("strip-up"));
        const Recognised found = recognise_one(picture, "x.png", hint);
        EXPECT_EQ(found.reading.layout->name, "strip-up") << name;
        EXPECT_EQ(found.contradiction, "") << name;
    }
}

// Whatever look an engine's picture holds, what bake wrote into its text is believed, unless the
// picture was turned upside down since.
TEST(Recognise, believes_the_hint_of_every_look_in_its_own_layout) {
    for (const Layout& layout : layouts()) {
        for (const RudeLook& look : rude_looks()) {
            const Picture picture = to_picture(coded(look.f, 16), layout);
            const Recognised found = recognise_one(picture, "x.png", {&layout, "it is said"});
            EXPECT_EQ(found.reading.layout->name, layout.name) << look.name;
            EXPECT_EQ(found.contradiction, "") << look.name;
        }
    }
}

TEST(Recognise, contradicts_a_hint_when_the_picture_was_flipped) {
    const LayoutHint hint{layout_named("strip-up"), "its text names the engine unity"};
    for (const RudeLook& look : rude_looks()) {
        const Picture picture = to_picture(coded(look.f, 16), *layout_named("strip"));
        if (!shown_by_content(recognise(picture))) {
            continue;
        }
        const Recognised found = recognise_one(picture, "x.png", hint);
        EXPECT_EQ(found.reading.layout->name, "strip") << look.name;
        EXPECT_NE(found.contradiction.find("its text names the engine unity"), std::string::npos);
    }
}

// What somebody does to a picture that makes it one of no layout.
Picture rearranged(const Picture& picture, bool transposed, bool mirrored) {
    Picture out{picture.width, picture.height, {}};
    if (transposed) {
        std::swap(out.width, out.height);
    }
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            const int across = mirrored ? out.width - 1 - x : x;
            out.pixels.push_back(transposed ? picture.at(y, across) : picture.at(across, y));
        }
    }
    return out;
}

TEST(Recognise, refuses_pictures_that_are_turned_or_mirrored) {
    for (const char* const layout : {"strip", "strip-vertical", "tiles", "hald"}) {
        for (const int n : {16, support::is_sanitized ? 25 : 64}) {
            const Picture picture = to_picture(coded(test_looks()[1].f, n), *layout_named(layout));
            EXPECT_EQ(refusal_of(rearranged(picture, true, false)).find("read as"),
                      std::string::npos)
                << layout << n;
            // A mirrored strip is a negative's strip with green up, and is read so, but not
            // without a word.
            if (layout == std::string("strip")) {
                const Recognised found = recognise_one(rearranged(picture, false, true), "x.png");
                EXPECT_NE(found.doubt.find("mirrored or turned"), std::string::npos) << n;
            } else {
                EXPECT_EQ(refusal_of(rearranged(picture, false, true)).find("read as"),
                          std::string::npos)
                    << layout << n;
            }
        }
    }
}

TEST(Recognise, says_of_a_negative_in_every_layout_that_it_may_be_a_picture_turned_round) {
    for (const Layout& layout : layouts()) {
        Picture picture = to_picture(coded(test_looks()[1].f, 16), layout);
        EXPECT_EQ(recognise_one(picture, "x.png").doubt, "") << layout.name;
        std::reverse(picture.pixels.begin(), picture.pixels.end());
        const Recognised found = recognise_one(picture, "x.png", {&layout, "its text says so"});
        EXPECT_NE(found.doubt.find("turned by 180 degrees"), std::string::npos) << layout.name;
    }
}

TEST(Recognise, refuses_photographs) {
    // A sky above a field, with grain.
    std::mt19937 random(3);
    std::normal_distribution<float> grain(0, 0.02F);
    for (const PictureSize extent : {PictureSize{512, 512}, {256, 16}, {16, 256}, {256, 128}}) {
        Picture photo{extent.width, extent.height, {}};
        for (int y = 0; y < extent.height; ++y) {
            for (int x = 0; x < extent.width; ++x) {
                const float down = static_cast<float>(y) / static_cast<float>(extent.height);
                const float wave = 0.1F * std::sin(static_cast<float>(x) / 40 + 9 * down);
                const Rgb ground = down < 0.5F ? Rgb{0.4F + down, 0.6F + 0.5F * down, 0.95F}
                                               : Rgb{0.3F, 0.9F - 0.6F * down, 0.15F};
                photo.pixels.push_back({ground.r + wave + grain(random), ground.g + grain(random),
                                        ground.b + wave + grain(random)});
            }
        }
        EXPECT_EQ(refusal_of(photo).find("read as"), std::string::npos)
            << extent.width << "x" << extent.height << ": " << refusal_of(photo);
    }
}

TEST(Recognise, refuses_dimensions_that_no_layout_has) {
    EXPECT_NE(refusal_of(Picture{30, 20, std::vector<Rgb>(600)}).find("no LUT layout has 30x20"),
              std::string::npos);
}

TEST(Recognise, finds_stacked_strips_among_them_a_grey_one) {
    const Layout& strip = *layout_named("strip");
    Picture three{1024, 96, {}};
    for (const std::size_t look : {0U, 2U, 16U}) {
        const Picture one = to_picture(coded(rude_looks()[look].f, 32), strip);
        three.pixels.insert(three.pixels.end(), one.pixels.begin(), one.pixels.end());
    }
    const Recognition found = recognise_one(three, "multi.png").reading;
    EXPECT_EQ(found.layout->name, "strip");
    EXPECT_EQ(found.rows, 3);
}

} // namespace
} // namespace lutlib
