#include "converter/match_run.h"

#include "converter/match_remarks.h"
#include "converter/report.h"
#include "lutlib/codes.h"
#include "lutlib/error.h"
#include "lutlib/match/flat_means.h"
#include "lutlib/match/held_out.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace converter {
namespace {

// Learnt from, of all pairs together: more tell nothing new, and take memory.
constexpr std::size_t most_pixels = std::size_t{1} << 23;

// The standard deviation of a channel that says nothing against two pictures, in code values.
constexpr double little_off = 4 / 255.0;

// Of these, unless one is named, what makes the best of pixels that it was not learnt from. Looks
// are handed around in both, and one in as many nodes as the other has its kinks where they were.
constexpr std::array<int, 2> usual_sizes{33, 32};

// One pair after the other, so that a sequence needs no more memory than a frame. A single pair is
// read once.
class PairReader {
  public:
    PairReader(std::span<const PairPaths> paths, const PairEncodings& encodings)
        : paths_(paths), encodings_(encodings) {}

    std::size_t count() const { return paths_.size(); }
    const PairPaths& paths(std::size_t i) const { return paths_[i]; }
    const PicturePair& get(std::size_t i) {
        if (!pair_ || i != at_) {
            pair_.reset();
            pair_ = read_pair(paths_[i], encodings_);
            at_ = i;
            encodings_.look = pair_->look;
        }
        return *pair_;
    }

  private:
    std::span<const PairPaths> paths_;
    PairEncodings encodings_; ///< the first pair's look is that of all
    std::optional<PicturePair> pair_;
    std::size_t at_ = 0;
};

struct Gathered {
    std::vector<lutlib::PixelPair> learnt, held_out;
    std::vector<lutlib::PixelPair> held_back; ///< what is learnt from of the part held out
    std::size_t pixels = 0, left_out = 0;
};

void gather(const PicturePair& pair, std::size_t most, std::span<const lutlib::Area> without,
            Gathered& to) {
    const lutlib::Picture& before = pair.before;
    const lutlib::FlatMeans means =
        pair.is_lossy ? flat_means(before, pair.after) : lutlib::FlatMeans{};
    const lutlib::Picture &from = pair.is_lossy ? means.before : before,
                          &to_learn = pair.is_lossy ? means.after : pair.after;
    std::vector<bool> is_left_out(before.pixels.size());
    for (const lutlib::Area& area : without) {
        for (int y = area.top; y < area.bottom; ++y) {
            for (int x = area.left; x < area.right; ++x) {
                is_left_out[static_cast<std::size_t>(y) * static_cast<std::size_t>(before.width) +
                            static_cast<std::size_t>(x)] = true;
            }
        }
    }
    const std::size_t step = (before.pixels.size() + most - 1) / most;
    std::size_t i = 0;
    for (int y = 0; y < before.height; ++y) {
        for (int x = 0; x < before.width; ++x, ++i) {
            to.left_out += is_left_out[i] ? 1 : 0;
            if (i % step == 0 && !is_left_out[i]) {
                const bool is_held_out = lutlib::is_held_out(x, y);
                (is_held_out ? to.held_back : to.learnt)
                    .push_back({from.pixels[i], to_learn.pixels[i]});
                if (is_held_out) {
                    to.held_out.push_back({before.pixels[i], pair.after.pixels[i]});
                }
                ++to.pixels;
            }
        }
    }
}

lutlib::Transform rounded(const lutlib::Transform& look, int bits) {
    if (bits == 0) {
        return look;
    }
    const lutlib::CodeDepth depth{bits};
    return lutlib::in_sequence(
        {look, lutlib::Transform::each([depth](lutlib::RgbD c) {
             return lutlib::RgbD{depth.rounded(c.r), depth.rounded(c.g), depth.rounded(c.b)};
         })});
}

lutlib::ErrorStats errors_of(const std::vector<lutlib::RgbD>& a, const std::vector<lutlib::RgbD>& b,
                             const lutlib::Viewing& viewing) {
    std::vector<double> errors(a.size());
    lutlib::Eye{viewing}(lutlib::Metric::delta_e_2000, a, b, errors);
    return lutlib::error_stats(std::move(errors));
}

// The mean of each of at most 64x64 places.
void reduce(const lutlib::OnPicture& on, MatchedPair& to) {
    constexpr int most = 64;
    to.size = on.size;
    to.places = {std::min(most, on.size.width), std::min(most, on.size.height)};
    const auto columns = static_cast<std::size_t>(to.places.width);
    std::vector<double> sum(columns * static_cast<std::size_t>(to.places.height)), count = sum;
    std::size_t i = 0;
    for (int y = 0; y < on.size.height; ++y) {
        for (int x = 0; x < on.size.width; ++x, ++i) {
            const auto place =
                static_cast<std::size_t>(std::int64_t{x} * to.places.width / on.size.width) +
                columns *
                    static_cast<std::size_t>(std::int64_t{y} * to.places.height / on.size.height);
            if (on.map[i] >= 0) {
                sum[place] += static_cast<double>(on.map[i]);
                ++count[place];
            }
        }
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        to.map.push_back(sum[k] / count[k]); // NaN where nothing was counted
    }
}

class MatchRun {
  public:
    MatchRun(std::span<const PairPaths> paths, const PairEncodings& encodings,
             std::optional<int> size)
        : reader_(paths, encodings), size_(size), parts_(paths.size()) {}

