#include "lutlib/plot/scatter.h"

#include "lutlib/plot/palette.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plot {
namespace {

constexpr double width = 860, height = 500;
constexpr double left = 86, right = 186, top = 40, bottom = 62;
constexpr std::size_t most_names = 8;

struct Point {
    double x, y;
};

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

// A place for each mark, in order of importance, where it leaves those before it to be seen.
std::vector<Point> places(const std::vector<const Mark*>& marks, const Axis& x, const Axis& y) {
    constexpr double apart = 4.2, furthest = 40;
    std::vector<Point> out;
    out.reserve(marks.size());
    for (const Mark* const mark : marks) {
        const Point wanted{x.at(mark->x), y.at(mark->y)};
        Point place = wanted;
        const auto is_taken = [&] {
            return std::any_of(out.begin(), out.end(), [&](const Point& other) {
                return std::hypot(other.x - place.x, other.y - place.y) < apart;
            });
        };
        double aside = 0;
        while (is_taken() && aside < furthest) {
            aside += apart;
            place.x = wanted.x + aside;
            if (is_taken()) {
                place.x = wanted.x - aside;
            }
        }
        out.push_back(place);
    }
    return out;
}

std::string mark_svg(const Mark& mark, Point at, const Axis& x, const Axis& y) {
    const double r = mark.pale ? 3 : 4.5;
    const char* const kind = mark.recommended ? "mark best" : mark.pale ? "mark" : "mark top";
    const std::string beyond = x.shows(mark.x) && y.shows(mark.y) ? "" : " (beyond the axis)";
    const std::string title =
        mark.label.empty() ? "" : "<title>" + escaped(mark.label + beyond) + "</title>";
    const std::string attributes = fmt::format(" class=\"{} s{}\" data-row=\"{}\"", kind,
                                               mark.series % series_colors.size(), mark.row);
    if (mark.diamond) {
        const double d = 1.25 * r;
        return fmt::format("<path d=\"M{0:.1f} {1:.1f}l{2:.3g} {2:.3g}l-{2:.3g} {2:.3g}l-{2:.3g} "
                           "-{2:.3g}z\"{3}>{4}</path>\n",
                           at.x, at.y - d, d, attributes, title);
    }
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\"{}>{}</circle>\n", at.x, at.y,
                       r, attributes, title);
}

// Where the interval of a mark's x is seen beside the mark.
std::string interval_svg(const Mark& mark, Point at, const Axis& x) {
    const double from = x.at(mark.x_low), to = x.at(mark.x_high);
    if (mark.pale || !(mark.x_low > 0) || to - from < 9) {
        return "";
    }
    return fmt::format("<path class=\"interval\" d=\"M{0:.1f} {2:.1f}v6m0 -3H{1:.1f}m0 -3v6\"/>\n",
                       from, to, at.y - 3);
}

// The marks of the front with how much of the plot each dominates alone, in square pixels.
std::vector<std::pair<double, std::size_t>> knees(const std::vector<const Mark*>& marks,
                                                  const Axis& x, const Axis& y) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i]->on_front && x.shows(marks[i]->x) && y.shows(marks[i]->y)) {
            front.push_back(i);
        }
    }
    std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
        return marks[a]->x != marks[b]->x ? marks[a]->x < marks[b]->x : marks[a]->y > marks[b]->y;
    });
    std::vector<std::pair<double, std::size_t>> out;
    for (std::size_t k = 0; k < front.size(); ++k) {
        const Mark& mark = *marks[front[k]];
        const double across =
            (k + 1 < front.size() ? x.at(marks[front[k + 1]]->x) : width - right) - x.at(mark.x);
        const double down = y.at(mark.y) - (k > 0 ? y.at(marks[front[k - 1]]->y) : top);
        out.emplace_back(across * down, front[k]);
    }
    std::sort(out.rbegin(), out.rend());
    return out;
}

// The names of the knees, in the room that the front leaves below and to the left, none over
// another.
std::string names_svg(const std::vector<const Mark*>& marks, const std::vector<Point>& at,
                      const Axis& x, const Axis& y) {
    struct Box {
        double left, right, top, bottom;
    };
    constexpr double letter = 6.4, line = 14; // pixels of the small type of names
    std::vector<Box> taken;
    std::string out;
    for (const auto& [area, i] : knees(marks, x, y)) {
        const std::string& name = marks[i]->name;
        const double length = letter * static_cast<double>(name.size());
        const bool fits = at[i].x - 6 - length > left + 2;
        const double from = fits ? at[i].x - 6 - length : at[i].x + 5;
        const double base = std::min(at[i].y + 15, height - bottom - 4);
        const Box box{from, from + length, base - line + 2, base + 2};
        const bool hidden = std::any_of(taken.begin(), taken.end(), [&](const Box& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom &&
                   other.top < box.bottom;
        });
        if (name.empty() || hidden || taken.size() == most_names) {
            continue;
        }
        taken.push_back(box);
        out += fmt::format("<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}"
                           "</text>\n",
                           fits ? at[i].x - 6 : from, base, fits ? "end" : "start", escaped(name));
    }
    return out;
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
                         series_colors[i % series_colors.size()]),
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

int rank_of(const Mark& mark) {
    return mark.recommended ? 0 : mark.pale ? 2 : 1;
}

// Those that matter most come first.
std::vector<const Mark*> by_importance(const std::vector<Mark>& marks) {
    std::vector<const Mark*> out;
    for (const Mark& mark : marks) {
        out.push_back(&mark);
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Mark* a, const Mark* b) { return rank_of(*a) < rank_of(*b); });
    return out;
}

template <class Get>
Axis axis_of(const std::vector<Mark>& marks, double start, double end, const Get& get) {
    std::vector<double> values;
    for (const Mark& mark : marks) {
        values.push_back(get(mark));
    }
    return axis_over(values, start, end);
}

} // namespace

std::string svg(const Scatter& s) {
    const Axis x = axis_of(s.marks, left, width - right, [](const Mark& m) { return m.x; });
    Axis y = axis_of(s.marks, height - bottom, top, [](const Mark& m) { return m.y; });
    if (s.y_floor > 0) {
        y.low = std::clamp(std::log10(s.y_floor), y.low, y.high - 0.1);
    }
    const std::vector<const Mark*> marks = by_importance(s.marks);
    const std::vector<Point> at = places(marks, x, y);
    std::string out =
        fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n", width,
                    height, escaped(s.title));
    out += svg({s.title, s.x_label, s.y_label, left, width - right, top, height - bottom}, x, y);
    // What matters most is drawn last.
    for (const int rank : {2, 1, 0}) {
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (rank_of(*marks[i]) == rank) {
                out += interval_svg(*marks[i], at[i], x) + mark_svg(*marks[i], at[i], x, y);
            }
        }
    }
    return out + front_line(s, x, y) + names_svg(marks, at, x, y) + legend(s) + "</svg>\n";
}

} // namespace plot
