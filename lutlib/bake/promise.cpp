#include "lutlib/bake/promise.h"

#include "lutlib/color/encoding.h"
#include "lutlib/metrics/eye_form.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/metrics/suspects.h"
#include "lutlib/nodes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lutlib {
namespace {

constexpr SampleCounts first_glance{.neutral = 64, .random = 4096, .lattice = false};
// Colours looked at before the first that breaks the promise ends it.
constexpr std::size_t at_once = 64, in_parallel = 8192, in_one_piece = 512;
// Room for the whole union grid of 33 and 128 nodes: a part of it may miss what breaks the promise.
constexpr std::size_t whole_grid = std::size_t{1} << 22;
// Of a larger one, as many colours, and as many of its middles.
constexpr SampleLimits as_many{.grid = whole_grid, .between = whole_grid};
constexpr std::size_t suspect_cells = 8192;

RgbD through_srgb(double (Encoding::*f)(double) const, RgbD c) {
    return {(srgb().*f)(c.r), (srgb().*f)(c.g), (srgb().*f)(c.b)};
}

} // namespace

namespace {

// Cells of a coarse lattice over the inputs, by what the eye sees of an error in all channels of
// the codes that come out.
std::vector<Domain> delicate_cells(const Transform& look, const Viewing& viewing) {
    constexpr int cells = 16;
    constexpr std::size_t most = 64;
    std::vector<Domain> out;
    std::vector<RgbD> codes;
    for_each_node(cells, [&](int r, int g, int b) {
        const Rgb low = Rgb{static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)} *
                        (1.0F / cells);
        out.push_back({low, low + Rgb{1, 1, 1} * (1.0F / cells)});
        codes.push_back(to_double((out.back().min + out.back().max) * 0.5F));
    });
    look(codes);
    const std::vector<EyeForm> forms = eye_forms(codes, viewing);
    std::vector<std::size_t> order(out.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto seen = [&](std::size_t i) { return forms[i].most(); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return seen(a) > seen(b); });
    std::vector<Domain> chosen;
    for (std::size_t i = 0; i < most; ++i) {
        chosen.push_back(out[order[i]]);
    }
    return chosen;
}

} // namespace

PromiseCheck::PromiseCheck(const Transform& look, const Engine& engine, const Budget& budget)
    : engine_(engine), budget_(budget), look_(held_to_codes(look)), eye_(budget.viewing),
      remembered_(sample_colors(2, first_glance)), expected_(images_of(look_, remembered_)),
      delicate_(delicate_cells(look_, budget.viewing)) {}

// What the engine's lookup weighs, without the picture.
std::vector<RgbD> PromiseCheck::read_point_samples(int size, CodeDepth depth,
                                                   std::span<const Rgb> in) const {
    const LatticeReader reader = reader_of(engine_, size);
    std::vector<NodeWeights> weights;
    std::vector<RgbD> nodes;
    for (const Rgb& color : in) {
        weights.push_back(reader.weights(to_double(color)));
        const NodeWeights& w = weights.back();
        for (std::size_t k = 0; k < w.count; ++k) {
            const auto n = static_cast<std::size_t>(size);
            const auto input = [&](std::size_t i) {
                return engine_.node_input(static_cast<int>(i), size);
            };
            nodes.push_back(
                {input(w.node[k] % n), input(w.node[k] / n % n), input(w.node[k] / n / n)});
        }
    }
    look_(nodes);
    const bool light = engine_.filtering == Filtering::light;
    std::vector<RgbD> out;
    auto node = nodes.begin();
    for (const NodeWeights& w : weights) {
        RgbD sum;
        for (std::size_t k = 0; k < w.count; ++k, ++node) {
            RgbD code;
            for (std::size_t c = 0; c < 3; ++c) {
                code[c] = depth.value(depth.code((*node)[c]));
            }
            sum = sum + w.weight[k] * (light ? through_srgb(&Encoding::decode, code) : code);
        }
        out.push_back(light ? through_srgb(&Encoding::encode, sum) : sum);
    }
    return out;
}

double PromiseCheck::glance(int size, int bits, double limit) {
    const double largest = glance_at_remembered(size, {bits}, limit);
    return largest > limit ? largest : std::max(largest, glance_at_delicate(size, {bits}, limit));
}

