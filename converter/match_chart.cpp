#include "converter/match_chart.h"

#include "lutlib/color/swatches.h"
#include "lutlib/error.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/file.h"
#include "lutlib/match/match_patches.h"
#include "lutlib/recipe/placement.h"

#include <array>
#include <charconv>
#include <utility>

namespace converter {
namespace {

struct ChartColors {
    std::array<lutlib::RgbD, lutlib::chart_patches> patches;
    lutlib::Encoding encoding;
    std::vector<std::string> remarks;
};

ChartColors chart_colors(const std::optional<ChartPicture>& chart,
                         const std::optional<lutlib::Encoding>& named, const char* option) {
    if (!chart) {
        return {lutlib::published_chart(), lutlib::srgb(), {}};
    }
    LonePicture picture = read_lone(chart->path, named, option);
    try {
        return {chart_in(picture.colors, chart->area), picture.encoding,
                std::move(picture.remarks)};
    } catch (const lutlib::Error& error) {
        throw error.in_file(lutlib::io::input_name(chart->path));
    }
}

void convert_patches(ChartColors& colors, const lutlib::Encoding& to) {
    if (colors.encoding != to) {
        lutlib::conversion({colors.encoding, to})(colors.patches);
    }
}

} // namespace

lutlib::ChartArea chart_area_of(const std::string& text, const std::string& option) {
    std::array<int, 4> numbers{};
    const char *at = text.data(), *const end = text.data() + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto read = std::from_chars(at, end, numbers[i]);
        const bool is_last = i + 1 == numbers.size();
        if (read.ec != std::errc() || (read.ptr == end) != is_last ||
            (!is_last && *read.ptr != ',')) {
            throw lutlib::UsageError(option +
                                     " takes a rectangle X,Y,WIDTH,HEIGHT in pixels, as "
                                     "120,80,600,400, not '" +
                                     text + "'");
        }
        at = is_last ? read.ptr : read.ptr + 1;
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

Matched match_charts(const std::optional<ChartPicture>& before,
                     const std::optional<ChartPicture>& after, const PairEncodings& encodings,
                     int size) {
    ChartColors was = chart_colors(before, encodings.pictures.input, "--before-encoding"),
                is = chart_colors(after, encodings.pictures.output, "--after-encoding");
    Matched out;
    out.look = {encodings.look.input.value_or(for_a_lattice(was.encoding)),
                encodings.look.output.value_or(for_a_lattice(is.encoding))};
    convert_patches(was, *out.look.input);
    convert_patches(is, *out.look.output);
    std::vector<lutlib::ColorPair> pairs;
    std::vector<lutlib::RgbD> found;
    for (std::size_t i = 0; i < lutlib::chart_patches; ++i) {
        pairs.push_back({was.patches[i], is.patches[i], 1});
    }
    out.match = lutlib::match_patches(pairs, size);
    out.coverage = lutlib::coverage_of(out.match.support, size);
    for (const lutlib::ColorPair& pair : pairs) {
        found.push_back(
            evaluate_exact(out.match.cube, pair.before, lutlib::Interpolation::tetrahedral));
    }
    const lutlib::Eye eye{lutlib::Viewing{*out.look.output}};
    std::vector<double> off(pairs.size()), off_left_out(pairs.size());
    eye(lutlib::Metric::delta_e_2000, found, is.patches, off);
    eye(lutlib::Metric::delta_e_2000, each_from_the_others(pairs), is.patches, off_left_out);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        out.patches.push_back({std::string(lutlib::color_checker[i].name), pairs[i].before,
                               pairs[i].after, off[i], off_left_out[i]});
    }
    out.own = lutlib::error_stats(off);
    out.held_out = lutlib::error_stats(off_left_out);
    out.remarks = std::move(was.remarks);
    out.remarks.insert(out.remarks.end(), is.remarks.begin(), is.remarks.end());
    return out;
}

} // namespace converter
