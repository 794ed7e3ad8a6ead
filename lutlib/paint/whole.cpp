#include "lutlib/paint/whole.h"

#include "lutlib/color/encoding.h"
#include "lutlib/number_text.h"
#include "lutlib/paint/mark_geometry.h"
#include "lutlib/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace lutlib {
namespace {

// Figures in codes of 8 bits. Rounding leaves 0.29 and noise that is not seen little more.
constexpr double noisy = 0.6, uneven = 1.5;
// Of the strip's noise, what its border has of it where nothing spared that.
constexpr double in_border = 0.5;
// Of a step between two cells or slices, the share that its neighbours hold.
constexpr double mixed_at_marks = 0.02, mixed_at_folds = 0.08;
// Lossy compression lets edges overshoot and greys differ so many times as much.
constexpr double ringing = 3;
constexpr double scale_seen = 0.004, degrees_seen = 0.3;
constexpr int margin = 4; ///< pixels beside an edge that what is done to edges reaches

std::string in_tenths(double value) {
    const long tenths = std::lround(10 * value);
    return std::to_string(tenths / 10) + "." + std::to_string(std::abs(tenths % 10));
}

std::string codes(double value) {
    return in_tenths(value) + " codes of 8 bits";
}

double sum(Rgb c) {
    return static_cast<double>(c.r) + static_cast<double>(c.g) + static_cast<double>(c.b);
}

// A part of the border: how many pixels, and their sums and squares, a channel each.
struct Part {
    double count = 0;
    RgbD sums, squares;

