#include "lutlib/io/png_rows.h"

#include "lutlib/io/png.h"

#include <gtest/gtest.h>

#include <png.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace lutlib::io {
namespace {

using Bytes = std::vector<std::uint8_t>;

// PNG 3rd edition, 9.2, letter by letter: the twin of filter_row().
Bytes filtered_plainly(RowFilter filter, const Bytes& row, const Bytes& above, std::size_t step) {
    Bytes out;
    for (std::size_t x = 0; x < row.size(); ++x) {
        const int a = x < step ? 0 : row[x - step], b = above[x],
                  c = x < step ? 0 : above[x - step];
        const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
        const int predicted[] = {0, a, b, (a + b) / 2,
                                 pa <= pb && pa <= pc ? a : (pb <= pc ? b : c)};
        out.push_back(static_cast<std::uint8_t>(row[x] - predicted[static_cast<int>(filter)]));
    }
    return out;
}

Bytes noise(std::size_t count, std::uint32_t seed) {
    Bytes out;
    for (std::size_t i = 0; i < count; ++i) {
        seed = seed * 1664525 + 1013904223;
        out.push_back(static_cast<std::uint8_t>(seed >> 24));
    }
    return out;
}

TEST(PngRows, are_filtered_as_the_standard_says) {
    for (const std::size_t step : {3U, 4U, 6U, 8U}) {
        for (const std::size_t length : {step, 2 * step, 37 * step}) {
            const Bytes row = noise(length, 1), above = noise(length, 2);
            for (int filter = 0; filter < 5; ++filter) {
                Bytes out(length);
                filter_row(static_cast<RowFilter>(filter), row, above, step, out);
                EXPECT_EQ(out, filtered_plainly(static_cast<RowFilter>(filter), row, above, step))
                    << filter << ' ' << step << ' ' << length;
            }
        }
    }
}

std::uint32_t adler_of(std::span<const std::uint8_t> bytes) {
    std::uint32_t a = 1, b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

TEST(PngRows, join_the_check_sums_of_blocks) {
    const Bytes bytes = noise(200000, 3);
    for (const std::size_t first : {0U, 1U, 65521U, 131042U, 199999U, 200000U}) {
        const std::span<const std::uint8_t> all(bytes);
        EXPECT_EQ(joined_adler(adler_of(all.first(first)), adler_of(all.subspan(first)),
                               bytes.size() - first),
                  adler_of(all))
            << first;
    }
}

struct Shape {
    int width, height, channels, bits;
};

// Gradients with a little noise, so that filters and repeats have something to find.
PngPicture picture(const Shape& shape) {
    PngPicture out;
    out.width = shape.width;
    out.height = shape.height;
    out.channels = shape.channels;
    out.bits = shape.bits;
    const std::size_t count = static_cast<std::size_t>(shape.width * shape.height * shape.channels);
    out.samples = SampleBuffer(count * static_cast<std::size_t>(shape.bits / 8));
    const Bytes random = noise(count, 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t value = i / 97 + random[i] % 7;
        if (shape.bits == 16) {
            out.samples.as<std::uint16_t>()[i] = static_cast<std::uint16_t>(value);
        } else {
            out.samples.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(value);
        }
    }
    return out;
}

// By libpng, which checks every sum. In the machine's byte order.
Bytes read_by_libpng(const std::string& file, const Shape& shape) {
    png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(reader);
    struct Source {
        const std::string& file;
        std::size_t at;
    } source{file, 0};
    png_set_read_fn(reader, &source, [](png_structp p, png_bytep to, png_size_t length) {
        auto* const from = static_cast<Source*>(png_get_io_ptr(p));
        std::memcpy(to, from->file.data() + from->at, length);
        from->at += length;
    });
    const std::size_t row = static_cast<std::size_t>(shape.width * shape.channels * shape.bits / 8);
    Bytes out(row * static_cast<std::size_t>(shape.height));
    png_read_info(reader, info);
    if (shape.bits == 16) {
        png_set_swap(reader);
    }
    for (std::size_t y = 0; y < static_cast<std::size_t>(shape.height); ++y) {
        png_read_row(reader, out.data() + y * row, nullptr);
    }
    png_read_end(reader, info);
    EXPECT_EQ(source.at, file.size());
    png_destroy_read_struct(&reader, &info, nullptr);
    return out;
}

TEST(PngRows, of_large_pictures_are_read_by_libpng_and_libspng_as_they_were) {
    for (const Shape& shape :
         {Shape{700, 600, 3, 8}, Shape{601, 500, 4, 8}, Shape{401, 500, 3, 16},
          Shape{300, 500, 4, 16}, Shape{65536, 6, 3, 8}, Shape{6, 60000, 3, 8}}) {
        const PngPicture before = picture(shape);
        const std::string file = write_png(before);
        const Bytes samples(before.samples.as<std::uint8_t>().begin(),
                            before.samples.as<std::uint8_t>().end());
        EXPECT_EQ(read_by_libpng(file, shape), samples) << shape.width << ' ' << shape.channels;
        const PngPicture after = read_png_picture(file, "x.png");
        ASSERT_EQ(after.samples.size(), samples.size());
        EXPECT_EQ(std::memcmp(after.samples.data(), samples.data(), samples.size()), 0);
        EXPECT_LT(file.size(), samples.size() * 6 / 10) << "filters and repeats were not found";
    }
}

TEST(PngRows, are_the_same_bytes_on_one_core_and_on_many) {
    const PngPicture large = picture({900, 700, 3, 8});
    const std::string many = write_png(large);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(write_png(large), many);
}

TEST(PngRows, that_cannot_be_compressed_are_kept_all_the_same) {
    PngPicture before = picture({700, 600, 3, 8});
    const Bytes random = noise(before.samples.size(), 5);
    std::memcpy(before.samples.data(), random.data(), random.size());
    const PngPicture after = read_png_picture(write_png(before), "x.png");
    EXPECT_EQ(std::memcmp(after.samples.data(), random.data(), random.size()), 0);
}

} // namespace
} // namespace lutlib::io
