#include "preview/finish/curve_counts.h"

#include "lutlib/color/oklab.h"

#include <cmath>
#include <numbers>

namespace preview {

const CountedAxis* axis_for(const lutlib::Parameter& parameter) {
    for (const CountedAxis& row : counted_axes) {
        if (row.label == parameter.axis.label &&
            (row.parameter.empty() || row.parameter == parameter.name)) {
            return &row;
        }
    }
    return nullptr;
}

AxisTables axis_tables(const lutlib::Encoding& encoding) {
    AxisTables tables;
    const lutlib::Matrix3 cones = lutlib::oklab_cones(encoding.primaries());
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            tables.cones[row][column] = static_cast<float>(cones.m[row][column]);
        }
    }
    for (std::size_t i = 0; i <= AxisTables::light_steps; ++i) {
        tables.light[i] =
            static_cast<float>(encoding.decode(static_cast<double>(i) / AxisTables::light_steps));
    }
    double last = -HUGE_VAL;
    for (std::size_t i = 0; i <= AxisTables::dial_steps; ++i) {
        const double angle =
            (2 * static_cast<double>(i) / AxisTables::dial_steps - 1) * std::numbers::pi;
        double hue = lutlib::dial_hue(std::cos(angle), std::sin(angle));
        while (hue < last) {
            hue += 360;
        }
        last = hue;
        tables.dial[i] = static_cast<float>(hue);
    }
    return tables;
}

} // namespace preview
