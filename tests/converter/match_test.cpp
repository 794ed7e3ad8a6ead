// lutconv match: a look out of a picture before and after a grade.
#include "lutlib/io/image.h"
#include "lutlib/match/chart.h"
#include "tests/converter/match_fixture.h"

namespace converter_test {
namespace {

TEST_F(MatchVerb, learns_a_look_that_makes_the_one_picture_of_the_other) {
    const json said = matched();
    EXPECT_EQ(said["pixels"], 256 * 160);
    EXPECT_EQ(said["look_input"], "srgb");
    EXPECT_LT(said["held_out"]["delta_e_2000"]["mean"], 0.3);
    EXPECT_EQ(said["held_out"]["delta_e_2000"]["count"], 256 * 160 / 8);
    EXPECT_TRUE(said["pairs"][0]["edits"].empty()) << said["pairs"][0]["edits"];
    // What it says is what apply makes of it.
    ASSERT_EQ(
        lutconv_in_process({"apply", in("look.cube"), in("before.png"), "-o", in("again.png")})
            .exit_code,
        0);
    const io::PngImage again = read("again.png"), after = read("after.png");
    int most = 0, differ = 0;
    for (std::size_t i = 0; i < again.samples.size(); ++i) {
        const int off = std::abs(int{again.samples[i]} - int{after.samples[i]});
        most = std::max(most, off);
        differ += off > 0 ? 1 : 0;
    }
    // Under sanitizers nodes lie twice as far apart, whose errors are four times as large.
    EXPECT_LE(most, support::is_sanitized ? 16 : 4);
    EXPECT_LT(differ, static_cast<int>(again.samples.size()) / 5);
}

TEST_F(MatchVerb, extends_the_look_to_another_picture) {
    matched();
    write("other.png", shot(500));
    grade("other.png", "wanted.png");
    ASSERT_EQ(lutconv_in_process({"apply", in("look.cube"), in("other.png"), "-o", in("got.png")})
                  .exit_code,
              0);
    const io::PngImage got = read("got.png"), wanted = read("wanted.png");
    double sum = 0;
    for (std::size_t i = 0; i < got.samples.size(); ++i) {
        sum += std::abs(int{got.samples[i]} - int{wanted.samples[i]});
    }
    EXPECT_LT(sum / static_cast<double>(got.samples.size()), 0.5);
}

TEST_F(MatchVerb, says_the_same_in_words) {
    const Result result = lutconv_in_process(words());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("held out, 5120 pixels: mean 0."), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("srgb to srgb"), std::string::npos) << result.out;
}

TEST_F(MatchVerb, names_a_part_that_was_painted_and_does_not_learn_it) {
    matched();
    const std::string clean = contents(in("look.cube"));
    io::PngImage painted = read("after.png");
    for (int y = 64; y < 112; ++y) {
        for (int x = 96; x < 144; ++x) {
            painted.at({x, y}, 0) = 250;
        }
    }
    write("after.png", painted);
    const json said = matched();
    EXPECT_EQ(said["left_out"], 48 * 48);
    EXPECT_NE(said["pairs"][0]["edits"].dump().find("between x 96 and 144, y 64 and 112"),
              std::string::npos)
        << said["pairs"][0]["edits"];
    folder_.write("clean.cube", clean);
    const json far = json::parse(
        lutconv_in_process({"compare", in("look.cube"), in("clean.cube"), "--json"}).out);
    EXPECT_LT(far["absolute"]["mean"], 1.0 / 255);
}

TEST_F(MatchVerb, takes_many_pairs_folders_and_frames_by_name_and_number) {
    for (const int frame : {9, 10, 11}) {
        const std::string number = (frame < 10 ? "000" : "00") + std::to_string(frame);
        write("plate." + number + ".png", shot(100 * frame, 64, 48));
        grade("plate." + number + ".png", "graded." + number + ".png");
    }
    std::vector<std::string> sequence = words();
    sequence[1] = in("plate.####.png");
    sequence[2] = in("graded.####.png");
    const json frames = matched(sequence);
    ASSERT_EQ(frames["pairs"].size(), 3U);
    EXPECT_EQ(frames["pixels"], 3 * 64 * 48);
    for (const json& pair : frames["pairs"]) {
        const std::string before = pair["before"], after = pair["after"];
        EXPECT_EQ(before.substr(before.size() - 8), after.substr(after.size() - 8));
    }
    std::vector<std::string> both = sequence;
    both.insert(both.begin() + 3, {in("before.png"), in("after.png")});
    EXPECT_EQ(matched(both)["pairs"].size(), 4U);
    std::vector<std::string> two = sequence;
    two.insert(two.end(), {"--frames", "9-10"});
    EXPECT_EQ(matched(two)["pairs"].size(), 2U);
    std::filesystem::remove(in("graded.0011.png"));
    refused(sequence, "it has no partner of the same frame");
}

TEST_F(MatchVerb, moves_a_shifted_picture_back_and_says_by_how_much) {
    matched();
    const std::string still = contents(in("look.cube"));
    io::PngImage after = read("after.png");
    const io::PngImage from = after;
    for (int y = 0; y < after.height; ++y) {
        for (int x = 0; x < after.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                after.at({x, y}, c) =
                    from.at({std::clamp(x - 5, 0, 255), std::clamp(y + 3, 0, 159)}, c);
            }
        }
    }
    write("after.png", after);
    const json said = matched();
    EXPECT_EQ(said["pairs"][0]["shift"]["x"], 5);
    EXPECT_EQ(said["pairs"][0]["shift"]["y"], -3);
    EXPECT_EQ(said["all_pixels"]["delta_e_2000"]["count"], 251 * 157);
    EXPECT_LT(said["all_pixels"]["delta_e_2000"]["mean"], 0.3);
    EXPECT_NE(said["pairs"][0]["remarks"].dump().find("it lies 5, -3 pixels beside"),
              std::string::npos);
}

