#include "lutlib/plot/figure.h"

#include "lutlib/plot/dot_font.h"
#include "lutlib/plot/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace plot {
namespace {

constexpr Rgb8 dark{34, 34, 34}, grey{90, 90, 90}, grid_color{226, 226, 226},
    frame_color{119, 119, 119};
constexpr double pad = 8, sample = 18;

// Of a number or name beside an axis.
std::size_t most_tick_letters(double width) {
    return width > 2 * figure_width ? 24 : 10;
}

double length_of(const std::string& text, std::size_t most) {
    return static_cast<double>(std::min(glyphs_of(text).size(), most)) * glyph_step;
}

// A scale with its ends and its numbers.
struct Ruled {
    Extent range;
    std::vector<Tick> ticks;
};

Extent shown_range(const Figure& f, bool is_x) {
    Extent out = is_x ? f.x.range : f.y.range;
    for (const Line& line : f.lines) {
        for (const auto& [x, y] : line.points) {
            out.add(is_x ? x : y);
        }
    }
    for (const Dots& dots : f.dots) {
        for (const Dot& dot : dots.dots) {
            out.add(is_x ? dot.x : dot.y);
        }
    }
    for (const Cells& cells : f.cells) {
        out.add(is_x ? cells.left : cells.bottom);
        out.add(is_x ? cells.right : cells.top);
    }
    return out.with_width();
}

Ruled ruled(const Scale& scale, const Extent& range, int most) {
    Ruled out{range, scale.ticks};
    std::erase_if(out.ticks,
                  [&](const Tick& tick) { return tick.at < range.low || tick.at > range.high; });
    if (scale.ticks.empty()) {
        for (const double value : round_values(range, most)) {
            out.ticks.push_back({value, value_text(value, range)});
        }
    }
    return out;
}

// Room on both sides, so that no line lies on the frame.
Extent with_margin(Extent range, double share) {
    const double margin = share * (range.high - range.low);
    return {range.low - margin, range.high + margin};
}

Extent about_middle(const Extent& range, double width) {
    const double middle = std::midpoint(range.low, range.high);
    return {middle - width / 2, middle + width / 2};
}

// The names of lines in rows below the plot.
struct Legend {
    struct Entry {
        const Line* line;
        double x = 0;
        int row = 0;
    };
    Legend(const Figure& f, double width) {
        double x = 0;
        for (const Line& line : f.lines) {
            if (line.name.empty()) {
                continue;
            }
            const auto letters = static_cast<std::size_t>((width - sample - 4) / glyph_step);
            const double needed = sample + 4 + length_of(line.name, letters) + 2 * glyph_step;
            if (x > 0 && x + needed > width) {
                x = 0;
                ++rows;
            }
            rows = std::max(rows, 1);
            entries.push_back({&line, x, rows - 1});
            x += needed;
        }
    }
    std::vector<Entry> entries;
    int rows = 0;
};

Rgb8 codes_of(lutlib::RgbD srgb) {
    Rgb8 out{};
    for (std::size_t c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>(std::lround(255 * lutlib::saturate(srgb[c])));
    }
    return out;
}

class Layout {
  public:
    Layout(const Figure& figure, double width, double height)
        : f_(figure), legend_(figure, width - 2 * pad) {
        out_.width = width;
        out_.height = height;
        out_.label = figure.title;
        Extent x = shown_range(figure, true), y = shown_range(figure, false);
        const bool has_lines = !figure.lines.empty() || !figure.dots.empty();
        if (has_lines && f_.cells.empty()) {
            x = with_margin(x, 0.02);
            y = with_margin(y, 0.04);
        }
        top_ = 5 + line_step + (figure.y.label.empty() ? 2 : line_step + 2);
        bottom_ = height - 4 - line_step * legend_.rows -
                  (f_.has_axes ? line_step + 4 + (figure.x.label.empty() ? 0 : line_step) : 4);
        letters_ = most_tick_letters(width);
        y_rule_ = ruled(figure.y, y, 6);
        left_ = pad;
        for (const Tick& tick : y_rule_.ticks) {
            left_ = std::max(left_, f_.has_axes ? pad + 4 + length_of(tick.text, letters_) : pad);
        }
        right_ = width - pad - 6;
        if (figure.same_units) {
            const double unit =
                std::max((x.high - x.low) / (right_ - left_), (y.high - y.low) / (bottom_ - top_));
            x = about_middle(x, unit * (right_ - left_));
            // Numbers stand beside the colours that they are of.
            if (!f_.cells.empty()) {
                out_.height -= bottom_ - (top_ + (y.high - y.low) / unit);
                bottom_ = top_ + (y.high - y.low) / unit;
            }
            y = about_middle(y, unit * (bottom_ - top_));
            y_rule_ = ruled(figure.y, y, 6);
        }
        x_rule_ = ruled(figure.x, x, std::max(2, static_cast<int>((right_ - left_) / 36)));
        x_ = {x.low, x.high, left_, right_};
        y_ = {y.low, y.high, bottom_, top_};
    }

