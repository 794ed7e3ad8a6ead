#include "lutlib/formats/cube.h"

#include "lutlib/error.h"
#include "lutlib/formats/all.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/text.h"
#include "tests/lutlib/formats/plain_cube_reader.h"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

namespace lutlib {
namespace {

// The 2-node identity's eight rows.
const std::string identity_rows = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n";

struct DialectRow {
    const char* name;
    std::string text;
    float right; ///< the answer for the input 0.502
};

class CubeDialectTable : public testing::TestWithParam<DialectRow> {};
INSTANTIATE_TEST_SUITE_P(
    Rows, CubeDialectTable,
    testing::Values(
        DialectRow{"domain_0_4",
                   "LUT_3D_SIZE 2\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 4 4 4\n" + identity_rows, 0.1255F},
        DialectRow{"domain_minus_1_1",
                   "LUT_3D_SIZE 2\nDOMAIN_MIN -1 -1 -1\nDOMAIN_MAX 1 1 1\n" + identity_rows,
                   0.751F},
        DialectRow{"domain_0_half",
                   "LUT_3D_SIZE 2\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 0.5 0.5 0.5\n" + identity_rows,
                   1.0F},
        DialectRow{"domain_before_size",
                   "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 4 4 4\nLUT_3D_SIZE 2\n" + identity_rows, 0.1255F},
        DialectRow{"domain_after_the_rows",
                   "LUT_3D_SIZE 2\n" + identity_rows + "DOMAIN_MAX 4 4 4\n", 0.1255F},
        DialectRow{"lower_case_keywords",
                   "lut_3d_size 2\ndomain_min 0 0 0\nDomain_Max 4 4 4\n" + identity_rows, 0.1255F},
        DialectRow{"resolve_input_range", "LUT_3D_SIZE 2\nLUT_3D_INPUT_RANGE 0 4\n" + identity_rows,
                   0.1255F},
        DialectRow{"resolve_shaper_and_cube",
                   "LUT_1D_SIZE 2\nLUT_1D_INPUT_RANGE 0 4\nLUT_3D_SIZE 2\nLUT_3D_INPUT_RANGE 0 "
                   "1\n0 0 0\n1 1 1\n" +
                       identity_rows,
                   0.1255F}),
    [](const auto& row) { return std::string(row.param.name); });

TEST_P(CubeDialectTable, gives_the_right_answer) {
    const Lut lut = read_cube(GetParam().text, "table.cube");
    const Rgb out = evaluate(lut, {0.502F, 0.502F, 0.502F});
    EXPECT_FLOAT_EQ(out.r, GetParam().right);
    EXPECT_FLOAT_EQ(out.g, GetParam().right);
    EXPECT_FLOAT_EQ(out.b, GetParam().right);
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
    std::string out;
    std::size_t at = 0;
    for (std::size_t next; (next = text.find(from, at)) != std::string::npos;
         at = next + from.size()) {
        out.append(text, at, next - at).append(to);
    }
    return out.append(text, at);
}

const std::string plain =
    "# head\nTITLE \"A look\"\nLUT_3D_SIZE 2\n0.5 -0.25 0\n1.5 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 "
    "1\n0 1 1\n1e-3 2.5E0 1\n";

struct Oddity {
    const char* name;
    std::string text;
};

class CubeOddity : public testing::TestWithParam<Oddity> {};
INSTANTIATE_TEST_SUITE_P(
    Texts, CubeOddity,
    testing::Values(
        Oddity{"crlf", replaced(plain, "\n", "\r\n")},
        Oddity{"lone_cr", replaced(plain, "\n", "\r")},
        Oddity{"byte_order_mark", "\xEF\xBB\xBF" + plain},
        Oddity{"lower_case_title", replaced(plain, "TITLE", "title")},
        Oddity{"unquoted_title", replaced(plain, "\"A look\"", "A look")},
        Oddity{"title_as_a_comment", replaced(plain, "TITLE", "# TITLE")},
        Oddity{"title_without_closing_quote", replaced(plain, "look\"", "look")},
        Oddity{"comment_behind_a_row", replaced(plain, "0 1 0\n", "0 1 0 # green\n")},
        Oddity{"comment_between_rows", replaced(plain, "0 1 0\n", "# green\n0 1 0\n")},
        Oddity{"comment_behind_a_keyword", replaced(plain, "SIZE 2\n", "SIZE 2 # small\n")},
        Oddity{"comment_without_a_blank",
               replaced(replaced(plain, "SIZE 2\n", "SIZE 2# small\n"), "0 1 0\n", "0 1 0#c\n")},
        Oddity{"comment_at_the_end", plain + "# the end"},
        Oddity{"blank_lines", replaced(plain, "\n", "\n\n \t\n")},
        Oddity{"decimal_comma",
               replaced(replaced(plain, "0.5 -0.25 0", "0,5 -0,25 0"), "1.5", "1,5")},
        Oddity{"plus_signs", replaced(plain, "1 1 0", "+1 +1.0 +0")},
        Oddity{"bare_points", replaced(replaced(plain, "0.5 -0.25 0", ".5 -.25 0."), "1.5", "1.5")},
        Oddity{"tabs", replaced(plain, "1 1 0", "\t1\t 1\t0 \t")},
        Oddity{"no_final_newline", plain.substr(0, plain.size() - 1)},
        Oddity{"unknown_keywords",
               replaced(plain, "LUT_3D", "LUT_IN_VIDEO_RANGE\nVENDOR x y\nLUT_3D")},
        Oddity{"domain_of_0_1",
               replaced(plain, "LUT_3D", "DOMAIN_MIN 0 0 0\nDOMAIN_MAX 1 1 1\nLUT_3D")},
        Oddity{"unit_range_of_an_absent_table",
               replaced(plain, "LUT_3D", "LUT_1D_INPUT_RANGE 0 1\nLUT_3D")},
        Oddity{"underflow", replaced(plain, "0.5 -0.25 0\n", "0.5 -0.25 1e-60\n")},
        Oddity{"many_digits", replaced(plain, "0.5 -0.25 0\n",
                                       "0.50000000000000000000000 -0.25 0.00000000000000\n")}),
    [](const auto& row) { return std::string(row.param.name); });

TEST_P(CubeOddity, reads_as_the_plain_file) {
    const Lut expected = read_cube(plain, "plain.cube");
    const Lut lut = read_cube(GetParam().text, "odd.cube");
    EXPECT_EQ(lut.title, "A look");
    ASSERT_TRUE(lut.cube);
    EXPECT_EQ(*lut.cube, *expected.cube);
    EXPECT_EQ(lut.cube->at(1, 1, 1), (Rgb{1e-3F, 2.5F, 1}));
}

// A locale with a decimal comma, made for the test.
class DecimalComma {
  public:
    DecimalComma() {
        const std::string make =
            "localedef --no-archive -i de_DE -f UTF-8 '" + folder_ + "/de_DE.UTF-8'";
        EXPECT_EQ(std::system(make.c_str()), 0);
        setenv("LOCPATH", folder_.c_str(), 1);
        EXPECT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
    }
    ~DecimalComma() {
        std::setlocale(LC_ALL, "C");
        unsetenv("LOCPATH");
        std::filesystem::remove_all(folder_);
    }
    DecimalComma(const DecimalComma&) = delete;
    DecimalComma& operator=(const DecimalComma&) = delete;