TEST_F(MatchVerb, learns_from_a_jpeg_and_takes_its_noise_for_no_edit) {
    const Result saved =
        lutconv_in_process({"apply", in("grade.cube"), in("before.png"), "-o", in("after.jpg")});
    ASSERT_EQ(saved.exit_code, 0) << saved.err;
    std::vector<std::string> from_jpeg = words();
    from_jpeg[2] = in("after.jpg");
    const json said = matched(from_jpeg);
    EXPECT_TRUE(said["pairs"][0]["edits"].empty()) << said["pairs"][0]["edits"];
    EXPECT_NE(said["pairs"][0]["remarks"].dump().find("JPEG compresses with losses"),
              std::string::npos);
    ASSERT_EQ(
        lutconv_in_process({"apply", in("look.cube"), in("before.png"), "-o", in("again.png")})
            .exit_code,
        0);
    const io::PngImage again = read("again.png"), after = read("after.png");
    double sum = 0;
    for (std::size_t i = 0; i < again.samples.size(); ++i) {
        sum += std::abs(int{again.samples[i]} - int{after.samples[i]});
    }
    EXPECT_LT(sum / static_cast<double>(again.samples.size()), 1.5);
}

TEST_F(MatchVerb, learns_a_steep_look_of_which_few_pixels_are_left) {
    folder_.write("steep.cube", "LUT_1D_SIZE 5\n0 0 0\n0 0 0\n0.1 0.1 0.1\n1 1 1\n1 1 1\n");
    ASSERT_EQ(
        lutconv_in_process({"apply", in("steep.cube"), in("before.png"), "-o", in("after.png")})
            .exit_code,
        0);
    EXPECT_GT(matched()["explained"], 0.99);
}

