// The rows of curves and gamuts against OpenColorIO's built-in transforms, through configs like a
// user's.
#include "lutlib/color/encoding.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/ocio.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <random>

namespace lutlib::io {
namespace {

// A config whose space "other" lies one built-in transform behind the space "reference".
std::string config_of(const std::string& style) {
    return R"(ocio_profile_version: 2
roles:
  default: reference
displays:
  Screen:
    - !<View> {name: Straight, colorspace: other}
    - !<View> {name: None, colorspace: reference}
colorspaces:
  - !<ColorSpace>
    name: reference
  - !<ColorSpace>
    name: other
    from_scene_reference: !<BuiltinTransform> {style: ")" +
           style + R"("}
)";
}

struct Builtin {
    const char* style;
    const char *from, *to; ///< the encodings between which it converts
    const Adaptation* adaptation;
    /// What its own arithmetic leaves, relative to 1 + the value: tables of 4096 entries for Canon.
    double tolerance;
    double lowest = -any_light; ///< what it clamps its result to
};

void PrintTo(const Builtin& row, std::ostream* out) {
    *out << row.style;
}

const Builtin builtins[] = {
    {"ACEScct_to_ACES2065-1", "acescct", "linear/ap0", &bradford, 1e-5},
    {"ACEScc_to_ACES2065-1", "acescc", "linear/ap0", &bradford, 1e-5, 0},
    {"ACEScg_to_ACES2065-1", "linear/ap1", "linear/ap0", &bradford, 1e-6},
    {"UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", "linear/ap1", "linear", &bradford, 1e-6},
    {"ARRI_ALEXA-LOGC-EI800-AWG_to_ACES2065-1", "logc3", "linear/ap0", &cat02, 1e-5},
    {"CANON_CLOG2-CGAMUT_to_ACES2065-1", "clog2", "linear/ap0", &cat02, 5e-5},
    {"CANON_CLOG3-CGAMUT_to_ACES2065-1", "clog3", "linear/ap0", &cat02, 5e-5},
    {"PANASONIC_VLOG-VGAMUT_to_ACES2065-1", "vlog", "linear/ap0", &bradford, 1e-5},
    {"RED_LOG3G10-RWG_to_ACES2065-1", "log3g10", "linear/ap0", &bradford, 1e-5},
    {"SONY_SLOG3-SGAMUT3_to_ACES2065-1", "slog3/sgamut3", "linear/ap0", &cat02, 1e-5},
    {"SONY_SLOG3-SGAMUT3.CINE_to_ACES2065-1", "slog3", "linear/ap0", &cat02, 1e-5},
    {"CURVE - ST-2084_to_LINEAR", "pq", "linear/rec2020", &bradford, 1e-4},
    {"CURVE - LINEAR_to_ST-2084", "linear/rec2020", "pq", &bradford, 1e-4},
};

class EveryBuiltin : public testing::TestWithParam<Builtin> {};
INSTANTIATE_TEST_SUITE_P(Ocio, EveryBuiltin, testing::ValuesIn(builtins), [](const auto& row) {
    std::string out(row.param.style);
    std::replace_if(
        out.begin(), out.end(), [](char c) { return !std::isalnum(c); }, '_');
    return out;
});

Transform builtin(const std::string& style, const std::string& from = "reference",
                  const std::string& to = "other") {
    const ScratchFolder scratch;
    write_file(scratch.file("c.ocio"), config_of(style));
    return ocio().from_config({scratch.file("c.ocio"), from, to, "", ""});
}

std::vector<Rgb> codes(int count) {
    std::vector<Rgb> out;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> code(0, 1);
    for (int i = 0; i < count; ++i) {
        out.push_back({code(random), code(random), code(random)});
    }
    return out;
}

TEST_P(EveryBuiltin, converts_as_our_rows_do) {
    const Builtin& row = GetParam();
    const Encoding from = require_encoding(row.from), to = require_encoding(row.to);
    const Matrix3 m = light_to_light(from, to, *row.adaptation);
    const std::vector<Rgb> in = codes(20000);
    const std::vector<RgbD> theirs = images_of(builtin(row.style), in);
    for (std::size_t i = 0; i < in.size(); ++i) {
        const RgbD c = to_double(in[i]);
        const RgbD light = m * RgbD{from.decode(c.r), from.decode(c.g), from.decode(c.b)};
        RgbD want{to.encode(light.r), to.encode(light.g), to.encode(light.b)};
        for (std::size_t k = 0; k < 3; ++k) {
            want[k] = std::max(want[k], row.lowest);
        }
        ASSERT_LT(largest_magnitude(theirs[i] - want),
                  row.tolerance * (1 + largest_magnitude(want)))
            << in[i].r << ' ' << in[i].g << ' ' << in[i].b << " -> " << theirs[i].r << ' '
            << theirs[i].g << ' ' << theirs[i].b << ", not " << want.r << ' ' << want.g << ' '
            << want.b;
    }
}

struct Display {
    const char* style;
    const char* encoding;
};

// All from CIE XYZ under D65, 1 at 100 cd/m2.
constexpr Display displays[] = {
    {"DISPLAY - CIE-XYZ-D65_to_sRGB", "srgb"},
    {"DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.709", "gamma24"},
    {"DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.2020", "gamma24/rec2020"},
    {"DISPLAY - CIE-XYZ-D65_to_G2.2-REC.709", "gamma22"},
    {"DISPLAY - CIE-XYZ-D65_to_G2.6-P3-DCI-BFD", "gamma26"},
    {"DISPLAY - CIE-XYZ-D65_to_G2.6-P3-D65", "gamma26/p3-d65"},
    {"DISPLAY - CIE-XYZ-D65_to_REC.2100-PQ", "pq"},
};

TEST(Ocio, displays_colors_as_our_rows_do) {
    for (const Display& row : displays) {
        const Encoding to = require_encoding(row.encoding);
        const Matrix3 to_xyz =
            adapted(to.primaries().white, white_d65) * rgb_to_xyz(to.primaries());
        std::vector<RgbD> theirs;
        const std::vector<Rgb> lights = codes(5000);
        for (const Rgb& light : lights) {
            theirs.push_back(to_xyz * to_double(light));
        }
        builtin(row.style)(theirs);
        double worst = 0;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const RgbD c = to_double(lights[i]);
            const RgbD want{to.encode(c.r), to.encode(c.g), to.encode(c.b)};
            worst = std::max(worst, largest_magnitude(theirs[i] - want));
        }
        EXPECT_LT(worst, 2e-4) << row.style; // where light of 1e-5 and less meets a power
    }
}

