// The names of looks on a finished picture.
#include "preview/passes/names.h"
#include "tests/preview/passes/finish_fixture.h"

#include <algorithm>

namespace preview {
namespace {

using BytesOfPicture = std::vector<std::uint8_t>;
constexpr std::uint32_t width = 320, height = 120;

class NamesTest : public FinishTest {
  protected:
    static BytesOfPicture grey() { return BytesOfPicture(std::size_t{4} * width * height, 100); }

    static BytesOfPicture run(const Compare& compare, std::array<std::string_view, 2> names) {
        const gpu::Image image = upload({Format::rgba8, width, height}, grey());
        Graph graph;
        const ImageHandle out =
            add_names(graph, graph.import("codes", image, image.desc()), compare, names);
        graph.present(out);
        Executor executor(device());
        executor.render(graph);
        return as<std::uint8_t>(executor.read_image(out));
    }

    struct Box {
        int low_x = width, high_x = -1, low_y = height, high_y = -1, ink = 0;
    };
    /// Of the texels that differ from the grey, from column `from` to `to`.
    static Box changed(const BytesOfPicture& codes, std::uint32_t from, std::uint32_t to) {
        Box box;
        for (std::uint32_t y = 0; y < height; ++y) {
            for (std::uint32_t x = from; x < to; ++x) {
                const std::size_t at = (std::size_t{y} * width + x) * 4;
                EXPECT_EQ(codes[at + 3], 100) << "alpha is not a name's to change";
                if (codes[at] != 100) {
                    box = {std::min(box.low_x, static_cast<int>(x)),
                           std::max(box.high_x, static_cast<int>(x)),
                           std::min(box.low_y, static_cast<int>(y)),
                           std::max(box.high_y, static_cast<int>(y)),
                           box.ink + (codes[at] == 255 ? 1 : 0)};
                }
            }
        }
        return box;
    }
};

TEST_F(NamesTest, each_side_has_its_own_in_its_upper_corner_and_the_rest_stays_as_it_is) {
    for (const Compare* compare : {&compare_split, &compare_side}) {
        const BytesOfPicture codes = run(*compare, {"warm", "a much longer name"});
        const Box a = changed(codes, 0, width / 2), b = changed(codes, width / 2, width);
        EXPECT_EQ(a.low_x, 4);
        EXPECT_EQ(a.high_x - a.low_x + 1, 7 * 6 + 3);
        EXPECT_EQ(b.high_x - b.low_x + 1, 21 * 6 + 3);
        EXPECT_EQ(compare == &compare_side ? b.low_x : width - 1 - b.high_x,
                  compare == &compare_side ? width / 2 + 4U : 4U);
        for (const Box& box : {a, b}) {
            EXPECT_EQ(box.low_y, 4);
            EXPECT_EQ(box.high_y, 13);
            EXPECT_GT(box.ink, 30);
        }
    }
}

TEST_F(NamesTest, letters_are_told_apart_and_any_name_fits) {
    std::vector<BytesOfPicture> seen;
    for (const char c : std::string_view("0123456789abcdefghijklmnopqrstuvwxyz.-_+:? ")) {
        seen.push_back(run(compare_split, {std::string_view(&c, 1), ""}));
        for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
            EXPECT_NE(seen.back(), seen[i]) << c;
        }
    }
    const std::string endless(1000, 'w');
    const Box box = changed(run(compare_split, {endless, endless}), 0, width);
    EXPECT_LT(box.high_x, static_cast<int>(width));
    // One question mark a character, whatever its bytes.
    EXPECT_EQ(run(compare_split, {"\xC3\xA4\xE2\x82\xAC", "x"}), run(compare_split, {"??", "x"}));
    EXPECT_EQ(run(compare_split, {"Warm", "x"}), run(compare_split, {"wARM", "x"}));
}

} // namespace
} // namespace preview
