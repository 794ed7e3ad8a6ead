#include "lutlib/verify/lossy.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr int block = 8;
constexpr double most_in_block_means = 0.4;
constexpr double least_wrong = 0.5;
// In codes of 8 bits. Texels that are off by one here and there are no compression.
constexpr double least_rms = 0.35;
// Of chroma to luma: below 3 with chroma at full resolution, above 3.9 at half.
constexpr double subsampled_ratio = 3.4;

// Y, Cb, Cr of ITU-R BT.601, in which such formats work.
RgbD luma_and_chroma(RgbD e) {
    const double y = 0.299 * e.r + 0.587 * e.g + 0.114 * e.b;
    return {y, 0.564 * (e.b - y), 0.713 * (e.r - y)};
}

} // namespace

std::optional<std::string> lossy_noise(const CodeImage& picture, const Engine& engine, int size,
                                       const Transform& look) {
    const auto [pixels, values] = right_texels(picture, engine, size, look);

    struct Block {
        RgbD sum;
        double count = 0;
    };
    const auto blocks_across = static_cast<std::size_t>((picture.width + block - 1) / block);
    const auto blocks_down = static_cast<std::size_t>((picture.height + block - 1) / block);
    std::vector<Block> blocks(blocks_across * blocks_down);
    std::vector<double> distance;
    RgbD squares;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        RgbD error;
        for (std::size_t c = 0; c < 3; ++c) {
            error[c] = picture.at(pixels[i], c) - picture.depth.code(values[i][c]);
            distance.push_back(error[c]);
        }
        wrong += !(error == RgbD{});
        const RgbD e = luma_and_chroma(error);
        squares = squares + RgbD{e.r * e.r, e.g * e.g, e.b * e.b};
        Block& around = blocks[static_cast<std::size_t>(pixels[i].y / block) * blocks_across +
                               static_cast<std::size_t>(pixels[i].x / block)];
        around.sum = around.sum + e;
        ++around.count;
    }
    double in_means = 0;
    for (const Block& b : blocks) {
        for (std::size_t c = 0; c < 3 && b.count > 0; ++c) {
            in_means += b.sum[c] * b.sum[c] / b.count;
        }
    }
    const double all = squares.r + squares.g + squares.b;
    const auto count = static_cast<double>(values.size());
    const double rms_in_8_bits = std::sqrt(all / (3 * count)) * 255 / picture.depth.maximum();
    if (static_cast<double>(wrong) < least_wrong * count || rms_in_8_bits < least_rms ||
        in_means > most_in_block_means * all) {
        return std::nullopt;
    }
    const bool subsampled =
        std::sqrt(squares.g + squares.b) > subsampled_ratio * std::sqrt(squares.r);
    const int p95 = static_cast<int>(std::ceil(error_stats(std::move(distance)).p95));
    return std::string("lossy compression") +
           (subsampled ? " with colour at half resolution (as JPEG 4:2:0)" : "") + ": noise of " +
           std::to_string(p95) + " codes (95 %) that cancels out in blocks of texels";
}

} // namespace lutlib