    void add(RgbD c) {
        ++count;
        sums = sums + c;
        squares = squares + RgbD{c.r * c.r, c.g * c.g, c.b * c.b};
    }
    double mean(std::size_t c) const { return sums[c] / count; }
    double variance(std::size_t c) const {
        return std::max(0.0, squares[c] / count - mean(c) * mean(c));
    }
};

struct Border {
    double noise = 0, spread = 0;
};

// In sixteen parts, four each way, of which those in the middle have little border.
Border border_of(const Picture& upright, const FoundStrip& strip) {
    const Area frame = frame_area(strip), inner = strip_area(strip);
    const int mark_right = strip.mark_at->x + mark_cells * mark_cell,
              mark_bottom = strip.mark_at->y + 2 * mark_cell;
    const auto beside = [](const Area& area) {
        return Area{area.left - margin, area.top - margin, area.right + margin,
                    area.bottom + margin};
    };
    const Area no_strip = beside(inner),
               no_mark = beside({strip.mark_at->x, strip.mark_at->y, mark_right, mark_bottom});
    std::array<Part, 16> parts{};
    for (int y = std::max(0, frame.top + margin);
         y < std::min(upright.height, frame.bottom - margin); ++y) {
        for (int x = std::max(0, frame.left + margin);
             x < std::min(upright.width, frame.right - margin); ++x) {
            if (no_strip.holds(x, y) || no_mark.holds(x, y)) {
                continue;
            }
            const int across = 4 * (x - frame.left) / (frame.right - frame.left),
                      down = 4 * (y - frame.top) / (frame.bottom - frame.top);
            parts[static_cast<std::size_t>(4 * down + across)].add(to_double(upright.at(x, y)));
        }
    }
    Border out;
    for (std::size_t c = 0; c < 3; ++c) {
        double low = HUGE_VAL, high = -HUGE_VAL, variance = 0, count = 0;
        for (const Part& part : parts) {
            if (part.count < 24) {
                continue;
            }
            low = std::min(low, part.mean(c));
            high = std::max(high, part.mean(c));
            variance += part.variance(c) * part.count;
            count += part.count;
        }
        if (count > 0) {
            out.noise = std::max(out.noise, 255 * std::sqrt(variance / count));
            out.spread = std::max(out.spread, 255 * (high - low));
        }
    }
    return out;
}

// The share of a step that has wandered across it: of the mark's cells, between their outermost and
// their inner pixels.
double mixed_in_mark(const Picture& upright, const FoundStrip& strip) {
    double products = 0, squares = 0;
    for (int row = 0; row < 2; ++row) {
        const MarkRow cells = mark_row(strip.framed, row);
        for (int i = 1; i < mark_cells; ++i) {
            if (cells[static_cast<std::size_t>(i)] == cells[static_cast<std::size_t>(i) - 1]) {
                continue;
            }
            const int edge = strip.mark_at->x + i * mark_cell;
            for (int line = 1; line < mark_cell - 1; ++line) {
                const int y = strip.mark_at->y + row * mark_cell + line;
                const auto at = [&](int x) { return sum(upright.at(edge + x, y)); };
                const double left = (at(-3) + at(-2)) / 2, right = (at(1) + at(2)) / 2;
                const double step = right - left;
                products += step * ((at(-1) - left) - (at(0) - right)) / 2;
                squares += step * step;
            }
        }
    }
    return squares > 0 ? products / squares : 0;
}

// The same at the folds of a strip's rows, against what the three pixels before lead to.
double mixed_in_folds(const Picture& upright, const FoundStrip& strip) {
    const Area area = strip_area(strip);
    const int n = strip.framed.size;
    double products = 0, squares = 0;
    if (n < 6 || (area.right - area.left) % n != 0) {
        return 0;
    }
    for (int y = area.top; y < area.bottom; ++y) {
        for (int x = area.left + n; x < area.right; x += n) {
            const auto at = [&](int i) { return sum(upright.at(x + i, y)); };
            const double before = 3 * at(-2) - 3 * at(-3) + at(-4),
                         after = 3 * at(1) - 3 * at(2) + at(3), step = after - before;
            products += step * ((at(-1) - before) - (at(0) - after)) / 2;
            squares += step * step;
        }
    }
    return squares > 0 ? products / squares : 0;
}

// Of a mark whose edges are soft, whether that is because they lie elsewhere.
bool judge_geometry(const Picture& upright, const FoundStrip& strip, Wholeness& out) {
    const std::optional<MarkGeometry> now = mark_geometry(upright, strip);
    const bool is_scaled = now && std::abs(now->scale - 1) > scale_seen,
               is_turned = now && std::abs(now->degrees) > degrees_seen;
    if (is_scaled) {
        out.harms.push_back({"scaled", "the picture was scaled to " + in_tenths(100 * now->scale) +
                                           " % since the strip was placed; export it in its own "
                                           "size"});
    }
    if (is_turned) {
        out.harms.push_back({"turned", "the picture was turned by " +
                                           in_tenths(std::abs(now->degrees)) +
                                           " degrees since the strip was placed; turn a copy "
                                           "without the strip, or by quarters"});
    }
    return is_scaled || is_turned;
}

// `rings`: edges and greys are off by what lossy compression leaves.
void judge_edges(const Picture& upright, const FoundStrip& strip, bool rings, Wholeness& out) {
    const bool marked = strip.mark_at.has_value();
    const double mixed = marked ? mixed_in_mark(upright, strip) : mixed_in_folds(upright, strip);
    if (std::abs(mixed) < (marked ? mixed_at_marks : mixed_at_folds) * (rings ? ringing : 1) ||
        (marked && judge_geometry(upright, strip, out))) {
        return;
    }
    const std::string where = marked ? "the mark" : "the strip's slices";
    if (mixed > 0) {
        out.harms.push_back({"blurred", "the strip was blurred or resampled: at the edges of " +
                                            where + " " + percent(mixed) +
                                            " of each step lies on its other side; leave blurring "
                                            "and resizing to a copy without the strip"});
    } else {
        out.harms.push_back({"sharpened", "the strip was sharpened: the edges of " + where +
                                              " overshoot by " + percent(-mixed) +
                                              " of each step; sharpen a copy without the strip"});
    }
}

void judge_alpha(const FoundStrip& strip, const std::vector<float>& alpha, int width,
                 Wholeness& out) {
    const Area area = strip_area(strip);
    std::size_t translucent = 0;
    float least = 1;
    for (int y = area.top; y < area.bottom && !alpha.empty(); ++y) {
        for (int x = area.left; x < area.right; ++x) {
            const float a = alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x)];
            translucent += a < 1 ? 1 : 0;
            least = std::min(least, a);
        }
    }
    if (translucent > 0) {
        out.harms.push_back(
            {"translucent", std::to_string(translucent) +
                                " pixels of the strip are translucent (alpha down to " +
                                percent(least) +
                                "), so that other colours are or will be mixed in; make its layer "
                                "opaque and flatten the picture"});
    }
}

void judge_border(const Border& border, bool rings, Wholeness& out) {
    if (border.spread > uneven * (rings ? ringing : 1) + border.noise / 2) {
        out.harms.push_back(
            {"uneven", "the border around the strip, one grey when it was placed, differs by " +
                           codes(border.spread) +
                           " from place to place: a vignette, a gradient, a mask or a translucent "
                           "layer lies over it, which no look holds; grade all of the picture "
                           "alike"});
    }
}

void judge_noise(const std::string& lossy, Wholeness& out) {
    if (!lossy.empty()) {
        out.harms.push_back(
            {"lossy",
             lossy + " (noise of about " + codes(out.noise) +
                 "), which --denoise takes off; nodes at the edges of slices are off by more where "
                 "such files keep colours at half the size: save lossless",
             false});
        return;
    }
    if (out.noise < noisy) {
        return;
    }
    const bool lies_there = out.border_noise.value_or(out.noise) > in_border * out.noise;
    out.harms.push_back(
        {lies_there ? "noise" : "ringing",
         lies_there ? "noise of about " + codes(out.noise) +
                          " lies over the strip, as dithering, grain or a lossy file leaves it; "
                          "leave grain out, or add --denoise"
                    : "the strip is off by about " + codes(out.noise) +
                          " and its border is not, as lossy compression leaves it; save lossless "
                          "files all the way, or add --denoise",
         false});
}

} // namespace

