// lutconv sheet: a picture under many looks.
#include "converter/sheet.h"
#include "converter/sheet_tile.h"
#include "converter/side_by_side.h"
#include "lutlib/bake/bake.h"
#include "lutlib/color/difference.h"
#include "lutlib/io/image.h"
#include "lutlib/io/look.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace converter_test {
namespace {

using nlohmann::json;
namespace io = lutlib::io;

constexpr plot::Rgb8 grey_ground{32, 32, 32};
const std::string srgb_words = "# Input encoding: srgb\n# Output encoding: srgb\n";
const std::string dim_cube = srgb_words + "LUT_1D_SIZE 2\n0 0 0\n0.4 0.4 0.4\n";
const std::string same_cube = srgb_words + "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n";

io::FloatImage picture_of(int width, int height, const std::vector<float>& rgba_in_turn) {
    io::FloatImage out;
    out.width = width;
    out.height = height;
    for (std::size_t i = 0; i < 4 * out.pixels(); ++i) {
        out.rgba.push_back(rgba_in_turn[i % rgba_in_turn.size()]);
    }
    return out;
}

class SheetOfLooks : public testing::Test {
  protected:
    const Folder folder;

    std::string written(const std::string& name, const io::FloatImage& image,
                        io::Depth depth) const {
        io::write_image(folder.path(name), image, {.depth = depth, .text = {}});
        return folder.path(name);
    }
    // Red and green of full codes and a grey, side by side.
    std::string colors() const {
        return written("colors.png",
                       picture_of(48, 20, {1, 0, 0, 1, 0, 1, 0, 1, 0.6F, 0.6F, 0.6F, 1}),
                       io::Depth::uint8);
    }
    json sheet(std::vector<std::string> words) const {
        words.insert(words.begin(), "sheet");
        words.insert(words.end(), {"-o", folder.path("sheet.png"), "--json"});
        const Result result = lutconv_in_process(words);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out, nullptr, false);
    }
    // The pixel of tile `i` of a sheet in one row, so far from the left and the top of it.
    plot::Rgb8 pixel(const json& report, int i, int x, int y) const {
        const io::FloatImage image = io::read_image(folder.path("sheet.png"));
        const int cell = std::max(160, report["tile_width"].get<int>());
        const int left = 6 + i * (cell + 6) + x, top = 6 + 11 + 3 + y;
        plot::Rgb8 out{};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(top * image.width + left) * 4 + c;
            out[c] = static_cast<std::uint8_t>(std::lround(255 * image.rgba[at]));
        }
        return out;
    }
};

TEST_F(SheetOfLooks, shows_the_original_first_and_the_picture_under_each_look_in_order) {
    const std::string dim = folder.write("dim.cube", dim_cube),
                      same = folder.write("same.cube", same_cube);
    const json report = sheet({colors(), dim, same, "--columns", "3"});
    EXPECT_EQ(report["tile_width"], 48); // no wider than the picture
    EXPECT_EQ(report["width"], 3 * 166 + 6);
    EXPECT_EQ(pixel(report, 0, 0, 0), (plot::Rgb8{255, 0, 0}));
    EXPECT_EQ(pixel(report, 0, 1, 19), (plot::Rgb8{0, 255, 0}));
    EXPECT_EQ(pixel(report, 1, 0, 0), (plot::Rgb8{102, 0, 0}));
    EXPECT_EQ(pixel(report, 2, 1, 19), (plot::Rgb8{0, 255, 0}));
    EXPECT_EQ(pixel(report, 0, 48, 0), grey_ground);
    EXPECT_EQ(report["looks"][0]["name"], "dim");
    EXPECT_LT(report["looks"][1]["delta_e_2000"]["max"], 1e-6);
}

TEST_F(SheetOfLooks, says_the_mean_and_the_largest_colour_difference_of_its_pixels) {
    const std::string dim = folder.write("dim.cube", dim_cube);
    const json error = sheet({colors(), dim})["looks"][0]["delta_e_2000"];
    double sum = 0, most = 0;
    for (const lutlib::RgbD& c : {lutlib::RgbD{1, 0, 0}, {0, 1, 0}, {0.6, 0.6, 0.6}}) {
        const double one = lutlib::delta_e_2000(c, {0.4 * c.r, 0.4 * c.g, 0.4 * c.b});
        sum += one;
        most = std::max(most, one);
    }
    EXPECT_EQ(error["count"], 48 * 20);
    // Codes come as floats, whose rounding is a millionth of a dE.
    EXPECT_NEAR(error["mean"].get<double>(), sum / 3, 1e-4);
    EXPECT_NEAR(error["max"].get<double>(), most, 1e-4);
}