TEST_F(MatchVerb, draws_what_the_pictures_show_and_where_the_look_misses) {
    std::vector<std::string> with_page = words();
    with_page.insert(with_page.end(), {"--html", in("look.html")});
    const json said = matched(with_page);
    EXPECT_GT(said["coverage"]["supported"], 0.005);
    EXPECT_LT(said["coverage"]["supported"], said["coverage"]["near"]);
    EXPECT_EQ(said["coverage"]["corners"].size(), 8U);
    EXPECT_GT(said["coverage"]["greys"][1], said["coverage"]["greys"][0]);
    const std::string page = contents(in("look.html"));
    for (const char* const part : {"id=\"plane-0\"", "blue 1.00", "id=\"pair-0\"", "magenta"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST_F(MatchVerb, learns_from_charts_that_lie_where_they_want_and_from_the_published_one) {
    // The chart on its head, in a larger picture.
    const auto patches = lutlib::published_chart();
    io::PngImage photo = shot(0, 300, 200);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 120; ++x) {
            const lutlib::RgbD color =
                patches[static_cast<std::size_t>(23 - (y / 20 * 6 + x / 20))];
            for (std::size_t c = 0; c < 3; ++c) {
                photo.at({100 + x, 70 + y}, c) = photo.depth.code(color[c]);
            }
        }
    }
    write("photo.png", photo);
    grade("photo.png", "photo_graded.png");
    const std::string area = "100,70,120,80";
    const std::string size = support::is_sanitized ? "5" : "17";
    const json both =
        matched({"match", in("photo.png"), in("photo_graded.png"), "--chart-before", area,
                 "--chart-after", area, "-o", in("chart.cube"), "--size", size});
    ASSERT_EQ(both["patches"].size(), 24U);
    EXPECT_EQ(both["patches"][0]["name"], "dark skin");
    EXPECT_NEAR(both["patches"][0]["before"][0], 115 / 255.0, 1e-6);
    const double coarseness = support::is_sanitized ? 4 : 1;
    EXPECT_LT(both["all_pixels"]["delta_e_2000"]["mean"], coarseness * 0.5);
    EXPECT_LT(both["held_out"]["delta_e_2000"]["mean"], coarseness * 2);
    const json to_graded = matched({"match", in("photo_graded.png"), "--chart-after", area, "-o",
                                    in("published.cube"), "--size", size});
    for (std::size_t i = 0; i < 24; ++i) {
        EXPECT_EQ(to_graded["patches"][i]["after"], both["patches"][i]["after"]);
        EXPECT_NEAR(to_graded["patches"][i]["delta_e_2000"], both["patches"][i]["delta_e_2000"],
                    0.05);
    }
    const json back = matched({"match", in("photo_graded.png"), "--chart-before", area, "-o",
                               in("back.cube"), "--html", in("back.html"), "--size", size});
    EXPECT_EQ(back["patches"][3]["before"], both["patches"][3]["after"]);
    EXPECT_NE(contents(in("back.html")).find("bluish green"), std::string::npos);
    refused({"match", in("photo.png"), "--chart-before", "0,0,90,60", "-o", in("x.cube")},
            "no ColorChecker lies in that rectangle");
    refused({"match", in("photo.png"), "--chart-before", "200,150,120,80", "-o", in("x.cube")},
            "reaches beyond its 300x200 pixels");
    refused({"match", in("photo.png"), "--chart-before", "0,0,90", "-o", in("x.cube")},
            "takes a rectangle", 3);
    refused({"match", in("photo.png"), in("photo_graded.png"), "--chart-before", area, "-o",
             in("x.cube")},
            "take a picture each", 3);
}

// Parts of what `lutpreview chart --headless --size 640x360` renders, from the front and with
// --azimuth 12, from pixel 4, 52 on.
TEST_F(MatchVerb, finds_the_chart_of_the_scene_that_lutpreview_renders_also_from_the_side) {
    struct Rendered {
        const char *file, *area;
    };
    const auto published = lutlib::published_chart();
    for (const auto& [file, area] :
         {Rendered{"chart.png", "10,8,228,151"}, Rendered{"chart_turned.png", "43,14,198,144"}}) {
        folder_.write("chart.png", contents(std::string(TEST_PICTURES "/") + file));
        grade("chart.png", "chart_graded.png");
        const json neutral = matched({"match", in("chart.png"), "--chart-before", area, "-o",
                                      in("none.cube"), "--size", "9"});
        const json graded =
            matched({"match", in("chart.png"), in("chart_graded.png"), "--chart-before", area,
                     "--chart-after", area, "-o", in("grade_found.cube"), "--size", "9"});
        ASSERT_EQ(neutral["patches"].size(), published.size());
        for (std::size_t i = 0; i < published.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(neutral["patches"][i]["before"][c], published[i][c], 1.01 / 255)
                    << file << ' ' << neutral["patches"][i]["name"];
            }
        }
        EXPECT_LT(neutral["all_pixels"]["delta_e_2000"]["max"], 0.5) << file;
        EXPECT_LT(graded["all_pixels"]["delta_e_2000"]["mean"], 1) << file;
    }
}