    Matched run() {
        learn();
        measure();
        if (std::any_of(parts_.begin(), parts_.end(), [](const auto& p) { return !p.empty(); })) {
            learn();
            measure();
        }
        require_the_same();
        out_.remarks = remarks_of(out_);
        doubt();
        return std::move(out_);
    }

  private:
    void require_the_same() const {
        constexpr double same_from = 0.8;
        if (out_.explained >= same_from || off_ <= little_off) {
            return;
        }
        const PairPaths& paths = reader_.paths(0);
        throw lutlib::Error(fmt::format(
            "{} do not show the same before and after a grade: of what AFTER shows, {:.0f} % "
            "follows from BEFORE's colours, wherever they are laid on each other",
            reader_.count() > 1 ? "the pairs"
                                : input_text(paths.before) + " and " + input_text(paths.after),
            100 * std::max(0.0, out_.explained)));
    }

    // More than compression and noise make.
    void doubt() {
        constexpr double doubtful = 4;
        const double mean = out_.held_out ? out_.held_out->mean : out_.own.mean;
        if (mean > doubtful) {
            out_.remarks.push_back(fmt::format(
                "check that each pixel is the other's, for the look misses by dE2000 {:.1f} in the "
                "mean: pictures that were scaled or turned against each other make no look",
                mean));
        }
    }

    // A look is measured where it was not learnt from; the one that is kept has learnt from all.
    void learn() {
        Gathered pixels;
        bool is_lossy = false;
        for (std::size_t i = 0; i < reader_.count(); ++i) {
            const PicturePair& pair = reader_.get(i);
            out_.look = pair.look;
            out_.bits = pair.bits;
            is_lossy = is_lossy || pair.is_lossy;
            gather(pair, std::max<std::size_t>(1, most_pixels / reader_.count()), parts_[i],
                   pixels);
        }
        out_.left_out = pixels.left_out;
        out_.pixels = pixels.pixels;
        // Means lie between codes.
        constexpr int bits_of_means = 16;
        lutlib::MatchSettings settings{size_.value_or(usual_sizes.front()),
                                       is_lossy && out_.bits ? bits_of_means : out_.bits};
        if (pixels.held_out.empty() || pixels.learnt.empty()) {
            pixels.learnt.insert(pixels.learnt.end(), pixels.held_back.begin(),
                                 pixels.held_back.end());
            out_.match = match_look(pixels.learnt, settings);
            explain(images(out_.match, pixels.learnt));
            return;
        }
        lutlib::Match first = best_of_sizes(pixels, settings);
        settings.size = first.cube.size;
        const bool keeps_range = is_as_good_within_codes(first, pixels.held_out);
        pixels.learnt.insert(pixels.learnt.end(), pixels.held_back.begin(), pixels.held_back.end());
        out_.match = match_look(std::move(pixels.learnt), settings, &first);
        if (keeps_range) {
            hold_to_codes(first.cube);
            hold_to_codes(out_.match.cube);
        }
        measure_held_out(images(first, pixels.held_out));
    }

    static void hold_to_codes(lutlib::Lut3D& cube) {
        for (lutlib::Rgb& node : cube.nodes) {
            node = to_float(saturate(to_double(node)));
        }
    }

    // Where AFTER's codes end the pixels do not tell whether the look goes on. A lattice that does
    // is bent where they end, which one of looks that end themselves is not.
    bool is_as_good_within_codes(const lutlib::Match& match,
                                 const std::vector<lutlib::PixelPair>& pixels) const {
        if (out_.bits == 0) {
            return false;
        }
        lutlib::Match held = match;
        hold_to_codes(held.cube);
        const auto off = [&](const lutlib::Match& tried) {
            const Images made = images(tried, pixels);
            return errors_of(made.look, made.after, viewing()).mean;
        };
        constexpr double no_worse = 1.02;
        return off(held) <= no_worse * off(match);
    }

