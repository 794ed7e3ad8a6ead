// The .3dl reader's depths and the writer's mesh, each by what the file says.
#include "lutlib/formats/threedl.h"

#include "lutlib/error.h"
#include "lutlib/formats/integer_codes.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace lutlib {
namespace {

/// Rows of a cube of n nodes: r = 0.9 x, g = 0.5 y, b = 0.2 z of the largest code; blue fastest.
std::string rows(int n, double white) {
    std::string out;
    for (int r = 0; r < n; ++r) {
        for (int g = 0; g < n; ++g) {
            for (int b = 0; b < n; ++b) {
                const auto code = [&](double share, int i) {
                    return std::to_string(std::lround(share * white * i / (n - 1.0)));
                };
                out += code(.9, r) + ' ' + code(.5, g) + ' ' + code(.2, b) + '\n';
            }
        }
    }
    return out;
}

Rgb white_of(const Lut& lut) {
    return lut.cube->nodes.back();
}

bool says(const std::vector<std::string>& notes, const char* words) {
    return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
        return note.find(words) != std::string::npos;
    });
}

const std::string mesh = "0 256 512 767 1023\n";

TEST(Threedl, declares_its_depth_in_lustres_keyword_or_a_comment) {
    // As dark as a 10-bit file's white.
    const double white = 1023 / .9;
    for (const std::string& head :
         {std::string("3DMESH\nMesh 2 12\n"), std::string("# Output bit depth 12\n"),
          std::string("#output bit depth: 12 \n"), std::string("Output bit depth 12\n"),
          std::string("# Input bit depth 10\n#  Output Bit Depth = 12\n")}) {
        const Lut lut = read_threedl(head + mesh + rows(5, white), "a.3dl");
        EXPECT_NEAR(white_of(lut).r, 1023 / 4095.0, 1e-6) << head;
        EXPECT_NEAR(white_of(lut).g, 1023 / 1.8 / 4095.0, 2e-4) << head;
        EXPECT_TRUE(says(lut.notes, "take them for 10 bits")) << head;
        EXPECT_TRUE(lut.keywords.empty());
        // Blue is fastest in the file, red in memory.
        EXPECT_NEAR(lut.cube->at(4, 0, 0).r, 1023 / 4095.0, 1e-6);
        EXPECT_EQ(lut.cube->at(4, 0, 0).b, 0);
    }
}

TEST(Threedl, without_a_depth_is_guessed_by_its_largest_code_and_says_so) {
    struct Case {
        int largest, bits;
    };
    for (const Case c : {Case{255, 8}, {511, 8}, {1023, 10}, {2047, 10}, {4095, 12}, {65535, 16}}) {
        const Lut lut = read_threedl(mesh + rows(4, c.largest / .9), "a.3dl");
        EXPECT_NEAR(white_of(lut).r, c.largest / largest_code(c.bits), 1e-6) << c.largest;
        EXPECT_TRUE(says(lut.notes, ("guessed " + std::to_string(c.bits) + " bits").c_str()));
    }
}

TEST(Threedl, of_a_depth_far_below_its_codes_is_guessed_and_says_why) {
    const Lut lut = read_threedl("Mesh 2 8\n" + mesh + rows(5, 4095), "a.3dl");
    EXPECT_NEAR(white_of(lut).r, .9, 1e-3);
    EXPECT_TRUE(says(lut.notes, "line 1 declares 8 bits"));
}

void refused(const std::string& text, const char* reason, std::size_t line) {
    try {
        read_threedl(text, "a.3dl");
        ADD_FAILURE() << "read: " << text.substr(0, 60);
    } catch (const Error& error) {
        EXPECT_NE(error.message().find(reason), std::string::npos) << error.what();
        EXPECT_EQ(error.where().line, line) << error.what();
    }
}

