// Times of lookups on a GPU, as preview_bench measures them, beside the combinations of a survey.
#pragma once

#include "converter/survey_columns.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace converter {

/// One lookup into a picture of 8 bits.
struct GpuTime {
    std::string lookup, formats; ///< as preview_bench calls them
    double milliseconds = 0;     ///< of the picture that was timed
    double ratio_to_copy = 0;
    std::optional<std::size_t> row; ///< of the survey, whose error it has; none: not in it
};

struct GpuTimes {
    std::string device;
    double pixels = 0; ///< of the picture that was timed
    std::vector<GpuTime> rows;

    double milliseconds(const GpuTime& time, const Raster& raster) const {
        return time.milliseconds * raster.pixels / pixels;
    }
};

/// From what `preview_bench --json` writes. Throws Error naming the file where it is not that.
GpuTimes read_gpu_times(const std::string& path, const lutlib::Survey& survey);

nlohmann::ordered_json to_json(const GpuTimes& times);

} // namespace converter
