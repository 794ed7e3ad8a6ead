#include "lutlib/paint/strip.h"

#include "lutlib/nodes.h"
#include "lutlib/paint/find_bare.h"
#include "lutlib/paint/find_mark.h"

#include <algorithm>

namespace lutlib {
namespace {

bool covers(const FoundStrip& strip, Pixel at, PictureSize size) {
    const Pixel upright = after_turn(at, size, strip.turn);
    return frame_area(strip).holds(upright.x, upright.y);
}

FoundStrip of_mark(const FoundMark& mark) {
    const FrameGeometry where = geometry_of(mark.framed);
    return {.framed = mark.framed,
            .extent = where.strip,
            .turn = mark.turn,
            .at = {mark.at.x + where.strip_at.x - where.mark_at.x,
                   mark.at.y + where.strip_at.y - where.mark_at.y},
            .mark_at = mark.at,
            .scale = mark.scale};
}

// Nodes along one axis moved from where they were placed to where they are to be.
void respace(Lut3D& cube, const std::vector<double>& placed, std::size_t step, int r, int g,
             int b) {
    const std::size_t first = cube.index(r, g, b);
    std::vector<RgbD> line;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        line.push_back(to_double(cube.nodes[first + i * step]));
    }
    const std::size_t last = placed.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        const double wanted = static_cast<double>(i) / static_cast<double>(last);
        const std::size_t from = wanted >= placed[i] ? i : i - 1;
        const double t = (wanted - placed[from]) / (placed[from + 1] - placed[from]);
        cube.nodes[first + i * step] = to_float(line[from] * (1 - t) + line[from + 1] * t);
    }
}

} // namespace

std::vector<FoundStrip> find_strips(const Picture& picture, const StripSearch& search) {
    std::vector<FoundStrip> out;
    for (const FoundMark& mark : find_marks(picture)) {
        out.push_back(of_mark(mark));
    }
    if (out.empty()) {
        for (const BareStrip& bare : find_bare(picture, {search.layout, search.size})) {
            out.push_back({.framed = {bare.layout, bare.size, search.bits},
                           .extent = bare.extent,
                           .turn = bare.turn,
                           .at = bare.at,
                           .mark_at = {},
                           .falls = bare.falls,
                           .may_be_negative = bare.may_be_negative});
        }
    }
    if (search.around) {
        std::erase_if(out, [&](const FoundStrip& strip) {
            return !covers(strip, *search.around, picture.size());
        });
    }
    return out;
}

Area strip_area(const FoundStrip& strip) {
    return {strip.at.x, strip.at.y, strip.at.x + strip.extent.width,
            strip.at.y + strip.extent.height};
}

Area frame_area(const FoundStrip& strip) {
    if (!strip.mark_at) {
        return strip_area(strip);
    }
    const FrameGeometry where = geometry_of(strip.framed);
    const int left = strip.mark_at->x - where.mark_at.x, top = strip.mark_at->y - where.mark_at.y;
    return {left, top, left + where.frame.width, top + where.frame.height};
}

Lut3D lattice_in(const Picture& upright, const FoundStrip& strip) {
    const Layout& layout = *strip.framed.layout;
    const int size = strip.framed.size;
    Lut3D cube = identity_cube(size);
    for_each_node(size, [&](int r, int g, int b) {
        const Pixel p = layout.pixel(size, strip.extent.width, r, g, b);
        cube.at(r, g, b) = upright.at(strip.at.x + p.x, strip.at.y + p.y);
    });
    const CodeDepth depth{strip.framed.bits};
    std::vector<double> placed;
    bool exact = true;
    for (int i = 0; i < size; ++i) {
        const double wanted = i / (size - 1.0);
        placed.push_back(depth.value(depth.code(wanted)));
        exact = exact && placed.back() == wanted;
    }
    // More nodes than codes stand on each other's.
    const bool rise =
        std::adjacent_find(placed.begin(), placed.end(), std::greater_equal<>()) == placed.end();
    if (exact || !rise) {
        return cube;
    }
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < size; ++k) {
            respace(cube, placed, 1, 0, i, k);
        }
    }
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < size; ++k) {
            respace(cube, placed, cube.index(0, 1, 0), i, 0, k);
        }
    }
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < size; ++k) {
            respace(cube, placed, cube.index(0, 0, 1), i, k, 0);
        }
    }
    return cube;
}

} // namespace lutlib
