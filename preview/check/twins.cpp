#include "preview/check/twins.h"

#include "lutlib/half.h"
#include "preview/check/pass_twins.h"
#include "preview/passes/resolve.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace preview {

namespace {

using lutlib::RgbD;
using reference::Image;

constexpr double drift_of_one_texel = 0x1p-10;

Image image_of(const Observed& observed) {
    Image out(static_cast<int>(observed.desc.width), static_cast<int>(observed.desc.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(observed.values[4 * i + c]);
        }
    }
    return out;
}

Image image_of(const ShownPicture& picture) {
    Image out(static_cast<int>(picture.size.width), static_cast<int>(picture.size.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(picture.rgba[4 * i + c]);
        }
    }
    return out;
}

/// What a pass samples.
struct Sampled {
    bool is_complete = false; ///< the first of it was observed, or is the picture that is shown
    Image image;              ///< the first, where it holds colours
    std::vector<const Observed*> all;
};

/// A pass of two halves has the input of the first.
Sampled sampled_by(const Situation& situation, const Graph& graph,
                   const std::vector<Observed>& observed, std::uint32_t pass) {
    Sampled out;
    for (const Use& use : graph.passes()[pass].uses) {
        if (use.binding != BindingType::sampled_image || use.writes ||
            use.version == Version::none) {
            continue;
        }
        const std::uint32_t producer = graph.versions()[use.version].producer;
        const bool is_first = out.all.empty();
        if (is_first && producer != Version::none &&
            graph.passes()[producer].name == resolve_along_rows) {
            return sampled_by(situation, graph, observed, producer);
        }
        const Observed* const found = with_version(observed, use.version);
        out.all.push_back(found);
        if (!is_first) {
            continue;
        }
        if (graph.resource_of(use.version).name == "picture") {
            out.image = image_of(*situation.shown->picture);
            out.is_complete = true;
        } else if (found != nullptr) {
            out.is_complete = true;
            out.image = found->channels == 4 ? image_of(*found) : Image();
        }
    }
    return out;
}

/// As an image of that format should keep it.
double stored(double value, Format format) {
    return format == Format::rgba16f ? static_cast<double>(lutlib::float_from_half(
                                           lutlib::half_from(std::min(value, 65504.0))))
                                     : value;
}

/// The brightest of the texels within `reach` of each, channel by channel.
Image brightest_about(const Image& image, int reach) {
    const auto along = [&](const Image& from, int dx, int dy) {
        Image out = from;
        for (int y = 0; y < from.height; ++y) {
            for (int x = 0; x < from.width; ++x) {
                for (int step = -reach; step <= reach; ++step) {
                    const RgbD& other = from.clamped(x + step * dx, y + step * dy);
                    for (std::size_t c = 0; c < 3; ++c) {
                        out.at(x, y)[c] = std::max(out.at(x, y)[c], std::abs(other[c]));
                    }
                }
            }
        }
        return out;
    };
    return along(along(image, 1, 0), 0, 1);
}

/// Bars beside a picture round to what they are; a picture that is all black is no bar.
double lit_texels(const Image& wanted) {
    const auto lit = std::count_if(wanted.pixels.begin(), wanted.pixels.end(),
                                   [](const RgbD& pixel) { return pixel != RgbD{}; });
    return lit > 0 ? static_cast<double>(lit) : static_cast<double>(wanted.pixels.size());
}

TwinFigure compared(const TwinRow& row, const Image& wanted, const Image& brightness,
                    const Observed& got) {
    TwinFigure out{.pass = std::string(row.pass), .bound = row.bound};
    out.may_be_beyond = static_cast<std::uint64_t>(
        std::ceil(row.may_be_beyond * static_cast<double>(wanted.pixels.size())));
    const std::size_t channels = got.channels == 4 ? 3 : 1;
    RgbD sum_wanted, sum_got;
    for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
        double worst = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const double twin = wanted.pixels[i][c],
                         pass = static_cast<double>(got.values[got.channels * i + c]);
            const double off =
                std::abs(pass - twin) / (std::abs(brightness.pixels[i][c]) + row.floor);
            worst = std::isnan(off) ? HUGE_VAL : std::max(worst, off);
            sum_wanted[c] += stored(twin, got.desc.format);
            sum_got[c] += pass;
        }
        out.largest = std::max(out.largest, worst);
        out.beyond += worst > row.bound ? 1 : 0;
    }
    const double texels = lit_texels(wanted);
    out.drift_bound = row.drift + drift_of_one_texel / std::sqrt(texels);
    for (std::size_t c = 0; c < channels; ++c) {
        const double drift =
            (sum_got[c] - sum_wanted[c]) / (std::abs(sum_wanted[c]) + row.floor * texels);
        out.drift = std::abs(drift) > std::abs(out.drift) ? drift : out.drift;
    }
    return out;
}

} // namespace

std::vector<TwinFigure> twin_figures(const Situation& situation, const Graph& graph,
                                     const std::vector<Observed>& observed) {
    std::vector<TwinFigure> out;
    for (const TwinRow& row : twin_rows()) {
        const Observed* const result = left_by(observed, row.pass);
        if (result == nullptr || (result->channels != 4 && result->channels != 1) ||
            !row.is_known(situation)) {
            continue;
        }
        const Sampled sampled = sampled_by(situation, graph, observed, result->order);
        if (!sampled.is_complete) {
            continue;
        }
        const TwinInput in{
            situation, sampled.image, sampled.all, {result->desc.width, result->desc.height}};
        const Image wanted = row.twin(in);
        out.push_back(compared(
            row, wanted, row.reach != nullptr ? brightest_about(in.image, row.reach(in)) : wanted,
            *result));
    }
    return out;
}

} // namespace preview
