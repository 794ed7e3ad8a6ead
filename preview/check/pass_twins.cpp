#include "preview/check/pass_twins.h"

#include "preview/check/lighting_twin.h"
#include "preview/check/seen_surfaces.h"
#include "preview/effects/effect.h"
#include "preview/passes/resolve.h"
#include "preview/reference/bloom.h"
#include "preview/reference/depth_of_field_cells.h"
#include "preview/reference/film.h"
#include "preview/reference/fxaa.h"
#include "preview/reference/occlusion.h"
#include "preview/reference/paintbrush.h"
#include "preview/reference/resolve.h"
#include "preview/reference/stylised.h"
#include "preview/reference/vignette.h"

#include <algorithm>
#include <cmath>

namespace preview {

namespace {

using lutlib::RgbD;
using reference::Image;

double stops_of(const Situation& s) {
    return static_cast<double>(s.settings.exposure) +
           (s.shown->scene ? static_cast<double>(s.shown->scene->exposure) : 0);
}

Twin resolve_twin(const TwinInput& in) {
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

Image bloomed(const TwinInput& in) {
    return reference::with_bloom(plan_for(in), in.image);
}

Twin bloom_twin(const TwinInput& in) {
    return bloomed(in);
}

Twin finish_twin(const TwinInput& in) {
    const FrameSettings& settings = in.situation.settings;
    const Tonemap* const tonemap =
        settings.without.has(Effect::tonemap) ? tonemap_named("none") : settings.tonemap;
    Image out = bloomed(in);
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

bool is_one_picture(const Situation& s) {
    return s.settings.compare != &compare_side;
}

// ---- effects

double number_of(const TwinInput& in, std::string_view effect, std::string_view parameter) {
    const PostEffect& row = *post_effect_named(effect);
    const auto found =
        std::find_if(row.parameters.begin(), row.parameters.end(),
                     [&](const lutlib::Parameter& it) { return parameter == it.name; });
    return static_cast<double>(number_at(use_of(in.situation.settings.effects, row)->values,
                                         static_cast<std::size_t>(found - row.parameters.begin())));
}

double rows_of(const TwinInput& in) {
    return in.image.height;
}

/// The number of the step of time, counted from 0 and backwards from 2^32.
std::uint32_t step_of(const TwinInput& in, std::string_view effect) {
    const double steps = std::floor(in.situation.settings.seconds * number_of(in, effect, "rate"));
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(steps));
}

double whole(double value) {
    return std::max(std::floor(value + 0.5), 1.0);
}

Twin vignette_twin(const TwinInput& in) {
    return reference::vignette(in.image, number_of(in, "vignette", "strength"),
                               number_of(in, "vignette", "angle"));
}

Twin fxaa_twin(const TwinInput& in) {
    return reference::fxaa(in.image, number_of(in, "fxaa", "strength"));
}

/// Of each texel's circle, behind the focus above 0: f/N f/(z_f - f) (1 - z_f / z) on the sensor,
/// with what is 1 / z_f in the shader's form.
std::vector<double> circles_of(const TwinInput& in) {
    const auto lens = [&](std::string_view parameter) {
        return number_of(in, "depth-of-field", parameter);
    };
    const FrameSettings& settings = in.situation.settings;
    const Observed& depth = *in.sampled[1];
    const Camera camera = camera_of(settings.orbit, static_cast<float>(depth.desc.width) /
                                                        static_cast<float>(depth.desc.height));
    const auto per_metre = [&](std::size_t texel) { // 1 / z
        return (1 - static_cast<double>(depth.values[texel])) /
               static_cast<double>(settings.orbit.near_plane);
    };
    const auto place = [](double share, std::uint32_t length) {
        return std::min(static_cast<std::uint32_t>(share * length), length - 1);
    };
    const double sensor = lens("sensor") / 1000,
                 focal = sensor / 2 * -static_cast<double>(camera.projection[1][1]);
    const std::size_t middle =
        std::size_t{place(lens("at-y"), depth.desc.height)} * depth.desc.width +
        place(lens("at-x"), depth.desc.width);
    const double focus =
        std::clamp(lens("focus") > 0 ? 1 / lens("focus") : per_metre(middle), 0.0, 0.5 / focal);
    const double largest = lens("largest") / 1000 * rows_of(in) / 2;
    std::vector<double> out;
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        const double on_sensor = focal * focal * lens("strength") / lens("aperture") *
                                 (focus - per_metre(i)) / (1 - focal * focus);
        out.push_back(std::clamp(on_sensor / sensor * rows_of(in) / 2, -largest, largest));
    }
    return out;
}

Twin lens_twin(const TwinInput& in) {
    const auto count = [&](std::string_view parameter) {
        return static_cast<int>(whole(number_of(in, "depth-of-field", parameter)));
    };
    return reference::focused_by_cells(
        in.image, circles_of(in),
        {.cell = count("cell"),
         .rings = count("rings"),
         .largest = number_of(in, "depth-of-field", "largest") / 1000 * rows_of(in) / 2});
}

int lens_reach(const TwinInput& in) {
    return static_cast<int>(number_of(in, "depth-of-field", "largest") / 1000 * rows_of(in)) + 4;
}

double fringe_of(const TwinInput& in) {
    return number_of(in, "chromatic-aberration", "strength") *
           number_of(in, "chromatic-aberration", "corner") / 1000 * rows_of(in);
}

Twin fringes_twin(const TwinInput& in) {
    return reference::chromatic_aberration(in.image, fringe_of(in));
}

int fringes_reach(const TwinInput& in) {
    return static_cast<int>(std::ceil(fringe_of(in))) + 1;
}

Twin sharpen_twin(const TwinInput& in) {
    return reference::sharpened(
        in.image, number_of(in, "sharpen", "strength"),
        static_cast<int>(whole(number_of(in, "sharpen", "reach") / 1000 * rows_of(in))));
}

Twin grain_twin(const TwinInput& in) {
    return reference::film_grain(
        in.image, {.amplitude = 0.15 * number_of(in, "film-grain", "strength"),
                   .cell = std::max(number_of(in, "film-grain", "size") / 1000 * rows_of(in), 1.0),
                   .frame = step_of(in, "film-grain"),
                   .is_colored = number_of(in, "film-grain", "colored") != 0});
}

Twin glitch_twin(const TwinInput& in) {
    const double strength = number_of(in, "glitch", "strength");
    const auto texels = [&](std::string_view parameter) {
        return number_of(in, "glitch", parameter) / 1000 * rows_of(in);
    };
    return reference::glitched(in.image, {.green_shift = strength * texels("shift"),
                                          .tear = strength * texels("tear"),
                                          .torn_lines = 0.2 * strength,
                                          .noise = strength * number_of(in, "glitch", "static"),
                                          .moment = step_of(in, "glitch"),
                                          .line = static_cast<int>(whole(texels("line")))});
}

Twin pointillism_twin(const TwinInput& in) {
    return reference::pointillism(
        in.image, {.strength = number_of(in, "pointillism", "strength"),
                   .cell = std::max(number_of(in, "pointillism", "size") / 1000 * rows_of(in), 2.0),
                   .is_colored = number_of(in, "pointillism", "colored") != 0});
}

Twin vaporwave_twin(const TwinInput& in) {
    // Of a picture all is in front.
    std::vector<bool> is_background(in.image.pixels.size(), false);
    if (in.sampled.size() > 1 && in.sampled[1] != nullptr) {
        for (std::size_t i = 0; i < is_background.size(); ++i) {
            is_background[i] = in.sampled[1]->values[i] >= 1;
        }
    }
    const double fields = in.situation.settings.seconds * number_of(in, "vaporwave", "speed");
    return reference::vaporwave(in.image, is_background,
                                {.strength = number_of(in, "vaporwave", "strength"),
                                 .field = number_of(in, "vaporwave", "field") / 1000 * rows_of(in),
                                 .moved = fields - 2 * std::floor(fields / 2)});
}

Twin paintbrush_twin(const TwinInput& in) {
    const double cell = std::max(number_of(in, "paintbrush", "size") / 1000 * rows_of(in) /
                                     (2 * reference::stroke_half_width),
                                 2.0);
    const double steps = in.situation.settings.seconds * number_of(in, "paintbrush", "rate");
    const double begun = std::floor(steps), part = steps - begun;
    return reference::painted(
        in.image,
        {.strength = number_of(in, "paintbrush", "strength"),
         .cell = cell,
         .half_length = number_of(in, "paintbrush", "length") * reference::stroke_half_width,
         .frequency = number_of(in, "paintbrush", "frequency") * cell / rows_of(in),
         .depth = begun - 256 * std::floor(begun / 256) + part * part * (3 - 2 * part),
         .coherence = number_of(in, "paintbrush", "coherence")});
}

/// Its twin looks at every stroke for each pixel.
bool is_small(const Situation& s) {
    return is_one_picture(s) && s.settings.output.width * s.settings.output.height <= 2500;
}

// ---- the scene

Twin occlusion_twin(const TwinInput& in) {
    const FrameSettings& settings = in.situation.settings;
    const reference::SeenSurfaces seen = seen_surfaces(in, *in.sampled[0], in.sampled[1]);
    const OcclusionSettings& asked = settings.occlusion;
    const std::vector<double> left = reference::occlusion(
        seen,
        {.strength = std::clamp(
             static_cast<double>(asked.strength * in.situation.shown->scene->occlusion), 0.0, 2.0),
         .radius = static_cast<double>(asked.radius),
         .samples = static_cast<int>(std::lround(asked.samples)),
         .cell = static_cast<int>(asked.resolution->side)});
    Image out(seen.width, seen.height);
    for (std::size_t i = 0; i < left.size(); ++i) {
        out.pixels[i] = {left[i], left[i], left[i]};
    }
    return out;
}

/// Beside a twin whose results are rounded as they should be. Cutting off in place of rounding to
/// half floats costs 3.5e-4 of the light of any picture.
constexpr double usual_drift = 1e-4;

constexpr TwinRow rows[] = {
    // Which texel a point falls on may hang on a rounding; such a pixel's blur is four pixels wide.
    {"ambient occlusion enlarged", 1e-3, 1, 0.02, 1e-3,
     [](const Situation& s) { return s.settings.occlusion.resolution->side > 1; }, occlusion_twin},
    {"ambient occlusion blurred along y", 1e-3, 1, 0.02, 1e-3,
     [](const Situation& s) { return s.settings.occlusion.resolution->side == 1; }, occlusion_twin},
    // A rounding to half floats is 2^-11. Where a mirror's highlight or what is nearest on a rod or
    // ring stands hangs on the roundings of floats.
    {"lighting", 0x1p-10, 0x1p-14, 0.001, usual_drift,
     [](const Situation& s) { return s.has_scene(); }, lighting_twin},
    // A rounding to half floats is 2^-11, of the smallest 2^-24.
    {"hdr resolve", 0x1p-10, 0x1p-14, 0, usual_drift,
     [](const Situation& s) { return s.has_light(); }, resolve_twin},
    // Layers keep radii as half floats, and which texel a point of a disc falls on may hang on
    // that.
    {"depth-of-field", 0x1p-6, 0x1p-14, 0.02, 2e-3, is_one_picture, lens_twin, lens_reach},
    {"chromatic-aberration", 0x1p-7, 0x1p-14, 0, 2e-3, is_one_picture, fringes_twin, fringes_reach},
    {"vignette", 0x1p-10, 1, 0, usual_drift, is_one_picture, vignette_twin},
    // Every stored level rounds to a half float; at most a dozen levels.
    {"bloom composite", 12.0 / 2048, 1, 0, 2e-4, [](const Situation& s) { return s.has_light(); },
     bloom_twin},
    // The same in display codes: 2.5 of 255.
    {"finish", 0.01, 1, 0, usual_drift, is_plainly_finished, finish_twin},
    {"sharpen", 1e-5, 1, 0, usual_drift, is_one_picture, sharpen_twin},
    // Cells' means are half floats, and what is a dot's hangs on them.
    {"pointillism", 0.004, 1, 0.02, 2e-3, is_one_picture, pointillism_twin},
    {"paintbrush", 0.01, 1, 0.01, 1e-3, is_small, paintbrush_twin},
    {"vaporwave", 1e-4, 1, 0.002, 1e-3, is_one_picture, vaporwave_twin},
    // By how many texels a line is torn may hang on a rounding.
    {"glitch", 1e-5, 1, 0.01, 1e-3, is_one_picture, glitch_twin},
    {"film-grain", 1e-4, 1, 0.002, 1e-3, is_one_picture, grain_twin},
    // Grain and strokes in front of it are edges everywhere, and which way one runs may hang on a
    // rounding.
    {"fxaa", 0.004, 1, 0.03, 1e-3, [](const Situation&) { return true; }, fxaa_twin},
};

} // namespace

std::span<const TwinRow> twin_rows() {
    return rows;
}

} // namespace preview