    Drawing drawn() {
        write_titles();
        draw_cells();
        if (f_.has_axes) {
            draw_axes();
        }
        for (const Line& line : f_.lines) {
            draw_line(line);
        }
        for (const Dots& dots : f_.dots) {
            for (const Dot& dot : dots.dots) {
                out_.shapes.emplace_back(
                    Disc{{x_.at(dot.x), y_.at(dot.y)}, 1.6, codes_of(dot.color)});
            }
        }
        for (const Note& note : f_.notes) {
            out_.shapes.emplace_back(Words{{x_.at(note.x), y_.at(note.y) - glyph_height / 2.0},
                                           note.text,
                                           Anchor::middle,
                                           grey});
        }
        draw_legend();
        return std::move(out_);
    }

  private:
    std::size_t letters_in(double room) const {
        return static_cast<std::size_t>(std::max(room, 0.0) / glyph_step);
    }

    void write(Words words) {
        if (!words.text.empty()) {
            out_.shapes.emplace_back(std::move(words));
        }
    }

    void write_titles() {
        const double room = out_.width - 2 * pad;
        write({{pad, 5}, f_.title, Anchor::start, dark, letters_in(room), true});
        write({{pad, 5.0 + line_step}, f_.y.label, Anchor::start, grey, letters_in(room)});
        if (f_.has_axes) {
            write({{right_, bottom_ + 3 + line_step},
                   f_.x.label,
                   Anchor::end,
                   grey,
                   letters_in(room)});
        }
    }

    void draw_axes() {
        const bool has_cells = !f_.cells.empty();
        for (const Tick& tick : x_rule_.ticks) {
            const double x = x_.at(tick.at);
            if (!has_cells) {
                out_.shapes.emplace_back(Stroke{{{x, top_}, {x, bottom_}}, grid_color, 0.6});
            }
            out_.shapes.emplace_back(
                Words{{x, bottom_ + 3}, tick.text, Anchor::middle, grey, letters_});
        }
        for (const Tick& tick : y_rule_.ticks) {
            const double y = y_.at(tick.at);
            if (!has_cells) {
                out_.shapes.emplace_back(Stroke{{{left_, y}, {right_, y}}, grid_color, 0.6});
            }
            out_.shapes.emplace_back(
                Words{{left_ - 4, y - 3.5}, tick.text, Anchor::end, grey, letters_});
        }
        if (!has_cells) {
            out_.shapes.emplace_back(
                Stroke{{{left_, top_}, {left_, bottom_}, {right_, bottom_}}, frame_color, 0.6});
        }
    }

    void draw_cells() {
        for (const Cells& cells : f_.cells) {
            const auto x = [&](int i) {
                return x_.at(std::lerp(cells.left, cells.right, i / double(cells.columns)));
            };
            const auto y = [&](int i) {
                return y_.at(std::lerp(cells.bottom, cells.top, i / double(cells.rows)));
            };
            for (int row = 0; row < cells.rows; ++row) {
                for (int column = 0; column < cells.columns; ++column) {
                    const auto at = static_cast<std::size_t>(row * cells.columns + column);
                    if (!std::isfinite(lutlib::largest_magnitude(cells.colors[at]))) {
                        continue;
                    }
                    const auto c = static_cast<std::size_t>(column);
                    out_.shapes.emplace_back(Box{{x(column), y(row + 1)},
                                                 {x(column + 1), y(row)},
                                                 codes_of(cells.colors[at]),
                                                 c < cells.labels.size() ? cells.labels[c] : ""});
                }
            }
        }
    }

    void draw_line(const Line& line) {
        Stroke stroke{{},
                      series_color(line.color, line.pale),
                      line_width(line),
                      line.dashed,
                      line.label.empty() ? line.name : line.label};
        for (const auto& [x, y] : line.points) {
            const bool is_place = std::isfinite(x) && std::isfinite(y);
            stroke.points.push_back(is_place ? Point{x_.at(x), y_.at(y)} : Point{NAN, NAN});
        }
        out_.shapes.emplace_back(std::move(stroke));
    }

    static double line_width(const Line& line) { return line.color == 0 ? 0.8 : 1.3; }

    void draw_legend() {
        const double first = out_.height - 4 - line_step * legend_.rows;
        for (const Legend::Entry& entry : legend_.entries) {
            const double x = pad + entry.x, y = first + entry.row * line_step;
            const Line& line = *entry.line;
            out_.shapes.emplace_back(Stroke{{{x, y + 4}, {x + sample, y + 4}},
                                            series_color(line.color, line.pale),
                                            line_width(line),
                                            line.dashed});
            out_.shapes.emplace_back(Words{{x + sample + 4, y},
                                           line.name,
                                           Anchor::start,
                                           dark,
                                           letters_in(out_.width - pad - x - sample - 4)});
        }
    }

    const Figure& f_;
    Legend legend_;
    Drawing out_;
    Ruled x_rule_, y_rule_;
    std::size_t letters_ = 0;
    double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
    ValueAxis x_{}, y_{};
};

} // namespace

Drawing drawing_of(const Figure& figure, double width, double height) {
    return Layout(figure, width, height).drawn();
}

} // namespace plot