    // What a look makes of pixels, beside what they became.
    struct Images {
        std::vector<lutlib::RgbD> look, after;
    };
    Images images(const lutlib::Match& match, const std::vector<lutlib::PixelPair>& pixels) const {
        Images out;
        for (const lutlib::PixelPair& pixel : pixels) {
            const lutlib::RgbD was = to_double(pixel.before), is = to_double(pixel.after);
            if (std::isfinite(largest_magnitude(was)) && std::isfinite(largest_magnitude(is))) {
                out.look.push_back(was);
                out.after.push_back(is);
            }
        }
        lutlib::Lut lut;
        lut.cube = match.cube;
        apply_in_parallel(lutlib::Transform::of(lut), out.look);
        // What goes beyond codes that end is no miss.
        for (lutlib::RgbD& color : out.look) {
            color = out_.bits ? saturate(color) : color;
        }
        return out;
    }

    lutlib::Match best_of_sizes(const Gathered& pixels, const lutlib::MatchSettings& settings) {
        if (size_) {
            return match_look(pixels.learnt, settings);
        }
        std::array<lutlib::Match, usual_sizes.size()> matches;
        std::array<double, usual_sizes.size()> off{};
        for (std::size_t i = 0; i < usual_sizes.size(); ++i) {
            matches[i] = match_look(pixels.learnt, {usual_sizes[i], settings.bits},
                                    i > 0 ? &matches.front() : nullptr);
            const Images made = images(matches[i], pixels.held_out);
            off[i] = errors_of(made.look, made.after, viewing()).mean;
        }
        const std::ptrdiff_t best = std::min_element(off.begin(), off.end()) - off.begin();
        size_ = usual_sizes[static_cast<std::size_t>(best)];
        return std::move(matches[static_cast<std::size_t>(best)]);
    }

    void explain(const Images& images) {
        double off = 0, squares = 0;
        lutlib::RgbD sum;
        for (std::size_t i = 0; i < images.look.size(); ++i) {
            const lutlib::RgbD is = images.after[i], left = is - images.look[i];
            off += left.r * left.r + left.g * left.g + left.b * left.b;
            squares += is.r * is.r + is.g * is.g + is.b * is.b;
            sum = sum + is;
        }
        const auto n = static_cast<double>(images.look.size());
        const double variance = squares - (sum.r * sum.r + sum.g * sum.g + sum.b * sum.b) / n;
        out_.explained = variance > 0 ? 1 - off / variance : 1;
        off_ = std::sqrt(off / n / 3);
    }

    void measure_held_out(const Images& images) {
        explain(images);
        std::vector<lutlib::RgbD> kept = images.look;
        apply_in_parallel(rounded({}, out_.bits), kept);
        out_.held_out = errors_of(kept, images.after, viewing());
        out_.rounding = errors_of(images.look, kept, viewing());
    }

    void measure() {
        lutlib::Lut lut;
        lut.cube = out_.match.cube;
        const lutlib::Transform look = rounded(lutlib::Transform::of(lut), out_.bits);
        std::vector<double> errors;
        out_.pairs.clear();
        for (std::size_t i = 0; i < reader_.count(); ++i) {
            const PicturePair& pair = reader_.get(i);
            const lutlib::OnPicture on = on_picture(pair.before, pair.after, {}, look, viewing());
            const std::size_t step = 1 + on.map.size() * reader_.count() / most_pixels;
            for (std::size_t k = 0; k < on.map.size(); k += step) {
                if (on.map[k] >= 0) {
                    errors.push_back(static_cast<double>(on.map[k]));
                }
            }
            parts_[i] = on.parts;
            out_.pairs.push_back({reader_.paths(i),
                                  pair.remarks,
                                  pair.shift,
                                  on.delta_e_2000,
                                  on.edits,
                                  on.parts,
                                  {},
                                  {},
                                  {}});
            reduce(on, out_.pairs.back());
        }
        out_.own = lutlib::error_stats(std::move(errors));
        out_.coverage = lutlib::coverage_of(out_.match.support, out_.match.cube.size);
    }

    lutlib::Viewing viewing() const { return {*out_.look.output}; }

    PairReader reader_;
    std::optional<int> size_;
    std::vector<std::vector<lutlib::Area>> parts_; ///< of each pair
    double off_ = 0; ///< the standard deviation of a channel from what was graded
    Matched out_;
};

} // namespace

Matched match_pairs(std::span<const PairPaths> paths, const PairEncodings& encodings,
                    std::optional<int> size) {
    return MatchRun(paths, encodings, size).run();
}

} // namespace converter
