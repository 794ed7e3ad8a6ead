// A look as the cube of its nodes: each at the colour that it has, in RGB space seen from a side,
// for the window and for pictures. No GPU.
//
// The neutral axis stands upright, black at the bottom, so that a turn runs through the hues and
// the view from above is a hexagon of them.
#pragma once

#include "lutlib/lut.h"

#include <array>
#include <cstdint>
#include <vector>

namespace preview {

/// Nodes of a lattice, red fastest.
struct NodeCloud {
    std::vector<float> inputs; ///< of the nodes of an axis, 0..1 over the domain
    std::vector<lutlib::Rgb> outputs;

    std::size_t per_side() const { return inputs.size(); }
};

/// The look's own nodes, of each axis at most `most` evenly chosen ones, the first and last among
/// them; of a look without a lattice `most` over its domain. `most` is at least 2.
NodeCloud cube_nodes(const lutlib::Lut& look, int most);

struct CubeView {
    float turn = 24, tilt = 18; ///< degrees; a tilt of 90 looks down on white
    float zoom = 1;
    bool clamped = false;  ///< nodes stand where a display shows them, within 0..1
    bool by_input = false; ///< dots have the colours that nodes stand for, not those they give
    friend bool operator==(const CubeView&, const CubeView&) = default;
};

using Rgb8 = std::array<std::uint8_t, 3>;
inline constexpr Rgb8 cube_ground{30, 30, 34};

struct CubeLine {
    float x0, y0, x1, y1, width, opacity;
    Rgb8 color;
};
struct CubeDot {
    float x, y, radius;
    Rgb8 color;
};

/// In pixels from the upper left, to be drawn in this order.
struct CubeDrawing {
    std::vector<CubeLine> behind; ///< edges of the unit cube that the dots hide, the neutral axis
    std::vector<CubeDot> dots;    ///< far to near
    std::vector<CubeLine> before; ///< nearer edges, what the look makes of the neutral axis
};

/// Replaces `drawing`. Values that are not finite have no dot.
void draw_cube(const NodeCloud& nodes, const CubeView& view, float width, float height,
               CubeDrawing& drawing);

/// Four codes a pixel, rows from the top, antialiased.
std::vector<std::uint8_t> rasterised(const CubeDrawing& drawing, int width, int height);

} // namespace preview
