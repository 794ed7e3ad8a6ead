#include "lutlib/io/image.h"

#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/oiio.h"
#include "lutlib/io/png.h"
#include "lutlib/io/samples.h"
#include "tests/lutlib/io/scratch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sys/stat.h>
#include <thread>

namespace lutlib::io {
namespace {

// Every value that 8, 16 bits and half floats all hold or round apart: codes / 255.
FloatImage ramp(bool alpha) {
    FloatImage image;
    image.width = 16;
    image.height = 16;
    image.alpha = alpha;
    image.channels = alpha ? 4 : 3;
    for (int i = 0; i < 256; ++i) {
        const float v = static_cast<float>(i) / 255;
        for (const float sample : {v, 1 - v, v * v, alpha ? v : 1.0F}) {
            image.rgba.push_back(sample);
        }
    }
    return image;
}

struct FileKind {
    std::string extension;
    Depth depth;
    double tolerance; ///< half a step of the depth over 0..1
};

class EveryFileKind : public testing::TestWithParam<std::tuple<FileKind, bool>> {};
INSTANTIATE_TEST_SUITE_P(
    Image, EveryFileKind,
    testing::Combine(testing::Values(FileKind{"png", Depth::uint8, 0.5 / 255},
                                     FileKind{"png", Depth::uint16, 0.5 / 65535},
                                     FileKind{"tif", Depth::uint8, 0.5 / 255},
                                     FileKind{"tif", Depth::uint16, 0.5 / 65535},
                                     FileKind{"tif", Depth::float32, 0},
                                     FileKind{"exr", Depth::half, 1.0 / 4096},
                                     FileKind{"exr", Depth::float32, 0}),
                     testing::Bool()),
    [](const auto& row) {
        const FileKind& kind = std::get<0>(row.param);
        return kind.extension + "_" + std::string(info_of(kind.depth).name) +
               (std::get<1>(row.param) ? "_alpha" : "");
    });

TEST_P(EveryFileKind, comes_back_within_half_a_step_and_with_colors_not_multiplied_by_alpha) {
    const auto& [kind, alpha] = GetParam();
    const ScratchFolder folder;
    const std::string path = folder.file("a picture." + kind.extension);
    const FloatImage image = ramp(alpha);
    write_image(path, image, {kind.depth, alpha, {}});
    EXPECT_EQ(folder.count(), 1U);
    const FloatImage back = read_image(path);
    EXPECT_EQ(back.width, 16);
    EXPECT_EQ(back.height, 16);
    EXPECT_EQ(back.depth, kind.depth);
    EXPECT_EQ(back.alpha, alpha);
    EXPECT_EQ(back.channels, alpha ? 4 : 3);
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        ASSERT_NEAR(back.rgba[i], image.rgba[i], kind.tolerance + 1e-7) << i;
    }
}

TEST(Image, keeps_nan_infinities_and_negative_values_in_float_files) {
    const ScratchFolder folder;
    constexpr float inf = std::numeric_limits<float>::infinity();
    FloatImage image;
    image.width = 2;
    image.height = 1;
    image.rgba = {NAN, inf, -inf, 1, -2.5F, 1e-6F, 60000, 1};
    for (const Depth depth : {Depth::half, Depth::float32}) {
        const std::string path = folder.file("x.exr");
        write_image(path, image, {depth, false, {}});
        const FloatImage back = read_image(path);
        EXPECT_TRUE(std::isnan(back.rgba[0]));
        EXPECT_EQ(back.rgba[1], inf);
        EXPECT_EQ(back.rgba[2], -inf);
        EXPECT_EQ(back.rgba[4], -2.5F);
    }
}

TEST(Image, clamps_what_integers_cannot_hold_and_writes_nan_as_0) {
    const ScratchFolder folder;
    FloatImage image;
    image.width = 2;
    image.height = 1;
    image.rgba = {NAN, INFINITY, -INFINITY, 1, -2.5F, 1.5F, 0.5F, 1};
    write_image(folder.file("x.png"), image, {Depth::uint8, false, {}});
    EXPECT_EQ(read_png(read_file(folder.file("x.png")), "").samples,
              (std::vector<std::uint16_t>{0, 255, 0, 0, 255, 128}));
}

TEST(Image, reads_a_png_as_openimageio_does) {
    const ScratchFolder folder;
    for (const Depth depth : {Depth::uint8, Depth::uint16}) {
        const std::string path = folder.file("x.png");
        write_image(path, ramp(true), {depth, true, {}});
        const FloatImage ours = read_image(path), theirs = floats_of(oiio().read(path, path));
        EXPECT_EQ(ours.depth, theirs.depth);
        ASSERT_EQ(ours.rgba.size(), theirs.rgba.size());
        for (std::size_t i = 0; i < ours.rgba.size(); ++i) {
            ASSERT_NEAR(ours.rgba[i], theirs.rgba[i], 1e-7);
        }
    }
}

TEST(Image, from_memory_is_told_by_its_content) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    write_image(path, ramp(false), {Depth::float32, false, {}});
    EXPECT_EQ(decode_image(read_file(path), "", "standard input").rgba, ramp(false).rgba);
}

