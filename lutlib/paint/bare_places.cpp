#include "lutlib/paint/bare_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace lutlib {
namespace {

// Of the mean jump where a row of nodes ends against the mean step within one, and of the folds
// those that jump at all.
constexpr double least_fold = 3, least_share = 0.7;
// A step of one code of 8 bits, squared, as much as rounding leaves where nothing moves.
constexpr double rounding_step = 1e-5;
// Of a photograph with stripes as far apart as slices are wide, a half and more.
constexpr double most_unlike = 0.3;
constexpr std::size_t most_candidates = 48; ///< of a shape

/// A place by its folds alone.
struct Candidate {
    BarePlace place;
    double ratio;
};

// How much the columns jump at the folds of a shape that begins at `left`, against elsewhere; 0
// where too few do.
double fold_ratio(const std::vector<double>& steps, const std::vector<double>& sums, int left,
                  const BareShape& shape, int rows) {
    const int folds = shape.picture.width / shape.size - 1;
    const auto at = static_cast<std::size_t>(left);
    double jumps = 0;
    for (int k = 1; k <= folds; ++k) {
        jumps += steps[at + static_cast<std::size_t>(k * shape.size)];
    }
    const double all = sums[at + static_cast<std::size_t>(shape.picture.width)] - sums[at + 1];
    const double others = shape.picture.width - 1 - folds;
    const double usual = (all - jumps) / others + rounding_step * rows;
    const double ratio = jumps / folds / usual;
    if (ratio < least_fold) {
        return 0;
    }
    int jumping = 0;
    for (int k = 1; k <= folds; ++k) {
        jumping += steps[at + static_cast<std::size_t>(k * shape.size)] > 2 * usual;
    }
    return jumping >= least_share * folds ? ratio : 0;
}

// What all layouts share: neighbours within a slice's row are alike, and so are those as far apart
// as a slice is wide, against the spread of all. The larger of both, of the rows from `top` to
// before `bottom`; 1 where nothing spreads.
double unlikeness(const Picture& picture, const BareShape& shape, int left, int top, int bottom) {
    RgbD sum;
    double squares = 0, beside = 0, across = 0, pairs_beside = 0, pairs_across = 0, count = 0;
    const auto squared = [](RgbD d) { return d.r * d.r + d.g * d.g + d.b * d.b; };
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < left + shape.picture.width; ++x) {
            const RgbD c = to_double(picture.at(x, y));
            sum = sum + c;
            squares += squared(c);
            ++count;
            if ((x + 1 - left) % shape.size != 0) {
                beside += squared(to_double(picture.at(x + 1, y)) - c);
                ++pairs_beside;
            }
            if (x + shape.size < left + shape.picture.width) {
                across += squared(to_double(picture.at(x + shape.size, y)) - c);
                ++pairs_across;
            }
        }
    }
    const double variance = squares / count - squared(sum) / (count * count);
    return variance > 1e-6 ? std::max(beside / pairs_beside, across / pairs_across) / (2 * variance)
                           : 1;
}

std::vector<double> sums_of(const std::vector<double>& steps) {
    std::vector<double> out(steps.size() + 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        out[i + 1] = out[i] + steps[i];
    }
    return out;
}

// Bands of half as many rows as a slice has: one lies within it wherever it begins.
std::vector<Candidate> candidates_of(const Picture& picture, const ColumnSteps& steps,
                                     const BareShape& shape, bool quarter) {
    std::vector<Candidate> out;
    const int band = shape.size / 2;
    for (int top = 0; top + band <= steps.size().height; top += band) {
        const std::vector<double> columns = steps.of_rows(top, top + band), sums = sums_of(columns);
        std::vector<double> ratios(columns.size());
        const int last = steps.size().width - shape.picture.width;
        for (int left = 0; left <= last; ++left) {
            ratios[static_cast<std::size_t>(left)] = fold_ratio(columns, sums, left, shape, band);
        }
        // The best of its neighbourhood; one slice further most folds are met as well.
        for (int left = 0; left <= last; ++left) {
            const double ratio = ratios[static_cast<std::size_t>(left)];
            const auto from = ratios.begin() + std::max(0, left - shape.size / 2);
            const auto to = ratios.begin() + std::min(last, left + shape.size / 2) + 1;
            if (ratio > 0 && ratio >= *std::max_element(from, to) &&
                unlikeness(picture, shape, left, top, top + band) < most_unlike) {
                out.push_back({{shape, quarter, {left, top}}, ratio});
            }
        }
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Candidate& a, const Candidate& b) { return a.ratio > b.ratio; });
    out.resize(std::min(out.size(), shape.size < 32 ? most_candidates : most_candidates / 4));
    return out;
}

// Less than twice what an identity's is: only the right place has it.
double as_an_identity(int size) {
    return 2 * 2.0 / ((size - 1.0) * (size + 1.0));
}

double smoothest(const Picture& picture) {
    const std::vector<Recognition> readings = recognise(picture);
    return readings.empty() ? 1 : readings.front().roughness;
}

// Where a strip is smoothest, from a place that most of it covers.
class Fitting {
  public:
    Fitting(const Picture& picture, const BareShape& shape) : picture_(picture), shape_(shape) {}

    /// Of a strip whose upper left pixel is there; 1 where none can be.
    double roughness(Pixel place) const {
        const PictureSize size = shape_.picture;
        const bool within = place.x >= 0 && place.y >= 0 &&
                            place.x + size.width <= picture_.width &&
                            place.y + size.height <= picture_.height;
        return within && unlikeness(picture_, shape_, place.x, place.y, place.y + size.height) <
                             most_unlike
                   ? smoothest(cut(picture_, place, size))
                   : 1;
    }

