#include "lutlib/paint/on_picture.h"

#include "lutlib/color/luma.h"
#include "lutlib/error.h"
#include "lutlib/number_text.h"
#include "lutlib/paint/line_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lutlib {
namespace {

constexpr int block = 16;
// dE2000 of a block that was edited: above what a steep look loses between 16 nodes, and what the
// picture's usual block has.
constexpr double seen = 2, above_usual = 4;
// Of it, what the block's mean colour must be off by at least.
constexpr double seen_in_the_mean = 0.5;
// Of the squared differences, what an explanation must take away to be named, and of a step how
// much is worth a word.
constexpr double telling = 0.3, worth_a_word = 0.03;
// Of luma, 0..1, between the middle and the corners.
constexpr double shading_seen = 0.01;

struct Pixels {
    PictureSize size;
    std::vector<float> expected, got; ///< luma through the look, and as it is
    std::vector<float> map;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    }
    bool counts(int x, int y) const { return map[index(x, y)] >= 0; }
    double off(int x, int y) const {
        return static_cast<double>(got[index(x, y)] - expected[index(x, y)]);
    }
};

std::string hundredths(double value) {
    const long all = std::lround(100 * value);
    const std::string rest = std::to_string(all % 100);
    return std::to_string(all / 100) + "." + (rest.size() < 2 ? "0" : "") + rest;
}

// Against the square of the distance from the middle, 1 in the corners.
std::string shading_in(const Pixels& pixels) {
    LineFit line;
    for (int y = 0; y < pixels.size.height; ++y) {
        for (int x = 0; x < pixels.size.width; ++x) {
            if (pixels.counts(x, y)) {
                const double across = 2 * (x + 0.5) / pixels.size.width - 1,
                             down = 2 * (y + 0.5) / pixels.size.height - 1;
                line.add((across * across + down * down) / 2, pixels.off(x, y));
            }
        }
    }
    const double step = line.slope();
    if (line.explained() < telling || std::abs(step) < shading_seen) {
        return "";
    }
    return std::string("the picture becomes ") + (step < 0 ? "darker" : "brighter") +
           " towards its corners, by " + percent(std::abs(step)) +
           " of white, as a vignette makes it: that is not in the look";
}

// Against how far a pixel stands out of the four beside it.
std::string edges_in(const Pixels& pixels) {
    LineFit line;
    for (int y = 1; y + 1 < pixels.size.height; ++y) {
        for (int x = 1; x + 1 < pixels.size.width; ++x) {
            if (!(pixels.counts(x, y) && pixels.counts(x - 1, y) && pixels.counts(x + 1, y) &&
                  pixels.counts(x, y - 1) && pixels.counts(x, y + 1))) {
                continue;
            }
            const auto at = [&](int dx, int dy) {
                return static_cast<double>(pixels.expected[pixels.index(x + dx, y + dy)]);
            };
            line.add(at(0, 0) - (at(-1, 0) + at(1, 0) + at(0, -1) + at(0, 1)) / 4,
                     pixels.off(x, y));
        }
    }
    if (line.count() < 2 || line.explained() < telling || std::abs(line.slope()) < worth_a_word) {
        return "";
    }
    return line.slope() > 0 ? "the picture was sharpened (by " + percent(line.slope()) +
                                  " of how far pixels stand out): that is not in the look"
                            : "the picture was blurred (by " + percent(-line.slope()) +
                                  " of how far pixels stand out): that is not in the look";
}

// Of the mean colour of each block, row by row: compression, noise and sharpening leave that where
// it was, edits do not.
std::vector<double> off_in_the_mean(PictureSize size, const std::vector<std::size_t>& places,
                                    const std::vector<RgbD>& expected, const std::vector<RgbD>& got,
                                    const Eye& eye) {
    const auto width = static_cast<std::size_t>(size.width);
    const std::size_t side = block, columns = (width + side - 1) / side;
    std::vector<double> count(columns *
                              ((static_cast<std::size_t>(size.height) + side - 1) / side));
    std::vector<RgbD> wanted(count.size()), is = wanted;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t at = places[i] / width / side * columns + places[i] % width / side;
        wanted[at] = wanted[at] + expected[i];
        is[at] = is[at] + got[i];
        ++count[at];
    }
    for (std::size_t at = 0; at < count.size(); ++at) {
        const double share = 1 / std::max(1.0, count[at]);
        wanted[at] = share * wanted[at];
        is[at] = share * is[at];
    }
    std::vector<double> out(count.size());
    eye(Metric::delta_e_2000, wanted, is, out);
    return out;
}

