// Learning a look from photographs of a ColorChecker.
#pragma once

#include "converter/match_run.h"
#include "lutlib/match/chart.h"

#include <optional>
#include <string>
#include <vector>

namespace converter {

/// X,Y,WIDTH,HEIGHT in pixels. Throws UsageError, which names the option.
lutlib::ChartArea chart_area_of(const std::string& text, const std::string& option);

/// A picture with a chart before or after the grade; without one, the published codes.
struct ChartPicture {
    std::string path;
    lutlib::ChartArea area;
};

/// From chart to chart, which need not lie at one place of pictures of one size. Throws Error.
Matched match_charts(const std::optional<ChartPicture>& before,
                     const std::optional<ChartPicture>& after, const PairEncodings& encodings,
                     int size);

} // namespace converter
