#include "converter/grade.h"

#include "lutlib/error.h"
#include "lutlib/interpolation/apply.h"
#include "lutlib/io/alpha.h"
#include "lutlib/io/file.h"
#include "lutlib/io/orientation.h"
#include "lutlib/io/samples.h"
#include "lutlib/named.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace converter {
namespace {

namespace io = lutlib::io;

constexpr std::array<AlphaRule, 4> rules{{
    {"auto", "as the file type says: EXR premultiplied, PNG straight", std::nullopt},
    {"straight", "colours are not multiplied by it", false},
    {"premultiplied", "colours are multiplied by it", true},
    {"ignore", "the look sees the colours as they are stored", std::nullopt, true},
}};

// Where a look keeps its encoding, the result goes back to the picture's; one that changes it, as
// camera LUTs do, is left to say what comes out.
lutlib::LookPlace place_of(const Grading& grading, const io::ImageInfo& image) {
    const lutlib::LookEncodings look = grading.look.encodings();
    lutlib::LookPlace place{look, encoding_of(image), {}, grading.converts, &grading.adaptation};
    if (grading.picture_encoding) {
        place.given = grading.picture_encoding;
    }
    if (grading.output_encoding) {
        place.wanted = grading.output_encoding;
    } else if (look.input && look.input == look.output) {
        place.wanted = place.given;
    }
    return place;
}

// The depth that was asked for, which the file type must hold, else the nearest to the picture's.
io::Depth choose_depth(const std::string& name, const std::string& output,
                       std::span<const io::Depth> held, io::Depth usual) {
    if (name.empty()) {
        return io::nearest_depth(usual, held);
    }
    std::vector<const io::DepthInfo*> rows;
    for (const io::Depth depth : held) {
        rows.push_back(&io::info_of(depth));
    }
    if (const auto* const row = lutlib::find_named(rows, name)) {
        return row->depth;
    }
    throw lutlib::UsageError('.' + io::extension_of(output) + " files cannot store --depth " +
                             name + "; they store " + lutlib::names_of(rows));
}

// What no table holds, colour by colour.
void apply_exactly(const lutlib::Transform& look, float* rgba, std::size_t pixels) {
    constexpr std::size_t at_once = 1 << 16;
    std::vector<lutlib::RgbD> colors;
    for (std::size_t first = 0; first < pixels; first += at_once) {
        colors.resize(std::min(at_once, pixels - first));
        float* const part = rgba + 4 * first;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            colors[i] = lutlib::to_double({part[4 * i], part[4 * i + 1], part[4 * i + 2]});
        }
        lutlib::apply_in_parallel(look, colors);
        for (std::size_t i = 0; i < colors.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                part[4 * i + c] = static_cast<float>(colors[i][c]);
            }
        }
    }
}

Graded report_of(const lutlib::LookPlace& place, const io::ImageInfo& image, io::Depth depth) {
    return {.width = image.width,
            .height = image.height,
            .has_alpha = image.alpha,
            .counts = {.pixels = image.pixels()},
            .share =
                1 - static_cast<double>(image.missing_pixels) / static_cast<double>(image.pixels()),
            .depth = &io::info_of(depth),
            .place = place};
}

// NaN lies outside of any domain, and is counted by itself.
void count_outside(const lutlib::Domain& domain, const lutlib::ConstPictureView& picture,
                   PixelCounts& counts) {
    counts.outside_domain = lutlib::pixels_outside(domain, picture);
    if (counts.outside_domain > 0) {
        const std::size_t with_nan = lutlib::pixels_with_nan(picture);
        counts.outside_domain -= with_nan;
        counts.not_a_number += with_nan;
    }
}

