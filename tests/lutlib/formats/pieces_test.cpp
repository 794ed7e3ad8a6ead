// A text in pieces reads as the same text whole, wherever the pieces end.
#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace lutlib {
namespace {

class Pieces final : public ByteSource {
  public:
    Pieces(std::string_view text, std::size_t size) : text_(text), size_(size) {}

    std::size_t read(char* to, std::size_t most) override {
        const std::size_t count = std::min({most, size_, text_.size()});
        std::copy_n(text_.begin(), count, to);
        text_.remove_prefix(count);
        return count;
    }
    std::size_t remaining() const override { return text_.size(); }

  private:
    std::string_view text_;
    std::size_t size_;
};

std::vector<std::string> lines_of(LineScanner scanner) {
    std::vector<std::string> out;
    std::string_view line;
    while (scanner.next(line)) {
        out.emplace_back(line);
    }
    return out;
}

TEST(LineScanner, finds_the_same_lines_in_pieces_of_any_size) {
    const std::string text = "\xEF\xBB\xBF"
                             "one\r\ntwo\rthree\n\n\r\n\r\rlonger line\r\nlast";
    const std::vector<std::string> whole = lines_of(LineScanner(text));
    ASSERT_EQ(whole.size(), 9U);
    for (std::size_t head = 3; head <= text.size(); ++head) {
        for (std::size_t size = 1; size < 9; ++size) {
            Pieces more(std::string_view(text).substr(head), size);
            EXPECT_EQ(lines_of(LineScanner(std::string_view(text).substr(0, head), more)), whole)
                << head << ' ' << size;
        }
    }
}

TEST(LineScanner, holds_a_line_that_is_longer_than_its_buffer) {
    std::string text(300000, 'x');
    text.append("\nend");
    Pieces more(text, 5000);
    const std::vector<std::string> lines = lines_of(LineScanner({}, more));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].size(), 300000U);
    EXPECT_EQ(lines[1], "end");
}

// What comes of a text: the table, or the error.
std::string outcome(const std::function<Lut()>& read) {
    try {
        const Lut lut = read();
        std::string out = lut.title + '|' + std::to_string(lut.comments.size()) + '|' +
                          std::to_string(lut.keywords.size());
        const std::vector<Rgb>& rows = lut.cube ? lut.cube->nodes : lut.shaper->entries;
        for (const Rgb& row : rows) {
            out += ' ' + std::to_string(row.r) + ' ' + std::to_string(row.g) + ' ' +
                   std::to_string(row.b);
        }
        return out;
    } catch (const Error& error) {
        return error.what();
    }
}

// Rows of many forms: fixed, short, with exponents, comments and blank lines between.
std::string cube_text(int size, unsigned seed) {
    std::mt19937 random(seed);
    std::string out = "# a comment\nTITLE \"Mine\"\nLUT_3D_SIZE " + std::to_string(size) + '\n';
    for (int i = 0; i < size * size * size; ++i) {
        const auto number = [&]() -> std::string {
            const double value = static_cast<double>(random() % 1000000) / 1e6;
            switch (random() % 4) {
            case 0:
                return std::to_string(value);
            case 1:
                return "0";
            case 2:
                return std::to_string(value) + "e-02";
            default:
                return std::to_string(value).substr(0, 5);
            }
        };
        out += number() + ' ' + number() + (random() % 9 == 0 ? "\t" : " ") + number();
        out += random() % 5 == 0 ? "\r\n" : "\n";
        out += random() % 40 == 0 ? "# between\n" : random() % 40 == 0 ? "\n" : "";
    }
    return out;
}

TEST(CubeInPieces, reads_as_the_whole_file_does_and_refuses_what_it_refuses) {
    std::vector<std::string> texts;
    for (unsigned seed = 0; seed < 4; ++seed) {
        texts.push_back(cube_text(4, seed));
    }
    const std::string good = texts[0];
    texts.push_back(good.substr(0, good.size() - 30));            // truncated
    texts.push_back(good + "0 0 0\n");                            // overlong
    texts.push_back(good.substr(0, good.size() / 2) + "x y z\n"); // damaged
    texts.push_back("LUT_3D_SIZE 200\n0 0 0\n");
    texts.push_back("LUT_1D_SIZE 2\n0 0 0\n1 1 1");
    for (const std::string& text : texts) {
        const std::string whole = outcome([&] { return read_cube(text, "x.cube"); });
        for (const std::size_t head : {std::size_t{1}, std::size_t{20}, text.size() / 3}) {
            for (const std::size_t size : std::initializer_list<std::size_t>{1, 7, 64, 129, 4096}) {
                Pieces more(std::string_view(text).substr(head), size);
                EXPECT_EQ(outcome([&] {
                              return read_cube_in_pieces(std::string_view(text).substr(0, head),
                                                         more, "x.cube");
                          }),
                          whole)
                    << head << ' ' << size;
            }
        }
    }
}

} // namespace
} // namespace lutlib