  private:
    static std::string made_folder() {
        std::string pattern = std::filesystem::temp_directory_path() / "lutlib-locale-XXXXXX";
        return mkdtemp(pattern.data());
    }
    std::string folder_ = made_folder();
};

TEST(Cube, ignores_the_locale_when_reading_and_writing) {
    const Lut lut = read_cube(plain, "plain.cube");
    const std::string before = write_cube(lut, CubeDialect::adobe);
    const DecimalComma locale;
    ASSERT_EQ(std::to_string(0.5).substr(0, 2), "0,");
    const Lut again = read_cube(plain, "plain.cube");
    EXPECT_EQ(again.cube, lut.cube);
    EXPECT_EQ(write_cube(again, CubeDialect::adobe), before);
}

Lut random_lut(int shaper, int cube, const Domain& domain) {
    std::mt19937 random(9);
    Lut lut;
    lut.title = "Random";
    const auto any_float = [&] {
        // Any finite bit pattern, so that every exponent and subnormals occur.
        float value = 0;
        do {
            value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        } while (!std::isfinite(value));
        return value;
    };
    if (shaper > 0) {
        lut.shaper.emplace().domain = domain;
        for (int i = 0; i < shaper; ++i) {
            lut.shaper->entries.push_back({any_float(), any_float(), any_float()});
        }
    }
    if (cube > 0) {
        lut.cube = identity_cube(cube, domain);
        for (Rgb& node : lut.cube->nodes) {
            node = {any_float(), any_float(), any_float()};
        }
    }
    return lut;
}

void expect_round_trip(const Lut& lut, CubeDialect dialect) {
    const Lut again = read_cube(write_cube(lut, dialect), "again.cube");
    EXPECT_EQ(again.title, lut.title);
    ASSERT_EQ(again.shaper.has_value(), lut.shaper.has_value());
    ASSERT_EQ(again.cube.has_value(), lut.cube.has_value());
    const auto same_bits = [](const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rgb)) == 0;
    };
    if (lut.shaper) {
        EXPECT_TRUE(same_bits(again.shaper->entries, lut.shaper->entries));
        EXPECT_EQ(again.shaper->domain, lut.shaper->domain);
    }
    if (lut.cube) {
        EXPECT_TRUE(same_bits(again.cube->nodes, lut.cube->nodes));
        EXPECT_EQ(again.cube->domain, lut.cube->domain);
    }
}