    /// Takes the best of the rows from `top` to `bottom`, then goes on from slice to slice as long
    /// as that becomes smoother, and looks at the rows around once more.
    void settle(int x, int top, int bottom) {
        at = {x, top};
        take_best_row(x, top, bottom);
        for (const int step : {-shape_.size, shape_.size}) {
            while (take({at.x + step, at.y})) {
            }
        }
        take_best_row(at.x, at.y - 3, at.y + 3);
    }

    Pixel at;
    double least = 1;

  private:
    bool take(Pixel place) {
        const double found = roughness(place);
        if (!(found < least)) {
            return false;
        }
        least = found;
        at = place;
        return true;
    }
    void take_best_row(int x, int top, int bottom) {
        for (int y = top; y <= bottom; ++y) {
            take({x, y});
        }
    }

    const Picture& picture_;
    BareShape shape_;
};

// From the rows around a band that have its folds.
std::optional<BarePlace> settled(const Picture& picture, const ColumnSteps& steps,
                                 BarePlace place) {
    const BareShape shape = place.shape;
    const auto has_folds = [&](int y) {
        const std::vector<double> columns = steps.of_rows(y, y + 1);
        return fold_ratio(columns, sums_of(columns), place.at.x, shape, 1) > 0;
    };
    const int rows = shape.picture.height;
    int top = place.at.y, bottom = place.at.y + shape.size / 2;
    while (top > 0 && bottom - top < 2 * rows && has_folds(top - 1)) {
        --top;
    }
    while (bottom < picture.height && bottom - top < 2 * rows && has_folds(bottom)) {
        ++bottom;
    }
    // A slice's first and last rows may be of one colour.
    constexpr int slack = 3;
    Fitting fitting(picture, shape);
    fitting.settle(place.at.x, std::min(top, bottom - rows) - slack,
                   std::max(top, bottom - rows) + slack);
    place.at = fitting.at;
    place.roughness = fitting.least;
    return fitting.least < 1 ? std::optional(place) : std::nullopt;
}

/// Where a place lies in the picture as it is.
struct Rectangle {
    int left, top, right, bottom;
};
Rectangle rectangle_of(const BarePlace& place, PictureSize whole) {
    const Turn turn{place.quarter ? 1 : 0, false};
    const PictureSize extent = place.shape.picture;
    const Pixel a = before_turn(place.at, whole, turn),
                b = before_turn({place.at.x + extent.width - 1, place.at.y + extent.height - 1},
                                whole, turn);
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

} // namespace

bool overlap(const BarePlace& a, const BarePlace& b, PictureSize whole) {
    const Rectangle one = rectangle_of(a, whole), other = rectangle_of(b, whole);
    return one.left <= other.right && other.left <= one.right && one.top <= other.bottom &&
           other.top <= one.bottom;
}

Picture cut(const Picture& picture, Pixel at, PictureSize size) {
    Picture out{size.width, size.height, {}};
    for (int y = 0; y < size.height; ++y) {
        const auto row = picture.pixels.begin() + (at.y + y) * picture.width + at.x;
        out.pixels.insert(out.pixels.end(), row, row + size.width);
    }
    return out;
}

ColumnSteps::ColumnSteps(const Picture& picture) : picture_(picture.size()) {
    const auto width = static_cast<std::size_t>(picture_.width);
    sums_.resize(width * (static_cast<std::size_t>(picture_.height) + 1));
    for (int y = 0; y < picture_.height; ++y) {
        const double* const above = &sums_[static_cast<std::size_t>(y) * width];
        double* const here = &sums_[(static_cast<std::size_t>(y) + 1) * width];
        for (int x = 1; x < picture_.width; ++x) {
            const RgbD d = to_double(picture.at(x, y) - picture.at(x - 1, y));
            here[x] = above[x] + d.r * d.r + d.g * d.g + d.b * d.b;
        }
    }
}

std::vector<double> ColumnSteps::of_rows(int top, int bottom) const {
    const auto width = static_cast<std::size_t>(picture_.width);
    std::vector<double> out(width);
    for (std::size_t x = 0; x < width; ++x) {
        out[x] = sums_[static_cast<std::size_t>(bottom) * width + x] -
                 sums_[static_cast<std::size_t>(top) * width + x];
    }
    return out;
}

namespace {

/// The smoothest first, and none that shares pixels with one before it.
std::vector<BarePlace> apart(std::vector<BarePlace> places, PictureSize whole) {
    std::stable_sort(places.begin(), places.end(), [](const BarePlace& a, const BarePlace& b) {
        return a.roughness < b.roughness;
    });
    std::vector<BarePlace> out;
    for (const BarePlace& one : places) {
        if (std::none_of(out.begin(), out.end(),
                         [&](const BarePlace& other) { return overlap(one, other, whole); })) {
            out.push_back(one);
        }
    }
    return out;
}

} // namespace

std::vector<BarePlace> bare_places(const Picture& picture, const ColumnSteps& steps,
                                   const BareShape& shape, bool quarter, PictureSize whole) {
    std::vector<BarePlace> all;
    for (const Candidate& candidate : candidates_of(picture, steps, shape, quarter)) {
        // Most places of a strip lead to the same.
        const bool known = std::any_of(all.begin(), all.end(), [&](const BarePlace& other) {
            return other.roughness < as_an_identity(shape.size) &&
                   overlap(candidate.place, other, whole);
        });
        if (known) {
            continue;
        }
        if (const std::optional<BarePlace> place = settled(picture, steps, candidate.place)) {
            all.push_back(*place);
        }
    }
    return apart(std::move(all), whole);
}

} // namespace lutlib