TEST_F(SheetOfLooks, gives_a_log_look_the_codes_that_it_expects_of_light_and_of_a_display) {
    // What it takes and gives is the same light.
    const std::string log = folder.write("log.cube", "# Input encoding: logc3/rec709\n"
                                                     "# Output encoding: logc3/rec709\n"
                                                     "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    const std::string light =
        written("light.exr", picture_of(16, 16, {0.5F, 0.18F, 0.02F, 1}), io::Depth::float32);
    const json of_light = sheet({light, log, "--columns", "2"});
    EXPECT_EQ(of_light["picture_encoding"], "linear");
    // sRGB codes of 0.5, 0.18 and 0.02 times 255.
    EXPECT_EQ(pixel(of_light, 0, 3, 3), (plot::Rgb8{188, 118, 39}));
    EXPECT_EQ(pixel(of_light, 1, 3, 3), (plot::Rgb8{188, 118, 39}));
    const json of_codes = sheet({colors(), log, "--columns", "2"});
    EXPECT_LT(of_codes["looks"][0]["delta_e_2000"]["max"], 1e-3);
    EXPECT_EQ(pixel(of_codes, 1, 0, 0), (plot::Rgb8{255, 0, 0}));
    const json left = sheet({colors(), log, "--columns", "2", "--no-convert"});
    EXPECT_LT(left["looks"][0]["delta_e_2000"]["max"], 1e-6);
}

TEST_F(SheetOfLooks, shows_what_an_engine_makes_of_its_strip) {
    // Steep between two of the strip's nodes, so that its lookup errs.
    const std::string steep = folder.write(
        "steep.cube", srgb_words + "LUT_1D_SIZE 101\n" + [] {
            std::string rows;
            for (int i = 0; i <= 100; ++i) {
                rows += i < 62 ? "0 0 0\n" : "1 1 1\n";
            }
            return rows;
        }());
    const json exact = sheet({colors(), steep, "--columns", "2"});
    EXPECT_EQ(pixel(exact, 1, 2, 0), (plot::Rgb8{0, 0, 0}));
    const lutlib::Engine& engine = *lutlib::engine_named("unreal");
    const lutlib::Bake bake = lutlib::bake(io::Look::open(steep).exact(), engine,
                                           engine.default_size, engine.default_bits);
    const json baked =
        sheet({written("between.png", picture_of(16, 16, {0.627451F, 0.627451F, 0.627451F, 1}),
                       io::Depth::uint8),
               steep, "--columns", "2", "--engine", "unreal"});
    EXPECT_EQ(baked["engine"], "unreal");
    const double expected = lutlib::read_by(engine, lutlib::decoded(bake.picture), bake.size)(
                                lutlib::RgbD{160.0 / 255, 160.0 / 255, 160.0 / 255})
                                .g;
    // Between the nodes at 9/15, which is black, and 10/15, which is white.
    EXPECT_GT(expected, 0.2);
    EXPECT_LT(expected, 0.8);
    EXPECT_NEAR(pixel(baked, 1, 5, 5)[1], 255 * expected, 0.52);
}

TEST_F(SheetOfLooks, takes_what_nobody_knows_for_srgb_and_says_so) {
    const std::string look = folder.write("look.cube", saturated_cube(5));
    const Result result =
        lutconv_in_process({"sheet", colors(), look, "-o", folder.path("sheet.png")});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("the picture's encoding is not known and taken for srgb"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("(name it with --look-input and --look-output): look\n"),
              std::string::npos)
        << result.out;
}

TEST_F(SheetOfLooks, is_not_made_where_a_look_cannot_be_read_and_names_each_of_them) {
    const std::string good = folder.write("good.cube", dim_cube),
                      bad = folder.write("bad.cube", "LUT_1D_SIZE 2\n0 0 0\n"),
                      gone = folder.path("gone.cube");
    const Result one =
        lutconv_in_process({"sheet", colors(), good, bad, "-o", folder.path("sheet.png")});
    EXPECT_EQ(one.exit_code, 2);
    EXPECT_NE(one.err.find("bad.cube"), std::string::npos) << one.err;
    const Result two =
        lutconv_in_process({"sheet", colors(), gone, good, bad, "-o", folder.path("sheet.png")});
    EXPECT_EQ(two.exit_code, 2);
    for (const char* const words : {"2 of 3 looks cannot be read", "gone.cube", "bad.cube"}) {
        EXPECT_NE(two.err.find(words), std::string::npos) << two.err;
    }
    EXPECT_EQ(std::count(two.err.begin(), two.err.end(), '\n'), 1) << two.err;
    const std::vector<std::string> names = folder.names();
    EXPECT_EQ(std::count(names.begin(), names.end(), "sheet.png"), 0);
}

TEST_F(SheetOfLooks, leaves_out_what_is_no_look_of_a_folder_and_says_so_in_one_line) {
    std::filesystem::create_directory(folder.path("looks"));
    folder.write("looks/dim.cube", dim_cube);
    folder.write("looks/settings.json", "{\"window\": 3}");
    written("looks/photo.png", picture_of(20, 16, {0.5F, 0.5F, 0.5F, 1}), io::Depth::uint8);
    const std::string looks = folder.path("looks"), png = folder.path("sheet.png");
    const Result result = lutconv_in_process({"sheet", colors(), looks, "-o", png, "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err,
              "lutconv: left out 2 files of folders that are no looks: photo.png, settings.json\n");
    EXPECT_EQ(json::parse(result.out)["looks"].size(), 1U);
    // Who names a file says that it is a look; and so does a .cube of a folder.
    const Result named = lutconv_in_process(
        {"sheet", colors(), looks, folder.path("looks/photo.png"), "-o", folder.path("no.png")});
    EXPECT_EQ(named.exit_code, 2);
    EXPECT_NE(named.err.find("photo.png"), std::string::npos) << named.err;
    folder.write("looks/bad.cube", "LUT_1D_SIZE 2\n0 0 0\n");
    const Result bad = lutconv_in_process({"sheet", colors(), looks, "-o", folder.path("no.png")});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_NE(bad.err.find("bad.cube"), std::string::npos) << bad.err;
    std::filesystem::remove(folder.path("looks/bad.cube"));
    std::filesystem::remove(folder.path("looks/dim.cube"));
    EXPECT_EQ(lutconv_in_process({"sheet", colors(), looks, "-o", folder.path("no.png")}).exit_code,
              2);
    EXPECT_FALSE(std::filesystem::exists(folder.path("no.png")));
}

TEST_F(SheetOfLooks, refuses_what_it_cannot_write_or_lay_out) {
    const std::string look = folder.write("dim.cube", dim_cube), png = folder.path("s.png");
    EXPECT_EQ(lutconv_in_process({"sheet", colors(), look, "-o", folder.path("s.exr")}).exit_code,
              3);
    EXPECT_EQ(lutconv_in_process({"sheet", colors(), look, "-o", png, "--width", "0"}).exit_code,
              3);
    EXPECT_EQ(lutconv_in_process({"sheet", colors(), look, "-o", png, "--columns", "-1"}).exit_code,
              3);
    EXPECT_EQ(lutconv_in_process({"sheet", "-", "-", "-o", png}).exit_code, 3);
}

TEST(SheetTile, averages_light_and_not_codes) {
    const io::FloatImage stripes = picture_of(32, 32, {0, 0, 0, 1, 1, 1, 1, 1});
    const auto tile =
        converter::make_tile(stripes, {}, {}, converter::tile_size_of(stripes, 16), grey_ground);
    ASSERT_EQ(tile.picture.width(), 16);
    // Half the light of white is the code 187.5.
    EXPECT_NEAR(tile.picture.at(7, 9)[1], 187.5, 0.6);
}

TEST(SheetTile, weighs_every_pixel_by_the_area_that_it_covers) {
    // Each of five columns covers 0.6 of one of three; the second and the fourth lie on borders.
    const io::FloatImage row =
        picture_of(5, 3, {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1});
    const auto tile = converter::make_tile(row, {}, {}, {3, 2}, grey_ground);
    const auto light = [&](int x, std::size_t c) {
        return lutlib::srgb().decode(tile.picture.at(x, 1)[c] / 255.0);
    };
    EXPECT_NEAR(light(0, 0), 0.4, 0.005);
    EXPECT_NEAR(light(1, 0), 0.2, 0.005);
    EXPECT_NEAR(light(1, 1), 0.6, 0.005);
    EXPECT_NEAR(light(1, 2), 0.2, 0.005);
    EXPECT_NEAR(light(2, 2), 0.4, 0.005);
    EXPECT_NEAR(light(2, 1), 0, 0.005);
}

TEST(SheetTile, counts_no_transparent_pixel_and_shows_what_lies_behind_it) {
    const io::FloatImage half = picture_of(16, 16, {1, 0, 0, 1, 0, 1, 0, 0});
    const lutlib::Transform look = lutlib::Transform::each([](lutlib::RgbD c) {
        return lutlib::RgbD{c.r, 0, 0};
    });
    const auto tile = converter::make_tile(half, {}, look, {16, 16}, grey_ground);
    EXPECT_EQ(tile.delta_e_2000.count, 128U);
    EXPECT_EQ(tile.delta_e_2000.max, 0);
    EXPECT_EQ(tile.picture.at(0, 0), (plot::Rgb8{255, 0, 0}));
    EXPECT_EQ(tile.picture.at(1, 0), grey_ground);
}

TEST(SheetTiles, made_side_by_side_are_those_made_one_after_another) {
    io::FloatImage picture = picture_of(301, 97, {0, 0, 0, 1});
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        picture.rgba[i] = static_cast<float>(i * 7919 % 1009) / 1008;
    }
    std::vector<lutlib::Transform> looks;
    for (int i = 0; i < 9; ++i) {
        looks.push_back(lutlib::Transform::each([i](lutlib::RgbD c) {
            return lutlib::RgbD{std::pow(c.r, 1 + 0.1 * i), c.g * (1 - 0.05 * i), c.b};
        }));
    }
    const auto size = converter::tile_size_of(picture, 64);
    for (const std::size_t at_once : {1U, 2U, 16U}) {
        const auto tiles = converter::make_tiles(picture, {}, looks, size, grey_ground, at_once);
        ASSERT_EQ(tiles.size(), looks.size());
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const auto one = converter::make_tile(picture, {}, looks[i], size, grey_ground);
            EXPECT_EQ(tiles[i].picture.pixels(), one.picture.pixels());
            EXPECT_EQ(tiles[i].delta_e_2000.mean, one.delta_e_2000.mean);
            EXPECT_EQ(tiles[i].delta_e_2000.p99, one.delta_e_2000.p99);
        }
    }
    EXPECT_GE(converter::bytes_of_tile(picture, size), picture.pixels() * sizeof(double));
}