TEST(Threedl, refuses_what_is_none_with_the_line) {
    refused("5\n" + rows(5, 4095), "if this is the number of nodes per axis, delete the line", 1);
    refused(mesh + "0 0 0\n1 2\n", "this one has 2", 3);
    refused(mesh + "0 0 0.5\n", "whole numbers", 2);
    refused(mesh + mesh, "a second mesh line", 2);
    const std::string all = rows(5, 4095);
    refused(mesh + all.substr(all.find('\n') + 1), "the table has 124 rows", 125);
    refused("0 64 90 127\n" + rows(4, 4095), "too small for any depth", 0);
    refused(mesh + rows(5, 100), "no depth has so small codes", 0);
    refused("<xml>\n", "begins with '<'", 1);
    refused("nothing\n", "neither a mesh line nor a row", 0);
}

TEST(Threedl, keeps_keywords_that_it_does_not_act_on) {
    const Lut lut = read_threedl(mesh + rows(5, 4095) + "\nLUT8\ngamma 2.2\nvendor x\n", "a.3dl");
    EXPECT_EQ(lut.keywords, (std::vector<std::string>{"gamma 2.2", "vendor x"}));
}

std::vector<int> mesh_of(const std::string& file) {
    std::istringstream text(file);
    std::string line;
    while (std::getline(text, line) &&
           (line.empty() || line.find_first_not_of("0123456789 ") != std::string::npos)) {
    }
    std::istringstream numbers(line);
    return {std::istream_iterator<int>(numbers), {}};
}

Lut bright_look(int size) {
    Lut lut;
    lut.cube = identity_cube(size);
    return lut;
}

// three.js wants even steps, OpenColorIO a line within two codes of a depth's own.
TEST(Threedl, has_a_mesh_of_even_whole_steps_wherever_a_depth_has_such) {
    int even_sizes = 0, sizes = 0;
    const int largest = support::is_sanitized ? 34 : 70;
    // Every size, or those that are used and some between.
    for (int size = min_threedl_size; size <= largest;
         size += support::is_thorough() || size < 18 || (size > 30 && size < 34) ? 1 : 2) {
        const std::string file = write_flame(bright_look(size), {});
        const std::vector<int> codes = mesh_of(file);
        ASSERT_EQ(codes.size(), static_cast<std::size_t>(size));
        bool even = true;
        for (std::size_t i = 2; i < codes.size(); ++i) {
            even = even && codes[i] - codes[i - 1] == codes[1];
        }
        const auto readers = flame_readers(bright_look(size));
        EXPECT_EQ(even, !says(readers, "three.js refuses")) << size;
        EXPECT_EQ(size == 17, !says(readers, "ffmpeg")) << size;
        even_sizes += even;
        ++sizes;
        for (const int usual : {4, 5, 9, 16, 17, 32, 33, 64, 65}) {
            EXPECT_TRUE(size != usual || even || size == 64) << size;
        }
        const int bits = codes.back() > 8191   ? 16
                         : codes.back() > 2047 ? 12
                         : codes.back() > 511  ? 10
                                               : 8;
        for (std::size_t i = 0; i < codes.size(); ++i) {
            EXPECT_LT(std::abs(codes[i] - static_cast<double>(i) * largest_code(bits) / (size - 1)),
                      2);
        }
        EXPECT_TRUE(read_threedl(file, "a.3dl").shaper == std::nullopt);
    }
    EXPECT_GT(even_sizes, sizes / 3);
}

TEST(Threedl, says_who_misreads_a_dark_look) {
    Lut dark = bright_look(17);
    for (Rgb& node : dark.cube->nodes) {
        node = node * 0.3F;
    }
    EXPECT_TRUE(says(flame_readers(dark), "OpenColorIO and three.js take its codes"));
    const Lut back = read_threedl(write_flame(dark, {}), "a.3dl");
    EXPECT_NEAR(white_of(back).r, 0.3, 1.3e-4);
    EXPECT_NEAR(white_of(read_threedl(write_lustre(dark, {}), "a.3dl")).r, 0.3, 1.3e-4);
    for (Rgb& node : dark.cube->nodes) {
        node = {};
    }
    EXPECT_TRUE(says(flame_readers(dark), "OpenColorIO refuses it"));
}

TEST(Threedl, holds_no_cube_whose_mesh_would_be_a_row) {
    EXPECT_THROW(write_flame(bright_look(3), {}), Error);
    EXPECT_THROW(write_flame(bright_look(130), {}), Error);
}

} // namespace
} // namespace lutlib
