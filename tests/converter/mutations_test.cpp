// lutconv on damaged files of every format: an answer or one sentence, in time and in little
// memory, and the file that was there before is kept.
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/image.h"
#include "lutlib/io/oiio.h"
#include "lutlib/io/picture_types.h"
#include "tests/converter/run_program.h"
#include "tests/support/mutations.h"
#include "tests/support/names.h"
#include "tests/support/thorough.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <ostream>

namespace {

namespace fs = std::filesystem;
namespace io = lutlib::io;
using namespace converter_test;

/// MiB that this process takes now, and that it took at most since reset_peak().
std::size_t status_of(const char* field) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == field) {
            std::size_t kib = 0;
            status >> kib;
            return kib >> 10;
        }
    }
    return 0;
}

void reset_peak() {
    std::ofstream("/proc/self/clear_refs") << 5;
}

/// A file, how lutconv is asked about it, and what it is to write.
struct Seed {
    std::string name, bytes;
    std::vector<std::string> words; ///< FILE is the file's path
    std::string output;
};

std::vector<Seed> seeds_of(const lutlib::FileFormat& format) {
    std::vector<Seed> out;
    const std::vector<std::string> words{"convert", "FILE", "--size", "9"};
    for (const std::string_view extension : format.extensions) {
        for (const auto& file : fs::directory_iterator(LUT_TEST_FILES)) {
            if (file.path().extension() == "." + std::string(extension)) {
                out.push_back(
                    {file.path().filename(), contents(file.path().string()), words, "out.cube"});
            }
        }
    }
    const bool is_picture = format.name == "png" || format.name == "picture" || format.layout;
    const lutlib::Lut look = io::decode_lut(saturated_cube(is_picture ? 16 : 5), "a.cube").lut;
    lutlib::WriteOptions options;
    options.size = is_picture ? 16 : 0;
    if (format.write) {
        out.push_back({"x." + format.extensions.first(),
                       io::encode_lut(look, format, options).bytes, words, "out.cube"});
    } else if (is_picture) { // which a layout's row writes
        const Folder folder;
        const std::string png = folder.path("x.png"), other = folder.path("x.tga");
        io::write_lut(png, look, options, "strip");
        io::write_image(other, io::read_image(png), {io::Depth::uint8, false, {}});
        out.push_back(format.name == "png" ? Seed{"x.png", contents(png), words, "out.cube"}
                                           : Seed{"x.tga", contents(other), words, "out.cube"});
    }
    return out;
}

std::vector<Seed> recipes() {
    std::vector<Seed> out;
    for (const auto& file : fs::directory_iterator(RECIPES)) {
        out.push_back({file.path().filename(),
                       contents(file.path().string()),
                       {"bake", "FILE", "--layout", "strip", "--size", "16"},
                       "out.png"});
    }
    return out;
}

/// None of a type that cannot be written.
std::vector<Seed> seeds_of(const io::PictureType& type) {
    const std::string name = "x." + type.extensions.first();
    if (type.extensions.first() != "png" && !io::oiio().writes(name)) {
        return {};
    }
    const Folder folder;
    io::FloatImage image;
    image.width = image.height = 64;
    for (int i = 0; i < 64 * 64 * 4; ++i) {
        image.rgba.push_back(static_cast<float>(i * i % 256) / 255);
    }
    const std::string path = folder.path(name);
    io::write_image(path, image, {io::depths_of(path).front(), false, {}});
    return {{name, contents(path), {"apply", SAMPLE_LOOKS "/warm_teal.cube", "FILE"}, "out.png"}};
}

/// By its name, since every run of this program makes the list.
struct Kind {
    std::string name;
    const lutlib::FileFormat* format = nullptr;
    const io::PictureType* type = nullptr;

    std::vector<Seed> seeds() const {
        return format ? seeds_of(*format) : type ? seeds_of(*type) : recipes();
    }
};

std::vector<Kind> kinds() {
    std::vector<Kind> out{{"recipe"}};
    for (const lutlib::FileFormat* const format : io::file_formats()) {
        if (format->read) {
            out.push_back({"lut " + std::string(format->name), format});
        }
    }
    for (const io::PictureType& type : io::picture_types()) {
        out.push_back({"picture " + std::string(type.name), nullptr, &type});
    }
    return out;
}

void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

class Mutations : public testing::TestWithParam<Kind> {};

TEST_P(Mutations, are_answered_or_refused_and_harm_nothing) {
    using Clock = std::chrono::steady_clock;
    constexpr double seconds = support::is_sanitized ? 60 : 20; // of a machine that has other work
    constexpr std::size_t mebibytes = 300;
    const std::vector<Seed> seeds = GetParam().seeds();
    if (GetParam().type && seeds.empty()) {
        GTEST_SKIP() << "this type cannot be written here";
    }
    ASSERT_FALSE(seeds.empty()) << "a file of this format belongs into " LUT_TEST_FILES;
    const Folder folder;
    for (std::size_t number = 0; number < support::mutations_to_try(); ++number) {
        const Seed& seed = seeds[number % seeds.size()];
        const support::Mutated file = support::mutated(seed.bytes, number);
        SCOPED_TRACE(seed.name + ", mutation " + std::to_string(number) + ": " + file.names);
        const std::string path = folder.write(seed.name, file.bytes);
        const std::string target = folder.write(seed.output, "kept");
        std::vector<std::string> words = seed.words;
        std::replace(words.begin(), words.end(), std::string("FILE"), path);
        words.insert(words.end(), {"-o", target, "--max-memory", "1"});
        reset_peak();
        const std::size_t before = status_of("VmRSS:");
        const auto start = Clock::now();
        const Result result = lutconv_in_process(words);
        const std::chrono::duration<double> took = Clock::now() - start;
        EXPECT_LT(took.count(), seconds);
        EXPECT_EQ(support::problem_of(result.err), "") << result.err;
        EXPECT_EQ(support::problem_of(result.out), "") << result.out;
        if (result.exit_code != 0) {
            EXPECT_EQ(result.exit_code, 2) << result.err;
            const bool names_it = result.err.find(seed.name) != std::string::npos;
            const bool names_what_it_names = result.err.find(folder.path("")) != std::string::npos;
            EXPECT_TRUE(names_it || names_what_it_names) << result.err;
            EXPECT_EQ(contents(target), "kept");
            if (!support::is_sanitized) {
                EXPECT_LT(status_of("VmHWM:"), before + mebibytes);
            }
        } else {
            EXPECT_NE(contents(target), "kept");
        }
        const std::vector<std::string> files = folder.names();
        EXPECT_EQ(std::count_if(files.begin(), files.end(),
                                [&](const auto& name) {
                                    return std::none_of(
                                        seeds.begin(), seeds.end(), [&](const Seed& s) {
                                            return s.name == name || s.output == name;
                                        });
                                }),
                  0);
        if (HasFailure()) {
            break;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutations, testing::ValuesIn(kinds()),
                         [](const auto& row) { return support::test_name(row.param.name); });

} // namespace
