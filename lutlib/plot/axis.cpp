#include "lutlib/plot/axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plot {

double Axis::at(double value) const {
    const double power = value > 0 ? std::log10(value) : low;
    const double t = std::isnan(value) ? 1 : (power - low) / (high - low);
    return start + std::clamp(t, 0.0, 1.0) * (end - start);
}

bool Axis::shows(double value) const {
    return value > 0 && std::isfinite(value) && std::log10(value) >= low;
}

Axis axis_over(const std::vector<double>& values, double start, double end) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values) {
        if (value > 0 && std::isfinite(value)) {
            low = std::min(low, std::log10(value));
            high = std::max(high, std::log10(value));
        }
    }
    if (low > high) {
        low = -1, high = 1;
    }
    const double margin = std::max(0.04 * (high - low), 0.05);
    return {low - margin, high + margin, start, end};
}

std::vector<double> ticks(const Axis& axis) {
    std::vector<double> out;
    const double decades = axis.high - axis.low;
    const int step = static_cast<int>(std::ceil(decades / 10));
    for (int power = static_cast<int>(std::floor(axis.low)); power <= axis.high; ++power) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, power);
            const double place = std::log10(value);
            const bool wanted = digit == 1 ? power % step == 0 : decades < 3.2;
            if (wanted && place >= axis.low && place <= axis.high) {
                out.push_back(value);
            }
        }
    }
    return out;
}

std::string tick_text(double value) {
    const double power = std::log10(value);
    if ((power < -3.5 || power > 3.5) && std::abs(power - std::round(power)) < 1e-9) {
        return fmt::format("10<tspan dy=\"-6\" font-size=\"11\">{:g}</tspan>", std::round(power));
    }
    return fmt::format("{:g}", value);
}

std::string svg(const Frame& f, const Axis& x, const Axis& y) {
    std::string out = fmt::format("<text class=\"title\" x=\"{:g}\" y=\"{:g}\">{}</text>\n", f.left,
                                  f.top - 18, escaped(f.title));
    for (const double value : ticks(x)) {
        out += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:g}V{2:g}\"/>"
                           "<text x=\"{0:.1f}\" y=\"{3:g}\" text-anchor=\"middle\">{4}</text>\n",
                           x.at(value), f.top, f.bottom, f.bottom + 19, tick_text(value));
    }
    for (const double value : ticks(y)) {
        out += fmt::format("<path class=\"grid\" d=\"M{1:g} {0:.1f}H{2:g}\"/>"
                           "<text x=\"{3:g}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
                           y.at(value), f.left, f.right, f.left - 7, y.at(value) + 5,
                           tick_text(value));
    }
    out += fmt::format("<path class=\"frame\" d=\"M{0:g} {1:g}V{2:g}H{3:g}\"/>\n", f.left, f.top,
                       f.bottom, f.right);
    out += fmt::format("<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n",
                       (f.left + f.right) / 2, f.bottom + 48, escaped(f.x_label));
    out += fmt::format("<text transform=\"translate({:g} {:g}) rotate(-90)\" "
                       "text-anchor=\"middle\">{}</text>\n",
                       f.left - 68, (f.top + f.bottom) / 2, escaped(f.y_label));
    return out;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

} // namespace plot