TEST(SideBySide, does_all_once_never_more_than_allowed_and_throws_what_the_first_threw) {
    for (const std::size_t at_once : {0U, 1U, 3U}) {
        std::vector<std::atomic<int>> done(50);
        std::atomic<int> now = 0, most = 0;
        const auto work = [&](std::size_t i) {
            const int here = ++now;
            int seen = most;
            while (seen < here && !most.compare_exchange_weak(seen, here)) {
            }
            std::vector<lutlib::RgbD> colors(20000, {0.5, 0.5, 0.5});
            lutlib::apply_in_parallel(lutlib::Transform::each([](lutlib::RgbD c) { return c; }),
                                      colors);
            ++done[i];
            --now;
            if (i % 20 == 7) {
                throw std::runtime_error(std::to_string(i));
            }
        };
        try {
            converter::do_side_by_side(done.size(), at_once, work);
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "7");
        }
        EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const auto& n) { return n == 1; }));
        EXPECT_LE(most, std::max<int>(static_cast<int>(at_once), 1));
    }
    converter::do_side_by_side(0, 4, [](std::size_t) { FAIL(); });
    EXPECT_EQ(converter::pieces_at_once(std::size_t{1} << 40), 1U);
    EXPECT_GE(converter::pieces_at_once(0), 1U);
}

