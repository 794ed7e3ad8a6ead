// What verbs say of the file that they wrote, where the format keeps less than the LUT.
#include "lutlib/io/formats/all.h"
#include "lutlib/io/image.h"
#include "lutlib/io/picture_types.h"
#include "lutlib/io/png.h"
#include "tests/converter/run_program.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace converter_test {
namespace {

namespace io = lutlib::io;
using nlohmann::json;

json run(std::vector<std::string> words) {
    words.emplace_back("--json");
    const Result result = lutconv_in_process(words);
    EXPECT_EQ(result.exit_code, 0) << words[0] << ": " << result.out << result.err;
    return json::parse(result.out, nullptr, false);
}

// `compare` reads both files anew.
TEST(FiguresOfAFile, are_those_of_the_file_read_back) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const std::vector<std::vector<std::string>> verbs{
        {"resample", look},
        {"edit", look},
        {"compose", look, folder.write("one.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n")},
        {"blend", look, look},
        {"convert", look}};
    for (const std::string extension : {"spi1d", "3dl", "cube"}) {
        for (std::vector<std::string> words : verbs) {
            const std::string file = folder.path("out." + extension);
            words.insert(words.end(), {"-o", file});
            const json said = run(words);
            if (extension == "cube") {
                EXPECT_TRUE(said["losses"].empty()) << words[0];
                continue;
            }
            EXPECT_FALSE(said["losses"].empty()) << words[0] << extension;
            const json found = run({"compare", look, file, "--samples", "50000"});
            for (const char* const figure : {"p99", "mean", "max"}) {
                const double ours = said["error"]["absolute"][figure];
                EXPECT_NEAR(ours, found["absolute"][figure].get<double>(), 1e-3 * ours)
                    << words[0] << ' ' << extension << ' ' << figure;
            }
        }
    }
}

TEST(FiguresOfAFile, say_which_tables_it_holds_and_what_was_lost) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(9));
    const Result text = lutconv_in_process({"resample", look, "-o", folder.path("x.spi1d")});
    EXPECT_NE(text.out.find("a 1D table of 4096 entries"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("lost: channels that mix replaced"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("error of the file, as it is read"), std::string::npos) << text.out;
}

TEST(FiguresOfAFile, of_an_inverse_are_of_the_look_and_then_that_file) {
    const Folder folder;
    const std::string look = folder.write("look.cube", "LUT_3D_SIZE 2\n0 0 0\n.9 .1 .1\n.1 .9 .1\n"
                                                       "1 1 .2\n.1 .1 .9\n1 .2 1\n.2 1 1\n1 1 1\n");
    const json cube = run({"invert", look, "-o", folder.path("x.cube"), "--size", "9"});
    const json curve = run({"invert", look, "-o", folder.path("x.spi1d"), "--size", "9"});
    EXPECT_TRUE(cube["losses"].empty());
    EXPECT_FALSE(curve["losses"].empty());
    EXPECT_GT(curve["round_trip"]["absolute"]["mean"],
              3 * cube["round_trip"]["absolute"]["mean"].get<double>());
}

TEST(Convert, names_the_engines_that_take_the_picture_and_what_makes_the_others) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(17)),
                      strip = folder.path("s.png");
    const Result deep = lutconv_in_process({"convert", look, "-o", strip});
    EXPECT_NE(deep.out.find("engines that take it as it is: none; 'lutconv bake LOOK -o strip.png "
                            "--engine NAME' makes what piccolo, unreal,"),
              std::string::npos)
        << deep.out;
    const Result plain = lutconv_in_process({"convert", look, "-o", strip, "--bits", "8"});
    EXPECT_NE(plain.out.find("engines that take it as it is: piccolo, reshade, threejs; "),
              std::string::npos)
        << plain.out;
}

TEST(EmptyOutput, is_refused_with_what_to_name) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(3));
    for (const char* const verb : {"convert", "resample", "bake", "edit", "invert"}) {
        const Result result = lutconv_in_process({verb, look, "-o", ""});
        EXPECT_EQ(result.exit_code, 3) << verb;
        EXPECT_NE(result.err.find("name the file to write, or - for standard output"),
                  std::string::npos)
            << result.err;
    }
}

