#include "lutlib/paint/find_mark.h"

#include <algorithm>
#include <cmath>

namespace lutlib {
namespace {

constexpr float least_contrast = 5.0F / 255;
constexpr double smallest_scale = 0.4, largest_scale = 4, scale_step = 1.012;

/// One value a pixel of a picture that was turned.
struct Plane {
    PictureSize size;
    std::vector<float> values;

    const float* row(int y) const {
        return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width)];
    }
};

struct Hit {
    int x, y, row;
    Framed framed;
};

// The centres of the cells of a mark whose cells are so wide, from its left end.
std::array<int, mark_cells> centres(double cell) {
    std::array<int, mark_cells> out{};
    for (int i = 0; i < mark_cells; ++i) {
        out[static_cast<std::size_t>(i)] = static_cast<int>((i + 0.5) * cell);
    }
    return out;
}

// The cells of a mark that begins there, if it is one: all that should be light are lighter than
// all that should be dark, or the other way round, as a negative makes them.
std::optional<MarkReading> read_at(const float* row, const std::array<int, mark_cells>& centre) {
    const auto at = [&](std::size_t i) { return row[centre[i]]; };
    static const MarkRow sync = mark_row({layout_named("strip"), 16}, 0);
    const float step = at(4) - at(5);
    if (!(std::abs(step) >= least_contrast)) {
        return std::nullopt;
    }
    const float sense = step > 0 ? 1.0F : -1.0F;
    if (!(sense * (at(8) - at(9)) >= least_contrast &&
          sense * (at(10) - at(11)) >= least_contrast)) {
        return std::nullopt;
    }
    float lowest_light = sense * at(0), highest_dark = sense * at(5);
    for (std::size_t i = 0; i < sync_cells; ++i) {
        const float value = sense * at(i);
        if (sync[i]) {
            lowest_light = std::min(lowest_light, value);
        } else {
            highest_dark = std::max(highest_dark, value);
        }
    }
    if (!(lowest_light - highest_dark >= least_contrast)) {
        return std::nullopt;
    }
    const float middle = (lowest_light + highest_dark) / 2;
    MarkRow cells{};
    for (std::size_t i = 0; i < mark_cells; ++i) {
        cells[i] = sense * at(i) > middle;
    }
    return read_mark(cells);
}

std::vector<Hit> hits_in(const Plane& plane, double cell) {
    const std::array<int, mark_cells> centre = centres(cell);
    // Both rows of cells are met at any scale, and so is every cell.
    const int stride = std::max(1, static_cast<int>(cell / mark_cell));
    std::vector<Hit> out;
    for (int y = 0; y < plane.size.height; y += stride) {
        const float* const row = plane.row(y);
        for (int x = 0; x + centre.back() < plane.size.width; x += stride) {
            if (const std::optional<MarkReading> read = read_at(row + x, centre)) {
                out.push_back({x, y, read->row, read->framed});
            }
        }
    }
    return out;
}

// Hits of one mark lie within a cell of each other across, and within its rows.
std::vector<FoundMark> marks_of(std::vector<Hit> hits, double cell, int quarters,
                                PictureSize size) {
    std::vector<FoundMark> out;
    while (!hits.empty()) {
        const Hit first = hits.front();
        std::vector<Hit> own, others;
        for (const Hit& hit : hits) {
            const bool near = hit.framed == first.framed && std::abs(hit.x - first.x) <= cell &&
                              std::abs(hit.y - first.y) <= 3 * cell;
            (near ? own : others).push_back(hit);
        }
        hits = std::move(others);
        std::array<int, 2> low{size.height, size.height}, high{-1, -1};
        int left = size.width, right = 0;
        for (const Hit& hit : own) {
            const auto row = static_cast<std::size_t>(hit.row);
            low[row] = std::min(low[row], hit.y);
            high[row] = std::max(high[row], hit.y);
            left = std::min(left, hit.x);
            right = std::max(right, hit.x);
        }
        if (high[0] < 0 || high[1] < 0) {
            continue;
        }
        const bool mirrored = low[0] + high[0] > low[1] + high[1];
        // Where its rows meet tells the place best: above and below lies grey.
        const double meet = mirrored ? (high[1] + low[0] + 1) / 2.0 : (high[0] + low[1] + 1) / 2.0;
        const double top = mirrored ? size.height - meet - cell : meet - cell;
        // A centre is met from within a cell, so the mark begins in the middle of what was hit.
        out.push_back({first.framed,
                       {quarters, mirrored},
                       {(left + right + 1) / 2, static_cast<int>(std::lround(top))},
                       cell / mark_cell});
    }
    return out;
}