TEST(Image, errors_are_one_line_that_names_the_file) {
    const ScratchFolder folder;
    write_file(folder.file("bad.exr"), "not a picture");
    write_file(folder.file("bad.png"), "\x89PNG\r\n\x1a\nno more");
    write_file(folder.file("empty.exr"), "");
    const auto message = [](const auto& action) {
        try {
            action();
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    for (const std::string name : {"bad.exr", "none.exr", "bad.png", "empty.exr"}) {
        const std::string path = folder.file(name);
        const std::string text = message([&] { read_image(path); });
        EXPECT_EQ(text.rfind(path + ": ", 0), 0U) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
    const std::string unknown = folder.file("x.unknown");
    const std::string text = message([&] { write_image(unknown, ramp(false), {}); });
    EXPECT_EQ(text.rfind(unknown + ": ", 0), 0U) << text;
    EXPECT_EQ(message([] { read_image("/dev/null"); }), "/dev/null: this is a device; name a file");
    EXPECT_EQ(message([&] { read_image(folder.file("empty.exr")); }),
              folder.file("empty.exr") + ": the file is empty");
    EXPECT_EQ(message([&] { read_image(folder.file("none.exr")); }),
              folder.file("none.exr") + ": cannot open the file: No such file or directory");
    EXPECT_EQ(message([&] { read_image(folder.path().string()); }),
              folder.path().string() + ": this is a directory; name a file");
    EXPECT_EQ(folder.count(), 3U) << "a temporary file was left";
}

TEST(Image, of_an_extension_that_no_type_has_is_told_which_there_are) {
    const std::vector<std::string> known = oiio().written_extensions();
    for (const char* const expected : {"exr", "hdr", "jpg", "png", "tif"}) {
        EXPECT_EQ(std::count(known.begin(), known.end(), expected), 1) << expected;
    }
    for (const std::string& extension : known) {
        EXPECT_TRUE(oiio().writes("picture." + extension)) << extension;
        EXPECT_FALSE(depths_of(ScratchFolder().file("x." + extension)).empty()) << extension;
    }
    const auto refusal = [](const std::string& path) {
        try {
            depths_of(path);
        } catch (const UsageError& error) {
            return error.message();
        }
        return std::string("no error");
    };
    EXPECT_NE(refusal("x.exe").find("extension 'exe'; did you mean exr?"), std::string::npos);
    const std::string text = refusal("x.unknown");
    for (const std::string& extension : known) {
        EXPECT_NE(text.find(" " + extension), std::string::npos) << text;
    }
}

TEST(Image, comes_through_a_pipe_that_is_read_but_once) {
    const ScratchFolder folder;
    for (const std::string extension : {"png", "exr"}) {
        const std::string path = folder.file("x." + extension), pipe = folder.file(extension);
        write_image(path, ramp(true), {Depth::uint16, true, {}});
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << read_file(path); });
        const FloatImage piped = read_image(pipe);
        writer.join();
        EXPECT_EQ(piped.rgba, read_image(path).rgba);
        EXPECT_EQ(piped.depth, read_image(path).depth);
    }
}

TEST(Image, goes_into_a_pipe_or_a_device_and_never_replaces_it) {
    const ScratchFolder folder;
    for (const std::string& extension : oiio().written_extensions()) {
        const std::string pipe = folder.file("pipe." + extension);
        ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
        const Depth depth = depths_of(pipe).front();
        std::string got;
        std::thread reader([&] {
            std::ifstream in(pipe, std::ios::binary);
            got.assign(std::istreambuf_iterator<char>(in), {});
        });
        write_image(pipe, ramp(false), {depth, false, {}});
        reader.join();
        EXPECT_TRUE(std::filesystem::is_fifo(pipe)) << extension;
        EXPECT_NO_THROW(decode_image(got, extension, "what came through")) << extension;
        // Always full: an error, whatever the library says that it has written.
        const std::string full = folder.file("full." + extension);
        std::filesystem::create_symlink("/dev/full", full);
        EXPECT_THROW(write_image(full, ramp(false), {depth, false, {}}), Error) << extension;
        EXPECT_TRUE(std::filesystem::is_character_file("/dev/full")) << extension;
    }
}

TEST(Image, a_cut_exr_is_an_error) {
    const ScratchFolder folder;
    const std::string path = folder.file("x.exr");
    write_image(path, ramp(false), {Depth::half, false, {}});
    const std::string bytes = read_file(path);
    write_file(path, bytes.substr(0, bytes.size() / 2));
    EXPECT_THROW(read_image(path), Error);
}

} // namespace
} // namespace lutlib::io