double PromiseCheck::glance_at_remembered(int size, CodeDepth depth, double limit) {
    double largest = 0;
    for (std::size_t first = 0; first < remembered_.size(); first += at_once) {
        const std::size_t count = std::min(at_once, remembered_.size() - first);
        const std::vector<RgbD> got =
            read_point_samples(size, depth, std::span(remembered_).subspan(first, count));
        std::array<double, at_once> error{};
        const auto errors = std::span(error).first(count);
        eye_(budget_.metric, std::span(expected_).subspan(first, count), got, errors);
        const auto worst = std::max_element(errors.begin(), errors.end());
        largest = std::max(largest, *worst);
        if (largest > limit) {
            const std::size_t at = first + static_cast<std::size_t>(worst - errors.begin());
            std::swap(remembered_.front(), remembered_[at]);
            std::swap(expected_.front(), expected_[at]);
            break;
        }
    }
    return largest;
}

// Of fine lattices only the rounding is left, which the eye sees most of in a few of their cells.
double PromiseCheck::glance_at_delicate(int size, CodeDepth depth, double limit) {
    const UnionAxes axis =
        union_axes({}, united(budget_.breaks, breaks_of(reader_of(engine_, size))));
    double largest = 0;
    std::vector<Rgb> colors;
    for (const Domain& box : delicate_) {
        std::array<std::span<const float>, 3> part;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto first = std::lower_bound(axis[c].begin(), axis[c].end(), box.min[c]);
            part[c] = {first, std::upper_bound(first, axis[c].end(), box.max[c])};
        }
        colors.clear();
        for (const float b : part[2]) {
            for (const float g : part[1]) {
                for (const float r : part[0]) {
                    colors.push_back({r, g, b});
                }
            }
        }
        if (colors.empty()) {
            continue;
        }
        std::vector<double> errors(colors.size());
        eye_(budget_.metric, images_of(look_, colors), read_point_samples(size, depth, colors),
             errors);
        largest = std::max(largest, *std::max_element(errors.begin(), errors.end()));
        if (largest > limit) {
            remember(colors, errors);
            break;
        }
    }
    return largest;
}

void PromiseCheck::remember(std::span<const Rgb> colors, std::span<const double> errors) {
    constexpr double nearly = 0.8;
    std::vector<std::size_t> worst;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (errors[i] > nearly * budget_.most) {
            worst.push_back(i);
        }
    }
    const std::size_t count = std::min(at_once, worst.size());
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(count),
                      worst.end(), [&](std::size_t a, std::size_t b) {
                          return errors[a] != errors[b] ? errors[a] > errors[b] : a < b;
                      });
    std::vector<Rgb> kept;
    for (std::size_t i = 0; i < count; ++i) {
        kept.push_back(colors[worst[i]]);
    }
    const std::vector<RgbD> right = images_of(look_, kept);
    remembered_.insert(remembered_.begin(), kept.begin(), kept.end());
    expected_.insert(expected_.begin(), right.begin(), right.end());
}

// The colours with the largest errors, from which to climb.
class PromiseCheck::Candidates {
  public:
    void add(std::span<const Rgb> colors, std::span<const double> errors) {
        for (std::size_t i = 0; i < colors.size(); ++i) {
            if (errors[i] > floor_) {
                worst_.push_back({errors[i], colors[i]});
            }
        }
        if (worst_.size() > 2 * most) {
            cut();
        }
    }
    Peak climbed(const UnionAxes& axis, const ErrorsOf& errors_of) const {
        std::vector<Rgb> colors;
        std::vector<double> errors;
        for (const Peak& peak : worst_) {
            colors.push_back(peak.at);
            errors.push_back(peak.error);
        }
        return lutlib::climbed(colors, errors, axis, errors_of);
    }

  private:
    static constexpr std::size_t most = 32768;

    void cut() {
        const auto last = worst_.begin() + static_cast<std::ptrdiff_t>(most);
        std::nth_element(worst_.begin(), last, worst_.end(),
                         [](const Peak& a, const Peak& b) { return a.error > b.error; });
        floor_ = last->error;
        worst_.erase(last, worst_.end());
    }

    double floor_ = -1;
    std::vector<Peak> worst_;
};