// A curve that rises without bound at 0 behind another that does: ever more entries help a little.
TEST(Compose, of_curves_takes_the_entries_that_the_error_asks_for_and_says_so) {
    const Folder folder;
    const auto power = [&](const std::string& name, double exponent) {
        std::string text = "LUT_1D_SIZE 1024\n";
        for (int i = 0; i < 1024; ++i) {
            const std::string value = std::to_string(std::pow(i / 1023.0, exponent));
            text += value + ' ' + value + ' ' + value + '\n';
        }
        return folder.write(name, text);
    };
    const std::string a = power("a.cube", 1 / 2.4), b = power("b.cube", 1 / 4.0),
                      out = folder.path("ab.cube");
    const json least = run({"compose", a, b, "-o", out, "--size", "1024"}),
               chosen = run({"compose", a, b, "-o", out});
    EXPECT_GT(chosen["shaper_size"], 1024);
    EXPECT_LT(chosen["error"]["absolute"]["max"],
              0.6 * least["error"]["absolute"]["max"].get<double>());
    const Result text = lutconv_in_process({"compose", a, b, "-o", out});
    EXPECT_NE(text.out.find("entries, as the error asks"), std::string::npos) << text.out;
}

TEST(Verify, takes_one_of_stacked_lattices_and_says_how) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(16)),
                      strip = folder.path("s.png");
    run({"bake", look, "-o", strip, "--engine", "reshade", "--size", "16"});
    const io::PngImage one = io::read_png(contents(strip), "s.png");
    io::PngImage two = one;
    two.height *= 2;
    two.samples.assign(one.samples.size() * 2, 7);
    std::copy(one.samples.begin(), one.samples.end(),
              two.samples.begin() + static_cast<std::ptrdiff_t>(one.samples.size()));
    const std::string stack = folder.write("two.png", io::write_png(two));
    const auto verified = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"verify", stack, "--against", look, "--engine", "reshade"};
        words.insert(words.end(), more.begin(), more.end());
        return lutconv_in_process(words);
    };
    const Result unnamed = verified({});
    EXPECT_EQ(unnamed.exit_code, 1);
    EXPECT_NE(unnamed.out.find("2 lattices below each other; verify one of them with --row 0 to 1"),
              std::string::npos)
        << unnamed.out;
    EXPECT_EQ(verified({"--row", "1"}).exit_code, 0);
    EXPECT_EQ(verified({"--row", "0"}).exit_code, 1);
    EXPECT_EQ(verified({"--row", "2"}).exit_code, 3);
}

// Every type that is written here: `info` and `verify` know it by its content too, and say alike
// what it does to codes.
TEST(PictureTypes, are_known_to_info_and_verify_alike) {
    const Folder folder;
    const std::string look = folder.write("look.cube", saturated_cube(16)),
                      strip = folder.path("s.png");
    run({"bake", look, "-o", strip});
    const std::string none = folder.write("none.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    int written = 0;
    for (const io::PictureType& type : io::picture_types()) {
        for (const std::string_view extension : type.extensions) {
            const std::string file = folder.path("s." + std::string(extension));
            if (lutconv_in_process({"apply", none, strip, "-o", file}).exit_code != 0) {
                continue; // OpenImageIO only reads it
            }
            ++written;
            const std::string bytes = contents(file);
            EXPECT_EQ(io::picture_type_of(bytes, file), &type) << extension;
            const bool begins = io::begins_as_picture(bytes);
            EXPECT_EQ(begins, type.marks[0].bytes.size() > 2) << extension;
            const bool harms = !type.harm.empty() && (!type.harms || type.harms(bytes));
            const std::vector<std::string> verify{"verify", file,       "--against",
                                                  look,     "--engine", "piccolo"};
            const Result verified = lutconv_in_process(verify);
            EXPECT_EQ(verified.out.find(std::string(type.harm)) != std::string::npos,
                      harms || type.harm.empty())
                << extension << verified.out << verified.err;
            const Result info = lutconv_in_process({"info", file});
            EXPECT_EQ(info.exit_code, 0) << extension << info.err;
            EXPECT_EQ((info.out + info.err).find(std::string(type.harm)) != std::string::npos,
                      harms || type.harm.empty())
                << extension << info.out;
        }
    }
    EXPECT_GE(written, 8);
    for (const std::string_view extension : lutlib::formats::picture.extensions) {
        EXPECT_TRUE(io::picture_type_of("", "x." + std::string(extension))) << extension;
    }
}

} // namespace
} // namespace converter_test
