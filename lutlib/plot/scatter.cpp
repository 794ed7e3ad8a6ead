#include "lutlib/plot/scatter.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plot {
namespace {

constexpr double width = 860, height = 500;
constexpr double left = 86, right = 186, top = 40, bottom = 62;

// Okabe and Ito's palette, which the colour-blind can tell apart.
constexpr std::array<const char*, 6> colours{"#999999", "#D55E00", "#0072B2",
                                             "#009E73", "#CC79A7", "#E69F00"};

// A logarithmic axis from pixel `start` to pixel `end`.
struct Axis {
    double low, high; // powers of ten
    double start, end;

    double at(double value) const {
        const double power = value > 0 ? std::log10(value) : low;
        const double t = std::isnan(value) ? 1 : (power - low) / (high - low);
        return start + std::clamp(t, 0.0, 1.0) * (end - start);
    }
    bool shows(double value) const {
        return value > 0 && std::isfinite(value) && std::log10(value) >= low;
    }
};

template <class Get>
Axis axis_of(const std::vector<Mark>& marks, double start, double end, const Get& get) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Mark& mark : marks) {
        const double value = get(mark);
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

// Every decade; 2 and 5 as well where there are few.
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

// Powers of ten beyond what is read at a glance are written as such.
std::string tick_text(double value) {
    const double power = std::log10(value);
    if ((power < -3.5 || power > 3.5) && std::abs(power - std::round(power)) < 1e-9) {
        return fmt::format("10<tspan dy=\"-6\" font-size=\"11\">{:g}</tspan>", std::round(power));
    }
    return fmt::format("{:g}", value);
}

std::string frame(const Scatter& s, const Axis& x, const Axis& y) {
    std::string out = fmt::format("<text class=\"title\" x=\"{:g}\" y=\"22\">{}</text>\n", left,
                                  escaped(s.title));
    for (const double value : ticks(x)) {
        out +=
            fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:g}V{2:g}\"/>"
                        "<text x=\"{0:.1f}\" y=\"{3:g}\" text-anchor=\"middle\">{4}</text>\n",
                        x.at(value), top, height - bottom, height - bottom + 19, tick_text(value));
    }
    for (const double value : ticks(y)) {
        out += fmt::format("<path class=\"grid\" d=\"M{1:g} {0:.1f}H{2:g}\"/>"
                           "<text x=\"{3:g}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
                           y.at(value), left, width - right, left - 7, y.at(value) + 5,
                           tick_text(value));
    }
    out += fmt::format("<path class=\"frame\" d=\"M{0:g} {1:g}V{2:g}H{3:g}\"/>\n", left, top,
                       height - bottom, width - right);
    out += fmt::format("<text x=\"{:g}\" y=\"{:g}\" text-anchor=\"middle\">{}</text>\n",
                       (left + width - right) / 2, height - 14, escaped(s.x_label));
    out += fmt::format("<text transform=\"translate(18 {:g}) rotate(-90)\" "
                       "text-anchor=\"middle\">{}</text>\n",
                       (top + height - bottom) / 2, escaped(s.y_label));
    return out;
}

// The front as a staircase: what is attainable at each cost.
std::string front_line(const Scatter& s, const Axis& x, const Axis& y) {
    std::vector<const Mark*> front;
    for (const Mark& mark : s.marks) {
        if (mark.on_front) {
            front.push_back(&mark);
        }
    }
    std::sort(front.begin(), front.end(), [](const Mark* a, const Mark* b) {
        return a->x != b->x ? a->x < b->x : a->y > b->y;
    });
    std::string path;
    for (const Mark* mark : front) {
        path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x.at(mark->x), y.at(mark->y))
                             : fmt::format("H{:.1f}V{:.1f}", x.at(mark->x), y.at(mark->y));
    }
    return path.empty() ? "" : "<path class=\"front\" d=\"" + path + "\"/>\n";
}

std::string mark_svg(const Scatter& s, const Mark& mark, const Axis& x, const Axis& y) {
    const double middle = (static_cast<double>(s.series.size()) - 1) / 2;
    const double aside = s.series_gap * (static_cast<double>(mark.series) - middle);
    const double px = x.at(mark.x) + aside, py = y.at(mark.y), r = mark.pale ? 3 : 4.5;
    const char* const kind = mark.recommended ? "mark best" : mark.pale ? "mark" : "mark top";
    const std::string colour = colours[mark.series % colours.size()];
    const std::string beyond = x.shows(mark.x) && y.shows(mark.y) ? "" : " (beyond the axis)";
    const std::string attributes =
        fmt::format(" class=\"{}\" fill=\"{}\" data-row=\"{}\"><title>{}</title>", kind, colour,
                    mark.row, escaped(mark.label + beyond));
    if (mark.diamond) {
        const double d = 1.25 * r;
        return fmt::format("<path d=\"M{0:.1f} {1:.1f}l{2:.1f} {2:.1f}l-{2:.1f} {2:.1f}l-{2:.1f} "
                           "-{2:.1f}z\"{3}</path>\n",
                           px, py - d, d, attributes);
    }
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\"{}</circle>\n", px, py, r,
                       attributes);
}

std::string legend(const Scatter& s) {
    std::string out;
    double y = top + 8;
    const double x = width - right + 16;
    const auto line = [&](const std::string& symbol, const std::string& name) {
        out += symbol +
               fmt::format("<text x=\"{:g}\" y=\"{:g}\">{}</text>\n", x + 13, y + 5, escaped(name));
        y += 22;
    };
    for (std::size_t i = 0; i < s.series.size(); ++i) {
        line(fmt::format("<circle cx=\"{:g}\" cy=\"{:g}\" r=\"4\" fill=\"{}\"/>", x, y,
                         colours[i % colours.size()]),
             s.series[i].name);
    }
    if (!s.circle_name.empty()) {
        line(fmt::format("<circle class=\"outline\" cx=\"{:g}\" cy=\"{:g}\" r=\"4\"/>", x, y),
             s.circle_name);
    }
    if (!s.diamond_name.empty()) {
        line(fmt::format("<path class=\"outline\" d=\"M{:g} {:g}l5 5l-5 5l-5 -5z\"/>", x, y - 5),
             s.diamond_name);
    }
    return out;
}

} // namespace

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

std::string svg(const Scatter& s) {
    const Axis x = axis_of(s.marks, left, width - right, [](const Mark& m) { return m.x; });
    Axis y = axis_of(s.marks, height - bottom, top, [](const Mark& m) { return m.y; });
    if (s.y_floor > 0) {
        y.low = std::clamp(std::log10(s.y_floor), y.low, y.high - 0.1);
    }
    std::string out =
        fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n", width,
                    height, escaped(s.title));
    out += frame(s, x, y) + front_line(s, x, y);
    // What matters lies on top.
    for (const bool strong : {false, true}) {
        for (const Mark& mark : s.marks) {
            if (mark.pale != strong) {
                out += mark_svg(s, mark, x, y);
            }
        }
    }
    return out + legend(s) + "</svg>\n";
}

} // namespace plot
