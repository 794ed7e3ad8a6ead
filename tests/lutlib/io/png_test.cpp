#include "lutlib/io/png.h"

#include "lutlib/error.h"

#include <gtest/gtest.h>

#include <png.h>

#include <cstring>
#include <random>

namespace lutlib::io {
namespace {

PngImage random_image(int width, int height, int channels, int bits, unsigned seed = 1) {
    PngImage image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.depth.bits = bits;
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * channels; ++i) {
        image.samples.push_back(static_cast<std::uint16_t>(
            random() % static_cast<unsigned>(image.depth.maximum() + 1)));
    }
    return image;
}

// libpng as an independent writer of what write_png does not write.
struct Encoder {
    int color_type = PNG_COLOR_TYPE_RGB;
    int depth = 8;
    int interlace = PNG_INTERLACE_NONE;
    bool gamma = false;
    bool primaries = false;
    std::vector<png_color> palette = {};
    std::vector<png_byte> palette_alpha = {};

    std::string operator()(int width, int height, std::vector<std::vector<png_byte>> rows) const {
        std::string out;
        png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
        png_infop info = png_create_info_struct(png);
        png_set_write_fn(
            png, &out,
            [](png_structp p, png_bytep data, png_size_t n) {
                static_cast<std::string*>(png_get_io_ptr(p))
                    ->append(reinterpret_cast<const char*>(data), n);
            },
            nullptr);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                     depth, color_type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        if (!palette.empty()) {
            png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
        }
        if (!palette_alpha.empty()) {
            png_set_tRNS(png, info, palette_alpha.data(), static_cast<int>(palette_alpha.size()),
                         nullptr);
        }
        if (primaries) {
            png_set_cHRM(png, info, 0.3127, 0.329, 0.64, 0.33, 0.3, 0.6, 0.15, 0.06);
        }
        if (gamma) {
            png_set_gAMA(png, info, 0.45455);
        }
        png_write_info(png, info);
        std::vector<png_bytep> pointers;
        for (auto& row : rows) {
            pointers.push_back(row.data());
        }
        png_write_image(png, pointers.data());
        png_write_end(png, info);
        png_destroy_write_struct(&png, &info);
        return out;
    }
};

struct Shape {
    int width, height, channels, bits;
};
class EveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Png, EveryShape,
                         testing::Values(Shape{256, 16, 3, 8}, Shape{256, 16, 3, 16},
                                         Shape{1, 1, 3, 8}, Shape{7, 5, 4, 8}, Shape{7, 5, 4, 16},
                                         Shape{1024, 32, 3, 16}));

TEST_P(EveryShape, codes_come_back_exactly) {
    const Shape s = GetParam();
    const PngImage image = random_image(s.width, s.height, s.channels, s.bits);
    const PngImage back = read_png(write_png(image), "x.png");
    EXPECT_EQ(back.width, s.width);
    EXPECT_EQ(back.height, s.height);
    EXPECT_EQ(back.channels, s.channels);
    EXPECT_EQ(back.depth.bits, s.bits);
    EXPECT_EQ(back.samples, image.samples);
    EXPECT_FALSE(back.interlaced || back.palette || back.grey);
}

TEST_P(EveryShape, every_cut_of_the_file_is_one_clear_error) {
    const Shape s = GetParam();
    const std::string bytes = write_png(random_image(s.width, s.height, s.channels, s.bits));
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 61) {
        EXPECT_THROW(read_png(bytes.substr(0, length), "x.png"), Error) << length;
    }
    // The IEND chunk is 12 bytes.
    EXPECT_THROW(read_png(bytes.substr(0, bytes.size() - 12), "x.png"), Error);
}

TEST(Png, reports_the_srgb_chunk_and_writes_it_only_when_asked) {
    PngImage image = random_image(4, 4, 3, 8);
    EXPECT_FALSE(read_png(write_png(image), "").srgb_tag);
    EXPECT_EQ(write_png(image).find("sRGB"), std::string::npos);
    EXPECT_EQ(write_png(image).find("gAMA"), std::string::npos);
    image.srgb_tag = true;
    EXPECT_TRUE(read_png(write_png(image), "").srgb_tag);
}

TEST(Png, keeps_text_in_order_including_utf8) {
    PngImage image = random_image(4, 4, 3, 8);
    image.text = {{"Title", "warm"}, {"Source", "na\xc3\xafve look.cube"}};
    EXPECT_EQ(read_png(write_png(image), "").text, image.text);
    image.text = {{"Title", ""}};
    EXPECT_TRUE(read_png(write_png(image), "").text.empty());
    image.text = {{std::string(80, 'k'), "v"}};
    EXPECT_THROW(write_png(image), Error);
}