void apply(const Grading& grading, io::FloatImage& image, Graded& report) {
    const std::size_t pixels = report.counts.pixels;
    float* const rgba = image.rgba.data();
    const io::Look& look = grading.look;
    const auto colors = [&] {
        return lutlib::interleaved(std::as_const(image.rgba).data(), lutlib::Element::float32, 4,
                                   static_cast<std::size_t>(image.width),
                                   static_cast<std::size_t>(image.height));
    };
    const lutlib::Placement placement = report.place.applied();
    if (placement.before) {
        report.counts.not_a_number = lutlib::pixels_with_nan(colors());
        apply_exactly(conversion(*placement.before, *placement.adaptation), rgba, pixels);
    }
    if (const std::optional<lutlib::Domain> domain = look.clamps_to()) {
        count_outside(*domain, colors(), report.counts);
    }
    if (look.is_table()) {
        const bool inside = report.counts.outside_domain == 0;
        grade_floats(grading.pixels, inside, image);
        report.left_out = inside ? grading.pixels.left_out() : std::vector<std::string>{};
    } else {
        apply_exactly(look.exact(), rgba, pixels);
    }
    if (placement.after) {
        apply_exactly(conversion(*placement.after, *placement.adaptation), rgba, pixels);
    }
}

// Whether tags that say what the codes are hold for the result too.
bool keeps_encoding(const lutlib::LookPlace& place) {
    const std::optional<lutlib::Encoding> holds = place.shown().output;
    return !place.given || !holds || *holds == *place.given;
}

// The picture's codes are what it says, else what the look takes.
void require_one_encoding(const lutlib::LookPlace& place) {
    const lutlib::LookEncodings shown = place.shown();
    const std::optional<lutlib::Encoding> own = place.given ? place.given : shown.input;
    if (own && shown.output && *own != *shown.output) {
        throw lutlib::UsageError(
            "--strength mixes the picture's codes with the graded ones, and these "
            "are " +
            shown.output->name() + ", the picture's " + own->name() +
            (place.given ? "" : " (as the look takes them)") + ": add --output-encoding " +
            own->name());
    }
}

// Of two colours, as much of the second as `strength` says. What is not finite has no mixture: it
// stays at 0 alone.
void mix(std::span<const float> before, double strength, std::vector<float>& rgba) {
    const auto graded = static_cast<float>(strength), own = static_cast<float>(1 - strength);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        if (strength == 0) {
            rgba[i] = before[i];
        } else if (i % 4 != 3 && std::isfinite(before[i])) {
            rgba[i] = before[i] * own + rgba[i] * graded;
        }
    }
}

// Straight colours through the look; then as the new file stores them.
void grade_as_floats(const Grading& grading, io::FloatImage& image, const std::string& output,
                     Graded& report) {
    const AlphaRule& rule = grading.alpha;
    image.premultiplied = rule.premultiplied.value_or(image.premultiplied);
    const bool was_premultiplied = image.premultiplied;
    const io::LightOnly light = rule.ignored ? io::LightOnly{} : make_straight(image);
    const std::vector<float> before = grading.strength == 1 ? std::vector<float>{} : image.rgba;
    apply(grading, image, report);
    if (!before.empty()) {
        mix(before, grading.strength, image.rgba);
    }
    report.counts.clamped = report.depth->integer ? lutlib::pixels_outside({}, image.rgba.data(),
                                                                           report.counts.pixels, 4)
                                                  : 0;
    if (rule.ignored) {
        image.premultiplied = was_premultiplied;
    } else if (image.alpha && io::stores_premultiplied(output, image.source.get())) {
        premultiply(image, light);
    }
}

bool turns(const io::ImageInfo& image, const std::string& output) {
    return image.source->orientation > 1 && !io::holds_orientation(output, *image.source);
}

// Whether alpha, where there is any, can stay beside colours that are graded as they are stored.
bool leaves_alpha(const Grading& grading, const io::SampleImage& image, const std::string& output) {
    const bool is_straight = !grading.alpha.premultiplied.value_or(image.premultiplied) &&
                             !io::stores_premultiplied(output, image.source.get());
    return grading.alpha.ignored || is_straight || is_opaque(image);
}