TEST(Cube, written_values_read_back_bit_identically_in_both_dialects) {
    const Domain scalar{{-0.1F, -0.1F, -0.1F}, {3.3F, 3.3F, 3.3F}};
    const Domain per_channel{{-2, 1, 0}, {2, 2, 1e-6F}};
    expect_round_trip(random_lut(0, 9, per_channel), CubeDialect::adobe);
    expect_round_trip(random_lut(300, 0, per_channel), CubeDialect::adobe);
    expect_round_trip(random_lut(0, 9, scalar), CubeDialect::resolve);
    expect_round_trip(random_lut(300, 0, scalar), CubeDialect::resolve);
    expect_round_trip(random_lut(300, 9, scalar), CubeDialect::resolve);
}

TEST(Cube, writer_refuses_what_the_dialect_cannot_say) {
    EXPECT_THROW(write_cube(random_lut(3, 3, {}), CubeDialect::adobe), Error);
    EXPECT_THROW(write_cube(random_lut(0, 3, {{0, 0, 0}, {1, 2, 1}}), CubeDialect::resolve), Error);
    EXPECT_THROW(write_cube(Lut{}, CubeDialect::adobe), Error);
    EXPECT_THROW(write_cube(random_lut(0, 2, {}), CubeDialect::adobe, {std::string(4097, 'x')}),
                 Error);
}

TEST(Cube, title_and_comments_cannot_break_the_written_file) {
    Lut lut = random_lut(0, 2, {});
    lut.title = "a \"quoted\"\nLUT_3D_SIZE 9";
    lut.comments = {"x\r0 0 0"};
    const Lut again = read_cube(write_cube(lut, CubeDialect::adobe), "again.cube");
    EXPECT_EQ(again.title, "a 'quoted' LUT_3D_SIZE 9");
    EXPECT_EQ(again.comments.front(), "x 0 0 0");
    EXPECT_EQ(again.cube, lut.cube);
}

TEST(Cube, title_is_not_taken_from_a_comment_that_looks_like_one) {
    Lut lut = random_lut(0, 2, {});
    lut.comments = {"TITLE \"of another\"", "TITLE \"" + std::string(5000, 'x') + "\""};
    for (const CubeDialect dialect : {CubeDialect::adobe, CubeDialect::resolve}) {
        const Lut again = read_cube(write_cube(lut, dialect), "again.cube");
        EXPECT_EQ(again.title, lut.title);
        EXPECT_EQ(again.comments, lut.comments);
    }
}

// The fast rows against std::from_chars: every digit count, sign, separator and line end that
// exporters write, and values next to the midpoints of floats.
TEST(CubeRows, are_bit_identical_to_from_chars) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-1.5, 20);
    std::string text;
    const int size = 40;
    for (int i = 0; i < size * size * size; ++i) {
        const int decimals = static_cast<int>(random() % 19);
        const bool tab = random() % 9 == 0;
        const auto number = [&] {
            char word[64];
            double v = value(random);
            if (random() % 3 == 0) {
                // Just at, below and above the middle between two floats.
                const float f = static_cast<float>(v);
                const float next = std::nextafter(f, 99.0F);
                v = (static_cast<double>(f) + static_cast<double>(next)) / 2;
                std::snprintf(word, sizeof word, "%.*f", 12 + static_cast<int>(random() % 14), v);
            } else {
                std::snprintf(word, sizeof word, random() % 40 ? "%.*f" : "%.*e", decimals, v);
            }
            return std::string(word);
        };
        text += number() + (tab ? "\t" : " ") + number() + " " + number();
        text += "\n";
    }
    const std::string file = "LUT_3D_SIZE 40\n" + text;
    const std::vector<Rgb> expected = plain_read_rows(text);
    const Lut lut = read_cube(file, "rows.cube");
    ASSERT_EQ(lut.cube->nodes.size(), expected.size());
    EXPECT_EQ(std::memcmp(lut.cube->nodes.data(), expected.data(), expected.size() * sizeof(Rgb)),
              0);
    EXPECT_EQ(read_cube(replaced(file, "\n", "\r\n"), "crlf.cube").cube, lut.cube);
}