std::vector<FoundMark> marks_at(const std::array<Plane, 4>& planes, double cell) {
    std::vector<FoundMark> out;
    for (int quarters = 0; quarters < 4; ++quarters) {
        const Plane& plane = planes[static_cast<std::size_t>(quarters)];
        const std::vector<FoundMark> found =
            marks_of(hits_in(plane, cell), cell, quarters, plane.size);
        out.insert(out.end(), found.begin(), found.end());
    }
    return out;
}

// Of the channels together, or of one where a grade has left only that.
std::array<Plane, 4> planes_of(const Picture& picture, Rgb weights) {
    std::vector<float> values;
    values.reserve(picture.pixels.size());
    for (const Rgb& c : picture.pixels) {
        values.push_back(weights.r * c.r + weights.g * c.g + weights.b * c.b);
    }
    std::array<Plane, 4> out;
    for (int quarters = 0; quarters < 4; ++quarters) {
        const Turn turn{quarters, false};
        out[static_cast<std::size_t>(quarters)] = {turned(picture.size(), turn),
                                                   turned(values, picture.size(), turn)};
    }
    return out;
}

// A mark is hit at several scales; it has the middle of them.
std::vector<FoundMark> at_one_scale_each(const std::vector<FoundMark>& found) {
    std::vector<FoundMark> out;
    std::vector<std::array<double, 2>> scales;
    for (const FoundMark& mark : found) {
        const auto known = std::find_if(out.begin(), out.end(), [&](const FoundMark& other) {
            return other.turn == mark.turn && other.framed == mark.framed &&
                   std::abs(other.at.x - mark.at.x) <= 8 * mark.scale &&
                   std::abs(other.at.y - mark.at.y) <= 8 * mark.scale;
        });
        if (known == out.end()) {
            out.push_back(mark);
            scales.push_back({mark.scale, mark.scale});
            continue;
        }
        auto& [low, high] = scales[static_cast<std::size_t>(known - out.begin())];
        low = std::min(low, mark.scale);
        high = std::max(high, mark.scale);
        known->scale = std::sqrt(low * high);
    }
    return out;
}

} // namespace

std::vector<FoundMark> find_marks(const Picture& picture) {
    std::vector<std::array<Plane, 4>> all;
    for (const Rgb weights : {Rgb{0.3F, 0.4F, 0.3F}, Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{0, 0, 1}}) {
        all.push_back(planes_of(picture, weights));
        if (std::vector<FoundMark> found = marks_at(all.back(), mark_cell); !found.empty()) {
            return found;
        }
    }
    std::vector<FoundMark> out;
    for (double scale = smallest_scale; scale <= largest_scale; scale *= scale_step) {
        const std::vector<FoundMark> found = marks_at(all.front(), scale * mark_cell);
        out.insert(out.end(), found.begin(), found.end());
    }
    return at_one_scale_each(out);
}

std::optional<Reduced> reduced(const Picture& picture) {
    for (const int by : {4, 3, 2}) {
        if (picture.width % by != 0 || picture.height % by != 0) {
            continue;
        }
        Reduced out{{picture.width / by, picture.height / by, {}}, by};
        bool equal = true;
        for (int y = 0; equal && y < picture.height; ++y) {
            for (int x = 0; equal && x < picture.width; ++x) {
                equal = picture.at(x, y) == picture.at(x / by * by, y / by * by);
                if (x % by == 0 && y % by == 0) {
                    out.picture.pixels.push_back(picture.at(x, y));
                }
            }
        }
        if (equal) {
            return out;
        }
    }
    return std::nullopt;
}

} // namespace lutlib
