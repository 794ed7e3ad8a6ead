#include "preview/check/twins.h"

#include "lutlib/half.h"
#include "preview/check/pass_twins.h"
#include "preview/check/read_by.h"
#include "preview/graph/interpose.h"
#include "preview/passes/copy.h"
#include "preview/passes/resolve.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace preview {

namespace {

using lutlib::RgbD;
using reference::Image;

constexpr double drift_of_one_texel = 0x1p-10;

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

/// Half floats hold no more light; of what the resolve reads they make infinities.
double held(double value, Format format) {
    constexpr double most = 65504;
    return format == Format::rgba16f ? std::clamp(value, -most, most) : value;
}

/// As an image of that format should keep it.
double stored(double value, Format format) {
    return format == Format::rgba16f ? static_cast<double>(lutlib::float_from_half(
                                           lutlib::half_from(held(value, format))))
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

/// What of a difference is beyond the doubt about it.
double beyond_doubt(double off, double doubt) {
    return std::isnan(off) ? HUGE_VAL : std::copysign(std::max(std::abs(off) - doubt, 0.0), off);
}

TwinFigure compared(const TwinRow& row, const Twin& should, const Observed& got) {
    const Image& wanted = should.wanted;
    const Format format = got.desc.format;
    TwinFigure out{.pass = std::string(row.pass), .bound = row.bound};
    out.may_be_beyond = static_cast<std::uint64_t>(
        std::ceil(row.may_be_beyond * static_cast<double>(wanted.pixels.size())));
    const std::size_t channels = got.channels == 4 ? 3 : 1;
    RgbD sum_wanted, sum_got, sum_doubt;
    for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
        double worst = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            const double twin = held(wanted.pixels[i][c], format),
                         pass = held(static_cast<double>(got.values[got.channels * i + c]), format),
                         doubt = should.doubt.pixels.empty() ? 0 : should.doubt.pixels[i][c];
            const double brightness = held(std::abs(should.brightness.pixels[i][c]), format);
            worst = std::max(worst,
                             std::abs(beyond_doubt(pass - twin, doubt)) / (brightness + row.floor));
            sum_wanted[c] += stored(twin, format);
            sum_got[c] += pass;
            sum_doubt[c] += doubt;
        }
        out.largest = std::max(out.largest, worst);
        out.beyond += worst > row.bound ? 1 : 0;
    }
    const double texels = lit_texels(wanted);
    out.drift_bound = row.drift + drift_of_one_texel / std::sqrt(texels);
    for (std::size_t c = 0; c < channels; ++c) {
        const double drift = beyond_doubt(sum_got[c] - sum_wanted[c], sum_doubt[c]) /
                             (std::abs(sum_wanted[c]) + row.floor * texels);
        out.drift = std::abs(drift) > std::abs(out.drift) ? drift : out.drift;
    }
    return out;
}

constexpr std::string_view drawn_over = "lighting";

/// The last version that the pass has written; none where the frame has no such pass.
std::uint32_t written_by(const Graph& graph, std::string_view pass) {
    std::uint32_t out = Version::none;
    for (std::uint32_t version = 0; version < graph.versions().size(); ++version) {
        const std::uint32_t producer = graph.versions()[version].producer;
        if (producer != Version::none && graph.passes()[producer].name == pass) {
            out = version;
        }
    }
    return out;
}

/// What a pass has left, or the copy of it; null where neither was observed.
const Observed* result_of(const Graph& graph, const std::vector<Observed>& observed,
                          std::string_view pass) {
    if (pass != drawn_over || left_by(observed, pass) != nullptr) {
        return left_by(observed, pass);
    }
    const std::uint32_t version = written_by(graph, pass);
    const auto found = std::find_if(observed.begin(), observed.end(), [&](const Observed& one) {
        const PassRecord& copy = graph.passes()[one.order];
        return copy.name == "copy" && copy.uses.front().version == version;
    });
    return version == Version::none || found == observed.end() ? nullptr : &*found;
}

} // namespace

Graph with_lighting_apart(const Graph& graph) {
    const std::uint32_t version = written_by(graph, drawn_over);
    if (version == Version::none || !graph.versions()[version].retired) {
        return graph;
    }
    return interposed(graph, ImageHandle{version}, [](Graph& copied, ImageHandle lit) {
        const ImageHandle out = add_copy(copied, lit, copied.image_desc(lit).format);
        copied.present(out);
        return out;
    });
}

std::vector<TwinFigure> twin_figures(const Situation& situation, const Graph& graph,
                                     const std::vector<Observed>& observed) {
    std::vector<TwinFigure> out;
    for (const TwinRow& row : twin_rows()) {
        const Observed* const result = result_of(graph, observed, row.pass);
        if (result == nullptr || (result->channels != 4 && result->channels != 1) ||
            !row.is_known(situation)) {
            continue;
        }
        const std::uint32_t order = result->pass == row.pass
                                        ? result->order
                                        : graph.versions()[written_by(graph, row.pass)].producer;
        const Sampled sampled = sampled_by(situation, graph, observed, order);
        if (!sampled.is_complete) {
            continue;
        }
        const TwinInput in{.situation = situation,
                           .image = sampled.image,
                           .sampled = sampled.all,
                           .size = {result->desc.width, result->desc.height},
                           .graph = graph,
                           .pass = graph.passes()[order],
                           .observed = observed};
        Twin should = row.twin(in);
        if (row.reach != nullptr) {
            should.brightness = brightest_about(in.image, row.reach(in));
        }
        out.push_back(compared(row, should, *result));
    }
    return out;
}

} // namespace preview
