#include "lutlib/io/png_stream.h"

#include "lutlib/error.h"
#include "lutlib/io/png.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lutlib::io {
namespace {

// Gives a few bytes at a time, as pipes do.
class Trickle final : public ByteSource {
  public:
    Trickle(std::string bytes, std::size_t at_once) : bytes_(std::move(bytes)), most_(at_once) {}
    std::size_t read(char* to, std::size_t most) override {
        const std::size_t count = bytes_.copy(to, std::min(most, most_), at_);
        at_ += count;
        return count;
    }
    std::size_t remaining() const override { return 0; }
    std::size_t taken() const { return at_; }

  private:
    std::string bytes_;
    std::size_t most_, at_ = 0;
};

std::string picture(int width) {
    PngImage image;
    image.width = width;
    image.height = 2;
    image.samples.assign(static_cast<std::size_t>(width) * 6, 77);
    return write_png(image);
}

const std::string name = "pipe";

TEST(PngStream, gives_each_file_and_takes_nothing_beyond_it) {
    const std::string first = picture(3), second = picture(500);
    for (const std::size_t at_once : {1U, 7U, 100000U}) {
        Trickle source(first + second, at_once);
        PngStream stream(source, name);
        EXPECT_EQ(stream.next(), first);
        EXPECT_EQ(source.taken(), first.size());
        EXPECT_EQ(stream.next(), second);
        EXPECT_EQ(stream.next(), std::nullopt);
    }
}

TEST(PngStream, that_breaks_off_anywhere_says_so) {
    const std::string one = picture(3);
    for (std::size_t length = 1; length < one.size(); ++length) {
        Trickle source(one + one.substr(0, length), 64);
        PngStream stream(source, name);
        EXPECT_EQ(stream.next(), one);
        EXPECT_THROW(stream.next(), Error) << length;
    }
}

TEST(PngStream, refuses_what_is_no_png_and_lengths_that_are_lies) {
    std::string lie = picture(3);
    lie[8] = '\x7f';
    for (const std::string& bytes : {std::string("no picture at all"), lie}) {
        Trickle source(bytes, 64);
        PngStream stream(source, name);
        EXPECT_THROW(stream.next(), Error);
    }
}

} // namespace
} // namespace lutlib::io