TEST_F(MatchVerb, refuses_pictures_that_do_not_lie_on_each_other) {
    io::PngImage other = shot(0);
    for (std::size_t i = 0; i < other.samples.size(); ++i) {
        other.samples[i] = static_cast<std::uint16_t>(i * 7919 % 251);
    }
    write("other.png", other);
    refused({"match", in("before.png"), in("other.png"), "-o", in("x.cube")},
            "do not show the same before and after a grade");
    EXPECT_EQ(std::filesystem::exists(in("x.cube")), false);
}

TEST_F(MatchVerb, a_picture_that_was_scaled_by_much_is_refused_or_doubted) {
    const io::PngImage from = read("after.png");
    for (const double by : {1.1, 1.3}) {
        io::PngImage scaled = from;
        for (int y = 0; y < scaled.height; ++y) {
            for (int x = 0; x < scaled.width; ++x) {
                const int at_x = static_cast<int>(std::lround(128 + (x - 128) / by)),
                          at_y = static_cast<int>(std::lround(80 + (y - 80) / by));
                for (std::size_t c = 0; c < 3; ++c) {
                    scaled.at({x, y}, c) = from.at({at_x, at_y}, c);
                }
            }
        }
        write("after.png", scaled);
        const Result result = lutconv_in_process(words());
        EXPECT_TRUE(result.exit_code == 2 ||
                    result.out.find("check that each pixel is the other's") != std::string::npos)
            << by << result.out;
    }
}

TEST_F(MatchVerb, refuses_with_one_sentence) {
    refused({"match", in("before.png"), "-o", in("x.cube")}, "pictures come in pairs", 3);
    write("small.png", shot(0, 100, 80));
    refused({"match", in("before.png"), in("small.png"), "-o", in("x.cube")},
            "it has 100x80 pixels and");
    refused({"match", in("before.png"), in("nowhere.png"), "-o", in("x.cube")}, "nowhere.png");
    refused({"match", "-", "-", "-o", in("x.cube")}, "standard input", 3);
}

TEST_F(MatchVerb, overwrites_no_picture_without_force) {
    const std::string before = contents(in("before.png"));
    std::vector<std::string> over = words("before.png");
    EXPECT_EQ(lutconv_in_process(over).exit_code, 2);
    EXPECT_EQ(contents(in("before.png")), before);
}

TEST_F(MatchVerb, pixels_that_alpha_hides_are_not_learnt_from) {
    io::FloatImage hidden = io::read_image(in("after.png"));
    for (std::size_t i = 0; i < hidden.pixels(); ++i) {
        if (i % 256 < 64) {
            std::fill_n(hidden.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, 0.0F);
        }
    }
    io::write_image(in("after.png"), hidden,
                    {.depth = io::Depth::uint8, .alpha = true, .text = {}});
    const json said = matched();
    EXPECT_EQ(said["all_pixels"]["delta_e_2000"]["count"], 192 * 160);
    EXPECT_LT(said["all_pixels"]["delta_e_2000"]["mean"], 0.3);
}

} // namespace
} // namespace converter_test