// Whether samples can go through the look and into the new file as they are.
bool stays_samples(const Grading& grading, const lutlib::LookPlace& place,
                   const io::SampleImage& image, const std::string& output, io::Depth depth) {
    return depth == image.depth && !turns(image, output) && grading.strength == 1 &&
           !place.applied().converts() && grading.pixels.keeps(depth) &&
           leaves_alpha(grading, image, output);
}

std::string as_samples(const io::SampleImage& image) {
    constexpr double megabyte = 1 << 20;
    return fmt::format("floats: the {} samples go through the look as they are, and {:.1f} MB of "
                       "floats are never made",
                       io::info_of(image.depth).name,
                       static_cast<double>(image.pixels() * 4 * sizeof(float)) / megabyte);
}

// Samples of the depth of the new file through the look.
void grade_as_samples(const Grading& grading, io::SampleImage& image, const std::string& output,
                      Graded& report) {
    if (const std::optional<lutlib::Domain> domain = grading.look.clamps_to();
        domain && !report.depth->integer) {
        count_outside(*domain, view_of(std::as_const(image)), report.counts);
    }
    const bool inside = report.counts.outside_domain == 0;
    if (inside) {
        report.left_out = grading.pixels.left_out();
    }
    if (image.depth != io::Depth::float32) {
        report.left_out.push_back(as_samples(image));
    }
    grade_samples(grading.pixels, inside, image, io::samples_for(output, image));
    if (!grading.alpha.ignored) {
        image.premultiplied = image.alpha && io::stores_premultiplied(output, image.source.get());
    }
}

} // namespace

PixelCounts& PixelCounts::operator+=(const PixelCounts& more) {
    pixels += more.pixels;
    outside_domain += more.outside_domain;
    clamped += more.clamped;
    not_a_number += more.not_a_number;
    return *this;
}

std::span<const AlphaRule> alpha_rules() {
    return rules;
}

std::vector<io::Depth> require_depth(const std::string& depth, const std::string& output) {
    std::vector<io::Depth> held = io::depths_of(output);
    choose_depth(depth, output, held, held.front());
    return held;
}

Graded grade_file(const Grading& grading, const std::string& picture, const std::string& output,
                  std::span<const io::Depth> held) {
    io::SampleImage stored = io::read_samples(picture, grading.reading);
    const std::shared_ptr<const io::PictureSource> source = stored.source;
    const lutlib::LookPlace place = place_of(grading, stored);
    if (grading.strength != 1) {
        require_one_encoding(place);
    }
    const io::Depth depth = choose_depth(grading.depth, output, held, stored.depth);
    Graded report = report_of(place, stored, depth);
    report.remarks = source->remarks;
    if (stored.missing_pixels > 0) {
        report.remarks.push_back(
            fmt::format("only {:.1f} % of the picture is in its file; the rest was taken as black",
                        100 * report.share));
    }
    const io::ImageWriteOptions options{.depth = depth,
                                        .alpha = stored.alpha,
                                        // The last is for files that keep another program's name.
                                        .text = {{"Source", io::input_name(picture)},
                                                 {"Software", "lutconv"},
                                                 {"GradedWith", "lutconv"}},
                                        .keep = source.get(),
                                        .keep_color = keeps_encoding(place)};
    if (stays_samples(grading, place, stored, output, depth)) {
        grade_as_samples(grading, stored, output, report);
        report.lost = io::write_samples(output, std::move(stored), options);
        return report;
    }
    io::FloatImage image = floats_of(std::move(stored));
    grade_as_floats(grading, image, output, report);
    if (turns(image, output)) {
        image = upright(image, source->orientation);
        report.remarks.push_back("written upright, as the new file cannot say which way up it is");
        report.width = image.width;
        report.height = image.height;
    }
    report.lost = io::write_image(output, image, options);
    return report;
}

} // namespace converter