// Blocks that are further off than is usual in this picture, and in the mean too; they go to
// `parts`.
std::string parts_in(const Pixels& pixels, const std::vector<double>& mean_off,
                     std::vector<Area>& parts) {
    struct Block {
        int x, y;
        double mean, of_mean;
    };
    std::vector<Block> blocks;
    std::size_t at = 0;
    for (int top = 0; top < pixels.size.height; top += block) {
        for (int left = 0; left < pixels.size.width; left += block, ++at) {
            double sum = 0, count = 0;
            for (int y = top; y < std::min(top + block, pixels.size.height); ++y) {
                for (int x = left; x < std::min(left + block, pixels.size.width); ++x) {
                    if (pixels.counts(x, y)) {
                        sum += static_cast<double>(pixels.map[pixels.index(x, y)]);
                        ++count;
                    }
                }
            }
            if (count > 0) {
                blocks.push_back({left, top, sum / count, mean_off[at]});
            }
        }
    }
    std::vector<double> means;
    for (const Block& one : blocks) {
        means.push_back(one.mean);
    }
    const auto middle = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2);
    std::nth_element(means.begin(), middle, means.end());
    const double least = std::max(seen, above_usual * *middle);
    int left = pixels.size.width, top = pixels.size.height, right = 0, bottom = 0;
    double most = 0;
    for (const Block& one : blocks) {
        if (one.mean <= least || one.of_mean <= seen_in_the_mean * one.mean) {
            continue;
        }
        parts.push_back({one.x, one.y, std::min(one.x + block, pixels.size.width),
                         std::min(one.y + block, pixels.size.height)});
        most = std::max(most, one.mean);
        left = std::min(left, one.x);
        top = std::min(top, one.y);
        right = std::max(right, parts.back().right);
        bottom = std::max(bottom, parts.back().bottom);
    }
    if (parts.empty()) {
        return "";
    }
    const double share = static_cast<double>(parts.size()) / static_cast<double>(blocks.size());
    return (share < 0.01 ? "less than 1 %" : percent(share)) + " of the picture, between x " +
           std::to_string(left) + " and " + std::to_string(right) + ", y " + std::to_string(top) +
           " and " + std::to_string(bottom) +
           ", was edited by itself, as through a mask or with a brush (up to dE2000 " +
           hundredths(most) + " in places of 16x16 pixels): that is not in the look";
}

} // namespace

OnPicture on_picture(const Picture& before, const Picture& after, const Area& except,
                     const Transform& look, const Viewing& viewing) {
    std::vector<RgbD> expected, got;
    std::vector<std::size_t> places;
    Pixels pixels{before.size(), {}, {}, {}};
    pixels.map.assign(before.pixels.size(), -1);
    for (int y = 0; y < before.height; ++y) {
        for (int x = 0; x < before.width; ++x) {
            const RgbD was = to_double(before.at(x, y)), is = to_double(after.at(x, y));
            if (!except.holds(x, y) && std::isfinite(largest_magnitude(was)) &&
                std::isfinite(largest_magnitude(is))) {
                places.push_back(pixels.index(x, y));
                expected.push_back(was);
                got.push_back(is);
            }
        }
    }
    if (places.empty()) {
        throw Error("nothing of the picture is left to compare");
    }
    apply_in_parallel(look, expected);
    std::vector<double> errors(places.size());
    const Eye eye{viewing};
    eye(Metric::delta_e_2000, expected, got, errors);
    const std::vector<double> mean_off = off_in_the_mean(pixels.size, places, expected, got, eye);
    pixels.expected.resize(before.pixels.size());
    pixels.got = pixels.expected;
    for (std::size_t i = 0; i < places.size(); ++i) {
        pixels.map[places[i]] = static_cast<float>(errors[i]);
        pixels.expected[places[i]] = static_cast<float>(luma(expected[i]));
        pixels.got[places[i]] = static_cast<float>(luma(got[i]));
    }
    OnPicture out;
    out.delta_e_2000 = error_stats(std::move(errors));
    // Single pixels of grain are no edit.
    for (const std::string& edit :
         {shading_in(pixels), edges_in(pixels), parts_in(pixels, mean_off, out.parts)}) {
        if (!edit.empty()) {
            out.edits.push_back(edit);
        }
    }
    out.size = pixels.size;
    out.map = std::move(pixels.map);
    return out;
}

} // namespace lutlib