TEST(Png, reads_grey_of_low_depth_scaled_to_8_bits) {
    const std::string bytes =
        Encoder{PNG_COLOR_TYPE_GRAY, 2}(4, 1, {{static_cast<png_byte>(0b00011011)}});
    const PngImage image = read_png(bytes, "");
    EXPECT_TRUE(image.grey);
    EXPECT_EQ(image.samples,
              (std::vector<std::uint16_t>{0, 0, 0, 85, 85, 85, 170, 170, 170, 255, 255, 255}));
}

TEST(Png, reads_a_palette_as_its_colors_and_its_transparency_as_alpha) {
    Encoder encoder{PNG_COLOR_TYPE_PALETTE, 8};
    encoder.palette = {{1, 2, 3}, {200, 100, 50}};
    const PngImage opaque = read_png(encoder(2, 1, {{1, 0}}), "");
    EXPECT_TRUE(opaque.palette);
    EXPECT_EQ(opaque.samples, (std::vector<std::uint16_t>{200, 100, 50, 1, 2, 3}));
    encoder.palette_alpha = {7};
    const PngImage clear = read_png(encoder(2, 1, {{1, 0}}), "");
    EXPECT_EQ(clear.samples, (std::vector<std::uint16_t>{200, 100, 50, 255, 1, 2, 3, 7}));
}

TEST(Png, reports_primaries) {
    Encoder encoder;
    EXPECT_FALSE(read_png(encoder(1, 1, {{10, 20, 30}}), "p.png").primaries_tag);
    encoder.primaries = true;
    EXPECT_TRUE(read_png(encoder(1, 1, {{10, 20, 30}}), "p.png").primaries_tag);
}

TEST(Png, never_applies_the_gamma_it_reports) {
    Encoder encoder;
    encoder.gamma = true;
    const PngImage image = read_png(encoder(1, 1, {{10, 128, 250}}), "");
    EXPECT_TRUE(image.gamma_tag);
    EXPECT_EQ(image.samples, (std::vector<std::uint16_t>{10, 128, 250}));
}

TEST(Png, reads_interlaced_16_bit_pictures_in_the_right_order) {
    const PngImage image = random_image(37, 19, 3, 16);
    std::vector<std::vector<png_byte>> rows;
    for (int y = 0; y < image.height; ++y) {
        auto& row = rows.emplace_back();
        for (int i = 0; i < image.width * 3; ++i) {
            const unsigned code = image.at({i / 3, y}, static_cast<std::size_t>(i % 3));
            row.push_back(static_cast<png_byte>(code >> 8));
            row.push_back(static_cast<png_byte>(code & 255));
        }
    }
    const PngImage back =
        read_png(Encoder{PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_ADAM7}(37, 19, rows), "");
    EXPECT_TRUE(back.interlaced);
    EXPECT_EQ(back.samples, image.samples);
}

TEST(Png, a_flipped_bit_of_the_pixels_is_an_error) {
    std::string bytes = write_png(random_image(64, 64, 3, 8));
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    EXPECT_THROW(read_png(bytes, "x.png"), Error);
}

TEST(Png, an_enormous_header_is_refused_before_its_pixels_are_allocated) {
    // A 65536x4096 picture of 16 bits in a file of 33 bytes, with the right check sum.
    std::string bytes = write_png(random_image(1, 1, 3, 16)).substr(0, 33);
    const auto patch = [&](std::uint32_t width, std::uint32_t height) {
        for (std::size_t i = 0; i < 4; ++i) {
            bytes[16 + i] = static_cast<char>(width >> (24 - 8 * i));
            bytes[20 + i] = static_cast<char>(height >> (24 - 8 * i));
        }
        std::uint32_t crc = 0xffffffffU;
        for (std::size_t i = 12; i < 29; ++i) {
            crc ^= static_cast<unsigned char>(bytes[i]);
            for (int bit = 0; bit < 8; ++bit) {
                crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320U : 0);
            }
        }
        crc = ~crc;
        for (std::size_t i = 0; i < 4; ++i) {
            bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
        }
    };
    const auto message = [&] {
        try {
            read_png(bytes, "x.png");
        } catch (const Error& e) {
            return e.message();
        }
        return std::string();
    };
    patch(65536, 4096);
    EXPECT_NE(message().find("cut short"), std::string::npos) << message();
    patch(65537, 1);
    EXPECT_NE(message().find("outside the limits"), std::string::npos) << message();
    patch(65536, 65536);
    EXPECT_NE(message().find("outside the limits"), std::string::npos) << message();
}

TEST(Png, something_else_is_called_not_a_png) {
    try {
        read_png("TITLE \"x\"\nLUT_3D_SIZE 2\n", "x.png");
        FAIL();
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "x.png: this is not a PNG file");
    }
}

} // namespace
} // namespace lutlib::io