bool Wholeness::is_spoilt() const {
    return std::any_of(harms.begin(), harms.end(), [](const Harm& harm) { return harm.spoils; });
}

double noise_of(const Lut3D& cube) {
    const int n = cube.size;
    if (n < 4) {
        return 0;
    }
    // 1, 3, 3 and 1 squared.
    constexpr double gain = 20, normal = 1.4826;
    const std::array<std::size_t, 3> steps{1, cube.index(0, 1, 0), cube.index(0, 0, 1)};
    std::vector<double> of_each;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<std::vector<double>, 3> differences;
        for (std::size_t at = 0; at + 3 * steps[axis] < cube.nodes.size(); ++at) {
            const std::size_t place = at / steps[axis] % static_cast<std::size_t>(n);
            if (place + 3 >= static_cast<std::size_t>(n)) {
                continue;
            }
            const auto node = [&](std::size_t i) {
                return to_double(cube.nodes[at + i * steps[axis]]);
            };
            const RgbD d = node(3) - 3.0 * node(2) + 3.0 * node(1) - node(0);
            for (std::size_t c = 0; c < 3; ++c) {
                differences[c].push_back(std::abs(d[c]));
            }
        }
        for (std::vector<double>& all : differences) {
            const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
            std::nth_element(all.begin(), middle, all.end());
            of_each.push_back(normal * *middle / std::sqrt(gain));
        }
    }
    std::nth_element(of_each.begin(), of_each.begin() + 4, of_each.end());
    return 255 * of_each[4];
}

Wholeness wholeness_of(const Picture& upright, const FoundStrip& strip,
                       const std::vector<float>& alpha, const std::string& lossy) {
    Wholeness out;
    if (std::abs(strip.scale - 1) > 0.005) {
        out.harms.push_back({"scaled", "the picture was scaled to " + percent(strip.scale) +
                                           " since the strip was placed; export it in its own "
                                           "size"});
        return out;
    }
    const Area area = strip_area(strip);
    if (!area.is_within(upright.size())) {
        const int missing_x = std::max(0, -area.left) + std::max(0, area.right - upright.width),
                  missing_y = std::max(0, -area.top) + std::max(0, area.bottom - upright.height);
        out.harms.push_back({"cropped", "the picture was cropped: " + std::to_string(missing_x) +
                                            " columns and " + std::to_string(missing_y) +
                                            " rows of the strip are missing; export all of it"});
        return out;
    }
    out.noise = noise_of(lattice_in(upright, strip));
    judge_alpha(strip, alpha, upright.width, out);
    const Border border = strip.mark_at ? border_of(upright, strip) : Border{};
    if (strip.mark_at) {
        out.border_noise = border.noise;
    }
    const bool rings =
        !lossy.empty() ||
        (out.noise >= noisy && out.border_noise.value_or(out.noise) <= in_border * out.noise);
    judge_edges(upright, strip, rings, out);
    judge_border(border, rings, out);
    judge_noise(lossy, out);
    return out;
}

std::optional<Harm> conversion_in(const Lut3D& cube, double slack) {
    struct Conversion {
        const char *from, *to;
    };
    constexpr std::array<Conversion, 8> known{{{"srgb", "srgb"},
                                               {"srgb", "linear"},
                                               {"linear", "srgb"},
                                               {"srgb", "gamma22/adobe-rgb"},
                                               {"gamma22/adobe-rgb", "srgb"},
                                               {"srgb", "srgb/display-p3"},
                                               {"srgb/display-p3", "srgb"},
                                               {"srgb", "gamma22"}}};
    for (const Conversion& row : known) {
        const Encoding from = require_encoding(row.from), to = require_encoding(row.to);
        const Matrix3 light = light_to_light(from, to);
        std::vector<RgbD> nodes;
        for (const Rgb& node : identity_cube(cube.size).nodes) {
            nodes.push_back(to_double(node));
        }
        if (!(from == to)) {
            from.decode_all(nodes);
            for (RgbD& node : nodes) {
                node = light * node;
            }
            to.encode_all(nodes);
        }
        double off = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const RgbD d = saturate(nodes[i]) - to_double(cube.nodes[i]);
            off += std::abs(d.r) + std::abs(d.g) + std::abs(d.b);
        }
        if (off / (3.0 * static_cast<double>(nodes.size())) < slack) {
            return from == to
                       ? Harm{"neutral", "nothing was graded: the strip is still neutral", false}
                       : Harm{"converted",
                              "the strip holds no grade but a conversion of its colours from " +
                                  from.label() + " to " + to.label() +
                                  ", as an editor makes it by a profile; export without "
                                  "conversion of colours",
                              false};
        }
    }
    return std::nullopt;
}

} // namespace lutlib
