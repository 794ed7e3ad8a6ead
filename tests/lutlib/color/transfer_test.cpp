#include "lutlib/color/transfer.h"

#include "lutlib/color/encoding.h"
#include "lutlib/color/powers.h"
#include "lutlib/color/transfer_constants.h"
#include "lutlib/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace lutlib {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string test_name(std::string_view name) {
    std::string out(name);
    std::replace_if(
        out.begin(), out.end(), [](char c) { return !std::isalnum(c); }, '_');
    return out;
}

class EveryEncoding : public testing::TestWithParam<Encoding> {
  protected:
    // Codes of the light that the curve keeps, as far as pictures have them.
    static double lowest() { return std::max(-1.0, GetParam().encode(GetParam().curve->darkest)); }
    static double highest() {
        return std::min(4.0, GetParam().encode(GetParam().curve->brightest));
    }
};
INSTANTIATE_TEST_SUITE_P(Transfer, EveryEncoding,
                         testing::ValuesIn(encodings().begin(), encodings().end()),
                         [](const auto& row) { return test_name(row.param.name()); });

TEST_P(EveryEncoding, comes_back_to_the_code_it_decoded) {
    // Makers publish rounded constants, whose two parts meet within 3e-6, Nikon's within 1.3e-4 of
    // the codes; PQ loses digits next to black, where its slope is infinite.
    const double gap = GetParam().name() == "nlog" ? 1.4e-4 : 3e-6;
    for (int i = 0; i <= 20000; ++i) {
        const double code = lowest() + (highest() - lowest()) * i / 20000;
        ASSERT_NEAR(GetParam().encode(GetParam().decode(code)), code, gap) << code;
    }
}

TEST_P(EveryEncoding, never_falls_in_either_direction) {
    const Encoding& e = GetParam();
    double light = -infinity, code = -infinity;
    for (int i = 0; i <= 40000; ++i) {
        const double x = -1 + 4 * i / 40000.0;
        ASSERT_GE(e.decode(x), light) << x;
        light = e.decode(x);
        const double linear = std::copysign(std::pow(std::abs(x), 3), x); // finest at black
        ASSERT_GE(e.encode(linear), code) << linear;
        code = e.encode(linear);
    }
}

TEST_P(EveryEncoding, keeps_the_light_it_says_it_keeps) {
    const Encoding& e = GetParam();
    for (const double x : {-1e9, -65504.0, -1.0, 0.0, 1.0, 65504.0, 1e9}) {
        const double kept = std::clamp(x, e.curve->darkest, e.curve->brightest);
        EXPECT_NEAR(e.decode(e.encode(x)), kept, 1e-5 + 1e-4 * std::abs(kept)) << x;
    }
}

TEST_P(EveryEncoding, has_a_finite_answer_for_every_double) {
    const Encoding& e = GetParam();
    for (const double x : {0.0, -0.0, 1e-40, -1e-40, 1e10, -1e10, 3.4e38, -3.4e38, 1e300, infinity,
                           -infinity, not_a_number}) {
        EXPECT_TRUE(std::isfinite(e.decode(x))) << x;
        EXPECT_TRUE(std::isfinite(e.encode(x))) << x;
    }
    EXPECT_EQ(e.decode(not_a_number), e.decode(0));
    EXPECT_EQ(e.encode(not_a_number), e.encode(0));
    EXPECT_EQ(e.decode(infinity), e.decode(3.4028234663852886e38));
    EXPECT_EQ(e.encode(-infinity), e.encode(-3.4028234663852886e38));
}

TEST_P(EveryEncoding, is_the_same_on_many_colors_as_on_one) {
    std::vector<RgbD> in{{not_a_number, infinity, -infinity}};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> near(-0.5, 1.5), exponent(-12, 38);
    for (int i = 0; i < 20001; ++i) {
        in.push_back({near(random), near(random), near(random)});
        const double huge = std::pow(10, exponent(random));
        in.push_back({huge, -huge, i % 2 ? 0.0 : -0.0});
    }
    for (const bool encode : {true, false}) {
        std::vector<RgbD> many = in;
        encode ? GetParam().encode_all(many) : GetParam().decode_all(many);
        for (std::size_t i = 0; i < in.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double want =
                    encode ? GetParam().encode(in[i][c]) : GetParam().decode(in[i][c]);
                // PQ raises to the power of 78.8 and back, which multiplies the rounding.
                ASSERT_NEAR(many[i][c], want, 1e-12 * (1 + std::abs(want))) << in[i][c];
            }
        }
    }
}

