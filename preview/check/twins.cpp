#include "preview/check/twins.h"

#include "lutlib/half.h"
#include "preview/effects/effect.h"
#include "preview/passes/resolve.h"
#include "preview/reference/bloom.h"
#include "preview/reference/fxaa.h"
#include "preview/reference/resolve.h"
#include "preview/reference/vignette.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace preview {

namespace {

using lutlib::RgbD;
using reference::Image;

std::optional<Image> image_of(const Observed* observed) {
    if (observed == nullptr || observed->channels != 4) {
        return std::nullopt;
    }
    Image out(static_cast<int>(observed->desc.width), static_cast<int>(observed->desc.height));
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            out.pixels[i][c] = static_cast<double>(observed->values[4 * i + c]);
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

/// What the pass samples first: an observed image, or the picture that is shown. A pass of two
/// halves has the input of the first.
std::optional<Image> input_of(const Situation& situation, const Graph& graph,
                              const std::vector<Observed>& observed, std::uint32_t pass) {
    for (const Use& use : graph.passes()[pass].uses) {
        if (use.binding != BindingType::sampled_image || use.writes ||
            use.version == Version::none) {
            continue;
        }
        const std::uint32_t producer = graph.versions()[use.version].producer;
        if (producer != Version::none && graph.passes()[producer].name == resolve_along_rows) {
            return input_of(situation, graph, observed, producer);
        }
        const bool is_picture = graph.resource_of(use.version).name == "picture";
        return is_picture ? std::optional(image_of(*situation.shown->picture))
                          : image_of(with_version(observed, use.version));
    }
    return std::nullopt;
}

struct TwinInput {
    const Situation& situation;
    const Image& image;
    Size size; ///< of the result
};

double stops_of(const Situation& s) {
    return static_cast<double>(s.settings.exposure) +
           (s.shown->scene ? static_cast<double>(s.shown->scene->exposure) : 0);
}

Image resolve_twin(const TwinInput& in) {
    const auto side = [](int length) { return static_cast<std::uint32_t>(length); };
    const Size extent = fitted({side(in.image.width), side(in.image.height)}, in.size);
    const auto width = static_cast<int>(in.size.width), height = static_cast<int>(in.size.height);
    const auto inner_width = static_cast<int>(extent.width),
               inner_height = static_cast<int>(extent.height);
    return reference::resolved(
        in.image, std::exp2(stops_of(in.situation)), width, height,
        {(width - inner_width) / 2, (height - inner_height) / 2, inner_width, inner_height});
}

BloomPlan plan_for(const TwinInput& in) {
    const FrameSettings& settings = in.situation.settings;
    const bool has_bloom = settings.bloom != nullptr && !settings.without.has(Effect::bloom) &&
                           in.situation.has_light();
    return has_bloom ? bloom_plan(*settings.bloom, {in.image.width, in.image.height},
                                  settings.bloom_settings)
                     : BloomPlan{};
}

Image bloom_twin(const TwinInput& in) {
    return reference::with_bloom(plan_for(in), in.image);
}

Image finish_twin(const TwinInput& in) {
    const FrameSettings& settings = in.situation.settings;
    const Tonemap* const tonemap =
        settings.without.has(Effect::tonemap) ? tonemap_named("none") : settings.tonemap;
    Image out = bloom_twin(in);
    for (RgbD& pixel : out.pixels) {
        pixel = tonemap->apply(pixel);
    }
    return out;
}

bool is_plainly_finished(const Situation& s) {
    const bool has_look = (s.look_a != nullptr && s.settings.compare->shows_a) ||
                          (s.look_b != nullptr && s.settings.compare->shows_b);
    return s.has_light() && s.settings.compare == &compare_a &&
           (!has_look || s.settings.without.has(Effect::looks));
}

double number_of(const Situation& s, std::string_view effect, std::size_t parameter) {
    return static_cast<double>(
        number_at(use_of(s.settings.effects, *post_effect_named(effect))->values, parameter));
}

Image vignette_twin(const TwinInput& in) {
    return reference::vignette(in.image, number_of(in.situation, "vignette", 0),
                               number_of(in.situation, "vignette", 1));
}

Image fxaa_twin(const TwinInput& in) {
    return reference::fxaa(in.image, number_of(in.situation, "fxaa", 0));
}

bool is_one_picture(const Situation& s) {
    return s.settings.compare != &compare_side;
}

/// Beside a twin whose results are rounded as they should be. Cutting off in place of rounding to
/// half floats costs 3.5e-4 of the light of any picture.
constexpr double usual_drift = 1e-4, drift_of_one_texel = 0x1p-10;

struct TwinRow {
    std::string_view pass;
    double bound, floor;
    double may_be_beyond; ///< share of the texels
    double drift;         ///< of pictures of many texels
    bool (*is_known)(const Situation& situation);
    Image (*twin)(const TwinInput& in);
};
constexpr TwinRow twin_rows[] = {
    // A rounding to half floats is 2^-11, of the smallest 2^-24.
    {"hdr resolve", 0x1p-10, 0x1p-14, 0, usual_drift,
     [](const Situation& s) { return s.has_light(); }, resolve_twin},
    {"vignette", 0x1p-10, 1, 0, usual_drift, is_one_picture, vignette_twin},
    // Every stored level rounds to a half float; at most a dozen levels.
    {"bloom composite", 12.0 / 2048, 1, 0, 2e-4, [](const Situation& s) { return s.has_light(); },
     bloom_twin},
    // The same in display codes: 2.5 of 255.
    {"finish", 0.01, 1, 0, usual_drift, is_plainly_finished, finish_twin},
    // Grain and strokes in front of it are edges everywhere, and which way one runs may hang on a
    // rounding.
    {"fxaa", 0.004, 1, 0.03, 1e-3, [](const Situation&) { return true; }, fxaa_twin},
};

/// As an image of that format should keep it.
double stored(double value, Format format) {
    return format == Format::rgba16f ? static_cast<double>(lutlib::float_from_half(
                                           lutlib::half_from(std::min(value, 65504.0))))
                                     : value;
}

TwinFigure compared(const TwinRow& row, const Image& wanted, const Observed& got) {
    TwinFigure out{.pass = std::string(row.pass), .bound = row.bound};
    out.may_be_beyond = static_cast<std::uint64_t>(
        std::ceil(row.may_be_beyond * static_cast<double>(wanted.pixels.size())));
    RgbD sum_wanted, sum_got;
    for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
        double worst = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double twin = wanted.pixels[i][c],
                         pass = static_cast<double>(got.values[4 * i + c]);
            const double off = std::abs(pass - twin) / (std::abs(twin) + row.floor);
            worst = std::isnan(off) ? HUGE_VAL : std::max(worst, off);
            sum_wanted[c] += stored(twin, got.desc.format);
            sum_got[c] += pass;
        }
        out.largest = std::max(out.largest, worst);
        out.beyond += worst > row.bound ? 1 : 0;
    }
    // Bars beside a picture round to what they are; a picture that is all black is no bar.
    const auto lit = std::count_if(wanted.pixels.begin(), wanted.pixels.end(),
                                   [](const RgbD& pixel) { return pixel != RgbD{}; });
    const double texels =
        lit > 0 ? static_cast<double>(lit) : static_cast<double>(wanted.pixels.size());
    out.drift_bound = row.drift + drift_of_one_texel / std::sqrt(texels);
    for (std::size_t c = 0; c < 3; ++c) {
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
    for (const TwinRow& row : twin_rows) {
        const Observed* const result = left_by(observed, row.pass);
        if (result == nullptr || result->channels != 4 || !row.is_known(situation)) {
            continue;
        }
        if (const auto input = input_of(situation, graph, observed, result->order)) {
            const TwinInput in{situation, *input, {result->desc.width, result->desc.height}};
            out.push_back(compared(row, row.twin(in), *result));
        }
    }
    return out;
}

} // namespace preview