namespace {

// A plane of a union grid, or of the middles of the cells between two of them.
void fill_plane(std::vector<Rgb>& out, const UnionAxes& axis, std::size_t k) {
    const bool middles = k % 2 == 1;
    const auto at = [&](std::size_t c, std::size_t i) {
        return middles ? std::midpoint(axis[c][i], axis[c][i + 1]) : axis[c][i];
    };
    const std::size_t less = middles ? 1 : 0;
    out.clear();
    for (std::size_t g = 0; g < axis[1].size() - less; ++g) {
        for (std::size_t r = 0; r < axis[0].size() - less; ++r) {
            out.push_back({at(0, r), at(1, g), at(2, k / 2)});
        }
    }
}

std::vector<Rgb> greys(const UnionAxes& axis) {
    std::vector<Rgb> out;
    for (const std::vector<float>& channel : axis) {
        for (const float x : channel) {
            out.push_back({x, x, x});
        }
    }
    return out;
}

std::size_t grid_size(const UnionAxes& axis) {
    return axis[0].size() * axis[1].size() * axis[2].size();
}

} // namespace

// Of a few thousand colours: the largest error, in which case they become candidates, or one that
// exceeds the limit, whose like are remembered.
double PromiseCheck::first_beyond(double limit, const Transform& lookup, std::span<const Rgb> in,
                                  Candidates& candidates) {
    double largest = 0;
    std::vector<double> errors(std::min(in_parallel, in.size()));
    for (std::size_t first = 0; first < in.size() && largest <= limit; first += in_parallel) {
        const auto part = in.subspan(first, std::min(in_parallel, in.size() - first));
        const auto error = std::span(errors).first(part.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, part.size(), in_one_piece),
                          [&](const auto& range) {
                              error_of(lookup, part.subspan(range.begin(), range.size()),
                                       error.subspan(range.begin(), range.size()));
                          });
        largest = std::max(largest, *std::max_element(error.begin(), error.end()));
        candidates.add(part, error);
        if (largest > limit) {
            remember(part, error);
        }
    }
    return largest;
}

// All of a union grid and the middles of its cells, those first that lie near the colour that broke
// the promise last.
double PromiseCheck::along_planes(double limit, const Transform& lookup, const UnionAxes& axis,
                                  Candidates& candidates) {
    const std::vector<float>& blue = axis[2];
    const auto above = std::lower_bound(blue.begin(), blue.end() - 1, remembered_.front().b);
    const auto start = 2 * (above - blue.begin());
    std::vector<std::size_t> order(2 * blue.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [start](std::size_t a, std::size_t b) {
        return std::abs(static_cast<std::ptrdiff_t>(a) - start) <
               std::abs(static_cast<std::ptrdiff_t>(b) - start);
    });
    double largest = 0;
    std::vector<Rgb> plane;
    for (std::size_t i = 0; i < order.size() && largest <= limit; ++i) {
        fill_plane(plane, axis, order[i]);
        largest = std::max(largest, first_beyond(limit, lookup, plane, candidates));
    }
    return largest;
}

void PromiseCheck::error_of(const Transform& lookup, std::span<const Rgb> in,
                            std::span<double> errors) const {
    std::vector<RgbD> right(in.size());
    std::transform(in.begin(), in.end(), right.begin(), to_double);
    std::vector<RgbD> got = right;
    look_(right);
    lookup(got);
    eye_(budget_.metric, right, got, errors);
}

double PromiseCheck::largest_error(const Bake& bake, double limit) {
    const Breaks breaks = united(budget_.breaks, breaks_of(reader_of(engine_, bake.size)));
    const UnionAxes axis = union_axes({}, breaks);
    const Transform lookup = read_by(engine_, decoded(bake.picture), bake.size);
    Candidates candidates;
    const auto beyond = [&](std::span<const Rgb> in) {
        return first_beyond(limit, lookup, in, candidates);
    };
    double largest = beyond(greys(axis));
    const auto look_at = [&](auto&& largest_of) {
        if (largest <= limit) {
            largest = std::max(largest, largest_of());
        }
    };
    const bool whole = grid_size(axis) <= whole_grid;
    if (whole) {
        look_at([&] { return along_planes(limit, lookup, axis, candidates); });
        look_at([&] {
            return beyond(suspects(look_, lookup, axis, budget_.viewing, {.cells = suspect_cells}));
        });
    }
    look_at([&] { return beyond(even_samples({})); });
    if (!whole) {
        look_at([&] { return beyond(error_samples({}, breaks, as_many).hiding); });
    }
    if (largest > limit) {
        return largest;
    }
    const Peak peak = candidates.climbed(
        axis, [&](std::span<const Rgb> in, std::span<double> out) { error_of(lookup, in, out); });
    if (peak.error > budget_.most) {
        remember(std::span(&peak.at, 1), std::span(&peak.error, 1));
    }
    return peak.error;
}

} // namespace lutlib