TEST_P(EveryEncoding, is_found_by_its_name_and_has_a_source) {
    EXPECT_EQ(require_encoding(GetParam().name()), GetParam());
    EXPECT_FALSE(GetParam().curve->source.empty());
    EXPECT_FALSE(GetParam().gamut->source.empty());
}

struct Published {
    const char* name;
    double light, code, digits;
};

// Codes that makers print. Those of n / 1023 are rounded to whole codes of 10 bits.
constexpr double whole = 0.5 / 1023;
constexpr Published published[] = {
    {"rec709", 1, 1, 1e-9},
    // IEC 61966-2-1, and what follows from the powers.
    {"srgb", 0.18, 0.4613561, 1e-7},
    {"gamma24", 0.1894646, 0.5, 1e-7},
    {"gamma22", 0.2176376, 0.5, 1e-7},
    {"gamma26", 0.1649385, 0.5, 1e-7},
    // SMPTE ST 2084: 100 and 10000 cd/m2.
    {"pq", 1, 0.5080784, 1e-7},
    {"pq", 100, 1, 1e-12},
    // ITU-R BT.2408-4, table 1: a grey card of 18 % at 38, diffuse white at 75 %.
    {"hlg", 0.18, 0.38, 0.005},
    {"hlg", 1, 0.75, 1e-9},
    // S-2014-003 and S-2016-001, tables of values.
    {"acescc", 0.18, 0.4135884, 1e-7},
    {"acescc", 0, -0.3584475, 1e-7},
    {"acescct", 0.18, 0.4135884, 1e-7},
    {"acescct", 0, 0.0729055, 1e-7},
    // Kodak: 2 % black at 95, 90 % white at 685; 18 % of that white lies at 470 within its tables.
    {"cineon", 0, 95.0 / 1023, 1e-9},
    {"cineon", 1, 685.0 / 1023, 1e-9},
    // ARRI: mid grey at 400 of 1023 at every exposure index.
    {"logc3-ei160", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei200", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei250", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei320", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei400", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei500", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei640", 0.18, 400.0 / 1023, 2e-6},
    {"logc3", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei1000", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei1280", 0.18, 400.0 / 1023, 2e-6},
    {"logc3-ei1600", 0.18, 400.0 / 1023, 2e-6},
    // ARRI, the table's column of black in the same document: 0.0928 at every index.
    {"logc3-ei160", 0, 0.0928, 5e-5},
    {"logc3-ei1600", 0, 0.0928, 5e-5},
    // ARRI LogC4 specification: black at 95 of 1023, mid grey at 0.27839, code 1 at 469.8.
    {"logc4", 0, 95.0 / 1023, 1e-9},
    {"logc4", 0.18, 0.27839, 1e-5},
    {"logc4", 469.8, 1, 1e-6},
    // Sony: black, grey card, 90 % white.
    {"slog2", 0, 90.0 / 1023, whole},
    {"slog2", 0.18, 347.0 / 1023, whole},
    {"slog2", 0.9, 582.0 / 1023, whole},
    {"slog3", 0, 95.0 / 1023, 1e-9},
    {"slog3", 0.18, 420.0 / 1023, 1e-9},
    {"slog3", 0.9, 598.0 / 1023, whole},
    // Panasonic: 0, 18 and 90 %.
    {"vlog", 0, 128.0 / 1023, whole},
    {"vlog", 0.18, 433.0 / 1023, whole},
    {"vlog", 0.9, 602.0 / 1023, whole},
    // Canon, "Canon-Log Transfer Characteristic" (2012), table 2: 0, 2, 18, 90, 720 %.
    {"clog", 0, 128.0 / 1023, whole},
    {"clog", 0.02, 169.0 / 1023, whole},
    {"clog", 0.18, 351.0 / 1023, whole},
    {"clog", 0.9, 614.0 / 1023, whole},
    {"clog", 7.2, 1016.0 / 1023, whole},
    // RED: mid grey at a third, ten stops above it at 1.
    {"log3g10", 0.18, 1.0 / 3, 1e-6},
    {"log3g10", 184.322, 1, 1e-6},
    // Fujifilm: 0, 18 and 90 %.
    {"flog", 0, 95.0 / 1023, whole},
    {"flog", 0.18, 470.0 / 1023, whole},
    {"flog", 0.9, 705.0 / 1023, whole},
    {"flog2", 0, 95.0 / 1023, whole},
    {"flog2", 0.18, 400.0 / 1023, whole},
    {"flog2", 0.9, 570.0 / 1023, whole},
    // Nikon publishes no table: its two formulas at round numbers.
    {"nlog", 1, 619.0 / 1023, 1e-9},
    {"nlog", 0.0565, 260.0 / 1023, 1e-9}, // (260 / 650)^3 = 0.064
    // DJI: black, and the end of the straight part.
    {"dlog", 0, 0.0929, 1e-9},
    {"dlog", 0.0078, 0.139895, 3e-6},
    {"dlog", 1, 0.584555, 1e-9},
    // Blackmagic: mid grey at 28 of 73.
    {"blackmagic-film5", 0.18, 28.0 / 73, 1e-9},
    {"blackmagic-film5", 0, 0.09246575, 1e-8},
    // DaVinci Wide Gamut Intermediate, table of mapping values.
    {"davinci-intermediate", 0.18, 0.336043, 1e-6},
    {"davinci-intermediate", 1, 0.513837, 1e-6},
    {"davinci-intermediate", 10, 0.756599, 1e-6},
    {"davinci-intermediate", 100, 1, 1e-6},
    // Apple: mid grey.
    {"applelog", 0.18, 0.488272, 1e-6},
    // O3DE: 6.5 stops either side of mid grey.
    {"o3de-log2", 0.18, 0.5, 1e-12},
    {"o3de-log2", 0.18 * 90.50966799187809, 1, 1e-12},
    {"o3de-log2", 0.36, 0.5 + 1.0 / 13, 1e-12},
    // GoPro: light of 0..1 at codes of 0..1.
    {"protune", 0, 0, 1e-12},
    {"protune", 1, 1, 1e-12},
};

