#include "lutlib/plot/lines.h"

#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace plot {
namespace {

constexpr double left = 86, right = 16, top = 40, bottom = 62;
constexpr double legend_line = 19;

// Values of 0..1 from pixel `start` to pixel `end`.
struct ShareAxis {
    double start, end;
    double at(double share) const { return start + std::clamp(share, 0.0, 1.0) * (end - start); }
};

std::string share_frame(const Frame& f, const ShareAxis& y) {
    std::string out;
    for (int i = 0; i <= 4; ++i) {
        const double share = i / 4.0;
        out += fmt::format("<path class=\"grid\" d=\"M{1:g} {0:.1f}H{2:g}\"/>"
                           "<text x=\"{3:g}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g} %</text>\n",
                           y.at(share), f.left, f.right, f.left - 7, y.at(share) + 5, 100 * share);
    }
    return out;
}

template <class Y>
std::string line_svg(const Lines& plot, const Line& line, const Axis& x, const Y& y) {
    std::string path, dots;
    const std::string color = css_color(series_color(line.color, line.pale));
    for (const auto& [px, py] : line.points) {
        if (!x.shows(px) || !(plot.y_is_share || (py > 0 && std::isfinite(py)))) {
            continue;
        }
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x.at(px), y.at(py));
        dots += line.dots ? fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\"/>", x.at(px),
                                        y.at(py))
                          : "";
    }
    const bool named = &line == &plot.lines.front() && !plot.first_line_id.empty();
    const std::string id = named ? " id=\"" + plot.first_line_id + "\"" : "";
    return fmt::format(
        "<g fill=\"{0}\"><title>{1}</title><path{2} class=\"line{3}\" stroke=\"{0}\" "
        "d=\"{4}\"/>{5}</g>\n",
        color, escaped(line.label.empty() ? line.name : line.label), id,
        line.dashed ? " dashed" : "", path, dots);
}

std::string legend(const Lines& plot, double x, double y) {
    std::string out;
    for (const Line& line : plot.lines) {
        if (line.name.empty()) {
            continue;
        }
        out += fmt::format("<path class=\"line{}\" stroke=\"{}\" d=\"M{:g} {:g}h22\"/>"
                           "<text class=\"name\" x=\"{:g}\" y=\"{:g}\">{}</text>\n",
                           line.dashed ? " dashed" : "",
                           css_color(series_color(line.color, line.pale)), x, y - 4, x + 28, y,
                           escaped(line.name));
        y += legend_line;
    }
    return out;
}

} // namespace

std::string share_path(const Lines& plot, const std::vector<std::pair<double, double>>& points) {
    const Axis x{std::log10(plot.x_low), std::log10(plot.x_high), left, plot.width - right};
    const ShareAxis y{plot.height - bottom, top};
    std::string path;
    for (const auto& [px, py] : points) {
        path += fmt::format("{}{:.0f} {:.0f}", path.empty() ? "M" : "L", x.at(px), y.at(py));
    }
    return path;
}

std::string svg(const Lines& plot) {
    std::vector<double> xs, ys;
    for (const Line& line : plot.lines) {
        for (const auto& [px, py] : line.points) {
            xs.push_back(px);
            ys.push_back(py);
        }
    }
    const auto named = static_cast<double>(std::count_if(
        plot.lines.begin(), plot.lines.end(), [](const Line& l) { return !l.name.empty(); }));
    const double high = plot.height + legend_line * named;
    const Frame frame{plot.title,         plot.x_label, plot.y_label,        left,
                      plot.width - right, top,          plot.height - bottom};
    Axis x = axis_over(xs, frame.left, frame.right);
    if (plot.x_low < plot.x_high) {
        x.low = std::log10(plot.x_low);
        x.high = std::log10(plot.x_high);
    }
    std::string out =
        fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n", plot.width,
                    high, escaped(plot.title));
    if (plot.y_is_share) {
        const ShareAxis y{frame.bottom, frame.top};
        // Without marks of its own, since those are powers of ten.
        out += svg(frame, x, Axis{0.1, 0.2, frame.bottom, frame.top}) + share_frame(frame, y);
        for (const Line& line : plot.lines) {
            out += line_svg(plot, line, x, y);
        }
    } else {
        Axis y = axis_over(ys, frame.bottom, frame.top);
        if (plot.y_floor > 0) {
            y.low = std::clamp(std::log10(plot.y_floor), y.low, y.high - 0.1);
        }
        out += svg(frame, x, y);
        for (const Line& line : plot.lines) {
            out += line_svg(plot, line, x, y);
        }
    }
    return out + legend(plot, frame.left, plot.height + 4) + "</svg>\n";
}

} // namespace plot