TEST(CubeRows, of_six_decimals_are_bit_identical_to_from_chars) {
    std::string text;
    std::vector<int> codes;
    // From 0.000000 to 9.999969, as many as a 1D table takes.
    for (int i = 0; i < 9999999; i += 51) {
        codes.push_back(i);
    }
    for (std::size_t i = 0; i + 2 < codes.size(); i += 3) {
        char row[64];
        std::snprintf(row, sizeof row, "%d.%06d %d.%06d %d.%06d\n", codes[i] / 1000000,
                      codes[i] % 1000000, codes[i + 1] / 1000000, codes[i + 1] % 1000000,
                      codes[i + 2] / 1000000, codes[i + 2] % 1000000);
        text += row;
    }
    const std::vector<Rgb> expected = plain_read_rows(text);
    const std::string file = "LUT_1D_SIZE " + std::to_string(expected.size()) + "\n" + text;
    const Lut lut = read_cube(file, "rows.cube");
    EXPECT_EQ(lut.shaper->entries, expected);
}

TEST(Cube, error_after_fast_rows_names_the_right_line) {
    std::string text = "LUT_3D_SIZE 16\n";
    for (int i = 0; i < 3000; ++i) {
        text += i == 2000 ? "0.1 0.2 x\n" : "0.100000 0.200000 0.300000\n";
    }
    try {
        read_cube(text + std::string(20000, '\n'), "late.cube");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.where().line, 2002U);
    }
}

TEST(CubeFormats, recognise_their_own_output_and_nothing_else) {
    for (const FileFormat* const format : {&formats::cube, &formats::cube_resolve}) {
        const std::string bytes = format->write(*format, random_lut(0, 3, {}), {});
        EXPECT_GE(format->recognise(bytes), 50) << format->name;
        EXPECT_GE(format->recognise("title x\nlut_3d_size 2\n"), 50) << format->name;
        EXPECT_EQ(format->recognise("\x89PNG\r\n"), 0) << format->name;
        EXPECT_EQ(format->recognise(""), 0) << format->name;
    }
}

std::string utf_16(std::string_view ascii, bool big, bool mark) {
    std::string out = !mark ? "" : big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : ascii) {
        out += big ? std::string{'\0', c} : std::string{c, '\0'};
    }
    return out;
}

TEST(ReadCube, takes_utf_16_with_and_without_its_mark) {
    const std::string text = "TITLE \"a\"\r\nLUT_1D_SIZE 2\r\n0 0.25 0\r\n1 1 0.5\r\n";
    const Lut meant = read_cube(text, "a.cube");
    for (const bool big : {false, true}) {
        for (const bool mark : {false, true}) {
            const Lut lut = read_cube(utf_16(text, big, mark), "a.cube");
            EXPECT_EQ(lut.shaper, meant.shaper) << big << mark;
            EXPECT_EQ(lut.title, "a");
        }
    }
    const std::string accented("\xFF\xFE\xE9\0\x3D\xD8\x00\xDE", 8); // e acute, then U+1F600
    EXPECT_EQ(utf8_of_utf16(accented), "\xC3\xA9\xF0\x9F\x98\x80");
}

TEST(ReadCube, takes_no_break_and_typographic_spaces_for_blanks) {
    const Lut meant = read_cube("LUT_1D_SIZE 2\n0 0.25 0\n1 1 0.5\n", "a.cube");
    for (const std::string blank :
         {"\xC2\xA0", "\xA0", "\xE2\x80\x89", "\xE3\x80\x80", "\xE2\x80\x8B"}) {
        const std::string text = "LUT_1D_SIZE" + blank + "2\n" + blank + "0" + blank + "0.25" +
                                 blank + blank + "0 \n1" + blank + " 1 0.5" + blank + "\n";
        EXPECT_EQ(read_cube(text, "a.cube").shaper, meant.shaper) << blank.size();
    }
    // A line of nothing but blanks is empty, however they follow one another.
    for (const std::string blanks : {"\xC2\xA0\xA0", "\xA0\xC2\xA0", "\xE2\x80\x8A\xA0\xA0"}) {
        EXPECT_EQ(trimmed(blanks), "");
        const std::string text = "LUT_1D_SIZE 2\n" + blanks + "\n0 0.25 0\n1 1 0.5\n";
        EXPECT_EQ(read_cube(text, "a.cube").shaper, meant.shaper);
    }
    // The second byte of a letter is none.
    EXPECT_EQ(words_of("d\xC3\xA0 voil\xC3\xA0").count, 2U);
}

} // namespace
} // namespace lutlib