TEST(SheetNames, are_as_short_as_they_can_be_told_apart) {
    EXPECT_EQ(converter::short_names_of(
                  {"a/warm.cube", "cold.json", "b/cold.cube", "x/a.cube", "y/a.cube"}),
              (std::vector<std::string>{"warm", "cold.json", "cold.cube", "x/a.cube", "y/a.cube"}));
}

TEST(SheetLayout, is_nearly_of_the_tiles_shape_and_holds_every_label) {
    EXPECT_EQ(converter::usual_columns(2), 2);
    EXPECT_EQ(converter::usual_columns(4), 2);
    EXPECT_EQ(converter::usual_columns(5), 3);
    EXPECT_EQ(converter::usual_columns(10), 4);
    const plot::Raster tile(16, 16, {0, 0, 0});
    const std::vector<converter::LabelledTile> tiles(3, {tile, std::string(500, 'm'), "figures"});
    const plot::Raster sheet = converter::sheet_of("head", tiles, 2);
    EXPECT_EQ(static_cast<std::size_t>(sheet.width()) * static_cast<std::size_t>(sheet.height()),
              converter::sheet_pixels(16, 16, 3, 2));
    // A name that is too long ends before the next tile begins.
    const int next = 6 + 160 + 6;
    for (int y = 0; y < sheet.height(); ++y) {
        EXPECT_EQ(sheet.at(next - 1, y), converter::sheet_ground) << y;
    }
}

} // namespace
} // namespace converter_test
