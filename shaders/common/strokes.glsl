// The brush strokes of shaders/paintbrush.comp: one in each cell of a grid over each side's picture.
// Lengths in cells. The strokes' images have a margin of cells beyond the picture all round.
const int stroke_reach = 2; // strokes of cells farther away do not reach a texel
const float stroke_jitter = 0.8, stroke_half_width = 0.7;
