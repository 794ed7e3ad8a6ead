#include "lutlib/verify/moved.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lutlib {
namespace {

// Of the texels, what must be right in another place.
constexpr double convincing_share = 0.98;

// Whether a texel holds a look's value.
class Holds {
  public:
    Holds(const CodeImage& picture, const Transform& look)
        : picture_(picture), tolerance_(tolerance_of(look.precision())) {}

    bool operator()(Pixel at, RgbD value) const {
        for (std::size_t c = 0; c < 3; ++c) {
            if (!is_rounded(picture_.at(at, c), saturate(value[c]), picture_.depth.maximum(),
                            tolerance_)) {
                return false;
            }
        }
        return true;
    }

  private:
    const CodeImage& picture_;
    double tolerance_;
};

// Of every `step`-th texel that such a move leaves within the picture.
struct Share {
    std::size_t within = 0, right = 0;

    bool convinces(double least) const {
        return within > 0 && static_cast<double>(right) >= least * static_cast<double>(within);
    }
};

Share share_of(const CodeImage& picture, const RightTexels& texels, const Holds& holds, int across,
               int down, std::size_t step) {
    Share out;
    for (std::size_t i = 0; i < texels.pixels.size(); i += step) {
        const Pixel at{texels.pixels[i].x + across, texels.pixels[i].y + down};
        if (at.x < 0 || at.x >= picture.width || at.y < 0 || at.y >= picture.height) {
            continue;
        }
        ++out.within;
        out.right += holds(at, texels.values[i]);
    }
    return out;
}

std::string distance(int count, const char* unit, const char* forwards, const char* backwards) {
    return std::to_string(std::abs(count)) + " " + unit + (std::abs(count) == 1 ? " " : "s ") +
           (count > 0 ? forwards : backwards);
}

} // namespace

std::optional<Diagnosis> shifted(const CodeImage& picture, const Engine& engine, int size,
                                 const Transform& look) {
    constexpr int furthest = 8;
    constexpr double worth_a_look = 0.9;
    const RightTexels texels = right_texels(picture, engine, size, look);
    const Holds holds(picture, look);
    // A prime, so that no axis is met in step.
    const std::size_t sparse = texels.pixels.size() < 8192 ? 7 : 61;
    std::vector<int> columns{-size, size}, rows;
    for (int i = -furthest; i <= furthest; ++i) {
        columns.push_back(i);
        rows.push_back(i);
    }
    std::optional<Diagnosis> best;
    for (const int down : rows) {
        for (const int across : columns) {
            const bool moves = across != 0 || down != 0;
            const bool part =
                2 * std::abs(across) < picture.width && 2 * std::abs(down) < picture.height;
            if (!moves || !part ||
                !share_of(picture, texels, holds, across, down, sparse).convinces(worth_a_look)) {
                continue;
            }
            const Share all = share_of(picture, texels, holds, across, down, 1);
            const double share = static_cast<double>(all.right) / static_cast<double>(all.within);
            if (!all.convinces(convincing_share) || (best && best->explained >= share)) {
                continue;
            }
            const std::string sideways =
                across == 0 ? "" : distance(across, "column", "to the right", "to the left");
            const std::string upright = down == 0 ? "" : distance(down, "row", "down", "up");
            best = {"the picture is shifted by " + sideways +
                        (sideways.empty() || upright.empty() ? "" : " and ") + upright +
                        ": cut it out or place it anew; the share is of what still lies in it",
                    share};
        }
    }
    return best;
}

std::optional<Diagnosis> slices_exchanged(const CodeImage& picture, const Engine& engine, int size,
                                          const Transform& look) {
    const auto [pixels, values] = right_texels(picture, engine, size, look);
    const Holds holds(picture, look);
    const std::size_t in_slice = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    const auto most_wrong =
        static_cast<std::size_t>((1 - convincing_share) * static_cast<double>(in_slice));
    // The texels of the place of slice `at` that hold slice `of`; fewer where that is hopeless.
    const auto right_in = [&, &where = pixels, &what = values](std::size_t at, std::size_t of) {
        std::size_t right = 0, wrong = 0;
        for (std::size_t i = 0; i < in_slice && wrong <= most_wrong; ++i) {
            const bool held = holds(where[at * in_slice + i], what[of * in_slice + i]);
            right += held;
            wrong += !held;
        }
        return std::pair(right, wrong <= most_wrong);
    };
    const auto count = static_cast<std::size_t>(size);
    std::vector<std::pair<std::size_t, std::size_t>> moved; // place and slice
    std::size_t right = 0;
    for (std::size_t at = 0; at < count; ++at) {
        auto [texels, is_it] = right_in(at, at);
        for (std::size_t of = 0; !is_it && of < count; ++of) {
            std::tie(texels, is_it) = right_in(at, of);
            if (is_it) {
                moved.emplace_back(at, of);
            }
        }
        if (!is_it) {
            return std::nullopt;
        }
        right += texels;
    }
    if (moved.empty()) {
        return std::nullopt;
    }
    const double share = static_cast<double>(right) / static_cast<double>(values.size());
    const auto number = [](std::size_t i) { return std::to_string(i); };
    const bool is_pair =
        moved.size() == 2 && moved[0].first == moved[1].second && moved[0].second == moved[1].first;
    return Diagnosis{
        is_pair ? "the slices " + number(moved[0].first) + " and " + number(moved[0].second) +
                      " of blue, counted from 0, are swapped"
                : number(moved.size()) + " slices of blue stand in the wrong place: where slice " +
                      number(moved[0].first) + " should be, counted from 0, is slice " +
                      number(moved[0].second),
        share};
}

} // namespace lutlib
