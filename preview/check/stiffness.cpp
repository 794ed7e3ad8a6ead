// How far a change of a millionth moves each pass and the finished picture.
#include "preview/check/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

/// The largest difference of any channel, of each texel.
std::vector<double> differences(const Observed& a, const Observed& b) {
    std::vector<double> out(a.texels());
    for (std::size_t i = 0; i < out.size(); ++i) {
        for (std::size_t c = 0; c < a.channels; ++c) {
            const double off = std::abs(static_cast<double>(a.values[a.channels * i + c]) -
                                        static_cast<double>(b.values[a.channels * i + c]));
            out[i] = std::max(out[i], std::isfinite(off) ? off : 0);
        }
    }
    return out;
}

double mean_magnitude(const Observed& observed) {
    double sum = 0;
    for (const float value : observed.values) {
        sum += std::isfinite(value) ? std::abs(static_cast<double>(value)) : 0;
    }
    return sum / static_cast<double>(std::max(observed.values.size(), std::size_t{1}));
}

struct Spread {
    double largest = 0, p99 = 0, mean = 0;
};

Spread spread_of(std::vector<double> values) {
    Spread out;
    if (values.empty()) {
        return out;
    }
    for (const double value : values) {
        out.mean += value / static_cast<double>(values.size());
        out.largest = std::max(out.largest, value);
    }
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
    std::nth_element(values.begin(), at, values.end());
    out.p99 = *at;
    return out;
}

PassMove move_of(const Observed& before, const Observed& after) {
    PassMove out{.pass = before.pass, .name = before.name};
    const double scale = mean_magnitude(before);
    if (scale > 0 && before.values.size() == after.values.size()) {
        const Spread spread = spread_of(differences(before, after));
        out.largest = spread.largest / scale;
        out.p99 = spread.p99 / scale;
        out.mean = spread.mean / scale;
    }
    return out;
}

/// Texels that stand out from the next one of their row or column.
std::size_t edge_texels(const Observed& picture) {
    const std::size_t width = picture.desc.width, height = picture.desc.height;
    const auto is_edge = [&](std::size_t a, std::size_t b) {
        for (std::size_t c = 0; c < std::min(picture.channels, std::size_t{3}); ++c) {
            if (std::abs(static_cast<double>(picture.values[picture.channels * a + c]) -
                         static_cast<double>(picture.values[picture.channels * b + c])) >=
                edge_contrast) {
                return true;
            }
        }
        return false;
    };
    std::size_t count = 0;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t at = y * width + x;
            count += (x + 1 < width && is_edge(at, at + 1)) ||
                             (y + 1 < height && is_edge(at, at + width))
                         ? 1
                         : 0;
        }
    }
    return count;
}

/// The share of a picture's texels that may move by more than a code.
double may_move(const Observed& picture, bool is_antialiased, bool moves_geometry) {
    const auto texels = static_cast<double>(picture.texels());
    double count = most_moved * texels;
    if (is_antialiased) {
        count += antialiasing_reach;
    }
    if (moves_geometry) {
        count += most_moved_of_edges * static_cast<double>(edge_texels(picture));
    }
    return count / texels;
}

/// How much more a result moves than what its pass reads of other passes: the most that any of
/// those does, and no less than the change that all began with.
double gain_of(const Graph& graph, const std::vector<Observed>& observed,
               const std::vector<PassMove>& moves, std::size_t index) {
    double read = nudge_share;
    for (const Use& use : graph.passes()[observed[index].order].uses) {
        for (std::size_t i = 0; i < observed.size(); ++i) {
            if (!use.writes && observed[i].version == use.version) {
                read = std::max(read, moves[i].mean);
            }
        }
    }
    return moves[index].mean / read;
}

} // namespace

NudgeResult Checker::check(const Nudge& row) {
    const auto in_floats = [](Situation situation) {
        situation.settings.format = Format::rgba32f;
        situation.settings.dithers = false;
        return situation;
    };
    if (!unmoved_) {
        unmoved_ = see(in_floats(situation_));
    }
    const Seen moved = see(in_floats(changed(situation_, row, nudge_share)));
    NudgeResult out{.name = row.name, .help = row.help};
    if (moved.observed.size() != unmoved_->observed.size()) {
        out.faults.emplace_back("other passes are drawn than before");
        return out;
    }
    for (std::size_t i = 0; i < moved.observed.size(); ++i) {
        out.passes.push_back(move_of(unmoved_->observed[i], moved.observed[i]));
    }
    for (std::size_t i = 0; i < out.passes.size(); ++i) {
        const double gain = gain_of(moved.graph, moved.observed, out.passes, i);
        if (gain > out.gain) {
            out.gain = gain;
            out.stiffest = out.passes[i].pass;
        }
    }
    const Observed* const before =
        with_version(unmoved_->observed, unmoved_->handles.output.version);
    const Observed* const after = with_version(moved.observed, moved.handles.output.version);
    const std::vector<double> off = differences(*before, *after);
    const Spread spread = spread_of(off);
    out.largest = 255 * spread.largest;
    out.p99 = 255 * spread.p99;
    out.moved = static_cast<double>(std::count_if(off.begin(), off.end(),
                                                  [](double value) { return 255 * value > 1; })) /
                static_cast<double>(off.size());
    if (out.p99 > most_p99) {
        out.faults.push_back(fmt::format("1 % of the finished picture moves by more than {:.2f} "
                                         "codes; {} moves {:.3g} times what it reads does",
                                         out.p99, out.stiffest, out.gain));
    }
    out.may_move =
        may_move(*before, left_by(unmoved_->observed, "fxaa") != nullptr, row.moves_geometry);
    if (out.moved > out.may_move) {
        out.faults.push_back(fmt::format("{:.2f} % of the finished picture moves by more than a "
                                         "code, and {:.2f} % may; {} moves {:.3g} times what it "
                                         "reads does",
                                         100 * out.moved, 100 * out.may_move, out.stiffest,
                                         out.gain));
    }
    return out;
}

} // namespace preview