TEST(Ocio, encodes_hlg_as_our_row_does_but_for_a_displays_system_gamma) {
    // BT.2100: a display of 1000 cd/m2 has a system gamma of 1.2, which neutrals undo by a power.
    const Transform theirs = builtin("DISPLAY - CIE-XYZ-D65_to_REC.2100-HLG-1000nit");
    const Encoding hlg = require_encoding("hlg");
    const double full = hlg.decode(1);
    for (int i = 1; i <= 100; ++i) {
        const double nits = 10.0 * i;
        const RgbD c = theirs(xyz_of(white_d65) * (nits / 100));
        EXPECT_NEAR(c.g, hlg.encode(full * std::pow(nits / 1000, 1 / 1.2)), 1e-4) << nits;
    }
}

std::string refusal(const ConfigConversion& conversion) {
    try {
        ocio().from_config(conversion);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Ocio, takes_a_users_config_by_spaces_or_by_display_and_says_what_it_lacks) {
    const ScratchFolder scratch;
    const std::string file = scratch.file("c.ocio");
    write_file(file, config_of("DISPLAY - CIE-XYZ-D65_to_sRGB"));
    const RgbD in{.25, .5, .125};
    const RgbD by_spaces = ocio().from_config({file, "reference", "other", "", ""})(in);
    EXPECT_EQ(ocio().from_config({file, "default", "", "Screen", ""})(in), by_spaces);
    EXPECT_EQ(ocio().from_config({file, "reference", "", "Screen", "None"})(in), in);
    EXPECT_NE(by_spaces, in);
    const auto says = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    says(refusal({file, "absent", "other", "", ""}),
         "there is no colour space 'absent'; there are reference, other");
    says(refusal({file, "other", "", "Wall", ""}), "there is no display 'Wall'; there is Screen");
    says(refusal({file, "other", "", "Screen", "Odd"}),
         "there is no view of Screen 'Odd'; there are Straight");
    says(refusal({scratch.file("none.ocio"), "a", "b", "", ""}), "none.ocio");
    if (ocio().version() < "2.2") {
        says(refusal({"ocio://default", "a", "b", "", ""}), "name a .ocio file");
    }
}

} // namespace
} // namespace lutlib::io