TEST(Transfer, gives_the_codes_that_makers_publish) {
    for (const Published& row : published) {
        EXPECT_NEAR(require_encoding(row.name).encode(row.light), row.code, row.digits)
            << row.name << ' ' << row.light;
    }
}

TEST(Transfer, of_logc4_has_the_numbers_that_its_specification_derives) {
    const double a = (std::exp2(18) - 16) / 117.45, b = (1023 - 95) / 1023.0, c = 95 / 1023.0;
    const double s = 7 * std::log(2) * std::exp2(7 - 14 * c / b) / (a * b);
    const double t = (std::exp2(6 - 14 * c / b) - 64) / a;
    const Encoding logc4 = require_encoding("logc4");
    EXPECT_NEAR(logc4.decode(0), t, 1e-12);
    EXPECT_NEAR(logc4.decode(-0.1), -0.1 * s + t, 1e-12);
    EXPECT_NEAR(logc4.decode(1), (std::exp2(14 * (1 - c) / b + 6) - 64) / a, 1e-9);
}

TEST(Encoding, is_named_by_curve_and_gamut_however_it_is_spelt) {
    const Encoding slog3 = require_encoding("slog3");
    EXPECT_EQ(slog3, require_encoding("slog3/sgamut3.cine"));
    EXPECT_EQ(slog3, require_encoding("S-Log3/S-Gamut3.Cine"));
    EXPECT_EQ(slog3.name(), "slog3");
    EXPECT_EQ(require_encoding("slog3/rec709").name(), "slog3/rec709");
    EXPECT_FALSE(encoding_named("slog3/"));
    EXPECT_EQ(encoding_named("S-Log3 S-Gamut3.Cine"), encoding_named("slog3/sgamut3.cine"));
    EXPECT_FALSE(encoding_named("some kind of log"));
    EXPECT_FALSE(encoding_named("slog3/slog3"));
    EXPECT_FALSE(encoding_named(""));
    EXPECT_FALSE(encoding_named("/rec709"));
    EXPECT_THROW(require_encoding("slog9"), Error);
}

TEST(Powers, cube_root_is_exact_to_the_last_places_and_odd) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> exponent(-30, 38);
    std::vector<double> in{0, -0.0, 1, -1, 8, -27, 1e-300, 3.4e38};
    for (int i = 0; i < 10000; ++i) {
        in.push_back((i % 2 ? 1 : -1) * std::pow(10, exponent(random)));
    }
    std::vector<double> out = in;
    cube_root_all(out);
    for (std::size_t i = 0; i < in.size(); ++i) {
        ASSERT_NEAR(out[i], std::cbrt(in[i]), 1e-15 * std::abs(std::cbrt(in[i]))) << in[i];
    }
}

TEST(Transfer, of_pq_is_the_same_in_nits) {
    EXPECT_DOUBLE_EQ(pq_encode(1), pq_from_nits(pq_white_nits));
    EXPECT_DOUBLE_EQ(pq_decode(0.75) * pq_white_nits, nits_from_pq(0.75));
}

} // namespace
} // namespace lutlib
