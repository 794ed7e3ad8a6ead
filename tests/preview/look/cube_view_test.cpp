// The cube of a look's nodes: which nodes, where they stand, and what becomes pixels.
#include "preview/look/cube_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace preview {
namespace {

using lutlib::Rgb;

lutlib::Lut identity_look(int size) {
    lutlib::Lut look;
    look.cube = lutlib::identity_cube(size);
    return look;
}

CubeDrawing drawn(const lutlib::Lut& look, const CubeView& view, int most = 9) {
    CubeDrawing drawing;
    draw_cube(cube_nodes(look, most), view, 400, 300, drawing);
    return drawing;
}

const CubeDot& dot_of(const CubeDrawing& drawing, Rgb8 color) {
    return *std::find_if(drawing.dots.begin(), drawing.dots.end(),
                         [&](const CubeDot& dot) { return dot.color == color; });
}

TEST(CubeNodesTest, are_the_looks_own_with_the_first_and_the_last_when_thinned) {
    for (const int size : {2, 9, 16, 33, 65}) {
        for (const int most : {2, 5, 17, 33}) {
            const NodeCloud nodes = cube_nodes(identity_look(size), most);
            const auto n = static_cast<std::size_t>(std::min(size, most));
            ASSERT_EQ(nodes.per_side(), n);
            ASSERT_EQ(nodes.outputs.size(), n * n * n);
            EXPECT_EQ(nodes.inputs.front(), 0);
            EXPECT_EQ(nodes.inputs.back(), 1);
            for (std::size_t i = 0; i < nodes.outputs.size(); ++i) {
                const Rgb at{nodes.inputs[i % n], nodes.inputs[i / n % n],
                             nodes.inputs[i / (n * n)]};
                // Of an identity, every node is the colour that it stands for.
                ASSERT_EQ(nodes.outputs[i], at);
            }
        }
    }
}

TEST(CubeNodesTest, of_a_look_without_a_lattice_are_its_values_over_its_domain) {
    lutlib::Lut look;
    look.shaper = lutlib::Lut1D{{{0, 0, 0}, {4, 4, 4}}, {{1, 0, 0}, {0, 0.5F, 1}}};
    const NodeCloud nodes = cube_nodes(look, 3);
    EXPECT_EQ(nodes.outputs.front(), (Rgb{1, 0, 0}));
    EXPECT_EQ(nodes.outputs.back(), (Rgb{0, 0.5F, 1}));
    EXPECT_EQ(cube_nodes({}, 3).outputs[13], (Rgb{0.5F, 0.5F, 0.5F}));
}

TEST(CubeDrawingTest, stands_on_black_with_white_above_it_however_it_is_turned) {
    for (float turn = -180; turn < 180; turn += 35) {
        CubeView view;
        view.turn = turn;
        view.tilt = 0;
        const CubeDrawing drawing = drawn(identity_look(9), view);
        const CubeDot &black = dot_of(drawing, {0, 0, 0}),
                      &white = dot_of(drawing, {255, 255, 255});
        EXPECT_NEAR(black.x, 200, 0.01);
        EXPECT_NEAR(white.x, 200, 0.01);
        EXPECT_GT(black.y, white.y + 200);
    }
}

TEST(CubeDrawingTest, keeps_a_look_that_leaves_the_cube_in_the_picture_from_every_side) {
    lutlib::Lut wide;
    wide.cube = lutlib::identity_cube(3);
    for (lutlib::Rgb& node : wide.cube->nodes) {
        node = {3 * node.r - 1, 2 * node.g - 0.5F, 2.5F * node.b};
    }
    const NodeCloud nodes = cube_nodes(wide, 3);
    CubeDrawing drawing;
    for (const float turn : {0.0F, 50.0F, 130.0F, 250.0F}) {
        CubeView view;
        view.turn = turn;
        draw_cube(nodes, view, 200, 100, drawing);
        for (const CubeDot& dot : drawing.dots) {
            EXPECT_TRUE(dot.x > 0 && dot.x < 200 && dot.y > 0 && dot.y < 100) << turn;
        }
    }
}

TEST(CubeDrawingTest, draws_nearer_nodes_later) {
    CubeView above;
    above.tilt = 90;
    EXPECT_EQ(drawn(identity_look(9), above).dots.back().color, (Rgb8{255, 255, 255}));
    CubeView below;
    below.tilt = -90;
    EXPECT_EQ(drawn(identity_look(9), below).dots.back().color, (Rgb8{0, 0, 0}));
    EXPECT_EQ(drawn(identity_look(9), below).dots.front().color, (Rgb8{255, 255, 255}));
}

TEST(CubeDrawingTest, has_twelve_edges_and_both_neutral_axes) {
    const CubeDrawing drawing = drawn(identity_look(9), {});
    // Three edges and the axis of no look behind the dots, nine before them and eight steps of
    // grey.
    EXPECT_EQ(drawing.behind.size(), 4U);
    EXPECT_EQ(drawing.before.size(), 17U + 16); // and the strokes of R, G and B
    EXPECT_EQ(drawing.dots.size(), 729U);
}

TEST(CubeDrawingTest, leaves_out_what_is_not_finite_and_clamps_and_recolors_when_asked) {
    lutlib::Lut look = identity_look(3);
    look.cube->nodes[0] = {NAN, 0, 0};
    look.cube->nodes[1] = {0, INFINITY, 0};
    look.cube->nodes[26] = {3, 3, 3};
    EXPECT_EQ(drawn(look, {}).dots.size(), 25U);
    CubeView view;
    view.tilt = 0;
    // Above the cube's uppermost corner, in pixels.
    const auto height_of_white = [&] {
        const CubeDrawing drawing = drawn(look, view);
        float top = 1e9F;
        for (const CubeLine& line : drawing.behind) {
            top = std::min({top, line.y0, line.y1});
        }
        return top - dot_of(drawing, {255, 255, 255}).y;
    };
    EXPECT_GT(height_of_white(), 10);
    view.clamped = true;
    EXPECT_NEAR(height_of_white(), 0, 1e-3);
    for (Rgb& node : look.cube->nodes) {
        node = {0.5F, 0.5F, 0.5F};
    }
    view.by_input = true;
    EXPECT_EQ(dot_of(drawn(look, view), {255, 0, 128}).x, 200);
}

TEST(CubePixelsTest, show_the_nearest_dot_and_the_ground_beside) {
    CubeView above;
    above.tilt = 90;
    const int width = 101, height = 61;
    CubeDrawing drawing;
    draw_cube(cube_nodes(identity_look(5), 5), above, width, height, drawing);
    drawing.behind.clear();
    drawing.before.clear();
    const auto pixels = rasterised(drawing, width, height);
    ASSERT_EQ(pixels.size(), std::size_t{4} * width * height);
    const auto pixel = [&](int x, int y) {
        const auto at = static_cast<std::size_t>(4 * (y * width + x));
        return Rgb8{pixels[at], pixels[at + 1], pixels[at + 2]};
    };
    EXPECT_EQ(pixel(50, 30), (Rgb8{255, 255, 255}));
    EXPECT_EQ(pixel(0, 0), cube_ground);
    EXPECT_EQ(rasterised({}, 1, 1).size(), 4U);
}

} // namespace
} // namespace preview
