// How a light pass over a whole picture divides it: 64 threads a group and eight texels a thread. A
// GPU starts a group or so a clock, so that one texel a thread is bound by that and not by memory,
// and eight independent loads a thread hide what a load takes. A thread's texels lie a group's
// width apart, so that each access of neighbouring threads is to neighbouring texels. Dispatched
// over tiles of many_each (preview/graph/graph.h).
layout(local_size_x = 8, local_size_y = 8) in;
const int texels_each = 8;

ivec2 tile_texel(int i) {
    return ivec2(gl_WorkGroupID.xy) * ivec2(32, 16) + ivec2(gl_LocalInvocationID.xy) +
           ivec2(i & 3, i >> 2) * 8;
}
